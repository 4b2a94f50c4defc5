"""The program that the calls and motions of LinuxCNC's interpreter make: lines and arcs in machine coordinates."""

import math
from collections import deque
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import takewhile

import numpy as np

from trueaxis.compensation.linuxcnc.modes import Call, Modes, written
from trueaxis.compensation.linuxcnc.splines import POINTS, biarcs, curve_of
from trueaxis.compensation.tools import Tool

AXES = "XYZABC"
_LARGEST_NUMBER = 99999  # of a block, in LinuxCNC
SAME = 1e-7  # mm, deg: what doubles lose on the way through inches
UNCERTAIN = "where the axes stand at first or after a tool change, or on a reference point that is not given"
# what M2 and M30 do themselves, and say just before
_RESETS = frozenset({
    "SET_G5X_OFFSET", "SET_FEED_MODE", "SET_FEED_RATE", "STOP_SPINDLE_TURNING", "SET_SPINDLE_MODE",
    "ENABLE_FEED_OVERRIDE",
})  # fmt: skip
HEAD = ("G21 G90 G94 G17 G40 G49 G80", "G92.1", "G10 L2 P9 X0 Y0 Z0", "G59.3")


@dataclass(frozen=True, slots=True, kw_only=True)
class Motion:
    """kind: rapid, feed or arc; line: of the source; plane, turns, centre: of an arc; end: X Y Z A B C in machine
    coordinates, mm and deg, None where it depends on where the axes stand at first; way: from the end before, NaN where
    that depends on it.
    """

    kind: str
    line: int
    plane: int
    turns: int
    centre: tuple[float, ...]
    end: tuple[float | None, ...]
    way: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Unrolled:
    """text: the program; lines: of the source, for each of its lines; tool: in the spindle before it, None where it
    does not say; exact_since: line of the first cycle in a path mode that the program does not say, 0: none.
    """

    text: str
    lines: tuple[int, ...]
    tool: int | None
    exact_since: int


def unrolled_program(
    made: Sequence[Motion | Call],
    tools: Mapping[int, Tool],
    axes: Sequence[str] = AXES,
    kept: bool = False,
    tool: int | None = None,
    machine_lines: Collection[int] = (),
) -> Unrolled:
    """The motions and calls in order as blocks; axes: those of the machine: others get no word while they stand at 0;
    kept: whether a tool change moves no axis; tool: in the spindle before the program, None: not known; machine_lines:
    of the source, with G53.

    Raises ValueError with what is not written, and its line.
    """
    writer = _Writer(Modes(tools, tool), axes, kept, machine_lines)
    blocks = [*((text, 1) for text in HEAD), *_blocks(writer, made)]
    return Unrolled(
        "".join(f"{text}\n" for text, _ in blocks), tuple(line for _, line in blocks), writer.modes.first_tool,
        writer.modes.exact_since,
    )  # fmt: skip


def _blocks(writer: "_Writer", made: Sequence[Motion | Call]) -> Iterator[tuple[str, int]]:
    remaining = deque(_without_resets(made))
    while remaining:
        one = remaining.popleft()
        if isinstance(one, Motion):
            texts = writer.motion(one)
        elif one.name == "NURBS_FEED":
            motions = spline_motions(remaining, one, writer.at)
            texts = (text for motion in motions for text in writer.motion(motion))
        else:
            texts = writer.call(one)
        for text in texts:
            yield text, one.line


def _without_resets(made: Sequence[Motion | Call]) -> list[Motion | Call]:
    """What is made of a program without what M2, M30 and M6 do again by themselves."""
    kept: list[Motion | Call] = []
    for one in made:
        last = kept[-1] if kept and isinstance(kept[-1], Call) else None
        if isinstance(one, Call) and one.name == "STOP_SPINDLE_TURNING" and last and last.name == "START_CHANGE":
            continue
        if isinstance(one, Call) and one.name == "PROGRAM_END":
            first = len(kept)
            while first and isinstance(before := kept[first - 1], Call) and before.line == one.line:
                first -= 1
            kept[first:] = [call for call in kept[first:] if isinstance(call, Call) and call.name not in _RESETS]
        kept.append(one)
    return kept


def spline_motions(remaining: deque[Motion | Call], call: Call, at: Sequence[float | None]) -> Iterator[Motion]:
    """Arcs and lines of a spline, for the module's motions, which are taken off; at: where it begins."""
    of_spline = takewhile(
        lambda one: isinstance(one, Motion) and one.kind == "feed" and None not in one.end[:2], remaining
    )
    given = [one for one in of_spline if isinstance(one, Motion)]
    if not given or None in at[:2]:
        raise ValueError(call.line, f"where a spline goes depends on {UNCERTAIN}")
    count = int(call.given[0])
    longest = given[: POINTS * count + 1]
    points = np.array([at[:2], *(motion.end[:2] for motion in longest)], dtype=np.float64)
    try:
        curve, used = curve_of(points, count)
        pieces = list(biarcs(curve))
    except ValueError as problem:
        raise ValueError(call.line, f"{problem} is not unrolled") from None
    for _ in range(used - 1):
        remaining.popleft()
    for end, centre, turns in pieces:
        kind = "feed" if centre is None else "arc"
        others = given[0].end[2:]
        yield Motion(
            kind=kind, line=given[0].line, plane=1, turns=turns, centre=centre or (), end=(*end, *others),
            way=(math.nan, math.nan, *(0.0,) * len(others)),
        )  # fmt: skip


class _Writer:
    """What is in force: positions (at), plane, increments, and modes."""

    def __init__(self, modes: Modes, axes: Sequence[str], kept: bool, machine_lines: Collection[int]) -> None:
        self._kept, self._machine_lines = kept, machine_lines
        self.modes = modes
        self._unknown: list[float | None] = [None if axis in axes else 0.0 for axis in AXES]
        self.at = self._unknown
        self._plane, self._absolute = 1, True

    def motion(self, motion: Motion) -> Iterator[str]:
        yield from self.modes.due()
        if motion.kind == "arc" and motion.plane != self._plane:
            self._plane = motion.plane
            yield f"G{(17, 19, 18)[self._plane - 1]}"
        by_ways = _counts_from_start(motion)
        if by_ways == self._absolute:
            self._absolute = not by_ways
            yield "G90" if self._absolute else "G91"
        rate = 0.0 if motion.kind == "rapid" else self.modes.feed(turns=_turns_alone(motion))
        fed = f" F{written(rate)}" if rate else ""
        # in machine coordinates it goes as far as the travel, and its words may stay there
        frame = "G53 " if motion.line in self._machine_lines and motion.kind == "rapid" else ""
        yield _increments(motion, fed) if by_ways else _block(motion, self.at, fed, frame)
        self.at = [before if value is None else value for before, value in zip(self.at, motion.end, strict=True)]

    def call(self, call: Call) -> Iterator[str]:
        if call.name == "CHANGE_TOOL" and not self._kept:  # axes may have moved, and get words again
            self.at = self._unknown
        yield from self.modes.words(call)


def _turns_alone(motion: Motion) -> bool:
    """Whether rotary axes move and no linear one: F is in deg/min then."""
    linear, rotary = motion.way[:3], motion.way[3:]
    return (
        motion.kind == "feed" and all(abs(way) < SAME for way in linear) and any(not abs(way) < SAME for way in rotary)
    )


def _counts_from_start(motion: Motion) -> bool:
    """Whether a motion moves an axis by an increment from where it stands at first.

    Raises ValueError where its way depends on that, too.
    """
    moved = [way for end, way in zip(motion.end, motion.way, strict=True) if end is None and not abs(way) < SAME]
    if any(math.isnan(way) for way in moved):
        raise ValueError(motion.line, f"where this motion goes depends on {UNCERTAIN}")
    return bool(moved) and motion.kind != "arc"


def _number(motion: Motion) -> str:
    """The line of the source as a block number."""
    return f"N{motion.line} " if 0 < motion.line <= _LARGEST_NUMBER else ""


def _increments(motion: Motion, feed: str) -> str:
    if any(end is not None and math.isnan(way) for end, way in zip(motion.end, motion.way, strict=True)):
        raise ValueError(motion.line, "moves axes by increments and to positions, from an unknown start")
    ways = [f"{axis}{way:.7f}" for axis, way in zip(AXES, motion.way, strict=True) if abs(way) > SAME]
    return f"{_number(motion)}{'G0' if motion.kind == 'rapid' else 'G1'} {' '.join(ways)}{feed}"


def _block(motion: Motion, at: Sequence[float | None], feed: str, frame: str) -> str:
    code = {"rapid": "G0", "feed": "G1"}.get(motion.kind) or ("G3" if motion.turns > 0 else "G2")
    words = [
        f"{axis}{value:.7f}"
        for axis, value, before in zip(AXES, motion.end, at, strict=True)
        if value is not None and (before is None or abs(value - before) > SAME)
    ]
    if motion.kind == "arc":
        rows = {1: (0, 1), 2: (1, 2), 3: (2, 0)}[motion.plane]
        start = [at[row] for row in rows]
        if None in start or None in [motion.end[row] for row in rows]:
            raise ValueError(motion.line, f"where this arc begins depends on {UNCERTAIN}")
        words += [
            f"{'IJK'[row]}{centre - (begin or 0.0):.7f}"
            for row, centre, begin in sorted(zip(rows, motion.centre, start, strict=True))
        ]
        if abs(motion.turns) > 1:
            words.append(f"P{abs(motion.turns)}")
    if not words:  # a motion to where the axes are: nothing moves
        return _number(motion).rstrip()
    return f"{_number(motion)}{frame}{code} {' '.join(words)}{feed}"
