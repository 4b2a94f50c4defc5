"""Candidate runs over the whole travels of a machine: of a laser, a ball bar, a probe, an angle instrument.

Every path is taken there and back, so that both directions of approach are read. Tool points are seen from the
workpiece, which is what parts are made by.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import combinations, product
from typing import cast

import numpy as np

from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.estimation.set_up import is_straightness
from trueaxis.measurement.instrument_kinds import Instrument
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import column
from trueaxis.measurement.setup import PointOn, Run, Vector
from trueaxis.planning.kit import Kit
from trueaxis.planning.paths import (
    at_share,
    follow_circle,
    follow_turn,
    grid,
    home_position,
    line,
    linear_axes,
    rotary_axes,
    there_and_back,
    tilted,
    turn,
)
from trueaxis.view import Frame

CIRCLE = 36  # readings of a circle, one way
TURNED = 1e-6  # rad: of a direction that turns with the workpiece at all
WITH_CANDIDATES: tuple[Instrument, ...] = ("laser", "ballbar", "probe", "angle")


@dataclass(frozen=True, slots=True, eq=False)
class Candidate:
    """A run that could be added, (n_axes, n) positions of its readings, and what it is in words."""

    run: Run
    positions: FloatArray
    what: str


def candidates(machine: IdentifiedMachine, kit: Kit) -> list[Candidate]:
    """All candidates, in a fixed order; ids are left to whoever takes one."""
    makers = {
        "laser": (_lines, _diagonals),
        "ballbar": (_circles, _bar_turns),
        "probe": (_grids, _sphere_turns),
        "angle": (_tilts, _rotations),
    }
    found = [one for name, of in makers.items() if name in kit.instruments for make in of for one in make(machine, kit)]

    def with_device(one: Candidate) -> Candidate:
        device = kit.device_of(one.run.instrument, straightness=is_straightness(machine, one.run, one.positions))
        return replace(one, run=replace(one.run, device=device, session=kit.session))

    return [with_device(one) for one in found]


def _lines(machine: IdentifiedMachine, kit: Kit) -> Iterator[Candidate]:
    """Along every linear axis, the others at the middle or at ends of their travels: displacement and straightness."""
    for tool, axis in product(kit.on_tool("laser"), linear_axes(machine)):
        others = [other for other in linear_axes(machine) if other != axis]
        for shares in [(0.5,) * len(others), *product((0.0, 1.0), repeat=len(others))]:
            ends = {other: (share, share) for other, share in zip(others, shares, strict=True)}
            positions = line(machine, {axis: (0.0, 1.0), **ends})
            at = _at_text({other: at_share(machine, other, share) for other, (share, _) in ends.items()})
            place = f"{axis} moving at {at}" if at else f"{axis} moving"
            motion = _motion(machine, positions, tool)
            along = int(np.abs(motion).argmax())
            for k, unit in enumerate(np.eye(3)):
                kind = "displacement" if k == along else f"straightness in {'xyz'[k]}"
                direction = _vector(motion, 9) if k == along else _vector(unit)
                yield _seen("laser", machine, positions, tool, direction, f"laser, {place}, {kind}")


def _diagonals(machine: IdentifiedMachine, kit: Kit) -> Iterator[Candidate]:
    """Displacement along the diagonals of the faces and of the volume (ISO 230-6)."""
    linear = linear_axes(machine)
    for tool, count in product(kit.on_tool("laser"), (2, 3)):
        for moved in combinations(linear, count):
            rest = [axis for axis in linear if axis not in moved]
            signs = product((1.0, 0.0), repeat=count - 1)
            for ways, shares in product(signs, product((0.0, 1.0), repeat=len(rest))):
                ends = {axis: (1.0 - way, way) for axis, way in zip(moved, (1.0, *ways), strict=True)}
                ends |= {axis: (share, share) for axis, share in zip(rest, shares, strict=True)}
                positions = line(machine, ends)
                direction = _vector(_motion(machine, positions, tool), 9)
                first, last = (
                    _at_text({axis: at_share(machine, axis, ends[axis][k]) for axis in linear}) for k in (0, 1)
                )
                what = f"laser, diagonal from {first} to {last}, displacement"
                yield _seen("laser", machine, positions, tool, direction, what)


def _grids(machine: IdentifiedMachine, kit: Kit) -> Iterator[Candidate]:
    """A calibrated plate probed in planes of the axes, low, in the middle and high; read in x, y and z."""
    linear = linear_axes(machine)
    for tool, plane in product(kit.on_tool("probe"), combinations(linear, 2)):
        rest = [axis for axis in linear if axis not in plane]
        for shares in product((0.0, 0.5, 1.0), repeat=len(rest)):
            at = {axis: at_share(machine, axis, share) for axis, share in zip(rest, shares, strict=True)}
            positions = grid(machine, plane, at)
            for unit, name in zip(np.eye(3), "xyz", strict=True):
                what = f"probe in {name}, grid in {''.join(plane)} at {_at_text(at)}"
                yield _seen("probe", machine, positions, tool, _vector(unit), what)


def _sphere_turns(machine: IdentifiedMachine, kit: Kit) -> Iterator[Candidate]:
    """A probe follows a sphere on the workpiece while a rotary axis turns."""
    for tool, axis, place in product(kit.on_tool("probe"), rotary_axes(machine), kit.places(machine)):
        for at in tilted(machine, axis, place):
            centre = machine.view_ideal("tool_in_workpiece", place, column(tool))
            turning = turn(machine, axis, at)
            positions = follow_turn(machine, turning, tool, np.repeat(centre, turning.shape[1], axis=1))
            if positions is None:
                continue
            tip, sphere = PointOn("tool", tool), PointOn("workpiece", _vector(centre[:, 0]))
            home = dict(zip(machine.axes, positions[:, 0].tolist(), strict=True))
            for frame, direction, name in _directions(machine, positions):
                run = Run(
                    id="", instrument="probe", target=tip, reference=sphere, frame=frame, home=home, direction=direction
                )
                what = f"probe in {name}, {_turn_text(machine, axis, at)} about a sphere at {_told(sphere)}"
                yield Candidate(run, there_and_back(positions), what)


def _directions(machine: IdentifiedMachine, positions: FloatArray) -> Iterator[tuple[Frame, Vector, str]]:
    """x, y and z of the bed, and those of the workpiece that turn in it: since home the former tell where the sphere
    stands and not where the axis that turns it does, the latter where the axis does and not the sphere.
    """
    origin = machine.view_ideal("workpiece_in_bed", positions, np.zeros((3, 1)))
    for unit, name in zip(np.eye(3), "xyz", strict=True):
        yield "bed", _vector(unit), name
        seen = machine.view_ideal("workpiece_in_bed", positions, column(_vector(unit))) - origin
        if float(np.ptp(seen, axis=1).max()) > TURNED:
            yield "workpiece", _vector(unit), f"{name} of the workpiece"


def _circles(machine: IdentifiedMachine, kit: Kit) -> Iterator[Candidate]:
    """The tool ball on circles about a workpiece ball, in the planes of the workpiece; arcs where travels end."""
    angle = 2.0 * np.pi * np.arange(CIRCLE) / CIRCLE
    planes = combinations(range(3), 2)
    for tool, place, plane, length in product(kit.on_tool("ballbar"), kit.places(machine), planes, kit.lengths):
        centre = machine.view_ideal("tool_in_workpiece", place, column(tool))
        way = np.repeat(centre, angle.size, axis=1)
        way[plane[0]] += length * np.cos(angle)
        way[plane[1]] += length * np.sin(angle)
        positions = follow_circle(machine, np.repeat(place, angle.size, axis=1), tool, way)
        if positions is not None:
            kind = "circle" if positions.shape[1] == angle.size else "arc"
            yield _bar(machine, tool, centre, length, positions, f"{kind} in {''.join('xyz'[i] for i in plane)}")


def _bar_turns(machine: IdentifiedMachine, kit: Kit) -> Iterator[Candidate]:
    """A rotary axis turns, the tool ball follows beside the workpiece ball: along x, y or z of the workpiece."""
    length = min(kit.lengths)
    for tool, axis, place, side in product(kit.on_tool("ballbar"), rotary_axes(machine), kit.places(machine), range(3)):
        for at in tilted(machine, axis, place):
            centre = machine.view_ideal("tool_in_workpiece", place, column(tool))
            turning = turn(machine, axis, at)
            way = np.repeat(centre + length * np.eye(3)[:, [side]], turning.shape[1], axis=1)
            positions = follow_turn(machine, turning, tool, way)
            if positions is not None:
                what = f"{_turn_text(machine, axis, at)}, bar along {'xyz'[side]}"
                yield _bar(machine, tool, centre, length, positions, what)


def _tilts(machine: IdentifiedMachine, kit: Kit) -> Iterator[Candidate]:
    """Pitch and yaw along every linear axis, by angular optics or an autocollimator, which see no roll.

    The others stand in the middle of their travels: a rotation is the same wherever they are.
    """
    tool = kit.on_tool("angle")[0]
    for axis in linear_axes(machine):
        others = {other: (0.5, 0.5) for other in linear_axes(machine) if other != axis}
        positions = line(machine, {axis: (0.0, 1.0), **others})
        along = int(np.abs(_motion(machine, positions, tool)).argmax())
        for k, unit in enumerate(np.eye(3)):
            if k != along:
                what = f"angle about {'xyz'[k]}, {axis} moving"
                yield _seen("angle", machine, positions, tool, _vector(unit), what)


def _rotations(machine: IdentifiedMachine, kit: Kit) -> Iterator[Candidate]:
    """Every rotary axis against an indexer or encoder about its own axis, the others at home."""
    tool = kit.on_tool("angle")[0]
    for axis, place in product(rotary_axes(machine), kit.places(machine)[:1]):
        positions = turn(machine, axis, place)
        about = _vector(_axis_of(machine, positions), 9)
        yield _seen("angle", machine, there_and_back(positions), tool, about, f"angle, {axis} turning, about its axis")


def _axis_of(machine: IdentifiedMachine, positions: FloatArray) -> FloatArray:
    """(3,): unit vector about which the tool turns seen from the workpiece, from the first position to the second."""
    ends = np.ascontiguousarray(positions[:, :2])
    origin = machine.view_ideal("tool_in_workpiece", ends, np.zeros((3, 1)))
    units = [machine.view_ideal("tool_in_workpiece", ends, column(_vector(unit))) - origin for unit in np.eye(3)]
    axis = sum(np.cross(one[:, 0], one[:, 1]) for one in units)  # sum of r x (R r) is 2 sin(angle) times the axis
    return np.asarray(axis / np.linalg.norm(axis))


def _seen(
    instrument: Instrument,
    machine: IdentifiedMachine,
    positions: FloatArray,
    tool: Vector,
    direction: Vector,
    what: str,
) -> Candidate:
    """The tool point against the workpiece, zeroed at the first position."""
    start = machine.view_ideal("tool_in_workpiece", np.ascontiguousarray(positions[:, :1]), column(tool))
    home = dict(zip(machine.axes, positions[:, 0].tolist(), strict=True))
    target, reference = PointOn("tool", tool), PointOn("workpiece", _vector(start[:, 0]))
    run = Run(
        id="",
        instrument=instrument,
        target=target,
        reference=reference,
        frame="workpiece",
        home=home,
        direction=direction,
    )
    return Candidate(run, positions, what)


def _bar(
    machine: IdentifiedMachine, tool: Vector, centre: FloatArray, length: float, positions: FloatArray, what: str
) -> Candidate:
    ball = PointOn("workpiece", _vector(centre[:, 0]))
    run = Run(
        id="",
        instrument="ballbar",
        target=PointOn("tool", tool),
        reference=ball,
        frame="bed",
        home=home_position(machine),
        direction=None,
        length=length,
    )
    text = f"ball bar of {length:g} mm, {what}, about {_told(ball)}"
    return Candidate(run, there_and_back(positions), text)


def _motion(machine: IdentifiedMachine, positions: FloatArray, tool: Vector) -> FloatArray:
    """(3,): unit vector from the first position of a path to its middle, seen from the workpiece."""
    ends = np.ascontiguousarray(positions[:, [0, positions.shape[1] // 2]])
    seen = machine.view_ideal("tool_in_workpiece", ends, column(tool))
    moved = seen[:, 1] - seen[:, 0]
    return np.asarray(moved / np.linalg.norm(moved))


def _turn_text(machine: IdentifiedMachine, axis: str, place: FloatArray) -> str:
    others = {other: float(place[machine.axes.index(other), 0]) for other in rotary_axes(machine) if other != axis}
    return f"{axis} turning at {_at_text(others)}" if others else f"{axis} turning"


def _at_text(positions: Mapping[str, float]) -> str:
    return " ".join(f"{axis}{position:g}" for axis, position in positions.items())


def _vector(values: FloatArray, digits: int = 3) -> Vector:
    return cast(Vector, tuple(round(float(value), digits) + 0.0 for value in values))


def _told(end: PointOn) -> str:
    return f"({', '.join(f'{part:g}' for part in end.point)}) on the {end.on}"
