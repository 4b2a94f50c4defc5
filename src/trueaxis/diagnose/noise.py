"""The noise of the readings, from replicates: what differs between readings of the same target.

Differences of repeats hold no model misfit. What a cause could put into them (an offset, a drift of a run) is
projected out before; from circles at two feeds what servo lag makes of them, too. The rest is fitted by restricted
maximum likelihood as white plus first-order autocorrelated noise; of all that the repeats allow, the noise that is
strongest at low frequencies is taken, since a cause that is none costs more than one not found.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from scipy.special import betaln, chdtri

from trueaxis.diagnose.result import FloatArray, IntArray, NoiseOf
from trueaxis.diagnose.rows import Rows, place_of
from trueaxis.diagnose.whiten import differenced, ramp, solved, tridiagonal, whitened
from trueaxis.estimation.set_up import STRAIGHT
from trueaxis.spec.machine import LINEAR

LAG = 2  # harmonic of a circle by which servo lag makes two feeds differ
FEWEST = 12  # targets that two passes must share to be compared
ALLOWED = 1.35  # of log-likelihood: 90 % confidence; of all that repeats allow, the slowest noise is taken
_SHARES = (0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.98)
_CORRELATIONS = (0.3, 0.5, 0.65, 0.8, 0.9, 0.95, 0.98)
_SHAPES = ((0.0, 0.0), *((share, correlation) for correlation in _CORRELATIONS for share in _SHARES))
FEWEST_RUNS = 4  # for a slope's variance
KEPT = 2.0 / 3.0  # of the slopes, the smallest: what warms or creeps may tilt the runs of one axis, all the more
REPEATS = "repeats"  # where noise comes from
TOLD = 0.4  # of the degrees of freedom, that are left by it


@dataclass(frozen=True, slots=True, eq=False)
class Contrast:
    """A difference of passes over the same targets, of the variance of one reading.

    values: (n,) mm, in the order of reading; nuisance: (n, k), what is projected out, the slope in time second.
    across_runs: whether the passes are of different runs; place: where they were taken, see `place_of`. warming: (2,),
    the same difference of the slopes that the temperature and its square have in them, where it was read.
    """

    instrument: str
    values: FloatArray
    nuisance: FloatArray
    across_runs: bool
    place: str = ""
    warming: FloatArray | None = None

    def slope(self, noise: NoiseOf) -> tuple[float, float]:
        """Slope in time, mm over a run, and the variance that noise without slopes of runs makes of it."""
        white = whitened(replace(noise, slope=0.0), np.hstack([self.nuisance, self.values[:, np.newaxis]]))
        inverse = np.linalg.pinv(white[:, :-1].T @ white[:, :-1])
        coefficient = inverse @ (white[:, :-1].T @ white[:, -1])
        return float(coefficient[1]), float(inverse[1, 1])


def contrasts(rows: Rows, values: FloatArray, theta: FloatArray) -> tuple[Contrast, ...]:
    """All contrasts. values: (n,) mm, readings less what is expected; theta: (n,) rad, polar angles of circles.

    Circles without an exact repeat are compared with those at another feed.
    """
    found = []
    without_repeat = []
    for mine in _by(rows.setup):
        instrument = rows.runs[rows.run[mine[0]]].instrument
        blocks = list(_by(rows.run[mine] * 10**6 + rows.passing[mine]))
        members = [mine[block] for block in blocks]
        sets = _sets(members, rows.target)
        if instrument == "ballbar" and all(len(one) < 2 for one in sets):
            without_repeat.append(members)
            continue
        for one in sets:
            found += _of_set(rows, one, rows.target, values, theta)
    if without_repeat:
        place = _places(rows)
        for members in without_repeat:
            for one in _sets(members, place):
                found += _of_set(rows, one, place, values, theta)
    return tuple(found)


def estimate_noise(found: Sequence[Contrast], instrument: str) -> NoiseOf | None:
    """Noise of one instrument; None where nothing was repeated."""
    mine = [one for one in found if one.instrument == instrument]
    freedom = sum(one.values.size - one.nuisance.shape[1] for one in mine)
    if freedom < FEWEST:
        return None
    scale = float(np.sqrt(sum(_rss(one) for one in mine) / freedom))
    if scale == 0.0:
        return NoiseOf(instrument, 1e-9, 0.0, 0.0, 0.0, freedom, "repeats agree to the last digit")
    shapes: dict[tuple[int, bytes], list[Contrast]] = {}
    for one in mine:
        shapes.setdefault((one.values.size, one.nuisance.tobytes()), []).append(one)
    stacks = [(np.stack([one.values for one in each], axis=1), each[0].nuisance) for each in shapes.values()]

    tried = [_profiled(instrument, share, correlation, freedom, stacks) for share, correlation in _SHAPES]
    most = max(likelihood for _, likelihood in tried)
    allowed = [noise for noise, likelihood in tried if likelihood >= most - ALLOWED]
    best = max(allowed, key=_slow)
    slope, told_by = _slope(mine, best)
    return replace(best, slope=slope, slope_freedom=told_by)


def _rss(one: Contrast) -> float:
    fitted = np.linalg.lstsq(one.nuisance, one.values, rcond=None)[0]
    rest = one.values - one.nuisance @ fitted
    return float(rest @ rest)


def _profiled(
    instrument: str, share: float, correlation: float, freedom: float, stacks: list[tuple[FloatArray, FloatArray]]
) -> tuple[NoiseOf, float]:
    """The noise of this shape that the contrasts make likeliest, and its restricted log-likelihood."""
    unit = NoiseOf(instrument, float(np.sqrt(1.0 - share)), float(np.sqrt(share)), correlation, 0.0, freedom, REPEATS)
    squares = determinant = 0.0
    for values, nuisance in stacks:
        count = values.shape[1]
        factor = tridiagonal(unit, values.shape[0])
        white = solved(factor, differenced(unit, np.hstack([nuisance, values])))
        q, r = np.linalg.qr(white[:, : nuisance.shape[1]])
        rest = white[:, nuisance.shape[1] :]
        rest = rest - q @ (q.T @ rest)
        squares += float(np.sum(rest**2))
        determinant += count * float(np.sum(np.log(factor[0])) + np.sum(np.log(np.abs(np.diag(r)))))
    sigma = float(np.sqrt(squares / freedom))
    likelihood = -freedom * float(np.log(sigma)) - determinant
    return replace(unit, white=sigma * unit.white, correlated=sigma * unit.correlated), likelihood


def _slow(noise: NoiseOf) -> float:
    """Power of the noise at the lowest frequencies, where effects are."""
    f = noise.correlation
    return noise.white**2 + noise.correlated**2 * (1.0 + f) / (1.0 - f)


def _slope(mine: Sequence[Contrast], noise: NoiseOf) -> tuple[float, float]:
    """Standard deviation of the slopes of runs, mm over a run, beyond what the other noise makes of them; freedom."""
    of_runs = [one.slope(noise) for one in mine if one.across_runs]
    if len(of_runs) < FEWEST_RUNS:
        return 0.0, 0.0
    slopes, variances = np.array(of_runs).T
    kept = max(int(KEPT * slopes.size), 1)
    order = np.argsort(slopes**2 / variances)[:kept]
    excess = float(np.mean(slopes[order] ** 2)) / _smallest(kept, slopes.size) - float(np.mean(variances))
    return float(np.sqrt(max(excess, 0.0))), TOLD * slopes.size


@cache
def _smallest(kept: int, count: int) -> float:
    """Expected mean of the smallest `kept` of `count` squares of standard normal variables (order statistics)."""
    share = np.linspace(0.0, 1.0, 4001)[1:-1]
    order = np.arange(1, kept + 1)[:, np.newaxis]
    above = count + 1 - order
    density = np.exp((order - 1) * np.log(share) + (above - 1) * np.log1p(-share) - betaln(order, above))
    return float(np.mean(np.trapezoid(chdtri(1, 1.0 - share) * density, share)))


def _by(number: IntArray) -> Iterator[IntArray]:
    """Rows of each number, in order."""
    order = np.argsort(number, kind="stable")
    edges = np.flatnonzero(np.diff(number[order])) + 1
    yield from np.split(order, edges)


def _sets(members: list[IntArray], target: IntArray) -> list[list[IntArray]]:
    """Passes that share nearly all of their targets, together."""
    found: list[tuple[set[int], list[IntArray]]] = []
    for member in members:
        mine = set(target[member].tolist())
        for place, (theirs, passes) in enumerate(found):
            shared = theirs & mine
            if len(shared) >= max(FEWEST, 0.8 * max(len(mine), len(theirs))):
                found[place] = (shared, [*passes, member])
                break
        else:
            found.append((mine, [member]))
    return [passes for _, passes in found]


def _of_set(
    rows: Rows, passes: list[IntArray], target: IntArray, values: FloatArray, theta: FloatArray
) -> list[Contrast]:
    if len(passes) < 2:
        return []
    shared = set.intersection(*(set(target[one].tolist()) for one in passes))
    first = passes[0][np.isin(target[passes[0]], list(shared))]
    order = target[first]
    if np.unique(order).size != order.size or order.size < FEWEST:
        return []
    at = np.empty((len(passes), order.size), dtype=np.int64)
    for index, one in enumerate(passes):
        where = {int(number): int(row) for number, row in zip(target[one], one, strict=True)}
        at[index] = [where[int(number)] for number in order]
    instrument = rows.runs[rows.run[first[0]]].instrument
    nuisance = [np.ones(order.size), ramp(order.size)]
    if instrument == "ballbar" and np.unique(rows.target[np.concatenate(passes)]).size > order.size:
        angle = theta[first]
        if np.ptp(angle) == 0.0:  # the table turns, and the bar stands still on it
            angle = 2.0 * np.pi * (ramp(order.size) + 0.5)
        nuisance += [np.cos(LAG * angle), np.sin(LAG * angle)]
    if instrument != "ballbar" and _across(rows, first):
        nuisance.append(rows.positions[int(np.argmax(np.ptp(rows.positions[:, first], axis=1))), first])
    columns = _independent(np.stack(nuisance, axis=1))
    across = len({int(rows.run[one[0]]) for one in passes}) == len(passes)
    place = place_of(rows, np.concatenate(passes))
    difference = _helmert(len(passes))
    warming = _warming(rows, at)
    return [
        Contrast(instrument, row @ values[at], columns, across, place, None if warming is None else row @ warming)
        for row in difference
    ]


def _across(rows: Rows, mine: IntArray) -> bool:
    """Whether readings are of a straightness, whose reference line has a slope that nobody knows, in every run anew."""
    direction = rows.runs[rows.run[mine[0]]].direction
    moving = np.ptp(rows.positions[:, mine], axis=1) > 0.0
    along = [LINEAR.index(axis) for axis, moves in zip(rows.axes, moving, strict=True) if moves and axis in LINEAR]
    return direction is not None and bool(along) and not np.any(np.abs(np.array(direction)[along]) > STRAIGHT)


def _warming(rows: Rows, at: IntArray) -> FloatArray | None:
    """(n_passes, 2): slopes of the temperature and of its square over each pass, degC and degC^2; at: its rows."""
    if rows.temperature is None or not np.isfinite(rows.temperature[at]).all():
        return None
    warm = rows.temperature[at] - np.nanmean(rows.temperature)
    along = ramp(at.shape[1])
    return np.stack([warm @ along, warm**2 @ along], axis=1) / float(along @ along)


def _independent(columns: FloatArray) -> FloatArray:
    size = np.maximum(np.ptp(columns, axis=0), np.abs(columns).max(axis=0) * 1e-3)
    scaled = columns / np.where(size > 0.0, size, 1.0)
    keep: list[int] = []
    for index in np.flatnonzero(columns.any(axis=0)).tolist():
        if np.linalg.matrix_rank(scaled[:, [*keep, index]], tol=1e-6) > len(keep):
            keep.append(index)
    return np.asarray(scaled[:, keep])


def _helmert(count: int) -> FloatArray:
    """(count - 1, count): orthonormal rows that sum to zero."""
    found = np.zeros((count - 1, count))
    for k in range(1, count):
        found[k - 1, :k] = 1.0
        found[k - 1, k] = -k
        found[k - 1] /= np.sqrt(k * (k + 1.0))
    return found


def _places(rows: Rows) -> IntArray:
    """Targets whatever the feed."""
    parts = np.vstack([rows.setup[np.newaxis], np.round(rows.positions, 3) + 0.0, rows.directions])
    _, found = np.unique(parts, axis=1, return_inverse=True)
    return found.reshape(-1).astype(np.int64)
