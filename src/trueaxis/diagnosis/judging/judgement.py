"""What may be said of what was found: which names stand, what is stale, which runs no errors of the machine fit."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.special import ndtr

from trueaxis.diagnosis.causes.contest import contest
from trueaxis.diagnosis.causes.imperfection import beside_forms, imperfections
from trueaxis.diagnosis.causes.neighbours import spoilt_values
from trueaxis.diagnosis.causes.refit import refit
from trueaxis.diagnosis.causes.rivals import of_rivals, with_best_periods, with_rivals
from trueaxis.diagnosis.causes.search import Ground, Search, search_of, without
from trueaxis.diagnosis.causes.signature import Fitted
from trueaxis.diagnosis.causes.signatures import directions_of
from trueaxis.diagnosis.judging.carried import carried_by_one
from trueaxis.diagnosis.judging.checks import run_checks
from trueaxis.diagnosis.judging.instruments import Off, instruments_off
from trueaxis.diagnosis.judging.misfit import Known, misfits
from trueaxis.diagnosis.judging.stale import Changes, stale_values
from trueaxis.diagnosis.judging.structure import Check
from trueaxis.diagnosis.judging.verdict import HOMOGENEOUS, explained_share, names_stand
from trueaxis.diagnosis.null_model.null import Null, what_is_free
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.result import AmplitudeOf, BoolArray, FloatArray

TOLERANCE = 0.1  # of the amplitude, by which groups may differ: no real effect has the exact form
TELLING = 1e-3  # share of the information below which a group says nothing of the amplitude


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Judged:
    """search: with the rivals of causes that are named; causes, groups: those, with their amplitudes; stand: whether
    what was found may be named; unnamed: causes of the machine that were found and may not be.
    """

    search: Search
    causes: tuple[Fitted, ...]
    groups: tuple[tuple[tuple[AmplitudeOf, ...], float], ...]
    checks: tuple[Check, ...]
    stand: bool
    off: tuple[Off, ...] = ()
    misfits: tuple[str, ...] = ()
    unnamed: tuple[Fitted, ...] = ()


def judged_causes(
    ground: Ground, null: Null, found: Search, causes: tuple[Fitted, ...], standing: Sequence[Fitted]
) -> Judged:
    """Whether causes found may be named, by what all of them together leave."""
    groups = _amplitudes(ground, causes)
    while len(causes) > 1 and min(p for _, p in groups) < HOMOGENEOUS:
        # a further cause that is not one everywhere is none, and says nothing against the others
        found = without(ground, found, max(k for k, (_, p) in enumerate(groups) if p < HOMOGENEOUS))
        ground, found, causes = with_best_periods(ground, found, refit(ground, found.causes), standing)
        groups = _amplitudes(ground, causes)
    checks = _checks(ground, found.projection, found.residual)
    hard = what_is_free(null, np.zeros((null.rows.size, 0))) if standing else ground.plain
    homogeneous_p = [p for _, p in groups]
    share = explained_share(ground, found, causes, checks, homogeneous_p, standing, hard)
    if names_stand(share, (*standing, *causes), checks, homogeneous_p):
        return Judged(search=with_rivals(ground, found), causes=causes, groups=groups, checks=checks, stand=True)
    return without_names(ground, Judged(search=found, causes=causes, groups=groups, checks=checks, stand=False))


def without_names(ground: Ground, judged: Judged) -> Judged:
    """With what all checks see beside no cause."""
    checks = _checks(ground, ground.base, ground.base.rest(ground.values)) if judged.causes else judged.checks
    unnamed = tuple(one for one in judged.causes if one.kind.place in ("component", "location"))
    return Judged(search=judged.search, causes=(), groups=(), checks=checks, stand=False, unnamed=unnamed)


def judged_values(
    ground: Ground, null: Null, judged: Judged, standing: Sequence[Fitted]
) -> tuple[Judged, Changes, BoolArray]:
    """Instruments that are off, and values given that are stale: or the effect that takes their place; or (n,),
    readings that explain as well what looks stale.
    """
    known = (*standing, *judged.causes)
    off = instruments_off(null, np.sum([*(one.signal for one in known), np.zeros(null.rows.size)], axis=0))
    of_instruments = [one.signal for one in off]
    # a phase or a period that is a little off leaves a curve
    free = [column for one in known for column in directions_of(ground.readings, one)]
    judged = replace(judged, off=off)
    besides, causes = _besides(ground, judged, known), [*free, *of_instruments]
    changes = stale_values(null, causes, besides, ground.freedom)
    taken = spoilt_values(null, changes, causes, besides, ground.freedom)
    if not changes.stale or taken.any() or judged.search.causes or any(one.fired for one in judged.checks):
        return judged, changes, taken
    named, left = contest(ground, null, changes, causes)
    if named is None:
        return judged, left, taken
    ground = beside_forms(ground, (*standing, named.cause))
    search = replace(search_of(ground, (named.found,), judged.search.first), threshold=judged.search.threshold)
    checks = _checks(ground, search.projection, search.residual)
    if any(one.fired for one in checks):
        return judged, changes, taken
    judged = replace(judged, search=search, causes=(named.cause,), groups=(((), 1.0),), checks=checks, stand=True)
    return judged, left, taken


def judged_runs(
    ground: Ground, null: Null, judged: Judged, changes: Changes, standing: Sequence[Fitted]
) -> tuple[Judged, Changes]:
    """Runs that no errors of the machine fit, beside causes of the machine, whether these may be named or not.

    What is left beside a cause may be a wrong run; without the cause sound ones would be the first to look wrong.
    """
    known = (*standing, *judged.causes, *judged.unnamed)
    carried, where = carried_by_one(null, (*judged.causes, *judged.unnamed))
    if carried:
        others = [one for one in known if one not in carried]
        forms = [column for one in others for column in imperfections(ground.readings, one)]
        wrong = misfits(null, _known(null, judged, others, forms))
        if wrong and where.issuperset(wrong):
            return beside_misfits(ground, judged, changes, wrong)
    besides = _besides(ground, judged, known)
    return beside_misfits(ground, judged, changes, misfits(null, _known(null, judged, known, besides)))


def _known(null: Null, judged: Judged, causes: Sequence[Fitted], besides: Sequence[FloatArray]) -> Known:
    """Causes, instruments that are off, and what causes may do besides."""
    nothing = np.zeros((null.rows.size, 0))
    signals = [*(one.signal for one in causes), *(one.signal for one in judged.off)]
    return Known(np.column_stack([nothing, *signals]), np.column_stack([nothing, *besides]))


def beside_misfits(ground: Ground, judged: Judged, changes: Changes, runs: Sequence[str]) -> tuple[Judged, Changes]:
    """Without names and stale values where there are such runs: what these read belongs to another machine."""
    if not runs:
        return judged, changes
    wrong = tuple(dict.fromkeys([*judged.misfits, *runs]))
    return replace(without_names(ground, judged), misfits=wrong), replace(changes, stale=())


def _besides(ground: Ground, judged: Judged, known: Sequence[Fitted]) -> list[FloatArray]:
    """(n,) each, mm: what causes may do besides, or would if another of their periods were the right one."""
    forms = [column for one in known for column in imperfections(ground.readings, one)]
    return [*forms, *(of_rivals(judged.search.causes, judged.causes) if judged.causes else ())]


def _checks(ground: Ground, projection: Projection, residual: FloatArray) -> tuple[Check, ...]:
    return run_checks(ground.readings, ground.whitening, projection, residual, ground.freedom)


def _amplitudes(ground: Ground, causes: Sequence[Fitted]) -> tuple[tuple[tuple[AmplitudeOf, ...], float], ...]:
    return tuple(amplitudes_of(ground, causes, index) for index in range(len(causes)))


def amplitudes_of(ground: Ground, causes: Sequence[Fitted], index: int) -> tuple[tuple[AmplitudeOf, ...], float]:
    """Amplitude and standard uncertainty by set-up, in the unit of the first parameter, and p of their being one.

    The other causes and the base are fitted beside.
    """
    rows = ground.readings.rows
    mine = causes[index]
    size = mine.values[0]
    groups = [
        (rows.setup == number)
        for number in np.unique(rows.setup)
        if np.abs(mine.signal[rows.setup == number]).max(initial=0.0) > 0.0
    ]
    if size == 0.0 or len(groups) < 2:
        return (), 1.0
    others = [ground.whitening(one.signal) for place, one in enumerate(causes) if place != index]
    projection = ground.base.extended(np.stack(others, axis=1)) if others else ground.base
    whole = projection.rest(ground.whitening(mine.signal))
    residual = projection.rest(ground.values)
    columns = projection.rest(
        ground.whitening(np.stack([np.where(group, mine.signal, 0.0) for group in groups], axis=1))
    )
    found, worst = [], 1.0
    for place, group in enumerate(groups):
        solved = _apart(whole, columns[:, place], residual)
        if solved is None:
            continue
        share, u, excess, excess_u = solved
        found.append(AmplitudeOf(_name(ground, group), share * size, u * abs(size)))
        z = excess / np.hypot(excess_u, TOLERANCE)
        worst = min(worst, float(2.0 * ndtr(-abs(z))) * len(groups))
    return tuple(found), min(worst, 1.0)


def _apart(whole: FloatArray, part: FloatArray, residual: FloatArray) -> tuple[float, float, float, float] | None:
    """Share of the amplitude in one group, its u, and by how much it exceeds that of all others, and its u.

    None where the group alone does not tell: its signature is the same as the whole, or the base holds it.
    """
    pair = np.stack([whole, part], axis=1)
    gram = pair.T @ pair
    if gram[1, 1] < TELLING * gram[0, 0] or 1.0 - gram[0, 1] ** 2 / (gram[0, 0] * gram[1, 1]) < 1e-6:
        return None
    inverse = np.linalg.inv(gram)
    value = inverse @ (pair.T @ residual)
    both = float(inverse.sum())
    return float(value.sum()), float(np.sqrt(max(both, 0.0))), float(value[1]), float(np.sqrt(inverse[1, 1]))


def _name(ground: Ground, group: FloatArray) -> str:
    rows = ground.readings.rows
    return ", ".join(rows.runs[index].id for index in np.unique(rows.run[group]))
