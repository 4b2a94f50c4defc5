"""Pairs of runs whose readings are likelier each in the other's place, or by the other's set-up."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from trueaxis.estimation.fitted import Fitted
from trueaxis.estimation.left_out import beside_others, widest
from trueaxis.estimation.own_part import by_shared, own_part_of
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.measurement.machine import FloatArray

# Runs of as many readings of an instrument that are compared, those that fit worst: time grows with their square
MOST_ALIKE = 60
MOST_WRONG = 3  # runs that are wrong, of which it is asked whose they are, each at the cost of two estimates


@dataclass(frozen=True, slots=True)
class Swap:
    """Two runs by their places; among: the number of runs whose readings one of them could have, of which one at most
    is right.
    """

    places: tuple[int, int]
    among: int


def swap_ratios(fitted: Fitted, posterior: Posterior) -> dict[Swap, float]:
    """Of every two runs that could have each other's readings: logarithm of how much likelier they are swapped, by the
    noise and sizes of the state. posterior: of what is fitted. None without a prior: errors that are held at zero then
    make readings likelier in the wrong place.

    As for a single run (`misread.log_ratios`), with P the inverse of the covariance of the whitened readings, c the
    change of both runs by the swap and r = P (y - p) what is left of them, the logarithm is -(2 c' r + c' P c) / 2.
    """
    found: dict[Swap, float] = {}
    for members in () if fitted.sizes.flat else _alike(fitted):
        pairs = [pair for pair in combinations(members, 2) if _differ(*(fitted.state.runs[one] for one in pair))]
        partners = np.bincount(np.ravel(pairs), minlength=len(fitted.state.runs)) if pairs else np.zeros(0)
        told = {one: _told(fitted, posterior, one, members) for one in sorted({one for pair in pairs for one in pair})}
        for a, b in pairs:
            each = [(told[one], members.index(other)) for one, other in ((a, b), (b, a))]
            linear = sum(float(one.linear[column]) for one, column in each)
            shared = np.sum([one.shared[:, column] for one, column in each], axis=0)
            square = sum(float(one.square[column]) for one, column in each) - float(shared @ shared)
            usual, size = sum(one.left for one, _ in each), sum(one.size for one, _ in each)
            swap = Swap((a, b), int(partners[[a, b]].max()))
            found[swap] = likelier(2.0 * linear + square, max(usual, size), size)
    return found


def likelier(worse: float, usual: float, size: int) -> float:
    """Logarithm of how much likelier readings become where their square over the noise grows by `worse`.

    Sizes that were estimated with a fault may be far too small for readings without it: what is worse by them counts as
    by a normal distribution of unknown width, about the `usual` square of so many readings.
    """
    return -0.5 * worse if worse < 0.0 else -0.5 * size * float(np.log1p(worse / usual))


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _Told:
    """What a run has of the pairs it is in, by the place of the partner among the members: linear, square: (m,), r' c
    and the part of c' P c that is the run's own; shared: (n_unknowns, m); left: square of what is left; size: readings.
    """

    linear: FloatArray
    square: FloatArray
    shared: FloatArray
    left: float
    size: int


def _told(fitted: Fitted, posterior: Posterior, place: int, members: Sequence[int]) -> _Told:
    state = fitted.state
    one = state.runs[place]
    changes = [state.runs[other].reading - one.reading for other in members]
    columns = np.column_stack([state.residual[place], *changes])[one.good]
    white = state.whitening(place, one.kept())(columns)
    left, change = white[:, 0], white[:, 1:]
    rest = own_part_of(state, fitted.sizes, fitted.x, place).rest(change)
    shared = posterior.spread.T @ by_shared(state, place, rest)
    return _Told(
        linear=left @ change,
        square=np.sum(change * rest, axis=0),
        shared=shared,
        left=float(left @ left),
        size=left.size,
    )


def _alike(fitted: Fitted) -> list[list[int]]:
    """Places of runs of an instrument with as many readings; of very many those that fit worst."""
    state = fitted.state
    members: dict[tuple[str, int], list[int]] = {}
    for place, one in enumerate(state.runs):
        members.setdefault((one.instrument, one.reading.size), []).append(place)
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


def likely_pairs(fitted: Fitted, wrong: Sequence[int], refit: Callable[[Sequence[MeasuredRun]], Fitted]) -> list[Swap]:
    """Of a few runs that are wrong, by index, each with the run whose set-up explains its readings best, by an estimate
    without it; places are indices. None without a prior.
    """
    found: dict[tuple[int, int], Swap] = {}
    runs, few = fitted.state.runs, () if fitted.sizes.flat else wrong[:MOST_WRONG]
    for one in (run for run in runs if run.rows.index in few):
        others = [run for run in runs if run is not one]
        partners = [run for run in others if run.instrument == one.instrument and run.rows.run != one.rows.run]
        if not partners:
            continue
        without, expected = widest(refit(others))
        scale = fitted.scales[one.rows.index]
        far = {}
        for other in partners:
            index = other.rows.index
            there = replace(one, rows=replace(one.rows, run=other.rows.run, index=index))
            far[index] = beside_others(without, expected, [there], {index: scale}).log_p
        first, second = sorted((one.rows.index, max(far, key=lambda index: far[index])))
        found[first, second] = Swap((first, second), len(partners))
    return list(found.values())
