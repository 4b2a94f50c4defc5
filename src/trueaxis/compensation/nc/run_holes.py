"""The holes of many blocks of a canned cycle, all of them at once: what `CycleWriter` makes of them one by one. The
blocks have X or Y, and may say again what is in force.
"""

import re
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import NO_ARCS, BlockPlaces, PlainRun
from trueaxis.compensation.machine import FloatArray
from trueaxis.compensation.moves import Kind
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc.plain_text import LETTERS, PlainText
from trueaxis.compensation.nc.state import NcState

MOST_MOTIONS = 16384  # of a run: a batch
_NUMBER = re.compile(r"[ \t]*+(N\d++)", re.IGNORECASE)
_BLANK = np.isin(np.arange(256), [ord(" "), ord("\t")])


class Hole(NamedTuple):
    """What is done over the place of a hole: motions of the axis in row `depth`, which is at `level` before, with their
    ends, mm, machine coordinates, and blocks that move nothing. code, words: of the cycle in force, as written.
    """

    depth: int
    level: float
    steps: tuple[tuple[Kind | str, float], ...]
    code: int
    words: dict[str, float]


def several_words(lines: PlainText, part: slice) -> NDArray[np.bool_]:
    """Which of these lines have more than one word."""
    count = np.diff(lines.first[part.start : part.stop + 1])
    return (count > 1) | (lines.lead[part] > lines.starts[part]) | np.isfinite(lines.feed[part])


def holes_alike(lines: PlainText, first: int, last: int, state: NcState, hole: Hole) -> int:
    """Up to which of these plain lines are holes that can be taken together, with text between them; the first itself
    if it is none.
    """
    part = slice(first, last)
    moves = np.diff(lines.first[first : last + 1]) > 0
    wrong = _otherwise(lines, first, last, state.plane, hole) | (lines.code[part] >= 0)
    wrong[lines.switches.of(first, last).line] = True
    start = int(lines.starts[first])
    solid = np.concatenate([[0], np.cumsum(~_BLANK[lines.source[start : lines.starts[last]]])])
    ends = lines.starts[first + 1 : last + 1] - 1 - lines.returned[part] - start
    last_word = np.maximum(lines.tail[part], lines.feed_end[part]) - start
    behind = solid[ends] - solid[np.where(moves, last_word, 0)] > 0
    wrong |= moves & (behind | (lines.returned[part] != lines.returned[first]))
    shows = moves & (lines.blank[part] | several_words(lines, part))
    wrong |= shows & (lines.blank[part] != (state.gap == " "))
    if isinstance(hole.steps[-1][0], str):  # what comes after the last motion and what stands behind the line
        wrong |= ~moves
    wrong[0] |= not moves[0]
    most = max(MOST_MOTIONS // len(hole.steps), 1)
    wrong |= np.cumsum(moves) > most
    return first + int(np.argmax(wrong)) if wrong.any() else last


def _otherwise(lines: PlainText, first: int, last: int, plane: int, hole: Hole) -> NDArray[np.bool_]:
    """Which of these lines say anything but where a further hole is, F, and again what is in force."""
    words = slice(*lines.first[[first, last]].tolist())
    letter, value, line = lines.letter[words], lines.value[words], lines.line[words] - first
    across, along = (letter == LETTERS.index(axis) for axis in codes.PLANES[plane][:2])
    named = np.zeros(last - first, dtype=bool)
    named[line[across | along]] = True
    wrong = np.zeros(last - first, dtype=bool)
    again = across | along
    for name, known in hole.words.items():  # Q without a decimal point may count otherwise
        again |= (letter == LETTERS.index(name)) & (value == known) & ((name != "Q") | (lines.decimals[words] >= 0))
    wrong[line[~again]] = True
    modes = lines.modes.of(first, last)
    wrong[modes.line[modes.number != hole.code]] = True
    wrong[modes.line[1:][np.diff(modes.line) == 0]] = True
    says = np.isfinite(lines.feed[first:last]) | (np.diff(lines.first[first : last + 1]) > 0)
    says[modes.line] = True
    return wrong | (says & ~named)


def holes_run(
    lines: PlainText,
    first: int,
    last: int,
    number: int,
    table: tuple[NDArray[np.bool_], FloatArray, FloatArray],
    state: NcState,
    hole: Hole,
) -> PlainRun:
    """The motions of the holes of these lines, of which the first is line `number` of the program.

    table: which axes the lines that move name, and where they go, mm and deg, each (n_axes, n), and their F (n,).
    """
    named, places, feed = table
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
    each, named = len(motions), named.copy()
    ends, written = np.repeat(places, each, axis=1), np.zeros((len(state.axes), index.size, each), dtype=bool)
    named[hole.depth] = False
    ends[hole.depth] = np.tile([hole.level, *(z for _, z in motions[1:])], index.size)
    written[:, :, 0], written[hole.depth, :, 1:] = named, True
    count, (places_of_text, leads) = ends.shape[1], _places(lines, first, last, index, behind, state.gap)
    return PlainRun(
        line=np.repeat(number + index - first, each), motion=np.tile([int(kind) for kind, _ in motions], index.size),
        ends=ends, written=written.reshape(-1, count), absolute=True, inch=state.inch,
        blank=np.full(count, state.gap == " "), eol=eol,
        source=np.concatenate([
            lines.source[lines.starts[first] : lines.starts[last]],
            np.frombuffer("".join([*behind, leads]).encode("latin-1"), dtype=np.uint8),
        ]),
        places=places_of_text, inserts=np.ones(count, dtype=bool), arcs=NO_ARCS,
        feed=np.repeat(feed, each), held=state.commanded.held[True],
        elsewhere=state.commanded.elsewhere, shift=state.shift, passable=False, stays=False,
    )  # fmt: skip


def _places(
    lines: PlainText, first: int, last: int, index: NDArray[np.int64], behind: list[str], gap: str
) -> tuple[BlockPlaces, str]:
    """Where the text of the motions is, in that of the lines with what stands behind each motion of a hole after it,
    and then the second result: N and F of lines with other words than those of X and Y.

    N and F stand before the first motion, the line's own end and the text behind it behind the last.
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
    again = np.isfinite(lines.feed[index])
    again[np.searchsorted(index, lines.modes.of(first, last).line + first)] = True
    leads = [_lead(lines, line, gap) for line in index[again].tolist()]
    lead_ends = int(ends[-1]) + np.cumsum([len(text) for text in leads], dtype=np.int64)
    begin[again, 0], first_word[again, 0] = lead_ends - [len(text) for text in leads], lead_ends
    begin, first_word, last_word, after = (of.reshape(-1) for of in (begin, first_word, last_word, after))
    places = BlockPlaces(
        begin=begin, first=first_word, last=last_word, end=last_word, after=after, code=first_word, code_end=first_word
    )
    return places, "".join(leads)


def _lead(lines: PlainText, line: int, gap: str) -> str:
    """N and F of a line, as they are written before its first motion."""
    text, begin = lines.source[lines.starts[line] : lines.lead[line]].tobytes().decode("latin-1"), lines.feed_at[line]
    feed = lines.source[begin : lines.feed_end[line]].tobytes().decode("latin-1")
    number = _NUMBER.match(text)
    return gap.join(word for word in (number[1] if number else "", feed) if word)
