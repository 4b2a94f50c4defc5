"""The noise of the readings: of every run, and what is told of every instrument, or of its devices (`noise_groups`).

By restricted maximum likelihood (REML; Patterson and Thompson, Biometrika 58, 1971) of what the saturated base leaves
of all runs together: runs of one axis share its curves, which leaves far more room to tell slow noise from the machine
than the course of a run by itself. What the base gets wrong repeats share: it is told from noise where there are any.
Noise of an instrument is white (more in some runs than in others) and slow; its runs wander and settle, and the ball of
each run of a ball bar stands a little elsewhere.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from trueaxis.diagnosis.null_model.base import SIZES, Base
from trueaxis.diagnosis.null_model.freedom import freedom_of_runs
from trueaxis.diagnosis.null_model.noise_blocks import HELD, NORMAL_MEDIAN, Block, Blocks, left_of, of_repeats
from trueaxis.diagnosis.null_model.noise_fit import restricted
from trueaxis.diagnosis.null_model.noise_law import Found, Guess, Law
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.null_model.whiten import RunNoise
from trueaxis.diagnosis.result import FloatArray, NoiseOf
from trueaxis.estimation.display import ROUNDING, display_step
from trueaxis.estimation.noise import Noise
from trueaxis.estimation.noise_of_residuals import SMALLEST, first_noise

LEAST = 1.0  # degrees of freedom: fewer tell no noise
FEWEST = 4  # readings of targets that were read before, for a noise to be from repeats
GIVEN = 1e6  # degrees of freedom of a noise that is given
# where a noise comes from
REPEATS, COURSES, EXPECTED, STATED, UNKNOWN = "repeats", "courses", "expected", "given", "unknown"


def noise_of_runs(
    rows: Rows, base: Base, values: FloatArray, noise_um: float | None, before: Found | None = None
) -> tuple[tuple[RunNoise, ...], tuple[NoiseOf, ...], Found | None]:
    """Of every run of the base, in its order, and of every group of runs. values: (n,) mm, readings less what is
    expected.

    noise_um: of every reading, where it is known: white noise, and nothing is estimated; before: what was found of
    nearly the same readings, from where a further estimate is near.
    """
    groups = [one.noise_group for one in base.runs]
    names = list(dict.fromkeys(groups))
    silent: Sequence[str] = ()
    if noise_um is not None:
        laws, fit = {name: Law(white=1e-3 * noise_um, freedom=GIVEN) for name in names}, None
    else:
        laws, fit, silent = _estimated(rows, base, values, before)
    scales = np.ones(len(groups)) if fit is None else fit.scales
    certain = np.full(len(groups), GIVEN) if fit is None else freedom_of_runs(np.log(fit.scales), fit.told)
    found, told = dict[int, RunNoise](), list[NoiseOf]()
    drifts, balls = base.drifts, base.balls
    for name in names:
        members = [place for place, one in enumerate(groups) if one == name]
        at = np.concatenate([base.runs[place].rows.at for place in members])
        origin = STATED if fit is None else REPEATS if at.size - np.unique(rows.target[at]).size >= FEWEST else COURSES
        law = laws[name]
        origin = EXPECTED if name in silent else origin
        if law.freedom < LEAST:
            law, origin = Law(white=max(float(np.sqrt(np.mean(values[at] ** 2))), SMALLEST)), UNKNOWN
        step = 0.0 if fit is None else _step(rows, base, members)
        times = _readings_of_a_target(rows, base, members)
        typical = _shown(Noise(law.white, law.slow, law.lasts), step, times)
        lasting = float(np.exp(-1.0 / law.lasts)) if law.slow else 0.0
        told.append(
            NoiseOf(
                instrument=base.runs[members[0]].instrument,
                group=name,
                white=typical.white,
                correlated=typical.slow,
                correlation=lasting,
                settles=law.settles,
                freedom=law.freedom,
                origin=origin,
                wanders=law.wanders,
                places=law.places if any(balls[place].size for place in members) else 0.0,
            )
        )
        for place in members:
            run, white = base.runs[place].rows, float(scales[place]) * law.white
            found[place] = RunNoise(
                noise=_shown(Noise(white, law.slow, law.lasts), step, times),
                steps=run.steps,
                passed=run.passed,
                wanders=law.wanders,
                settles=law.settles,
                drifts=drifts[place],
                ball=balls[place],
                places=law.places,
                freedom=float(certain[place]),
            )
    return tuple(found[place] for place in range(len(groups))), tuple(told), fit


def _estimated(
    rows: Rows, base: Base, values: FloatArray, before: Found | None
) -> tuple[dict[str, Law], Found, list[str]]:
    """Of every group of runs, and the names of those whose readings the base takes up whole where it is free.

    Their noise is what is left beside errors of the machine as large as expected, times that of SIZES which the
    readings make likeliest. values, before: see `noise_of_runs`.
    """
    groups = [one.noise_group for one in base.runs]
    memory = None if before is None else before.blocks
    if memory is None or memory.base is not base:
        memory = Blocks(rows, base)
    blocks = list(memory.of(values))
    guesses = {name: _guess(blocks, groups, name) for name in dict.fromkeys(groups)}
    laws, fit = restricted(blocks, groups, guesses, before)
    fit = replace(fit, blocks=memory)
    silent = [name for name in guesses if laws[name].freedom < LEAST]
    if not silent:
        return laws, fit, silent
    guesses |= {name: _guess_of_neighbours(base, values, name) for name in silent}
    tried: list[tuple[dict[str, Law], Found]] = []
    earlier = None if before is None else before.beside  # of nearly the same readings
    for times in SIZES if earlier is None else (earlier.times,):
        beside = [one.expecting(base, times) for one in blocks]
        told, found = restricted(beside, groups, guesses, tried[-1][1] if tried else earlier)
        tried.append((told, replace(found, times=times)))
        if len(tried) > 1 and tried[-1][1].unlikely > tried[-2][1].unlikely:
            break
    told, found = min(tried, key=lambda one: one[1].unlikely)
    mine = np.isin(groups, silent)
    scales, information = (np.where(mine, *both) for both in ((found.scales, fit.scales), (found.told, fit.told)))
    fit = replace(fit, scales=scales, told=information, beside=found)
    return laws | {name: told[name] for name in silent}, fit, silent


def _guess_of_neighbours(base: Base, values: FloatArray, name: str) -> Guess:
    """Of the noise of a group of runs, by how readings differ from their neighbours."""
    of_runs = [values[one.rows.at] for one in base.runs if one.noise_group == name]
    return Guess(first_noise(of_runs).white, 0.0)


def _guess(blocks: Sequence[Block], groups: Sequence[str], name: str) -> Guess:
    """Of the noise of a group of runs, by its repeats, and of the misfit of the base; else by what the base leaves."""
    of_base, of_target = [np.zeros(0)], [np.zeros(0)]
    for block in blocks:
        left, share = left_of(block)
        for one in block.parts:
            if groups[one.place[0]] == name:
                of_base.append(np.abs(left[one.rows][share[one.rows] > HELD]))
                of_target.append(np.abs(of_repeats(one, block.values[one.rows])))
    typical = [
        max(float(np.median(one)) / NORMAL_MEDIAN, SMALLEST) if one.size else SMALLEST
        for one in (np.concatenate(of_target), np.concatenate(of_base))
    ]
    repeated = sum(map(len, of_target)) > 0
    return Guess(typical[0], typical[1] / typical[0]) if repeated else Guess(typical[1], 0.0)


def _step(rows: Rows, base: Base, members: Sequence[int]) -> float:
    """mm, of the display."""
    step = display_step(rows.reading[np.concatenate([base.runs[place].rows.at for place in members])])
    resolved = [base.runs[place].rows.run.device for place in members]
    return max([step, *(one.resolution or 0.0 for one in resolved if one is not None)])


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
    least = step * ROUNDING * float(np.sqrt(1.0 + (times - 1.0) * alike))
    return Noise(max(noise.white, least), noise.slow, noise.lasts)
