"""Modal state of an NC program while it is read."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from trueaxis.compensation.canned_cycles import Cycle
from trueaxis.compensation.commanded import CommandedAxes
from trueaxis.compensation.frames import Frames
from trueaxis.compensation.machine import LINEAR
from trueaxis.compensation.nc_meaning import FeedMode
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.settings import MM_PER_INCH

MODE_NOTES = {
    "inch": "no G20 or G21 before this motion: it is read in mm, and is wrong on a control that starts in inches",
    "absolute": "no G90 or G91 before this motion: it is read as G90, and is wrong on a control that starts in G91",
}


@dataclass(slots=True, kw_only=True)
class NcState:
    """What the blocks read so far have set.

    position: programmed position of each axis, mm or deg, None until known. motion: 0 rapid, 1 line, 2 and 3 arc
    (clockwise, counter-clockwise), None: none in force. in_force: the motion in force in the program that is written,
    where an arc has become lines. feed: F in force, mm/min or deg/min, NaN until known; feed_mode: how F
    counts. ended: line of the end of the program, 0 before. said: which of units (G20 G21) and distances
    (G90 G91) the program has stated.
    numbers: of the words that gave the axes their positions, as written in the units in force; half a unit of them in
    mm where the units have changed since; None where no word has.
    offsets: work offsets known before the program; frames: those in force. tool: in the spindle, None: not known.
    cycle: the canned cycle in force; at_initial_level: G98; spindle: M3 or M4 while it turns. shift: position minus
    word of each axis, mm or deg; empty if 0. gap: between words, as in the last block that shows it.
    point_control: whether positions are those of the tip.
    """

    axes: tuple[str, ...]
    position: list[float | None]
    motion: int | None = None
    in_force: int | None = None
    absolute: bool = True
    inch: bool = False
    plane: int = 170
    feed: float = math.nan
    feed_mode: FeedMode = "minute"
    ended: int = 0
    percents: int = 0
    moved: bool = False
    said: set[str] = field(default_factory=set)
    offsets: Offsets = field(default_factory=Offsets)
    tool: int | None = None
    cycle: Cycle | None = None
    at_initial_level: bool = True
    spindle: str = ""
    shift: tuple[float, ...] = ()
    gap: str = " "
    point_control: bool = False
    numbers: list[str | float | None] = field(init=False)
    frames: Frames = field(init=False)
    commanded: CommandedAxes = field(init=False)
    row: dict[str, int] = field(init=False)

    def __post_init__(self) -> None:
        self.commanded = CommandedAxes(self.axes, [value is not None for value in self.position])
        self.frames = Frames(axes=self.axes, offsets=self.offsets)
        self.enter_frame()
        self.numbers = [None] * len(self.axes)
        self.row = {axis: number for number, axis in enumerate(self.axes)}

    def enter_frame(self, machine: bool = False) -> None:
        """Positions are in the frame that the offsets make, or in machine coordinates, from now on."""
        self.shift = self.frames.shift_of_machine if machine else self.frames.shift
        self.commanded.enter(self.frames.of_machine if machine else self.frames.ids)

    @property
    def feed_in_minutes(self) -> float:
        """F in force, mm/min or deg/min; NaN where it is not known or counts otherwise."""
        return self.feed if self.feed_mode == "minute" else math.nan

    def scale(self, axis: str) -> float:
        """Length (mm) or angle (deg) of one unit of a word of this axis."""
        return MM_PER_INCH if self.inch and axis in LINEAR else 1.0

    def after(self, words: dict[str, float], ways: Mapping[str, bool] | None = None) -> list[float | None]:
        """Positions after a move to these axis words; ways: see Meaning."""
        end = list(self.position)
        for axis, value in words.items():
            row = self.row[axis]
            distance = value * self.scale(axis)
            if self.absolute if not ways else ways.get(axis, self.absolute):
                end[row] = distance + self.shift[row] if self.shift else distance
            else:
                before = end[row]
                end[row] = None if before is None else before + distance
        return end
