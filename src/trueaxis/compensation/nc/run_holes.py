"""The holes of many blocks of a canned cycle, all of them at once: what `CycleWriter` makes of them one by one. The
blocks have X or Y, and may say again what is in force; the cycle may end by G80, and begin again as it was, behind
rapids, where the axis that drills stands as it did.
"""

import re
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import NO_ARCS, BlockPlaces, PlainRun, columns_of
from trueaxis.compensation.machine import FloatArray
from trueaxis.compensation.moves import Kind
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc.plain_text import LETTERS, Codes, PlainText
from trueaxis.compensation.nc.state import NcState

MOST_MOTIONS = 16384  # of a run: a batch
_WORD = re.compile(r"([A-Z])[ \t]*+([-+.\d]++)", re.IGNORECASE)
_RETURN = frozenset({98.0, 99.0})
_BLANK = np.isin(np.arange(256), [ord(" "), ord("\t")])
_END, _LAST_LINEAR = codes.CANCEL_CYCLE // 10, LETTERS.index("Z")


class Hole(NamedTuple):
    """What is done over the place of a hole: motions of the axis in row `depth`, which is at `level` before, with their
    ends, mm, machine coordinates, and blocks that move nothing. code, words: of the cycle in force, as written;
    returns: 98 or 99, in force; says_return: whether that is written; begins_again: whether the cycle is the same after
    its end where these words are said again.
    """

    depth: int
    level: float
    steps: tuple[tuple[Kind | str, float], ...]
    code: int
    words: dict[str, float]
    returns: int
    says_return: bool
    begins_again: bool


def several_words(lines: PlainText, part: slice) -> NDArray[np.bool_]:
    """Which of these lines have more than one word."""
    count = np.diff(lines.first[part.start : part.stop + 1])
    return (count > 1) | (lines.lead[part] > lines.starts[part]) | np.isfinite(lines.feed[part])


def begin_again(state: NcState, hole: Hole) -> None:
    """Take into the state that the cycle in force has ended and begun again behind rapids."""
    if state.cycle is not None:
        state.cycle = replace(state.cycle, initial=hole.level)
    state.before_cycle = int(Kind.RAPID)


class Part(NamedTuple):
    """Some lines of a text, from the first up to the last."""

    lines: PlainText
    first: int
    last: int

    @property
    def moves(self) -> NDArray[np.bool_]:
        """Which of them have words of axes."""
        return np.diff(self.lines.first[self.first : self.last + 1]) > 0

    @property
    def modes(self) -> Codes:
        """Their codes of modes."""
        return self.lines.modes.of(self.first, self.last)

    @property
    def words(self) -> tuple[NDArray[np.int64], FloatArray, NDArray[np.int64]]:
        """Letters, values and lines, from 0, of their words of axes."""
        of = slice(*self.lines.first[[self.first, self.last]].tolist())
        return self.lines.letter[of], self.lines.value[of], self.lines.line[of] - self.first


class _Marks(NamedTuple):
    """Which lines are rapids to further holes, and which end the cycle, each (n,)."""

    places: NDArray[np.bool_]
    ends: NDArray[np.bool_]


def holes_alike(part: Part, state: NcState, hole: Hole) -> int:
    """Up to which of these plain lines are holes that can be taken together, with text, and ends and new beginnings of
    the cycle, between them; the first itself if it is none.
    """
    lines, first, last = part
    of, moves, modes = slice(first, last), part.moves, part.modes
    places = moves & (lines.code[of] == int(Kind.RAPID)) & hole.begins_again
    ends = np.zeros(moves.size, dtype=bool)
    ends[modes.line[modes.number == _END]] = hole.begins_again
    again, astray = _turns(part, state, hole, _Marks(places, ends))
    wrong = astray | _otherwise(part, state.plane, hole, places) | ((lines.code[of] >= 0) & ~places)
    wrong[lines.switches.of(first, last).line] = True
    start = int(lines.starts[first])
    solid = np.concatenate([[0], np.cumsum(~_BLANK[lines.source[start : lines.starts[last]]])])
    line_ends = lines.starts[first + 1 : last + 1] - 1 - lines.returned[of] - start
    last_word = np.maximum(lines.tail[of], lines.feed_end[of]) - start
    behind = solid[line_ends] - solid[np.where(moves, last_word, 0)] > 0
    wrong |= moves & (behind | (lines.returned[of] != lines.returned[first]))
    shows = moves & (lines.blank[of] | several_words(lines, of))
    wrong |= shows & (lines.blank[of] != (state.gap == " "))
    if isinstance(hole.steps[-1][0], str):  # what comes after the last motion and what stands behind the line
        wrong |= ~moves
    wrong[0] |= not moves[0]
    most = max(MOST_MOTIONS // len(hole.steps), 1)
    wrong |= np.cumsum(moves) > most
    count = int(np.argmax(wrong)) if wrong.any() else moves.size
    begun, ended = (np.append(np.flatnonzero(which[:count]), -1) for which in (again, ends))
    return first + (int(ended[-2]) if ended.size > 1 and begun[-2:].max() < ended[-2] else count)


def _turns(part: Part, state: NcState, hole: Hole, marks: _Marks) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Where the cycle begins again, and which lines it is no such turn for: rapids or an end where it is in force,
    holes or an end where it is not.
    """
    (places, ends), (letter, value, line), modes = marks, part.words, part.modes
    count = places.size
    says = np.zeros(count, dtype=bool)
    says[modes.line[modes.number == hole.code]] = True
    of_end, of_cycle = _latest(ends), _latest(says)
    out = of_end > of_cycle
    again = says & out
    axis = state.axes[hole.depth]
    scale, shift = state.scale(axis), state.shift[hole.depth] if state.shift else 0.0
    depth = (letter == LETTERS.index(axis)) & places[line]
    level = np.zeros(count)
    level[line[depth]] = value[depth] * scale + shift
    moved = np.zeros(count, dtype=bool)
    moved[line[depth]] = True
    of_level = _latest(moved)
    complete = np.bincount(line[np.isin(letter, [LETTERS.index(name) for name in hole.words])], minlength=count)
    astray = again & ((complete < len(hole.words)) | (_latest(places) < of_end))
    astray |= again & (of_level > of_end) & (level[np.maximum(of_level, 0)] != hole.level)
    holes = part.moves & ~places
    return again, astray | np.where(out, (holes & ~says) | ends, places)


def _latest(of: NDArray[np.bool_]) -> NDArray[np.int64]:
    """The latest of these lines before each line; -1: none."""
    found = np.maximum.accumulate(np.where(of, np.arange(of.size), -1))
    return np.concatenate([[-1], found[:-1]])


def _otherwise(part: Part, plane: int, hole: Hole, places: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Which of these lines say anything but where a further hole is, F, and again what is in force; rapids (`places`)
    anything but where they go, and ends of the cycle anything else.
    """
    lines, first, last = part
    letter, value, line = part.words
    decimals = lines.decimals[slice(*lines.first[[first, last]].tolist())]
    across, along = (letter == LETTERS.index(axis) for axis in codes.PLANES[plane][:2])
    named = np.zeros(last - first, dtype=bool)
    named[line[across | along]] = True
    wrong = np.zeros(last - first, dtype=bool)
    again = across | along
    for name, known in hole.words.items():  # Q without a decimal point may count otherwise
        again |= (letter == LETTERS.index(name)) & (value == known) & ((name != "Q") | (decimals >= 0))
    again = np.where(places[line], letter <= _LAST_LINEAR, again)
    wrong[line[~again]] = True
    modes = part.modes
    ends = modes.number == _END
    wrong[modes.line[~np.isin(modes.number, [hole.code, hole.returns, *[_END] * hole.begins_again])]] = True
    same = (np.diff(modes.line) == 0) & (ends[1:] | ends[:-1] | (modes.number[1:] == modes.number[:-1]))
    wrong[modes.line[1:][same]] = True
    says = np.isfinite(lines.feed[first:last]) | part.moves
    wrong[modes.line[ends]] |= says[modes.line[ends]]
    says[modes.line[~ends]] = True
    return wrong | (says & np.where(places, np.isfinite(lines.feed[first:last]), ~named)) | _marked(places, modes.line)


def _marked(places: NDArray[np.bool_], line: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Rapids with codes of modes, whose lines are given."""
    found = np.zeros_like(places)
    found[line] = places[line]
    return found


def holes_run(
    part: Part,
    number: int,
    table: tuple[NDArray[np.bool_], FloatArray, FloatArray],
    state: NcState,
    hole: Hole,
) -> PlainRun:
    """The motions of the holes of these lines, of which the first is line `number` of the program.

    table: which axes the lines that move name, those of holes without the one that drills, and where they go, mm and
    deg, each (n_axes, n), and their F (n,).
    """
    (lines, first, last), (named, ends_of_lines, feed) = part, table
    index = first + np.flatnonzero(part.moves)
    drills = lines.code[index] < 0
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
    ends = np.repeat(ends_of_lines, each, axis=1)
    written = np.zeros((len(state.axes), index.size, each), dtype=bool)
    ends[hole.depth] = np.tile([hole.level, *(z for _, z in motions[1:])], index.size)
    ends[hole.depth, ::each] = ends_of_lines[hole.depth]
    written[:, :, 0], written[hole.depth, :, 1:] = named, True
    places, leads = _places(part, index, behind, (state.gap, hole))
    of = np.flatnonzero(np.repeat(drills, each) | (np.arange(drills.size * each) % each == 0))  # rapids: one motion
    return PlainRun(
        line=np.repeat(number + index - first, each)[of],
        motion=np.tile([int(kind) for kind, _ in motions], index.size)[of],
        ends=columns_of(ends, of), written=columns_of(written.reshape(len(state.axes), -1), of), absolute=True,
        inch=state.inch, blank=np.full(of.size, state.gap == " "), eol=eol,
        source=np.concatenate([
            lines.source[lines.starts[first] : lines.starts[last]],
            np.frombuffer("".join([*behind, leads]).encode("latin-1"), dtype=np.uint8),
        ]),
        places=places.of(of), inserts=np.repeat(drills, each)[of], arcs=NO_ARCS,
        feed=np.repeat(feed, each)[of], held=state.commanded.held[True],
        elsewhere=state.commanded.elsewhere, shift=state.shift, passable=False, stays=np.repeat(~drills, each)[of],
    )  # fmt: skip


def _places(
    part: Part, index: NDArray[np.int64], behind: list[str], of_holes: tuple[str, Hole]
) -> tuple[BlockPlaces, str]:
    """Where the text of the motions is, in that of the lines with what stands behind each motion of a hole after it,
    and then the second result: N, F and the return of lines with other words than those of X and Y.

    N and F stand before the first motion, the line's own end and the text behind it behind the last.
    """
    lines, first, last = part
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
    rapids = np.flatnonzero(lines.code[index] >= 0)  # whose text stays, but for its words
    at = index[rapids]
    begin[rapids, 0], first_word[rapids, 0], last_word[rapids, 0] = (
        of[at] - start for of in (lines.starts, lines.lead, lines.tail)
    )
    after[rapids, 0] = after[rapids, -1]
    modes = part.modes
    again = np.isfinite(lines.feed[index])
    again[np.searchsorted(index, modes.line[modes.number != _END] + first)] = True
    leads = [_lead(lines, line, *of_holes) for line in index[again].tolist()]
    lead_ends = int(ends[-1]) + np.cumsum([len(text) for text in leads], dtype=np.int64)
    begin[again, 0], first_word[again, 0] = lead_ends - [len(text) for text in leads], lead_ends
    begin, first_word, last_word, after = (of.reshape(-1) for of in (begin, first_word, last_word, after))
    places = BlockPlaces(
        begin=begin, first=first_word, last=last_word, end=last_word, after=after, code=first_word, code_end=first_word
    )
    return places, "".join(leads)


def _lead(lines: PlainText, line: int, gap: str, hole: Hole) -> str:
    """N, F and, where that is written, G98 or G99 of a line, as they are written before its first motion."""
    text = lines.source[lines.starts[line] : lines.starts[line + 1]].tobytes().decode("latin-1")
    return gap.join(
        word[0]
        for word in _WORD.finditer(text)
        if word[1] in "NFnf" or (hole.says_return and word[1] in "Gg" and float(word[2]) in _RETURN)
    )
