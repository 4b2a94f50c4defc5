"""The geometry of a set-up: which line a target moves on, where a ball bar's ball stands and how it is carried."""

from typing import cast

import numpy as np
from scipy.spatial.transform import Rotation

from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_geometry import ideal_displacement, run_terms
from trueaxis.measurement.reading_model import home_positions, measuring_frame, sensed_directions
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.view import view_of

STRAIGHT = 1e-6  # share of a motion that may lie along the sensed direction or beside the line of the motion


def is_straightness(machine: IdentifiedMachine, run: Run, positions: FloatArray) -> bool:
    """Whether the run senses across a motion on a straight line, of the target relative to the reference."""
    if run.instrument != "laser" or run.direction is None:
        return False
    moved = relative_motion(machine, run, positions)
    sizes = np.linalg.svd(moved, compute_uv=False)
    across = float(np.abs(np.array(run.direction) @ moved).max(initial=0.0))
    longest = float(np.linalg.norm(moved, axis=0).max(initial=0.0))
    return bool(longest > 0.0 and across <= STRAIGHT * longest and sizes[1:].max(initial=0.0) <= STRAIGHT * sizes[0])


def relative_motion(machine: IdentifiedMachine, run: Run, positions: FloatArray) -> FloatArray:
    """(3, n): ideal displacement of the target relative to the reference since home, mm, measuring frame."""
    return ideal_displacement(machine, run, positions, cast(FloatArray, home_positions(run, machine.axes)))


def turned_about(machine: IdentifiedMachine, run: Run, positions: FloatArray) -> FloatArray:
    """(3,): unit vector of the axis about which the target turns most against the reference, measuring frame; zero
    where it does not.
    """
    turned = np.zeros((positions.shape[1], 3))
    for term in run_terms(run):
        origin = machine.view_ideal(term.view, positions, np.zeros((3, 1)))
        arms = [machine.view_ideal(term.view, positions, unit[:, np.newaxis]) - origin for unit in np.eye(3)]
        bodies = np.stack(arms, axis=1).transpose(2, 0, 1)
        turned += term.sign * Rotation.from_matrix(bodies @ bodies[0].T).as_rotvec()
    most = turned[int(np.linalg.norm(turned, axis=1).argmax())]
    size = float(np.linalg.norm(most))
    return most / size if size > STRAIGHT else np.zeros(3)


def ball_of(run: Run) -> tuple[float, PointOn]:
    """The ball or sphere whose place was set up, and the sign of its coordinates in a reading: the workpiece's."""
    return (1.0, run.target) if run.target.on == "workpiece" else (-1.0, run.reference)


def tip_of(run: Run) -> PointOn | None:
    """The end of a run that the tool carries: of a probe its tip; None where it carries none."""
    return next((end for end in (run.target, run.reference) if end.on == "tool"), None)


def carried(machine: IdentifiedMachine, run: Run, ball: PointOn, coordinate: int, positions: FloatArray) -> FloatArray:
    """(3, n): a unit vector of the body that carries the ball as the measuring frame sees it."""
    frame, unit = measuring_frame(run), np.zeros((3, 1))
    unit[coordinate] = 1.0
    if ball.on == frame:
        return np.repeat(unit, positions.shape[1], axis=1)
    view = view_of(ball.on, frame)
    return machine.view_ideal(view, positions, unit) - machine.view_ideal(view, positions, np.zeros((3, 1)))


def ball_columns(machine: IdentifiedMachine, run: Run, positions: FloatArray) -> FloatArray:
    """(n, 3): derivative of the readings of a ball-bar run by the place of its ball on the workpiece (or bed)."""
    sign, ball = ball_of(run)
    direction = sensed_directions(machine, run, positions)
    turned = (carried(machine, run, ball, coordinate, positions) for coordinate in range(3))
    return np.stack([sign * np.einsum("in,in->n", direction, one) for one in turned], axis=1)
