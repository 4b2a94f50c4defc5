"""Candidate runs: lines of a laser or probe, circles and turns of a ball bar, turns of a probe on a sphere."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, product
from typing import cast

import numpy as np

from trueaxis.estimation.machine import LINEAR, IdentifiedMachine
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.reading_model import column
from trueaxis.measure.setup import Instrument, PointOn, Run, Vector
from trueaxis.plan import boxes
from trueaxis.plan.lines import path_line

FEWEST, MOST = 5, 37  # readings of a candidate run
LENGTHS = (150.0, 100.0)  # mm: of ball bars, where the plan has none
TURN = 180.0  # deg: a rotary axis is turned this far to either side at most
SHARE = 0.5  # of the positions of a path that must be within the travels


@dataclass(frozen=True, slots=True, eq=False)
class Candidate:
    """A run that could be added, (n_axes, n) positions of its readings, and what it is in words."""

    run: Run
    positions: FloatArray
    what: str


@dataclass(frozen=True, slots=True)
class Style:
    """What candidates are made after: the runs of the plan, its instruments, readings per run, where it is zeroed."""

    runs: tuple[Run, ...]
    instruments: tuple[Instrument, ...]
    readings: int
    home: dict[str, float]


def style_of(
    machine: IdentifiedMachine, runs: Sequence[Run], readings: Sequence[int], instruments: Sequence[Instrument]
) -> Style:
    """The plan's own style; readings: of each run."""
    given = next((dict(run.home) for run in runs if run.instrument != "ballbar"), None)
    home = given or {axis: min(max(0.0, low), high) for axis, (low, high) in machine.travel.items()}
    return Style(tuple(runs), tuple(instruments), int(np.clip(np.median(readings), FEWEST, MOST)), home)


def candidates(machine: IdentifiedMachine, style: Style) -> list[Candidate]:
    """All candidates, in a fixed order; ids are left to whoever takes one."""
    found: list[Candidate] = []
    for instrument in ("laser", "probe"):
        if instrument in style.instruments:
            found += _lines(machine, style, cast(Instrument, instrument))
    if "probe" in style.instruments:
        found += _sphere_turns(machine, style)
    if "ballbar" in style.instruments:
        found += [*_circles(machine, style), *_bar_turns(machine, style)]
    return found


def _lines(machine: IdentifiedMachine, style: Style, instrument: Instrument) -> Iterator[Candidate]:
    """Along one, two or three linear axes, read along the line and along the axes of the frame."""
    linear = [axis for axis in machine.axes if axis in LINEAR]
    for (target, reference), moved in product(
        _pairs(style, instrument), [axes for n in (1, 2, 3) for axes in combinations(linear, n)]
    ):
        run = Run("", instrument, target, reference, "bed", style.home, (1.0, 0.0, 0.0))
        positions = _path(machine, style, moved)
        for direction, kind in _directions(machine, run, positions):
            place = "seen from the bed" if reference.on == "bed" else f"against the {reference.on}"
            what = f"{instrument}, {''.join(moved)} moving, {kind}, point {_told(target)} {place}"
            yield Candidate(replace(run, direction=direction), positions, what)


def _pairs(style: Style, instrument: Instrument) -> list[tuple[PointOn, PointOn]]:
    """Target and reference as in the plan, moved together to the corners and the centre of the box of such targets."""
    models: dict[tuple[str, str], Run] = {}
    for run in style.runs:
        if run.instrument == instrument:
            models.setdefault((run.target.on, run.reference.on), run)
    found = []
    for run in models.values():
        around = boxes.box([one for one in style.runs if one.instrument == instrument], run.target.on)
        for point in boxes.corners_and_centre(around) if around is not None else []:
            shift = np.subtract(point, run.target.point)
            other = run.reference
            if other.on != "bed":
                other = replace(other, point=_vector(np.add(other.point, shift)))
            found.append((PointOn(run.target.on, point), other))
    return found


def _directions(machine: IdentifiedMachine, run: Run, positions: FloatArray) -> Iterator[tuple[Vector, str]]:
    line = path_line(machine, run, positions)
    if line is None:
        return
    motion = _vector(line[0] / np.linalg.norm(line[0]), digits=9)
    single = max(abs(part) for part in motion) > 1.0 - 1e-9
    if not single:
        yield motion, "along the line"
    for unit, name in zip(np.eye(3), "xyz", strict=True):
        share = abs(float(unit @ line[0]))
        kind = "along it" if share > 1.0 - 1e-9 else "across it" if share < 1e-9 else "part of it"
        yield _vector(unit), f"in {name} ({kind})"


def _path(machine: IdentifiedMachine, style: Style, moved: Sequence[str]) -> FloatArray:
    """(n_axes, n): the axes together through their travels, the others at home."""
    steps: FloatArray = np.linspace(0.0, 1.0, style.readings)
    rows = []
    for axis in machine.axes:
        low, high = machine.travel[axis]
        rows.append(low + (high - low) * steps if axis in moved else np.full(steps.size, style.home[axis]))
    return np.asarray(np.round(np.array(rows), 3), dtype=np.float64)


def _sphere_turns(machine: IdentifiedMachine, style: Style) -> Iterator[Candidate]:
    """A probe follows a sphere on the turning workpiece; read in x, y, z of the bed."""
    for axis, place in product(_rotary(machine), _places(machine)):
        tool = _tool_point(style)
        centre = machine.view_ideal("tool_in_workpiece", place, column(tool))
        turning = _turning(machine, style, axis, place)
        positions = follow(machine, turning, tool, np.repeat(centre, turning.shape[1], axis=1))
        if positions is None:
            continue
        sphere = PointOn("workpiece", _vector(centre[:, 0]))
        first = dict(zip(machine.axes, positions[:, 0].tolist(), strict=True))
        for unit, name in zip(np.eye(3), "xyz", strict=True):
            run = Run("", "probe", PointOn("tool", tool), sphere, "bed", first, _vector(unit))
            yield Candidate(run, positions, f"probe in {name}, {axis} turning about a sphere at {_told(sphere)}")


def _circles(machine: IdentifiedMachine, style: Style) -> Iterator[Candidate]:
    """The tool ball on circles about a workpiece ball, in the planes of the workpiece."""
    tool = _tool_point(style)
    angle = 2.0 * np.pi * np.arange(style.readings) / style.readings
    for place, plane, length in product(_places(machine), combinations(range(3), 2), _lengths(style)):
        centre = machine.view_ideal("tool_in_workpiece", place, column(tool))
        way = np.repeat(centre, angle.size, axis=1)
        way[plane[0]] += length * np.cos(angle)
        way[plane[1]] += length * np.sin(angle)
        positions = follow(machine, np.repeat(place, angle.size, axis=1), tool, way)
        if positions is not None:
            name = "".join("xyz"[i] for i in plane)
            yield _bar(machine, style, centre, length, positions, f"circle of {length:g} mm in {name}")


def _bar_turns(machine: IdentifiedMachine, style: Style) -> Iterator[Candidate]:
    """A rotary axis turns, the tool ball follows beside the workpiece ball: along x, y or z of the workpiece."""
    tool = _tool_point(style)
    for axis, place, side, length in product(_rotary(machine), _places(machine), range(3), _lengths(style)):
        centre = machine.view_ideal("tool_in_workpiece", place, column(tool))
        turning = _turning(machine, style, axis, place)
        way = np.repeat(centre + length * np.eye(3)[:, [side]], turning.shape[1], axis=1)
        positions = follow(machine, turning, tool, way)
        if positions is not None:
            yield _bar(machine, style, centre, length, positions, f"{axis} turning, bar along {'xyz'[side]}")


def _bar(
    machine: IdentifiedMachine, style: Style, centre: FloatArray, length: float, positions: FloatArray, what: str
) -> Candidate:
    tool, ball = PointOn("tool", _tool_point(style)), PointOn("workpiece", _vector(centre[:, 0]))
    home = {axis: min(max(0.0, low), high) for axis, (low, high) in machine.travel.items()}
    run = Run("", "ballbar", tool, ball, "bed", home, None, length)
    return Candidate(run, positions, f"ball bar, {what}, about {_told(ball)}")


def follow(machine: IdentifiedMachine, positions: FloatArray, tool: Vector, way: FloatArray) -> FloatArray | None:
    """(n_axes, m): positions with the linear axes such that a tool point is at `way` (3, n) in the workpiece frame.

    Those outside the travels are left out; None where less than SHARE of them are within, or no axes reach it.
    """
    linear = [index for index, axis in enumerate(machine.axes) if axis in LINEAR]
    start = positions.copy()
    start[linear] = 0.0
    seen = machine.view_ideal("tool_in_workpiece", start, column(tool))
    slopes = np.empty((positions.shape[1], 3, len(linear)))
    for place, index in enumerate(linear):
        moved = start.copy()
        moved[index] = 1.0
        slopes[:, :, place] = (machine.view_ideal("tool_in_workpiece", moved, column(tool)) - seen).T
    if len(linear) != 3 or np.abs(np.linalg.det(slopes)).min(initial=1.0) < 1e-6:
        return None
    found = start
    found[linear] = np.linalg.solve(slopes, (way - seen).T[:, :, np.newaxis])[:, :, 0].T
    found = np.round(found, 3) + 0.0
    limits = np.array([machine.travel[axis] for axis in machine.axes])
    within = ((found >= limits[:, :1]) & (found <= limits[:, 1:])).all(axis=0)
    return np.ascontiguousarray(found[:, within]) if within.mean() >= SHARE else None


def _places(machine: IdentifiedMachine) -> list[FloatArray]:
    """(n_axes, 1) each: quarter, half and three quarters of every linear travel, rotary axes at 0."""
    linear = [axis for axis in machine.axes if axis in LINEAR]
    found = []
    for shares in product((0.25, 0.5, 0.75), repeat=len(linear)):
        at = dict(zip(linear, shares, strict=True))
        place = np.zeros((len(machine.axes), 1))
        for index, axis in enumerate(machine.axes):
            low, high = machine.travel[axis]
            place[index] = low + (high - low) * at[axis] if axis in at else min(max(0.0, low), high)
        found.append(place)
    return found


def _turning(machine: IdentifiedMachine, style: Style, axis: str, place: FloatArray) -> FloatArray:
    index = machine.axes.index(axis)
    low, high = machine.travel[axis]
    turning = np.repeat(place, style.readings, axis=1)
    turning[index] = np.linspace(max(low, -TURN), min(high, TURN), style.readings)
    return turning


def _rotary(machine: IdentifiedMachine) -> list[str]:
    return [axis for axis in machine.axes if axis not in LINEAR]


def _tool_point(style: Style) -> Vector:
    """Of the first point that the plan has on the tool."""
    ends = [end for run in style.runs for end in (run.target, run.reference) if end.on == "tool"]
    return ends[0].point if ends else (0.0, 0.0, 0.0)


def _lengths(style: Style) -> tuple[float, ...]:
    return tuple(dict.fromkeys(run.length for run in style.runs if run.length is not None)) or LENGTHS


def _vector(values: FloatArray, digits: int = 3) -> Vector:
    return cast(Vector, tuple(round(float(value), digits) + 0.0 for value in values))


def _told(end: PointOn) -> str:
    return f"({', '.join(f'{part:g}' for part in end.point)}) on the {end.on}"
