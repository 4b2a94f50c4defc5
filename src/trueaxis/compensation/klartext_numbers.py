"""Block numbers of Klartext programs that have become longer."""

import re
from collections.abc import Iterable, Iterator

from trueaxis.compensation.mark import MARK

_NUMBER = re.compile(r"([ \t]*+)(\d{1,9}+)(?=[ \t])")
_MARKED = re.compile(rf"[ \t]*;[ \t]*{MARK}")


def numbered(pieces: Iterable[str]) -> Iterator[str]:
    """The program with block numbers that rise: each is kept where it can be. Labels, not numbers, are what calls name,
    so a new number changes nothing. Blocks that have none get none.
    """
    last, goes_on = -1, False
    for piece in pieces:
        lines = piece.splitlines(keepends=True)
        for index, line in enumerate(lines):
            match = None if goes_on else _NUMBER.match(line)
            goes_on = line.rstrip().endswith("~")
            if match is not None:
                last = max(int(match[2]), last + 1)
                lines[index] = f"{match[1]}{last}{line[match.end() :]}"
            elif last >= 0 and _MARKED.match(line):
                last += 1
                lines[index] = f"{last} {line.lstrip()}"
        yield "".join(lines)
