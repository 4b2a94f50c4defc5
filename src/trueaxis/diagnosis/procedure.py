"""The diagnosis from readings to verdict: null model, search, audit, judgement, gain, values identified anew."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.diagnosis.causes.candidates import candidates
from trueaxis.diagnosis.causes.hidden_by_noise import in_noise_of_a_run, likeliest
from trueaxis.diagnosis.causes.imperfection import beside_forms
from trueaxis.diagnosis.causes.neighbours import LeftOut, among, disturbed, of_one_run
from trueaxis.diagnosis.causes.refit import refit, refitted_columns, standing_effects
from trueaxis.diagnosis.causes.rivals import with_best_periods
from trueaxis.diagnosis.causes.search import MOST_CAUSES, Each, Found, Ground, Search, search, search_of, settled
from trueaxis.diagnosis.causes.signature import Fitted, Readings, readings_of
from trueaxis.diagnosis.extend import Extend, identified_anew
from trueaxis.diagnosis.further_runs.audit import audit
from trueaxis.diagnosis.further_runs.prospect import prospect_of
from trueaxis.diagnosis.judging.gain import fit, gain_by_unit, held_out, predicted
from trueaxis.diagnosis.judging.judgement import Judged, beside_misfits, judged_causes, judged_runs, judged_values
from trueaxis.diagnosis.judging.off import Off, with_instead
from trueaxis.diagnosis.judging.scale_off import less_scale_off
from trueaxis.diagnosis.judging.stale import Changes
from trueaxis.diagnosis.null_model.base import given_by_chance
from trueaxis.diagnosis.null_model.frames import written_once
from trueaxis.diagnosis.null_model.freedom import freedom_of
from trueaxis.diagnosis.null_model.null import Null, again, balls_anywhere, rougher, what_is_free
from trueaxis.diagnosis.null_model.outliers import left_out, null_of, spoilt_beside
from trueaxis.diagnosis.null_model.roughness import roughness_of
from trueaxis.diagnosis.null_model.rows import Rows, rows_of
from trueaxis.diagnosis.null_model.temperature import smoothed
from trueaxis.diagnosis.result import Diagnosis, FloatArray, NoiseOf
from trueaxis.diagnosis.write_up import Outcome, diagnosis_of
from trueaxis.effects.kind import Effect
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.reading_model import expected_readings
from trueaxis.model.covariance import Covariance
from trueaxis.model.model import MachineModel

AGAIN = 0.03  # relative change of the noise, causes taken away, from which the search is done again
LOWER = 0.1  # the same beside what that search found, from which it is done a third time


@dataclass(frozen=True, slots=True, kw_only=True)
class DiagnoseOptions:
    """noise_um: of a reading, where it is known, else from repeats. covariance: of the model's error values, see
    `load_uncertainty`; None: they are exact. progress: told each stage. each: how candidates are gone through, one
    after another or by several threads; what is found is the same, to the last digit. extend: the model of the machine
    with the causes that a diagnosis names, from which its values are identified anew; None: they are not. ahead:
    whether to say what further runs would tell, a sixth of the time; the verdict is the same without.
    """

    noise_um: float | None = None
    covariance: Covariance | None = None
    progress: Callable[[str], None] = lambda _: None
    each: Each = map
    extend: Extend | None = None
    ahead: bool = True


def diagnose(model: MachineModel, data: MeasuredData, options: DiagnoseOptions | None = None) -> Diagnosis:
    """What the model gets wrong of the data, and why. Raises ValueError where no reading can be used, or where error
    values name their covariance and the options have none; InputError where the readings hold no value of the machine
    with the causes named.

    Cost: linear in the number of readings, times rank of the base (hundreds) times the points of all grids.
    """
    options = options or DiagnoseOptions()
    if model.errors.covariance is not None and options.covariance is None:
        raise ValueError(f"the values are as uncertain as {model.errors.covariance.file} has it: see load_uncertainty")
    options.progress("reading")
    rows = written_once(model, rows_of(smoothed(data)))
    if rows.size == 0:
        raise ValueError("no reading can be used: plans, or taken beside reversals, or directions are unknown")
    options.progress("noise")
    null = _given(null_of(model, rows, rows.reading - _expected(model, rows), options.noise_um), model, options)
    null, off = less_scale_off(null, options.noise_um)
    data = _less(data, null.rows, off)
    null, ground, judged, changes = _with_runs(model, null, options)
    judged = replace(judged, off=with_instead(null.rows, (*off, *judged.off)))
    # neither needs the other: where there are threads both are worked out at once
    audits, prospects = options.each(audit, [ground]), options.each(prospect_of, [ground] if options.ahead else [])
    options.progress("gain")
    (audited,), prospect = audits, next(iter(prospects), None)
    outcome = _outcome(ground, null, judged, changes)

    def record(outcome: Outcome) -> Diagnosis:
        return diagnosis_of(outcome, audited, prospect, data.setup.report)

    before = record(outcome)
    if options.extend is None:
        return before
    options.progress("extending")
    anew = identified_anew(model, data, before, options.extend)
    if set(anew.misfits) <= set(before.misfits):
        return replace(before, errors=anew.errors, values=anew.values, settled=anew.settled)
    judged, changes = beside_misfits(ground, judged, changes, anew.misfits)
    return replace(record(_outcome(ground, null, judged, changes)), errors=anew.errors)


def _less(data: MeasuredData, rows: Rows, off: Sequence[Off]) -> MeasuredData:
    """The readings without what scales that are off make of them."""
    reading = data.readings.reading.copy()
    for one in off:
        reading[rows.row] -= one.signal
    return replace(data, readings=replace(data.readings, reading=reading)) if off else data


def _outcome(ground: Ground, null: Null, judged: Judged, changes: Changes) -> Outcome:
    """With what was gained. Where balls stand is nothing that the model gets wrong."""
    held, split = held_out(null.rows)
    every = np.ones_like(held)
    free = balls_anywhere(null)
    white, values, causes = free.whitening, null.values, judged.causes
    on_all, on_others = (fit(null.base, white, values, causes, rows) for rows in (every, ~held))
    of_all = predicted(on_all, white, values, every)
    gain, of_held = gain_by_unit((on_all, on_others), free, (held, split))
    return Outcome(
        ground=ground,
        null=null,
        judged=judged,
        changes=changes,
        held=held,
        left=of_all.left,
        predicted=of_held,
        gain=gain,
    )


def _expected(model: MachineModel, rows: Rows) -> FloatArray:
    return expected_readings(model, rows.runs, rows.run, rows.positions, rows.context)


def _with_runs(model: MachineModel, null: Null, options: DiagnoseOptions) -> tuple[Null, Ground, Judged, Changes]:
    """All that may be said; a run that looks wrong may only hold a reading that is spoilt, and that causes hide."""
    null, ground, judged, changes, standing = _judged(model, null, options)
    options.progress("runs")
    of_all, changes_beside = judged_runs(ground, null, judged, changes, standing)
    if of_all.misfits and judged.causes and (named := _without_spoilt(model, null, judged.causes, options)):
        null, ground, judged, changes, standing = named
        of_all, changes_beside = judged_runs(ground, null, judged, changes, standing)
    return null, ground, of_all, changes_beside


def _judged(
    model: MachineModel, null: Null, options: DiagnoseOptions
) -> tuple[Null, Ground, Judged, Changes, Sequence[Fitted]]:
    """What may be named and what is stale, without readings whose disturbance would be taken for stale values."""
    while True:
        null, ground, found, causes, standing = _undisturbed(model, null, options)
        ground, found, causes = with_best_periods(ground, found, causes, standing)
        options.progress("checks")
        judged = judged_causes(ground, null, found, causes, standing)
        if causes and not judged.stand and (named := _without_spoilt(model, null, causes, options)):
            return named
        options.progress("values given")
        judged, changes, taken = judged_values(ground, null, judged, standing)
        if not taken.any():
            return null, ground, judged, changes, standing
        null = _given(left_out(null, taken, options.noise_um), model, options)


def _without_spoilt(
    model: MachineModel, null: Null, causes: Sequence[Fitted], options: DiagnoseOptions
) -> tuple[Null, Ground, Judged, Changes, Sequence[Fitted]] | None:
    """The same without outliers that causes hide, if it is these that take the names away."""
    spoilt = spoilt_beside(null, [one.signal for one in causes])
    if not spoilt.any():
        return None
    found = _judged(model, _given(left_out(null, spoilt, options.noise_um), model, options), options)
    return found if found[2].causes else None


def _undisturbed(
    model: MachineModel, null: Null, options: DiagnoseOptions
) -> tuple[Null, Ground, Search, tuple[Fitted, ...], Sequence[Fitted]]:
    """The search without readings whose disturbance would be taken for a cause.

    A disturbance is of two readings: a cause that is found again without them, and that two more of their run explain,
    is no disturbance.
    """
    doubted, real = dict[Effect, tuple[Null, LeftOut]](), frozenset[Effect]()
    while True:
        readings = readings_of(model, null.rows)
        standing = standing_effects(readings)
        free = refitted_columns(readings, standing)
        beside, ground, found, causes = _beside_causes(readings, free, null, options, standing)
        pairs = disturbed(ground, found, real)
        if not pairs:
            return beside, ground, found, causes, standing
        lasting = next(
            (one for one, pair in pairs.items() if one in doubted and of_one_run(pair, doubted[one][1])), None
        )
        if lasting is not None:
            null, real, doubted = doubted[lasting][0], real | {lasting}, {}
            continue
        for one, pair in pairs.items():
            first, before = doubted.get(one, (null, frozenset()))
            doubted[one] = first, before | pair
        taken = frozenset[tuple[int, int]]().union(*pairs.values())
        null = _given(left_out(null, among(null.rows, taken), options.noise_um), model, options)


def _beside_causes(
    readings: Readings, free: FloatArray, null: Null, options: DiagnoseOptions, standing: Sequence[Fitted]
) -> tuple[Null, Ground, Search, tuple[Fitted, ...]]:
    """The search, and again with the noise that is left beside what was found; where nothing was, beside the likeliest.

    Without repeats the noise takes up what nobody has named yet, and hides it; that of a run, what acts on it alone.
    """
    null, ground, found, causes = _searched(readings, free, null, options, standing)
    start = (found.causes,) if causes else tuple((one,) for one in likeliest(ground, found))
    for tried in start:
        known, fresh = _noise_beside(ground, null, tried, options)
        changed = _changed(null.noise, fresh.noise)
        if not causes and not changed:
            continue  # the noise is no reason why nothing was found
        beside = fresh if changed else null
        anew = _searched(readings, free, beside, options, (*standing, *known), tried, doubted=not causes)
        if causes or anew[3]:
            null, ground, found, causes = anew
            break
    if causes:  # the first noise may still have held much of them
        known, fresh = _noise_beside(ground, null, found.causes, options)
        if _changed(null.noise, fresh.noise, LOWER):
            anew = _searched(readings, free, fresh, options, (*standing, *known), found.causes)
            null, ground, found, causes = anew if anew[3] else (null, ground, found, causes)
    while len(causes) < MOST_CAUSES and (further := in_noise_of_a_run(ground, found)):
        tried = (*found.causes, further)
        known, fresh = _noise_beside(ground, null, tried, options)
        anew = _searched(readings, free, fresh, options, (*standing, *known), tried)
        if further.scan.effect not in [one.effect for one in anew[3]]:
            break
        null, ground, found, causes = anew
    return null, ground, found, causes


def _noise_beside(
    ground: Ground, null: Null, tried: Sequence[Found], options: DiagnoseOptions
) -> tuple[tuple[Fitted, ...], Null]:
    """Causes as they are fitted, and the null model with the noise that they leave."""
    known = refit(ground, tried)
    return known, again(null, np.sum([one.signal for one in known], axis=0), options.noise_um)


def _searched(
    readings: Readings,
    free: FloatArray,
    null: Null,
    options: DiagnoseOptions,
    known: Sequence[Fitted],
    start: Sequence[Found] = (),
    *,
    doubted: bool = False,
) -> tuple[Null, Ground, Search, tuple[Fitted, ...]]:
    """With the base as rough as it has to be.

    free: (n, k), mm, columns that are free besides; known: causes whose forms may lack something; start: where to
    begin; doubted: whether nothing is looked at unless one of these stands: the noise hid none of them.
    """
    white = null.whitening
    plain = what_is_free(null, free)
    bare = Ground(
        readings=readings,
        effects=candidates(readings.model, null.rows),
        whitening=white,
        plain=plain,
        base=plain,
        wide=plain,
        values=white(null.values),
        freedom=freedom_of(null.rows, white, null.noise),
        progress=options.progress,
        rough=null.base.rough,
        each=options.each,
    )
    ground = beside_forms(bare, known)
    if doubted and not settled(ground, start):
        return null, ground, search_of(ground, (), ()), ()
    higher = readings.memory.higher(readings.model, null)
    ground = replace(ground, roughness=roughness_of(higher, white, ground.base))
    found = search(ground, start)
    if found.rough:
        rough = _given(rougher(readings.model, null, found.rough, options.noise_um), readings.model, options)
        return _searched(readings, free, rough, options, known, start)
    return null, ground, found, refit(ground, found.causes)


def _given(null: Null, model: MachineModel, options: DiagnoseOptions) -> Null:
    if options.covariance is None:
        return null
    return replace(null, given=given_by_chance(model, null.base, options.covariance))


def _changed(before: Sequence[NoiseOf], after: Sequence[NoiseOf], share: float = AGAIN) -> bool:
    each = [[(one.sigma, one.sigma + one.settles + one.wanders) for one in noises] for noises in (before, after)]
    one, other = (np.array(sizes).reshape(-1) for sizes in each)
    return bool((np.abs(one - other) > share * np.maximum(one, other)).any())
