"""What the keywords and calls of SINUMERIK programs do to positions.

A keyword that is in none of the tables is a fault that names it: it may be a subprogram, which may move anything.
Source: SINUMERIK 840D sl / 828D, Programming Manuals Fundamentals and Job Planning.
"""

from trueaxis.compensation import nc_codes as codes
from trueaxis.compensation.nc_meaning import Meaning
from trueaxis.compensation.siemens_lexer import ABSOLUTE_WAY, TOOL_BY_NAME, Function, SiemensBlock

# dynamics, look-ahead, messages, graphics: nothing of where the axes go
_HARMLESS = frozenset(
    """SOFT BRISK SOFTA BRISKA DRIVE DRIVEA FFWON FFWOF STARTFIFO STOPFIFO FIFOCTRL STOPRE CFC CFTCP CFIN DIAMOF UPATH
    SPATH COMPOF CUT2D CUT2DF NORM KONT ORIWKS ORIMKS ORIAXES ORIVECT ORIVIRT1 DYNNORM DYNPOS DYNROUGH
    DYNSEMIFIN DYNFINISH MSG WORKPIECE GROUP_BEGIN GROUP_END GROUP_ADDEND LIMS FGROUP FNORM FLIN CPRECOF""".split()
)
# modes that let the control round the path within a tolerance of its own, as G64 does
_ROUNDING = frozenset("COMPON COMPCURV COMPCAD COMPSURF CYCLE832 CUST_832 HIGH_SPEED CYCLE_HSC".split())
ROUNDS = "the control may round the path within a tolerance of its own here"
_SHIFTS = {"TRANS": codes.SHIFT_TO, "ATRANS": codes.SHIFT_BY}
_FRAMES = {"ROT": "turns", "AROT": "turns", "ROTS": "turns", "AROTS": "turns", "SCALE": "scales", "ASCALE": "scales",
           "MIRROR": "mirrors", "AMIRROR": "mirrors"}  # fmt: skip
_MACHINE = frozenset({"SUPA"})
_FAULTY = {
    "CIP": "is an arc through a middle point", "CT": "is a tangential arc", "INVCW": "is an involute",
    "INVCCW": "is an involute", "ASPLINE": "is a spline", "BSPLINE": "is a spline", "CSPLINE": "is a spline",
    "POLY": "is a polynomial", "CYCLE800": "tilts the plane", "TOFRAME": "turns the coordinates",
    "TRANSMIT": "interpolates on the face",
    "TRACYL": "interpolates on a cylinder", "TRAANG": "slants an axis",
    "MCALL": "calls a cycle at every position", "DIAMON": "reads diameters", "DIAM90": "reads diameters",
    "CUT3DC": "compensates the cutter's radius", "CUT3DF": "compensates the cutter's radius",
    "G290": "changes the language", "G291": "changes the language",
    "IF": "is a branch", "ELSE": "is a branch", "ENDIF": "is a branch", "FOR": "is a loop", "WHILE": "is a loop",
    "LOOP": "is a loop", "REPEAT": "is a loop", "GOTO": "is a jump", "GOTOF": "is a jump", "GOTOB": "is a jump",
    "GOTOC": "is a jump", "GOTOS": "is a jump", "DEF": "declares a variable", "PROC": "begins a subprogram",
    "EXTERN": "declares a subprogram", "CALL": "calls a subprogram", "MEAS": "probes", "MEAW": "probes",
    "POS": "moves an axis by itself", "POSA": "moves an axis by itself",
}  # fmt: skip
_WRITTEN_OUT = "have its motions written out as G0, G1, G2 and G3"


def take_functions(found: SiemensBlock, meaning: Meaning) -> None:
    """Take in the keywords of a block before its words; complaints go into its meaning."""
    for function in found.functions:
        _take(function, meaning)
    for letter, way in found.ways.items():
        meaning.ways[letter] = way == ABSOLUTE_WAY


def _take(function: Function, meaning: Meaning) -> None:
    name, arguments = function
    if name in _SHIFTS:
        meaning.data_code = _SHIFTS[name]
    elif name in _FRAMES:
        meaning.data_code, meaning.frame = codes.SHIFT_TO, f"{name} {_FRAMES[name]} the coordinates"
        if name.startswith("A") or arguments is not None:
            meaning.complain(meaning.frame, codes.MACHINE_REMEDY)
    elif name in _MACHINE:
        meaning.codes.add(codes.MACHINE_COORDINATES)
    elif name in _ROUNDING:
        meaning.notes.append(f"{name}: {ROUNDS}")
    elif name == TOOL_BY_NAME:
        meaning.complain(f"{arguments} selects a tool by its name", "the number of a tool in --tools, as T1")
    elif name in _FAULTY:
        meaning.complain(f"{name} {_FAULTY[name]}", _WRITTEN_OUT)
    elif name in ("TRAORI", "TRAFOOF"):
        meaning.point_control = name == "TRAORI"
        if arguments not in (None, "()", "(1)"):
            meaning.complain(f"{name}{arguments} selects another transformation", "TRAORI alone, or TRAORI(1)")
    elif name not in _HARMLESS:
        what = "is a cycle or a subprogram" if arguments is not None else "is not known, and may be a subprogram"
        meaning.complain(f"{name} {what}: its motions are not in the program", _WRITTEN_OUT)
