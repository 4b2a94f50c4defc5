"""What may be said of what was found: which names stand, what is stale, which runs no errors of the machine fit."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.diagnosis.causes.contest import contest
from trueaxis.diagnosis.causes.imperfection import beside_forms, imperfections, open_harmonics
from trueaxis.diagnosis.causes.neighbours import spoilt_values
from trueaxis.diagnosis.causes.refit import refit
from trueaxis.diagnosis.causes.rivals import of_rivals, with_best_periods, with_rivals
from trueaxis.diagnosis.causes.search import Ground, Search, search_of, without
from trueaxis.diagnosis.causes.signature import Fitted
from trueaxis.diagnosis.causes.signatures import directions_of
from trueaxis.diagnosis.judging.amplitudes import Uneven, amplitudes_of, unevenness
from trueaxis.diagnosis.judging.carried import carried_by_one
from trueaxis.diagnosis.judging.checks import fired_structure, run_checks
from trueaxis.diagnosis.judging.instruments import instruments_off
from trueaxis.diagnosis.judging.misfit import Known, misfits
from trueaxis.diagnosis.judging.off import Off
from trueaxis.diagnosis.judging.stale import Changes, stale_values
from trueaxis.diagnosis.judging.structure import Check
from trueaxis.diagnosis.judging.verdict import HOMOGENEOUS, explained_share, names_stand
from trueaxis.diagnosis.null_model.null import Null, what_is_free
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.result import AmplitudeOf, BoolArray, FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Judged:
    """search: with the rivals of causes that are named; causes, groups: those, with their amplitudes; stand: whether
    what was found may be named; unnamed: causes of the machine that were found and may not be; or_changed: components
    whose values may have changed in place of the cause, see `contest`.
    """

    search: Search
    causes: tuple[Fitted, ...]
    groups: tuple[tuple[tuple[AmplitudeOf, ...], float], ...]
    checks: tuple[Check, ...]
    stand: bool
    off: tuple[Off, ...] = ()
    misfits: tuple[str, ...] = ()
    unnamed: tuple[Fitted, ...] = ()
    or_changed: tuple[str, ...] = ()


def judged_causes(
    ground: Ground, null: Null, found: Search, causes: tuple[Fitted, ...], standing: Sequence[Fitted]
) -> Judged:
    """Whether causes found may be named, by what all of them together leave."""
    groups, uneven = _amplitudes(ground, found, causes)
    while len(causes) > 1 and min(one.p_value for one in uneven) < HOMOGENEOUS:
        # a further cause that is not one everywhere is none, and says nothing against the others
        found = without(ground, found, max(k for k, one in enumerate(uneven) if one.p_value < HOMOGENEOUS))
        ground, found, causes = with_best_periods(ground, found, refit(ground, found.causes), standing)
        groups, uneven = _amplitudes(ground, found, causes)
    checks = _checks(ground, found.projection, found.residual)
    hard = what_is_free(null, np.zeros((null.rows.size, 0))) if standing else ground.plain
    share = explained_share(ground, found, causes, checks, uneven, standing, hard)
    if names_stand(share, (*standing, *causes), checks, uneven):
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

    Causes that may not be named, and structure that nothing explains, are there all the same, and leave curves.
    """
    signals = [one.signal for one in (*standing, *judged.causes)]
    judged = replace(judged, off=instruments_off(null, np.sum([*signals, np.zeros(null.rows.size)], axis=0)))
    known = (*standing, *judged.causes, *judged.unnamed)
    # a phase or a period that is a little off leaves a curve
    free = [column for one in known for column in directions_of(ground.readings, one)]
    causes = [*free, *(one.signal for one in judged.off), *_seen(ground, judged)]
    besides = _curves_besides(ground, judged, known)
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
    return replace(judged, or_changed=tuple(one.component for one in changes.stale)), left, taken


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


def _curves_besides(ground: Ground, judged: Judged, known: Sequence[Fitted]) -> list[FloatArray]:
    """(n,) each, mm: that, and what would look like a changed curve of the machine if a rival were the cause, or the
    pitch another that the readings leave open.
    """
    open_ = [column for one in known for column in open_harmonics(ground.readings, one)]
    others = of_rivals(judged.search.causes, judged.causes, of_others=True) if judged.causes else ()
    return [*_besides(ground, judged, known), *open_, *others]


def _seen(ground: Ground, judged: Judged) -> Iterator[FloatArray]:
    """(n,) each, mm: structure that is left, as the checks that fired see it."""
    bare = ground.base, ground.base.rest(ground.values)
    beside = (judged.search.projection, judged.search.residual) if judged.causes else bare
    return fired_structure(ground.readings, ground.whitening, *beside, judged.checks)


def _checks(ground: Ground, projection: Projection, residual: FloatArray) -> tuple[Check, ...]:
    return run_checks(ground.readings, ground.whitening, projection, residual, ground.freedom)


def _amplitudes(
    ground: Ground, found: Search, causes: Sequence[Fitted]
) -> tuple[tuple[tuple[tuple[AmplitudeOf, ...], float], ...], list[Uneven]]:
    """Of every cause: those of its set-ups, and whether it is one."""
    groups = tuple(amplitudes_of(ground, causes, index) for index in range(len(causes)))
    return groups, unevenness(ground, found, causes, [p for _, p in groups])
