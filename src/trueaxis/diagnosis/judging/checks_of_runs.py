"""Is there one period in a run? Is all together more than repeats differ by?"""

import numpy as np

from trueaxis.diagnosis.judging.structure import Check, StructureClass
from trueaxis.diagnosis.null_model.freedom import Freedom
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.result import FloatArray
from trueaxis.estimation.tails import log_f_tail

FALSE_ALARMS = 1e-3  # share of clean data sets in which one check or other may fire
TELLING = 0.2  # share of a reading's variance that the model leaves, below which its residual is no measure of noise
FEWEST = 12  # such readings of a run, for its noise to be compared
SLOWEST = 3  # periods in a run: slower ones are its drift
SURER = 0.1  # share of the false alarms that a period may give: noise is not quite of the form that it is taken for
MORE = 1.15  # times the variance of repeats


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
    where = rows.runs[loudest].id
    return Check(
        structure=StructureClass.ONE_PERIOD, place=where, p_value=p_value, fired=p_value < SURER * FALSE_ALARMS, rms=rms
    )


def lack_of_fit(rows: Rows, projection: Projection, residual: FloatArray, sigma: FloatArray, freedom: Freedom) -> Check:
    """All that the model leaves, against the noise by repeats, of the instrument where it is most: by the F test.

    Tails heavier than normal make the estimates vary more than the test believes: a little more is no finding.
    """
    left = projection.left
    instrument = np.array([run.instrument for run in rows.runs])[rows.run]
    names = np.unique(instrument)
    worst, p_value, rms, excess = str(names[0]), 1.0, 0.0, 0.0
    for name in names:
        mine = instrument == name
        k, total = float(left[mine].sum()), float(residual[mine] @ residual[mine])
        if k < FEWEST:
            continue
        p = min(1.0, float(np.exp(log_f_tail(total / k, k, float(freedom.of_rows[mine][0])))) * names.size)
        if p <= p_value and total > MORE * k:
            worst, p_value, excess = str(name), p, total - k
            rms = float(np.sqrt(excess / k)) * float(np.mean(sigma[mine]))
    return Check(
        structure=StructureClass.LACK_OF_FIT,
        place=worst,
        p_value=p_value,
        fired=p_value < FALSE_ALARMS,
        rms=rms,
        excess=excess,
    )
