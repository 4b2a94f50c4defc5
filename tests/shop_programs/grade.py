"""Compensates programs for a machine of matrices and says how far the tool is off the path, before and after.

Both programs are run by LinuxCNC's interpreter. The tool of the error-free machine at the source's motions makes the
path that was meant; the tool of the machine with errors at the written ones must keep to it.
"""

import contextlib
import hashlib
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tests.compensation.analytic_machine import XyzMachine, paper_sized
from tests.compensation.path_distance import FloatArray, apart, distances, sampled, way
from tests.compensation.rs274_calls import INCH, calls_of, different_modes
from tests.shop_programs.interpreter import IN_SPINDLE, Ran, diameter_of, ended, run, tool_table
from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.tools import Cutter, Tool, ToolTable
from trueaxis.io.faults import InputError

TRAVEL = 1500.0  # mm each way
TOLERANCE = 0.0015  # mm along the path: half a word in each axis, and the height of a chord
LENGTHS = {tool: 20.0 + 1.5 * tool for tool in range(1, 100)}  # mm; no two the same
OFFSETS = [(300.0 + 10.0 * k, -200.0, 100.0 - 5.0 * k) for k in range(9)]  # of G54 and on, mm: errors are 0 at home
SPACING = 0.2  # mm between the places of a line that are looked at


# what a program needs beside lines and arcs, by its words
KINDS = {
    "M codes of the shop, whose files are not there": r"(?i)\bM1\d\d\b",
    "macro": r"[#\[]|(?i:\bO\s*<?\w+>?\s*(?:sub|call|if|while|do|repeat|endsub))|M9[89]\b",
    "cutter compensation": r"(?i)G\s*4[12](?![\d])|G4[12]\.1",
    "threads, lathes, splines": r"(?i)G0*(?:33|76|84|74|5\.[23]|7|8|96)(?![0-9.])",
}


@dataclass(frozen=True)
class Grade:
    """kind: plain, or why it is no main program for this machine. outcome: accepted, refused, wrong, or empty.

    before, after: largest distance from the path, mm; moves: of the source and of what is written.
    """

    name: str
    kind: str
    outcome: str = ""
    reason: str = ""
    before: float = 0.0
    after: float = 0.0
    moves: tuple[int, int] = (0, 0)


def settings_of(text: str) -> Settings:
    """What a shop would give: offsets, tools, dialect, integers; M codes of overrides and outputs pass."""
    names = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"]
    offsets = {
        name: {axis: (value, value) for axis, value in zip("XYZ", values, strict=True)}
        for name, values in zip(names, OFFSETS, strict=True)
    }
    tools = ToolTable({
        tool: Tool(length=length, cutter=Cutter(diameter_of(tool))) for tool, length in LENGTHS.items()
    })  # fmt: skip
    passed = sorted({int(code) for code in re.findall(r"[Mm]0*(\d+)", text)} & {48, 49, 50, 51, 52, 53, *range(60, 69)})
    return Settings(
        dialect="linuxcnc", offsets=Offsets(offsets, {}, "G54"), tools=tools, block_delete="skip",
        pass_m=tuple(passed), start={}, reference_points={code: dict.fromkeys("XYZ", 0.0) for code in ("G28", "G30")},
    )  # fmt: skip


def machine() -> XyzMachine:
    """Errors of the paper's size, travel for all programs."""
    made = paper_sized()
    return XyzMachine(made.curves, made.squareness, travel=dict.fromkeys("XYZ", (-TRAVEL, TRAVEL)))


def kind_of(text: str, ran: Ran) -> str:
    """`plain`, or what a program needs beside lines and arcs; `no main program` where LinuxCNC runs nothing of it."""
    if ran.problem:
        return "not run by LinuxCNC" if ran.problem != "no motion" else "no motion: a subprogram or a test of words"
    code = re.sub(r"\([^()]*\)|;.*", "", text)
    if {"uvw", "turned", "probe", "tap"} & ran.features or (ran.ends[:, 3:] != 0.0).any():
        return "rotary and parallel axes, turned frames, probing, tapping"
    if np.abs(ran.ends[:, :3]).max() > TRAVEL:
        return "beyond the travel"
    return next((kind for kind, pattern in KINDS.items() if re.search(pattern, code)), "plain")


def ways(settings: Settings) -> Iterator[tuple[str, Settings]]:
    """What is given, the less the better, with its name."""
    yield "", settings
    stated = replace(settings, start=dict.fromkeys("XYZ", 0.0))
    yield "with --start", stated
    passing = replace(stated, pass_m=(*settings.pass_m, 0, 1, 6))
    yield "with --start and --pass-m 0,1,6", passing
    yield "with --start, --pass-m 0,1,6 and --spindle-tool", replace(passing, spindle_tool=IN_SPINDLE)


def grade(program: Path, package: Path, folder: Path, via: bool = False) -> Grade:
    """Grade one program; what is written goes into the folder; via: by way of --via-linuxcnc."""
    name, text = program.name, program.read_bytes().decode("latin-1")
    source = run(program, package, LENGTHS, OFFSETS)
    kind = kind_of(text, source)
    if kind.startswith(("not run", "no motion", "rotary", "beyond", "M codes")):
        return Grade(name, kind)
    out = folder / "out.ngc"
    out.unlink(missing_ok=True)
    if via:  # LinuxCNC wants an end of the program
        program = folder / "in.ngc"
        program.write_bytes(ended(text.encode("latin-1")))
    for tried, settings in ways(settings_of(text)):
        refusal = _refusal(program, out, settings, package if via else None)
        if refusal:
            continue
        written = run(out, package, LENGTHS, OFFSETS)
        if written.problem:
            return Grade(name, kind, "wrong", f"what is written does not run: {written.problem}")
        graded = _compared(name, kind, source, written, tried, settings.spindle_tool or 0)
        if via and graded.outcome == "accepted" and (problem := _other_modes(program, out, folder, package)):
            return replace(graded, outcome="wrong", reason=problem)
        return graded
    return Grade(name, kind, "refused", refusal)


def _other_modes(program: Path, out: Path, folder: Path, package: Path) -> str:
    """Which modes and calls are not those of the source, in LinuxCNC's stand-alone interpreter; empty: none."""
    values = {5220: 1.0} | {5221 + 20 * k + row: at[row] / INCH for k, at in enumerate(OFFSETS) for row in range(3)}
    values |= dict.fromkeys((*range(5161, 5170), *range(5181, 5190), *range(5210, 5220)), 0.0)
    given = tool_table(LENGTHS, INCH), values
    source, written = (
        calls_of(path, folder / "rs274", *given, skips=True, package=package) for path in (program, out)
    )  # fmt: skip
    cycles = any(one.modes["path"] != source[0].modes["path"] for one in source)
    silent = not re.search(r"(?i)G\s*6[14](?![0-9])", program.read_text("latin-1"))
    # where a program says no path mode, that of its first cycle stays
    return different_modes(source, written, ("path", "P", "Q") if cycles and silent else ())


def _refusal(program: Path, out: Path, settings: Settings, via: Path | None) -> str:
    """Why a program is refused; empty where it is written."""
    try:
        report = compensate_file(program, out, machine(), settings, language="nc", via_linuxcnc=via)
    except InputError as error:
        return "; ".join(fault.problem for fault in error.faults[:3])
    return "" if report.good else "exit code 1: an error above the tolerance is left, and reported"


def _compared(name: str, kind: str, source: Ran, written: Ran, start: str, first_tool: int) -> Grade:
    """first_tool: in the spindle before the program, where that was told; 0: no tool."""
    made = machine()
    meant, done = _runs(source), _runs(written)
    moves = (source.moves, written.moves)
    if len(meant) != len(done):
        return Grade(name, kind, "wrong", f"{len(meant)} runs of feed became {len(done)}", moves=moves)
    before = after = later = 0.0
    if any(run.free.any() for run in meant):
        start += " but for axes that it has not commanded yet"
    for a, b in zip(meant, done, strict=True):
        if (a.free != b.free).any() or np.ptp(b.points[b.free], axis=1).any():
            return Grade(name, kind, "wrong", "an axis is moved that the program does not command", moves=moves)
        if a.tool != b.tool and b.tool:  # 0: none has come, and lengths are in the words
            return Grade(name, kind, "wrong", "another tool", moves=moves)
        point = np.array([[0.0], [0.0], [-LENGTHS.get(a.tool or first_tool, 0.0)]])
        path, was, now = made.ideal(a.points, point), made.actual(a.points, point), made.actual(b.points, point)
        for points in (path, was, now):  # an axis that is not commanded has no place that was meant
            points[a.free] = 0.0
        if a.first and way(path)[-1] < 1e-6:  # a feed block that goes nowhere
            continue
        before = max(before, float(distances(was, path).max()))
        after = max(after, apart(now, path))
        rest, cut = path[:, a.first :], now[:, way(now) >= way(path)[a.first]]
        if rest.shape[1] > 1 and cut.shape[1] > 1:
            later = max(later, distances(cut, path).max(), distances(rest, now).max())
    if after < TOLERANCE:
        return Grade(name, kind, "accepted", start, before, after, moves)
    if later < TOLERANCE and after < max(before, TOLERANCE):
        return Grade(name, kind, "accepted", "the first feed after a rapid without all axes", before, later, moves)
    return Grade(name, kind, "wrong", "", before, after, moves)


class Run(NamedTuple):
    """Feed motions between two rapids, with the same axes not commanded yet: points (3, n), the tool in the spindle,
    index of the end of the first motion, and (3,) axes not commanded yet.
    """

    points: FloatArray
    tool: int
    first: int
    free: NDArray[np.bool_]


def _runs(ran: Ran) -> list[Run]:
    state = np.where(ran.feed, 1 + ran.free @ [1, 2, 4], 0)
    edges = np.flatnonzero(np.diff(state, prepend=-1, append=-1))
    found = []
    for a, b in pairwise(edges):
        if not ran.feed[a]:
            continue
        begin = a if a > 0 and (ran.free[a - 1] & ~ran.free[a]).any() else max(a - 1, 0)  # from nowhere
        ends = ran.ends[begin:b, :3].T
        first = sampled(ends[:, :2], SPACING).shape[1] - 1
        found.append(Run(sampled(ends, SPACING), int(ran.tool[a]), first, ran.free[a]))
    return found


def different(programs: list[Path]) -> list[Path]:
    """The programs, the same text once."""
    first: dict[bytes, Path] = {}
    for program in programs:
        first.setdefault(hashlib.sha256(program.read_bytes()).digest(), program)
    return list(first.values())


def all_grades(programs: list[Path], package: Path, folder: Path, via: bool) -> Iterator[Grade]:
    """Grades of many programs."""
    for program in programs:
        with contextlib.suppress(UnicodeError):
            yield grade(program, package, folder, via)
