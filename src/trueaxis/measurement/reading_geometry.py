"""The geometry of a reading: whose coordinates it is made of, where it is zero and what it senses without errors."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import cast

import numpy as np

from trueaxis.measurement.instrument_kinds import ANGLE, ARM
from trueaxis.measurement.machine import FloatArray, MeasuredMachine
from trueaxis.measurement.setup import PointOn, Run, Vector
from trueaxis.view import Frame, View, view_of

ARM_POINTS: tuple[Vector, ...] = ((ARM, 0.0, 0.0), (0.0, ARM, 0.0), (0.0, 0.0, ARM))


@dataclass(frozen=True, slots=True)
class Term:
    """One term of a reading: sign * (coordinates of the point in the view)."""

    view: View
    sign: float
    point: Vector


@dataclass(frozen=True, slots=True, eq=False)
class Sensed:
    """A point in a view and along what its deviation counts, sign included, (3, n)."""

    view: View
    point: Vector
    direction: FloatArray


def measuring_frame(run: Run) -> Frame:
    """The frame whose coordinates a reading is made of; for a ball bar the workpiece where a ball is on it."""
    if run.instrument == "ballbar":
        on_tool = "tool" in (run.target.on, run.reference.on)
        on_workpiece = "workpiece" in (run.target.on, run.reference.on)
        return "workpiece" if on_tool and on_workpiece else "bed"
    return run.frame


def run_terms(run: Run) -> tuple[Term, ...]:
    """The views and points whose deviations make up the readings of a run, target first.

    With d the sensed direction, the first-order reading is d . sum(sign * D(view, point)), minus the same at home
    for laser and probe. Of an angle instrument, whose bodies turn, the origins stand for the bodies; `sensed_points`
    has what it reads. Points that rest in the measuring frame contribute nothing and are left out.
    """
    frame = measuring_frame(run)
    if run.instrument == ANGLE:
        run = replace(run, target=PointOn(run.target.on), reference=PointOn(run.reference.on))
    return tuple(
        Term(view_of(end.on, frame), sign, end.point)
        for end, sign in ((run.target, 1.0), (run.reference, -1.0))
        if end.on != frame
    )


def home_positions(run: Run, axes: Sequence[str]) -> FloatArray | None:
    """Where the reading was zeroed, (n_axes, 1), mm or deg; None for a ball bar, whose readings have no zero point."""
    if run.instrument == "ballbar":
        return None
    return np.array([[run.home[axis]] for axis in axes])


def sensed_directions(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    """Unit vectors along which deviations count to first order, (3, n); for a ball bar the ideal bar's direction, for
    an angle instrument the axis of the rotation.

    positions: (n_axes, n), mm or deg.
    """
    if run.direction is not None:
        return np.repeat(column(run.direction), positions.shape[1], axis=1)
    vector = ideal_bar(machine, run, positions)
    size = np.linalg.norm(vector, axis=0)
    return cast(FloatArray, np.divide(vector, size, out=np.zeros_like(vector), where=size > 0.0))


def sensed_points(machine: MeasuredMachine, run: Run, positions: FloatArray) -> list[Sensed]:
    """The points whose deviations make up the readings of a run: each reading is, to first order, the sum of
    direction . D(view, point), minus the same at home where it was zeroed there. positions: (n_axes, n), mm or deg.

    An angle instrument reads the rotation w of a body, its deviation being D(point) = D(origin) + w x (R point). With
    r_i = R e_i and m_i = w x r_i, the sum of r_i x m_i over i = x, y, z is 2 w. So the points are those at ARM along x,
    y and z, against the origin, and n . w = 1/2 sum (n x r_i) . m_i about an axis n; of the exact model this takes the
    skew part of D's derivative by the point times R', the rotation to second order in the errors.
    """
    terms = run_terms(run)
    if run.instrument != ANGLE:
        direction = sensed_directions(machine, run, positions)
        return [Sensed(term.view, term.point, term.sign * direction) for term in terms]
    axis = sensed_directions(machine, run, positions)
    found = []
    for term in terms:
        origin = machine.view_ideal(term.view, positions, column(term.point))
        against = np.zeros_like(origin)
        for point in ARM_POINTS:
            arm = (machine.view_ideal(term.view, positions, column(point)) - origin) / ARM
            direction = 0.5 * term.sign * np.cross(axis, arm, axis=0)
            found.append(Sensed(term.view, point, direction))
            against -= direction
        found.append(Sensed(term.view, term.point, against))
    return found


def ideal_bar(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    """The target ball seen from the reference ball on the error-free machine, (3, n), mm, measuring frame."""
    ends = [_ideal(machine, end, measuring_frame(run), positions) for end in (run.target, run.reference)]
    return ends[0] - ends[1]


def ideal_displacement(machine: MeasuredMachine, run: Run, positions: FloatArray, home: FloatArray) -> FloatArray:
    """Displacement since home of the target seen from the reference, on the error-free machine, (3, n), mm.

    positions: (n_axes, n); home: (n_axes, 1), mm or deg; result in the measuring frame.
    """
    total = np.zeros((3, positions.shape[1]))
    for term in run_terms(run):
        point = column(term.point)
        here, there = (machine.view_ideal(term.view, at, point) for at in (positions, home))
        total += term.sign * (here - there)
    return total


def along_line(moved: FloatArray) -> FloatArray:
    """(n,), mm: the part of displacements since home (3, n) along the line of the motion, towards growing coordinates.

    The line goes through the first and the farthest from it; home need not lie on it, unless there is but one point.
    """
    between = moved - moved[:, :1]
    between = between if between.any() else moved
    farthest = between[:, int(np.linalg.norm(between, axis=0).argmax())]
    size = float(np.linalg.norm(farthest))
    if size == 0.0:
        return np.zeros(moved.shape[1])
    line = farthest / size
    line = line * np.sign(line[int(np.abs(line).argmax())])
    return cast(FloatArray, line @ moved)


def column(point: Vector) -> FloatArray:
    """A point as the (3, 1) array that views take."""
    return np.array(point)[:, np.newaxis]


def _ideal(machine: MeasuredMachine, end: PointOn, frame: Frame, positions: FloatArray) -> FloatArray:
    if end.on == frame:
        return np.repeat(column(end.point), positions.shape[1], axis=1)
    return machine.view_ideal(view_of(end.on, frame), positions, column(end.point))
