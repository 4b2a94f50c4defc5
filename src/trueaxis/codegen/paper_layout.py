"""Where the paper has what is derived, for the page of the paper's own machine: numbers, points, unknowns, errata."""

from dataclasses import dataclass

TITLE = "Prediction and compensation of geometric error for translational axes in multi-axis machine tools"
ERRATA_PAGE = "../../docs/errata.md"


@dataclass(frozen=True)
class Reading:
    """One measured displacement L_{label direction h}: of point `label` in a direction, in runs of a pattern."""

    label: str
    direction: str

    @property
    def latex(self) -> str:
        """`L_{1xh}`."""
        return f"L_{{{self.label}{self.direction}h}}"


@dataclass(frozen=True, kw_only=True)
class System:
    """A numbered system of a pattern: its readings row by row, its unknowns in the paper's order.

    solution: the number of its closed form; written by rows (`rows`) or with the inverse matrix.
    """

    number: int
    solution: int
    readings: tuple[Reading, ...]
    unknowns: tuple[str, ...]
    rows: bool = True


@dataclass(frozen=True, kw_only=True)
class Pattern:
    """A motion of Sects. 3.2 to 3.5: axes that move, number of its motion equation, of its readings and systems.

    projected: number of the projections of its linkage line, with the directions of sine and cosine. general: number
    of the readings of any point i; special: number and readings of the points measured.
    """

    axes: str
    section: str
    title: str
    motion: int
    systems: tuple[System, ...]
    projected: tuple[int, str, str] | None = None
    general: tuple[int, str] | None = None
    special: tuple[tuple[int, tuple[Reading, ...]], ...] = ()


def _readings(labels: str, directions: str) -> tuple[Reading, ...]:
    return tuple(Reading(label, direction) for direction in directions for label in labels)


PATTERNS = (
    Pattern(
        axes="X",
        section="3.2",
        title="X alone",
        motion=12,
        systems=(
            System(number=15, solution=18, readings=_readings("123", "x"), unknowns=("EXX", "ECX", "EBX"), rows=False),
        ),
    ),
    Pattern(
        axes="Y",
        section="3.2",
        title="Y alone",
        motion=13,
        systems=(
            System(number=16, solution=19, readings=_readings("456", "y"), unknowns=("EYY", "ECY", "EAY"), rows=False),
        ),
    ),
    Pattern(
        axes="Z",
        section="3.2",
        title="Z alone",
        motion=14,
        systems=(
            System(number=17, solution=20, readings=_readings("789", "z"), unknowns=("EZZ", "EBZ", "EAZ"), rows=False),
        ),
    ),
    Pattern(
        axes="XZ",
        section="3.3",
        title="X and Z together",
        motion=21,
        systems=(
            System(number=25, solution=26, readings=_readings("12", "xz"), unknowns=("EXZ", "ECZ", "EZX", "EAX")),
        ),
        projected=(22, "x", "z"),
        general=(23, "xz"),
        special=((24, _readings("12", "xz")),),
    ),
    Pattern(
        axes="XY",
        section="3.4",
        title="X and Y together",
        motion=27,
        systems=(
            System(number=31, solution=32, readings=_readings("12", "x"), unknowns=("EXY", "EBY")),
            System(number=0, solution=34, readings=_readings("1", "y"), unknowns=("EYX",)),
        ),
        projected=(28, "x", "y"),
        general=(29, "xy"),
        special=((30, _readings("12", "x")), (33, _readings("1", "y"))),
    ),
    Pattern(
        axes="YZ",
        section="3.5",
        title="Y and Z together",
        motion=35,
        systems=(
            System(number=0, solution=38, readings=(Reading("1", "z"), Reading("1", "y")), unknowns=("EZY", "EYZ")),
        ),
        projected=(36, "y", "z"),
        general=None,
        special=((37, (Reading("1", "y"), Reading("1", "z"))),),
    ),
)

RUNS = frozenset(
    f"{pattern.axes}-{reading.label}{reading.direction if len(pattern.axes) > 1 else ''}"
    for pattern in PATTERNS
    for system in pattern.systems
    for reading in system.readings
)
"""Names of the paper's 18 runs: a spec that derives them all, and names the paper's numbers, is of its machine."""

ERRATA: dict[int | str, tuple[int, ...]] = {
    "Table 1": (1, 2),
    "Table 2": (5,),
    "Table 3": (7, 8),
    "Table 4": (10, 33, 34),
    "Table 5": (10, 34, 35),
    1: (3,),
    2: (4,),
    3: (4,),
    6: (6,),
    9: (8, 9),
    10: (8,),
    11: (8, 9),
    13: (10,),
    17: (33,),
    18: (10, 11),
    19: (12,),
    20: (12, 33),
    21: (13,),
    22: (14, 15),
    23: (16,),
    24: (14, 15),
    25: (17, 18),
    26: (19, 20),
    27: (10, 21),
    28: (15,),
    30: (10, 15),
    31: (10,),
    32: (10, 22, 23),
    33: (10, 15, 24),
    34: (10, 24),
    35: (25,),
    36: (14, 15, 26),
    37: (10, 14, 15),
    38: (10,),
    39: (27, 28, 29, 30),
    40: (30,),
    41: (30, 31),
    42: (30,),
    43: (30, 32),
    53: (39,),
    54: (39,),
    55: (40,),
    56: (41,),
}
"""Errata of docs/errata.md by equation or table."""


def erratum(number: int) -> str:
    """A link to one erratum."""
    return f"[E{number}]({ERRATA_PAGE}#e{number})"


def beside(*sources: int | str, linked: bool = True) -> str:
    """Errata of equations or tables, for behind their numbers, as links or as numbers; empty where there are none."""
    numbers = sorted({number for source in sources for number in ERRATA.get(source, ())})
    texts = ", ".join(erratum(number) if linked else "E" + str(number) for number in numbers)
    return f" (errata: {texts})" if texts else ""
