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

from trueaxis.estimation.machine import IdentifiedMachine, lever
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.set_up import (
    STRAIGHT,
    along_line,
    ball_of,
    carried,
    is_straightness,
    relative_motion,
)
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.reading_model import home_positions, sensed_directions
from trueaxis.measure.setup import Frame, PointOn, Run

Kind = Literal["offset", "slope", "centre", "length", "zero"]
KINDS: tuple[Kind, ...] = ("offset", "slope", "centre", "length", "zero")
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


def _point(end: PointOn) -> str:
    return f"({', '.join(f'{value:g}' for value in end.point)}) on the {end.on}"


def _ids(observed: Observations, runs: Sequence[int]) -> str:
    return ", ".join(observed.runs[index].id for index in runs)
