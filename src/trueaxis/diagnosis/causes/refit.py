"""All causes fitted together: Gauss-Newton with shortened steps, with the derivatives that the kernels give."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from trueaxis.diagnosis.causes.search import Found, Ground
from trueaxis.diagnosis.causes.signature import Fitted, Readings
from trueaxis.diagnosis.causes.signatures import parameter_signature
from trueaxis.diagnosis.result import FloatArray
from trueaxis.effects.kind import Effect

STEPS = 12
FAR = 1.0  # share of a searched parameter by which the fit may leave it
HALVINGS = 12
CONVERGED = 1e-6  # of a standard uncertainty


def refit(ground: Ground, causes: Sequence[Found], steps: int = STEPS) -> tuple[Fitted, ...]:
    """Values and standard uncertainties of all parameters, base projected out. steps: at most."""
    if not causes:
        return ()
    ground = _beside_free_runs(ground, causes)
    kinds = [one.signature.kind for one in causes]
    effects = [one.scan.effect for one in causes]
    values = [start_of(one) for one in causes]
    ends = np.cumsum([0, *(one.size for one in values)])
    within = [_bounds(one, value, ground.readings) for one, value in zip(causes, values, strict=True)]
    values = [np.clip(one, low, high) for one, (low, high) in zip(values, within, strict=True)]
    covariance = np.zeros((int(ends[-1]), int(ends[-1])))
    for _ in range(steps):
        signals, jacobian = _linearised(ground.readings, effects, values)
        left = ground.wide.rest(ground.whitening(jacobian))
        residual = ground.wide.rest(ground.values - ground.whitening(signals.sum(axis=1)))
        step, covariance = _solved(left, residual)
        better = _improved(ground, effects, values, np.split(step, ends[1:-1]), within, float(residual @ residual))
        if better is None:
            break
        values = better
        spread = np.sqrt(np.maximum(np.diag(covariance), 0.0))
        if (np.abs(step) <= CONVERGED * spread + 1e-300).all():
            break
    signals, _ = _linearised(ground.readings, effects, values)
    spread = np.sqrt(np.diag(covariance))
    spread = np.where(spread > 0.0, spread, np.nan)
    return tuple(
        Fitted(effect=effect, kind=kind, values=values[k], u=u, signal=signals[:, k])
        for k, (effect, kind, u) in enumerate(zip(effects, kinds, np.split(spread, ends[1:-1]), strict=True))
    )


def _beside_free_runs(ground: Ground, causes: Sequence[Found]) -> Ground:
    """What runs without a temperature have of a cause says nothing of its size."""
    free = [one.signature.over_all()[:, -one.signature.free :] for one in causes if one.signature.free]
    return replace(ground, wide=ground.wide.extended(ground.whitening(np.hstack(free)))) if free else ground


def _bounds(one: Found, values: FloatArray, readings: Readings) -> tuple[FloatArray, FloatArray]:
    """How far each parameter may go: none beyond what is possible, searched ones by the place where they were found.

    A period as far as another half of it fits into the range of the axis: farther off it is another period.
    """
    most = one.signature.most
    low, high = np.full(values.size, -most), np.full(values.size, most)
    for place, parameter in enumerate(one.signature.kind.parameters):
        if parameter.role != "grid":
            continue
        share = FAR
        if parameter.grid == "pitch" and one.scan.effect.component:
            rows = readings.rows
            span = float(np.ptp(rows.positions[rows.axes.index(one.scan.effect.own_axis)]))
            share = min(FAR, 0.5 * values[place] / span)
        low[place], high[place] = values[place] / (1.0 + share), values[place] * (1.0 + share)
    return low, high


def _improved(
    ground: Ground,
    effects: Sequence[Effect],
    values: Sequence[FloatArray],
    steps: Sequence[FloatArray],
    within: Sequence[tuple[FloatArray, FloatArray]],
    before: float,
) -> list[FloatArray] | None:
    """The values after the step, halved until it does no harm: a time constant hardly told would run away. None where
    every step does. before: sum of squares at the values.
    """
    for halved in range(HALVINGS):
        tried = [
            np.clip(one + 0.5**halved * step, low, high)
            for one, step, (low, high) in zip(values, steps, within, strict=True)
        ]
        with np.errstate(all="ignore"):  # what overflows is NaN, and no improvement
            if _squares(ground, effects, tried) <= before:
                return tried
    return None


def _squares(ground: Ground, effects: Sequence[Effect], values: Sequence[FloatArray]) -> float:
    signals, _ = _linearised(ground.readings, effects, values)
    rest = ground.wide.rest(ground.values - ground.whitening(signals.sum(axis=1)))
    return float(rest @ rest)


def _solved(columns: FloatArray, residual: FloatArray) -> tuple[FloatArray, FloatArray]:
    size = np.linalg.norm(columns, axis=0)
    told = size > 1e-12 * size.max(initial=0.0)
    told &= size > 0.0
    scaled = columns[:, told] / size[told]
    inverse = np.linalg.pinv(scaled.T @ scaled, rcond=1e-10, hermitian=True)
    step, covariance = np.zeros(size.size), np.zeros((size.size, size.size))
    step[told] = (inverse @ (scaled.T @ residual)) / size[told]
    covariance[np.ix_(told, told)] = inverse / np.outer(size[told], size[told])
    return step, covariance


def _linearised(
    readings: Readings, effects: Sequence[Effect], values: Sequence[FloatArray]
) -> tuple[FloatArray, FloatArray]:
    """(n, n_causes) signals and (n, all parameters) derivatives, mm."""
    pairs = [parameter_signature(readings, effect, vector) for effect, vector in zip(effects, values, strict=True)]
    return np.stack([signal for signal, _ in pairs], axis=1), np.hstack([jacobian for _, jacobian in pairs])


def start_of(one: Found) -> FloatArray:
    """(m,): the parameters of a cause as it was found, in the order of its kind."""
    kind, scan = one.signature.kind, one.scan
    found = dict(scan.point)
    linear = [each.name for each in kind.parameters if each.role == "linear"]
    phases = [each.name for each in kind.parameters if each.role == "phase"]
    roots = [each.name for each in kind.parameters if each.role == "root"]
    if phases:
        found[linear[0]] = float(np.hypot(*scan.amplitudes))
        found[phases[0]] = float(np.arctan2(scan.amplitudes[1], scan.amplitudes[0]))
    elif roots:
        found[roots[0]] = float(np.sqrt(max(scan.amplitudes[0], 0.0)))
    else:
        found |= dict(zip(linear, scan.amplitudes[: len(linear)].tolist(), strict=True))
    return np.array([found[each.name] for each in kind.parameters])


def standing_effects(readings: Readings) -> tuple[Fitted, ...]:
    """Those of the spec that have values, with their signals; a squareness is a location error of the base."""
    model, found = readings.model, []
    for one in model.errors.effects:
        kind = model.machine.kinds[one.effect.kind]
        if kind.place != "location":
            values = one.vector(kind)
            signal, _ = parameter_signature(readings, one.effect, values)
            found.append(
                Fitted(effect=one.effect, kind=kind, values=values, u=np.full(values.size, np.nan), signal=signal)
            )
    return tuple(found)


def refitted_columns(readings: Readings, standing: tuple[Fitted, ...]) -> FloatArray:
    """(n, k): derivatives of the readings by all of their parameters."""
    columns = [parameter_signature(readings, one.effect, one.values)[1] for one in standing]
    return np.hstack(columns) if columns else np.zeros((readings.rows.size, 0))
