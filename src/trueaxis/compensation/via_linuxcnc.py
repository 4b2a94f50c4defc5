"""Has LinuxCNC's interpreter unroll a program: macros, subprograms and cutter compensation become plain motions.

The interpreter (Debian package linuxcnc-uspace) runs in processes of its own, in an empty folder, with a table of tools
and offsets made for it, no INI of the shop, no remapped codes, no Python and no M codes of the user. Its module `gcode`
gives the motions, twice, from two places: what differs depends on where the axes stand at first, and is not known. Its
program `rs274` gives the other calls (spindle, coolant, tools, dwells). What comes out is a program of lines and arcs
in machine coordinates that NcReader reads as any other; its N words are the lines of the source.
"""

import json
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from trueaxis.compensation.offsets import NUMBERED, Offsets, half_width, middle
from trueaxis.compensation.settings import BlockDelete
from trueaxis.compensation.tools import ToolTable
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files

CALLS = Path(__file__).with_name("linuxcnc_calls.py")
PYTHON = "/usr/bin/python3"  # the one that the package's module is made for
SECONDS = 600
AXES = "XYZABC"
# two places where the axes are taken to stand at first, mm and deg, that no program names
STARTS = ("G53 G0 X13.1713 Y17.3319 Z19.7117 A1.1713 B1.3319 C1.7117",
          "G53 G0 X23.9173 Y29.1371 Z31.3733 A2.9173 B2.1371 C3.3733")  # fmt: skip
_SAME = 1e-7  # mm, deg: what doubles lose on the way through inches
_CALL = re.compile(r"\s*\d+\s+N\S+\s+(\w+)\((.*)\)\s*$")
_OPTIONAL = re.compile(rb"(?m)^[ \t]*/")
_MOTION = frozenset({"STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "ARC_FEED"})
_WORDS = {
    "START_SPINDLE_CLOCKWISE": "M3", "START_SPINDLE_COUNTERCLOCKWISE": "M4", "STOP_SPINDLE_TURNING": "M5",
    "FLOOD_ON": "M8", "MIST_ON": "M7", "FLOOD_OFF": "M9", "MIST_OFF": "M9", "PROGRAM_STOP": "M0",
    "OPTIONAL_PROGRAM_STOP": "M1", "PROGRAM_END": "M2",
}  # fmt: skip
# M codes of LinuxCNC that move nothing, with their words: overrides, outputs
_OUTPUTS = {
    "ENABLE_FEED_OVERRIDE": "M50 P1", "DISABLE_FEED_OVERRIDE": "M50 P0", "ENABLE_SPEED_OVERRIDE": "M51 P1",
    "DISABLE_SPEED_OVERRIDE": "M51 P0", "SET_MOTION_OUTPUT_BIT": "M62 P{0:.0f}",
    "CLEAR_MOTION_OUTPUT_BIT": "M63 P{0:.0f}", "SET_AUX_OUTPUT_BIT": "M64 P{0:.0f}",
    "CLEAR_AUX_OUTPUT_BIT": "M65 P{0:.0f}",
    "SET_MOTION_OUTPUT_VALUE": "M67 E{0:.0f} Q{1:.6f}", "SET_AUX_OUTPUT_VALUE": "M68 E{0:.0f} Q{1:.6f}",
}  # fmt: skip
PASSED = (50, 51, 62, 63, 64, 65, 67, 68)  # the codes of these
# what says nothing that the motions do not hold
_SILENT = frozenset({
    "USE_LENGTH_UNITS", "SET_G5X_OFFSET", "SET_G92_OFFSET", "SET_XY_ROTATION", "SET_FEED_REFERENCE", "ON_RESET",
    "SELECT_PLANE", "SELECT_TOOL", "START_CHANGE", "SET_CUTTER_RADIUS_COMPENSATION", "START_CUTTER_RADIUS_COMPENSATION",
    "STOP_CUTTER_RADIUS_COMPENSATION", "COMMENT", "MESSAGE", "LOG", "SET_NAIVECAM_TOLERANCE", "USE_TOOL_LENGTH_OFFSET",
    "ORIENT_SPINDLE_OFF", "PALLET_SHUTTLE",  # M30
    "FINISH",
})  # fmt: skip
_HEAD = "G21 G90 G94 G17 G40 G49 G80\nG92.1\nG10 L2 P9 X0 Y0 Z0\nG59.3\n"
NOT_INSTALLED = (
    "LinuxCNC's interpreter is not there",
    "install the Debian package linuxcnc-uspace, or name the folder into which it is unpacked: --via-linuxcnc DIR",
)


@dataclass(frozen=True, slots=True)
class Motion:
    """kind: rapid, feed or arc; line: of the source; plane, turns, centre: of an arc; end: X Y Z A B C in machine
    coordinates, mm and deg, None where it depends on where the axes stand at first.
    """

    kind: str
    line: int
    plane: int
    turns: int
    centre: tuple[float, ...]
    end: tuple[float | None, ...]


def unrolled(
    program: Path,
    package: Path,
    offsets: Offsets,
    tools: ToolTable | None,
    name: str,
    block_delete: BlockDelete = "fault",
) -> str:
    """The program as lines and arcs in machine coordinates.

    package: the folder in which LinuxCNC is installed (`/`) or unpacked. block_delete: what / blocks are. Raises
    InputError when the interpreter is not there or refuses the program, when an offset that the program uses is not
    known, or when the program does what lines and arcs do not say.
    """
    where = package / "usr/lib/python3/dist-packages"
    if not (package / "usr/bin/rs274").is_file() or not list(where.glob("gcode*.so")):
        raise InputError([Fault("--via-linuxcnc", "", *NOT_INSTALLED)])
    if tools is not None and any(tool.offset[:2] != (0.0, 0.0) for tool in tools.tools.values()):
        raise InputError([Fault("--tools", "", "offsets of tools in X and Y do not go with --via-linuxcnc")])
    source = program.read_bytes()
    optional = _OPTIONAL.search(source)
    if optional and block_delete == "fault":
        line = source.count(b"\n", 0, optional.start()) + 1
        raise InputError([
            Fault(name, f"line {line}", "whether a block with / is run is not known", "say --block-delete run or skip")
        ])  # fmt: skip
    lengths = {} if tools is None else {number: tool.shift[2] for number, tool in tools.tools.items()}
    with tempfile.TemporaryDirectory() as folder:
        here = Path(folder)
        write_files({here / "program.ngc": source})
        _write_state(here, offsets, lengths)
        env = {
            "PATH": os.defpath, "HOME": folder,
            "LD_LIBRARY_PATH": f"{package}/usr/lib:{package}/usr/lib/{sys.implementation._multiarch}",
        }  # fmt: skip
        rs274 = [str(package / "usr/bin/rs274"), "-g", "-i", "units.ini", "-t", "tool.tbl", "-v", "calls.var"]
        rs274 += ["-b"] if block_delete == "skip" else []
        calls = _run([*rs274, "program.ngc"], here, env)  # makes the table of tools that the module reads, too
        table = json.dumps([(0, 0.0), *lengths.items()])
        given = (str(where), table)
        rounds = [
            _run([PYTHON, str(CALLS), "program.ngc", f"motions{number}.var", *given, start, block_delete], here, env)
            for number, start in enumerate(STARTS)
        ]
    _check_offsets(calls, offsets, name)
    motions = _motions(rounds, name)
    try:
        return _HEAD + "".join(f"{line}\n" for line in _blocks(calls.splitlines(), motions, [0, *lengths]))
    except ValueError as problem:
        raise InputError([Fault(name, "", f"{problem}, which is not unrolled")]) from None


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


def _write_state(here: Path, offsets: Offsets, lengths: Mapping[int, float]) -> None:
    first = offsets.first or "G54"
    values = {5220: NUMBERED.index(first) + 1.0}
    for place, system in enumerate(NUMBERED):
        table = offsets.systems.get(system, {})
        values |= {5221 + 20 * place + row: middle(table.get(axis, (0.0, 0.0))) for row, axis in enumerate(AXES)}
        values |= {5221 + 20 * place + row: 0.0 for row in (6, 7, 8, 9)}
    for base in (5161, 5181, 5211):
        values |= {base + row: 0.0 for row in range(9)}
    values[5210] = 0.0
    text = "".join(f"{number}\t{value:.6f}\n" for number, value in sorted(values.items()))
    write_files({
        here / "units.ini": "[TRAJ]\nLINEAR_UNITS = mm\n",
        here / "tool.tbl": "".join(f"T{tool} P{tool} Z{length:.6f}\n" for tool, length in lengths.items()),
        **dict.fromkeys((here / file for file in ("calls.var", "motions0.var", "motions1.var")), text),
    })  # fmt: skip


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
    found: list[list[list[object]]] = []
    for text in rounds:
        lines = [json.loads(line) for line in text.splitlines() if line.startswith("[")]
        if not lines or lines[-1][0] != "end":
            raise InputError([Fault("--via-linuxcnc", "", "the interpreter broke off")])
        _, line, result, problem = lines[-1]
        if result:
            raise InputError([Fault(name, f"line {line}", f"LinuxCNC refuses the program: {problem}")])
        others = [Fault(name, f"line {one[1]}", f"{one[2]} is not unrolled") for one in lines if one[0] == "other"]
        if others:
            raise InputError(others)
        found.append(lines[1:-1])  # the first is the motion to the start
    if [(one[0], one[1]) for one in found[0]] != [(one[0], one[1]) for one in found[1]]:
        raise InputError([Fault(name, "", "what the program does depends on where the axes stand at first")])
    motions = []
    for one, other in zip(*found, strict=True):
        kind, line, plane, turns, centre, end = one
        same = tuple(a if abs(a - b) < _SAME else None for a, b in zip(end, other[5], strict=True))
        motions.append(Motion(str(kind), int(line), int(plane), int(turns), tuple(centre), same))
    return motions


def _blocks(calls: Sequence[str], motions: Sequence[Motion], tools: Sequence[int]) -> Iterator[str]:
    """Blocks of the program: the calls of rs274 in order, with the motions in their places; tools: numbers in the order
    of the table, by which rs274 names them.

    Raises ValueError with what a call does that is not written.
    """
    at: list[float | None] = [None] * len(AXES)
    remaining = iter(motions)
    unit, plane, feed, changed = 1.0, 1, "", False
    for text in calls:
        call = _CALL.match(text)
        if call is None:
            continue
        function, arguments = call[1], call[2]
        if function in _MOTION:
            motion = next(remaining, None)
            if motion is None:
                raise ValueError("rs274 makes more motions than the module")
            if motion.kind == "arc" and motion.plane != plane:
                plane = motion.plane
                yield f"G{(17, 19, 18)[plane - 1]}"
            yield _block(motion, at, "" if motion.kind == "rapid" else feed)
            at = [before if value is None else value for before, value in zip(at, motion.end, strict=True)]
        elif function == "USE_LENGTH_UNITS":
            unit = 25.4 if "INCH" in arguments else 1.0
        elif function == "SET_FEED_RATE":
            feed = f" F{float(arguments) * unit:.4f}"
        elif function == "USE_TOOL_LENGTH_OFFSET":
            if len(tools) > 1 and not changed and any(float(value) for value in re.findall(r"[-\d.]+", arguments)):
                raise ValueError("the length of a tool is in force before a tool change")
        elif function == "CHANGE_TOOL":
            changed = True
            yield f"T{tools[int(float(arguments))]} M6"
        else:
            yield from _words(function, arguments)
    if next(remaining, None) is not None:
        raise ValueError("the module makes more motions than rs274")


def _words(function: str, arguments: str) -> Iterator[str]:
    numbers = [float(number) for number in re.findall(r"[-+]?\d+\.?\d*", arguments)]
    if function in _WORDS:
        yield _WORDS[function]
    elif function in _OUTPUTS:
        yield _OUTPUTS[function].format(*numbers)
    elif function == "SET_FEED_MODE":
        yield "G95" if numbers[-1] else "G94"
    elif function == "SET_SPINDLE_SPEED":
        yield f"S{abs(numbers[-1]):.4f}"
    elif function == "DWELL":
        yield f"G4 P{numbers[0]:.4f}"
    elif function == "SET_MOTION_CONTROL_MODE":
        mode = "G61" if "EXACT_STOP" in arguments else "G61.1" if "EXACT_PATH" in arguments else "G64"
        yield mode + (f" P{numbers[-1]:.4f}" if mode == "G64" and numbers and numbers[-1] else "")
    elif (function == "SET_SPINDLE_MODE" and not any(numbers)) or function in _SILENT:
        return
    else:
        raise ValueError(f"the program calls {function}({arguments[:30]})")


def _block(motion: Motion, at: Sequence[float | None], feed: str) -> str:
    code = {"rapid": "G0", "feed": "G1"}.get(motion.kind) or ("G3" if motion.turns > 0 else "G2")
    words = [
        f"{axis}{value:.7f}"
        for axis, value, before in zip(AXES, motion.end, at, strict=True)
        if value is not None and (before is None or abs(value - before) > _SAME)
    ]
    if motion.kind == "arc":
        rows = {1: (0, 1), 2: (1, 2), 3: (2, 0)}[motion.plane]
        start = [at[row] for row in rows]
        if None in start or None in [motion.end[row] for row in rows]:
            raise ValueError(f"the arc of line {motion.line} begins where the axes stand at first")
        words += [
            f"{'IJK'[row]}{centre - (begin or 0.0):.7f}"
            for row, centre, begin in sorted(zip(rows, motion.centre, start, strict=True))
        ]
        if abs(motion.turns) > 1:
            words.append(f"P{abs(motion.turns)}")
    if not words:  # a motion to where the axes are: nothing moves
        return f"N{motion.line}"
    return f"N{motion.line} {code} {' '.join(words)}{feed}"
