"""One block of a SINUMERIK program (840D, 828D, 808D) as words: `X=10.5`, `CR=5`, `X=AC(10)`, and what its keywords and
calls do to positions.
"""

import re
from typing import NamedTuple

from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc import m_codes
from trueaxis.compensation.nc.drilling_call import (
    DRILLING,
    END_OF_CALLS,
    MODAL,
    CallError,
    drilling_call,
)
from trueaxis.compensation.nc.lexer import (
    LARGEST,
    NUMBER,
    Block,
    Meaning,
    Word,
    beyond,
    decimals_of,
)
from trueaxis.compensation.nc.mistyped import Mistyped, mistyped
from trueaxis.compensation.nc.rotary_ways import WAYS, problems_of

_BLANK = re.compile(r"[ \t]++")
_COMMENT = re.compile(r";.*+")
_LABEL = re.compile(r"[A-Za-z_][A-Za-z0-9_]++:(?!=)[ \t]*+")
_WAY = re.compile(rf"([XYZABCIJK])[ \t]*+=[ \t]*+(AC|IC|DC|ACP|ACN)[ \t]*+\([ \t]*+({NUMBER})[ \t]*+\)", re.IGNORECASE)
_ASSIGNED = re.compile(rf"(CR|[XYZABCIJKFSTDMN])[ \t]*+=[ \t]*+({NUMBER})(?![\w(*/+.$-])", re.IGNORECASE)
_SPINDLE = re.compile(r"[MS][0-9]{1,2}[ \t]*+=[ \t]*+([0-9]++(?:\.[0-9]*+)?)(?![\w(*/+.$-])", re.IGNORECASE)
_TOOL_NAME = re.compile(r'T[ \t]*+=[ \t]*+"([^"]*+)"', re.IGNORECASE)
_PLAIN = re.compile(rf"([A-Za-z])[ \t]*+({NUMBER})(?![ \t]*+=)")
_KEYWORD = re.compile(r"[A-Za-z_][A-Za-z0-9_]*+")
_ARGUMENTS = re.compile(r"[ \t]*+\([^()\"]*+(?:\"[^\"]*+\"[^()\"]*+)*\)")
_SUBPROGRAM = re.compile(r"(L[0-9]{1,7}+)(?:[ \t]*+P[ \t]*+=?[ \t]*+[0-9]++)?(?![ \t]*+[=.])", re.IGNORECASE)
_ADIS = re.compile(rf"(?:ADIS|ADISPOS)[ \t]*+=[ \t]*+{NUMBER}", re.IGNORECASE)
_DEFINITION = re.compile(
    r"DEF[ \t]++(?:REAL|INT|BOOL|CHAR|AXIS|FRAME|STRING[ \t]*+\[[ \t]*+\d++[ \t]*+\])[ \t]++"
    r"[A-Za-z_]\w++[ \t]*+(?:=[ \t]*+[^;,]*+)?(?:,[ \t]*+[A-Za-z_]\w++[ \t]*+(?:=[ \t]*+[^;,]*+)?)*(?=;|$)",
    re.IGNORECASE,
)
_SPINDLE_TURNS = re.compile(
    rf"SPOSA?[ \t]*+(?:\[[ \t]*+\d++[ \t]*+\])?[ \t]*+=[ \t]*+"
    rf"(?:{NUMBER}|(?:AC|IC|DC|ACP|ACN)[ \t]*+\([ \t]*+{NUMBER}[ \t]*+\))(?![\w(*/+.$-])",
    re.IGNORECASE,
)
_STATEMENT = re.compile(r"(?:R[0-9]++|\$\w++|[A-Za-z_]\w*+)[ \t]*+(?:\[[^\]]*+\])?[ \t]*+=")

# a spindle's speed and direction: no axis; what a word with another spindle's number may say
_SPINDLE_CODES = frozenset({"3", "4", "5", "03", "04", "05"})
INCREMENTAL_WAY = "IC"
TOOL_BY_NAME = "T="


class Function(NamedTuple):
    """A keyword or call in a block, in capitals; arguments: the text in its parentheses, None without any."""

    name: str
    arguments: str | None


class SiemensBlock(NamedTuple):
    """words: as of a `Block`; functions: keywords and calls; ways: AC, IC, DC, ACP or ACN of words."""

    block: Block
    functions: tuple[Function, ...]
    ways: dict[str, str]

    @property
    def problem(self) -> str:
        """That of its words."""
        return self.block.problem

    @property
    def mended(self) -> str:
        """The text with a mistyped number put right."""
        return self.block.mended


def lex_siemens(body: str, begin: int = 0) -> SiemensBlock:
    """Words, keywords and calls of a block; `body` has no line end, reading begins at `begin`."""
    words: list[Word] = []
    functions: list[Function] = []
    ways: dict[str, str] = {}
    place = begin
    problem = mended = ""
    while place < len(body) and not problem:
        if passed := _passed(body, place, not functions and all(word.letter == "N" for word in words)):
            place = passed.end()
        elif not functions and (label := _LABEL.match(body, place)):
            place = label.end()
        elif called := _call(body, place):
            functions.append(called[0])
            place = called[1]
        elif (number := _WAY.match(body, place)) and abs(float(number[3])) > LARGEST:
            problem = beyond(number[1], number[3])
        elif way := _WAY.match(body, place):
            ways[way[1].upper()] = way[2].upper()
            words.append(_word(way[1], way[3], place, way.end()))
            place = way.end()
        elif found := _ASSIGNED.match(body, place) or _PLAIN.match(body, place):
            if abs(float(found[2])) > LARGEST:
                problem = beyond(found[1], found[2])
                break
            words.append(_word("R" if found[1].upper() == "CR" else found[1], found[2], place, found.end()))
            if found[1].upper() == "R":
                problem = f"column {place + 1}: R is a parameter on SINUMERIK; the radius of an arc is CR="
            place = found.end()
        elif (spindle := _SPINDLE.match(body, place)) and (body[place] in "Ss" or spindle[1] in _SPINDLE_CODES):
            place = spindle.end()
        elif wrong := _no_word(body, place):
            problem, mended = f"column {place + 1}: {wrong.problem}", wrong.mended
        elif keyword := _KEYWORD.match(body, place):
            name, arguments = keyword[0].upper(), _ARGUMENTS.match(body, keyword.end())
            functions.append(Function(name, arguments[0].strip() if arguments else None))
            place = arguments.end() if arguments else keyword.end()
            place = len(body) if name in _BRANCHES else place  # the rest is on which condition, and where to
    return SiemensBlock(Block(tuple(words), problem, mended=mended), tuple(functions), ways)


def _passed(body: str, place: int, first: bool) -> re.Match[str] | None:
    """What says nothing of where the axes go: blanks, comments, rounding, where a spindle stops, and, first in a block,
    the declaration of variables: what uses one is no number, and a fault where it stands.
    """
    patterns = (_BLANK, _COMMENT, _ADIS, _SPINDLE_TURNS, *([_DEFINITION] if first else []))
    return next((match for pattern in patterns if (match := pattern.match(body, place))), None)


def _no_word(body: str, place: int) -> Mistyped | None:
    """What is wrong with what stands there; None where it is a keyword."""
    if slip := mistyped(body, place):
        return slip
    statement = _STATEMENT.match(body, place)
    if statement is None and _KEYWORD.match(body, place):
        return None
    what = _ASSIGNED_WORDS.get(statement[0].rstrip("= \t").upper()) if statement else None
    what = what or "is no word whose value is in the program: write the number itself"
    return Mistyped(f"{body[place : place + 20]!r} {what}", mended="")


def _call(body: str, place: int) -> tuple[Function, int] | None:
    """A tool by its name, or a subprogram by its number, and where that ends."""
    if named := _TOOL_NAME.match(body, place):
        return Function(TOOL_BY_NAME, named[1]), named.end()
    if called := _SUBPROGRAM.match(body, place):
        return Function(called[1].upper(), None), called.end()
    return None


def _word(letter: str, number: str, start: int, end: int) -> Word:
    return Word(letter.upper(), float(number), start, end, decimals_of(number))


# dynamics, look-ahead, messages, graphics: nothing of where the axes go
_HARMLESS = frozenset(
    """SOFT BRISK SOFTA BRISKA DRIVE DRIVEA FFWON FFWOF STARTFIFO STOPFIFO FIFOCTRL STOPRE CFC CFTCP CFIN DIAMOF UPATH
    SPATH COMPOF CUT2D CUT2DF NORM KONT ORIWKS ORIMKS ORIAXES ORIVECT ORIVIRT1 DYNNORM DYNPOS DYNROUGH
    DYNSEMIFIN DYNFINISH MSG WORKPIECE GROUP_BEGIN GROUP_END GROUP_ADDEND LIMS FGROUP FNORM FLIN CPRECOF""".split()
)
# modes that let the control round the path within a tolerance of its own, as G64 does
_ROUNDING = frozenset("COMPON COMPCURV COMPCAD COMPSURF CYCLE832 CUST_832 HIGH_SPEED CYCLE_HSC".split())
_SHIFTS = {"TRANS": codes.SHIFT_TO, "ATRANS": codes.SHIFT_BY}
_FRAMES = {"ROT": "turns", "AROT": "turns", "ROTS": "turns", "AROTS": "turns", "SCALE": "scales", "ASCALE": "scales",
           "MIRROR": "mirrors", "AMIRROR": "mirrors"}  # fmt: skip
_MACHINE = frozenset({"SUPA"})
_TAPPING = ("CYCLE84", "CYCLE840")
_FAULTY = {
    "CIP": "is an arc through a middle point", "CT": "is a tangential arc", "INVCW": "is an involute",
    "INVCCW": "is an involute", "ASPLINE": "is a spline", "BSPLINE": "is a spline", "CSPLINE": "is a spline",
    "POLY": "is a polynomial", "CYCLE800": "tilts the plane", "TOFRAME": "turns the coordinates",
    "TRANSMIT": "interpolates on the face",
    "TRACYL": "interpolates on a cylinder", "TRAANG": "slants an axis",
    "DIAMON": "reads diameters", "DIAM90": "reads diameters",
    "CUT3DC": "compensates the cutter's radius", "CUT3DF": "compensates the cutter's radius",
    "G290": "changes the language", "G291": "changes the language",
    "IF": "is a branch", "ELSE": "is a branch", "ENDIF": "is a branch", "FOR": "is a loop", "WHILE": "is a loop",
    "LOOP": "is a loop", "REPEAT": "is a loop", "GOTO": "is a jump", "GOTOF": "is a jump", "GOTOB": "is a jump",
    "GOTOC": "is a jump", "GOTOS": "is a jump", "DEF": "declares a variable", "PROC": "begins a subprogram",
    "EXTERN": "declares a subprogram", "CALL": "calls a subprogram", "MEAS": "probes", "MEAW": "probes",
    "POS": "moves an axis by itself", "POSA": "moves an axis by itself",
    **dict.fromkeys(_TAPPING, "taps: its motions go with the spindle"),
}  # fmt: skip
# words by a name: what they do
_ASSIGNED_WORDS = {
    "RND": "rounds a corner, which is not followed", "RNDM": "rounds every corner, which is not followed",
    "CHF": "chamfers a corner, which is not followed", "CHR": "chamfers a corner, which is not followed",
    "RPL": "turns the coordinates, which is not followed", "TURN": "adds turns to an arc, which is not followed",
    "AR": "gives an arc by its angle, which is not followed", "ANG": "gives a line by its angle, which is not followed",
    "AP": "gives a position by its angle, which is not followed",
    "RP": "gives a position by its radius, which is not followed",
    **dict.fromkeys(("I1", "J1", "K1"), "gives an arc by a middle point, which is not followed"),
}  # fmt: skip
END_OF_TILT = "CYCLE800() ends a tilted plane, of which there is none here: it is taken to move no axis"
_DECLARES = frozenset({"DEF", "PROC", "EXTERN"})
_BRANCHES = frozenset("IF ELSE ENDIF FOR WHILE LOOP REPEAT GOTO GOTOF GOTOB GOTOC GOTOS".split())
_RUN = "write the blocks that are run, in their order"
_WRITTEN_OUT = "have its motions written out as G0, G1, G2 and G3"


def take_functions(found: SiemensBlock, meaning: Meaning) -> None:
    """Take in the keywords of a block before its words; complaints go into its meaning."""
    functions = list(found.functions)
    if any(function.name in (*DRILLING, MODAL) for function in functions):
        _call_cycle(found, meaning)
        functions = [function for function in functions if function.name not in (*DRILLING, MODAL)]
    for function in functions:
        _take(function, meaning)
        if function[0] in _DECLARES:
            break  # what follows are names
    for letter, way in found.ways.items():
        meaning.ways[letter] = way != INCREMENTAL_WAY
        if way in WAYS:
            meaning.turning[letter] = way
            value = next(word.value for word in found.block.words if word.letter == letter)
            if problem := problems_of(letter, way, value):
                meaning.complain(*problem)


def _call_cycle(found: SiemensBlock, meaning: Meaning) -> None:
    """A cycle, called where the axes stand or after each block that moves, or the end of such calls."""
    names = [function.name for function in found.functions]
    modal = names[0] == MODAL
    if any(word.letter != "N" for word in found.block.words) or len(names) > 1 + modal:
        meaning.complain(f"{names[-1]} beside other words", "a block of its own")
    elif len(names) == modal:
        meaning.call = END_OF_CALLS
    elif names[-1] in DRILLING:
        try:
            meaning.call = drilling_call(names[-1], found.functions[-1].arguments, modal)
        except CallError as problem:
            meaning.complain(str(problem), f"{problem.remedy}; or {_WRITTEN_OUT}")


def _take(function: Function, meaning: Meaning) -> None:
    name, arguments = function
    if name in _SHIFTS:
        meaning.data_code = _SHIFTS[name]
    elif name in _FRAMES:
        meaning.data_code, meaning.frame = codes.SHIFT_TO, f"{name} {_FRAMES[name]} the coordinates"
        if name.startswith("A") or arguments is not None:
            meaning.complain(meaning.frame, codes.WITHOUT_IT)
    elif name in _MACHINE:
        meaning.codes.add(codes.MACHINE_COORDINATES)
    elif name in _ROUNDING:
        meaning.notes.append(f"{name}: {codes.ROUNDS}")
    elif name == TOOL_BY_NAME:
        meaning.tool_name = arguments or ""
    elif name == "CYCLE800" and arguments == "()":
        meaning.notes.append(END_OF_TILT)
    elif name in _FAULTY:
        remedy = _RUN if name in _BRANCHES else codes.TAP_APART if name in _TAPPING else _WRITTEN_OUT
        meaning.complain(f"{name} {_FAULTY[name]}", remedy)
    elif _SUBPROGRAM.fullmatch(name):
        meaning.complain(f"{name} calls a subprogram, which is not followed", m_codes.IN_PLACE)
    elif name in ("TRAORI", "TRAFOOF"):
        meaning.point_control = name == "TRAORI"
        if arguments not in (None, "()", "(1)"):
            meaning.complain(f"{name}{arguments} selects another transformation", "TRAORI alone, or TRAORI(1)")
    elif name not in _HARMLESS:
        what = "is a cycle or a subprogram" if arguments is not None else "is not known, and may be a subprogram"
        meaning.complain(f"{name} {what}: its motions are not in the program", _WRITTEN_OUT)
