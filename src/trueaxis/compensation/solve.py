"""Which commands bring the tool where the program wants it (Eqs. 55 and 56)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import ErrorModel, FloatArray
from trueaxis.compensation.placed import of_points
from trueaxis.compensation.settings import Method

MOST_STEPS = 20
SOLVER_SHARE = 0.01  # of the tolerance: the rounding of the words takes the rest


@dataclass(frozen=True, slots=True, kw_only=True)
class Solution:
    """Commands before they become words.

    commands: (n_axes, n), mm and deg. target: (3, n), tool point wanted, workpiece frame, mm.
    steps: (n,), corrections made. residual: (n,), length of the error left, mm. before: (n,), the same uncorrected.
    converged: (n,); for the ordinary method true wherever the result is finite.
    """

    commands: FloatArray
    target: FloatArray
    steps: NDArray[np.int64]
    residual: FloatArray
    before: FloatArray
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
    commands = begin.copy()
    error = target - _actual(commands, model, tool_point)
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
    return Solution(commands=commands, target=target, steps=steps, residual=best, before=before, converged=converged)


def _actual(positions: FloatArray, model: ErrorModel, tool_point: FloatArray) -> FloatArray:
    return model.ideal(positions, tool_point) + model.deviation(positions, tool_point)


def _norm(vectors: FloatArray) -> FloatArray:
    return np.asarray(np.sqrt(np.einsum("in,in->n", vectors, vectors)))
