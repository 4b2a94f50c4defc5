"""Arguments of `compensate` as users write them: settings by name, work offsets and tools as tables."""

import math
from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Any, Literal, TypedDict, cast, get_args, get_origin, get_type_hints

import numpy as np

from trueaxis.compensation.offsets import (
    RIGHT_NAME,
    Offsets,
    Range,
    problem_of,
    read_offsets,
    system_name,
    with_options,
)
from trueaxis.compensation.settings import Arcs, BlockDelete, Dialect, Integers, Method, Orientation, WordChoice
from trueaxis.compensation.tools import LONGEST, Tool, ToolTable, read_tools
from trueaxis.compensation.touched_off import touched_off_of_option
from trueaxis.jobs.typed import AnyPath
from trueaxis.machine.machine import AXES

Zero = float | tuple[float, float]
WorkOffsets = AnyPath | Mapping[str, Mapping[str, Zero]]
Tools = AnyPath | Mapping[int, Tool | float]


class CompensationSettings(TypedDict, total=False):
    """Further arguments of `compensate`, as the options of `trueaxis compensate`; mm and deg, defaults in brackets.

    tolerance: largest tool point error allowed (0.001; 0.00254 for words of 0.0001 inch); resolution,
    rotary_resolution, inch_resolution (inch): steps of the words that are written (0.001, 0.0001, 0.00001; 0.0001 for
    "fanuc"); chord_tolerance: of an arc from its chords (0.0005); arcs: "keep" or "chords"; method: "iterative" or
    "ordinary"; words: "nearest", "ends" or "middles", which need ball: the centre of the workpiece ball, workpiece
    frame. orientation: "keep" or
    "correct", to orientation_tolerance_urad (2), of tool_axis: its direction, tool frame (0, 0, 1). start: axis
    positions before the first block, those known. temperature (degC), time (s): for effects that depend on them.
    block_delete: motions in / blocks are a "fault", "run", or to "skip"; dialect: "fanuc", "linuxcnc", "siemens" or
    "heidenhain"; integers: what a number without a decimal point counts, "mm" or "least-increment"; pass_m, pass_g: M
    and G codes that move nothing on this control. peck_return: how far G73 and G83 go back, where they are written out
    (0.254). touched_off: work offsets that were touched off without compensation, each as --touched-off takes it
    ("G54=L120"); keep_g53: motions in machine coordinates stay as they are. spindle_tool: number of the tool in the
    spindle before the program, 0: none (not known).
    """

    tolerance: float
    resolution: float
    inch_resolution: float
    rotary_resolution: float
    chord_tolerance: float
    arcs: Arcs
    method: Method
    words: WordChoice
    ball: Sequence[float]
    orientation: Orientation
    orientation_tolerance_urad: float
    tool_axis: Sequence[float]
    start: Mapping[str, float]
    temperature: float
    time: float
    block_delete: BlockDelete
    dialect: Dialect
    integers: Integers
    pass_m: Sequence[int]
    pass_g: Sequence[float]
    peck_return: float
    touched_off: Sequence[str]
    keep_g53: bool
    spindle_tool: int


def settings_of(given: CompensationSettings) -> dict[str, Any]:
    """The settings as the record has them. Raises TypeError for a name that is none, ValueError for another form."""
    types, settings = get_type_hints(CompensationSettings), dict[str, Any](given)
    if unknown := [name for name in settings if name not in types]:
        raise TypeError(f"compensate: no argument {', '.join(unknown)}; settings are {', '.join(types)}")
    for name, value in settings.items():
        if get_origin(types[name]) is Literal:
            if value not in get_args(types[name]):
                raise ValueError(f"{name}: expected one of {', '.join(get_args(types[name]))}; given {value!r}")
        elif types[name] is float:
            settings[name] = _number(name, value)
    for name in ("ball", "tool_axis"):
        if name in settings:
            settings[name] = _vector(name, settings[name])
    if "start" in settings:
        settings["start"] = {axis: _number(f"start[{axis!r}]", at) for axis, at in dict(settings["start"]).items()}
    if "touched_off" in settings:
        settings["touched_off"] = tuple(map(touched_off_of_option, settings["touched_off"]))
    if "pass_m" in settings:
        settings["pass_m"] = _codes(settings["pass_m"])
    if "pass_g" in settings:
        settings["pass_g"] = _g_codes(settings["pass_g"])
    return settings


def offsets_of(given: WorkOffsets | None) -> Offsets:
    """The work offsets. Raises InputError with the faults of a file, ValueError where a table is of another form."""
    if given is None:
        return Offsets()
    if isinstance(given, str | PathLike):
        return read_offsets(Path(given))
    systems = []
    for name, values in given.items():
        if (system := system_name(name)) is None:
            raise ValueError(f"offsets: expected {RIGHT_NAME}; given {name!r}")
        if unknown := [axis for axis in values if axis not in AXES]:
            raise ValueError(f"offsets[{name!r}]: expected axes among {', '.join(AXES)}; given {', '.join(unknown)}")
        systems.append((system, {axis: _range(f"offsets[{name!r}][{axis!r}]", at) for axis, at in values.items()}))
    return with_options(Offsets(), systems)


def tools_of(given: Tools | None) -> ToolTable | None:
    """The tools by number. Raises InputError with the faults of a file, ValueError where a table is of another form."""
    if given is None:
        return None
    if isinstance(given, str | PathLike):
        return read_tools(Path(given))
    tools = {}
    for number, one in given.items():
        tool = one if isinstance(one, Tool) else Tool(_number(f"tools[{number}]", one))
        if not isinstance(number, int) or number < 0:
            raise ValueError(f"tools: expected numbers of tools, 0 or above; given {number!r}")
        lengths = np.array(
            [tool.length, *tool.offset, *(tool.point or ()), tool.cutter.diameter or 0.0], dtype=np.float64
        )
        if not (np.abs(lengths) <= LONGEST).all():
            raise ValueError(f"tools[{number}]: expected lengths in mm, up to {LONGEST:g}; given {tool}")
        tools[number] = tool
    return ToolTable(tools)


def _number(name: str, value: object) -> float:
    try:
        number = float(cast("float", value))
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number):
        raise ValueError(f"{name}: expected a finite number; given {value!r}")
    return number


def _vector(name: str, value: Sequence[float]) -> tuple[float, float, float]:
    array = np.asarray(value, dtype=np.float64)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise ValueError(f"{name}: expected three finite numbers; given {value}")
    x, y, z = array.tolist()
    return x, y, z


def _codes(value: Sequence[int]) -> tuple[int, ...]:
    codes = tuple(value)
    if not all(isinstance(code, int) and code >= 0 for code in codes):
        raise ValueError(f"pass_m: expected whole numbers, such as (70, 110); given {value!r}")
    return tuple(sorted(set(codes)))


def _g_codes(value: Sequence[float]) -> tuple[float, ...]:
    codes = tuple(value)
    if not all(isinstance(code, int | float) and code >= 0 for code in codes):
        raise ValueError(f"pass_g: expected numbers, such as (187, 5.1); given {value!r}")
    return tuple(sorted({float(code) for code in codes}))


def _range(name: str, value: Zero) -> Range:
    ends = tuple(value) if isinstance(value, Sequence) else (value, value)
    if len(ends) != 2:
        raise ValueError(f"{name}: expected a number, or (lowest, highest), mm or deg; given {value}")
    low, high = _number(name, ends[0]), _number(name, ends[1])
    if problem := problem_of((low, high)):
        raise ValueError(f"{name}: {problem}; expected a number, or (lowest, highest), mm or deg")
    return low, high
