"""Runs that were misread: sign reversed, wrong unit, targets labelled from the wrong end, readings of another run.

All runs of an instrument may have the same wrong sign or unit: that is one fault, not many. Every such fault has an
inverse. A run is judged by what the others expect of it: as it is, and with each fault undone. Where the noise is
estimated, that estimate has taken a faulty run for noise, by which the run is hardly likelier with the fault undone. So
every fault that is likelier is undone on trial, noise and sizes are estimated anew, and the marginal likelihoods of
both are compared: the data are the same but for a factor or an order.
"""

from collections.abc import Collection, Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from trueaxis.estimation.changed import ChangesOfRun, changes_of_run, log_ratio
from trueaxis.estimation.display import DECIMALS, ROUNDING
from trueaxis.estimation.fitted import Continued, Fitted, Refit, counting_in_both, evidence_ratio
from trueaxis.estimation.noise_of_residuals import SMALLEST
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.estimation.state import State
from trueaxis.estimation.swapped import swap_ratios
from trueaxis.estimation.undone import OF_INSTRUMENTS, ONLY_TOGETHER, UNDONE, UNITS, How, undone_reading
from trueaxis.measurement.setup import Vector
from trueaxis.view import Frame

# Logarithm of the ratio of likelihoods from which on a run is said to be misread: were one run of a thousand misread,
# one statement of a thousand would be wrong.
SURE = float(2.0 * np.log(1e3))
# By how much more an instrument in inches or arcseconds has to be likelier: errors may well be five or twenty times
# smaller than [prior] has them. On sound lines of three axes with angle runs inches were likelier by 15; where they
# were inches, by 1372, arcseconds by 252.
BY_SIZE = 2.0 * SURE
# From where on it is said, with its odds, and decides nothing: one of a thousand runs is misread, and that is a guess.
SUSPICIOUS = float(np.log(1e3))
# Logarithm of the ratio from which on a fault is undone on trial, by the noise and sizes as they are; and from which on
# all is estimated anew with it undone, by an estimate that goes on from there. On the data sets of
# `python -m tests.worlds.faulty_data 2 9831 --faults 2` trials that came out SUSPICIOUS had 6.7 at least by the former,
# and going on was 2.4 below an estimate from the beginning at most. Readings that hold next to nothing but noise are as
# likely reversed as not: each of their runs would be tried.
TRIED = 1.0
# Below the likeliest fault by how much others are not tried from the beginning: they would be named beside it from SURE
# below on, and may come out likelier by a few
NEAR = 2.0 * SURE
# Likeliest faults that are undone on trial, each at the cost of an estimate. Of 20 worlds as they should be no run was
# likelier reversed at all, of 20 with one reversed that one alone; where the model is badly wrong all runs may be.
MOST_TRIALS = 4
# mm: less than any instrument scatters in a shop, where air and temperature alone make some ten nanometres in a metre.
LEAST_NOISE = 2e-5


@dataclass(frozen=True, slots=True, kw_only=True)
class Misread:
    """how: what is wrong with a run; log_odds: logarithm of how much likelier its readings are with that undone;
    partner: the run, by index, whose readings it has if they are swapped; together: the runs, by index, of an
    instrument, or of it in a session, of which all have the fault, itself among them, else none; direction: along which
    it reads; frame: in which it reads.
    """

    how: How
    log_odds: float
    partner: int | None = None
    together: tuple[int, ...] = ()
    direction: Vector | None = None
    frame: Frame | None = None

    @property
    def sure(self) -> bool:
        """Whether it decides how a fit ended."""
        return bool(self.log_odds > SURE)


@dataclass(frozen=True, slots=True)
class Fault:
    """places: of the run, of all runs of an instrument, or of the two that are swapped; among: of how many such faults
    it is one, of which one at most is there: what is likelier by it counts as much less.
    """

    places: tuple[int, ...]
    how: How
    among: int = 1

    @property
    def of_instrument(self) -> bool:
        """Whether all runs of one have it."""
        return len(self.places) > 1 and self.how != "swapped"

    @property
    def price(self) -> float:
        """Logarithm."""
        return float(np.log(self.among))


@dataclass(frozen=True, slots=True, eq=False)
class MisreadRuns:
    """runs: by index, those that are likelier with a fault undone; mistakes: the runs, by index, of each fault that is
    sure, of which one is undone at least; undone: the estimate with those undone.
    """

    runs: dict[int, Misread]
    mistakes: tuple[frozenset[int], ...]
    undone: Fitted


def misread_runs(fitted: Fitted, posterior: Posterior, continued: Continued, refit: Refit) -> MisreadRuns:
    """One after the other: the next beside those that were undone before. Where several runs are as likely as each
    other to be the one that is misread, each is there, and the likeliest is undone. posterior: of what is fitted.
    """
    found: dict[int, Misread] = {}
    undone: set[Fault] = set()
    mistakes: list[frozenset[int]] = []
    while True:
        state = fitted.state
        # beside a fault of all its instrument a run may have one of its own
        taken = {place for fault in undone if not fault.of_instrument for place in fault.places}
        ratios = _ratios(fitted, posterior).items()
        odds = {key: odd for key, odd in ratios if key not in undone and not taken & set(key.places)}
        likeliest = sorted((key for key in odds if odds[key] > TRIED), key=lambda key: -odds[key])
        trials = _undone_on_trial(fitted, _with_other_units(likeliest[:MOST_TRIALS], odds), continued, refit)
        gains = {fault: gain for fault, (gain, _) in trials.items()}
        if not gains or max(gains.values()) <= SUSPICIOUS:
            break
        best = max(gains.values())
        alike = [key for key in gains if gains[key] > max(best - SURE, SUSPICIOUS)]
        for fault in sorted(alike, key=lambda key: -gains[key]):
            indices = tuple(state.runs[place].rows.index for place in fault.places)
            for index, partner in zip(indices, reversed(indices), strict=True):
                wrong = Misread(how=fault.how, log_odds=gains[fault])
                if fault.how == "swapped":
                    wrong = replace(wrong, partner=partner)
                elif fault.of_instrument:
                    wrong = replace(wrong, together=indices)
                found.setdefault(index, wrong)
        if best <= SURE:
            break
        undone |= set(alike)
        mistakes.append(frozenset(state.runs[place].rows.index for fault in alike for place in fault.places))
        _, fitted = max(trials.values(), key=lambda trial: trial[0])
        posterior = fitted.posterior()
    return MisreadRuns(found, tuple(mistakes), fitted)


def _undone_on_trial(
    fitted: Fitted, faults: Sequence[Fault], continued: Continued, refit: Refit
) -> dict[Fault, tuple[float, Fitted]]:
    """How much likelier readings are with each undone, as a logarithm, and the estimate with it undone: from the
    beginning where it may be as likely as the likeliest.
    """
    runs_of = {fault: runs for fault in faults if (runs := _with_undone(fitted.state.runs, fault)) is not None}

    def trial(fault: Fault, undone: Fitted) -> tuple[float, Fitted]:
        return _gain(fitted, undone, fault), undone

    found = {fault: trial(fault, continued(fitted, runs)) for fault, runs in runs_of.items()}
    most = max((gain for gain, _ in found.values()), default=0.0)
    near = [fault for fault, (gain, _) in found.items() if gain > max(TRIED, most - NEAR)]
    return found | {fault: trial(fault, refit(runs_of[fault])) for fault in near}


def _with_other_units(faults: Sequence[Fault], among: Collection[Fault]) -> list[Fault]:
    """Those, and of an instrument whose unit may be wrong all others that it may be: noise is no measure of them, which
    is estimated anew with each.
    """
    units = {one.places for one in faults if one.of_instrument and one.how in UNITS}
    return [*faults, *(one for one in among if one.places in units and one.how in UNITS and one not in faults)]


def _ratios(fitted: Fitted, posterior: Posterior) -> dict[Fault, float]:
    """Of every fault, by the noise and sizes of the state.

    Infinite where all runs of an instrument may be too small and have less noise than any: an estimate with such noise
    follows them, whatever the others say.
    """
    noise = fitted.state.noise
    quiet = {group for group in noise if noise[group].sigma < LEAST_NOISE}
    swaps = swap_ratios(fitted, posterior).items()
    double = {Fault(swap.places, "swapped", swap.among): odds for swap, odds in swaps}
    found = {fault: odds - fault.price for fault, odds in (fault_ratios(fitted, posterior) | double).items()}
    small = (fault for fault in found if fault.of_instrument and fault.how == "small")
    return found | {one: np.inf for one in small if fitted.state.runs[one.places[0]].noise_group in quiet}


def fault_ratios(fitted: Fitted, posterior: Posterior) -> dict[Fault, float]:
    """Logarithm of how much likelier readings are with a fault of a run undone, or one of all runs of an instrument
    beside others: by the noise and sizes of the state.
    """
    state = fitted.state
    changed: dict[int, ChangesOfRun] = {}
    columns: dict[int, list[How]] = {}
    for place, one in enumerate(state.runs):
        # without a prior readings of any unit are as likely: more of one unit than of another tells nothing
        hows = [how for how, factor in UNDONE.items() if not (fitted.sizes.flat and abs(factor) != 1.0)]
        each = {how: reading - one.reading for how in hows if (reading := undone_reading(one, how)) is not None}
        columns[place] = list(each)
        changed[place] = changes_of_run(fitted, posterior, place, list(each.values()))
    faults = [Fault((place,), how) for place, hows in columns.items() for how in hows if how not in ONLY_TOGETHER]
    found = {}
    for fault in [*faults, *_of_instruments(state, columns)]:
        parts = [(changed[place], columns[place].index(fault.how)) for place in fault.places]
        found[fault] = log_ratio(parts) + _of_factor(state, fault)
    return found


def _of_instruments(state: State, columns: Mapping[int, Sequence[How]]) -> Iterator[Fault]:
    """Those that all runs of an instrument may have, beside another; and the wrong sign of all of it that sense along
    one line, as one column of a file has, or while the same axes move, as one set-up has. columns: what each run may
    have, by its place.
    """
    of_instrument: dict[str, list[int]] = {}
    parts: dict[Hashable, list[int]] = {}
    for place, one in enumerate(state.runs):
        of_instrument.setdefault(one.noise_group, []).append(place)
        parts.setdefault((one.noise_group, "line", one.rows.run.line), []).append(place)
        parts.setdefault((one.noise_group, "moving", _moving(one)), []).append(place)
    groups = [(how, tuple(members)) for how, members in product(OF_INSTRUMENTS, of_instrument.values())]
    groups = list(dict.fromkeys([*groups, *(("reversed", tuple(members)) for members in parts.values())]))
    for how, members in groups:
        places = tuple(place for place in members if how in columns[place])
        if 1 < len(places) < len(state.runs):
            yield Fault(places, how)


def _moving(one: MeasuredRun) -> tuple[bool, ...]:
    """Of each axis whether it moves in the run."""
    return tuple(bool(span > 0.0) for span in np.ptp(one.rows.positions, axis=1))


def _of_factor(state: State, fault: Fault) -> float:
    """Logarithm of the density of readings that are multiplied: finer ones are denser, but not what is coarser than the
    noise since the display shows no more. state: with the readings as they are.
    """
    factor, value = abs(UNDONE[fault.how]), 0.0
    if factor == 1.0:
        return value
    for place in fault.places:
        one = state.runs[place]
        steps = np.diff(np.unique(np.round(one.reading[one.good], DECIMALS)))
        white = max(float(state.scales[place]) * state.noise[one.noise_group].white, SMALLEST)
        shown = ROUNDING * float(steps.min(initial=np.inf)) / white
        coarse = float(np.log(np.hypot(1.0, factor * shown) / np.hypot(1.0, shown))) if np.isfinite(shown) else np.inf
        value += int(one.good.sum()) * (float(np.log(factor)) - coarse)
    return value


def _with_undone(runs: Sequence[MeasuredRun], fault: Fault) -> list[MeasuredRun] | None:
    """All readings count again."""
    whole = [replace(one, good=np.ones(one.reading.size, dtype=bool)) for one in runs]
    for place, partner in zip(fault.places, reversed(fault.places), strict=True):
        undone = runs[partner].reading if fault.how == "swapped" else undone_reading(runs[place], fault.how)
        if undone is None:
            return None
        whole[place] = replace(whole[place], reading=undone)
    return whole


def _gain(one: Fitted, other: Fitted, fault: Fault) -> float:
    """Logarithm of how much likelier readings are by the other estimate."""
    value = evidence_ratio(one, other)
    if fault.how != "swapped":
        before, after = counting_in_both(one.state, other.state)
        value += _of_factor(replace(before, noise=after.noise, scales=after.scales), fault)
    return value - fault.price - (BY_SIZE if fault.how in ONLY_TOGETHER else 0.0)
