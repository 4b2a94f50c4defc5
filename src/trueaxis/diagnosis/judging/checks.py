"""Is there structure left? Classes of structure that need no cause, tested on what the final model leaves."""

from collections.abc import Iterator, Sequence

import numpy as np

from trueaxis.diagnosis.causes.signature import Readings
from trueaxis.diagnosis.judging.checks_of_runs import FALSE_ALARMS, FEWEST, humming_run, lack_of_fit
from trueaxis.diagnosis.judging.structure import Check
from trueaxis.diagnosis.judging.structure_columns import Structure, structures
from trueaxis.diagnosis.null_model.freedom import Freedom
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.null_model.whiten import Whitening
from trueaxis.diagnosis.result import FloatArray, IntArray
from trueaxis.estimation.tails import log_f_tail

LOOKS = 2  # at each structure: by the noise that was estimated, and by what it leaves itself


def run_checks(
    readings: Readings, whitening: Whitening, projection: Projection, residual: FloatArray, freedom: Freedom
) -> tuple[Check, ...]:
    """All checks. residual: (n,), whitened, model projected out; p values multiplied by the number of checks.

    rms of a check: about what the structure comes to, mm, its share of the noise taken away.
    """
    rows, sigma, left = readings.rows, whitening.sigma, projection.left - _by_chance(whitening)
    classes, explaining, counts = [], [], []
    for one in structures(readings):
        there = _runs_of(one, rows)
        white = whitening.part(there, one.columns[there])
        weights, k = projection.explaining(there, white, residual)
        classes.append((one.kind, one.place))
        explaining.append(np.zeros(rows.size))
        explaining[-1][there] = white @ weights
        counts.append((k, freedom.of(there, one.columns[there]), there))
    found = []
    every = projection.rest(np.stack(explaining, axis=1)).T if classes else ()
    for (kind, place), fitted, (k, of_noise, there) in zip(classes, every, counts, strict=True):
        if k == 0:
            continue
        statistic = float(fitted @ fitted)
        log_p, variance = log_f_tail(statistic / k, k, of_noise), 1.0
        if (beside := _beside(fitted[there], residual[there], float(left[there].sum()), k))[0] < log_p:
            log_p, variance = beside
        log_p += np.log(len(classes) * LOOKS)
        excess = statistic - variance * k
        beyond = max(excess, 0.0) / statistic if statistic > 0.0 else 0.0
        rms = float(np.sqrt(beyond * np.mean((sigma * fitted) ** 2)))
        p_value = float(np.exp(min(log_p, 0.0)))
        found.append(
            Check(
                structure=kind,
                place=place,
                p_value=p_value,
                fired=p_value < FALSE_ALARMS,
                rms=rms,
                excess=excess,
            )
        )
    found.append(humming_run(rows, whitening, projection, residual))
    found.append(lack_of_fit(rows, projection, residual, sigma, freedom))
    return tuple(found)


def fired_structure(
    readings: Readings, whitening: Whitening, projection: Projection, residual: FloatArray, checks: Sequence[Check]
) -> Iterator[FloatArray]:
    """(n,) each, mm: what the readings have of the structure of each check that fired, as these see it: see
    `run_checks`. Of all structure together, and of the waves in one run, nothing is known that other runs would show.
    """
    fired = {(one.structure, one.place) for one in checks if one.fired}
    for one in structures(readings) if fired else ():
        if (one.kind, one.place) in fired:
            there = _runs_of(one, readings.rows)
            weights, _ = projection.explaining(there, whitening.part(there, one.columns[there]), residual)
            yield one.columns @ weights


def _runs_of(one: Structure, rows: Rows) -> IntArray:
    """Rows, ascending, of all runs in which there may be such structure."""
    return np.flatnonzero(np.isin(rows.run, rows.run[one.columns.any(axis=1)]))


def _by_chance(whitening: Whitening) -> FloatArray:
    """(n,): share of each whitened reading's variance by which its run drifts, settles and wanders, if it does so as
    far as is usual: it may do less, and what is left is no measure of the noise there.
    """
    found = np.zeros(int(whitening.starts[-1]))
    for place in range(len(whitening.runs)):
        aside, share = whitening.aside(place)
        chance = np.where(share < 1.0, 1.0 - (1.0 - share) ** 2, 0.0)
        found[whitening.starts[place] : whitening.starts[place + 1]] = aside**2 @ chance
    return found


def _beside(fitted: FloatArray, residual: FloatArray, left: float, k: int) -> tuple[float, float]:
    """Logarithm of the probability, by the F test, that noise is explained as well by k columns, the noise of these
    runs being what they leave; and the variance of that noise.

    What several runs share and nothing repeats counts as noise of these runs in the estimate, and hides behind it. What
    is less than that noise itself is no finding: rounding by a display leaves less than it is expected to.
    fitted, residual: (n_rows,), of these runs; left: degrees of freedom of their residuals.
    """
    rest, statistic = residual - fitted, float(fitted @ fitted)
    variance = float(rest @ rest) / (left - k) if left - k >= FEWEST else 0.0
    if variance == 0.0 or statistic <= k:
        return 0.0, 1.0
    return log_f_tail(statistic / (k * variance), k, left - k), variance
