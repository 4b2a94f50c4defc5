"""Lines of lasers and probes: those that were taken, and new ones like them."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import cast

import numpy as np

from trueaxis.diagnosis.result import FloatArray
from trueaxis.diagnosis.rows import DECIMALS, Rows
from trueaxis.machine.machine import LINEAR
from trueaxis.machine.topology import branch
from trueaxis.measurement.reading_geometry import column, ideal_displacement
from trueaxis.measurement.setup import Instrument, PointOn, Run, Vector
from trueaxis.model.model import MachineModel

MARGIN = 0.01  # of the travel, that targets keep from its ends
TARGETS = 41
ALONG = 1.0 - 1e-6  # cosine from which a line is sensed along its motion


@dataclass(frozen=True, slots=True, eq=False)
class Line:
    """One pass there and back of a line. axis: the one that moves (of a diagonal: the first); motion: (3,), unit
    direction of the ideal motion of target against reference, in the measuring frame.
    """

    axis: str
    run: Run
    positions: FloatArray
    directions: FloatArray
    motion: FloatArray


def lines_at_hand(model: MachineModel, rows: Rows) -> list[Line]:
    """The first pass of every laser run in which one linear axis moves and is sensed along its motion."""
    found = []
    for index in rows.present:
        run, mine = rows.runs[index], rows.of_run(index)
        moving = np.flatnonzero(np.ptp(rows.positions[:, mine], axis=1) > 10.0**-DECIMALS)
        if run.instrument != "laser" or run.direction is None or moving.size != 1 or rows.axes[moving[0]] not in LINEAR:
            continue
        first = np.flatnonzero(rows.passing[mine] == 0) + mine.start
        positions = np.ascontiguousarray(rows.positions[:, first])
        motion = _motion(model, run, positions)
        if abs(float(np.array(run.direction) @ motion)) > ALONG:
            found.append(Line(rows.axes[moving[0]], run, positions, rows.directions[:, first], motion))
    return found


def line_anew(
    model: MachineModel,
    axis: str,
    at: Mapping[str, float],
    *,
    way: Mapping[str, float] | None = None,
    like: Line | None = None,
    instrument: Instrument = "laser",
    longest: float = np.inf,
) -> Line:
    """A line of an axis, there and back between the ends of its travel, the other axes standing `at` their places.

    way: signs of the axes of a diagonal, which move together; like: a line whose targets and points are taken over, the
    points moved along with the axes; longest: mm. What moves carries the target, what rests the reference.
    """
    way = way or {axis: 1.0}
    there = np.linspace(MARGIN, 1.0 - MARGIN, TARGETS)
    share = np.concatenate([there, there[::-1]])
    size = share.size if like is None else like.positions.shape[1]
    positions = np.repeat(np.array([[at[one]] for one in model.axes], dtype=np.float64), size, axis=1)
    directions = np.zeros_like(positions)
    home = dict(at)
    for one, sign in way.items():
        row = model.axes.index(one)
        if like is not None:
            positions[row], directions[row], home[one] = like.positions[row], like.directions[row], like.run.home[one]
            continue
        low, high = model.travel[one]
        if high - low > longest:
            low, high = 0.5 * (low + high - longest), 0.5 * (low + high + longest)
        if sign < 0.0:
            low, high = high, low
        positions[row] = np.round(low + share * (high - low), 3)
        directions[row] = np.repeat([np.sign(high - low), -np.sign(high - low)], TARGETS)
        home[one] = float(positions[row, 0])
    run = _pointed(model, axis, home, instrument) if like is None else _moved_along(model, like.run, home)
    motion = _motion(model, run, positions)
    return Line(axis, replace(run, instrument=instrument, direction=_vector(motion)), positions, directions, motion)


def middle(model: MachineModel) -> dict[str, float]:
    """Linear axes in the middle of their travels, rotary ones at 0 or as near as they come."""
    return {
        axis: 0.5 * (low + high) if axis in LINEAR else min(max(0.0, low), high)
        for axis, (low, high) in model.travel.items()
    }


def _pointed(model: MachineModel, axis: str, home: Mapping[str, float], instrument: Instrument) -> Run:
    """Tool and workpiece point at one place, with nothing between them that would be a lever."""
    seen = model.view_ideal("tool_in_workpiece", _place(model, home), column((0.0, 0.0, 0.0)))[:, 0]
    ends = PointOn("tool"), PointOn("workpiece", _vector(np.round(seen, 3)))
    carries = model.machine.mover(axis) in branch(model.machine, model.machine.workpiece)
    target, reference = ends[::-1] if carries else ends
    return Run("", instrument, target, reference, "bed", home, (1.0, 0.0, 0.0))


def _moved_along(model: MachineModel, run: Run, home: Mapping[str, float]) -> Run:
    """The same set-up at another home: the end on the workpiece goes where the end on the tool has gone."""
    points = {end.on: end for end in (run.target, run.reference)}
    if set(points) != {"tool", "workpiece"}:
        return replace(run, home=home)
    tool = column(points["tool"].point)
    was, now = (model.view_ideal("tool_in_workpiece", _place(model, each), tool)[:, 0] for each in (run.home, home))
    there = replace(points["workpiece"], point=_vector(np.round(points["workpiece"].point + now - was, 3)))
    if run.target.on == "workpiece":
        return replace(run, home=home, target=there)
    return replace(run, home=home, reference=there)


def _place(model: MachineModel, home: Mapping[str, float]) -> FloatArray:
    return np.array([[home[axis]] for axis in model.axes])


def _motion(model: MachineModel, run: Run, positions: FloatArray) -> FloatArray:
    """(3,): unit direction from one end of the line to the other; zero where nothing moves."""
    path = ideal_displacement(model, run, positions, _place(model, run.home))
    farthest = path[:, int(np.argmax(np.linalg.norm(path - path[:, :1], axis=0)))] - path[:, 0]
    size = float(np.linalg.norm(farthest))
    return farthest / size if size > 0.0 else farthest


def _vector(values: FloatArray) -> Vector:
    return cast(Vector, tuple(float(value) + 0.0 for value in values))
