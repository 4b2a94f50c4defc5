"""What canned cycles become, G73 G81 G82 G83 G85 G86 G89, as LinuxCNC and Fanuc make them: the motions in a hole, the
blocks of one block, and those of many holes at once, which are blocks of X and Y alone.

What many holes become is what `CycleWriter` makes of them one by one: a test holds both against each other.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import NO_ARCS, BlockPlaces, PlainRun
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import FloatArray
from trueaxis.compensation.moves import Item, Kind, Move
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc.lexer import Block, Meaning, due_at_end
from trueaxis.compensation.nc.plain_text import LETTERS, PlainText
from trueaxis.compensation.nc.state import NcState, missing_axes, starts_elsewhere, unknown_position

MOST_PECKS = 10_000

RAPID, FEED, DWELL, SPINDLE_STOP, SPINDLE_START = range(5)
Step = tuple[int, float]  # what is done, and to which position of the axis that drills (machine, mm)
_OF_CYCLE = frozenset("XYZRQPLK")
_RETURN = frozenset({980, 990})  # codes that say where the control's own cycles end
MOST_MOTIONS = 16384  # of a run: a batch
_BLANK = np.isin(np.arange(256), [ord(" "), ord("\t")])


class CycleError(Exception):
    """What is wrong with a block of a cycle, and the remedy."""


DWELLING = (820, 860, 890)  # cycles with a dwell at the bottom


def steps(
    code: int, r: float, bottom: float, clear: float, peck: tuple[float, float], dwells: bool
) -> Iterator[Step]:  # fmt: skip
    """What a cycle does in one hole, from R on; r, bottom, clear (where it ends): mm, machine coordinates; peck: how
    deep, and how far back, mm.
    """
    deep, back = peck
    if code in (730, 830):
        depth = r - deep
        while depth > bottom + 1e-9:
            yield FEED, depth
            if code == 830:
                yield RAPID, r
            yield RAPID, depth + min(back, r - depth)
            depth -= deep
    yield FEED, bottom
    if dwells and code in DWELLING:
        yield DWELL, bottom
    if code == 860:
        yield SPINDLE_STOP, bottom
    if code in (850, 890):
        yield FEED, r
    if clear != r or code not in (850, 890):
        yield RAPID, clear
    if code == 860:
        yield SPINDLE_START, clear


class Hole(NamedTuple):
    """What is done over the place of a hole: motions of the axis in row `depth`, which is at `level` before, with their
    ends, mm, machine coordinates, and blocks that move nothing.
    """

    depth: int
    level: float
    steps: tuple[tuple[Kind | str, float], ...]


class CycleWriter:
    """Makes the blocks of one block of a cycle. with_return: whether G98 and G99 are written with the motions, for
    cycles that the control is left with.
    """

    def __init__(
        self,
        state: NcState,
        number: int,
        body: str,
        block: Block,
        eol: str,
        again: str,
        assumed: list[float],
        faults: FaultLog,
        *,
        with_return: bool,
    ) -> None:
        self._state, self._number, self._assumed, self._faults = state, number, assumed, faults
        self._eol, self._again = eol or "\n", again
        if " " in body or "\t" in body:
            state.gap = " "
        elif len(block.words) > 1:
            state.gap = ""
        self._lead, self._comment, self._last = _kept(body, block, state.gap, again, with_return)
        self._items: list[Item] = []
        self._wrong = False

    def fault(self, problem: str, remedy: str) -> None:
        """Note what is wrong."""
        self._wrong = True
        self._faults.add(self._number, problem, remedy)

    def finished(self) -> list[Item]:
        """The blocks."""
        if self._last and not self._wrong:
            self.say(self._last)
        return self._items

    def alone(self) -> list[Item]:
        """What stays of a block whose cycle does nothing."""
        text = (self._lead.rstrip() + self._comment + self._last).strip()
        return [f"{text}{self._eol}"] if text else []

    def say(self, text: str) -> None:
        """A block that moves nothing."""
        self._items.append(f"{self._again}{text}{self._eol}")

    def across(self, meaning: Meaning) -> bool:
        """Over the hole, by the X and Y of the block; False after a fault."""
        if not meaning.axes:
            return True
        end = self._state.after(meaning.axes)
        if None in [end[self._state.row[axis]] for axis in meaning.axes]:
            self.fault(f"the position of {' '.join(meaning.axes)} is not known here", "G90 G0 in the program first")
            return False
        return self.go(Kind.RAPID, {axis: end[self._state.row[axis]] or 0.0 for axis in meaning.axes})

    def go(self, kind: Kind, ends: dict[str, float]) -> bool:
        """A straight motion of some axes, to machine positions, mm; False after a fault."""
        state = self._state
        end = list(state.position)
        for axis, value in ends.items():
            end[state.row[axis]] = value
        written = tuple(axis in ends for axis in state.axes)
        before = self._faults.count
        state.motion = int(kind)
        if kind != Kind.RAPID and (missing := missing_axes(state, state.position, end, set(ends))):
            state.motion = None
            if not self._wrong:
                self.fault(*unknown_position(state, missing))
            return False
        elsewhere = starts_elsewhere(self._number, state, written, "", self._faults)
        state.motion = None
        state.position, state.in_force, state.moved = end, int(kind), True
        lead = self._lead + ("G1" if kind else "G0") + state.gap
        held = state.commanded.command(written, state.absolute)
        self._items.append(
            Move(
                self._number,
                kind,
                tuple(self._assumed[row] if v is None else v for row, v in enumerate(end)),
                written,
                state.absolute,
                state.inch,
                lead,
                self._comment,
                state.gap,
                self._eol,
                "",
                self._again,
                passable=False,
                feed=state.feed_in_minutes,
                held=held,
                elsewhere=state.commanded.elsewhere,
                unnamed=state.commanded.unnamed,
                shift=state.shift,
                start_stated=elsewhere,
            )
        )
        self._lead, self._comment = self._again, ""
        return self._faults.count == before


def _kept(body: str, block: Block, gap: str, again: str, with_return: bool) -> tuple[str, str, str]:
    """What stays of a block of a cycle: text before its first motion, comments behind it, words due at the end."""
    lead: list[str] = []
    last: list[str] = []
    comment, place = "", 0
    out = codes.CYCLES if with_return else codes.CYCLES | _RETURN
    for word in block.words:
        between, place = body[place : word.start].strip(" \t").removeprefix(again), word.end
        comment += f" {between.strip()}" if between.strip() else ""
        if word.letter in _OF_CYCLE or (word.letter == "G" and round(word.value * 10) in out):
            continue
        (last if due_at_end(word) else lead).append(body[word.start : word.end])
    comment += f" {body[place:].strip()}" if body[place:].strip() else ""
    head = gap.join(lead)
    return again + head + (gap if head else ""), comment, gap.join(last)


def holes_alike(lines: PlainText, first: int, last: int, state: NcState, hole: Hole) -> int:
    """Up to which of these plain lines are holes that can be taken together, with text between them; the first itself
    if it is none.
    """
    part, words = slice(first, last), slice(*lines.first[[first, last]].tolist())
    plane = [LETTERS.index(axis) for axis in codes.PLANES[state.plane][:2]]
    moves = np.diff(lines.first[first : last + 1]) > 0
    wrong = (lines.code[part] >= 0) | np.isfinite(lines.feed[part])
    wrong[(lines.line[words] - first)[~np.isin(lines.letter[words], plane)]] = True
    wrong[lines.modes.of(first, last).line] = wrong[lines.switches.of(first, last).line] = True
    start = int(lines.starts[first])
    solid = np.concatenate([[0], np.cumsum(~_BLANK[lines.source[start : lines.starts[last]]])])
    ends = lines.starts[first + 1 : last + 1] - 1 - lines.returned[part] - start
    behind = solid[ends] - solid[np.where(moves, lines.tail[part] - start, 0)] > 0
    wrong |= moves & (behind | (lines.returned[part] != lines.returned[first]))
    several = (np.diff(lines.first[first : last + 1]) > 1) | (lines.lead[part] > lines.starts[part])
    shows = moves & (lines.blank[part] | several)
    wrong |= shows & (lines.blank[part] != (lines.blank[first] if shows[0] else state.gap == " "))
    if isinstance(hole.steps[-1][0], str):  # what comes after the last motion and what stands behind the line
        wrong |= ~moves
    wrong[0] |= not moves[0]
    most = max(MOST_MOTIONS // len(hole.steps), 1)
    wrong |= np.cumsum(moves) > most
    return first + int(np.argmax(wrong)) if wrong.any() else last


def holes_run(
    lines: PlainText,
    first: int,
    last: int,
    number: int,
    table: tuple[NDArray[np.bool_], FloatArray],
    state: NcState,
    hole: Hole,
) -> PlainRun:
    """The motions of the holes of these lines, of which the first is line `number` of the program.

    table: which axes the lines that move name, and where they go, mm and deg, each (n_axes, n).
    """
    named, places = table
    index = first + np.flatnonzero(np.diff(lines.first[first : last + 1]) > 0)
    eol = "\r\n" if lines.returned[first] else "\n"
    motions: list[tuple[Kind, float]] = [(Kind.RAPID, 0.0)]  # over the hole, then what is done there
    behind = [eol]  # each motion
    for what, z in hole.steps:
        if isinstance(what, str):
            behind[-1] += what + eol
        else:
            motions.append((what, z))
            behind.append(eol)
    each = len(motions)
    ends, written = np.repeat(places, each, axis=1), np.zeros((len(state.axes), index.size, each), dtype=bool)
    ends[hole.depth] = np.tile([hole.level, *(z for _, z in motions[1:])], index.size)
    written[:, :, 0], written[hole.depth, :, 1:] = named, True
    count = ends.shape[1]
    return PlainRun(
        line=np.repeat(number + index - first, each), motion=np.tile([int(kind) for kind, _ in motions], index.size),
        ends=ends, written=written.reshape(-1, count), absolute=True, inch=state.inch,
        blank=np.full(count, state.gap == " "), eol=eol,
        source=np.concatenate([
            lines.source[lines.starts[first] : lines.starts[last]],
            np.frombuffer("".join(behind).encode("latin-1"), dtype=np.uint8),
        ]),
        places=_places(lines, first, last, index, behind), inserts=np.ones(count, dtype=bool), arcs=NO_ARCS,
        feed=np.full(count, state.feed_in_minutes), held=state.commanded.held[True],
        elsewhere=state.commanded.elsewhere, shift=state.shift, passable=False, stays=False,
    )  # fmt: skip


def _places(lines: PlainText, first: int, last: int, index: NDArray[np.int64], behind: list[str]) -> BlockPlaces:
    """Where the text of the motions is, in that of the lines with what stands behind each motion of a hole after it.

    N stands before the first motion, the line's own end and the text behind it behind the last.
    """
    start = int(lines.starts[first])
    solid = start + np.flatnonzero(~_BLANK[lines.source[start : lines.starts[last]]])
    lead = lines.lead[index]
    begin, first_word, last_word, after = np.zeros((4, index.size, len(behind)), dtype=np.int64)
    begin[:, 0] = solid[np.searchsorted(solid, lines.starts[index])] - start
    first_word[:, 0] = np.where(
        begin[:, 0] + start == lead, begin[:, 0], solid[np.searchsorted(solid, lead) - 1] + 1 - start
    )
    ends = int(lines.starts[last]) - start + np.cumsum([len(text) for text in behind])
    last_word[:], after[:] = ends - [len(text) for text in behind], ends
    if len(behind[-1]) <= len("\r\n"):
        last_word[:, -1] = lines.starts[index + 1] - 1 - lines.returned[index] - start
        after[:, -1] = np.append(lines.starts[index[1:]], lines.starts[last]) - start
    begin, first_word, last_word, after = (of.reshape(-1) for of in (begin, first_word, last_word, after))
    return BlockPlaces(
        begin=begin, first=first_word, last=last_word, end=last_word, after=after, code=first_word, code_end=first_word
    )
