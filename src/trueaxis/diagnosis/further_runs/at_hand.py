"""Lines of lasers and circles of ball bars that were taken, one pass of each."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.diagnosis.null_model.rows import DECIMALS, Rows
from trueaxis.diagnosis.result import FloatArray
from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.reading_effects import theta
from trueaxis.measurement.reading_geometry import ideal_displacement
from trueaxis.measurement.setup import Run
from trueaxis.model.model import MachineModel

ALONG = 1.0 - 1e-6  # cosine from which a line is sensed along its motion
RETURNING = 0.1  # share of its way that a run goes back, from which on it shows both directions


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Line:
    """One pass there and back of a line. axis: the one that moves; motion: (3,), unit
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
        if run.instrument != "laser" or moving.size != 1 or rows.axes[moving[0]] not in LINEAR:
            continue
        first = np.flatnonzero(rows.passing[mine] == 0) + mine.start
        positions = np.ascontiguousarray(rows.positions[:, first])
        motion = motion_of(model, run, positions)
        if is_along(run, motion):
            found.append(
                Line(
                    axis=rows.axes[moving[0]],
                    run=run,
                    positions=positions,
                    directions=rows.directions[:, first],
                    motion=motion,
                )
            )
    return found


def is_along(run: Run, motion: FloatArray) -> bool:
    """Whether a line is sensed along its motion, (3,)."""
    return run.direction is not None and abs(float(np.array(run.direction) @ motion)) > ALONG


def motion_of(model: MachineModel, run: Run, positions: FloatArray) -> FloatArray:
    """(3,): unit direction from one end of the line to the other; zero where nothing moves."""
    path = ideal_displacement(model, run, positions, np.array([[run.home[axis]] for axis in model.axes]))
    farthest = path[:, int(np.argmax(np.linalg.norm(path - path[:, :1], axis=0)))] - path[:, 0]
    size = float(np.linalg.norm(farthest))
    return farthest / size if size > 0.0 else farthest


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
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
        found.append(
            Round(
                plane=plane,
                sense=sense,
                feed=feed,
                run=run,
                positions=positions,
                directions=rows.directions[:, first],
                returns=returns,
            )
        )
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
