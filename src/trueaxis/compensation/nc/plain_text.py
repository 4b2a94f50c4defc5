"""The lines of a text that have only words that most blocks are made of, found and read all at once: N, codes of G,
axes and I J K R Q, with F before or behind these, then a comment; or, without axes and centres, M and S besides.

Bytes are sorted into classes; which classes may follow each other, and the order of letters, decides which lines are
such. The digits of a number make a whole number, exact in doubles, which is divided once by a power of ten: that rounds
as `float` does.
"""

import re
from collections.abc import Collection
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.dialects import is_marked
from trueaxis.compensation.machine import FloatArray
from trueaxis.compensation.nc.lexer import LARGEST, active_comment

LETTERS = "NGXYZABCIJKRQFSM"  # in the order of words
_DIGIT, _DOT, _SIGN, _BLANK, _RETURN, _NEWLINE, _N, _G, _X = range(1, 10)
_Q, _F, _S, _M = (_N + LETTERS.index(letter) for letter in "QFSM")
_CLASSES = ("0123456789", ".", "+-", " \t", "\r", "\n", *(letter + letter.lower() for letter in LETTERS))
_NUMBER, _SIZE = 9, 10  # of classes that may follow alike: letters of axes and centres, and F and S; M is as G
_LINE_END = {_RETURN, _NEWLINE}
_BEHIND = {_BLANK, _G, _NUMBER, _SIZE} | _LINE_END  # behind a number
_FOLLOWS: dict[int, set[int]] = {
    _NEWLINE: {_N} | _BEHIND,
    _N: {_DIGIT},
    _G: {_DIGIT},
    _NUMBER: {_SIGN, _DIGIT, _DOT, _BLANK},
    _SIZE: {_DIGIT, _DOT, _BLANK},
    _SIGN: {_DIGIT, _DOT},
    _DIGIT: {_DIGIT, _DOT} | _BEHIND,
    _DOT: {_DIGIT} | _BEHIND,
    _BLANK: {_N} | _BEHIND,
    _RETURN: {_NEWLINE},
}
_CLASS_OF = bytes(next((k for k, of in enumerate(_CLASSES, 1) if chr(byte) in of), 0) for byte in range(256))
_ALIKE_OF = bytes(k if k < _X else _NUMBER if k <= _Q else _G if k == _M else _SIZE for k in _CLASS_OF)
_MAY_FOLLOW = bytes(pair % 16 in _FOLLOWS.get(pair // 16, ()) for pair in range(256))
_MOST_DIGITS = np.array([0] * _N + [9, 2] + [15] * (_S - _G) + [2])  # by class; a whole number of 15 is a double
_MOST_DOTS = np.array([0] * _X + [1] * (_S - _G) + [0])
_POWERS = 10.0 ** np.arange(16)
_EIGHT = 8  # figures that are read at once, the first in the lowest byte
_LAST_OF_EIGHT = np.array([0] + [(1 << 64) - (1 << 8 * (_EIGHT - count)) for count in range(1, _EIGHT + 1)], np.uint64)
_JOINED = tuple(
    (np.uint64((base << shift) + 1), np.uint64(shift), np.uint64(mask))
    for base, shift, mask in ((10, 8, 0x00FF00FF00FF00FF), (100, 16, 0x0000FFFF0000FFFF), (10_000, 32, 0xFFFFFFFF))
)
_NO_FIGURES = bytes(byte for byte in range(256) if chr(byte) not in _CLASSES[_DIGIT - 1])
_MOTIONS = 4  # G0 to G3
_CODES = 100  # of two digits
_SEMICOLON = re.compile(r";[^\r\n]*+")
_COMMENT = re.compile(r"(?:\([^()\r\n]*+\)|;[^\r\n]*+)[ \t]*+(?=\r*\n)")


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class PlainText:
    """The lines of a text, n of them, and their words of axes and centres, m of all lines together.

    source: its bytes. starts: (n + 1,), where lines begin, and where the last ends. plain: (n,), whether a line is as
    said; of those: code: G0 to G3, -1 where it has none, in the source from code_at to code_end; feed: F, NaN where it
    has none, in the source from feed_at to feed_end; blank: whether there is a blank; returned: whether the line ends
    in CR LF; lead, tail: where the words of axes and centres begin and end.
    first: (n + 1,), at which of these words lines begin. Of the words, each (m,): line; letter, its place in LETTERS;
    value; decimals, digits behind the dot, -1 where there is none; place, end, in the source.
    modes, switches: other codes of G, and those of M.
    """

    source: NDArray[np.uint8]
    starts: NDArray[np.int64]
    plain: NDArray[np.bool_]
    code: NDArray[np.int64]
    code_at: NDArray[np.int64]
    code_end: NDArray[np.int64]
    feed: FloatArray
    feed_at: NDArray[np.int64]
    feed_end: NDArray[np.int64]
    blank: NDArray[np.bool_]
    returned: NDArray[np.bool_]
    lead: NDArray[np.int64]
    tail: NDArray[np.int64]
    first: NDArray[np.int64]
    line: NDArray[np.int64]
    letter: NDArray[np.int64]
    value: FloatArray
    decimals: NDArray[np.int64]
    place: NDArray[np.int64]
    end: NDArray[np.int64]
    modes: "Codes"
    switches: "Codes"


class Codes(NamedTuple):
    """Codes of one letter, k of them: lines, ascending, and their numbers, each (k,)."""

    line: NDArray[np.int64]
    number: NDArray[np.int64]

    def of(self, first: int, last: int) -> "Codes":
        """Those of some lines, from the first up to the last."""
        begin, end = np.searchsorted(self.line, [first, last])
        return Codes(self.line[begin:end] - first, self.number[begin:end])


class Marks(NamedTuple):
    """Line ends and letters, k of them: each begins what goes up to the next. Each (k,): place in the bytes; kind,
    class of the letter; line; and of the number behind it, of no use where it is none: where it begins, its value, and
    how many digits, dots, and digits behind the dot it has.
    """

    place: NDArray[np.int64]
    kind: NDArray[np.uint8]
    line: NDArray[np.int64]
    begin: NDArray[np.int64]
    value: FloatArray
    digits: NDArray[np.int64]
    dots: NDArray[np.int64]
    decimals: NDArray[np.int64]


def plain_text(
    text: str, undotted_mm: bool, parentheses: bool = True, modes: Collection[int] = (), switches: Collection[int] = ()
) -> PlainText:
    """Read a text; undotted_mm: whether a number of axes or centres without a decimal point counts mm (or inch), else
    a line with one is not plain; parentheses: whether they are comments, as what follows a semicolon is; modes,
    switches: which codes of G, besides those of motions, and of M a line may have.
    """
    signs = np.frombuffer(f"\n{text}\n".encode("latin-1"), dtype=np.uint8)
    bare = (_COMMENT if parentheses else _SEMICOLON).sub(_blanks, text) if "(" in text or ";" in text else text
    source = f"\n{bare}\n".encode("latin-1")  # the first line begins, and the last ends, as the others
    of = np.frombuffer(source.translate(_CLASS_OF), dtype=np.uint8)
    place = np.flatnonzero(of >= _NEWLINE)
    kind = of[place]
    ends = np.flatnonzero(kind == _NEWLINE)
    newline, line = place[ends], np.repeat(np.arange(ends.size), np.diff(ends, append=kind.size))
    marks = Marks(place, kind, line, *_numbers(source, of, place))
    words = np.flatnonzero((kind >= _X) & (kind <= _Q))
    each = np.bincount(line[words], minlength=ends.size)

    plain = np.ones(ends.size, dtype=bool)
    bad = _bad_words(marks, words, undotted_mm) | _bad_codes(marks, modes, switches)
    bad |= _misplaced(marks, each > 0)
    bad[ends] = False
    plain[line[bad]] = False
    alike = np.frombuffer(source.translate(_ALIKE_OF), dtype=np.uint8)
    follows = np.frombuffer((alike[:-1] * 16 + alike[1:]).tobytes().translate(_MAY_FOLLOW), dtype=np.bool_)
    behind = np.flatnonzero(~follows) + 1
    apart = marks.begin[
        (marks.begin > place + 1) & (kind >= _X) & (kind <= _S)
    ]  # numbers behind their letters and blanks
    plain[np.searchsorted(newline, behind[~np.isin(behind, apart)]) - 1] = False

    count = text.count("\n")
    first = np.concatenate([[0], np.cumsum(each)])
    begin = place[words]
    end = marks.begin[words] - 1 + (of[marks.begin[words]] == _SIGN) + marks.digits[words] + marks.dots[words]
    lead = tail = np.zeros(count, dtype=np.int64)
    if words.size:
        lead = begin[np.minimum(first[:count], words.size - 1)] - 1
        tail = end[first[1 : count + 1] - 1]
    blank = of == _BLANK if bare is text else (signs == ord(" ")) | (signs == ord("\t"))
    return PlainText(
        source=signs[1:-1], starts=newline[: count + 1], plain=plain[:count], **_of_lines(marks, ends.size),
        blank=np.logical_or.reduceat(blank, newline), returned=of[newline[1:] - 1] == _RETURN,
        lead=lead, tail=tail, first=first, line=line[words], letter=kind[words].astype(np.int64) - _N,
        value=marks.value[words], decimals=np.where(marks.dots[words] > 0, marks.decimals[words], -1),
        place=begin - 1, end=end,
    )  # fmt: skip


def _bad_words(marks: Marks, words: NDArray[np.int64], undotted_mm: bool) -> NDArray[np.bool_]:
    """Which numbers are none that a plain line may have; words: those of axes and centres."""
    kind, dots, value = marks.kind, marks.dots, marks.value
    bad = (marks.digits < 1) | (marks.digits > _MOST_DIGITS[kind]) | (dots > _MOST_DOTS[kind])
    bad |= np.abs(value) > LARGEST
    if not undotted_mm:
        bad[words] |= (dots[words] == 0) & (value[words] != 0.0)
    return bad


def _bad_codes(marks: Marks, modes: Collection[int], switches: Collection[int]) -> NDArray[np.bool_]:
    """Which codes are none that a plain line may have, or one too many."""
    kind, line = marks.kind, marks.line
    bad = np.zeros(kind.size, dtype=bool)
    for of, known in ((_G, (*range(_MOTIONS), *modes)), (_M, (*switches,))):
        codes = np.flatnonzero(kind == of)
        may = np.zeros(_CODES, dtype=bool)
        may[np.array(known, dtype=np.int64)] = True
        bad[codes] = ~may[np.clip(marks.value[codes], 0, _CODES - 1).astype(np.int64)]
    for single in ((kind == _G) & (marks.value < _MOTIONS), kind == _F, kind == _S):
        at = np.flatnonzero(single)
        bad[at[1:][line[at[1:]] == line[at[:-1]]]] = True
    return bad


def _misplaced(marks: Marks, moves: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Which words stand where no plain line has them; moves: whether a line has words of axes or centres."""
    kind, line = marks.kind, marks.line
    bad = np.zeros(kind.size, dtype=bool)
    aside = np.flatnonzero(kind >= _S)
    bad[aside[moves[line[aside]]]] = True
    back = 1 + np.flatnonzero((kind[1:] <= kind[:-1]) & (kind[1:] != _NEWLINE))
    if not back.size:
        return bad
    this, before = kind[back], kind[back - 1]
    word, at_rest = (this >= _X) & (this <= _Q), ~moves[line[back]]
    fine = ((this == _G) & (before == _G)) | (at_rest & np.isin(this, (_G, _S, _M)))
    fine |= word & (before <= _Q)  # once each
    fine |= word & (before == _F) & ((kind[back - 2] < _X) | (kind[back - 2] > _Q))  # F before all of them
    bad[back[~fine]] = True
    again = np.flatnonzero(np.isin(line, line[back[word]]) & (kind >= _X) & (kind <= _Q))
    _, first = np.unique(line[again] * np.int64(_CODES) + kind[again], return_index=True)
    bad[np.delete(again, first)] = True
    return bad


def _of_lines(marks: Marks, count: int) -> dict[str, Any]:
    """The codes and F of the lines, as in PlainText."""
    kind, line, number = marks.kind, marks.line, marks.value
    feeds, codes = np.flatnonzero(kind == _F), np.flatnonzero(kind == _G)
    motions = codes[number[codes] < _MOTIONS]
    feed, code = np.full(count, np.nan), np.full(count, -1)
    code_at, code_end, feed_at, feed_end = np.zeros((4, count), dtype=np.int64)
    feed[line[feeds]], code[line[motions]] = number[feeds], number[motions]
    code_at[line[motions]] = marks.place[motions] - 1
    code_end[line[motions]] = marks.place[motions] + marks.digits[motions]
    feed_at[line[feeds]] = marks.place[feeds] - 1
    feed_end[line[feeds]] = marks.begin[feeds] - 1 + marks.digits[feeds] + marks.dots[feeds]
    others = (codes[number[codes] >= _MOTIONS], np.flatnonzero(kind == _M))
    modes, switches = (Codes(line[at], number[at].astype(np.int64)) for at in others)
    return {
        "code": code, "code_at": code_at, "code_end": code_end, "feed": feed, "feed_at": feed_at, "feed_end": feed_end,
        "modes": modes, "switches": switches,
    }  # fmt: skip


def _blanks(comment: re.Match[str]) -> str:
    """As many blanks as a comment is long; one that is more than a comment stays."""
    text, line = comment[0], comment.string.rfind("\n", 0, comment.start()) + 1
    after_words = bool(comment.string[line : comment.start()].strip())
    return text if is_marked(text) or active_comment(text.rstrip(), after_words) else " " * len(text)


def _numbers(
    source: bytes, of: NDArray[np.uint8], marks: NDArray[np.int64]
) -> tuple[NDArray[np.int64], FloatArray, NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Of the numbers behind marks what Marks says of them: where they begin, and so on.

    of: classes of the bytes.
    """
    is_dot = of == _DOT
    # adding up between marks is three times as fast as over all bytes; bytes are faster than truth values, and int32
    # than int64
    digits, dots = (
        np.add.reduceat(is_it.view(np.uint8), marks, dtype=np.int32).astype(np.int64)
        for is_it in (of == _DIGIT, is_dot)
    )
    first = np.minimum(marks + 1, of.size - 1)
    apart = np.flatnonzero(of[first] == _BLANK)
    if apart.size:
        solid = np.flatnonzero(of != _BLANK)
        first[apart] = solid[np.searchsorted(solid, first[apart])]
    signed = of[first] == _SIGN
    owner = np.repeat(np.arange(marks.size), dots)
    decimals = np.zeros(marks.size, dtype=np.int64)
    decimals[owner] = (first + signed + digits + dots)[owner] - 1 - np.flatnonzero(is_dot)
    figures = np.frombuffer(source.translate(None, _NO_FIGURES), dtype=np.uint8)
    value = _whole_numbers(figures, np.cumsum(digits) - digits, digits)
    size = value / _POWERS[np.clip(decimals, 0, _POWERS.size - 1)]
    minus = np.frombuffer(source, dtype=np.uint8)[first] == ord("-")
    return first, np.where(minus, -size, size), digits, dots, decimals


def _whole_numbers(figures: NDArray[np.uint8], begin: NDArray[np.int64], count: NDArray[np.int64]) -> NDArray[np.int64]:
    """The numbers that `count` figures make from `begin` on; of no use where they are more than 16."""
    room = np.concatenate([np.full(_EIGHT, ord("0"), dtype=np.uint8), figures])
    # the eight figures before each place
    each = np.ndarray((figures.size + 1,), dtype="<u8", buffer=room, strides=(1,)).copy()
    end = begin + count
    value = _of_eight(each[end], np.minimum(count, _EIGHT))
    if count.max(initial=0) > _EIGHT:
        rest = np.maximum(count - _EIGHT, 0)
        value += 10**_EIGHT * _of_eight(each[begin + rest], np.minimum(rest, _EIGHT))
    return value


def _of_eight(figures: NDArray[np.uint64], count: NDArray[np.int64]) -> NDArray[np.int64]:
    """The number of the last `count` of eight figures, all at once: neighbours are joined, then pairs, then fours."""
    figures = figures & np.uint64(0x0F0F0F0F0F0F0F0F) & _LAST_OF_EIGHT[count]
    for factor, shift, mask in _JOINED:
        figures = ((figures * factor) >> shift) & mask
    return figures.astype(np.int64)
