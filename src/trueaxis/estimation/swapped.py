"""Runs whose readings are likelier in another's place, by another's set-up, or along another direction."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from trueaxis.estimation.changed import changes_of_run, log_ratio
from trueaxis.estimation.display import DECIMALS
from trueaxis.estimation.fitted import Fitted, Refit
from trueaxis.estimation.left_out import beside_others, widest
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.estimation.set_up import is_straightness, relative_motion
from trueaxis.measurement.setup import Run

# Runs of as many readings of an instrument that are compared, those that fit worst: time grows with their square
MOST_ALIKE = 60
# Runs that are wrong, of which it is asked whose they are and along what, each at the cost of three estimates
MOST_WRONG = 3
ALONG = 1e-6  # sine of an angle up to which two directions are one


@dataclass(frozen=True, slots=True)
class Swap:
    """Two runs by their places; among: the number of runs whose readings one of them could have, of which one at most
    is right.
    """

    places: tuple[int, int]
    among: int


Direction = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Turned:
    """A run by its index that sensed in another direction; among: the number of directions, of which one at most is
    right.
    """

    index: int
    direction: Direction
    among: int


def swap_ratios(fitted: Fitted, posterior: Posterior) -> dict[Swap, float]:
    """Of every two runs that could have each other's readings: logarithm of how much likelier they are swapped, by the
    noise and sizes of the state. posterior: of what is fitted. None without a prior: errors that are held at zero then
    make readings likelier in the wrong place.
    """
    runs = fitted.state.runs
    found: dict[Swap, float] = {}
    for members in () if fitted.sizes.flat else _alike(fitted):
        pairs = [pair for pair in combinations(members, 2) if _differ(*(runs[one] for one in pair))]
        partners = np.bincount(np.ravel(pairs), minlength=len(runs)) if pairs else np.zeros(0)
        changed = {
            one: changes_of_run(fitted, posterior, one, [runs[other].reading - runs[one].reading for other in members])
            for one in sorted({one for pair in pairs for one in pair})
        }
        for a, b in pairs:
            each = [(changed[one], members.index(other)) for one, other in ((a, b), (b, a))]
            found[Swap((a, b), int(partners[[a, b]].max()))] = log_ratio(each)
    return found


def _alike(fitted: Fitted) -> list[list[int]]:
    """Places of runs of a device with as many readings; of very many those that fit worst."""
    state = fitted.state
    members: dict[tuple[str, int], list[int]] = {}
    for place, one in enumerate(state.runs):
        members.setdefault((one.noise_group, one.reading.size), []).append(place)
    misfit = [float(np.mean(np.square(rest))) / float(scale) ** 2
              for rest, scale in zip(state.residual, state.scales, strict=True)]  # fmt: skip
    return [
        sorted(sorted(places, key=lambda place: -misfit[place])[:MOST_ALIKE])
        for places in members.values()
        if len(places) > 1
    ]


def _differ(one: MeasuredRun, other: MeasuredRun) -> bool:
    """Whether it makes a difference which readings are whose: repeats of a run may be taken for each other."""
    a, b = one.rows.run, other.rows.run
    set_ups = [(run.direction, run.target, run.reference, run.frame, dict(run.home), run.length) for run in (a, b)]
    return set_ups[0] != set_ups[1] or not np.array_equal(one.rows.positions, other.rows.positions)


def likely_set_ups(fitted: Fitted, wrong: Sequence[int], refit: Refit, sure: float) -> list[Swap | Turned]:
    """Of a few runs that are wrong, by index, each with the run whose set-up explains its readings best, and with the
    direction that does, if noise allows as much, by an estimate without it; places are indices. None without a prior.

    sure: minus the logarithm of the probability below which what is left is not noise.
    """
    found: dict[object, Swap | Turned] = {}
    runs, few = fitted.state.runs, () if fitted.sizes.flat else wrong[:MOST_WRONG]
    for one in (run for run in runs if run.rows.index in few):
        others = [run for run in runs if run is not one]
        partners = [
            run
            for run in others
            if run.noise_group == one.noise_group
            and run.rows.run != one.rows.run
            and _may_be(fitted, one, run.rows.run)
        ]
        directions = _other_directions(fitted, one)
        told = one.noise_group in {run.noise_group for run in others}  # the noise of the run
        if not told or not (partners or directions):
            continue
        without, expected = widest(refit(others))
        scale = fitted.scales[one.rows.index]
        likely = {}
        for other in partners:
            index = other.rows.index
            there = replace(one, rows=replace(one.rows, run=other.rows.run, index=index))
            likely[index] = beside_others(without, expected, [there], {index: scale}).log_p
        if likely:
            first, second = sorted((one.rows.index, max(likely, key=lambda index: likely[index])))
            found[first, second] = Swap((first, second), len(partners))
        far = {
            direction: beside_others(*_sensing(without, expected, one, direction), {one.rows.index: scale})
            for direction in directions
        }
        allowed = [direction for direction in directions if far[direction].log_p > -sure]
        if allowed:
            best = max(allowed, key=lambda direction: far[direction].log_density)
            found[one.rows.index, best] = Turned(one.rows.index, best, len(directions))
    return list(found.values())


def _other_directions(fitted: Fitted, one: MeasuredRun) -> list[Direction]:
    """Along the axes of the measuring frame and along the motion, both ways; not its own, nor the opposite of that,
    which is its sign. None of a display that never moved, which says nothing of a direction.
    """
    own = one.rows.run.direction
    if own is None or np.ptp(one.reading) <= 10.0**-DECIMALS:
        return []
    moved = relative_motion(fitted.state.layout.model, one.rows.run, one.rows.positions)
    along = np.linalg.svd(moved, full_matrices=False)[0][:, 0]
    axes = [*np.eye(3), *([along] if moved.any() and np.abs(along).max() < 1.0 - ALONG else [])]
    others = [axis for axis in axes if np.linalg.norm(np.cross(axis, own)) > ALONG]
    both_ways = (one for axis in others for one in (axis + 0.0, 0.0 - axis))  # no zero with a sign
    found: list[Direction] = [(float(x), float(y), float(z)) for x, y, z in both_ways]
    return [way for way in found if _may_be(fitted, one, replace(one.rows.run, direction=way))]


def _may_be(fitted: Fitted, one: MeasuredRun, set_up: Run) -> bool:
    """Whether a run may have been made by a set-up: of straightness where its instrument has read straightness, of a
    displacement where it has read displacements, in this run as it is written or in another. A curve of straightness
    that no other run tells would take up whatever is wrong.
    """
    layout = fitted.state.layout
    read = {layout.straightness[run.rows.index] for run in fitted.state.runs if run.noise_group == one.noise_group}
    return is_straightness(layout.model, set_up, one.rows.positions) in read


def _sensing(
    without: Fitted, expected: Posterior, one: MeasuredRun, direction: Direction
) -> tuple[Fitted, Posterior, list[MeasuredRun]]:
    """A run as if it had sensed in another direction, and the estimate by whose layout it is then of straightness or
    not.
    """
    layout, rows = without.state.layout, one.rows
    run = replace(rows.run, direction=direction)
    straight = list(layout.straightness)
    straight[rows.index] = is_straightness(layout.model, run, rows.positions)
    state = replace(without.state, layout=replace(layout, straightness=tuple(straight)))
    return replace(without, state=state), expected, [replace(one, rows=replace(rows, run=run))]
