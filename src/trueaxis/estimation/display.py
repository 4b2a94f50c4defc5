"""The steps in which instruments display readings: no noise is smaller than their rounding."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from trueaxis.estimation.noise import Noise
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.measurement.machine import FloatArray

STEPS = tuple(digit * 10.0**power for power in range(-2, -7, -1) for digit in (5.0, 2.0, 1.0))  # of displays, mm
DECIMALS = 9  # of mm: readings that differ by less are the same
ROUNDING = 12.0**-0.5  # of a step: the standard deviation of rounding to it


def display_step(readings: FloatArray) -> float:
    """mm: the step of which all readings are multiples, 0 if they have none of those that displays have."""
    for step in STEPS:
        share = readings / step
        if np.abs(share - np.round(share)).max(initial=0.0) < 1e-6 and np.unique(readings).size > 1:
            return step
    return 0.0


def display_steps(runs: Sequence[MeasuredRun]) -> dict[str, float]:
    """Noise group -> mm, as its devices state it or its readings show it."""
    found: dict[str, float] = {}
    for name in sorted({one.noise_group for one in runs}):
        mine = [one for one in runs if one.noise_group == name]
        devices = [one.rows.run.device for one in mine]
        stated = [one.resolution or 0.0 for one in devices if one is not None]
        found[name] = max([display_step(np.concatenate([one.reading for one in mine])), *stated])
    return found


def rounded(noise: Noise, step: float) -> Noise:
    """No less than the rounding to a step, mm: where that is coarse, most readings are as their neighbours."""
    return replace(noise, white=max(noise.white, step * ROUNDING))
