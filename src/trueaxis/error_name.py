"""Names of errors (ISO 230-1, ISO 230-7): a direction and an axis. No other module takes a name apart."""

import re
from typing import Self

_ABOUT = {"A": "X", "B": "Y", "C": "Z"}  # a letter of a rotation, or of a rotary axis: the line it turns about
_NAME = re.compile(r"E[XYZABC]0?[XYZABC]")


def line_of(axis: str) -> str:
    """X, Y or Z: along which an axis moves, or about which it turns."""
    return _ABOUT.get(axis, axis)


class Direction(str):
    """EX, EY, EZ: a displacement along X, Y, Z; EA, EB, EC: a rotation about them."""

    __slots__ = ()

    @property
    def letter(self) -> str:
        """X .. C."""
        return self[1]

    @property
    def line(self) -> str:
        """X, Y or Z: along which it displaces, or about which it turns."""
        return line_of(self.letter)

    @property
    def is_rotation(self) -> bool:
        """Whether it turns."""
        return self.letter in _ABOUT

    @property
    def unit(self) -> str:
        """`mm` or `rad`."""
        return "rad" if self.is_rotation else "mm"

    def motion_error(self, axis: str) -> "ErrorName":
        """The component error of an axis in this direction: EXY of EX and Y."""
        return ErrorName(f"{self}{axis}")

    def location_error(self, axis: str) -> "ErrorName":
        """The location error of an axis in this direction: EC0Y of EC and Y."""
        return ErrorName(f"{self}0{axis}")


DIRECTIONS = tuple(Direction(f"E{letter}") for letter in "XYZABC")
DISPLACEMENTS, ROTATIONS = DIRECTIONS[:3], DIRECTIONS[3:]


def rotation_about(line: str) -> Direction:
    """EA, EB or EC: the rotation about X, Y or Z, or about the line of a rotary axis."""
    return next(turn for turn in ROTATIONS if turn.line == _ABOUT.get(line, line))


def positioning_error(axis: str) -> "ErrorName":
    """The component error of an axis along its own motion: EXX of X, ECC of C."""
    return ErrorName(f"E{axis}{axis}")


class ErrorName(str):
    """A component error such as EXY, or a location error such as EC0Y. It is the text, as in files and as a key.

    Raises ValueError for a text that is no such name.
    """

    __slots__ = ()

    def __new__(cls, text: str) -> Self:
        """See the class."""
        if not _NAME.fullmatch(text):
            raise ValueError(f"{text!r} is no name of an error")
        return super().__new__(cls, text)

    @classmethod
    def parse(cls, text: str) -> Self | None:
        """The name that a text of a file says; None where it says none."""
        return cls(text) if _NAME.fullmatch(text) else None

    @property
    def direction(self) -> Direction:
        """EX .. EC: in which direction the axis errs."""
        return Direction(self[:2])

    @property
    def axis(self) -> str:
        """The axis that errs, X .. C."""
        return self[-1]

    @property
    def subscript(self) -> str:
        """What follows the E: `C0Y`."""
        return self[1:]

    @property
    def is_location(self) -> bool:
        """Whether it is an error of where the axis lies, not of its motion."""
        return self[2] == "0"

    @property
    def is_rotation(self) -> bool:
        """Whether it is an angle."""
        return self.direction.is_rotation

    @property
    def is_of_linear_axis(self) -> bool:
        """Whether the axis is X, Y or Z."""
        return self.axis not in _ABOUT

    @property
    def is_positioning(self) -> bool:
        """Whether it is along the motion of its axis: EXX of a linear axis, ECC of a rotary one."""
        return self.direction.letter == self.axis

    @property
    def is_straightness(self) -> bool:
        """Whether it is a displacement of a linear axis across its motion."""
        return self.is_of_linear_axis and not self.is_rotation and not self.is_positioning

    @property
    def unit(self) -> str:
        """`mm` or `rad`."""
        return self.direction.unit

    @property
    def axis_unit(self) -> str:
        """`mm` or `deg`: of positions of the axis."""
        return "mm" if self.is_of_linear_axis else "deg"

    @property
    def slope_unit(self) -> str:
        """`mm/mm`, `rad/deg` and the like."""
        return f"{self.unit}/{self.axis_unit}"
