"""Which commands bring the tool where the program wants it (Eqs. 55 and 56), its axis too where rotary axes turn."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.course import of_points
from trueaxis.compensation.machine import ErrorModel, FloatArray, rotary_rows
from trueaxis.compensation.settings import Method

SINGULAR = 0.01  # sine of the angle, 0.57 deg, between tool axis and rotary axis: an error of 50 urad turns it 0.3 deg


@dataclass(frozen=True, slots=True, kw_only=True)
class Turning:
    """How turns of the rotary axes from programmed positions move the error-free tool axis.

    programmed: (n_axes, n), mm and deg. rows: of the rotary axes. jacobian: (3, n_rotary, n), see ToolAxis. square:
    (n, n_rotary), squares of its singular values, ascending, with basis (n, n_rotary, n_rotary), directions in columns.
    """

    programmed: FloatArray
    rows: list[int]
    jacobian: FloatArray
    square: FloatArray
    basis: FloatArray

    @property
    def singular(self) -> NDArray[np.bool_]:
        """(n,): where one direction of the tool axis that the machine has elsewhere is lost."""
        useful = min(len(self.rows), 2)
        return np.asarray(self.square[:, -useful] < SINGULAR**2)

    def at(self, index: NDArray[np.int64]) -> "Turning":
        """The same for some of the points."""
        return Turning(
            programmed=self.programmed[:, index],
            rows=self.rows,
            jacobian=self.jacobian[:, :, index],
            square=self.square[index],
            basis=self.basis[index],
        )

    def step(self, positions: FloatArray, error: FloatArray) -> tuple[FloatArray, FloatArray]:
        """One Gauss-Newton step from `positions`; error: (3, n), wanted minus actual unit vector.

        Returns moves of all axes, (n_axes, n), deg, linear rows 0, and how far they turn the tool axis, rad, (n,).
        """
        weight = np.maximum(SINGULAR**2 - self.square, 0.0)
        away = np.radians(positions[self.rows] - self.programmed[self.rows])
        slope = np.einsum("iaq,iq->aq", self.jacobian, error)
        pull = np.einsum("qam,aq->qm", self.basis, slope) - weight * np.einsum("qam,aq->qm", self.basis, away)
        by_axis = np.einsum("qam,qm->aq", self.basis, pull / np.maximum(self.square, SINGULAR**2))
        moves = np.zeros_like(positions)
        moves[self.rows] = np.degrees(by_axis)
        reach = np.sqrt((np.einsum("iaq,aq->iq", self.jacobian, by_axis) ** 2).sum(axis=0))
        return moves, reach


class ToolAxis:
    """The tool axis of a machine; `direction` is a vector of the tool frame."""

    def __init__(self, model: ErrorModel, direction: tuple[float, float, float]) -> None:
        self._model, self.direction = model, direction
        self._direction = unit(np.array(direction, dtype=np.float64)[:, None])
        self._rows = list(rotary_rows(model.axes))

    def on(self, model: ErrorModel) -> "ToolAxis":
        """The same tool axis on another machine, or on this one at some places."""
        return ToolAxis(model, self.direction)

    @property
    def turns(self) -> bool:
        """Whether the machine has rotary axes."""
        return bool(self._rows)

    def wanted(self, programmed: FloatArray) -> FloatArray:
        """Unit vectors (3, n) in the workpiece frame of the error-free machine."""
        return self._model.orientation_ideal(programmed, self._direction)

    def actual(self, positions: FloatArray) -> FloatArray:
        """Unit vectors (3, n) in the workpiece frame of the machine as it is."""
        ideal = self._model.orientation_ideal(positions, self._direction)
        return unit(ideal + self._model.orientation_deviation(positions, self._direction))

    def jacobian(self, positions: FloatArray) -> FloatArray:
        """Motion of the error-free tool axis per rad of each rotary axis, (3, n_rotary, n).

        The tool axis is a + b cos r + c sin r in every rotary position r, so that half the difference over +-90 deg is
        the derivative without truncation.
        """
        columns = []
        for row in self._rows:
            ahead, behind = positions.copy(), positions.copy()
            ahead[row] += 90.0
            behind[row] -= 90.0
            columns.append(0.5 * (self.wanted(ahead) - self.wanted(behind)))
        return np.stack(columns, axis=1)

    def turning(self, programmed: FloatArray) -> Turning:
        """Turns from programmed positions (n_axes, n); the corrections are small enough for one Jacobian to do."""
        jacobian = self.jacobian(programmed)
        square, basis = np.linalg.eigh(np.nan_to_num(np.einsum("iaq,ibq->qab", jacobian, jacobian)))
        return Turning(programmed=programmed, rows=self._rows, jacobian=jacobian, square=square, basis=basis)


def unit(vectors: FloatArray) -> FloatArray:
    """Vectors (3, n) made unit vectors."""
    return np.asarray(vectors / np.sqrt(np.einsum("in,in->n", vectors, vectors)))


def angle(first: FloatArray, second: FloatArray) -> FloatArray:
    """Angles between unit vectors (3, n), rad, (n,); exact for the smallest."""
    apart, sum_ = first - second, first + second
    return np.asarray(
        2.0 * np.arctan2(np.sqrt(np.einsum("in,in->n", apart, apart)), np.sqrt(np.einsum("in,in->n", sum_, sum_)))
    )


MOST_STEPS = 20
SOLVER_SHARE = 0.01  # of the tolerance: the rounding of the words takes the rest


@dataclass(frozen=True, slots=True, kw_only=True)
class Solution:
    """Commands before they become words.

    commands: (n_axes, n), mm and deg. target: (3, n), tool point wanted, workpiece frame, mm.
    steps: (n,), corrections made. left: (3, n), error left, actual minus wanted, mm, None where the commands have been
    changed since; residual: (n,), its length; before: (n,), the same uncorrected. deviation: (3, n), mm, of the
    programmed positions, None where it did not begin there. converged: (n,); for the ordinary method true wherever the
    result is finite.
    """

    commands: FloatArray
    target: FloatArray
    steps: NDArray[np.int64]
    left: FloatArray | None
    residual: FloatArray
    before: FloatArray
    deviation: FloatArray | None
    converged: NDArray[np.bool_]


def solve(
    programmed: FloatArray,
    begin: FloatArray,
    model: ErrorModel,
    tool_point: FloatArray,
    tolerance: float,
    method: Method = "iterative",
) -> Solution:
    """Commands whose actual tool point is the error-free one at the programmed positions.

    programmed: (n_axes, n). begin: (n_axes, n), where to begin, rotary positions as they will be written; only linear
    axes are corrected here, and for the rounding of rotary words too.
    `iterative`: command += correction(target - actual(command)), actual = Psi of Eq. (55), until the error left is
    within `SOLVER_SHARE` of the tolerance (mm) or `MOST_STEPS` are made; a step that does not improve a point is its
    last and the best command is kept. `ordinary`: one step.
    """
    target = model.ideal(programmed, tool_point)
    commands, begins_there = begin.copy(), np.array_equal(begin, programmed)
    ideal = target if begins_there else model.ideal(begin, tool_point)
    error = target - (ideal + model.deviation(begin, tool_point))
    deviation = -error if begins_there else None
    before = _norm(error)
    best = before.copy()
    steps = np.zeros(before.size, dtype=np.int64)
    goal = SOLVER_SHARE * tolerance
    active = np.isfinite(before) & ((best > goal) if method == "iterative" else True)
    for _ in range(MOST_STEPS if method == "iterative" else 1):
        index = np.flatnonzero(active)
        if index.size == 0:
            break
        part = slice(None) if index.size == active.size else index
        here = of_points(model, part)
        tried = commands[:, part] + here.correction(commands[:, part], error[:, part])
        left = target[:, part] - _actual(tried, here, tool_point)
        length = _norm(left)
        better = np.isfinite(length) & ((length < best[part]) | (method == "ordinary"))
        if better.size == active.size and better.all():
            commands, error, best = tried, left, length
            steps += 1
        else:
            kept = index[better]
            commands[:, kept] = tried[:, better]
            error[:, kept] = left[:, better]
            best[kept] = length[better]
            steps[kept] += 1
        active[index] = better & (length > goal)
    converged = np.isfinite(best) & ((best <= goal) | (method == "ordinary"))
    return Solution(
        commands=commands, target=target, steps=steps, left=-error, residual=best, before=before,
        deviation=deviation, converged=converged,
    )  # fmt: skip


def _actual(positions: FloatArray, model: ErrorModel, tool_point: FloatArray) -> FloatArray:
    return model.ideal(positions, tool_point) + model.deviation(positions, tool_point)


def _norm(vectors: FloatArray) -> FloatArray:
    return np.asarray(np.sqrt(np.einsum("in,in->n", vectors, vectors)))


@dataclass(frozen=True, slots=True)
class PoseSolution:
    """Commands (n_axes, n) before they become words, mm and deg; steps (n,), corrections made; converged (n,);
    singular (n,), see Turning.
    """

    commands: FloatArray
    steps: NDArray[np.int64]
    converged: NDArray[np.bool_]
    singular: NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class Solved:
    """linear: for rotary positions as their words name them; pose: before they are words, where they turn too."""

    linear: Solution
    pose: PoseSolution | None

    @property
    def commands(self) -> FloatArray:
        """Commands (n_axes, n), words not rounded."""
        return self.linear.commands if self.pose is None else self.pose.commands

    @property
    def steps(self) -> NDArray[np.int64]:
        """Corrections made, (n,)."""
        return self.linear.steps if self.pose is None else self.pose.steps

    @property
    def converged(self) -> NDArray[np.bool_]:
        """(n,)."""
        return self.linear.converged if self.pose is None else self.linear.converged & self.pose.converged


@dataclass(slots=True)
class _State:
    """A command and what is left to correct there: point (3, n), mm; turn (n_axes, n), deg; merit (n,), at most 1 when
    both are within their goals.
    """

    commands: FloatArray
    turn: FloatArray
    merit: FloatArray


def solve_pose(
    programmed: FloatArray,
    model: ErrorModel,
    tool_point: FloatArray,
    tool_axis: ToolAxis,
    tolerance: float,
    orientation_tolerance: float,
    method: Method = "iterative",
) -> PoseSolution:
    """Commands whose actual tool point and tool axis are the error-free ones at the programmed positions.

    programmed: (n_axes, n); tolerance mm; orientation_tolerance rad. A correction turns the rotary axes by one
    Gauss-Newton step and then moves the linear axes by Eq. (55) at the new rotary positions. It is repeated until the
    tool point is within `SOLVER_SHARE` of its tolerance and a further turn would be within the same share of its own;
    what no turn can mend at a singular pose does not count. A correction that does not improve a point is its last.
    """
    target, wanted = model.ideal(programmed, tool_point), tool_axis.wanted(programmed)
    turning = tool_axis.turning(programmed)
    goal, turn_goal = SOLVER_SHARE * tolerance, SOLVER_SHARE * orientation_tolerance

    def state(commands: FloatArray, index: NDArray[np.int64]) -> _State:
        pointing = tool_axis.on(of_points(model, index)).actual(commands)
        turn, reach = turning.at(index).step(commands, wanted[:, index] - pointing)
        off = np.sqrt((_left(commands, index) ** 2).sum(axis=0))
        return _State(commands, turn, np.maximum(off / goal, reach / turn_goal))

    def _left(commands: FloatArray, index: NDArray[np.int64]) -> FloatArray:
        actual = model.ideal(commands, tool_point) + of_points(model, index).deviation(commands, tool_point)
        return np.asarray(target[:, index] - actual)

    now = state(programmed.copy(), np.arange(programmed.shape[1]))
    steps = np.zeros(now.merit.size, dtype=np.int64)
    active = np.isfinite(now.merit) & ((now.merit > 1.0) | (method == "ordinary"))
    for _ in range(MOST_STEPS if method == "iterative" else 1):
        index = np.flatnonzero(active)
        if index.size == 0:
            break
        tried = now.commands[:, index] + now.turn[:, index]
        tried += model.correction(tried, _left(tried, index))
        then = state(tried, index)
        better = np.isfinite(then.merit) & ((then.merit < now.merit[index]) | (method == "ordinary"))
        kept = index[better]
        now.commands[:, kept], now.turn[:, kept] = tried[:, better], then.turn[:, better]
        now.merit[kept] = then.merit[better]
        steps[kept] += 1
        active[index] = better & (then.merit > 1.0)
    converged = np.isfinite(now.merit) & ((now.merit <= 1.0) | (method == "ordinary"))
    return PoseSolution(now.commands, steps, converged, turning.singular)
