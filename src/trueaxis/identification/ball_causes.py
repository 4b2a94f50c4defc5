"""What explains how far the balls of a ball bar are apart: a dimension, the place of a ball, the length."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import cast

import numpy as np

from trueaxis.identification.words import enumerated
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import ideal_bar, measuring_frame
from trueaxis.measurement.setup import Run
from trueaxis.model.model import MachineModel

MOST_FITTED = 500  # positions that a cause is sought from
OFF = 5.0  # mm, what is left of distances where a cause explains them: a ball is set up within five with a ruler
FARTHEST = 500.0  # mm from what is given, from where a dimension is sought as well


def ball_causes(model: MachineModel, run: Run, positions: FloatArray, reading: FloatArray) -> str:
    """What explains the distances by itself, likeliest first: dimensions are given apart from the set-up and forgotten,
    a ball is set up by hand, a length stands on the bar. reading: (n,), mm.
    """
    every = slice(None, None, max(positions.shape[1] // MOST_FITTED, 1))
    positions = np.ascontiguousarray(positions[:, every])
    length = cast(float, run.length) + reading[every]
    causes = [
        *_dimensions(model, run, positions, length),
        *_ball(model, run, positions, length),
        *_length(model, run, positions, length),
    ]
    silent = [name for name in model.dimensions if name not in model.errors.parameters]
    hint = f"; {', '.join(silent)} are taken as zero (--known gives them)" if silent else ""
    if not causes:
        return f"points, positions and length that agree{hint}"
    first = "" if len(causes) == 1 else "one of these, likeliest first: "
    return f"{first}{'; '.join(causes)}{hint}"


def _dimensions(model: MachineModel, run: Run, positions: FloatArray, length: FloatArray) -> Iterator[str]:
    for name in model.dimensions:
        given = model.errors.parameters.get(name, 0.0)
        bars = [ideal_bar(_with(model, name, value), run, positions) for value in (given, given + 1.0)]

        def off(value: FloatArray, bars: Sequence[FloatArray] = bars) -> FloatArray:
            return np.asarray(np.linalg.norm(bars[0] + value * (bars[1] - bars[0]), axis=0) - length)

        values = _fits(off, [np.array([start]) for start in (-FARTHEST, FARTHEST)])
        if values:
            told = [f"{round(given + float(value[0]), 3) + 0.0:g}" for value in values]
            taken = "given as" if name in model.errors.parameters else "not given, taken as"
            yield f"dimension {name} = {enumerated(told, 'or')} mm (--known; {taken} {given:g})"


def _with(model: MachineModel, name: str, value: float) -> MachineModel:
    parameters = {**model.errors.parameters, name: value}
    return model.with_values(replace(model.errors, parameters=parameters))


def _ball(model: MachineModel, run: Run, positions: FloatArray, length: FloatArray) -> Iterator[str]:
    """Where the ball that rests in the measuring frame would have to be."""
    ends = {"target": run.target, "reference": run.reference}
    name, end = next((name, end) for name, end in ends.items() if end.on == measuring_frame(run))
    # the other ball, seen from the point that is given
    other = (-1.0 if name == "target" else 1.0) * ideal_bar(model, run, positions)

    def off(centre: FloatArray) -> FloatArray:
        return np.asarray(np.linalg.norm(other - centre[:, np.newaxis], axis=0) - length)

    # |p|^2 - 2 p c + k = length^2 with k = |c|^2 is linear: a start that no distance between the points can mislead
    rows = np.vstack([2.0 * other, -np.ones(other.shape[1])]).T
    start = np.linalg.lstsq(rows, (other**2).sum(axis=0) - length**2, rcond=1e-9)[0][:3]
    middle = other.mean(axis=1)
    normal = np.linalg.svd(other - middle[:, np.newaxis])[0][:, 2]  # of a circle's plane: it has a place on either side
    beside = start + normal * (normal @ (middle - start))
    starts = [beside + side * FARTHEST * normal for side in (-1.0, 1.0)]
    centres = _fits(off, [start, np.zeros(3), *starts])
    if centres:
        at = [str([round(float(value), 3) + 0.0 for value in np.array(end.point) + moved]) for moved in centres]
        yield f"the ball on the {end.on} would have to be at {enumerated(at, 'or')} (key {name}.point)"


def _length(model: MachineModel, run: Run, positions: FloatArray, length: FloatArray) -> Iterator[str]:
    off = np.linalg.norm(ideal_bar(model, run, positions), axis=0) - length
    if float(np.ptp(off)) <= OFF:
        yield f"is the length {cast(float, run.length) + float(np.mean(off)):.6g} mm? (key length)"


def _fits(off: Callable[[FloatArray], FloatArray], starts: Sequence[FloatArray]) -> list[FloatArray]:
    """Values that leave little, those next to what is given first; sought from several starts."""
    from scipy.optimize import least_squares  # noqa: PLC0415  only a fault asks for it

    found: list[list[FloatArray]] = []  # those that no ruler tells apart, such as on either side of a circle's plane
    for start in starts:
        fit = least_squares(off, start, max_nfev=100)
        if float(np.abs(fit.fun).max()) <= OFF:
            near = next((of for of in found if float(np.linalg.norm(of[0] - fit.x)) <= OFF), None)
            if near is None:
                found.append(near := [])
            near.append(np.asarray(fit.x, dtype=np.float64))
    middles = [0.5 * (np.min(of, axis=0) + np.max(of, axis=0)) for of in found]
    return sorted(middles, key=lambda middle: float(np.linalg.norm(middle)))
