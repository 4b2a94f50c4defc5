"""Has LinuxCNC's interpreter unroll a program: macros, subprograms and cutter compensation become plain motions.

The interpreter (Debian package linuxcnc-uspace) runs in processes of its own, in an empty folder, with the parameters
and the table of tools that are given, no INI of the shop, no remapped codes, no Python and no M codes of the user. It
runs three times: from two places, as what differs depends on where the axes stand at first, and is not known; and with
other values of what else is not known, which may change nothing. What comes out is a program of lines and arcs in
machine coordinates that NcReader reads as any other; its N words are the lines of the source.
"""

import json
import math
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping, Sequence
from itertools import zip_longest
from pathlib import Path
from typing import Any

from trueaxis.compensation.linuxcnc.blocks import AXES, SAME, UNCERTAIN, Motion, Unrolled, unrolled_program
from trueaxis.compensation.linuxcnc.modes import Call
from trueaxis.compensation.linuxcnc.source import (
    Source,
    control_faults,
    end_faults,
    fault_of,
    machine_lines,
    marked_source,
    may_use_point,
)
from trueaxis.compensation.linuxcnc.state import Round, known_parameters, point_faults, rounds_of
from trueaxis.compensation.machine import LINEAR
from trueaxis.compensation.offsets import NOT_KNOWN, NUMBERED, Offsets, half_width
from trueaxis.compensation.settings import BlockDelete
from trueaxis.compensation.tools import Tool, ToolTable
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files

CALLS = Path(__file__).with_name("calls.py")
PYTHON = "/usr/bin/python3"  # the one that the package's module is made for
SECONDS = 600
_OPTIONAL = re.compile(rb"(?m)^[ \t]*/")
_TOOL_COMES = frozenset({"CHANGE_TOOL", "CHANGE_TOOL_NUMBER"})
_MOTIONS = frozenset({"rapid", "feed", "arc", "stands"})
NOT_INSTALLED = (
    "LinuxCNC's interpreter is not there",
    "install the Debian package linuxcnc-uspace, or name the folder into which it is unpacked: --via-linuxcnc DIR",
)
RADIUS = "this (cutter radius compensation) depends on the diameter of a tool, which is 0 in --tools or not known"
DIAMETER = "D in the tool table, diameter in TOML"
UNKNOWN = (
    "what the program does here depends on a parameter that is neither set before nor known, or on the tool in the "
    "spindle at first"
)
UNKNOWN_REMEDY = "T and M6 at its beginning, or --spindle-tool; parameters by --offsets FILE.var"

Record = list[Any]


def unroll(
    program: Path,
    package: Path,
    offsets: Offsets,
    tools: ToolTable | None,
    name: str,
    block_delete: BlockDelete = "fault",
    axes: Sequence[str] = AXES,
    reference_points: Mapping[str, Mapping[str, float]] | None = None,
    kept: bool = False,
    tool: int | None = None,
) -> Unrolled:
    """The program as lines and arcs in machine coordinates.

    package: the folder in which LinuxCNC is installed (`/`) or unpacked. block_delete: what / blocks are. axes: those
    of the machine. reference_points: of Settings. kept: whether a tool change moves no axis. tool: of tools, in the
    spindle before the program, 0: none, None: not known. Raises InputError when the interpreter is not there or refuses
    the program, when a value that the program uses is not known, or when the program does what lines, arcs and codes do
    not say.
    """
    where = package / "usr/lib/python3/dist-packages"
    if not list(where.glob("gcode*.so")):
        raise InputError([Fault("--via-linuxcnc", "", *NOT_INSTALLED)])
    of_number = {} if tools is None else tools.tools
    if any(tool.offset[:2] != (0.0, 0.0) for tool in of_number.values()):
        raise InputError([Fault("--tools", "", "offsets of tools in X and Y do not go with --via-linuxcnc")])
    given, points = program.read_bytes(), reference_points or {}
    _check_given(given, name, block_delete, offsets, points)
    source = marked_source(given, known_parameters(offsets, points, tool))
    with tempfile.TemporaryDirectory() as folder:
        here = Path(folder)
        write_files({here / "program.ngc": source.text})
        env = {
            "PATH": os.defpath, "HOME": folder,
            "LD_LIBRARY_PATH": f"{package}/usr/lib:{package}/usr/lib/{sys.implementation._multiarch}",
        }  # fmt: skip
        task = {"program": "program.ngc", "packages": str(where), "skips": block_delete == "skip"}
        *three, by_diameter = rounds_of(offsets, of_number, points, axes, kept, tool)
        rounds = [_run(one, task, here, env) for one in three]
        _check_rounds(rounds, lambda: _run(by_diameter, task, here, env), name)
    _check_diameters(rounds[0], source, of_number, name)
    _check_offsets(rounds[0], offsets, axes, name)
    _check_end(rounds[0], given, name)
    try:
        return unrolled_program(_made(rounds), of_number, axes, kept, tool, machine_lines(given))
    except ValueError as problem:
        line, text = problem.args
        raise InputError([Fault(name, f"line {line}", text)]) from None


def _check_given(
    source: bytes, name: str, block_delete: BlockDelete, offsets: Offsets, points: Mapping[str, Mapping[str, float]]
) -> None:
    """Faults of what is not known before the program runs."""
    used = {code: point for code, point in points.items() if may_use_point(source, code)}
    faults = [*control_faults(source, name), *point_faults(offsets, used)]
    optional = _OPTIONAL.search(source)
    if optional and block_delete == "fault":
        line = source.count(b"\n", 0, optional.start()) + 1
        problem = "whether a block with / is run is not known"
        faults.append(Fault(name, f"line {line}", problem, "say --block-delete run or skip"))
    if any(offsets.shift.values()):
        faults.append(Fault("--offsets", "", "G92 in force does not go with --via-linuxcnc", "G92.1 on the control"))
    if faults:
        raise InputError(faults)


def _check_end(records: Sequence[Record], source: bytes, name: str) -> None:
    """A fault of a main program that has no end."""
    ends = [record[1] for record in records if record[0] == "call" and record[2] == "PROGRAM_END"]
    if ends and (faults := end_faults(source, ends[-1], name)):
        raise InputError(faults)


def _check_offsets(records: Sequence[Record], offsets: Offsets, axes: Sequence[str], name: str) -> None:
    """Faults of offsets that are not known exactly: what is written has them in its words."""
    used: dict[str, int] = {}  # with the line of the first motion under each
    active = offsets.first or "G54"
    for kind, line, *more in records[1:]:
        if kind == "call" and more[0] == "SET_G5X_OFFSET":
            active = NUMBERED[int(more[1]) - 1]
        elif kind in _MOTIONS and line:
            used.setdefault(active, line)
    linear, faults = [axis for axis in axes if axis in LINEAR], []
    for system, line in sorted(used.items()):
        given = offsets.systems.get(system, {})
        if missing := [axis for axis in linear if axis not in given]:
            named = f"{system} {' '.join(missing)}" if given else system
            problem, remedy = f"{named}: {NOT_KNOWN}", f"say --offset {system}=X..,Y..,Z.., exactly"
            faults.append(Fault(name, f"line {line}", problem, remedy))
    if any(half_width(values) for system in used for values in offsets.systems.get(system, {}).values()):
        faults.append(Fault("--offset", "", "a range does not go with --via-linuxcnc", "the value itself"))
    if faults:
        raise InputError(faults)


def _run(one: Round, task: Mapping[str, object], folder: Path, env: Mapping[str, str]) -> list[Record]:
    """What the interpreter asks of the machine in one run, see calls."""
    more = {"start": one.start, "moved": one.moved, "tools": one.table}
    files = {"var": one.parameters, "table": one.tools}
    write_files({folder / name: text for name, text in files.items()})
    write_files({folder / "task.json": json.dumps({**task, **more, **{name: name for name in files}})})
    try:
        done = subprocess.run(
            [PYTHON, "-B", str(CALLS), "task.json"], cwd=folder, env=dict(env), capture_output=True, text=True,
            errors="replace", timeout=SECONDS, check=False, stdin=subprocess.DEVNULL,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        raise InputError([Fault("--via-linuxcnc", "", f"the interpreter took more than {SECONDS} s")]) from None
    return [json.loads(line) for line in done.stdout.splitlines()]


def _check_rounds(rounds: Sequence[Sequence[Record]], by_diameter: Callable[[], Sequence[Record]], name: str) -> None:
    """Faults of a program that LinuxCNC refuses, or that does other things with other values of what is not known;
    by_diameter: a further run, with other diameters alone.
    """
    for records in rounds:
        if not records or records[-1][0] != "end":
            raise InputError([Fault("--via-linuxcnc", "", "the interpreter broke off")])
    _, line, result, problem = rounds[0][-1]
    if result == -1:
        raise InputError([Fault("--via-linuxcnc", "", f"this version of LinuxCNC is not known: no call {problem}")])
    if result:
        raise InputError([fault_of(name, line, problem)])
    if others := {(line, what): None for kind, line, what, *_ in rounds[0] if kind == "other"}:
        raise InputError([Fault(name, f"line {line}", f"{what} is not unrolled") for line, what in others])
    if (place := _first_difference(rounds[0], rounds[2], positions=True)) is not None:
        radius = _first_difference(rounds[0], by_diameter(), positions=True) == place
        what = (RADIUS, DIAMETER) if radius else (UNKNOWN, UNKNOWN_REMEDY)
        raise InputError([Fault(name, f"line {rounds[0][place][1]}", *what)])
    if (place := _first_difference(rounds[0], rounds[1], positions=False)) is not None:
        line = rounds[0][place][1]
        raise InputError([Fault(name, f"line {line}", f"what the program does depends on {UNCERTAIN}")])


def _first_difference(one: Sequence[Record], other: Sequence[Record], positions: bool) -> int | None:
    """The first record that differs; positions: whether those of motions are to be the same."""
    for place, (a, b) in enumerate(zip_longest(one, other)):
        if a is None or b is None:
            return min(place, len(one) - 1)
        whole = positions or a[0] not in _MOTIONS
        if not (_same(a, b) if whole else a[:2] == b[:2]):
            return place
    return None


def _same(one: object, other: object) -> bool:
    """Whether two records say the same but for rounding."""
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(_same, one, other))
    if isinstance(one, float) and isinstance(other, float):
        return math.isclose(one, other, rel_tol=1e-9, abs_tol=SAME)
    return one == other


def _check_diameters(records: Sequence[Record], source: Source, tools: Mapping[int, Tool], name: str) -> None:
    """Faults of lines that read the diameter of the tool in the spindle, where those of the program's are not known."""
    used = {int(record[3]) for record in records if record[0] == "call" and record[2] in _TOOL_COMES}
    unknown = sorted(tool for tool in used if tool in tools and tools[tool].cutter.diameter is None)
    if unknown and source.diameters:
        problem = f"#5410 is a diameter, and that of T{unknown[0]} is not known"
        raise InputError([Fault(name, f"line {line}", problem, "diameter in --tools") for line in source.diameters])


def _made(rounds: Sequence[Sequence[Record]]) -> list[Motion | Call]:
    """Motions and calls in order; what differs between the runs from two places is left open."""
    made: list[Motion | Call] = []
    before: list[tuple[float, ...]] = []
    for one, other in zip(rounds[0], rounds[1], strict=True):
        kind, line, *more = one
        if kind == "call":
            made.append(Call(line, more[0], more[1:]))
        if kind not in _MOTIONS:
            continue
        plane, turns, centre, end = more
        ends = [tuple(end), tuple(other[5])]
        if before and kind != "stands":  # the first is the motion to the start; the next motion starts where it stands
            ways = zip(ends[0], before[0], ends[1], before[1], strict=True)
            made.append(
                Motion(
                    kind=kind,
                    line=line,
                    plane=int(plane),
                    turns=int(turns),
                    centre=tuple(centre),
                    end=tuple(a if abs(a - b) < SAME else None for a, b in zip(*ends, strict=True)),
                    way=tuple(a - c if abs((a - c) - (b - d)) < SAME else math.nan for a, c, b, d in ways),
                )
            )
        before = ends
    return made
