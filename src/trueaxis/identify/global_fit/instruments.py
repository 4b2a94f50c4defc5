"""Instruments as they are: what nobody can know of their set-up, as unknowns beside those of the machine.

straightness   A laser run across a straight motion: its reference line has an unknown offset and slope.
ball bar       The workpiece ball stands a little off its point (centre, one for all runs with the ball there), and the
               bar differs from its nominal length (length, for every nominal length).
probe          The zero of the readings: a displacement common to all runs with the same target and reference. A
               sphere on a body that turns in the measuring frame is besides a little off its point (centre).

Unknowns that no reading holds (the centre of a circle across its plane) are left out.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Literal, cast

import numpy as np

from trueaxis.identify.machine import IdentifiedMachine, lever
from trueaxis.identify.observations import Observations
from trueaxis.measure.machine import FloatArray, View
from trueaxis.measure.reading_model import column, home_positions, measuring_frame, sensed_directions
from trueaxis.measure.setup import Frame, PointOn, Run

Kind = Literal["offset", "slope", "centre", "length", "zero"]
KINDS: tuple[Kind, ...] = ("offset", "slope", "centre", "length", "zero")
STRAIGHT = 1e-6  # share of a motion that may lie along the sensed direction or beside the line of the motion
COORDINATES = "xyz"


@dataclass(frozen=True, slots=True)
class InstrumentUnknown:
    """One unknown of an instrument: what, of which, in mm or rad; coordinate: x, y, z of a centre or zero, else 0.

    runs: indices of the runs whose readings it is in; size: what one scaled unit is.
    """

    kind: Kind
    of: str
    unit: str
    runs: tuple[int, ...]
    coordinate: int = 0
    size: float = 1.0

    @property
    def name(self) -> str:
        """As a report says it."""
        of_vector = f" {COORDINATES[self.coordinate]}" if self.kind in ("centre", "zero") else ""
        return f"{self.kind}{of_vector} of {self.of}"


@dataclass(frozen=True, slots=True)
class Instruments:
    """All unknowns of the instruments, in a fixed order."""

    unknowns: tuple[InstrumentUnknown, ...] = ()

    @property
    def count(self) -> int:
        """How many there are."""
        return len(self.unknowns)

    def columns(self, machine: IdentifiedMachine, runs: Sequence[Run], index: int, positions: FloatArray) -> FloatArray:
        """(n, count): derivative of the readings of run `index` at positions (n_axes, n) by each scaled unknown."""
        found = np.zeros((positions.shape[1], self.count))
        for place, unknown in enumerate(self.unknowns):
            if index in unknown.runs:
                found[:, place] = _column(machine, runs[index], unknown, positions) * unknown.size
        return found

    def set_up(self, runs: Sequence[Run], values: FloatArray) -> tuple[Run, ...]:
        """The runs with the workpiece balls of ball bars where they stand; values: (count,), scaled."""
        moved = list(runs)
        for unknown, value in zip(self.unknowns, values, strict=True):
            for index in unknown.runs:
                if unknown.kind == "centre" and runs[index].instrument == "ballbar":
                    _, at = ball_of(moved[index])
                    point = np.array(at.point)
                    point[unknown.coordinate] += value * unknown.size
                    there = PointOn(at.on, tuple(point.tolist()))
                    one = moved[index]
                    moved[index] = replace(one, target=there) if at is one.target else replace(one, reference=there)
        return tuple(moved)

    def added(self, machine: IdentifiedMachine, observed: Observations, values: FloatArray) -> FloatArray:
        """(n,): what the unknowns add to the readings, mm, besides what `set_up` has done."""
        total = np.zeros(observed.reading.size)
        for unknown, value in zip(self.unknowns, values, strict=True):
            for index in unknown.runs:
                run = observed.runs[index]
                if value and not (unknown.kind == "centre" and run.instrument == "ballbar"):
                    rows = np.flatnonzero(observed.run == index)
                    total[rows] += _column(machine, run, unknown, observed.positions[:, rows]) * unknown.size * value
        return total


def instruments(machine: IdentifiedMachine, observed: Observations, kinds: Iterable[Kind]) -> Instruments:
    """The unknowns of these kinds that the readings hold."""
    chosen = set(kinds)
    found: list[InstrumentUnknown] = []
    for unknown in _candidates(machine, observed):
        if unknown.kind in chosen and any(
            np.abs(_column(machine, observed.runs[i], unknown, observed.positions[:, observed.run == i])).max(initial=0)
            > STRAIGHT
            for i in unknown.runs
        ):
            found.append(unknown)
    return Instruments(tuple(found))


def is_straightness(machine: IdentifiedMachine, run: Run, positions: FloatArray) -> bool:
    """Whether the run senses across a motion on a straight line, of the target relative to the reference."""
    if run.instrument != "laser" or run.direction is None:
        return False
    moved = relative_motion(machine, run, positions)
    sizes = np.linalg.svd(moved, compute_uv=False)
    across = float(np.abs(np.array(run.direction) @ moved).max(initial=0.0))
    longest = float(np.linalg.norm(moved, axis=0).max(initial=0.0))
    return bool(longest > 0.0 and across <= STRAIGHT * longest and sizes[1:].max(initial=0.0) <= STRAIGHT * sizes[0])


def _candidates(machine: IdentifiedMachine, observed: Observations) -> list[InstrumentUnknown]:
    found: list[InstrumentUnknown] = []
    present = [index for index in range(len(observed.runs)) if (observed.run == index).any()]
    balls: dict[PointOn, list[int]] = {}
    lengths: dict[float, list[int]] = {}
    spheres: dict[tuple[PointOn, PointOn, Frame], list[int]] = {}
    for index in present:
        run = observed.runs[index]
        if run.instrument == "ballbar":
            balls.setdefault(ball_of(run)[1], []).append(index)
            lengths.setdefault(cast(float, run.length), []).append(index)
        elif run.instrument == "probe":
            spheres.setdefault((run.target, run.reference, run.frame), []).append(index)
        elif is_straightness(machine, run, observed.positions[:, observed.run == index]):
            found.append(InstrumentUnknown("offset", f"run {run.id}", "mm", (index,)))
            found.append(InstrumentUnknown("slope", f"run {run.id}", "rad", (index,), size=1.0 / lever(machine)))
    for ball, runs in balls.items():
        of = f"the ball at {_point(ball)} ({_ids(observed, runs)})"
        found += [InstrumentUnknown("centre", of, "mm", tuple(runs), k) for k in range(3)]
    for length, runs in lengths.items():
        of = f"the bar of {length:g} mm ({_ids(observed, runs)})"
        found.append(InstrumentUnknown("length", of, "mm", tuple(runs)))
    for (_, _, frame), runs in spheres.items():
        _, sphere = ball_of(observed.runs[runs[0]])
        of = f"the probe ({_ids(observed, runs)})"
        found += [InstrumentUnknown("zero", of, "mm", tuple(runs), k) for k in range(3)]
        if sphere.on not in (frame, "bed"):
            of = f"the sphere at {_point(sphere)} ({_ids(observed, runs)})"
            found += [InstrumentUnknown("centre", of, "mm", tuple(runs), k) for k in range(3)]
    return found


def _column(machine: IdentifiedMachine, run: Run, unknown: InstrumentUnknown, positions: FloatArray) -> FloatArray:
    """(n,): derivative of the readings of a run by the unknown, per mm or rad."""
    if unknown.kind == "slope":
        return along_line(relative_motion(machine, run, positions))
    if unknown.kind in ("offset", "length"):
        return np.ones(positions.shape[1])
    direction = sensed_directions(machine, run, positions)
    if unknown.kind == "zero":
        return cast(FloatArray, direction[unknown.coordinate])
    sign, ball = ball_of(run)
    turned = carried(machine, run, ball, unknown.coordinate, positions)
    home = home_positions(run, machine.axes)
    if home is not None:
        turned = turned - carried(machine, run, ball, unknown.coordinate, home)
    return cast(FloatArray, sign * np.einsum("in,in->n", direction, turned))


def along_line(moved: FloatArray) -> FloatArray:
    """(n,): signed way along the line of the motion, towards growing coordinates, from home."""
    farthest = moved[:, int(np.linalg.norm(moved, axis=0).argmax())]
    size = float(np.linalg.norm(farthest))
    if size == 0.0:
        return np.zeros(moved.shape[1])
    line = farthest / size
    line = line * np.sign(line[int(np.abs(line).argmax())])
    return cast(FloatArray, line @ moved)


def relative_motion(machine: IdentifiedMachine, run: Run, positions: FloatArray) -> FloatArray:
    """(3, n): ideal displacement of the target relative to the reference since home, mm, measuring frame."""
    home = cast(FloatArray, home_positions(run, machine.axes))
    frame = measuring_frame(run)
    total = np.zeros((3, positions.shape[1]))
    for end, sign in ((run.target, 1.0), (run.reference, -1.0)):
        if end.on != frame:
            view = cast(View, f"{end.on}_in_{frame}")
            point = column(end.point)
            total += sign * (machine.view_ideal(view, positions, point) - machine.view_ideal(view, home, point))
    return total


def ball_of(run: Run) -> tuple[float, PointOn]:
    """The ball or sphere whose place was set up, and the sign of its coordinates in a reading: the workpiece's."""
    return (1.0, run.target) if run.target.on == "workpiece" else (-1.0, run.reference)


def carried(machine: IdentifiedMachine, run: Run, ball: PointOn, coordinate: int, positions: FloatArray) -> FloatArray:
    """(3, n): a unit vector of the body that carries the ball as the measuring frame sees it."""
    frame, unit = measuring_frame(run), np.zeros((3, 1))
    unit[coordinate] = 1.0
    if ball.on == frame:
        return np.repeat(unit, positions.shape[1], axis=1)
    view = cast(View, f"{ball.on}_in_{frame}")
    return machine.view_ideal(view, positions, unit) - machine.view_ideal(view, positions, np.zeros((3, 1)))


def ball_columns(machine: IdentifiedMachine, run: Run, positions: FloatArray) -> FloatArray:
    """(n, 3): derivative of the readings of a ball-bar run by the place of its ball on the workpiece (or bed)."""
    sign, ball = ball_of(run)
    direction = sensed_directions(machine, run, positions)
    turned = (carried(machine, run, ball, coordinate, positions) for coordinate in range(3))
    return np.stack([sign * np.einsum("in,in->n", direction, one) for one in turned], axis=1)


def _point(end: PointOn) -> str:
    return f"({', '.join(f'{value:g}' for value in end.point)}) on the {end.on}"


def _ids(observed: Observations, runs: Sequence[int]) -> str:
    return ", ".join(observed.runs[index].id for index in runs)
