"""The lines of a text that have only words that most blocks are made of, found and read all at once: N, one of G0 to
G3, axes, I J K R and F, in this order, then a comment.

Bytes are sorted into classes; which classes may follow each other, and the order of letters, decides which lines are
such. The digits of a number are added up to a whole number, exact in doubles, and divided once by a power of ten: that
rounds as `float` does.
"""

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.dialects import is_marked
from trueaxis.compensation.machine import FloatArray
from trueaxis.compensation.nc_lexer import LARGEST, active_comment

LETTERS = "NGXYZABCIJKRF"  # in the order of words
_DIGIT, _DOT, _SIGN, _BLANK, _RETURN, _NEWLINE, _N, _G, _X = range(1, 10)
_I, _R, _F = (_N + LETTERS.index(letter) for letter in "IRF")
_CLASSES = ("0123456789", ".", "+-", " \t", "\r", "\n", *(letter + letter.lower() for letter in LETTERS))
_NUMBER, _FEED = 9, 10  # of classes that may follow alike: letters of axes and centres, and F
_LINE_END = {_RETURN, _NEWLINE}
_BEHIND = {_BLANK, _G, _NUMBER, _FEED} | _LINE_END  # behind a number
_FOLLOWS: dict[int, set[int]] = {
    _NEWLINE: {_N} | _BEHIND,
    _N: {_DIGIT},
    _G: {_DIGIT},
    _NUMBER: {_SIGN, _DIGIT, _DOT},
    _FEED: {_DIGIT, _DOT},
    _SIGN: {_DIGIT, _DOT},
    _DIGIT: {_DIGIT, _DOT} | _BEHIND,
    _DOT: {_DIGIT} | _BEHIND,
    _BLANK: {_N} | _BEHIND,
    _RETURN: {_NEWLINE},
}
_CLASS_OF = bytes(next((k for k, of in enumerate(_CLASSES, 1) if chr(byte) in of), 0) for byte in range(256))
_ALIKE_OF = bytes(k if k < _X else _FEED if k == _F else _NUMBER for k in _CLASS_OF)
_MAY_FOLLOW = bytes(pair % 16 in _FOLLOWS.get(pair // 16, ()) for pair in range(256))
_MOST_DIGITS = np.array([0] * _N + [9, 2] + [15] * (_F - _G))  # by class; a whole number of 15 is a double
_MOST_DOTS = np.array([0] * _X + [1] * (_F - _G))
_POWERS = 10.0 ** np.arange(16)
_MOTIONS = 3.0  # G0 to G3
_SEMICOLON = re.compile(r";[^\r\n]*+")
_COMMENT = re.compile(r"(?:\([^()\r\n]*+\)|;[^\r\n]*+)[ \t]*+(?=\r*\n)")


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class PlainText:
    """The lines of a text, n of them, and their words of axes and centres, m of all lines together.

    source: its bytes. starts: (n + 1,), where lines begin, and where the last ends. plain: (n,), whether a line is as
    said; of those: code: G, -1 where it has none, in the source from code_at to code_end; feed: F, NaN where it has
    none; blank: whether there is a blank; returned: whether the line ends in CR LF; lead, tail: where the words of axes
    and centres begin and end.
    first: (n + 1,), at which of these words lines begin. Of the words, each (m,): line; letter, its place in LETTERS;
    value; decimals, digits behind the dot, -1 where there is none; place, end, in the source.
    """

    source: NDArray[np.uint8]
    starts: NDArray[np.int64]
    plain: NDArray[np.bool_]
    code: NDArray[np.int64]
    code_at: NDArray[np.int64]
    code_end: NDArray[np.int64]
    feed: FloatArray
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


def plain_text(text: str, undotted_mm: bool, parentheses: bool = True) -> PlainText:
    """Read a text; undotted_mm: whether a number of axes or centres without a decimal point counts mm (or inch), else
    a line with one is not plain; parentheses: whether they are comments, as what follows a semicolon is.
    """
    signs = np.frombuffer(f"\n{text}\n".encode("latin-1"), dtype=np.uint8)
    bare = (_COMMENT if parentheses else _SEMICOLON).sub(_blanks, text) if "(" in text or ";" in text else text
    source = f"\n{bare}\n".encode("latin-1")  # the first line begins, and the last ends, as the others
    of = np.frombuffer(source.translate(_CLASS_OF), dtype=np.uint8)
    marks = np.flatnonzero(of >= _NEWLINE)  # line ends and letters: each begins what goes up to the next
    kind = of[marks]
    ends = np.flatnonzero(kind == _NEWLINE)
    newline, line = marks[ends], np.repeat(np.arange(ends.size), np.diff(ends, append=kind.size))
    value, digits, dots, decimals = _numbers(signs, of, marks)

    bad = (digits < 1) | (digits > _MOST_DIGITS[kind]) | (dots > _MOST_DOTS[kind]) | ((kind == _G) & (value > _MOTIONS))
    bad |= np.abs(value) > LARGEST
    bad[1:] |= kind[1:] <= kind[:-1]
    words = np.flatnonzero((kind >= _X) & (kind <= _R))
    if not undotted_mm:
        bad[words] |= (dots[words] == 0) & (value[words] != 0.0)
    bad[ends] = False
    plain = np.ones(ends.size, dtype=bool)
    plain[line[bad]] = False
    alike = np.frombuffer(source.translate(_ALIKE_OF), dtype=np.uint8)
    follows = np.frombuffer((alike[:-1] * 16 + alike[1:]).tobytes().translate(_MAY_FOLLOW), dtype=np.bool_)
    plain[np.searchsorted(newline, np.flatnonzero(~follows) + 1) - 1] = False

    count = text.count("\n")
    starts = newline[: count + 1]
    codes, feeds = np.flatnonzero(kind == _G), np.flatnonzero(kind == _F)
    code, feed = np.full(ends.size, -1), np.full(ends.size, np.nan)
    code_at, code_end = np.zeros((2, ends.size), dtype=np.int64)
    code[line[codes]], feed[line[feeds]] = value[codes], value[feeds]
    code_at[line[codes]], code_end[line[codes]] = marks[codes] - 1, marks[codes] + digits[codes]
    first = np.concatenate([[0], np.cumsum(np.bincount(line[words], minlength=ends.size))])
    place = marks[words]
    end = place + (of[place + 1] == _SIGN) + digits[words] + dots[words]
    lead = tail = np.zeros(count, dtype=np.int64)
    if words.size:
        lead = place[np.minimum(first[:count], words.size - 1)] - 1
        tail = end[first[1 : count + 1] - 1]
    blank = of == _BLANK if bare is text else (signs == ord(" ")) | (signs == ord("\t"))
    return PlainText(
        source=signs[1:-1], starts=starts, plain=plain[:count], code=code, code_at=code_at, code_end=code_end,
        feed=feed, blank=np.logical_or.reduceat(blank, newline), returned=of[newline[1:] - 1] == _RETURN,
        lead=lead, tail=tail, first=first, line=line[words], letter=kind[words].astype(np.int64) - _N,
        value=value[words], decimals=np.where(dots[words] > 0, decimals[words], -1), place=place - 1, end=end,
    )  # fmt: skip


def _blanks(comment: re.Match[str]) -> str:
    """As many blanks as a comment is long; one that is more than a comment stays."""
    text, line = comment[0], comment.string.rfind("\n", 0, comment.start()) + 1
    after_words = bool(comment.string[line : comment.start()].strip())
    return text if is_marked(text) or active_comment(text.rstrip(), after_words) else " " * len(text)


def _numbers(
    signs: NDArray[np.uint8], of: NDArray[np.uint8], marks: NDArray[np.int64]
) -> tuple[FloatArray, NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """The number behind each mark, how many digits it has, how many dots, and how many digits behind the dot; of no use
    where it is none.

    signs: all bytes; of: their classes.
    """
    is_digit = of == _DIGIT
    before = np.cumsum(is_digit, dtype=np.int32)
    digits = np.diff(before[marks], append=before[-1:])
    place = np.flatnonzero(is_digit)
    last = np.repeat(before[marks] + digits, digits)
    behind = last - np.arange(1, place.size + 1, dtype=np.int32)  # digits of the same number
    shares = (signs[place] - ord("0")) * _POWERS[np.minimum(behind, 15)]
    value, numbers = np.zeros(marks.size), np.flatnonzero(digits)
    if numbers.size:
        value[numbers] = np.add.reduceat(shares, before[marks[numbers]])
    dot = np.flatnonzero(of == _DOT)
    owner = np.searchsorted(marks, dot) - 1
    dots = np.bincount(owner, minlength=marks.size)
    decimals = np.zeros(marks.size, dtype=np.int64)
    decimals[owner] = (before[marks] + digits)[owner] - before[dot]
    value[owner] /= _POWERS[np.minimum(decimals[owner], 15)]
    minus = signs[np.minimum(marks + 1, signs.size - 1)] == ord("-")
    return np.where(minus, -value, value), digits.astype(np.int64), dots, decimals
