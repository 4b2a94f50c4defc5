"""From what was computed to the record that report and diagnosis.json are made of; the verdict is reached here."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from trueaxis.diagnosis.absences import absences
from trueaxis.diagnosis.audit import Audit
from trueaxis.diagnosis.circles import circles_of
from trueaxis.diagnosis.gain import Left, fit, predicted
from trueaxis.diagnosis.instruments import Off
from trueaxis.diagnosis.linearisation import second_order_of
from trueaxis.diagnosis.measured import measured_with
from trueaxis.diagnosis.next_runs import Ahead, ahead_of, next_runs, separating_run
from trueaxis.diagnosis.null import Null
from trueaxis.diagnosis.prospect import Prospect
from trueaxis.diagnosis.refit import Fitted
from trueaxis.diagnosis.result import (
    AmplitudeOf,
    BoolArray,
    Cause,
    Check,
    Diagnosis,
    Estimate,
    Evidence,
    Gain,
    Residuals,
    Stale,
    Verdict,
)
from trueaxis.diagnosis.scan import Scanned
from trueaxis.diagnosis.search import Found, Ground, Search
from trueaxis.effects.kind import Kind
from trueaxis.effects.latex import effect_latex
from trueaxis.estimation.effects.unknowns import unit_in


@dataclass(frozen=True, slots=True, eq=False)
class Outcome:
    """All that the procedure has computed. causes, groups: those that
    are named, with their amplitudes by group and the p value of their being one; held: (n,), rows held back.
    """

    ground: Ground
    null: Null
    search: Search
    causes: tuple[Fitted, ...]
    groups: tuple[tuple[tuple[AmplitudeOf, ...], float], ...]
    verdict: Verdict
    off: tuple[Off, ...]
    audit: Audit
    prospect: Prospect
    checks: tuple[Check, ...]
    held: BoolArray
    left: Left
    gain: Gain
    stale: tuple[Stale, ...]
    stale_p: float
    report: Mapping[str, str]
    misfits: tuple[str, ...]


def diagnosis_of(outcome: Outcome) -> Diagnosis:
    """The record."""
    ground = outcome.ground
    prospect = outcome.prospect
    ahead = tuple(ahead_of(prospect, _found(outcome, one), float(one.values[0])) for one in outcome.causes)
    causes = tuple(_cause(outcome, index, one) for index, one in enumerate(ahead))
    if outcome.verdict != "unexplained_structure":
        causes += tuple(_of_instrument(ground, one) for one in outcome.off)
    return Diagnosis(
        machine=ground.readings.model.name,
        verdict=outcome.verdict,
        noise=outcome.null.noise,
        causes=causes,
        limits=outcome.audit.limits,
        isolability=outcome.audit.isolable,
        correlation=outcome.audit.correlation,
        scan=tuple(_evidence(one) for one in outcome.search.first),
        threshold=outcome.search.threshold,
        checks=outcome.checks,
        outliers=outcome.null.outliers,
        stale=outcome.stale,
        gain=outcome.gain,
        circles=circles_of(ground.readings, outcome.left),
        recalibration_p=outcome.stale_p,
        next_runs=next_runs(prospect, outcome.audit, ahead, outcome.checks, outcome.null.noise),
        absences=absences(ground.readings, outcome.audit),
        second_order=second_order_of(ground),
        residuals=_residuals(outcome),
        measured=measured_with(ground.readings.rows),
        report=outcome.report,
        misfits=outcome.misfits,
    )


def _cause(outcome: Outcome, index: int, ahead: Ahead) -> Cause:
    ground, fitted = outcome.ground, outcome.causes[index]
    found = _found(outcome, fitted)
    groups, homogeneous_p = outcome.groups[index]
    others = tuple(one for place, one in enumerate(outcome.causes) if place != index)
    without = outcome.gain.held_out.refitted
    if others:
        null = outcome.null
        alone = fit(null.base, null.whitening, null.values, others, ~outcome.held)
        without = predicted(alone, null.whitening, null.values, outcome.held).stage().extended
    rivals = tuple(_evidence(one) for one in found.rivals)
    return Cause(
        effect=fitted.effect,
        parameters=_parameters(fitted.kind, fitted),
        sentence=fitted.kind.sentence,
        formula=effect_latex(fitted.kind, fitted.effect),
        p_value=found.scan.p_value,
        evidence=found.scan.evidence,
        rms=float(np.sqrt(np.mean(fitted.signal**2))),
        held_out_gain=1.0 - outcome.gain.held_out.extended / without if without > 0.0 else 0.0,
        rivals=rivals,
        amplitudes=groups,
        homogeneous_p=homogeneous_p,
        remainder=any(check.fired for check in outcome.checks),
        separating=separating_run(ground.readings.model.machine.kinds, ahead),
    )


def _of_instrument(ground: Ground, off: Off) -> Cause:
    kind = ground.readings.model.machine.kinds[off.effect.kind]
    return Cause(
        effect=off.effect,
        parameters=_parameters(kind, off),
        sentence=kind.sentence,
        formula=effect_latex(kind, off.effect),
        p_value=off.p_value,
        evidence=-float(np.log10(max(off.p_value, 1e-300))),
        rms=float(np.sqrt(np.mean(off.signal**2))),
        held_out_gain=0.0,
        rivals=(),
        amplitudes=(),
        homogeneous_p=1.0,
        remainder=False,
        separating=None,
    )


def _parameters(kind: Kind, found: Fitted | Off) -> tuple[Estimate, ...]:
    return tuple(
        Estimate(one.name, float(value), float(u), unit_in(one.unit, found.effect))
        for one, value, u in zip(kind.parameters, found.values, found.u, strict=True)
    )


def _found(outcome: Outcome, fitted: Fitted) -> Found:
    return next(one for one in outcome.search.causes if one.scan.effect == fitted.effect)


def _evidence(one: Scanned) -> Evidence:
    return Evidence(one.effect, max(one.evidence, 0.0), one.p_value, one.tries, one.freedom)


def _residuals(outcome: Outcome) -> Residuals:
    readings = outcome.ground.readings
    rows, left = readings.rows, outcome.left
    named = bool(outcome.causes) or not outcome.search.causes
    ground_left = outcome.search.residual if named else outcome.ground.base.rest(outcome.ground.values)
    return Residuals(
        runs=tuple(run.id for run in rows.runs),
        instruments=tuple(run.instrument for run in rows.runs),
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
