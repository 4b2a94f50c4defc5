"""Where the tool axis points, and which turns of the rotary axes put it right.

The tool axis has two degrees of freedom; its turn about itself is of no concern. Per pose the turns follow by
Gauss-Newton from J = dn/dr, n the error-free tool axis in the workpiece frame and r the rotary positions (rad). Where
the tool axis comes near the line of a rotary axis (C with B = 0 on a fork head), J loses rank: there an axis would have
to turn far for little. Along directions v_i of r whose singular values s_i of J are below `SINGULAR`, turns from the
programmed position are weighted:

    minimise  |n_wanted - n|^2 + sum_i max(SINGULAR^2 - s_i^2, 0) (v_i . (r - r_programmed))^2,

so that the turn per error, 1 / s_i elsewhere, grows no further than 1 / SINGULAR and falls to 0 with s_i, without a
jump on the way. With s_i = 0 this is the truncated pseudo-inverse.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensate.machine import ErrorModel, FloatArray, rotary_rows

SINGULAR = 0.01  # sine of the angle, 0.57 deg, between tool axis and rotary axis: an error of 50 urad turns it 0.3 deg


class Turns(NamedTuple):
    """moves: (n_axes, n), deg, linear rows 0. reach: (n,), how far they turn the tool axis, rad. singular: (n,), true
    where one direction of the tool axis that the machine has elsewhere is lost.
    """

    moves: FloatArray
    reach: FloatArray
    singular: NDArray[np.bool_]


class ToolAxis:
    """The tool axis of a machine; `direction` is a vector of the tool frame."""

    def __init__(self, model: ErrorModel, direction: tuple[float, float, float]) -> None:
        self._model = model
        self._direction = unit(np.array(direction, dtype=np.float64)[:, None])
        self._rows = list(rotary_rows(model.axes))

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

    def turn(self, positions: FloatArray, programmed: FloatArray, error: FloatArray) -> Turns:
        """One Gauss-Newton step at `positions`; error: (3, n), wanted minus actual unit vector."""
        jacobian = self.jacobian(positions)
        normal = np.einsum("iaq,ibq->qab", jacobian, jacobian)
        square, basis = np.linalg.eigh(np.nan_to_num(normal))  # of the singular values, ascending
        weight = np.maximum(SINGULAR**2 - square, 0.0)
        away = np.radians(positions[self._rows] - programmed[self._rows])
        pull = np.einsum("qam,iaq,iq->qm", basis, jacobian, error) - weight * np.einsum("qam,aq->qm", basis, away)
        by_axis = np.einsum("qam,qm->aq", basis, pull / np.maximum(square, SINGULAR**2))
        moves = np.zeros_like(positions)
        moves[self._rows] = np.degrees(by_axis)
        reach = np.sqrt((np.einsum("iaq,aq->iq", jacobian, by_axis) ** 2).sum(axis=0))
        useful = min(len(self._rows), 2)
        return Turns(moves, reach, square[:, -useful] < SINGULAR**2)


def unit(vectors: FloatArray) -> FloatArray:
    """Vectors (3, n) made unit vectors."""
    return np.asarray(vectors / np.sqrt(np.einsum("in,in->n", vectors, vectors)))


def angle(first: FloatArray, second: FloatArray) -> FloatArray:
    """Angles between unit vectors (3, n), rad, (n,); exact for the smallest."""
    apart, sum_ = first - second, first + second
    return np.asarray(
        2.0 * np.arctan2(np.sqrt(np.einsum("in,in->n", apart, apart)), np.sqrt(np.einsum("in,in->n", sum_, sum_)))
    )
