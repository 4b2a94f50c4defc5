"""What LinuxCNC's interpreter is told before a program: parameters, tools, and what it takes for what is not known."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from trueaxis.compensation.linuxcnc.blocks import AXES
from trueaxis.compensation.linuxcnc.source import TOOL_PARAMETERS
from trueaxis.compensation.offsets import NUMBERED, Offsets, middle
from trueaxis.compensation.tools import Tool
from trueaxis.io.faults import Fault

# two places where the axes are taken to stand at first, mm and deg, that no program names
STARTS = (
    {"X": 13.1713, "Y": 17.3319, "Z": 19.7117, "A": 1.1713, "B": 1.3319, "C": 1.7117},
    {"X": 23.9173, "Y": 29.1371, "Z": 31.3733, "A": 2.9173, "B": 2.1371, "C": 3.3733},
)
# and by how much a tool change, or G28 to a point that is not known, puts them elsewhere
MOVED = ((0.0, 0.0, 0.0, 0.0, 0.0, 0.0), (7.7191, 9.3137, 11.7793, 0.7191, 0.9137, 1.3793))
REFERENCE = {"G28": 5161, "G30": 5181}  # parameters of their X
SYSTEMS, EACH = 5221, 20  # the parameter of X of G54, and from one work offset to the next
OF_USER = range(1, 5061)  # parameters that are programs' own
# what is taken for what is not known: a tool in the spindle at first, mm, parameters, and diameters, so small that no
# contour becomes impossible
UNKNOWN_TOOL, NO_TOOL = (99991, (3.1713, 2.3319, 7.7117)), (-1, (0.0, 0.0, 0.0))
UNKNOWN_DIAMETER = 0.0613  # mm
UNKNOWN_PARAMETER = 1000.0371


@dataclass(frozen=True, slots=True, kw_only=True)
class Round:
    """One run of the interpreter. parameters, tools: as files of LinuxCNC in mm; table: see calls; start: a
    block; moved: by a tool change, X Y Z A B C.
    """

    parameters: str
    tools: str
    table: Sequence[object]
    start: str
    moved: Sequence[float]


def rounds_of(
    offsets: Offsets, tools: Mapping[int, Tool], points: Mapping[str, Mapping[str, float]], axes: Sequence[str],
    kept: bool, tool: int | None = None,
) -> list[Round]:  # fmt: skip
    """Four runs: from two places; from the first of them with other values of all that is not known; and with other
    diameters alone of tools whose diameter is not known.

    kept: whether a tool change moves no axis. tool: of tools, in the spindle before the program; None: not known.
    """
    made = []
    for number, unknown, diameters in ((0, False, False), (1, False, False), (0, True, True), (0, False, True)):
        start, moved = STARTS[number], MOVED[number]
        values = _parameters(offsets, points, axes, moved)
        if unknown:
            values = {one: UNKNOWN_PARAMETER + one for one in OF_USER} | values
        diameter = UNKNOWN_DIAMETER if diameters else 0.0
        first = [*(UNKNOWN_TOOL if unknown else NO_TOOL), diameter, 0.0, 0.0, 0]
        if tool is not None:
            first = _entry(tool, tools[tool], diameter) if tool else [*NO_TOOL, 0.0, 0.0, 0.0, 0]
        ways = zip(AXES, moved, strict=True)
        made.append(
            Round(
                parameters="".join(f"{one}\t{value:.9f}\n" for one, value in sorted(values.items())),
                tools="".join(_line(number, tool) for number, tool in tools.items()),
                table=[first, *(_entry(one, tool, diameter) for one, tool in tools.items())],
                start="G53 G0 " + " ".join(f"{axis}{start[axis]}" for axis in axes),
                moved=[way if axis in axes and not kept else 0.0 for axis, way in ways],
            )
        )
    return made


def known_parameters(
    offsets: Offsets, points: Mapping[str, Mapping[str, float]], tool: int | None = None
) -> Collection[int]:
    """Numbers of the parameters that are known before a program; tool: in the spindle, None: not known."""
    known = set(offsets.parameters) | set(range(5210, 5221))  # G92, and which work offset is in force
    known |= set(TOOL_PARAMETERS if tool is not None else ())
    for system in offsets.systems:
        if system in NUMBERED:
            first = SYSTEMS + EACH * NUMBERED.index(system)
            known |= set(range(first, first + EACH // 2))
    for code, point in points.items():
        known |= {REFERENCE[code] + AXES.index(axis) for axis in point if axis in AXES}
    return known


def point_faults(offsets: Offsets, points: Mapping[str, Mapping[str, float]]) -> Iterable[Fault]:
    """Faults of reference points that differ in the control's parameters and in the spec."""
    for code, point in points.items():
        for axis, at in point.items():
            value = offsets.parameters.get(REFERENCE[code] + AXES.index(axis), at)
            if abs(value - at) > 1e-6:
                yield Fault(
                    "--offsets", "", f"{axis} of {code} is {value:g} there, and {at:g} in [reference_points] of the "
                    "spec", "the same in both",
                )  # fmt: skip


def _parameters(
    offsets: Offsets, points: Mapping[str, Mapping[str, float]], axes: Sequence[str], moved: Sequence[float]
) -> dict[int, float]:
    values = {number: value for number, value in offsets.parameters.items() if number in OF_USER}
    for place, system in enumerate(NUMBERED):
        table = offsets.systems.get(system, {})
        first = SYSTEMS + EACH * place
        values |= {first + row: middle(table.get(axis, (0.0, 0.0))) for row, axis in enumerate(AXES)}
        values |= {first + row: 0.0 for row in (6, 7, 8, 9)}
    for base in (5161, 5181, 5211):
        values |= {base + row: 0.0 for row in range(9)}
    for code, base in REFERENCE.items():
        for axis in axes:
            row = AXES.index(axis)
            told = offsets.parameters.get(base + row, moved[row])
            values[base + row] = points.get(code, {}).get(axis, told)
    return values | {5210: 0.0, 5220: NUMBERED.index(offsets.first or "G54") + 1.0}


def _entry(number: int, tool: Tool, otherwise: float) -> list[object]:
    cutter = tool.cutter
    return [number, list(tool.shift), cutter.diameter or otherwise, *cutter.angles, cutter.orientation]


def _line(number: int, tool: Tool) -> str:
    x, y, z = tool.shift
    return f"T{number} P{number} X{x:.9f} Y{y:.9f} Z{z:.9f} D{tool.cutter.diameter or 0.0:.9f}\n"
