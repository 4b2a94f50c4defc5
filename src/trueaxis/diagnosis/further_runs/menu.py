"""Further runs that could be taken: those at hand otherwise than they were, and the candidates of `plan`.

Every one is set up anew: it has its own zero or its own place of the ball, and no fault of an earlier set-up is in it.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.diagnosis.further_runs.at_hand import (
    Line,
    Round,
    both_ways,
    is_along,
    lines_at_hand,
    motion_of,
    rounds_at_hand,
)
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.result import FloatArray
from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.approach import approach_directions
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.model import MachineModel
from trueaxis.planning.candidates import Candidate, candidates
from trueaxis.planning.kit import LENGTHS, Kit

HOUR = 3600.0
SWING, WARMER = 3.0, 5.0  # K
READING_S = 6.0  # of a laser or probe, with the way to the target
ASIDE = 100.0  # mm: as far as an optic is easily moved on the tool, and its line beside it
SLANTED = 0.5  # cosine of a motion and a direction, up to which the direction is across the motion
IRREGULAR = 0.4  # of the distance of two targets, by which each is moved at most
GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)
FEEDS = 4.0  # ratio of another feed to the one at hand
DIAMETERS = (1.0, 0.5, 1.5)  # of circles, in those at hand
FASTEST = 6000.0  # mm/min, of a ball bar
GAUGE = 1000.0  # mm, the longest step gauge
USUAL_FEED = 1000.0  # mm/min, of circles where the readings have no feed


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class FurtherRun:
    """One run of the menu.

    what: in words, what to do; positions, directions: (n_axes, n), mm or deg and -1, 0, +1; feed: mm/min, NaN where
    the axes stand; after: s between the last reading at hand and its first; lasts: s; warmer: (n,) K above the
    course of the readings at hand.
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
    rounds = rounds_at_hand(model, rows)
    found = [*_rounds(rows, rounds), *_lines(model, rows, lines_at_hand(model, rows)), *_anew(model, rows, rounds)]
    return tuple(_numbered(one, number) for number, one in enumerate(found))


def _numbered(one: FurtherRun, number: int) -> FurtherRun:
    return replace(one, run=replace(one.run, id=f"further run {number + 1}"))


def _of_line(line: Line, what: str, **more: object) -> FurtherRun:
    size = line.positions.shape[1]
    standard = FurtherRun(
        what=what,
        run=line.run,
        positions=line.positions,
        directions=line.directions,
        feed=np.nan,
        after=HOUR,
        lasts=READING_S * size,
        warmer=np.zeros(size),
    )
    return replace(standard, **more)  # type: ignore[arg-type]


def _lines(model: MachineModel, rows: Rows, lines: Sequence[Line]) -> Iterator[FurtherRun]:
    first = {line.axis: line for line in reversed(lines)}
    for line in first.values():
        yield _of_line(line, f"line {line.run.id} again, aligned anew")
    for line in first.values():
        regular = _irregular(model, line)
        if regular is not None:
            yield _of_line(regular, f"line {line.run.id} with targets at irregular distances")
    for line in first.values():
        yield from _elsewhere(line)
    for line in first.values():
        yield from _warm(rows, line)
        if rows.time is not None:
            later = 4.0 * float(np.ptp(rows.time)) + HOUR
            yield _of_line(line, f"line {line.run.id} again {later / HOUR:.0f} h later", after=later)


def _irregular(model: MachineModel, line: Line) -> Line | None:
    """Targets moved, each by its own share of their distance; None where they are irregular already."""
    row = model.axes.index(line.axis)
    targets = np.unique(line.positions[row])
    steps = np.diff(targets)
    if targets.size < 5 or float(np.ptp(steps)) > IRREGULAR * float(np.median(steps)):
        return None
    shift = IRREGULAR * float(np.median(steps)) * (2.0 * np.mod(GOLDEN * np.arange(targets.size), 1.0) - 1.0)
    shift[[0, -1]] = 0.0
    positions = line.positions.copy()
    positions[row] = np.round(targets + shift, 3)[np.searchsorted(targets, line.positions[row])]
    return replace(line, positions=positions)


def _elsewhere(line: Line) -> Iterator[FurtherRun]:
    """Across the motion: an angle moves the optic there by as much more, the error of a point by no more."""
    for k, letter in enumerate("XYZ"):
        if abs(line.motion[k]) > SLANTED:
            continue
        shift = ASIDE * np.eye(3)[k]
        run = replace(line.run, target=_shifted(line.run.target, shift), reference=_shifted(line.run.reference, shift))
        yield _of_line(
            line, f"line {line.run.id} again with the optics {ASIDE:g} mm further towards {letter}+", run=run
        )


def _shifted(end: PointOn, shift: FloatArray) -> PointOn:
    """A point of a body elsewhere by a way that all bodies see alike, with the axes at home."""
    x, y, z = (round(float(part), 6) for part in np.array(end.point) + shift)
    return replace(end, point=(x, y, z))


def _warm(rows: Rows, line: Line) -> Iterator[FurtherRun]:
    if rows.temperature is None:
        return
    size = line.positions.shape[1]
    swing = 0.5 * SWING * (1.0 - np.cos(2.0 * np.pi * np.linspace(0.0, 1.0, size)))
    what = f"line {line.run.id} again over an hour in which the temperature rises and falls by {SWING:g} K"
    yield _of_line(line, what, lasts=HOUR, warmer=swing)
    what = f"line {line.run.id} again when it is {WARMER:g} K warmer"
    yield _of_line(line, what, warmer=np.full(size, WARMER))


def _rounds(rows: Rows, rounds: Sequence[Round]) -> Iterator[FurtherRun]:
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


def _anew(model: MachineModel, rows: Rows, rounds: Sequence[Round]) -> Iterator[FurtherRun]:
    """Candidates with the points in the tool frame and the bars at hand, and lines along the axes on a step gauge."""
    ends = [end for index in rows.present for end in (rows.runs[index].target, rows.runs[index].reference)]
    tools = tuple(dict.fromkeys(end.point for end in ends if end.on == "tool"))[:1] or ((0.0, 0.0, 0.0),)
    at_hand = next((one.run.length for one in rounds if one.run.length is not None), None)
    lengths = LENGTHS if at_hand is None else tuple(at_hand * ratio for ratio in DIAMETERS)
    found = candidates(model, Kit(instruments=("laser", "ballbar"), tools=tools, lengths=lengths, everywhere=False))
    feed = rounds[0].feed if rounds else USUAL_FEED
    for one in found:
        yield _of_candidate(model, one, feed)
    for axis in (one for one in model.axes if one in LINEAR):
        row = model.axes.index(axis)
        lines = [one for one in found if [*np.flatnonzero(np.ptp(one.positions, axis=1))] == [row]]
        line = next(one for one in lines if is_along(one.run, motion_of(model, one.run, one.positions)))
        at = line.positions[row]
        kept = np.abs(at - 0.5 * (at.min() + at.max())) <= 0.5 * GAUGE
        positions = np.ascontiguousarray(line.positions[:, kept])
        what = f"a probe on a calibrated step gauge of {np.ptp(positions[row]):.0f} mm along {axis}"
        yield _of_candidate(model, Candidate(replace(line.run, instrument="probe"), positions, what), feed)


def _of_candidate(model: MachineModel, one: Candidate, feed: float) -> FurtherRun:
    size = one.positions.shape[1]
    directions = approach_directions(one.run, model.axes, np.arange(size), one.positions).astype(np.float64)
    if one.run.length is not None:
        return _of_round(
            Round(plane="", sense=1, feed=feed, run=one.run, positions=one.positions, directions=directions),
            feed,
            one.what,
        )
    return FurtherRun(
        what=one.what,
        run=one.run,
        positions=one.positions,
        directions=directions,
        feed=np.nan,
        after=HOUR,
        lasts=READING_S * size,
        warmer=np.zeros(size),
    )


def _of_round(one: Round, feed: float, what: str) -> FurtherRun:
    way = float(np.linalg.norm(np.diff(one.positions, axis=1), axis=0).sum())
    size = one.positions.shape[1]
    feed = feed if np.isfinite(feed) else USUAL_FEED
    return FurtherRun(
        what=what,
        run=one.run,
        positions=np.ascontiguousarray(one.positions),
        directions=np.ascontiguousarray(one.directions),
        feed=feed,
        after=HOUR,
        lasts=60.0 * way / feed,
        warmer=np.zeros(size),
    )
