"""Runs that were misread: sign reversed, wrong unit, targets labelled from the wrong end, readings of another run.

Every such fault has an inverse. A run is judged by what the others expect of it: as it is, and with each fault undone.
Where the noise is estimated, that estimate has taken a faulty run for noise, by which the run is hardly likelier with
the fault undone. So every fault that is likelier is undone on trial, noise and sizes are estimated anew, and the
marginal likelihoods of both are compared: the data are the same but for a factor or an order.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from trueaxis.estimation.fitted import Fitted, counting_in_both, evidence_ratio
from trueaxis.estimation.left_out import Contradiction, beside_others, contradiction, widest
from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.noise_of_residuals import SMALLEST
from trueaxis.estimation.own_part import by_shared, own_part_of
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.estimation.state import DISPLAY, State
from trueaxis.estimation.swapped import likelier, swap_ratios
from trueaxis.measurement.machine import FloatArray

How = Literal["reversed", "small", "large", "mirrored", "swapped"]

# By what a run's readings are multiplied to undo it; a mirrored run is put in the other order. Two swapped runs get
# each other's readings.
UNDONE: Mapping[How, float] = {"reversed": -1.0, "small": 1e3, "large": 1e-3, "mirrored": 1.0}
# Logarithm of the ratio of likelihoods from which on a run is said to be misread: were one run of a thousand misread,
# one statement of a thousand would be wrong.
SURE = float(2.0 * np.log(1e3))
# From where on it is said, with its odds, and decides nothing: one of a thousand runs is misread, and that is a guess.
SUSPICIOUS = float(np.log(1e3))
# Logarithm of the ratio from which on a fault is undone on trial, by the noise and sizes as they are; and from which on
# all is estimated anew with it undone, by an estimate that goes on from there. On the data sets of
# `python -m tests.worlds.faulty_data 2 9831 --faults 2` trials that came out SUSPICIOUS had 6.7 at least by the former,
# and going on was 2.4 below an estimate from the beginning at most. Readings that hold next to nothing but noise are as
# likely reversed as not: each of their runs would be tried.
TRIED = 1.0
# Likeliest faults that are undone on trial, each at the cost of an estimate. Of 20 worlds as they should be no run was
# likelier reversed at all, of 20 with one reversed that one alone; where the model is badly wrong all runs may be.
MOST_TRIALS = 4
DECIMALS = 9  # of mm: readings that differ by less are the same
FEWEST_TARGETS = 3
TARGETS = 6  # decimals of mm or deg, within which targets are the same

Refit = Callable[[Sequence[MeasuredRun]], Fitted]  # the estimate of runs


@dataclass(frozen=True, slots=True, kw_only=True)
class Misread:
    """how: what is wrong with a run; log_odds: logarithm of how much likelier its readings are with that undone;
    partner: the run, by index, whose readings it has if they are swapped.
    """

    how: How
    log_odds: float
    partner: int | None = None

    @property
    def sure(self) -> bool:
        """Whether it decides how a fit ended."""
        return bool(self.log_odds > SURE)


@dataclass(frozen=True, slots=True)
class _Fault:
    """places: of the run, or of the two that are swapped; among: of how many such faults it is one, of which one at
    most is there: what is likelier by it counts as much less.
    """

    places: tuple[int, ...]
    how: How
    among: int = 1

    @property
    def price(self) -> float:
        """Logarithm."""
        return float(np.log(self.among))


def misread_runs(fitted: Fitted, posterior: Posterior, continued: Refit, refit: Refit) -> dict[int, Misread]:
    """Runs by index that are likelier with a fault undone.

    One after the other: the next beside those that were undone before. Where several runs are as likely as each other
    to be the one that is misread, each is there. posterior: of what is fitted; continued: goes on from there.
    """
    found: dict[int, Misread] = {}
    undone: set[int] = set()
    while True:
        state = fitted.state
        odds = {key: odd for key, odd in _ratios(fitted, posterior).items() if not undone & set(key.places)}
        likeliest = sorted((key for key in odds if odds[key] > TRIED), key=lambda key: -odds[key])
        gains: dict[_Fault, float] = {}
        following = fitted
        for fault in likeliest[:MOST_TRIALS]:
            runs = _with_undone(state.runs, fault)
            if runs is not None:
                trial = continued(runs)
                gain = _gain(fitted, trial, fault)
                if gain > TRIED:
                    trial = refit(runs)
                    gain = _gain(fitted, trial, fault)
                if gain > max([SURE, *gains.values()]):
                    following = trial
                gains[fault] = gain
        if not gains or max(gains.values()) <= SUSPICIOUS:
            return found
        best = max(gains.values())
        alike = [key for key in gains if gains[key] > max(best - SURE, SUSPICIOUS)]
        for fault in sorted(alike, key=lambda key: -gains[key]):
            indices = [state.runs[place].rows.index for place in fault.places]
            for index, partner in zip(indices, reversed(indices), strict=True):
                with_it = partner if fault.how == "swapped" else None
                found.setdefault(index, Misread(how=fault.how, log_odds=gains[fault], partner=with_it))
        if best <= SURE:
            return found
        undone |= {place for fault in alike for place in fault.places}
        fitted = following
        posterior = fitted.posterior()


def _ratios(fitted: Fitted, posterior: Posterior) -> dict[_Fault, float]:
    """Of every fault, by the noise and sizes of the state."""
    single = {_Fault((place,), how): odds for (place, how), odds in log_ratios(fitted, posterior).items()}
    swaps = swap_ratios(fitted, posterior).items()
    double = {_Fault(swap.places, "swapped", swap.among): odds for swap, odds in swaps}
    return {fault: odds - fault.price for fault, odds in (single | double).items()}


def unexplained(fitted: Fitted, sure: Mapping[int, Misread], refit: Refit) -> list[Contradiction]:
    """Runs that contradict the others with their fault undone, too: something else is wrong with them.

    sure: runs by index that are misread; refit: of the other runs.
    """
    by_index = {one.rows.index: one for one in fitted.state.runs}
    others = [one for one in fitted.state.runs if one.rows.index not in sure]
    if not {one.noise_group for one in fitted.state.runs} <= {one.noise_group for one in others}:
        return []
    without, expected = widest(refit(others))
    found = []
    for one in fitted.state.runs:
        wrong = sure.get(one.rows.index)
        if wrong is None:
            continue
        partner = None if wrong.partner is None else by_index[wrong.partner]
        reading = undone_reading(one, wrong.how) if partner is None else partner.reading
        if reading is not None:
            undone, now = (
                beside_others(without, expected, [replace(one, reading=values)], fitted.scales)
                for values in (reading, one.reading)
            )
            if max(undone.log_p, now.log_p) < -SURE:
                found.append(contradiction((one.rows.index,), now, now, without, expected))
    return found


def log_ratios(fitted: Fitted, posterior: Posterior) -> dict[tuple[int, How], float]:
    """Of each run, by its place, and each fault: logarithm of how much likelier it is undone, by the noise and sizes of
    the state.

    With p what the others expect of the whitened readings y of a run, S the covariance of y - p, and z the readings
    with the fault undone, the logarithm is [(y - p)' S^-1 (y - p) - (z - p)' S^-1 (z - p)] / 2, and that of the factor
    for every reading. S^-1 is what is left of 1 when the run's own unknowns and those that runs share are taken out,
    and S^-1 (y - p) is the residual of the estimate of all runs.
    """
    found: dict[tuple[int, How], float] = {}
    state, sizes, x = fitted.state, fitted.sizes, fitted.x
    for place, one in enumerate(state.runs):
        # without a prior readings of any unit are as likely: more of one unit than of another tells nothing
        hows = [how for how, factor in UNDONE.items() if not (sizes.flat and abs(factor) != 1.0)]
        each = {how: reading for how in hows if (reading := undone_reading(one, how)) is not None}
        columns = np.column_stack([state.residual[place], one.reading, *each.values()])[one.good]
        residual, *white = state.whitening(place, one.kept())(columns).T
        readings = np.stack(white, axis=1)
        rest = own_part_of(state, sizes, x, place).rest(readings)
        shared = posterior.spread.T @ by_shared(state, place, rest)
        squares = readings.T @ rest - shared.T @ shared
        for column, how in enumerate(each, 1):
            change = readings[:, column] - readings[:, 0]  # (z - p) = (y - p) + change
            by_shape = float(squares[column, column] - 2.0 * squares[0, column] + squares[0, 0])
            worse = 2.0 * float(change @ residual) + by_shape
            usual = max(float(residual @ residual), float(residual.size))
            found[place, how] = likelier(worse, usual, residual.size) + _of_factor(state, place, how)
    return found


def undone_reading(one: MeasuredRun, how: How) -> FloatArray | None:
    """(n,): the readings of a run with a fault undone, mm; None where it cannot have the fault."""
    if np.ptp(one.reading) <= 10.0**-DECIMALS:
        return None  # a display that never moved
    if how != "mirrored":
        return UNDONE[how] * one.reading
    partner = _mirrored(one)
    return None if partner is None else one.reading[partner]


def _mirrored(one: MeasuredRun) -> IntArray | None:
    """(n,): the row of each row's target counted from the other end, of the same pass; None where there is none."""
    positions = np.round(one.rows.positions, TARGETS) + 0.0
    moving = np.ptp(positions, axis=1)
    if one.instrument == "ballbar" or not moving.any():
        return None
    _, target = np.unique(positions[int(np.argmax(moving))], return_inverse=True)
    count = np.bincount(target)
    if count.size < FEWEST_TARGETS or (count != count[::-1]).any():
        return None
    order = np.argsort(target, kind="stable")
    start = np.cumsum(count) - count
    turn = np.empty_like(target)
    turn[order] = np.arange(target.size) - np.repeat(start, count)  # number of the visit of its target
    return np.asarray(order[start[count.size - 1 - target] + turn])


def _of_factor(state: State, place: int, how: How) -> float:
    """Logarithm of the density of readings that are multiplied: finer ones are denser, but not what is coarser than the
    noise since the display shows no more. state: with the readings as they are.
    """
    one, factor = state.runs[place], abs(UNDONE[how])
    steps = np.diff(np.unique(np.round(one.reading[one.good], DECIMALS)))
    white = max(float(state.scales[place]) * state.noise[one.noise_group].white, SMALLEST)
    shown = DISPLAY * float(steps.min(initial=np.inf)) / white
    coarse = float(np.log(np.hypot(1.0, factor * shown) / np.hypot(1.0, shown))) if np.isfinite(shown) else np.inf
    return int(one.good.sum()) * (float(np.log(factor)) - (coarse if factor != 1.0 else 0.0))


def _with_undone(runs: Sequence[MeasuredRun], fault: _Fault) -> list[MeasuredRun] | None:
    """All readings count again."""
    whole = [replace(one, good=np.ones(one.reading.size, dtype=bool)) for one in runs]
    for place, partner in zip(fault.places, reversed(fault.places), strict=True):
        undone = runs[partner].reading if fault.how == "swapped" else undone_reading(runs[place], fault.how)
        if undone is None:
            return None
        whole[place] = replace(whole[place], reading=undone)
    return whole


def _gain(one: Fitted, other: Fitted, fault: _Fault) -> float:
    """Logarithm of how much likelier readings are by the other estimate."""
    value = evidence_ratio(one, other)
    if fault.how != "swapped":
        before, after = counting_in_both(one.state, other.state)
        (place,) = fault.places
        value += _of_factor(replace(before, noise=after.noise, scales=after.scales), place, fault.how)
    return value - fault.price


def mean_square(state: State) -> float:
    """Of the residuals that count, over their noise."""
    white = [
        state.whitening(place, one.kept())(state.residual[place][one.good][:, np.newaxis])
        for place, one in enumerate(state.runs)
    ]
    return float(np.mean(np.vstack(white) ** 2))
