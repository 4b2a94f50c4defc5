"""What the readers hand on: text that moves nothing, and moves."""

import math
from collections import Counter
from dataclasses import dataclass, field
from enum import IntEnum
from typing import Literal, NamedTuple

import numpy as np

from trueaxis.compensation.arcs import Arc
from trueaxis.compensation.logs import LineLog


class Kind(IntEnum):
    """How a move gets to its end."""

    RAPID = 0
    LINE = 1
    ARC = 2


class Split(NamedTuple):
    """The text around the axis words when a block becomes several: words due at the end go to the last one."""

    lead: str
    tail: str
    last: str


CentreWords = Literal["centre", "radius"]


class Round(NamedTuple):
    """How an arc is written where it stays one.

    lead, split_lead: as of Move and Split, with the code of the arc. code, line: what stands before the words of the
    pieces that follow, by kind. centre: whether I J K, or the radius, which is written after `radius`; last: after it.
    """

    lead: str
    split_lead: str
    code: str
    line: str
    centre: CentreWords = "centre"
    radius: str = "R"
    last: str = ""


class Move(NamedTuple):
    """One block that moves, as programmed.

    line: number in the source, from 1. end: programmed axis positions, mm and deg, order of the machine's axes.
    written: for each axis whether the source block has its word. absolute, inch: how words are to be written.
    lead, tail: the other text of the block before and after its axis words; gap: what separates words.
    eol: line end as in the source. source: the whole block where it could stand unchanged, else empty.
    again: what the further blocks of a split begin with. split: lead and tail when split, None if the same.
    passable: whether the tool may run through the end without anything due there. feed: F in force, mm/min (deg/min);
    NaN where it is not known or counts by turns of the spindle.
    held: for each axis whether it gets no word here, see commanded; empty if all may. elsewhere: for each axis whether
    it may stand anywhere, and `end` is where it is taken to stand; empty if none may. unnamed: for each axis whether it
    is a linear one that the program has not moved so far; empty if none is. shift: position minus word of
    each axis, mm and deg; empty if 0. start_stated: whether it starts
    where the program has not commanded the axes to: only its end counts. whole: why it may not be cut; empty if it may.
    inverse_time: F where it is 1/min of the block (G93), else 0. round: how an arc is written where it may stay one.
    in_machine: whether the block is in machine coordinates by itself (G53, SUPA, M91). ways: for each axis DC, ACP or
    ACN, as which its word is written (SINUMERIK), empty for none; empty if no axis has one.
    """

    line: int
    kind: Kind
    end: tuple[float, ...]
    written: tuple[bool, ...]
    absolute: bool
    inch: bool
    lead: str
    tail: str
    gap: str
    eol: str
    source: str
    again: str = ""
    split: Split | None = None
    arc: Arc | None = None
    passable: bool = True
    feed: float = math.nan
    held: tuple[bool, ...] = ()
    elsewhere: tuple[bool, ...] = ()
    unnamed: tuple[bool, ...] = ()
    shift: tuple[float, ...] = ()
    start_stated: bool = False
    whole: str = ""
    inverse_time: float = 0.0
    round: Round | None = None
    in_machine: bool = False
    ways: tuple[str, ...] = ()

    def as_line(self) -> "Move":
        """The same, but straight."""
        return self._replace(arc=None, kind=Kind.LINE)


class Zero(NamedTuple):
    """A block that gives axes new values where they stand (G92): `source` if its words hold where they stand now.

    rows: axes that it names. shift: position minus word in the frame of these words; lead, tail, gap, inch as in Move.
    """

    rows: tuple[int, ...]
    shift: tuple[float, ...]
    lead: str
    tail: str
    gap: str
    inch: bool
    source: str


class Setup(NamedTuple):
    """What holds from here on: the work offset (empty: machine coordinates), its values and half of their ranges for
    each axis, mm and deg; the tool in the spindle (None: not known, the tool point is that of the settings); whether
    positions are those of the tip, see point_control.
    """

    system: str = ""
    values: tuple[float, ...] = ()
    spread: tuple[float, ...] = ()
    tool: int | None = None
    point_control: bool = False


class KeptHole(NamedTuple):
    """A hole of a canned cycle that stays one, at `bottom` (n_axes), from `top`; the drilling axis, Z, then goes to
    `clear`: mm and deg, machine coordinates.

    begins: whether the cycle begins here, from the level to which it goes back; to_level: whether it goes back there,
    or to the top. shift: position minus word of each axis; lead, tail, gap, inch, eol as in Move.
    """

    line: int
    bottom: tuple[float, ...]
    top: float
    clear: float
    begins: bool
    to_level: bool
    shift: tuple[float, ...]
    inch: bool
    lead: str
    tail: str
    gap: str
    eol: str


class Start(NamedTuple):
    """Where the machine stands before the next move, uncompensated, mm and deg; NaN where that is not known.

    None: the axis stands where the words have put it.
    """

    position: tuple[float | None, ...]


Between = Start | Zero | Setup | KeptHole  # what is said between moves
Item = str | Move | Between

TOOL_CHANGE = (
    "--tool-point is taken to hold after M6 too, whatever the tool; M6 may have moved any axis, so each gets words "
    "again only once the program has commanded it"
)
AFTER_END = "what follows the end of the program is copied as it is: its motions are not compensated"
STOP = "the operator may move axes at M0 and M1: each gets words again only once the program has commanded it"


@dataclass(slots=True, kw_only=True)
class Notes:
    """Remarks on a program that are no faults: text, how often, and the first line. grave: those that may cost a crash
    or a wrong part. passed: lines of each M code that the user vouches for. kept: motions that stay as they are.
    unplaced: whether the program moves without any work offset that is known.
    """

    counts: Counter[str] = field(default_factory=Counter)
    first: dict[str, int] = field(default_factory=dict)
    passed: dict[int, LineLog] = field(default_factory=dict)
    kept: int = 0
    grave: set[str] = field(default_factory=set)
    unplaced: bool = False

    def pass_code(self, line: int, code: int) -> None:
        """Note an M code that the user vouches for."""
        self.passed.setdefault(code, LineLog()).add(np.array([line]))

    def add(self, line: int, text: str, times: int = 1) -> None:
        """Note a remark once more, or more often."""
        self.counts[text] += times
        self.first.setdefault(text, line)

    def warn(self, line: int, text: str, times: int = 1) -> None:
        """Note a remark on what may cost a crash or a wrong part: it is read first."""
        self.grave.add(text)
        self.add(line, text, times)

    def texts(self, grave: bool = False) -> tuple[str, ...]:
        """`line 12 (and 3 more): remark`, in the order of first appearance, of those that are grave or of the others;
        line 0 is the program as a whole.
        """
        return tuple(
            text
            if line == 0
            else f"line {line}{f' (and {self.counts[text] - 1} more)' if self.counts[text] > 1 else ''}: {text}"
            for text, line in self.first.items()
            if (text in self.grave) == grave
        )
