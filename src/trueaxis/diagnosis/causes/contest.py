"""Stale values, or an effect that the base holds: which of both is likelier.

What any curves of the machine may imitate is not searched for beside them. But where values given are stale, one effect
may say in one number what else many values would have to change for.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.diagnosis.causes.imperfection import imperfections
from trueaxis.diagnosis.causes.refit import refit
from trueaxis.diagnosis.causes.rivals import of_rivals, with_best_periods, with_rivals
from trueaxis.diagnosis.causes.search import FALSE_ALARMS, RIVAL, Found, Ground, best_of, scan_all, search_of
from trueaxis.diagnosis.causes.signature import Fitted
from trueaxis.diagnosis.causes.signatures import directions_of
from trueaxis.diagnosis.further_runs.separation import APART
from trueaxis.diagnosis.judging.stale import Changes, free_besides, stale_values
from trueaxis.diagnosis.judging.verdict import size_is_significant
from trueaxis.diagnosis.null_model.noise import EXPECTED
from trueaxis.diagnosis.null_model.null import Null
from trueaxis.diagnosis.null_model.projection import Projection, orthonormal
from trueaxis.diagnosis.result import FloatArray

MOST = 3  # effects that are looked at as explaining the readings about as well as stale values
LIKELIER = -float(np.log10(FALSE_ALARMS))  # decades by which an effect must be likelier than stale values to be named


@dataclass(frozen=True, slots=True, eq=False)
class Named:
    """An effect that takes the place of stale values: as it was found, and fitted, the values given being true."""

    found: Found
    cause: Fitted


def contest(ground: Ground, null: Null, changes: Changes, known: Sequence[FloatArray]) -> tuple[Named | None, Changes]:
    """The effect that explains the readings instead of stale values, and what is stale beside it.

    None where none does, or where both explain alike: that is then said with what is stale. An effect must reach the
    threshold of any candidate, have a size beyond its uncertainty, leave nothing stale, be the likelier by LIKELIER,
    and say of the readings what no change of one component does: a new scale of one axis is one number, too. Nor does
    one where errors as large as expected tell the noise: how likely changes are is then said already. known: (n,) each,
    mm, what instruments do that are off.
    """
    if any(one.origin == EXPECTED for one in null.noise):
        return None, changes
    free = free_besides(null, known, ())
    tight = replace(ground, plain=free, base=free, wide=free, known={})
    residual = tight.left(free)
    scans = scan_all(tight, residual, ground.effects)
    best = best_of(tight, residual, scans)
    behind = changes.evidence + float(np.log10(max(len(scans), 1)))
    if best is None or best.scan.evidence < ground.threshold or best.scan.preference < behind - RIVAL:
        return None, changes
    found = search_of(tight, [best], scans)
    tight, found, (cause,) = with_best_periods(tight, found, refit(tight, (best,)), ())
    (best,) = with_rivals(tight, found).causes
    others = [one.fitted for one in best.rivals if one.fitted.effect != cause.effect]
    besides = (*imperfections(tight.readings, cause), *of_rivals((best,), (cause,)))
    left = stale_values(null, (*known, *directions_of(tight.readings, cause)), besides, tight.freedom)
    tried = [(cause, left), *((one, _left(tight, null, one, known)) for one in others[: MOST - 1])]
    # an effect that aliases to a slow curve at targets of one distance has any size
    vanishes = tuple(one.effect for one, its in tried if not its.stale and size_is_significant(one))
    stale = {one.component for one in changes.stale}
    # a wave as long as the travel is a curve of its component, as any other
    alone = {cause.effect.component, *(stale if len(stale) == 1 else ())}
    imitated = any(_imitates(null, free, one, cause) for one in alone)
    if cause.effect in vanishes and best.scan.preference >= behind + LIKELIER and not imitated:
        return Named(best, cause), left
    return None, replace(changes, stale=tuple(replace(one, effects=vanishes) for one in changes.stale))


def _imitates(null: Null, free: Projection, component: str | None, cause: Fitted) -> bool:
    """Whether a change of a component alone makes the readings what the effect makes them."""
    at = np.flatnonzero(np.array(null.base.components) == component)
    columns = null.whitening(null.base.machine.take(at).dense())
    basis, signal = orthonormal(free.rest(columns)), free.rest(null.whitening(cause.signal))
    left = signal - basis @ (basis.T @ signal)
    return bool(left @ left < APART * (signal @ signal))


def _left(tight: Ground, null: Null, cause: Fitted, known: Sequence[FloatArray]) -> Changes:
    """What is stale beside an effect."""
    besides = tuple(imperfections(tight.readings, cause))
    return stale_values(null, (*known, *directions_of(tight.readings, cause)), besides, tight.freedom)
