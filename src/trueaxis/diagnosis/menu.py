"""Further runs that could be taken: made from the machine and from the runs at hand, all within the travels.

Every one is set up anew: it has its own zero or its own place of the ball, and no fault of an earlier set-up is in it.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, product

import numpy as np

from trueaxis.diagnosis.lines_at_hand import Line, line_anew, lines_at_hand, middle
from trueaxis.diagnosis.result import FloatArray
from trueaxis.diagnosis.rounds_at_hand import Round, both_ways, plane_round, rounds_at_hand, scaled_round
from trueaxis.diagnosis.rows import Rows
from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.setup import Run
from trueaxis.model.model import MachineModel

HOUR = 3600.0
SWING, WARMER = 3.0, 5.0  # K
READING_S = 6.0  # of a laser or probe, with the way to the target
SHARES = (0.1, 0.9)  # of the travels: where a line is put that is not where the others are
IRREGULAR = 0.4  # of the distance of two targets, by which each is moved at most
GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)
FEEDS = 4.0  # ratio of another feed to the one at hand
DIAMETERS = (0.5, 1.5)  # the same of diameters
FASTEST = 6000.0  # mm/min, of a ball bar
GAUGE = 1000.0  # mm, the longest step gauge
USUAL_FEED = 1000.0  # mm/min, of circles where the readings have no feed


@dataclass(frozen=True, slots=True, eq=False)
class FurtherRun:
    """One run of the menu.

    what: in words, what to do; positions, directions: (n_axes, n), mm or deg and -1, 0, +1; feed: mm/min, NaN where
    the axes stand; after: s between the last reading at hand and its first; lasts: s; warmer: (n,) K above the mean of
    the readings at hand.
    """

    what: str
    run: Run
    positions: FloatArray
    directions: FloatArray
    feed: float
    after: float
    lasts: float
    warmer: FloatArray


def menu(model: MachineModel, rows: Rows) -> tuple[FurtherRun, ...]:
    """The runs considered, the easiest first."""
    lines, rounds = lines_at_hand(model, rows), rounds_at_hand(model, rows)
    found = [*_rounds(model, rows, rounds), *_lines(model, rows, lines)]
    return tuple(_numbered(one, number) for number, one in enumerate(found))


def _numbered(one: FurtherRun, number: int) -> FurtherRun:
    return replace(one, run=replace(one.run, id=f"further run {number + 1}"))


def _of_line(line: Line, what: str, **more: object) -> FurtherRun:
    size = line.positions.shape[1]
    standard = FurtherRun(
        what, line.run, line.positions, line.directions, np.nan, HOUR, READING_S * size, np.zeros(size)
    )
    return replace(standard, **more)  # type: ignore[arg-type]


def _lines(model: MachineModel, rows: Rows, lines: Sequence[Line]) -> Iterator[FurtherRun]:
    linear = [axis for axis in model.axes if axis in LINEAR]
    first = {line.axis: line for line in reversed(lines)}
    for line in first.values():
        yield _of_line(line, f"line {line.run.id} again, aligned anew")
    for axis in linear:
        if axis not in first:
            what = f"a laser line of {axis} in the middle of the other travels"
            yield _of_line(line_anew(model, axis, middle(model)), what)
    for axis in linear:
        yield from _elsewhere(model, axis, [line for line in lines if line.axis == axis])
    for line in first.values():
        regular = _irregular(model, line)
        if regular is not None:
            yield _of_line(regular, f"line {line.run.id} with targets at irregular distances")
    for axis in linear:
        yield from _across(first.get(axis) or line_anew(model, axis, middle(model)))
    for line in first.values():
        yield from _warm(rows, line)
        if rows.time is not None:
            later = 4.0 * float(np.ptp(rows.time)) + HOUR
            yield _of_line(line, f"line {line.run.id} again {later / HOUR:.0f} h later", after=later)
    yield from _diagonals(model, linear)
    for axis in linear:
        gauge = line_anew(model, axis, middle(model), instrument="probe", longest=GAUGE)
        length = float(np.ptp(gauge.positions[model.axes.index(axis)]))
        yield _of_line(gauge, f"a probe on a calibrated step gauge of {length:.0f} mm along {axis}")


def _elsewhere(model: MachineModel, axis: str, lines: Sequence[Line]) -> Iterator[FurtherRun]:
    """The line at the two corners of the other travels that are farthest from all lines there are."""
    others = [other for other in model.axes if other in LINEAR and other != axis]
    if not lines or not others:
        return
    taken = [[_share(model, other, line.run.home[other]) for other in others] for line in lines]
    corners = list(product(SHARES, repeat=len(others)))
    distance = [min(float(np.hypot.reduce(np.subtract(corner, one))) for one in taken) for corner in corners]
    for place in np.argsort(-np.array(distance), kind="stable")[:2]:
        at = dict(lines[0].run.home)
        for other, share in zip(others, corners[place], strict=True):
            low, high = model.travel[other]
            at[other] = round(low + share * (high - low), 3)
        where = ", ".join(f"{other} {at[other]:g}" for other in others)
        yield _of_line(line_anew(model, axis, at, like=lines[0]), f"a laser line of {axis} at {where}")


def _share(model: MachineModel, axis: str, position: float) -> float:
    low, high = model.travel[axis]
    return (position - low) / (high - low) if high > low else 0.0


def _irregular(model: MachineModel, line: Line) -> Line | None:
    """Targets moved, each by its own share of their distance; None where they are irregular already."""
    row = model.axes.index(line.axis)
    targets = np.unique(line.positions[row])
    steps = np.diff(targets)
    if targets.size < 5 or float(np.ptp(steps)) > 0.2 * float(np.median(steps)):
        return None
    shift = IRREGULAR * float(np.median(steps)) * (2.0 * np.mod(GOLDEN * np.arange(targets.size), 1.0) - 1.0)
    shift[[0, -1]] = 0.0
    positions = line.positions.copy()
    positions[row] = np.round(targets + shift, 3)[np.searchsorted(targets, line.positions[row])]
    return replace(line, positions=positions)


def _across(line: Line) -> Iterator[FurtherRun]:
    """Straightness along the line, in the two frame directions across its motion."""
    along = line.motion
    for letter, unit in zip("XYZ", np.eye(3), strict=True):
        if abs(float(unit @ along)) < 1e-6:
            run = replace(line.run, instrument="laser", direction=(float(unit[0]), float(unit[1]), float(unit[2])))
            yield _of_line(replace(line, run=run), f"straightness of {line.axis} in {letter} (laser across the line)")


def _warm(rows: Rows, line: Line) -> Iterator[FurtherRun]:
    if rows.temperature is None:
        return
    size = line.positions.shape[1]
    swing = 0.5 * SWING * (1.0 - np.cos(2.0 * np.pi * np.linspace(0.0, 1.0, size)))
    what = f"line {line.run.id} again over an hour in which the temperature rises and falls by {SWING:g} K"
    yield _of_line(line, what, lasts=HOUR, warmer=swing)
    what = f"line {line.run.id} again when it is {WARMER:g} K warmer"
    yield _of_line(line, what, warmer=np.full(size, WARMER))


def _diagonals(model: MachineModel, linear: Sequence[str]) -> Iterator[FurtherRun]:
    """Laser lines along the diagonals of all travels, and of each two of them."""
    for count in range(len(linear), 1, -1):
        for moved in combinations(linear, count):
            for signs in product((1.0, -1.0), repeat=count - 1):
                way = dict(zip(moved, (1.0, *signs), strict=True))
                said = " ".join(f"{'+' if sign > 0.0 else '-'}{axis}" for axis, sign in way.items())
                yield _of_line(line_anew(model, moved[0], middle(model), way=way), f"a laser diagonal along {said}")


def _rounds(model: MachineModel, rows: Rows, rounds: Sequence[Round]) -> Iterator[FurtherRun]:
    for one in {each.plane: each for each in reversed(rounds)}.values():
        alike = [each for each in rounds if each.plane == one.plane]
        if not both_ways(alike):
            there = replace(one, positions=one.positions[:, ::-1], directions=-one.directions[:, ::-1])
            yield _of_round(there, one.feed, f"circle {one.run.id} in the other direction")
        if rows.feed is not None:
            feeds = {each.feed for each in alike}
            feed = one.feed * FEEDS if one.feed * FEEDS <= FASTEST else one.feed / FEEDS
            if all(abs(feed - each) > 0.2 * feed for each in feeds):
                yield _of_round(one, feed, f"circle {one.run.id} at {feed:.0f} mm/min")
    linear = [axis for axis in model.axes if axis in LINEAR]
    for plane in combinations(linear, 2):
        if all(frozenset(plane) != frozenset(each.plane) for each in rounds):
            circle = plane_round(model, plane, rounds)
            if circle is not None:
                feed = rounds[0].feed if rounds else USUAL_FEED
                what = f"a circle of {2.0 * float(circle.run.length or 0.0):.0f} mm diameter in {''.join(plane)}"
                yield _of_round(circle, feed, what)
    for one in {each.plane: each for each in reversed(rounds)}.values():
        for ratio in DIAMETERS:
            other = scaled_round(model, one, ratio)
            if other is not None:
                what = f"circle {one.run.id} with a bar of {other.run.length:g} mm"
                yield _of_round(other, one.feed, what)


def _of_round(one: Round, feed: float, what: str) -> FurtherRun:
    way = float(np.linalg.norm(np.diff(one.positions, axis=1), axis=0).sum())
    size = one.positions.shape[1]
    feed = feed if np.isfinite(feed) else USUAL_FEED
    return FurtherRun(
        what,
        one.run,
        np.ascontiguousarray(one.positions),
        np.ascontiguousarray(one.directions),
        feed,
        HOUR,
        60.0 * way / feed,
        np.zeros(size),
    )
