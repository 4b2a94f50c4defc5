"""Circles by ball bar: those that were taken, and new ones like them."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import cast

import numpy as np

from trueaxis.diagnosis.lines_at_hand import middle
from trueaxis.diagnosis.result import FloatArray
from trueaxis.diagnosis.rows import DECIMALS, Rows
from trueaxis.measurement.reading_context import theta
from trueaxis.measurement.reading_geometry import column, ideal_bar
from trueaxis.measurement.setup import PointOn, Run, Vector
from trueaxis.model.model import MachineModel
from trueaxis.planning.candidates import follow

SAMPLES = 180
RETURNING = 0.1  # share of its way that a run goes back, from which on it shows both directions
RADII = (150.0, 100.0, 50.0)  # mm, of bars, where none is at hand


@dataclass(frozen=True, slots=True, eq=False)
class Round:
    """A run of a ball bar. plane: the axes that move, such as XY; sense: +1 where the polar angle grows; feed: mm/min,
    NaN where unknown; returns: whether it goes there and back.
    """

    plane: str
    sense: int
    feed: float
    run: Run
    positions: FloatArray
    directions: FloatArray
    returns: bool = False


def rounds_at_hand(model: MachineModel, rows: Rows) -> list[Round]:
    """All runs of ball bars, their first pass."""
    found = []
    for index in rows.present:
        run, mine = rows.runs[index], rows.of_run(index)
        if run.instrument != "ballbar" or mine.stop - mine.start < 3:
            continue
        first = np.flatnonzero(rows.passing[mine] == 0) + mine.start
        positions = np.ascontiguousarray(rows.positions[:, first])
        moving = "".join(
            axis for axis, at in zip(rows.axes, positions, strict=True) if float(np.ptp(at)) > 10.0**-DECIMALS
        )
        plane = "ZX" if moving == "XZ" else moving
        feed = np.nan if rows.feed is None else float(np.median(rows.feed[first]))
        sense, returns = _sense(model, run, positions)
        found.append(Round(plane, sense, feed, run, positions, rows.directions[:, first], returns))
    return found


def both_ways(rounds: Sequence[Round]) -> bool:
    """Whether the polar angle grows in some of them and falls in some."""
    return len({one.sense for one in rounds}) > 1 or any(one.returns for one in rounds)


def _sense(model: MachineModel, run: Run, positions: FloatArray) -> tuple[int, bool]:
    """Of the polar angle, and whether it returns; of a bar that stands still while a table turns, of the last axis that
    moves.
    """
    steps = np.diff(np.unwrap(theta(model, run, positions)))
    if float(np.abs(steps).max(initial=0.0)) < 1e-6:
        moving = np.flatnonzero(np.ptp(positions, axis=1) > 0.0)
        steps = np.diff(positions[moving[-1]]) if moving.size else steps
    back = float(np.abs(steps[steps < 0.0]).sum()) / max(float(np.abs(steps).sum()), 1e-300)
    return 1 if back <= 0.5 else -1, RETURNING < back < 1.0 - RETURNING


def plane_round(model: MachineModel, plane: Sequence[str], rounds: Sequence[Round]) -> Round | None:
    """A circle in another plane, about the middle of the travels, with the bar at hand; None where none fits."""
    tool = next((end.point for one in rounds for end in (one.run.target, one.run.reference) if end.on == "tool"), None)
    tool = tool or (0.0, 0.0, 0.0)
    home = middle(model)
    at = np.array([[home[axis]] for axis in model.axes])
    centre = model.view_ideal("tool_in_workpiece", at, column(tool))
    for radius in tuple(one.run.length for one in rounds if one.run.length)[:1] or RADII:
        ball = PointOn("workpiece", _vector(np.round(centre[:, 0], 3)))
        run = Run("", "ballbar", PointOn("tool", tool), ball, "bed", home, None, radius)
        found = _circle(model, plane, run, at, radius)
        if found is not None:
            return found
    return None


def scaled_round(model: MachineModel, one: Round, ratio: float) -> Round | None:
    """The circle with a bar of another length about the same ball; None where it leaves the travels."""
    if one.run.length is None or {one.run.target.on, one.run.reference.on} != {"tool", "workpiece"}:
        return None
    tool, ball = (next(e for e in (one.run.target, one.run.reference) if e.on == on) for on in ("tool", "workpiece"))
    bar = ideal_bar(model, one.run, one.positions) * (1.0 if one.run.target is tool else -1.0)
    way = column(ball.point) + ratio * bar
    positions = follow(model, one.positions, tool.point, way)
    if positions is None or positions.shape != one.positions.shape:
        return None
    return replace(one, run=replace(one.run, length=ratio * one.run.length), positions=positions)


def _circle(model: MachineModel, plane: Sequence[str], run: Run, at: FloatArray, radius: float) -> Round | None:
    step = 2.0 * np.pi / SAMPLES
    angle = 0.25 * np.pi + step * (np.arange(SAMPLES) + 0.5)
    # as of the readings at hand, the sample on either side of a reversal is left out
    angle = angle[np.abs(np.mod(angle + 0.25 * np.pi, 0.5 * np.pi) - 0.25 * np.pi) > step]
    positions = np.repeat(at, angle.size, axis=1)
    directions = np.zeros_like(positions)
    for axis, phase in zip(plane, (angle, angle - 0.5 * np.pi), strict=True):
        row = model.axes.index(axis)
        positions[row] = np.round(at[row] + radius * np.cos(phase), 3)
        directions[row] = -np.sign(np.sin(phase))
        low, high = model.travel[axis]
        if positions[row].min() < low or positions[row].max() > high:
            return None
    return Round("".join(plane), 1, np.nan, run, positions, directions)


def _vector(values: FloatArray) -> Vector:
    return cast(Vector, tuple(float(value) + 0.0 for value in values))
