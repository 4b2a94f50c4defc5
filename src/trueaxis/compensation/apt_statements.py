"""Statements of an APT cutter location file: `MAJOR / minor, ...`, `$` continues, `$$` comments."""

import math
import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple

LONGEST = 100_000  # characters of one statement with its continuations

_MAJOR = re.compile(r"\s*([A-Za-z][A-Za-z0-9 _.]*?)\s*(?:/(.*))?\s*", re.DOTALL)
# free text follows these without a slash
_TEXT = re.compile(r"\s*(PARTNO|PPRINT|REMARK|INSERT|TLAXIS)\b\s*/?\s*(.*?)\s*", re.IGNORECASE | re.DOTALL)


_NUMBER = re.compile(r"[-+]?\d*+\.?([0-9]*+)(?:[EeDd]([-+]?\d{1,3}))?")


class Statement(NamedTuple):
    """line: first line of the statement; major: upper case, empty if there is none; minor: what follows the slash.

    comment: what stands behind `$$`, None if nothing does. problem: why it is no statement, else empty.
    """

    line: int
    major: str
    minor: tuple[str, ...]
    text: str
    comment: str | None = None
    problem: str = ""


def statements(lines: Iterable[str]) -> Iterator[Statement]:
    """Put continued lines together and take statements apart."""
    parts: list[str] = []
    first = 0
    comments: list[str] = []
    size = 0
    for number, line in enumerate(lines, 1):
        body, mark, comment = line.rstrip("\r\n").partition("$$")
        if mark:
            comments.append(comment.strip())
        body = body.rstrip()
        first = first or number
        goes_on = body.endswith("$")
        parts.append(body[:-1] if goes_on else body)
        size += len(parts[-1])
        if goes_on and size <= LONGEST:
            continue
        yield _statement(first, " ".join(parts), "; ".join(comments) if comments else None, size)
        parts, comments, first, size = [], [], 0, 0
    if parts:
        yield Statement(first, "", (), "", problem="the file ends within a statement continued by $")


def _statement(line: int, text: str, comment: str | None, size: int) -> Statement:
    if size > LONGEST:
        return Statement(line, "", (), "", comment, "the statement is longer than any this program reads")
    if not text.strip():
        return Statement(line, "", (), "", comment)
    free = _TEXT.fullmatch(text)
    if free:
        return Statement(line, free[1].upper(), (free[2],), text, comment)
    match = _MAJOR.fullmatch(text)
    if match is None or "$" in text:
        return Statement(line, "", (), text, comment, f"{text.strip()[:40]!r} is no statement")
    minor = tuple(part.strip() for part in match[2].split(",")) if match[2] is not None else ()
    return Statement(line, " ".join(match[1].upper().split()), minor, text, comment)


def decimals_of(number: str) -> int:
    """Digits after the decimal point of a number as a CL file writes it, `-1.25` or `1.25E-2`; none if it is none."""
    match = _NUMBER.fullmatch(number.strip())
    if match is None:
        return 0
    return max(0, len(match[1] or "") - int(match[2] or 0))


def number_of(word: str) -> float | None:
    """A number of a machine; None if it is none, or of more than 1e9."""
    try:
        value = float(word) if "_" not in word else math.nan
    except ValueError:
        return None
    return value if abs(value) <= 1e9 else None
