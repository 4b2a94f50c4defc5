"""Is there one period in a run? Is all together more than repeats differ by?"""

import numpy as np
from scipy.linalg import block_diag

from trueaxis.diagnosis.judging.structure import Check, StructureClass
from trueaxis.diagnosis.null_model.freedom import Freedom
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.null_model.whiten import Whitening
from trueaxis.diagnosis.result import FloatArray
from trueaxis.estimation.tails import log_f_tail

FALSE_ALARMS = 1e-3  # share of clean data sets in which one check or other may fire
TELLING = 0.2  # share of a reading's variance that the model leaves, below which its residual is no measure of noise
FEWEST = 12  # such readings of a run, for its noise to be compared
SLOWEST = 3  # periods in a run: slower ones are its drift
SURER = 0.1  # share of the false alarms that a period may give: noise is not quite of the form that it is taken for
MORE = 1.15  # times the variance of repeats


def humming_run(rows: Rows, whitening: Whitening, projection: Projection, residual: FloatArray) -> Check:
    """A run with one period in it: something shook, or a neighbour ran.

    The line of each run's periodogram by the order of its readings that explains most of what the model leaves of it,
    as a share of all that: the run's own scatter is the measure, as in the test of R. A. Fisher (Proc. R. Soc. A 125,
    1929). What the model leaves of a short run is no white noise: it is made white first, where enough is left.
    """
    least, loudest, rms = 1.0, rows.present[0], 0.0
    for place, index in enumerate(rows.present):
        mine = rows.of_run(index)
        shares, freedom, total = _lines(whitening, projection, place, residual[mine])
        if shares.size == 0:
            continue
        share = min(1.0, float(shares.max()))
        p_value = min(1.0, shares.size * (1.0 - share) ** (0.5 * freedom - 1.0))
        if p_value < least:
            least, loudest = p_value, index
            rms = float(np.sqrt(share * total / rows.size)) * whitening.runs[place].sigma
    p_value = min(1.0, least * len(rows.present))
    where = rows.runs[loudest].id
    return Check(
        structure=StructureClass.ONE_PERIOD, place=where, p_value=p_value, fired=p_value < SURER * FALSE_ALARMS, rms=rms
    )


def _lines(whitening: Whitening, projection: Projection, place: int, left: FloatArray) -> tuple[FloatArray, int, float]:
    """Of a run: share of its squares that each line explains, degrees of freedom, and these squares. left: (m,).

    Outside the columns that are free in the run, few of them, what is left is white; within, it has the variance 1 - g
    along the directions v. Those of which too little is left do not count, nor what its instrument may do of its own.
    """
    mine = slice(*whitening.starts[place : place + 2].tolist())
    weights, aside = projection.basis.of_run(place), whitening.aside(place)[0]
    causes = projection.causes[mine] if projection.causes.size else np.zeros((left.size, 0))
    few, turned = np.linalg.qr(np.hstack([projection.basis.few[place], causes, aside]))
    taken = turned[:, : -aside.shape[1] or None] @ block_diag(weights, np.eye(causes.shape[1]))
    own = few.T @ aside
    others = np.eye(few.shape[1]) - own @ own.T
    g, v = np.linalg.eigh(np.eye(few.shape[1]) - others @ (others - taken @ taken.T) @ others)
    kept = g < 1.0 - TELLING
    freedom = left.size - int(np.count_nonzero(~kept))
    count = (left.size + 1) // 2 - SLOWEST
    if freedom < FEWEST or count < 1:
        return np.zeros(0), freedom, 0.0
    of_few = np.fft.rfft(few @ v, axis=0)[SLOWEST : SLOWEST + count]
    within = (few @ v).T @ left
    total = float(left @ left - within @ within + np.sum(within[kept] ** 2 / (1.0 - g[kept])))
    waves = np.stack([of_few.real, of_few.imag], axis=1)  # (lines, cosine and sine, directions)
    lost = waves * np.where(kept, g, 1.0)
    gram = 0.5 * left.size * np.eye(2) - lost @ waves.transpose(0, 2, 1)
    whole = np.fft.rfft(left)[SLOWEST : SLOWEST + count]
    inside = np.stack([whole.real, whole.imag], axis=1) - waves[:, :, ~kept] @ within[~kept]
    told = np.linalg.eigvalsh(gram)[:, 0] > TELLING * 0.5 * left.size
    if total <= 0.0 or not told.any():
        return np.zeros(0), freedom, 0.0
    squares = np.einsum("ki,ki->k", inside[told], np.linalg.solve(gram[told], inside[told][:, :, np.newaxis])[:, :, 0])
    return np.asarray(squares / total), freedom, total


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
