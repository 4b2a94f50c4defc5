"""What stands before the first % of a program: Fanuc and the like do not read it, LinuxCNC reads it as blocks."""

import re
from collections.abc import Sequence

from trueaxis.compensation.dialects import BYTE_ORDER_MARK, COMPENSATED_ALREADY, is_marked
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.moves import Notes
from trueaxis.compensation.nc.lexer import lex
from trueaxis.compensation.settings import Dialect

_MARK = re.compile(r"[ \t]*+%")
_BLOCK = re.compile(r"[ \t]*+(?:[#/\[]|(?i:IF|WHILE|GOTO|DO|END)\b)")  # of a macro, or for a switch
_MOST_LINES = 200  # a header of a CAM system has fewer
_READ_BY: tuple[Dialect | None, ...] = (None, "fanuc", "linuxcnc")  # % begins a program's name on the others
PASSED = "text before the first % is left as it is: Fanuc and the like begin to read behind it, LinuxCNC refuses it"


def leader_of(text: str, dialect: Dialect | None) -> list[str]:
    """The lines before the first % of a program that begins with this text; none if there is a block among them, as
    where % only ends a program.
    """
    lines = text.removeprefix(BYTE_ORDER_MARK).split("\n", _MOST_LINES)[:_MOST_LINES]
    first = next((number for number, line in enumerate(lines) if _MARK.match(line)), 0)
    if dialect not in _READ_BY or any(_BLOCK.match(line) or lex(line.strip()).words for line in lines[:first]):
        return []
    return text.split("\n", first)[:first]


def take_leader(leader: Sequence[str], dialect: Dialect | None, faults: FaultLog, notes: Notes) -> None:
    """Notes and faults of these lines."""
    said = [number for number, line in enumerate(leader, 1) if line.strip()]
    for number in said:
        if is_marked(leader[number - 1]):
            faults.add(number, *COMPENSATED_ALREADY)
    if said and dialect == "linuxcnc":
        faults.add(len(leader) + 1, "% behind other lines, which LinuxCNC refuses", "% in the first line, or none")
    elif wrong := [number for number in said if lex(leader[number - 1].strip()).problem]:
        notes.add(wrong[0], PASSED, len(wrong))
