"""From what was computed to the record that report and diagnosis.json are made of; the verdict is reached here."""

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import cast

import numpy as np

from trueaxis.diagnosis.causes.scan import Scanned
from trueaxis.diagnosis.causes.search import Found, Ground, Rival
from trueaxis.diagnosis.causes.signature import Fitted, Readings
from trueaxis.diagnosis.further_runs.absences import absences
from trueaxis.diagnosis.further_runs.audit import DETECTION, Audit
from trueaxis.diagnosis.further_runs.next_runs import ahead_of, next_runs, separating_run
from trueaxis.diagnosis.further_runs.of_plan import NextRun, Separating
from trueaxis.diagnosis.further_runs.prospect import Prospect
from trueaxis.diagnosis.judging.gain import Left, fit, predicted
from trueaxis.diagnosis.judging.judgement import Judged
from trueaxis.diagnosis.judging.off import Instead, Off
from trueaxis.diagnosis.judging.stale import Changes
from trueaxis.diagnosis.judging.verdict import verdict_of
from trueaxis.diagnosis.null_model.null import Null
from trueaxis.diagnosis.null_model.rows import Rows, plane_of
from trueaxis.diagnosis.result import (
    BoolArray,
    Cause,
    Circle,
    Diagnosis,
    Estimate,
    Evidence,
    FloatArray,
    Gain,
    MeasuredWith,
    Residuals,
    SecondOrder,
    Stage,
)
from trueaxis.effects.kind import Kind
from trueaxis.effects.latex import effect_latex
from trueaxis.estimation.effects.unknowns import unit_in
from trueaxis.estimation.runs import noise_groups
from trueaxis.evaluation.circular_test import circularity
from trueaxis.measurement.reading_geometry import column, sensed_points


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Outcome:
    """All that the procedure has found in the readings. held: (n,), rows held back; left: of all rows; predicted: RMS
    of those held back, lengths and angles (at ARM) together, mm.
    """

    ground: Ground
    null: Null
    judged: Judged
    changes: Changes
    held: BoolArray
    left: Left
    predicted: Stage
    gain: Gain


def diagnosis_of(outcome: Outcome, audited: Audit, prospect: Prospect | None, report: Mapping[str, str]) -> Diagnosis:
    """The record. audited, prospect: of what the runs can show, and what further ones could, None where nobody asked;
    report: what setup.toml says in free words.
    """
    ground, judged = outcome.ground, outcome.judged
    stale, instead = outcome.changes.stale, judged.or_changed
    verdict = verdict_of(judged.search, judged.stand, judged.checks, stale, judged.off, judged.misfits, instead)
    further: tuple[NextRun, ...] = ()
    separating: tuple[Separating | None, ...] = (None,) * len(judged.causes)
    if prospect is not None:
        ahead = tuple(ahead_of(prospect, _found(judged, one), float(one.values[0])) for one in judged.causes)
        further = next_runs(prospect, audited, ahead, () if judged.misfits else judged.checks, outcome.null.noise)
        separating = tuple(separating_run(ground.readings.model.machine.kinds, one) for one in ahead)
    causes = tuple(_cause(outcome, index, one) for index, one in enumerate(separating))
    if verdict != "unexplained_structure":
        causes += tuple(_of_instrument(ground, one) for one in judged.off)
    return Diagnosis(
        machine=ground.readings.model.name,
        verdict=verdict,
        noise=outcome.null.noise,
        causes=causes,
        limits=audited.limits,
        isolability=audited.isolable,
        correlation=audited.correlation,
        scan=tuple(_evidence(one) for one in judged.search.first),
        threshold=judged.search.threshold,
        checks=judged.checks,
        outliers=outcome.null.outliers,
        stale=outcome.changes.stale,
        gain=outcome.gain,
        circles=_circles(ground.readings, outcome.left),
        recalibration_p=outcome.changes.p_value,
        next_runs=further,
        absences=absences(ground.readings, audited),
        second_order=second_order_of(ground),
        residuals=_residuals(outcome),
        measured=measured_with(ground.readings.rows),
        report=report,
        misfits=judged.misfits,
    )


def _circles(readings: Readings, left: Left) -> tuple[Circle, ...]:
    """Circular deviation of each ball-bar run, and what each stage of the model leaves of it."""
    rows, found = readings.rows, []
    for index in (one for one in rows.present if rows.runs[one].instrument == "ballbar"):
        mine = rows.of_run(index)
        theta = readings.reading.theta[mine]
        parts = {
            "measured": rows.reading, "given": left.given, "refitted": left.refitted, "extended": left.extended
        }  # fmt: skip
        with suppress(ValueError):  # too few of its readings count
            each = {name: circularity(theta, part[mine]).deviation for name, part in parts.items()}
            found.append(Circle(run=rows.runs[index].id, **each))
    return tuple(found)


def _cause(outcome: Outcome, index: int, separating: Separating | None) -> Cause:
    judged = outcome.judged
    fitted = judged.causes[index]
    found = _found(judged, fitted)
    groups, homogeneous_p = judged.groups[index]
    others = tuple(one for place, one in enumerate(judged.causes) if place != index)
    without = outcome.predicted.refitted
    if others:
        null = outcome.null
        alone = fit(null.base, null.whitening, null.values, others, ~outcome.held)
        without = predicted(alone, null.whitening, null.values, outcome.held).stage().extended
    rivals = tuple(_rival(fitted, one) for one in found.rivals)
    return Cause(
        effect=fitted.effect,
        parameters=_parameters(fitted.kind, fitted),
        sentence=fitted.kind.sentence,
        formula=effect_latex(fitted.kind, fitted.effect),
        p_value=found.scan.p_value,
        evidence=found.scan.evidence,
        rms=float(np.sqrt(np.mean(fitted.signal**2))),
        held_out_gain=1.0 - outcome.predicted.extended / without if without > 0.0 else 0.0,
        rivals=rivals,
        amplitudes=groups,
        homogeneous_p=homogeneous_p,
        remainder=any(check.fired for check in judged.checks),
        separating=separating,
        or_changed=judged.or_changed,
    )


def _of_instrument(ground: Ground, off: Off) -> Cause:
    kind = ground.readings.model.machine.kinds[off.effect.kind]
    return Cause(
        effect=off.effect,
        parameters=_parameters(kind, off),
        sentence=kind.sentence,
        formula=effect_latex(kind, off.effect),
        p_value=off.p_value,
        evidence=_decades(off),
        rms=float(np.sqrt(np.mean(off.signal**2))),
        held_out_gain=0.0,
        rivals=tuple(_in_place(ground, off, one) for one in off.instead),
        amplitudes=(),
        homogeneous_p=1.0,
        remainder=False,
        separating=None,
    )


def _in_place(ground: Ground, off: Off, one: Instead) -> Evidence:
    """As likely as what is off: it makes the same of the readings."""
    parameters = _parameters(ground.readings.model.machine.kinds[one.effect.kind], one)
    return Evidence(
        effect=one.effect,
        evidence=_decades(off),
        p_value=off.p_value,
        tries=1.0,
        freedom=one.values.size,
        parameters=parameters,
    )


def _decades(off: Off) -> float:
    return -float(np.log10(max(off.p_value, 1e-300)))


def _parameters(kind: Kind, found: Fitted | Off | Instead) -> tuple[Estimate, ...]:
    return tuple(
        Estimate(one.name, float(value), float(u), unit_in(one.unit, found.effect))
        for one, value, u in zip(kind.parameters, found.values, found.u, strict=True)
    )


def _found(judged: Judged, fitted: Fitted) -> Found:
    return next(one for one in judged.search.causes if one.scan.effect == fitted.effect)


def _rival(cause: Fitted, one: Rival) -> Evidence:
    differs_by = next(iter(one.scan.point), "") if one.fitted.effect == cause.effect else ""
    parameters = _parameters(one.fitted.kind, one.fitted)
    return replace(_evidence(one.scan), parameters=parameters, differs_by=differs_by)


def _evidence(one: Scanned) -> Evidence:
    return Evidence(
        effect=one.effect, evidence=max(one.evidence, 0.0), p_value=one.p_value, tries=one.tries, freedom=one.freedom
    )


def _residuals(outcome: Outcome) -> Residuals:
    readings = outcome.ground.readings
    rows, left = readings.rows, outcome.left
    judged = outcome.judged
    named = bool(judged.causes) or not judged.search.causes
    ground_left = judged.search.residual if named else outcome.ground.base.rest(outcome.ground.values)
    return Residuals(
        runs=tuple(run.id for run in rows.runs),
        instruments=tuple(run.instrument for run in rows.runs),
        noise_groups=noise_groups(rows.runs),
        axes=rows.axes,
        row=rows.row,
        run=rows.run,
        seq=rows.seq,
        positions=rows.positions,
        directions=rows.directions,
        time=rows.time,
        temperature=rows.temperature,
        feed=rows.feed,
        theta=readings.reading.theta,
        along=readings.reading.along,
        reading=rows.reading,
        given=left.given,
        refitted=left.refitted,
        extended=left.extended,
        whitened=ground_left,
    )


def second_order_of(ground: Ground) -> SecondOrder:
    """How large the terms are, and whether these readings could show them at all."""
    terms = second_order(ground.readings)
    left = ground.base.rest(ground.whitening(terms))
    return SecondOrder(float(np.abs(terms).max(initial=0.0)), float(left @ left) > DETECTION)


def second_order(readings: Readings) -> FloatArray:
    """(n,), mm: exact less first-order deviations of the model as given, along what each instrument senses."""
    model, rows = readings.model, readings.rows
    errors = model.in_context(readings.context).component_errors(rows.positions)
    found = np.zeros(rows.size)
    for index in rows.present:
        run, mine = rows.runs[index], rows.of_run(index)
        positions = np.ascontiguousarray(rows.positions[:, mine])
        along = np.zeros(positions.shape[1])
        for one in sensed_points(model, run, positions):
            inputs = (positions, np.ascontiguousarray(errors[:, mine]), model.parameter_values, column(one.point))
            exact = model.kernels[f"{one.view}_deviation"](*inputs)
            dropped = exact - model.kernels[f"{one.view}_deviation_first_order"](*inputs)
            along += np.einsum("in,in->n", one.direction, dropped)
        found[mine] = along if run.instrument == "ballbar" else along - along[0]
    return cast(FloatArray, found)


def measured_with(rows: Rows) -> tuple[MeasuredWith, ...]:
    """One of each device, in the order of the runs; runs that do not name one are of one device."""
    members: dict[tuple[str, str], list[int]] = {}
    for index in rows.present:
        run = rows.runs[index]
        members.setdefault((run.instrument, run.device.id if run.device else ""), []).append(index)
    return tuple(_of_device(rows, indices) for indices in members.values())


def _of_device(rows: Rows, indices: Sequence[int]) -> MeasuredWith:
    runs = [rows.runs[index] for index in indices]
    mine = np.isin(rows.run, indices)
    device = runs[0].device
    return MeasuredWith(
        instrument=runs[0].instrument,
        device=device.id if device else "",
        serial=device.serial if device else "",
        sessions=tuple(dict.fromkeys(run.session for run in runs if run.session)),
        runs=len(runs),
        readings=int(mine.sum()),
        motions=tuple(dict.fromkeys(plane_of(rows, rows.run == index) for index in indices)),
        time_s=_range(rows.time, mine),
        temperature_c=_range(rows.temperature, mine),
    )


def _range(values: FloatArray | None, mine: np.ndarray) -> tuple[float, float] | None:
    known = np.zeros(0) if values is None else values[mine & np.isfinite(values)]
    return (float(known.min()), float(known.max())) if known.size else None
