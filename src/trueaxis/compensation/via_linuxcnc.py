"""Has LinuxCNC's interpreter unroll a program: macros, subprograms and cutter compensation become plain motions.

The interpreter (Debian package linuxcnc-uspace) runs in processes of its own, in an empty folder, with a table of tools
and offsets made for it, no INI of the shop, no remapped codes, no Python and no M codes of the user. Its module `gcode`
gives the motions, twice, from two places: what differs depends on where the axes stand at first, and is not known. Its
program `rs274` gives the other calls (spindle, coolant, tools, dwells). What comes out is a program of lines and arcs
in machine coordinates that NcReader reads as any other; its N words are the lines of the source.
"""

import json
import math
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from trueaxis.compensation.linuxcnc_blocks import AXES, SAME, UNCERTAIN, Motion, Unrolled, unrolled_program
from trueaxis.compensation.offsets import NUMBERED, Offsets, half_width, middle
from trueaxis.compensation.settings import MM_PER_INCH, BlockDelete
from trueaxis.compensation.tools import ToolTable
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files

CALLS = Path(__file__).with_name("linuxcnc_calls.py")
PYTHON = "/usr/bin/python3"  # the one that the package's module is made for
SECONDS = 600
# two places where the axes are taken to stand at first, mm and deg, that no program names
STARTS = (
    {"X": 13.1713, "Y": 17.3319, "Z": 19.7117, "A": 1.1713, "B": 1.3319, "C": 1.7117},
    {"X": 23.9173, "Y": 29.1371, "Z": 31.3733, "A": 2.9173, "B": 2.1371, "C": 3.3733},
)
# and by how much a tool change, or G28 to a point that is not known, puts them elsewhere
MOVED = ((0.0, 0.0, 0.0, 0.0, 0.0, 0.0), (7.7191, 9.3137, 11.7793, 0.7191, 0.9137, 1.3793))
_WAITS = re.compile(rb"(?i)M\s*0*66(?![0-9.])")
# parameters that are lengths: X Y Z of G28, G30, G92 and the work offsets
_LENGTHS = frozenset(
    base + row for base in (5161, 5181, 5211, *range(5221, 5221 + 20 * len(NUMBERED), 20)) for row in range(3)
)
_OPTIONAL = re.compile(rb"(?m)^[ \t]*/")
NOT_INSTALLED = (
    "LinuxCNC's interpreter is not there",
    "install the Debian package linuxcnc-uspace, or name the folder into which it is unpacked: --via-linuxcnc DIR",
)


def unrolled(
    program: Path,
    package: Path,
    offsets: Offsets,
    tools: ToolTable | None,
    name: str,
    block_delete: BlockDelete = "fault",
    axes: Sequence[str] = AXES,
    reference_points: Mapping[str, Mapping[str, float]] | None = None,
    kept: bool = False,
) -> Unrolled:
    """The program as lines and arcs in machine coordinates.

    package: the folder in which LinuxCNC is installed (`/`) or unpacked. block_delete: what / blocks are. axes: those
    of the machine. reference_points: of Settings. kept: whether a tool change moves no axis. Raises InputError when the
    interpreter is not there or refuses the program, when an offset that the program uses is not known, or when the
    program does what lines and arcs do not say.
    """
    where = package / "usr/lib/python3/dist-packages"
    if not (package / "usr/bin/rs274").is_file() or not list(where.glob("gcode*.so")):
        raise InputError([Fault("--via-linuxcnc", "", *NOT_INSTALLED)])
    if tools is not None and any(tool.offset[:2] != (0.0, 0.0) for tool in tools.tools.values()):
        raise InputError([Fault("--tools", "", "offsets of tools in X and Y do not go with --via-linuxcnc")])
    source = program.read_bytes()
    _check_source(source, name, block_delete)
    lengths = {} if tools is None else {number: tool.shift[2] for number, tool in tools.tools.items()}
    with tempfile.TemporaryDirectory() as folder:
        here = Path(folder)
        write_files({here / "program.ngc": source})
        _write_state(here, offsets, lengths, reference_points or {}, axes)
        env = {
            "PATH": os.defpath, "HOME": folder,
            "LD_LIBRARY_PATH": f"{package}/usr/lib:{package}/usr/lib/{sys.implementation._multiarch}",
        }  # fmt: skip
        rs274 = [str(package / "usr/bin/rs274"), "-g", "-t", "tool.tbl", "-v", "calls.var"]
        rs274 += ["-b"] if block_delete == "skip" else []
        calls = _run([*rs274, "program.ngc"], here, env)  # makes the table of tools that the module reads, too
        table = json.dumps([(0, 0.0), *lengths.items()])
        rounds = []
        for number, (start, moved) in enumerate(zip(STARTS, MOVED, strict=True)):
            begin = "G53 G0 " + " ".join(f"{axis}{start[axis]}" for axis in axes)
            ways = zip(AXES, moved, strict=True)
            elsewhere = json.dumps([way if axis in axes and not kept else 0.0 for axis, way in ways])
            given = [f"motions{number}.var", str(where), table, begin, block_delete, elsewhere]
            rounds.append(_run([PYTHON, str(CALLS), "program.ngc", *given], here, env))
    _check_offsets(calls, offsets, name)
    motions = _motions(rounds, name)
    try:
        return unrolled_program(calls.splitlines(), motions, {} if tools is None else tools.tools, axes, kept)
    except ValueError as problem:
        raise InputError([Fault(name, "", f"{problem}, which is not unrolled")]) from None


def _check_source(source: bytes, name: str, block_delete: BlockDelete) -> None:
    """Faults of what is not known before the program runs."""
    optional = _OPTIONAL.search(source)
    if optional and block_delete == "fault":
        line = source.count(b"\n", 0, optional.start()) + 1
        raise InputError([
            Fault(name, f"line {line}", "whether a block with / is run is not known", "say --block-delete run or skip")
        ])  # fmt: skip
    for number, block in enumerate(source.split(b"\n"), 1):
        if _WAITS.search(re.sub(rb"\([^()]*\)|;.*", b"", block)):
            problem = "M66 waits for an input: what the program does then is not known"
            raise InputError([Fault(name, f"line {number}", problem)])


def _check_offsets(calls: str, offsets: Offsets, name: str) -> None:
    """Faults of offsets that are not known exactly: what is written has them in its words."""
    used = {NUMBERED[int(place) - 1] for place in re.findall(r"SET_G5X_OFFSET\((\d)", calls)}
    faults = [
        Fault(name, "", f"{system}: where its zero is is not known", f"say --offset {system}=X..,Y..,Z.., exactly")
        for system in sorted(used - set(offsets.systems))
    ]
    if any(half_width(values) for system in used for values in offsets.systems.get(system, {}).values()):
        faults.append(Fault("--offset", "", "a range does not go with --via-linuxcnc", "the value itself"))
    if any(offsets.shift.values()):
        faults.append(Fault("--offsets", "", "G92 in force does not go with --via-linuxcnc", "G92.1 on the control"))
    if faults:
        raise InputError(faults)


def _write_state(
    here: Path, offsets: Offsets, lengths: Mapping[int, float], points: Mapping[str, Mapping[str, float]],
    axes: Sequence[str],
) -> None:  # fmt: skip
    """Files of parameters and tools: for the module in mm, for rs274, which takes all lengths for inches, in those."""
    first = offsets.first or "G54"
    switches = {5210: 0.0, 5220: NUMBERED.index(first) + 1.0}
    values: dict[int, float] = {}
    for place, system in enumerate(NUMBERED):
        table = offsets.systems.get(system, {})
        values |= {5221 + 20 * place + row: middle(table.get(axis, (0.0, 0.0))) for row, axis in enumerate(AXES)}
        values |= {5221 + 20 * place + row: 0.0 for row in (6, 7, 8, 9)}
    for base in (5161, 5181, 5211):
        values |= {base + row: 0.0 for row in range(9)}
    units = {"motions0": 1.0, "motions1": 1.0, "calls": MM_PER_INCH}
    for (name, unit), moved in zip(units.items(), (*MOVED, MOVED[0]), strict=True):
        for base, code in ((5161, "G28"), (5181, "G30")):
            point = points.get(code, {})
            values |= {base + AXES.index(axis): point.get(axis, moved[AXES.index(axis)]) for axis in axes}
        scaled = {number: value / (unit if number in _LENGTHS else 1.0) for number, value in values.items()}
        text = "".join(f"{number}\t{value:.9f}\n" for number, value in sorted((scaled | switches).items()))
        write_files({here / f"{name}.var": text})
    table_of_tools = (f"T{tool} P{tool} Z{length / MM_PER_INCH:.9f}\n" for tool, length in lengths.items())
    write_files({here / "tool.tbl": "".join(table_of_tools)})


def _run(command: Sequence[str], folder: Path, env: Mapping[str, str]) -> str:
    try:
        done = subprocess.run(
            command, cwd=folder, env=dict(env), capture_output=True, text=True, errors="replace", timeout=SECONDS,
            check=False, stdin=subprocess.DEVNULL,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        raise InputError([Fault("--via-linuxcnc", "", f"the interpreter took more than {SECONDS} s")]) from None
    return done.stdout


def _motions(rounds: Sequence[str], name: str) -> list[Motion]:
    found: list[list[list[Any]]] = []
    for text in rounds:
        lines = [json.loads(line) for line in text.splitlines() if line.startswith("[")]
        if not lines or lines[-1][0] != "end":
            raise InputError([Fault("--via-linuxcnc", "", "the interpreter broke off")])
        _, line, result, problem = lines[-1]
        if result and found:
            raise InputError([Fault(name, f"line {line}", f"what the program does depends on {UNCERTAIN}")])
        if result:
            raise InputError([Fault(name, f"line {line}", f"LinuxCNC refuses the program: {problem}")])
        others = [Fault(name, f"line {one[1]}", f"{one[2]} is not unrolled") for one in lines if one[0] == "other"]
        if others:
            raise InputError(others)
        found.append(lines[:-1])  # the first is the motion to the start
    if [(one[0], one[1]) for one in found[0]] != [(one[0], one[1]) for one in found[1]]:
        raise InputError([Fault(name, "", f"what the program does depends on {UNCERTAIN}")])
    motions = []
    for (one, other), (before, before_other) in zip(
        zip(found[0][1:], found[1][1:], strict=True), zip(*found, strict=True), strict=False
    ):
        kind, line, plane, turns, centre, end = one
        if kind == "stands":  # what the next motion starts from
            continue
        same = tuple(a if abs(a - b) < SAME else None for a, b in zip(end, other[5], strict=True))
        ways = zip(end, before[5], other[5], before_other[5], strict=True)
        way = tuple(a - c if abs((a - c) - (b - d)) < SAME else math.nan for a, c, b, d in ways)
        motions.append(
            Motion(
                kind=str(kind),
                line=int(line),
                plane=int(plane),
                turns=int(turns),
                centre=tuple(centre),
                end=same,
                way=way,
            )
        )
    return motions
