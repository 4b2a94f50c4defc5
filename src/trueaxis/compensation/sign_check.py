"""What shows, before first use, whether the signs of the machine's axes and of the error values are right."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import LINEAR, ErrorModel, FloatArray, linear_jacobian, linear_rows, rotary_rows
from trueaxis.compensation.path import Held, Path


@dataclass(frozen=True, slots=True, kw_only=True)
class SignCheck:
    """One point at which a gauge shows whether the sign of the error values is right.

    line: of the block. position: programmed axis positions, mm and deg. direction: X, Y or Z of the workpiece frame.

    deviation: of the tool point there in that direction, actual minus ideal, mm, uncompensated; at_home: the same at
    `home`, axis positions where a gauge is set to zero; since_home: the difference, which the gauge shows. axis,
    command: the linear axis that moves the tool most in that direction, and its compensated command. correction: how
    far all compensated commands together move the error-free tool point in that direction, mm. datum: of it, what goes
    along with the datum of a work offset that was touched off, mm.
    """

    line: int
    position: dict[str, float]
    home: dict[str, float]
    direction: str
    deviation: float
    at_home: float
    since_home: float
    axis: str
    command: float
    correction: float
    datum: float = 0.0

    @property
    def compensated(self) -> float:
        """What the gauge, set to zero at home without compensation, shows with the compensated program, mm."""
        return self.since_home + self.correction


@dataclass(frozen=True, slots=True)
class Senses:
    """Where the model takes a positive command of each linear axis to move the tool.

    towards: direction in the workpiece frame of each axis, as `Y-`. rotary: positions of the rotary axes, deg, at which
    that holds. about: the direction in the workpiece frame about which each rotary axis turns the tool, right-handed.
    """

    towards: dict[str, str]
    rotary: dict[str, float]
    about: dict[str, str]


_TURN = 0.1  # deg, either way


def turned_about(model: ErrorModel, home: FloatArray) -> dict[str, str]:
    """The direction in the workpiece frame about which each rotary axis turns the tool there; home: (n_axes,)."""
    found = {}
    for row in rotary_rows(model.axes):
        turn = np.zeros((home.size, 1))
        turn[row] = _TURN
        back, forth = (
            np.hstack([model.orientation_ideal(home[:, None] + way * turn, unit[:, None]) for unit in np.eye(3)])
            for way in (-1.0, 1.0)
        )
        rotation = forth @ back.T
        vector = np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0],
                           rotation[1, 0] - rotation[0, 1]])  # fmt: skip
        main = int(np.argmax(np.abs(vector)))
        if abs(vector[main]) > np.radians(_TURN):  # else tool and workpiece turn together
            found[model.axes[row]] = LINEAR[main] + ("+" if vector[main] > 0.0 else "-")
    return found


def senses_of(model: ErrorModel, tool_point: FloatArray) -> Senses:
    """Which way each linear axis moves the tool at home, and each rotary one turns it; tool_point: (3, 1), mm."""
    home = home_of(model)
    moves = linear_jacobian(model, home[:, None], tool_point)[:, :, 0]
    towards = {}
    for column, row in enumerate(linear_rows(model.axes)):
        main = int(np.argmax(np.abs(moves[:, column])))
        towards[model.axes[row]] = LINEAR[main] + ("+" if moves[main, column] > 0.0 else "-")
    at = zip(model.axes, home.tolist(), strict=True)
    rotary = {axis: value for axis, value in at if axis not in LINEAR}
    return Senses(towards, rotary, turned_about(model, home))


def home_of(model: ErrorModel) -> FloatArray:
    """Axis positions (n_axes,), mm and deg, nearest to 0 within the travel."""
    low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T
    return np.asarray(np.clip(np.zeros(len(model.axes)), low, high))


@dataclass(frozen=True, slots=True, kw_only=True)
class KinematicsCheck:
    """Where the axes stand at the end of a block under tool centre point control if the control's kinematics are those
    of the spec. line: of the block. position: of the axes, mm and deg, as programmed. turned: how far the turns of
    rotary axes have moved the linear ones, mm.
    """

    line: int
    position: dict[str, float]
    turned: float


class KinematicsChecker:
    """Keeps the programmed point at which turned rotary axes move the linear ones farthest."""

    def __init__(self, axes: tuple[str, ...]) -> None:
        self._axes, self._linear = axes, list(linear_rows(axes))
        self.found: KinematicsCheck | None = None

    def add(self, tips: FloatArray, points: FloatArray, lines: NDArray[np.int64], left_out: Held) -> None:
        """Look at positions of the tip and where the axes stand there, each (n_axes, n); left_out: (n,), points where
        that is not known.
        """
        turned = np.sqrt(((points - tips)[self._linear] ** 2).sum(axis=0)) * ~left_out
        most = int(np.argmax(turned))
        if turned[most] > max(_SHOWS, 0.0 if self.found is None else self.found.turned):
            position = dict(zip(self._axes, points[:, most].tolist(), strict=True))
            self.found = KinematicsCheck(line=int(lines[most]), position=position, turned=float(turned[most]))


_SHOWS = 1.0  # mm: less is hardly told from the corrections themselves
# mm: what a gauge shows clearly where the table is not turned; a gauge along a turned one is hard to set
_CLEAR = 0.005


class SignChecker:
    """Keeps the programmed point at which the deviation since home is largest in one direction, if above `least` mm."""

    def __init__(self, model: ErrorModel, tool_point: FloatArray, least: float) -> None:
        self._model, self._tool_point = model, tool_point
        self._home = home_of(model)
        self._at_home = model.deviation(self._home[:, None], tool_point)
        self._rotary = list(rotary_rows(model.axes))
        # at ends of feed motions with rotary axes at home; of any; within them; at ends of rapids
        self._largest = [max(least, _CLEAR), least, least, least]
        self.found: SignCheck | None = None

    def use(self, tool_point: FloatArray) -> None:
        """Another tool point from here on, (3, 1), mm."""
        self._tool_point = tool_point
        self._at_home = self._model.deviation(self._home[:, None], tool_point)

    def add(
        self, path: Path, deviation: FloatArray, commands: FloatArray, lines: NDArray[np.int64], left_out: Held,
        datum: FloatArray,
    ) -> None:  # fmt: skip
        """Look at points: deviation (3, n) at the programmed positions, commands (n_axes, n) as written; left_out:
        (n,), points whose commands are not those of the compensation alone; datum: (3, 1), what corrections count from.

        Feed motions come first, where the part is cut, and of them the ends, whose words are in the program: those with
        rotary axes at home, where a gauge shows enough there.
        """
        since = np.where(left_out, 0.0, np.abs(np.nan_to_num(deviation - self._at_home)))
        if since.max() <= min(self._largest):
            return
        ends = np.diff(path.owner, append=-1) != 0
        at_home = (path.points == self._home[:, np.newaxis])[self._rotary].all(axis=0)
        fed = ~path.rapid & ends
        for rank, mine in enumerate((fed & at_home, fed, ~path.rapid, path.rapid)):
            direction, point = np.unravel_index(np.argmax(since * mine), since.shape)
            size = float((since * mine)[direction, point])
            if size > self._largest[rank]:
                self._largest[rank:] = [size] + [np.inf] * (len(self._largest) - rank - 1)
                self._note(path, deviation, commands, lines, (int(direction), int(point)), datum)

    def _note(
        self, path: Path, deviation: FloatArray, commands: FloatArray, lines: NDArray[np.int64],
        place: tuple[int, int], datum: FloatArray,
    ) -> None:  # fmt: skip
        direction, point = place
        axes, at, written = self._model.axes, path.points[:, [point]], commands[:, [point]]
        moves = linear_jacobian(self._model, at, self._tool_point)[direction, :, 0]
        row = linear_rows(axes)[int(np.argmax(np.abs(moves)))]
        moved = self._model.ideal(written, self._tool_point) - self._model.ideal(at, self._tool_point)
        self.found = SignCheck(
            line=int(lines[point]),
            position=dict(zip(axes, at[:, 0].tolist(), strict=True)),
            home=dict(zip(axes, self._home.tolist(), strict=True)),
            direction=LINEAR[direction],
            deviation=float(deviation[direction, point]),
            at_home=float(self._at_home[direction, 0]),
            since_home=float(deviation[direction, point] - self._at_home[direction, 0]),
            axis=axes[row],
            command=float(written[row, 0]),
            correction=float(moved[direction, 0]),
            datum=float(datum[direction, 0]),
        )
