"""Runs in which an instrument showed the same again and again while the machine moved: it was read no more."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.display import DECIMALS, display_step
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.runs import noise_groups
from trueaxis.identification.words import in_small
from trueaxis.measurement.instrument_kinds import ANGLE, ARM
from trueaxis.measurement.machine import FloatArray

LEAST_P = 1e-6  # that a sound instrument shows so many equal readings in a row anywhere in the data


@dataclass(frozen=True, slots=True, kw_only=True)
class Stuck:
    """count: readings in a row that are the same, of so many of the run; value, mm or rad; seq: number of the first."""

    run: str
    count: int
    of_run: int
    value: float
    seq: int
    unit: str

    def __str__(self) -> str:
        factor, unit = in_small(self.unit)
        return (
            f"run {self.run}: {self.count} of its {self.of_run} readings, from seq {self.seq} on, are all "
            f"{self.value * factor:.6g} {unit}, while the machine moved: noise makes that next to impossible. Had the "
            "instrument lost its beam, was its display held, or was a column filled down?"
        )


def stuck_runs(observed: Observations, found: Estimate) -> Iterator[Stuck]:
    """One of each run at most: the longest row of equal readings, where display and noise do not explain it.

    Two readings of white noise s on a display of step d are the same with a probability of d / (2 s sqrt(pi)) at most,
    whatever is measured; and noise that other runs of the instrument show as equal neighbours is no fault of this one.
    """
    groups = noise_groups(observed.runs)
    rows_of = {index: _in_order(observed, index) for index in found.own}
    each = {index: observed.reading[rows] for index, rows in rows_of.items()}
    for index, rows in rows_of.items():
        first, count = _longest(each[index], observed.positions[:, rows])
        value = float(each[index][first]) if count else 0.0
        if count < 2 or (value == 0.0 and count == rows.size):
            continue  # a run of zeros: nothing was read, or nothing is wrong with the machine
        alike = [each[other] for other in each if groups[other] == groups[index]]
        noise = found.noise.of_group[groups[index]].white * found.noise.scale_of_run[index]
        chance = max(_by_display(alike, noise), _of_others(each, index, groups))
        if (count - 1) * np.log(chance) + np.log(observed.reading.size) < np.log(LEAST_P):
            angle = observed.runs[index].instrument == ANGLE
            yield Stuck(
                run=observed.runs[index].id,
                count=count,
                of_run=rows.size,
                value=value / (ARM if angle else 1.0),
                seq=first if observed.seq is None else int(observed.seq[rows[first]]),
                unit="rad" if angle else "mm",
            )


def _in_order(observed: Observations, index: int) -> np.ndarray:
    rows = np.flatnonzero(observed.run == index)
    return rows if observed.seq is None else rows[np.argsort(observed.seq[rows], kind="stable")]


def _longest(readings: FloatArray, positions: FloatArray) -> tuple[int, int]:
    """First and number of the longest row of equal readings in which the machine moves."""
    new = np.append(np.flatnonzero(np.diff(np.round(readings, DECIMALS), prepend=np.inf) != 0.0), readings.size)
    order = np.argsort(-np.diff(new), kind="stable")
    for place in order.tolist():
        here = slice(int(new[place]), int(new[place + 1]))
        if np.ptp(positions[:, here], axis=1).any():
            return here.start, here.stop - here.start
    return 0, 0


def _by_display(readings: list[FloatArray], noise: float) -> float:
    step = max(display_step(np.concatenate(readings)), 10.0**-DECIMALS)
    return min(1.0, step / (2.0 * np.sqrt(np.pi) * noise)) if noise > 0.0 else 1.0


def _of_others(each: dict[int, FloatArray], index: int, groups: tuple[str, ...]) -> float:
    """Share of equal neighbours in the other runs of the instrument; 0 where there is none."""
    others = [np.diff(one) == 0.0 for other, one in each.items() if other != index and groups[other] == groups[index]]
    pairs = sum(one.size for one in others)
    return (sum(int(one.sum()) for one in others) / pairs) if pairs else 0.0
