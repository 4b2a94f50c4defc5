"""Is a run unlike the others, in its noise or by one period in it? Is all together more than repeats differ by?"""

import numpy as np
from scipy.special import ndtr

from trueaxis.diagnose.freedom import Freedom
from trueaxis.diagnose.projection import Projection
from trueaxis.diagnose.result import LACK_OF_FIT, Check, FloatArray
from trueaxis.diagnose.rows import Rows
from trueaxis.diagnose.tails import log_f_tail

FALSE_ALARMS = 1e-3  # share of clean data sets in which one check or other may fire
TELLING = 0.2  # share of a reading's variance that the model leaves, below which its residual is no measure of noise
FEWEST = 12  # such readings of a run, for its noise to be compared
NOISY = 4.0  # times the variance of the other runs, from which a run stands out
MEDIAN_SQUARE = 0.454936  # of a standard normal variable
SLOWEST = 3  # periods in a run: slower ones are its drift
SURER = 0.1  # share of the false alarms that a period may give: noise is not quite of the form that it is taken for
MORE = 1.15  # times the variance of repeats
LESS_EFFICIENT = 2.72  # variance of an estimate by the median of squares, over that by their mean


def noisy_run(rows: Rows, projection: Projection, residual: FloatArray, sigma: FloatArray) -> Check:
    """A run with far more noise than the others of its instrument: something was going on meanwhile.

    By medians, which neither outliers nor heavy tails move; that of squares varies more than their mean. Readings that
    the model has nearly used up say nothing of their noise, nor do runs with few others.
    """
    left = projection.left
    telling = left > TELLING
    power, count = np.full(len(rows.runs), np.nan), np.zeros(len(rows.runs))
    for index in rows.present:
        mine = rows.of_run(index)
        there = telling[mine]
        if np.count_nonzero(there) >= FEWEST:
            squares = residual[mine][there] ** 2 / left[mine][there]
            power[index], count[index] = float(np.median(squares)) / MEDIAN_SQUARE, squares.size
    ratio, usual = np.ones(len(rows.runs)), np.ones(len(rows.runs))
    for name in dict.fromkeys(run.instrument for run in rows.runs):
        same = np.array([run.instrument == name for run in rows.runs]) & np.isfinite(power)
        if same.any():
            usual[same] = max(float(np.median(power[same])), 1e-300)
            ratio[same] = power[same] / usual[same]
    z = (ratio - 1.0) / np.sqrt(2.0 * LESS_EFFICIENT / np.maximum(count, 1.0))
    worst = int(np.argmax(z))
    p_value = min(1.0, float(ndtr(-z[worst])) * len(rows.runs))
    excess = max(ratio[worst] - 1.0, 0.0) * usual[worst] * count[worst] / rows.size
    rms = float(np.sqrt(excess)) * float(np.mean(sigma[rows.of_run(worst)])) if excess > 0.0 else 0.0
    fired = p_value < FALSE_ALARMS and float(ratio[worst]) > NOISY
    return Check("runs, noise", "one run is much noisier than the others", p_value, fired, rms)


def humming_run(rows: Rows, projection: Projection, residual: FloatArray, sigma: FloatArray) -> Check:
    """A run with one period in it: something shook, or a neighbour ran.

    The largest line of each run's periodogram by its place in the run, as a share of all lines, tested as R. A. Fisher
    did (Proc. R. Soc. A 125, 1929): the run's own scatter is the measure.
    """
    left = projection.left
    least, loudest, rms = 1.0, rows.present[0], 0.0
    for index in rows.present:
        mine = rows.of_run(index)
        if np.mean(left[mine] > TELLING) < 0.5 or mine.stop - mine.start < FEWEST:
            continue
        power = np.abs(np.fft.rfft(residual[mine])[SLOWEST : (mine.stop - mine.start + 1) // 2]) ** 2
        share = float(power.max() / power.sum()) if power.sum() > 0.0 else 0.0
        p_value = min(1.0, power.size * (1.0 - share) ** (power.size - 1))
        if p_value < least:
            least, loudest = p_value, index
            variance = share * float(np.mean(residual[mine] ** 2)) * (mine.stop - mine.start) / rows.size
            rms = float(np.sqrt(variance)) * float(np.mean(sigma[mine]))
    p_value = min(1.0, least * len(rows.present))
    meaning = f"run {rows.runs[loudest].id} goes up and down with one period"
    return Check("runs, one period", meaning, p_value, p_value < SURER * FALSE_ALARMS, rms)


def lack_of_fit(rows: Rows, projection: Projection, residual: FloatArray, sigma: FloatArray, freedom: Freedom) -> Check:
    """All that the model leaves, against the noise by repeats, of the instrument where it is most: by the F test.

    Tails heavier than normal make the estimates vary more than the test believes: a little more is no finding.
    """
    left = projection.left
    instrument = np.array([run.instrument for run in rows.runs])[rows.run]
    names = np.unique(instrument)
    worst, p_value, rms, excess = "", 1.0, 0.0, 0.0
    for name in names:
        mine = instrument == name
        k, total = float(left[mine].sum()), float(residual[mine] @ residual[mine])
        if k < FEWEST:
            continue
        p = min(1.0, float(np.exp(log_f_tail(total / k, k, float(freedom.of_rows[mine][0])))) * names.size)
        if p <= p_value and total > MORE * k:
            worst, p_value, excess = str(name), p, total - k
            rms = float(np.sqrt(excess / k)) * float(np.mean(sigma[mine]))
    meaning = (
        f"readings of the {worst} are farther off than repeats differ" if worst else "no more than repeats differ by"
    )
    return Check(LACK_OF_FIT, meaning, p_value, p_value < FALSE_ALARMS, rms, excess)
