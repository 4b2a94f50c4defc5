"""The noise of the readings, from repeats: what differs between readings of the same target.

Readings of one target, from one side, with one set-up have one mean, whatever the model: this and the unknowns of each
run's instrument are taken as free, and what is left is fitted as white and slow noise by restricted maximum likelihood
(REML; Patterson and Thompson, Biometrika 58, 1971). Repeats may come in any order: passes, cycles, poses, further runs.
Without repeats the course of each run, smooth by direction, takes the place of the means.

Of all noise that the readings allow the slowest is taken: a cause that is none costs more than one not found.
"""

from collections.abc import Sequence

import numpy as np

from trueaxis.diagnose.base import Base
from trueaxis.diagnose.noise_blocks import Block, courses, repeated
from trueaxis.diagnose.noise_fit import restricted
from trueaxis.diagnose.result import FloatArray, NoiseOf
from trueaxis.diagnose.rows import Rows
from trueaxis.diagnose.whiten import RunNoise, settling
from trueaxis.estimation.noise import Noise
from trueaxis.estimation.noise_of_residuals import AS_MANY, SMALLEST
from trueaxis.estimation.state import DISPLAY

FEWEST = 4  # degrees of freedom, for a noise to be told
GIVEN = 1e6  # degrees of freedom of a noise that is given
REPEATS, COURSES, STATED, UNKNOWN = "repeats", "courses", "given", "unknown"  # where a noise comes from
STEPS = tuple(digit * 10.0**power for power in range(-2, -7, -1) for digit in (5.0, 2.0, 1.0))  # of displays, mm


def noise_of_runs(
    rows: Rows, base: Base, values: FloatArray, noise_um: float | None
) -> tuple[tuple[RunNoise, ...], tuple[NoiseOf, ...]]:
    """Of every run of the base, in its order, and of every instrument. values: (n,) mm, readings less what is expected.

    noise_um: of every reading, where it is known: white noise, and nothing is estimated.
    """
    noises: dict[str, Noise] = {}
    told: list[NoiseOf] = []
    scales = np.ones(len(base.runs))
    for name in dict.fromkeys(one.instrument for one in base.runs):
        members = [place for place, one in enumerate(base.runs) if one.instrument == name]
        origin, freedom = STATED, GIVEN
        if noise_um is not None:
            noises[name] = Noise(1e-3 * noise_um)
        else:
            noises[name], of_runs, origin, freedom = _of_instrument(rows, base, values, members)
            scales[members] = of_runs
        typical = noises[name]
        lasting = float(np.exp(-1.0 / typical.lasts)) if typical.slow else 0.0
        told.append(NoiseOf(name, typical.white, typical.slow, lasting, 0.0, freedom, origin))
    found = tuple(
        RunNoise(
            noise=noises[one.instrument],
            scale=float(scale),
            steps=one.rows.steps,
            settles=0.0,
            settling=settling(one.rows.passed),
        )
        for one, scale in zip(base.runs, scales, strict=True)
    )
    return found, tuple(told)


def _of_instrument(
    rows: Rows, base: Base, values: FloatArray, members: Sequence[int]
) -> tuple[Noise, FloatArray, str, float]:
    """Noise, scale of every member, origin and degrees of freedom."""
    step = display_step(rows.reading[np.concatenate([base.runs[place].rows.at for place in members])])
    resolved = [base.runs[place].rows.run.device for place in members]
    step = max([step, *(one.resolution or 0.0 for one in resolved if one is not None)])
    # few repeats still are a better measure than none: the tests know how few they are
    for origin, blocks, fewest in ((REPEATS, repeated, FEWEST), (COURSES, courses, FEWEST), (REPEATS, repeated, 1)):
        every = [one for one in blocks(rows, base, values, members) if one.freedom > 0]
        freedom = float(sum(one.freedom for one in every))
        if freedom >= fewest:
            hardly = _hardly_repeated(every, members) if origin == REPEATS else set()
            alone = [one for one in courses(rows, base, values, sorted(hardly)) if one.freedom > 0]
            noise, scales = restricted(every, alone, members)
            return _shown(noise, step, _readings_of_a_target(rows, base, members)), scales, origin, freedom
    mine = np.concatenate([base.runs[place].rows.at for place in members])
    size = max(float(np.sqrt(np.mean(values[mine] ** 2))), SMALLEST)
    return Noise(size), np.ones(len(members)), UNKNOWN, 1.0


def _readings_of_a_target(rows: Rows, base: Base, members: Sequence[int]) -> float:
    """How often a run reads the same target, on average."""
    readings = sum(base.runs[place].rows.at.size for place in members)
    targets = sum(np.unique(rows.target[base.runs[place].rows.at]).size for place in members)
    return readings / max(targets, 1)


def _shown(noise: Noise, step: float, times: float) -> Noise:
    """With the rounding of the display. times: readings of a target in a run.

    Where the noise is finer than the step, repeats are rounded alike, and no number of them tells more than one: each
    then has the rounding of all in its variance. Of two readings of normal noise the correlation of the rounding
    is exp(-(2 pi noise/step)^2) (first term of the series of Widrow and Kollar, Quantization Noise, 2008).
    """
    if step == 0.0:
        return noise
    alike = float(np.exp(-((2.0 * np.pi * noise.sigma / step) ** 2)))
    least = step * DISPLAY * float(np.sqrt(1.0 + (times - 1.0) * alike))
    return Noise(max(noise.white, least), noise.slow, noise.lasts)


def display_step(readings: FloatArray) -> float:
    """mm: the step of which all readings are multiples, 0 if they have none of those that displays have."""
    for step in STEPS:
        share = readings / step
        if np.abs(share - np.round(share)).max(initial=0.0) < 1e-6 and np.unique(readings).size > 1:
            return step
    return 0.0


def _hardly_repeated(blocks: Sequence[Block], members: Sequence[int]) -> set[int]:
    """Runs of which too few readings are repeated to tell that they have another noise than their instrument."""
    repeated = dict.fromkeys(members, 0)
    for one in blocks:
        for place, part, _ in one.parts:
            repeated[place] += part.stop - part.start
    return {place for place, count in repeated.items() if count < 2.0 * AS_MANY}
