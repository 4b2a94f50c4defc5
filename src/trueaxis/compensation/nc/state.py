"""The modal state of an NC program while it is read, which axes it has commanded so far, and where its blocks start.

Only axes that the program has commanded may get words that it does not have.
"""

import math
from collections.abc import Hashable, Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, field
from enum import IntEnum

from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import LINEAR
from trueaxis.compensation.moves import Start
from trueaxis.compensation.nc.canned_cycle import Cycle, DrillingCall
from trueaxis.compensation.nc.frames import Frames
from trueaxis.compensation.nc.lexer import FeedMode
from trueaxis.compensation.nc.path_mode import PathMode
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.settings import MM_PER_INCH


class Commanded(IntEnum):
    """How the position of an axis is known.

    A word put in for an axis that does not stand where it is taken to stand would move it there.
    """

    UNKNOWN = 0  # neither commanded nor stated
    DISPLACED = 1  # a tool change may have moved it
    STATED = 2  # by --start (FROM in a CL file)
    BY_INCREMENTS = 3  # by increments from there: an increment put in is right wherever the axis is
    STOPPED = 4  # commanded, but the operator may have moved it since, and moves it back if the way on is to be right
    ABSOLUTE = 5


class CommandedAxes:
    """Follows `Commanded` of every axis through a program.

    An axis that was commanded in another frame (work offset, tool length) counts as BY_INCREMENTS: its position in this
    one is known only as well as both offsets, which may be rough.
    linear_complete: whether all linear axes are ABSOLUTE. held: for G91 and G90 (index 0 and 1) whether each axis may
    get no word in a block that does not name it; empty where all may. elsewhere: whether each axis may stand anywhere;
    empty where none may. unnamed: whether each axis is a linear one that nothing in the program has moved yet; empty
    where none is.
    """

    def __init__(self, axes: tuple[str, ...], stated: Sequence[bool] = ()) -> None:
        """stated: for each axis whether the user states where it stands at first; empty: for all."""
        self._linear = [row for row, axis in enumerate(axes) if axis in LINEAR]
        self._commanded = [Commanded.STATED if known else Commanded.UNKNOWN for known in stated or [True] * len(axes)]
        self._frame: Sequence[Hashable] = [None] * len(axes)  # that positions are given in now
        self._given: list[Hashable] = [None] * len(axes)  # that each axis was commanded in
        self._jogged: set[int] = set()  # since a stop
        self._unnamed = set(self._linear)
        self._set(self._commanded)

    def _set(self, commanded: list[Commanded]) -> None:
        self._commanded = commanded
        self._known = [
            known if given == now else min(known, Commanded.BY_INCREMENTS)
            for known, given, now in zip(commanded, self._given, self._frame, strict=True)
        ]
        self._complete = min(self._known, default=Commanded.ABSOLUTE) == Commanded.ABSOLUTE
        self.linear_complete = self.of(self._linear) == Commanded.ABSOLUTE
        self.unnamed = tuple(row in self._unnamed for row in range(len(commanded))) if self._unnamed else ()
        self.elsewhere = _below(self._known, Commanded.STATED)
        self.held = (_below(self._known, Commanded.BY_INCREMENTS), _below(self._known, Commanded.ABSOLUTE))

    def enter(self, frame: Sequence[Hashable]) -> None:
        """Positions are given in another frame from now on: for each axis what its offset is made of."""
        if frame != self._frame:
            self._frame = frame
            self._set(self._commanded)

    def displace(self, rows: Iterable[int] | None = None) -> None:
        """Some axes (None: any) may have moved.

        Before the program's first motion that is part of where the user states that they stand.
        """
        if rows is None and len(self._unnamed) == len(self._linear):
            return
        moved = set(range(len(self._commanded)) if rows is None else rows)
        self._set([min(k, Commanded.DISPLACED) if row in moved else k for row, k in enumerate(self._commanded)])

    def lose(self, rows: Iterable[int]) -> None:
        """Nothing says where these axes stand now."""
        lost = set(rows)
        self._unnamed -= lost
        self._set([Commanded.UNKNOWN if row in lost else k for row, k in enumerate(self._commanded)])

    def name(self, rows: Iterable[int], known: Commanded) -> None:
        """The axes stand where the program says in the frame in force."""
        named = set(rows)
        self._jogged -= named
        self._unnamed -= named
        for row in named:
            self._given[row] = self._frame[row]
        self._set([known if row in named else k for row, k in enumerate(self._commanded)])

    def stop(self) -> None:
        """The operator may have moved any axis."""
        self._jogged = set(range(len(self._commanded)))
        self._set([min(known, Commanded.STOPPED) for known in self._commanded])

    def stands(self, rows: Iterable[int]) -> bool:
        """Whether axes stand where they are taken to stand, and no operator may have moved them since."""
        named = set(rows)
        return not named & self._jogged and self.of(named) >= Commanded.STATED

    def of(self, rows: Iterable[int]) -> Commanded:
        """The least certain of some axes."""
        if self._complete:
            return Commanded.ABSOLUTE
        return min((self._known[row] for row in rows), default=Commanded.ABSOLUTE)

    def below(self, least: Commanded) -> list[int]:
        """Rows of the axes that are less certain."""
        return [] if self._complete else [row for row, known in enumerate(self._known) if known < least]

    def command(self, written: Sequence[bool], absolute: bool) -> tuple[bool, ...]:
        """Take in a block with these axis words; returns `held` of it."""
        named = [row for row, named in enumerate(written) if named]
        if self.of(named) < (Commanded.ABSOLUTE if absolute else Commanded.BY_INCREMENTS):
            if absolute:
                self.name(named, Commanded.ABSOLUTE)
            else:
                raised = set(named)
                self._unnamed -= raised
                self._set(
                    [max(k, Commanded.BY_INCREMENTS) if row in raised else k for row, k in enumerate(self._commanded)]
                )
        return self.held[absolute]


def _below(known: Sequence[Commanded], least: Commanded) -> tuple[bool, ...]:
    return tuple(one < least for one in known) if min(known) < least else ()


@dataclass(slots=True, kw_only=True)
class NcState:
    """What the blocks read so far have set.

    position: programmed position of each axis, mm or deg, None until known. motion: 0 rapid, 1 line, 2 and 3 arc
    (clockwise, counter-clockwise), None: none in force. in_force: the motion in force in the program that is written,
    where an arc has become lines. feed: F in force, mm/min or deg/min, NaN until known; feed_mode: how F counts. ended:
    line of the end of the program, 0 before. said: which of units (G20 G21) and distances (G90 G91) it has stated.
    numbers: of the words that gave the axes their positions, as written in the units in force; half a unit of them in
    mm where the units have changed since; None where no word has.
    offsets: work offsets known before the program; frames: those in force. tool: in the spindle, None: not known.
    cycle: the canned cycle in force; before_cycle: the motion that was before it; at_initial_level: G98; spindle: M3 or
    M4 while it turns. shift: position minus word of each axis, mm or deg; empty if 0. gap: between words, as in the
    last block that shows it. lost: rows of axes that were once where the program does not say. path: path mode, for
    LinuxCNC. point_control: whether positions are those of the tip. due: whether something is to be noted at the next
    motion. fed: whether F is above 0, or it has been noted that it is not. call: the cycle that is called after each
    block that moves. shorter_way: whether rotary axes turn on the shorter way (M126 of Heidenhain).
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
    before_cycle: int | None = None
    at_initial_level: bool = True
    spindle: str = ""
    shift: tuple[float, ...] = ()
    gap: str = " "
    lost: set[int] = field(default_factory=set)
    path: PathMode = field(default_factory=PathMode)
    point_control: bool = False
    due: bool = False
    fed: bool = False
    call: DrillingCall | None = None
    shorter_way: bool = False
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

    def lose(self, rows: Sequence[int]) -> Start:
        """Axes of these rows may stand anywhere from now on."""
        for row in rows:
            self.position[row] = None
        self.lost.update(rows)
        self.commanded.lose(rows)
        return Start(tuple(math.nan if row in rows else None for row in range(len(self.axes))))

    @property
    def goes_on_plainly(self) -> bool:
        """Whether a block of axis words alone is a move, or a hole, from where all axes are known."""
        known = self.commanded.linear_complete and None not in self.position
        return known and self.feed_mode != "time" and not (self.ended or self.due or self.call)

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


def starts_elsewhere(number: int, state: NcState, moved: Sequence[bool], otherwise: str, faults: FaultLog) -> bool:
    """Whether a block starts where the program has not commanded its axes to; faults where its way depends on that.

    moved: for each axis whether the block moves it. otherwise: what else would be right after a tool change.
    """
    arc = state.motion in (2, 3)
    known = state.commanded.of(row for row, moves in enumerate(moved) if moves)
    if known <= Commanded.DISPLACED and (arc or not state.absolute):
        faults.add(
            number,
            "this motion counts from where the axes stand, and the tool change before it may have moved them",
            ", ".join(filter(None, ("give their positions by G90 G0 first", otherwise))),
        )
    elif arc and state.absolute and known < Commanded.STOPPED:
        faults.add(
            number,
            "an arc that starts where the program has not commanded the axes to",
            "give the position by G90 G0 or G1 in the program first",
        )
    return known < (Commanded.STOPPED if state.absolute else Commanded.STATED)


def missing_axes(
    state: NcState, start: Sequence[float | None], end: Sequence[float | None], moved: AbstractSet[str]
) -> list[int]:
    """Axes without a position on which a motion depends; start, end: of all axes; moved: those that it moves.

    A rapid depends on the axes that it moves, a feed motion on those too that the program has moved before. Linear axes
    that it has not moved so far stand where they are taken to stand, and get no word. Under tool centre point control
    every axis counts.
    """
    unnamed, found = state.commanded.unnamed, []
    for row, axis in enumerate(state.axes):
        needed = (start[row], end[row]) if state.motion in (2, 3) else (end[row],)
        waits = bool(unnamed) and unnamed[row] and not state.point_control
        if None in needed and (axis in moved or (state.motion and not waits)):
            found.append(row)
    return found


def unknown_position(state: NcState, rows: Sequence[int]) -> tuple[str, str]:
    """The fault of a feed motion while the axes of some rows may stand anywhere, and what would be right."""
    problem = f"the position of {' '.join(state.axes[row] for row in rows)} is not known here"
    if lost := [state.axes[row] for row in rows if row in state.lost]:
        # where an axis stood before the program says nothing of where it went since
        went = "a reference point not in the spec, a switch of tool centre point control, a retraction or a K0 or L0"
        return (
            f"{problem} after {went}, and the errors depend on it",
            f"a rapid with {' '.join(lost)} before this block",
        )
    given = "".join(f"{state.axes[row]}0" for row in rows)
    return f"{problem}, and the errors depend on it", f"give it in the program or by --start {given} (with its value)"
