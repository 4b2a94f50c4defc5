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

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import ErrorModel, FloatArray, rotary_rows

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
