"""One point at which a gauge shows, before first use, whether the sign of the error values is right."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensate.held import Held
from trueaxis.compensate.machine import LINEAR, ErrorModel, FloatArray, linear_jacobian, linear_rows
from trueaxis.compensate.path import Path


@dataclass(frozen=True, slots=True)
class SignCheck:
    """line: of the block. position: programmed axis positions, mm and deg. direction: X, Y or Z of the workpiece frame.

    deviation: of the tool point there in that direction, actual minus ideal, mm, uncompensated, and since_home: the
    same minus the deviation at `home`, axis positions where a gauge is set to zero. axis, command: the linear axis that
    moves the tool most in that direction, and its compensated command; sense: 1 where a positive command moves the tool
    towards the positive direction of the workpiece frame, -1 where it moves it the other way.
    """

    line: int
    position: dict[str, float]
    home: dict[str, float]
    direction: str
    deviation: float
    since_home: float
    axis: str
    command: float
    sense: int

    def __str__(self) -> str:
        at, home = (
            " ".join(f"{axis}{value + 0.0:.9g}" for axis, value in p.items()) for p in (self.position, self.home)
        )
        against = "" if self.sense > 0 else f" (which is where {self.axis}- commands move it)"
        return (
            f"sign check before first use: at {at} (line {self.line}) the error values displace the tool point by "
            f"d{self.direction} = {self.deviation:+.4f} mm in the workpiece frame.\n"
            f"  Without compensation, a gauge or laser between table and tool along {self.direction} that is zero at "
            f"{home} must show {self.since_home:+.4f} mm there:\n"
            f"  + where the tool stands too far towards {self.direction}+ of the workpiece{against}. "
            f"The compensated program commands {self.axis}{self.command:.9g}, "
            f"{self.command - self.position[self.axis]:+.4f} mm.\n"
            "  If the gauge moves the other way, the error values have the wrong sign: do not run the program."
        )


class SignChecker:
    """Keeps the programmed point at which the deviation since home is largest in one direction, if above `least` mm."""

    def __init__(self, model: ErrorModel, tool_point: FloatArray, least: float) -> None:
        self._model, self._tool_point = model, tool_point
        low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T
        self._home = np.clip(np.zeros(len(model.axes)), low, high)
        self._at_home = model.deviation(self._home[:, None], tool_point)
        self._largest = least
        self.found: SignCheck | None = None

    def add(
        self, path: Path, deviation: FloatArray, commands: FloatArray, lines: NDArray[np.int64], held: Held
    ) -> None:
        """Look at points: deviation (3, n) at the programmed positions, commands (n_axes, n) as written."""
        since = np.where(held.any(axis=0), 0.0, np.nan_to_num(deviation - self._at_home))
        direction, point = np.unravel_index(np.argmax(np.abs(since)), since.shape)
        if not abs(since[direction, point]) > self._largest:
            return
        self._largest = float(abs(since[direction, point]))
        axes, at = self._model.axes, path.points[:, point]
        moves = linear_jacobian(self._model, at[:, None], self._tool_point)[direction, :, 0]
        main = int(np.argmax(np.abs(moves)))
        row = linear_rows(axes)[main]
        self.found = SignCheck(
            int(lines[point]),
            dict(zip(axes, at.tolist(), strict=True)),
            dict(zip(axes, self._home.tolist(), strict=True)),
            LINEAR[direction],
            float(deviation[direction, point]),
            float(since[direction, point]),
            axes[row],
            float(commands[row, point]),
            1 if moves[main] > 0.0 else -1,
        )
