"""The diagnosis from readings to verdict: null model, audit, search, refit, checks, stale values, gain."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.diagnosis.amplitudes import amplitudes_of
from trueaxis.diagnosis.audit import audit
from trueaxis.diagnosis.candidates import candidates
from trueaxis.diagnosis.checks import run_checks
from trueaxis.diagnosis.contest import contest
from trueaxis.diagnosis.freedom import freedom_of
from trueaxis.diagnosis.gain import fit, gain_of, held_out, predicted
from trueaxis.diagnosis.given import given_by_chance
from trueaxis.diagnosis.imperfection import imperfection, imperfections
from trueaxis.diagnosis.instruments import Off, instruments_off
from trueaxis.diagnosis.misfit import Known, misfits
from trueaxis.diagnosis.null import Null, again, null_of
from trueaxis.diagnosis.projection import Projection, spanned
from trueaxis.diagnosis.prospect import prospect_of
from trueaxis.diagnosis.refit import Fitted, refit
from trueaxis.diagnosis.result import AmplitudeOf, Check, Diagnosis, FloatArray, NoiseOf
from trueaxis.diagnosis.rows import Rows, rows_of
from trueaxis.diagnosis.search import (
    Each,
    Found,
    Ground,
    Search,
    likeliest,
    search,
    whitened_columns,
    with_rivals,
    without,
)
from trueaxis.diagnosis.signatures import Readings, readings_of
from trueaxis.diagnosis.stale import Changes, stale_values
from trueaxis.diagnosis.standing import refitted_columns, standing_effects
from trueaxis.diagnosis.temperature import smoothed
from trueaxis.diagnosis.verdict import HOMOGENEOUS, explained_share, names_stand, size_is_significant, verdict_of
from trueaxis.diagnosis.write_up import Outcome, diagnosis_of
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.reading_model import expected_readings
from trueaxis.model.covariance import Covariance
from trueaxis.model.model import MachineModel

AGAIN = 0.03  # relative change of the noise, causes taken away, from which the search is done again


@dataclass(frozen=True, slots=True)
class DiagnoseOptions:
    """noise_um: of a reading, where it is known, else from repeats. covariance: of the model's error values, see
    `load_uncertainty`; None: they are exact. progress: told each stage. each: how candidates are gone through, one
    after another or by several threads; what is found is the same, to the last digit. misfits: runs that are known
    to fit no errors of the machine, by an estimate of these.
    """

    noise_um: float | None = None
    covariance: Covariance | None = None
    progress: Callable[[str], None] = lambda _: None
    each: Each = map
    misfits: tuple[str, ...] = ()


def diagnose(model: MachineModel, data: MeasuredData, options: DiagnoseOptions | None = None) -> Diagnosis:
    """What the model gets wrong of the data, and why. Raises ValueError where no reading can be used, or where error
    values name their covariance and the options have none.

    Cost: linear in the number of readings, times rank of the base (hundreds) times the points of all grids.
    """
    options = options or DiagnoseOptions()
    if model.errors.covariance is not None and options.covariance is None:
        raise ValueError(f"the values are as uncertain as {model.errors.covariance.file} has it: see load_uncertainty")
    options.progress("reading")
    rows = rows_of(smoothed(data))
    if rows.size == 0:
        raise ValueError("no reading can be used: plans, or taken beside reversals, or directions are unknown")
    options.progress("noise")
    null = null_of(model, rows, rows.reading - _expected(model, rows), options.noise_um)
    if options.covariance is not None:
        null = replace(null, given=given_by_chance(model, null.base, options.covariance))
    readings = readings_of(model, null.rows)
    standing = standing_effects(readings)
    free = refitted_columns(readings, standing)
    null, ground, found, causes = _beside_causes(readings, free, null, options, standing)
    values = null.values
    # neither looks at the readings: where there are threads they are worked out beside what follows
    audits, prospects = options.each(audit, [ground]), options.each(prospect_of, [ground])
    options.progress("checks")
    judged = _judged(ground, null, found, causes, standing)
    options.progress("values given")
    judged, changes = _values_judged(ground, null, judged, standing)
    options.progress("runs")
    judged, changes = _runs_judged(ground, null, judged, changes, standing, options.misfits)
    causes = judged.causes
    options.progress("gain")
    held, split = held_out(null.rows)
    every = np.ones_like(held)
    of_all = predicted(fit(null.base, null.whitening, values, causes, every), null.whitening, values, every)
    of_held = predicted(fit(null.base, null.whitening, values, causes, ~held), null.whitening, values, held)
    gain = gain_of(of_all, of_held, split, float(np.sqrt(np.mean(null.whitening.sigma**2))))
    (audited,), (prospect,) = audits, prospects
    return diagnosis_of(
        Outcome(
            ground=ground,
            null=null,
            search=judged.search,
            causes=causes,
            groups=judged.groups,
            verdict=verdict_of(judged.search, judged.stand, judged.checks, changes.stale, judged.off, judged.misfits),
            off=judged.off,
            audit=audited,
            prospect=prospect,
            checks=judged.checks,
            held=held,
            left=of_all.left,
            gain=gain,
            stale=changes.stale,
            stale_p=changes.p_value,
            report=data.setup.report,
            misfits=judged.misfits,
        )
    )


@dataclass(frozen=True, slots=True, eq=False)
class _Judged:
    """search: with the rivals of causes that are named; causes, groups: those, with their amplitudes; stand: whether
    what was found may be named.
    """

    search: Search
    causes: tuple[Fitted, ...]
    groups: tuple[tuple[tuple[AmplitudeOf, ...], float], ...]
    checks: tuple[Check, ...]
    stand: bool
    off: tuple[Off, ...] = ()
    misfits: tuple[str, ...] = ()


def _judged(
    ground: Ground, null: Null, found: Search, causes: tuple[Fitted, ...], standing: Sequence[Fitted]
) -> _Judged:
    """Whether causes found may be named, by what all of them together leave."""
    groups = _amplitudes(ground, causes)
    while len(causes) > 1 and min(p for _, p in groups) < HOMOGENEOUS:
        # a further cause that is not one everywhere is none, and says nothing against the others
        found = without(ground, found, max(k for k, (_, p) in enumerate(groups) if p < HOMOGENEOUS))
        causes = refit(ground, found.causes)
        groups = _amplitudes(ground, causes)
    checks = _checks(ground, found.projection, found.residual)
    hard = _plain(null, np.zeros((null.rows.size, 0))) if standing else ground.plain
    homogeneous_p = [p for _, p in groups]
    share = explained_share(ground, found, causes, checks, homogeneous_p, standing, hard)
    if names_stand(share, (*standing, *causes), checks, homogeneous_p) and all(map(size_is_significant, causes)):
        return _Judged(with_rivals(ground, found), causes, groups, checks, stand=True)
    return _without_names(ground, _Judged(found, causes, groups, checks, stand=False))


def _without_names(ground: Ground, judged: _Judged) -> _Judged:
    """With what all checks see beside no cause."""
    checks = _checks(ground, ground.base, ground.base.rest(ground.values)) if judged.causes else judged.checks
    return _Judged(judged.search, (), (), checks, stand=False)


def _values_judged(ground: Ground, null: Null, judged: _Judged, standing: Sequence[Fitted]) -> tuple[_Judged, Changes]:
    """Instruments that are off, and values given that are stale: or the effect that takes their place."""
    known = (*standing, *judged.causes)
    signals = [one.signal for one in known]
    besides = [column for one in known for column in imperfections(ground.readings, one)]
    off = instruments_off(null, np.sum([*signals, np.zeros(null.rows.size)], axis=0))
    signals += [one.signal for one in off]
    judged = replace(judged, off=off)
    changes = stale_values(null, signals, besides, ground.freedom)
    if not changes.stale or judged.search.causes or any(one.fired for one in judged.checks):
        return judged, changes
    named, left = contest(ground, null, changes, signals)
    if named is None:
        return judged, left
    projection = ground.base.extended(whitened_columns(ground, named.found.signature))
    residual = projection.rest(ground.values)
    checks = _checks(ground, projection, residual)
    if any(one.fired for one in checks):
        return judged, changes
    search = replace(judged.search, causes=(named.found,), projection=projection, residual=residual)
    return replace(judged, search=search, causes=(named.cause,), groups=(((), 1.0),), checks=checks, stand=True), left


def _runs_judged(
    ground: Ground,
    null: Null,
    judged: _Judged,
    changes: Changes,
    standing: Sequence[Fitted],
    known: Sequence[str],
) -> tuple[_Judged, Changes]:
    """Runs that no errors of the machine fit, and no name beside them: they are of the wrong sign, or belong elsewhere.

    known: of these.
    """
    causes = (*standing, *judged.causes)
    nothing = np.zeros((null.rows.size, 0))
    beside = Known(
        signals=np.column_stack([nothing, *(one.signal for one in (*causes, *judged.off))]),
        besides=np.column_stack([nothing, *(one for cause in causes for one in imperfections(ground.readings, cause))]),
    )
    wrong = tuple(dict.fromkeys([*misfits(null, beside), *known]))
    if not wrong:
        return judged, changes
    return replace(_without_names(ground, judged), misfits=wrong), replace(changes, stale=())


def _checks(ground: Ground, projection: Projection, residual: FloatArray) -> tuple[Check, ...]:
    rows, theta = ground.readings.rows, ground.readings.reading.theta
    return run_checks(rows, theta, ground.whitening, projection, residual, ground.freedom)


def _amplitudes(ground: Ground, causes: Sequence[Fitted]) -> tuple[tuple[tuple[AmplitudeOf, ...], float], ...]:
    return tuple(amplitudes_of(ground, causes, index) for index in range(len(causes)))


def _expected(model: MachineModel, rows: Rows) -> FloatArray:
    return expected_readings(model, rows.runs, rows.run, rows.positions, rows.context)


def _beside_causes(
    readings: Readings, free: FloatArray, null: Null, options: DiagnoseOptions, standing: Sequence[Fitted]
) -> tuple[Null, Ground, Search, tuple[Fitted, ...]]:
    """The search, and again with the noise that is left beside what was found; where nothing was, beside the likeliest.

    Without repeats the noise takes up what nobody has named yet, and hides it.
    """
    ground, found, causes = _searched(readings, free, null, options, standing)
    start = (found.causes,) if causes else tuple((one,) for one in likeliest(ground, found))
    for tried in start:
        known = refit(ground, tried)
        fresh = again(null, np.sum([one.signal for one in known], axis=0), options.noise_um)
        changed = _changed(null.noise, fresh.noise)
        if not causes and not changed:
            continue  # the noise is no reason why nothing was found
        anew = _searched(readings, free, fresh if changed else null, options, (*standing, *known), tried)
        if causes or anew[2]:
            return (fresh if changed else null, *anew)
    return null, ground, found, causes


def _searched(
    readings: Readings,
    free: FloatArray,
    null: Null,
    options: DiagnoseOptions,
    known: Sequence[Fitted],
    start: Sequence[Found] = (),
) -> tuple[Ground, Search, tuple[Fitted, ...]]:
    white = null.whitening
    plain = _plain(null, free)
    bare = Projection(plain.basis)
    chance = imperfection(readings, known, lambda columns: bare.rest(white(columns)))
    of_laser = white(null.base.by_chance)
    ground = Ground(
        readings=readings,
        effects=candidates(readings.model, null.rows),
        whitening=white,
        plain=plain,
        base=bare.softened(np.hstack([of_laser, chance.beside])),
        values=white(null.values),
        freedom=freedom_of(null.rows, white.sigma, null.noise),
        progress=options.progress,
        each=options.each,
        wide=bare.softened(np.hstack([of_laser, chance.columns])),
    )
    found = search(ground, start)
    return ground, found, refit(ground, found.causes)


def _plain(null: Null, free: FloatArray) -> Projection:
    """What is no news before any cause is known. free: (n, k), mm, columns that are free besides."""
    columns = null.base.columns.beside(free) if free.size else null.base.columns
    basis = Projection(spanned(columns.whitened(null.whitening)))
    return basis.softened(null.whitening(null.base.by_chance))


def _changed(before: Sequence[NoiseOf], after: Sequence[NoiseOf]) -> bool:
    pairs = [(one.sigma, other.sigma) for one, other in zip(before, after, strict=True)]
    pairs += [(_whole(one), _whole(other)) for one, other in zip(before, after, strict=True)]
    return any(abs(one - other) > AGAIN * max(one, other) for one, other in pairs)


def _whole(one: NoiseOf) -> float:
    return one.sigma + one.settles + one.wanders
