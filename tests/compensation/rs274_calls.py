"""What LinuxCNC's stand-alone interpreter `rs274` makes of a program: motions and events, with the modes in force.

Nothing here uses src. rs274 takes parameters and the table of tools in inches, and prints lengths in the units of the
program with four decimals; here everything is in mm.
"""

import math
import re
import subprocess
from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

import numpy as np

INCH = 25.4
PRINTED = 0.005  # mm: half of the last decimal in inches, of a position, an offset and a length
_CALL = re.compile(r"\s*\d+\s+N(?:\.+|\d+)\s*([A-Z]\w*)\((.*)\)\s*$")
_PLANES = {"XY": (0, 1, 2), "YZ": (1, 2, 0), "XZ": (2, 0, 1)}
_EVENTS = frozenset({
    "DWELL", "PROGRAM_STOP", "OPTIONAL_PROGRAM_STOP", "PALLET_SHUTTLE", "PROGRAM_END", "MESSAGE", "SELECT_TOOL",
    "CHANGE_TOOL", "CHANGE_TOOL_NUMBER", "SET_MOTION_OUTPUT_BIT", "CLEAR_MOTION_OUTPUT_BIT",
    "SET_MOTION_OUTPUT_VALUE", "SET_AUX_OUTPUT_BIT", "CLEAR_AUX_OUTPUT_BIT", "SET_AUX_OUTPUT_VALUE",
})  # fmt: skip
_SWITCHES = {
    "MIST_ON": ("mist", 1.0), "MIST_OFF": ("mist", 0.0), "FLOOD_ON": ("flood", 1.0), "FLOOD_OFF": ("flood", 0.0),
    "ENABLE_FEED_OVERRIDE": ("override", 1.0), "DISABLE_FEED_OVERRIDE": ("override", 0.0),
    "ENABLE_SPEED_OVERRIDE": ("speed override", 1.0), "DISABLE_SPEED_OVERRIDE": ("speed override", 0.0),
    "ENABLE_ADAPTIVE_FEED": ("adaptive", 1.0), "DISABLE_ADAPTIVE_FEED": ("adaptive", 0.0),
    "ENABLE_FEED_HOLD": ("hold", 1.0), "DISABLE_FEED_HOLD": ("hold", 0.0),
    "START_SPINDLE_CLOCKWISE": ("turns", 1.0), "START_SPINDLE_COUNTERCLOCKWISE": ("turns", -1.0),
    "STOP_SPINDLE_TURNING": ("turns", 0.0),
}  # fmt: skip


def libraries_of(package: Path) -> dict[str, str]:
    """The environment that programs of an unpacked package (or of `/`) need."""
    return {"LD_LIBRARY_PATH": f"{package}/usr/lib:{package}/usr/lib/x86_64-linux-gnu"}


@dataclass(frozen=True)
class Made:
    """A motion (kind rapid or feed; end X Y Z in machine coordinates, mm; arc: whether it is one) or an event (its
    call), and the modes in force there.
    """

    kind: str
    end: tuple[float, ...]
    modes: Mapping[str, float]
    arc: bool = False


def calls_of(
    program: Path, folder: Path, tools: str, parameters: Mapping[int, float], skips: bool = False,
    package: Path = Path("/"),
) -> list[Made]:  # fmt: skip
    """What rs274 makes of a program; tools, parameters: as rs274 takes them, lengths in inches; skips: / blocks;
    package: where LinuxCNC is installed or unpacked.
    """
    folder.mkdir(exist_ok=True)
    (folder / "tool.tbl").write_text(tools)
    (folder / "rs274.var").write_text("".join(f"{n}\t{value:.9f}\n" for n, value in sorted(parameters.items())))
    command = [
        f"{package}/usr/bin/rs274",
        *(["-b"] if skips else []),
        "-g",
        "-t",
        "tool.tbl",
        "-v",
        "rs274.var",
        str(program.resolve()),
    ]
    done = subprocess.run(
        command, cwd=folder, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False, timeout=60,
        env={"PATH": "/usr/bin:/bin", "HOME": str(folder), **libraries_of(package)}, errors="replace",
    )  # fmt: skip
    assert "PROGRAM_END" in done.stdout, done.stderr[-300:]
    return _made(done.stdout)


def _made(text: str) -> list[Made]:
    unit, rows = 1.0, _PLANES["XY"]
    shifts = {name: np.zeros(3) for name in ("SET_G5X_OFFSET", "SET_G92_OFFSET", "USE_TOOL_LENGTH_OFFSET")}
    modes: dict[str, float] = {"path": 3.0, "P": 0.0, "Q": 0.0, "by turns": 0.0, "F": 0.0, "turns": 0.0, "S": 0.0}
    made = []
    for call in filter(None, map(_CALL.match, text.splitlines())):
        name, said = call[1], call[2]
        numbers = [float(number) for number in re.findall(r"[-+]?\d+\.?\d*", said)]
        if name == "USE_LENGTH_UNITS":
            unit = INCH if "INCH" in said else 1.0
        elif name in shifts:
            shifts[name] = np.array(numbers[name == "SET_G5X_OFFSET" :][:3]) * unit
        elif name == "SELECT_PLANE":
            rows = _PLANES[said[-2:]]
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "ARC_FEED"):
            end = np.array(numbers[:3])
            if name == "ARC_FEED":
                end[list(rows)] = numbers[0], numbers[1], numbers[5]
            kind = "rapid" if name == "STRAIGHT_TRAVERSE" else "feed"
            made.append(Made(kind, tuple(end * unit + sum(shifts.values())), dict(modes), name == "ARC_FEED"))
        elif name == "NURBS_FEED":  # a spline, of which rs274 does not say where it ends
            made.append(Made("feed", (math.nan,) * 3, dict(modes), arc=True))
        elif name in _EVENTS:
            made.append(Made(f"{name}({said.replace(' ', '')})", (), dict(modes)))
        else:
            modes |= _modes(name, said, numbers, unit, modes)
    return made


def _modes(
    name: str, said: str, numbers: Sequence[float], unit: float, before: Mapping[str, float]
) -> dict[str, float]:
    """What a call puts in force."""
    found: dict[str, float] = {}
    if name in _SWITCHES:
        found = dict([_SWITCHES[name]])
    elif name == "SET_MOTION_CONTROL_MODE":
        kind = {"EXACT_STOP": 1.0, "EXACT_PATH": 2.0}.get(said.partition("CANON_")[2].partition(",")[0], 3.0)
        found = {"path": kind} | ({"P": numbers[-1] * unit} if kind == 3.0 else {})
    elif name == "SET_NAIVECAM_TOLERANCE":
        found = {"Q": numbers[0] * unit}
    elif name == "SET_FEED_MODE":
        found = {"by turns": numbers[-1]}
    elif name == "SET_FEED_RATE":
        found = {"F": numbers[0] * unit}
    elif name == "SET_SPINDLE_MODE":
        found = {"surface": min(numbers[-1], 1e9)}
    elif name == "SET_SPINDLE_SPEED":  # along the surface in m/min or ft/min
        foot = 0.3048 if before.get("surface") and unit != 1.0 else 1.0
        found = {"S": abs(numbers[-1]) * foot}
    return found


def different(source: Sequence[Made], written: Sequence[Made], within: float) -> str:
    """What is not the same in both, empty if nothing is; within: mm, between ends of motions, which may be cut."""
    parts, others = _parts(source), _parts(written)
    if [kind for kind, _ in parts] != [kind for kind, _ in others]:
        return f"{[kind for kind, _ in parts]} became {[kind for kind, _ in others]}"
    for (kind, meant), (_, done) in zip(parts, others, strict=True):
        if kind not in ("rapid", "feed"):
            if problem := _other_modes(meant[0], done[0], feeds=False):
                return f"{kind}: {problem}"
            continue
        place = 0
        for one in meant:
            while place < len(done) and not np.allclose(one.end, done[place].end, rtol=0.0, atol=within):
                place += 1
            if place == len(done):
                return f"{kind} to {one.end}: not among {[two.end for two in done]}"
            if problem := _other_modes(one, done[place], feeds=kind == "feed"):
                return f"{kind} to {one.end}: {problem}"
        if place < len(done) - 1:
            return f"{kind}: beyond {meant[-1].end} to {done[-1].end}"
    return ""


def different_modes(source: Sequence[Made], written: Sequence[Made], left_out: Container[str] = ()) -> str:
    """What of the modes in force at motions, and of the events between them, is not the same; empty if nothing is.

    Ends are not looked at; left_out: names of modes.
    """
    meant, done = _changes(source, left_out), _changes(written, left_out)
    for a, b in zip(meant, done, strict=False):
        if a.kind != b.kind:
            return f"{a.kind} became {b.kind}"
        if problem := _other_modes(a, b, feeds=a.kind == "feed"):
            return f"{a.kind}: {problem}"
    return "" if len(meant) == len(done) else f"{len(meant)} changes of modes became {len(done)}"


def _changes(made: Sequence[Made], left_out: Container[str]) -> list[Made]:
    """The events, and the first motion of each kind and under each modes; those that go nowhere are left out."""
    found: list[Made] = []
    place: tuple[float, ...] = (0.0, 0.0, 0.0)  # where rs274 has the axes at first
    for one in made:
        modes = {name: value for name, value in one.modes.items() if name not in left_out}
        fresh = Made(one.kind, one.end, modes)
        still = (
            bool(one.end)
            and not one.arc
            and len(place) == len(one.end)
            and np.allclose(one.end, place, rtol=0.0, atol=PRINTED / 5)
        )
        place = one.end or place
        last = found[-1] if found else None
        same = last is not None and bool(last.end) and last.kind == one.kind
        if still or (last is not None and same and not _other_modes(last, fresh, feeds=one.kind == "feed")):
            continue
        found.append(fresh)
    return found


def _parts(made: Sequence[Made]) -> list[tuple[str, list[Made]]]:
    """Motions of one kind together, each event alone; the first motions may go to where the axes stand."""
    numbered = enumerate(made)
    together = groupby(numbered, key=lambda one: one[1].kind if one[1].end else f"{one[0]} {one[1].kind}")
    parts = [[made for _, made in group] for _, group in together]
    return [(part[0].kind, part) for part in parts]


def _other_modes(one: Made, other: Made, feeds: bool) -> str:
    for name in sorted(set(one.modes) | set(other.modes)):
        a, b = one.modes.get(name, 0.0), other.modes.get(name, 0.0)
        allowed = PRINTED / 2 if name in ("P", "Q") else 2e-3 * max(abs(a), 1.0)
        if (name != "F" or feeds) and abs(a - b) > allowed and not (name in ("P", "Q") and one.modes["path"] != 3.0):
            return f"{name} {a:g} became {b:g}"
    return ""
