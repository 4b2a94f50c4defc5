"""The mark of a compensated program: a second compensation would double every correction."""

import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from trueaxis.compensation.dialects import BYTE_ORDER_MARK
from trueaxis.compensation.fault_log import FaultLog
from trueaxis.compensation.settings import Dialect

# capitals and no sign but a blank: older controls take no other in a comment
MARK = "TRUEAXIS COMPENSATED"
COMPENSATED_ALREADY = ("this program is compensated already", "compensate the original program")
# what must stay first: a byte order mark, blank lines, %, the program's number, Siemens' path in the second line, and
# BEGIN PGM of Heidenhain
_HEAD = re.compile(
    r"(?:\xef\xbb\xbf)?"
    r"(?:[ \t]*+(?:%[^\r\n]*+|[O:o][ \t]*+\d[^\r\n]*+|;\$PATH[^\r\n]*+|(?:\d++[ \t]++)?BEGIN PGM[^\r\n]*+)?\r*+\n)*"
)
_HEAD_BYTES = 65536
_SEMICOLON = frozenset({".mpf", ".spf", ".i"})  # extensions of Siemens and Heidenhain, where ( ) is no comment


def comment_of(program: Path, dialect: Dialect | None) -> str:
    """The mark as a comment of the program's own kind: `;` where the control or the program has no other.

    Raises OSError when the file cannot be read.
    """
    head = b""
    if program.is_file():  # a pipe can be read only once
        with program.open("rb") as file:
            head = file.read(_HEAD_BYTES)
    semicolon = dialect in {"siemens", "heidenhain"} or (
        dialect is None and b"(" not in head and (b";" in head or program.suffix.lower() in _SEMICOLON)
    )
    return f"; {MARK}" if semicolon else f"({MARK})"


def is_marked(line: str) -> bool:
    """Whether a line holds the mark, in capitals or not: an editor may have changed them."""
    return MARK in line.upper()


def unmarked(lines: Iterable[str], faults: FaultLog) -> Iterator[str]:
    """The lines as they are; one that holds the mark is a fault."""
    for number, line in enumerate(lines, 1):
        if is_marked(line):
            faults.add(number, *COMPENSATED_ALREADY)
        yield line


def marked(pieces: Iterable[str], comment: str) -> Iterator[str]:
    """The program in pieces of whole lines, with the mark in a line of its own before the first that may come later."""
    placed = False
    for piece in pieces:
        match = None if placed else _HEAD.match(piece)
        if match is None or match.end() == len(piece):
            yield piece
            continue
        placed, end = True, match.end()
        if piece.startswith(BYTE_ORDER_MARK, end):
            end += len(BYTE_ORDER_MARK)
        ending = re.search(r"\r*\n", piece)
        yield f"{piece[:end]}{comment}{ending[0] if ending else chr(10)}{piece[end:]}"
