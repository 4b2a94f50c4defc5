"""Which commands bring tool point and tool axis where the program wants them: Eq. (55) for all axes."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import ErrorModel, FloatArray
from trueaxis.compensation.orientation import ToolAxis
from trueaxis.compensation.placed import of_points
from trueaxis.compensation.settings import Method
from trueaxis.compensation.solve import MOST_STEPS, SOLVER_SHARE


@dataclass(frozen=True, slots=True)
class PoseSolution:
    """Commands (n_axes, n) before they become words, mm and deg; steps (n,), corrections made; converged (n,);
    singular (n,), see Turning.
    """

    commands: FloatArray
    steps: NDArray[np.int64]
    converged: NDArray[np.bool_]
    singular: NDArray[np.bool_]


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
