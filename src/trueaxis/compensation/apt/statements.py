"""Statements of an APT cutter location file: `MAJOR / minor, ...`, `$` continues, `$$` comments; and post-processor
vocabulary: what moves nothing, as NC blocks, FEDRAT as an F word, M codes of blocks.
"""

import math
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import NamedTuple

from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.moves import STOP, TOOL_CHANGE, Notes
from trueaxis.compensation.nc import m_codes
from trueaxis.compensation.nc.state import CommandedAxes
from trueaxis.compensation.settings import MM_PER_INCH, Settings

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


# kept as comments in the written program, of no influence on positions
TEXT = frozenset({"PARTNO", "PPRINT", "REMARK", "TOOL PATH", "END-OF-PATH"})
IGNORED = TEXT | frozenset(
    "MACHIN TLDATA CUTTER INTOL OUTTOL TOLER PAINT DISPLY LINTOL SEQNO LEADER TMARK REWIND TOOLNO HEAD SELECT CLEARP "
    "SAFETY MODE OPSKIP DELAY DRAFT CHECK MULTAX TLAXIS MCHTOL MAXDPM MAXVEL CLRSRF PLABEL VTLAXIS PROTECT TPRINT AIR "
    "FLUSH CLDIST PITCH".split()
)
# faults, unless they say OFF
CAN_BE_OFF = frozenset({"CUTCOM", "CYCLE", "TLCOMP", "OFSTNO"})

# what moves or shifts positions in a way that is not followed
FAULTY = {
    "CYCLE": "is a canned cycle: its motions are not in the file",
    "TRANS": "shifts the positions",
    "ORIGIN": "shifts the positions",
    "TRACUT": "transforms the positions",
    "MATRIX": "defines a transformation",
    "COPY": "repeats motions transformed",
    "INDEX": "repeats motions transformed",
    "ROTATE": "turns a table or head",
    "ROTABL": "turns a table or head",
    "ROTHED": "turns a table or head",
    "CUTCOM": "shifts positions by a tool value that is not in the file",
    "TLCOMP": "shifts positions by a tool value that is not in the file",
    "OFSTNO": "shifts positions by a tool value that is not in the file",
    "GOHOME": "moves to a position that is not in the file",
    "RETRCT": "moves to a position that is not in the file",
    "PLUNGE": "moves to a position that is not in the file",
    "THREAD": "couples the feed to the spindle (thread)",
    "PREFUN": "inserts a preparatory function",
    "INSERT": "inserts NC text",
    "MACRO": "is a macro",
    "CALL": "calls a macro",
    "LOOPST": "is a loop",
    "LOOPND": "is a loop",
    "JUMPTO": "jumps",
    "IF": "is a condition",
    "GOFWD": "is a motion along surfaces, not a cutter location",
    "GOBACK": "is a motion along surfaces, not a cutter location",
    "GOLFT": "is a motion along surfaces, not a cutter location",
    "GORGT": "is a motion along surfaces, not a cutter location",
    "GOUP": "is a motion along surfaces, not a cutter location",
    "GODOWN": "is a motion along surfaces, not a cutter location",
    "TLON": "is a motion along surfaces, not a cutter location",
    "TLLFT": "is a motion along surfaces, not a cutter location",
    "TLRGT": "is a motion along surfaces, not a cutter location",
    "INDIRV": "is a motion along surfaces, not a cutter location",
    "INDIRP": "is a motion along surfaces, not a cutter location",
    "NURBS": "is a curve that is not followed",
    "POLY": "is a curve that is not followed",
    "COUPLE": "couples axes",
    "ARCSLP": "changes how circles are made",
}


# LinuxCNC acts on comments that begin like this
_ACTIVE = re.compile(r"[ \t]*\w+[ \t]*,")


def is_off(statement: Statement) -> bool:
    """Whether a statement says OFF and nothing else."""
    return tuple(word.upper() for word in statement.minor) == ("OFF",)


def changes_nothing(system: Sequence[float]) -> bool:
    """Whether the numbers of MSYS or CSYS are those of a system that is neither turned nor shifted."""
    neutral = {9: (0, 0, 0, 1, 0, 0, 0, 1, 0), 12: (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0)}
    return tuple(system) == neutral.get(len(system))


def comment(text: str) -> str:
    """An NC comment, its brackets taken out so that it stays one, and made no command of a control (LinuxCNC)."""
    clean = text.replace("(", "[").replace(")", "]")
    if _ACTIVE.match(clean):
        clean = f"- {clean}"
    return f"({''.join(sign if sign.isprintable() else '?' for sign in clean)})"


def whole_number(text: str) -> int | None:
    """A whole number from 0 to 999999, or None."""
    try:
        value = float(text)
    except ValueError:
        return None
    return int(value) if value == value // 1 and 0 <= value <= 999_999 else None


def _tool(statement: Statement) -> str | None:
    for word in statement.minor:
        number = whole_number(word)
        if number is not None:
            return f"T{number} M6"
    return None


def _spindle(statement: Statement) -> str | None:
    words = [word.upper() for word in statement.minor]
    if "OFF" in words:
        return "M5"
    speed = next((number for word in words if (number := whole_number(word)) is not None), None)
    turn = "M4" if "CCLW" in words else "M3"
    if speed is None:
        return turn if not words or set(words) <= {"ON", "CLW", "CCLW"} else None
    return f"S{speed} {turn}"


def _coolant(statement: Statement) -> str | None:
    words = {word.upper() for word in statement.minor}
    return "M9" if "OFF" in words else "M7" if "MIST" in words else "M8"


def _auxiliary(statement: Statement) -> str | None:
    number = whole_number(statement.minor[0]) if statement.minor else None
    return None if number is None else f"M{number}"


# statements that become words; None from the function: the statement cannot be understood
BLOCKS: dict[str, Callable[[Statement], str | None]] = {
    "LOADTL": _tool,
    "SPINDL": _spindle,
    "COOLNT": _coolant,
    "AUXFUN": _auxiliary,
    "STOP": lambda _: "M0",
    "OPSTOP": lambda _: "M1",
}


_PER_MINUTE = {"MMPM": False, "PERMIN": None, "IPM": True}
_PER_TURN = {"MMPR": False, "PERREV": None, "IPR": True}


class Feed(NamedTuple):
    """mode: G94 or G95; word: the F word; per_minute: mm/min, NaN where it counts by turns."""

    mode: str
    word: str
    per_minute: float


def feed_of(words: Sequence[str], inch: bool) -> Feed | None:
    """The feed of FEDRAT's words (upper case) in a program in inches or mm; None if they make none."""
    numbers = [word for word in words if word[:1] in "+-.0123456789" and word]
    units = [word for word in words if word not in numbers]
    unit = units[0] if len(units) == 1 else "PERMIN" if not units else ""
    table = {**_PER_MINUTE, **_PER_TURN}
    value = number_of(numbers[0]) if len(numbers) == 1 else None
    if value is None or unit not in table or value <= 0:
        return None
    of_inch = table[unit]
    if of_inch is not None and of_inch != inch:
        value *= MM_PER_INCH if of_inch else 1.0 / MM_PER_INCH
    turns = unit in _PER_TURN
    per_minute = math.nan if turns else value * (MM_PER_INCH if inch else 1.0)
    word = f"F{value:.4f}".rstrip("0").rstrip(".")
    return None if word == "F0" else Feed("G95" if turns else "G94", word, per_minute)


_M_CODE = re.compile(r"\bM(\d+)\b")


def follow_codes(
    block: str, line: int, commanded: CommandedAxes, settings: Settings, faults: FaultLog, notes: Notes
) -> bool:
    """Follow the M codes of a block; returns whether one ends the program."""
    given = [int(code) for code in _M_CODE.findall(block)]
    for code in given:
        if problem := m_codes.problem_of(code, settings.pass_m, settings.dialect):
            faults.add(line, *problem)
        elif m_codes.vouched_for(code, settings.pass_m):
            notes.pass_code(line, code)
        elif code == m_codes.TOOL_CHANGE:
            notes.add(line, TOOL_CHANGE)
            commanded.displace()
        elif code in m_codes.STOPS:
            notes.add(line, STOP)
            commanded.stop()
    return not m_codes.END.isdisjoint(given)
