"""What is known of the tools of a program."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from trueaxis.compensation.machine import LINEAR, ErrorModel, FloatArray


@dataclass(frozen=True, slots=True)
class Tool:
    """length: what G43 adds to Z, from the point that --tool-point names to the tip; offset: further X Y Z, as in a
    tool table of LinuxCNC. point: the point to be compensated, tool frame; None: what follows from both. mm.
    """

    length: float = 0.0
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0)
    point: tuple[float, float, float] | None = None

    @property
    def shift(self) -> tuple[float, float, float]:
        """What is added to X Y Z of the program."""
        x, y, z = self.offset
        return (x, y, z + self.length)


@dataclass(frozen=True, slots=True)
class ToolTable:
    """Tools by number."""

    tools: Mapping[int, Tool] = field(default_factory=dict)


def tool_point_of(model: ErrorModel, tool: Tool | None, otherwise: FloatArray) -> FloatArray:
    """The point of a tool that is compensated, (3, 1), mm, tool frame; otherwise: that without a tool.

    With what G43 adds, the axes bring this point where they would bring the other one without: at home, where all
    frames are parallel, it lies back by as much as the axes then move the tool.
    """
    if tool is None:
        return otherwise
    if tool.point is not None:
        return np.array(tool.point, dtype=np.float64)[:, np.newaxis]
    home = np.zeros((len(model.axes), 1))
    moved = home.copy()
    for row, axis in enumerate(model.axes):
        if axis in LINEAR:
            moved[row] = tool.shift[LINEAR.index(axis)]
    return np.asarray(otherwise - (model.ideal(moved, otherwise) - model.ideal(home, otherwise)))


@dataclass(frozen=True, slots=True)
class ToolUse:
    """A tool of a program and the point that was compensated, tool frame, mm."""

    number: int
    tool_point: tuple[float, float, float]

    def __str__(self) -> str:
        x, y, z = (value + 0.0 for value in self.tool_point)
        return f"tool {self.number}: the point {x:.9g}, {y:.9g}, {z:.9g} of the tool frame is compensated"
