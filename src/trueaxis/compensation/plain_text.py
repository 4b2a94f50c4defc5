"""The lines of a text that are N, G0 or G1, X Y Z and F alone, in this order, found and read all at once.

Bytes are sorted into classes; which classes may follow each other, and the order of letters, decides which lines are
such. The digits of a number are added up to a whole number, exact in doubles, and divided once by a power of ten: that
rounds as `float` does.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import FloatArray

_CLASSES = ("0123456789", ".", "+-", " ", "\r", "\n", "N", "G", "X", "Y", "Z", "F")  # letters in the order of words
_DIGIT, _DOT, _SIGN, _BLANK, _RETURN, _NEWLINE, _N, _G, _X, _Y, _Z, _F = range(1, 13)
_AXES, _LINE_END = {_X, _Y, _Z}, {_RETURN, _NEWLINE}
_FOLLOWS: dict[int, set[int]] = {
    _NEWLINE: {_N, _G} | _AXES,
    _N: {_DIGIT},
    _G: {_DIGIT},
    **{axis: {_SIGN, _DIGIT, _DOT} for axis in _AXES},
    _F: {_DIGIT, _DOT},
    _SIGN: {_DIGIT, _DOT},
    _DIGIT: {_DIGIT, _DOT, _BLANK, _G, _F} | _AXES | _LINE_END,
    _DOT: {_DIGIT, _BLANK, _F} | _AXES | _LINE_END,
    _BLANK: {_BLANK, _G, _F} | _AXES | _LINE_END,
    _RETURN: {_NEWLINE},
}
_CLASS_OF = bytes(next((k for k, of in enumerate(_CLASSES, 1) if chr(byte) in of), 0) for byte in range(256))
_MAY_FOLLOW = bytes(pair % 16 in _FOLLOWS.get(pair // 16, ()) for pair in range(256))
_MOST_DIGITS = np.array([0] * _N + [9, 2, 15, 15, 15, 15])  # by class; a whole number of 15 is a double
_MOST_DOTS = np.array([0] * _X + [1, 1, 1, 1])
_POWERS = 10.0 ** np.arange(16)


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class PlainText:
    """The lines of a text, n of them, and their words X Y Z, m of all lines together.

    source: its bytes. starts: (n + 1,), where lines begin, and where the last ends. plain: (n,), whether a line is as
    said; of those: code: G, -1 where it has none; feed: F, NaN where it has none; words: (n,), how many of X Y Z;
    spaced: whether there is a blank; returned: whether the line ends in CR LF; lead, tail: characters before the first
    and after the last of X Y Z, without the line end.
    first: (n + 1,), at which of the words X Y Z lines begin; axis: (m,), 0 to 2; value: (m,); place: (m,), of the
    letter in the source.
    """

    source: NDArray[np.uint8]
    starts: NDArray[np.int64]
    plain: NDArray[np.bool_]
    code: NDArray[np.int64]
    feed: FloatArray
    words: NDArray[np.int64]
    spaced: NDArray[np.bool_]
    returned: NDArray[np.bool_]
    lead: NDArray[np.int64]
    tail: NDArray[np.int64]
    first: NDArray[np.int64]
    axis: NDArray[np.uint8]
    value: FloatArray
    place: NDArray[np.int64]


def plain_text(text: str, undotted_mm: bool) -> PlainText:
    """Read a text; undotted_mm: whether a number of X Y Z without a decimal point counts mm (or inch), else a line with
    one is not plain.
    """
    source = f"\n{text}\n".encode("latin-1")  # the first line begins, and the last ends, as the others
    of = np.frombuffer(source.translate(_CLASS_OF), dtype=np.uint8)
    marks = np.flatnonzero(of >= _NEWLINE)  # line ends and letters: each begins what goes up to the next
    kind = of[marks]
    ends = np.flatnonzero(kind == _NEWLINE)
    newline, line = marks[ends], np.repeat(np.arange(ends.size), np.diff(ends, append=kind.size))
    signs = np.frombuffer(source, dtype=np.uint8)
    value, digits, dots = _numbers(signs, of, marks)

    bad = (digits < 1) | (digits > _MOST_DIGITS[kind]) | (dots > _MOST_DOTS[kind]) | ((kind == _G) & (value > 1.0))
    bad[1:] |= kind[1:] <= kind[:-1]
    axes = np.flatnonzero((kind >= _X) & (kind <= _Z))
    if not undotted_mm:
        bad[axes] |= (dots[axes] == 0) & (value[axes] != 0.0)
    bad[ends] = False
    words = np.bincount(line[axes], minlength=ends.size)
    plain = words > 0
    plain[line[bad]] = False
    follows = np.frombuffer((of[:-1] * 16 + of[1:]).tobytes().translate(_MAY_FOLLOW), dtype=np.bool_)
    plain[np.searchsorted(newline, np.flatnonzero(~follows) + 1) - 1] = False

    count = text.count("\n")
    first = np.concatenate([[0], np.cumsum(words)])
    code, feed = np.full(ends.size, -1), np.full(ends.size, np.nan)
    for letter, values in ((_G, code), (_F, feed)):
        these = np.flatnonzero(kind == letter)
        values[line[these]] = value[these]
    returned = of[newline[1:] - 1] == _RETURN
    lead = tail = np.zeros(count, dtype=np.int64)
    if axes.size:
        begin = axes[np.minimum(first[:count], axes.size - 1)]
        last = axes[first[1 : count + 1] - 1]
        lead = marks[begin] - newline[:count] - 1
        number_end = marks[last] + 1 + (of[marks[last] + 1] == _SIGN) + digits[last] + dots[last]
        tail = newline[1 : count + 1] - returned[:count] - number_end
    return PlainText(
        source=signs[1:-1], starts=newline[: count + 1], plain=plain[:count], code=code, feed=feed, words=words,
        spaced=np.logical_or.reduceat(of == _BLANK, newline), returned=returned, lead=lead, tail=tail,
        first=first, axis=kind[axes] - _X, value=value[axes], place=marks[axes] - 1,
    )  # fmt: skip


def _numbers(
    signs: NDArray[np.uint8], of: NDArray[np.uint8], marks: NDArray[np.int64]
) -> tuple[FloatArray, NDArray[np.int64], NDArray[np.int64]]:
    """The number behind each mark, how many digits it has and how many dots; of no use where it is none.

    signs: all bytes; of: their classes.
    """
    is_digit = of == _DIGIT
    before = np.cumsum(is_digit, dtype=np.int32)
    digits = np.diff(before[marks], append=before[-1:])
    place = np.flatnonzero(is_digit)
    behind = np.repeat(before[marks] + digits, digits) - np.arange(1, place.size + 1)  # digits of the same number
    owner = np.repeat(np.arange(marks.size), digits)
    shares = (signs[place] - ord("0")) * _POWERS[np.minimum(behind, 15)]
    value = np.bincount(owner, shares, minlength=marks.size).astype(np.float64)  # whole ones where there are none
    dot = np.flatnonzero(of == _DOT)
    owner = np.searchsorted(marks, dot) - 1
    dots = np.bincount(owner, minlength=marks.size)
    value[owner] /= _POWERS[np.minimum((before[marks] + digits)[owner] - before[dot], 15)]
    minus = signs[np.minimum(marks + 1, signs.size - 1)] == ord("-")
    return np.where(minus, -value, value), digits.astype(np.int64), dots
