"""A machine as a tree of rigid bodies: what its spec says, and nothing of its errors."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Flags = NDArray[np.bool_]

LETTERS = "XYZABC"
LINEAR = "XYZ"
BED = 1


@dataclass(frozen=True)
class Body:
    """A body on its lower body.

    moves: axis letter, or "" where it is fixed; travel: mm or deg; offset: its position in the lower body's frame, mm;
    names: the parameters that hold the offset, or () where the spec has the numbers; motion: its component errors;
    located: (direction such as EC, name of the location error).
    """

    number: int
    lower: int
    name: str
    moves: str = ""
    sense: int = 1
    travel: tuple[float, float] = (0.0, 0.0)
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0)
    names: tuple[str, ...] = ()
    motion: tuple[str, ...] = ()
    located: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Machine:
    """bodies: a lower body before those on it; workpiece, tool: numbers of the end bodies; structure: for people;
    true_rotations: errors turn by rotation vectors, else by the matrix 1 + [eps x] of the paper.
    """

    name: str
    bodies: tuple[Body, ...]
    workpiece: int
    tool: int
    structure: str
    true_rotations: bool = False

    @cached_property
    def axes(self) -> tuple[str, ...]:
        """In the order X Y Z A B C."""
        return tuple(letter for letter in LETTERS if any(body.moves == letter for body in self.bodies))

    @property
    def linear(self) -> tuple[str, ...]:
        return tuple(axis for axis in self.axes if axis in LINEAR)

    @property
    def rotary(self) -> tuple[str, ...]:
        return tuple(axis for axis in self.axes if axis not in LINEAR)

    @cached_property
    def components(self) -> tuple[str, ...]:
        """Component errors, axis by axis."""
        return tuple(name for axis in self.axes for name in self.body_of(axis).motion)

    @cached_property
    def locations(self) -> Mapping[str, str]:
        """Name of each location error -> its direction, such as EC."""
        return {name: direction for body in self.bodies for direction, name in body.located}

    @cached_property
    def dimensions(self) -> Mapping[str, float]:
        """Values of the named offsets, mm."""
        return {n: v for body in self.bodies if body.names for n, v in zip(body.names, body.offset, strict=True)}

    def body_of(self, axis: str) -> Body:
        return next(body for body in self.bodies if body.moves == axis)

    def travel(self, axis: str) -> tuple[float, float]:
        return self.body_of(axis).travel

    def home(self, axis: str) -> float:
        """0, or the end of the travel next to it."""
        low, high = self.travel(axis)
        return min(max(0.0, low), high)

    def share(self, axis: str, position: Array) -> Array:
        """Position as a share of the travel."""
        low, high = self.travel(axis)
        return (np.asarray(position, float) - low) / (high - low)

    def branch(self, end: str) -> tuple[Body, ...]:
        """Bodies from the bed outwards to an end (bed, workpiece or tool)."""
        number = {"bed": BED, "workpiece": self.workpiece, "tool": self.tool}[end]
        found: list[Body] = []
        while number != BED:
            found.append(next(body for body in self.bodies if body.number == number))
            number = found[-1].lower
        return tuple(reversed(found))

    def carries(self, end: str, axis: str) -> bool:
        """Whether an axis moves that end."""
        return any(body.moves == axis for body in self.branch(end))
