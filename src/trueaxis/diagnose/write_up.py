"""From what was computed to the record that report and diagnosis.json are made of; the verdict is reached here."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.diagnose.amplitudes import amplitudes_of
from trueaxis.diagnose.audit import Audit, unit_at
from trueaxis.diagnose.base import Base
from trueaxis.diagnose.circles import circles_of
from trueaxis.diagnose.formula import formula_of
from trueaxis.diagnose.gain import Left, fitted_left
from trueaxis.diagnose.next_runs import next_runs, separating_run
from trueaxis.diagnose.refit import Fitted
from trueaxis.diagnose.result import (
    BoolArray,
    Cause,
    Check,
    Diagnosis,
    Estimate,
    Evidence,
    FloatArray,
    Gain,
    NoiseOf,
    Outlier,
    Residuals,
    Verdict,
)
from trueaxis.diagnose.scan import Scanned
from trueaxis.diagnose.search import Found, Ground, Search

HOMOGENEOUS = 1e-4  # p below which the amplitudes of a cause are not one
NEARLY_ALL = 0.97  # share of what was to be explained from which a remainder does not take the name back


@dataclass(frozen=True, slots=True, eq=False)
class Outcome:
    """All that the procedure has computed."""

    ground: Ground
    base: Base
    search: Search
    causes: tuple[Fitted, ...]
    audit: Audit
    checks: tuple[Check, ...]
    outliers: tuple[Outlier, ...]
    gain: Gain
    left: Left
    expected: FloatArray
    held: BoolArray
    stale_p: float
    noise: tuple[NoiseOf, ...]
    recalibrate: bool


def diagnosis_of(outcome: Outcome) -> Diagnosis:
    """The record; no name is given where structure is left that the causes do not account for."""
    fired = any(check.fired for check in outcome.checks)
    causes = tuple(_cause(outcome, index, fired) for index in range(len(outcome.causes)))
    verdict = _verdict(outcome, causes, fired)
    if verdict == "unexplained_structure":
        outcome = _without_causes(outcome)
        causes = ()
    ground = outcome.ground
    return Diagnosis(
        machine=ground.readings.model.name,
        verdict=verdict,
        noise=tuple({one.instrument: one for one in outcome.noise}.values()),
        causes=causes,
        limits=outcome.audit.limits,
        isolability=outcome.audit.isolable,
        correlation=outcome.audit.correlation,
        scan=tuple(_evidence(one) for one in outcome.search.first),
        threshold=outcome.search.threshold,
        checks=outcome.checks,
        outliers=outcome.outliers,
        gain=outcome.gain,
        circles=circles_of(ground.readings, outcome.left),
        recalibration_p=outcome.stale_p,
        next_runs=next_runs(ground, outcome.audit, causes),
        absences=_absences(outcome),
        warnings=_warnings(outcome, causes, verdict),
        residuals=_residuals(outcome),
    )


def explained_share(outcome: Outcome) -> float:
    """Share of the excess of whitened squares over noise that the causes account for."""
    ground = outcome.ground
    rest = ground.base.rest(ground.values)
    freedom = rest.size - ground.base.rank
    before = float(rest @ rest) - freedom
    after = float(outcome.search.residual @ outcome.search.residual) - (freedom - len(outcome.causes))
    explained = sum(one.scan.statistic - one.scan.freedom for one in outcome.search.causes)
    return explained / max(explained + max(after, 0.0), 1e-300) if before > 0.0 else 1.0


def _verdict(outcome: Outcome, causes: Sequence[Cause], fired: bool) -> Verdict:
    if not causes:
        if fired:
            return "unexplained_structure"
        return "recalibrate" if outcome.recalibrate else "no_discrepancy"
    homogeneous = all(one.homogeneous_p > HOMOGENEOUS for one in causes)
    if not homogeneous or (fired and explained_share(outcome) < NEARLY_ALL):
        return "unexplained_structure"
    return "ambiguous" if any(one.rivals for one in causes) else "explained"


def _cause(outcome: Outcome, index: int, fired: bool) -> Cause:
    ground, fitted = outcome.ground, outcome.causes[index]
    found = _found(outcome, fitted)
    groups, homogeneous_p = amplitudes_of(ground, outcome.causes, index)
    others = tuple(one for place, one in enumerate(outcome.causes) if place != index)
    train = ~outcome.held
    with_it = outcome.gain.held_out.extended
    left = fitted_left(outcome.base, ground.whitening, _values(outcome), others, train)
    without = float(np.sqrt(np.mean(left.extended[outcome.held] ** 2)))
    rivals = tuple(_evidence(one) for one in found.rivals)
    return Cause(
        effect=fitted.effect,
        parameters=tuple(
            Estimate(one.name, float(value), float(u), unit_at(one.unit, fitted.effect))
            for one, value, u in zip(fitted.kind.parameters, fitted.values, fitted.u, strict=True)
        ),
        sentence=fitted.kind.sentence,
        formula=formula_of(ground.readings.model.machine, fitted.effect),
        p_value=found.scan.p_value,
        evidence=found.scan.evidence,
        rms=float(np.sqrt(np.mean(fitted.signal**2))),
        held_out_gain=1.0 - with_it / without if without > 0.0 else 0.0,
        rivals=rivals,
        amplitudes=groups,
        homogeneous_p=homogeneous_p,
        remainder=fired,
        separating=separating_run(ground, fitted.effect, [one.effect for one in rivals]),
    )


def _found(outcome: Outcome, fitted: Fitted) -> Found:
    return next(one for one in outcome.search.causes if one.scan.effect == fitted.effect)


def _values(outcome: Outcome) -> FloatArray:
    rows = outcome.ground.readings.rows
    return np.asarray(rows.reading - outcome.expected)


def _without_causes(outcome: Outcome) -> Outcome:
    gain, left = outcome.gain, outcome.left
    rms, held = (replace(stage, extended=stage.refitted) for stage in (gain.rms, gain.held_out))
    return replace(
        outcome, causes=(), gain=replace(gain, rms=rms, held_out=held), left=replace(left, extended=left.refitted)
    )


def _evidence(one: Scanned) -> Evidence:
    return Evidence(one.effect, max(one.evidence, 0.0), one.p_value, one.tries, one.freedom)


def _absences(outcome: Outcome) -> tuple[str, ...]:
    """Each column that is missing, with the kinds that cannot be seen without it."""
    costs: dict[str, list[str]] = {}
    for limit in outcome.audit.limits:
        if limit.reason.startswith("no "):
            costs.setdefault(limit.reason[3:], []).append(limit.effect.kind)
    return tuple(f"without {what}: {', '.join(dict.fromkeys(kinds))} cannot be seen" for what, kinds in costs.items())


def _warnings(outcome: Outcome, causes: Sequence[Cause], verdict: Verdict) -> tuple[str, ...]:
    found = []
    for one in {each.instrument: each for each in outcome.noise}.values():
        if one.origin != "repeats":
            found.append(f"noise of the {one.instrument}: {one.origin}; repeat runs to know it")
    if verdict == "unexplained_structure":
        found.append("structure is left that no known cause explains: no name is given")
    found += [
        f"{one.effect.label}: beside it structure is left ({outcome.gain.rms.extended * 1e3:.2f} um in all)"
        for one in causes
        if one.remainder
    ]
    found += [
        f"{one.effect.label} and {', '.join(r.effect.label for r in one.rivals)} predict the same readings"
        for one in causes
        if one.rivals
    ]
    if outcome.outliers:
        found.append(f"{len(outcome.outliers)} readings far from their repeats were left out")
    return tuple(found)


def _residuals(outcome: Outcome) -> Residuals:
    readings = outcome.ground.readings
    rows, left = readings.rows, outcome.left
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
        whitened=outcome.search.residual,
    )
