"""LinuxCNC's interpreter as a process of its own: what it makes of a program, as arrays."""

import atexit
import functools
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tests.compensation.rs274_calls import libraries_of

CHILD = Path(__file__).with_name("canonical.py")
SPLINES = Path(__file__).with_name("spline_motions.cc")
PYTHON = "/usr/bin/python3"  # the one that the package's module is built for
SECONDS = 60
IN_SPINDLE = 7  # the tool before the program
MOST_MOTIONS = 2_000_000
_ROWS = {1: (0, 1, 2), 2: (1, 2, 0), 3: (2, 0, 1)}
ELSEWHERE = 0.0371  # mm: so small that neither arcs nor the number of their samples change
STEP = 0.02  # rad between the samples of an arc


@dataclass(frozen=True)
class Ran:
    """problem: why LinuxCNC does not run the program; empty if it does. features: what it does beside plain motions.

    ends: (n, 6) ends of straight motions, mm and deg, arcs sampled; feed: (n,) whether by feed; line: (n,) of the
    program; tool: (n,) number in the spindle, 0 before the first change; moves: number of motions, an arc one. free:
    (n, 3) whether X, Y, Z is still where it stood before the program.
    """

    problem: str
    features: frozenset[str] = frozenset()
    ends: NDArray[np.float64] = field(default_factory=lambda: np.zeros((0, 6)))
    feed: NDArray[np.bool_] = field(default_factory=lambda: np.zeros(0, dtype=bool))
    line: NDArray[np.int64] = field(default_factory=lambda: np.zeros(0, dtype=np.int64))
    tool: NDArray[np.int64] = field(default_factory=lambda: np.zeros(0, dtype=np.int64))
    moves: int = 0
    free: NDArray[np.bool_] = field(default_factory=lambda: np.zeros((0, 3), dtype=bool))


def diameter_of(tool: int) -> float:
    """mm: no two the same, and small enough for inside corners of contours."""
    return 2.0 + 0.01 * tool


def tool_table(tools: Mapping[int, float], unit: float) -> str:
    """LinuxCNC's, of lengths in mm by number, in a unit of so many mm."""
    return "".join(f"T{t} P{t} Z{z / unit:.9f} D{diameter_of(t) / unit:.9f}\n" for t, z in tools.items())


def packages_of(package: Path) -> tuple[Path, dict[str, str]]:
    """Where the gcode module of an unpacked package (or of `/`) is, and the environment that it needs."""
    return package / "usr/lib/python3/dist-packages", libraries_of(package)


def run(
    program: Path, package: Path, tools: Mapping[int, float], offsets: Sequence[Sequence[float]] = (),
) -> Ran:  # fmt: skip
    """Run a program; tools: length of each by number, mm; offsets: X Y Z of G54 and on, mm. Of the tools IN_SPINDLE is
    there at first.

    It is run with all axes at 0, and from another place: an axis that is elsewhere then was not commanded.
    """
    one = _run(program, package, tools, offsets, "G53 G0 X0 Y0 Z0")
    free = np.zeros((len(one.ends), 3), dtype=bool)
    if not one.problem and (np.abs(one.ends[:, :3]) < 1e-9).any():
        other = _run(program, package, tools, offsets, f"G53 G0 X{ELSEWHERE} Y{ELSEWHERE} Z{ELSEWHERE}")
        if other.ends.shape == one.ends.shape:
            free = np.abs(other.ends[:, :3] - one.ends[:, :3]) > 1e-6
    return replace(one, free=free)


def _run(
    program: Path, package: Path, tools: Mapping[int, float], offsets: Sequence[Sequence[float]], start: str
) -> Ran:
    where, environment = packages_of(package)
    with tempfile.TemporaryDirectory() as folder:
        var = Path(folder) / "linuxcnc.var"
        numbers = [*range(5161, 5170), *range(5181, 5190), *range(5210, 5220), *range(5221, 5391)]
        unused = {n for n in numbers if n > 5220 and (n - 5221) % 20 > 9}
        values = dict.fromkeys((n for n in numbers if n not in unused), 0.0) | {5220: 1.0}
        values |= {5221 + 20 * k + axis: offset[axis] for k, offset in enumerate(offsets) for axis in range(3)}
        var.write_text("".join(f"{n}\t{value:.6f}\n" for n, value in sorted(values.items())))
        env = {"PATH": os.environ["PATH"], "HOME": folder, **environment}
        preload = {"LD_PRELOAD": splines} if (splines := _splines(package)) else {}
        entries = [(tool, length, diameter_of(tool)) for tool, length in tools.items()]
        first = next((entry for entry in entries if entry[0] == IN_SPINDLE), (0, 0.0, 0.0))
        table = json.dumps([first, *entries])
        _make_tools(Path(folder), package, tools, env)
        copy = Path(folder) / "program.ngc"
        copy.write_bytes(ended(program.read_bytes()))
        command = [PYTHON, str(CHILD), str(copy), str(var), str(where), table, start]
        try:
            done = subprocess.run(
                command, cwd=folder, env=env | preload, capture_output=True, text=True, errors="replace",
                timeout=SECONDS, check=False,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            return Ran("takes more than a minute")
    lines = done.stdout.splitlines()
    if not lines or not lines[-1].startswith("end "):
        return Ran(f"the interpreter ended: {done.stderr.strip()[-100:]}")
    _, result, at, *text = lines[-1].split(" ", 3)
    if int(result) > 2:
        return Ran(f"line {at}: {text[0] if text else result}")
    return _motions(lines[:-1], tools)


@functools.cache
def _splines(package: Path) -> str:
    """A library that makes the motions of splines as LinuxCNC's control does; empty where it cannot be compiled."""
    compiler, header = shutil.which("g++"), package / "usr/include/linuxcnc/canon.hh"
    if compiler is None or not header.is_file():
        return ""
    library = Path(tempfile.mkdtemp(prefix="spline_motions")) / "spline_motions.so"
    atexit.register(shutil.rmtree, library.parent, ignore_errors=True)
    command = [compiler, "-O1", "-shared", "-fPIC", "-I", str(header.parent), "-o", str(library), str(SPLINES)]
    return str(library) if subprocess.run(command, capture_output=True, check=False).returncode == 0 else ""


def ended(program: bytes) -> bytes:
    """The program with an end: senders of hobby controls need none, LinuxCNC does."""
    percents = len(re.findall(rb"(?m)^[ \t]*%", program))
    if percents == 1:
        return program.rstrip() + b"\n%\n"
    ends = re.search(rb"(?i)M0*(?:2|30)(?![0-9])", re.sub(rb"\([^()]*\)|;.*", b"", program))
    return program if percents or ends else program.rstrip() + b"\nM2\n"


def _make_tools(folder: Path, package: Path, tools: Mapping[int, float], env: Mapping[str, str]) -> None:
    """Have the shared table of tools made; lengths in mm."""
    (folder / "tool.tbl").write_text(tool_table(tools, 1.0))
    (folder / "units.ini").write_text("[TRAJ]\nLINEAR_UNITS = mm\n")
    (folder / "empty.ngc").write_text("M2\n")
    (folder / "empty.var").write_text("")
    command = [f"{package}/usr/bin/rs274", "-g", "-i", "units.ini", "-t", "tool.tbl", "-v", "empty.var", "empty.ngc"]
    subprocess.run(command, cwd=folder, env=dict(env), capture_output=True, check=False, timeout=SECONDS)


def _motions(lines: list[str], tools: Mapping[int, float]) -> Ran:
    at = np.zeros(6)
    ends, feed, number, tool = [], [], [], []
    features: set[str] = set()
    by_length = {length: of_tool for of_tool, length in tools.items()}
    spindle, changed, moves = 0, False, -1  # the first is the motion to the start
    for text in lines:
        kind, *words = text.split()
        if kind in ("rapid", "feed", "arc"):
            points = _arc(at, words) if kind == "arc" else np.array(words[1:], dtype=float)[None]
            at = points[-1]
            moves += 1
            if moves == 0:
                continue
            ends.append(points)
            feed.append([kind != "rapid"] * len(points))
            number.append([int(words[0])] * len(points))
            tool.append([spindle] * len(points))
        elif kind == "tool":
            spindle, changed = int(words[1]), True
        elif kind == "length":
            if not changed:  # no change yet: the tool whose length is put in force is in the spindle
                spindle = by_length.get(round(float(words[1]), 6), 0)
        else:
            features.add(kind)
        if moves > MOST_MOTIONS:
            return Ran("more than two million motions")
    if not ends:
        return Ran("no motion", frozenset(features))
    joined = np.concatenate(ends)
    moving = np.linalg.norm(np.diff(joined, axis=0, prepend=np.full((1, 6), np.inf)), axis=1) > 1e-6
    if moving.sum() < 2:
        return Ran("no motion", frozenset(features))
    return Ran(
        "", frozenset(features), joined[moving], np.concatenate(feed)[moving], np.concatenate(number)[moving],
        np.concatenate(tool)[moving], moves,
    )  # fmt: skip


def _arc(start: NDArray[np.float64], words: list[str]) -> NDArray[np.float64]:
    rows, turns = _ROWS[int(words[1])], int(words[2])
    centre, end = np.array(words[3:5], dtype=float), np.array(words[5:], dtype=float)
    first, last = start[list(rows[:2])] - centre, end[list(rows[:2])] - centre
    begin, finish = np.arctan2(first[1], first[0]), np.arctan2(last[1], last[0])
    sweep = finish - begin
    if turns > 0:
        sweep = (sweep % (2 * np.pi) or 2 * np.pi) if sweep % (2 * np.pi) > 1e-9 else 2 * np.pi
        sweep += 2 * np.pi * (turns - 1)
    else:
        sweep = -((-sweep) % (2 * np.pi)) if (-sweep) % (2 * np.pi) > 1e-9 else -2 * np.pi
        sweep += 2 * np.pi * (turns + 1)
    radius = np.hypot(*first), np.hypot(*last)
    count = max(int(np.ceil(abs(sweep) / min(STEP, 2 * np.sqrt(2e-5 / max(*radius, 1e-3))))), 2)
    share = np.arange(1, count + 1) / count
    points = start + share[:, None] * (end - start)
    size, angle = radius[0] + share * (radius[1] - radius[0]), begin + share * sweep
    points[:, rows[0]] = centre[0] + size * np.cos(angle)
    points[:, rows[1]] = centre[1] + size * np.sin(angle)
    points[-1] = end
    return np.asarray(points)


if __name__ == "__main__":
    print(run(Path(sys.argv[1]), Path(sys.argv[2]), {}))
