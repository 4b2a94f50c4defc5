"""What is there before any cause: readings that count, what recalibration could change, noise of every run."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import solve_triangular
from scipy.special import ndtri

from trueaxis.diagnosis.null_model.base import Base, base_of
from trueaxis.diagnosis.null_model.by_run import ByRun
from trueaxis.diagnosis.null_model.noise import noise_of_runs
from trueaxis.diagnosis.null_model.noise_fit import UNEVEN, Found
from trueaxis.diagnosis.null_model.projection import Projection, orthonormal, spanned
from trueaxis.diagnosis.null_model.rows import DECIMALS, Rows
from trueaxis.diagnosis.null_model.whiten import RANK, RunNoise, Whitening, whitening
from trueaxis.diagnosis.result import BoolArray, FloatArray, IntArray, NoiseOf, Outlier
from trueaxis.estimation.factors import triangle_of
from trueaxis.estimation.outliers import (
    EXPECTED,
    NEIGHBOURS,
    WINDOW,
    Judged,
    covariance_of,
    excess,
    long,
    shared_by_repeats,
    spoilt,
)
from trueaxis.model.model import MachineModel

ALIKE = 0.5  # of the largest one: it bends the base, and with it readings of other runs, which wait
AS_MANY = 0.5 * UNEVEN**-2.0  # readings whose mean square scatters as that of a run about its instrument's
ROUNDS = 20  # of looking for outliers: they end by themselves, a few later than a run has outliers


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Null:
    """rows: those that count; values: (n,) mm, readings less what is expected; outliers: those left out; found: of the
    noise, where it was estimated; given: (of_machine, k), by how much given values may be off, see `given_by_chance`.
    """

    rows: Rows
    values: FloatArray
    base: Base
    whitening: Whitening
    noise: tuple[NoiseOf, ...]
    outliers: tuple[Outlier, ...]
    found: Found | None
    given: FloatArray

    def only(self, keep: BoolArray) -> "Null":
        """Of some rows, (n,)."""
        return replace(
            self,
            rows=self.rows.only(keep),
            values=self.values[keep],
            base=self.base.only(keep),
            whitening=self.whitening.only(keep),
        )


def null_of(model: MachineModel, rows: Rows, values: FloatArray, noise_um: float | None) -> Null:
    """From the readings, outliers left out. values: (n,) mm, of all rows.

    The farthest readings go first: others wait, as these pull what is fitted to them.
    """
    whole = found = _with_noise(rows, base_of(model, rows), values, noise_um)
    good, stays = np.ones((2, rows.size), dtype=bool)
    stays[:] = False
    for _ in range(ROUNDS):
        left = _left(found, found.values)
        bad = np.zeros(rows.size, dtype=bool)
        bad[good] = _spoilt(found, left, stays[good])
        if not bad.any():
            break
        for index in rows.present:
            mine = rows.of_run(index)
            stays[mine] |= long(~good[mine] | bad[mine])
        good = (good & ~bad) | stays
        found = whole.only(good)
    if good.all():
        return found
    never = undecided(rows, good)
    found = whole.only(good & ~never)
    found = _with_noise(found.rows, found.base, found.values, noise_um, found.found)
    back, outliers = explained(whole, found, good & ~never)
    if (back & ~never).any():
        found = whole.only((good | back) & ~never)
        found = _with_noise(found.rows, found.base, found.values, noise_um, found.found)
    return replace(found, outliers=tuple(one for at, one in outliers.items() if never[at] or not back[at]))


def left_out(null: Null, taken: BoolArray, noise_um: float | None) -> Null:
    """Without further outliers, (n,), and what may be spoilt in their stead."""
    kept = ~taken & ~undecided(null.rows, ~taken)
    found = null.only(kept)
    found = _with_noise(found.rows, found.base, found.values, noise_um, found.found)
    _, outliers = explained(null, found, kept)
    return replace(found, outliers=(*null.outliers, *outliers.values()))


def undecided(rows: Rows, good: BoolArray) -> BoolArray:
    """(n,): readings of a place of which some are spoilt, where no more than two in a row seem not to be: these may be
    the spoilt ones as well, by one disturbance. good: (n,), those that seem not to be.
    """
    open_to_doubt = np.zeros(rows.size, dtype=bool)
    places = places_of(rows)
    for place in np.unique(places[~good]):
        there = np.flatnonzero(places == place)
        kept = there[good[there]]
        open_to_doubt[there] |= 0 < kept.size <= NEIGHBOURS and np.ptp(kept) < kept.size
    return open_to_doubt


def places_of(rows: Rows) -> IntArray:
    """(n,): the same number for readings at the same positions with the same set-up, from whichever side."""
    at = np.vstack([rows.setup, np.round(rows.positions, DECIMALS) + 0.0])
    return np.asarray(np.unique(at, axis=1, return_inverse=True)[1]).reshape(-1)


def explained(whole: Null, found: Null, good: BoolArray) -> tuple[BoolArray, dict[int, Outlier]]:
    """(n,): readings left out that the noise of those that count explains after all; and each that was, by its place,
    in standard deviations of that noise, its neighbours known. good: (n,), those that count.
    """
    left = whole.values - whole.base.columns @ _expected(found)
    limit = float(-ndtri(0.5 * EXPECTED / max(good.size, 1)))
    back, told = np.zeros(good.size, dtype=bool), dict[int, Outlier]()
    for run, own, noise in zip(whole.base.runs, whole.base.own, lent(whole, found).whitening.runs, strict=True):
        at = run.rows.at
        kept = good[at]
        both = noise.only(kept).whitened(np.column_stack([own, left[at]])[kept])
        rest = left[at] - own @ np.linalg.lstsq(both[:, :-1], both[:, -1], rcond=RANK)[0]
        for k in np.flatnonzero(~kept):
            some = kept | (np.arange(at.size) == k)
            white = noise.only(some).alone()
            z = (white.weighed(rest[some]) / np.sqrt(white.weights()))[int(some[:k].sum())]
            back[at[k]] = abs(z) < limit
            told[int(at[k])] = Outlier(run.rows.run.id, int(whole.rows.seq[at[k]]), float(rest[k]), float(z))
    return back, told


def lent(null: Null, other: Null) -> Null:
    """With the noise that another has of the same runs, or of one with the same noise (`noise_groups`)."""
    runs = zip(other.base.runs, other.whitening.runs, strict=True)
    told: dict[object, RunNoise] = {}
    for run, noise in runs:
        told |= {run.noise_group: noise, run.rows.index: noise}
    noises = []
    for run, before in zip(null.base.runs, null.whitening.runs, strict=True):
        noise = told.get(run.rows.index) or told.get(run.noise_group) or before
        known = replace(noise, steps=before.steps, passed=before.passed, drifts=before.drifts, ball=before.ball)
        noises.append(replace(known, freedom=before.freedom))
    return replace(null, whitening=whitening(null.rows.run, noises, null.base.free))


def balls_anywhere(null: Null) -> Null:
    """With the ball of each run free: where it may be the fault of an instrument, other balls do not tell its place."""
    runs = [replace(one, places=0.0) for one in null.whitening.runs]
    return replace(null, whitening=whitening(null.rows.run, runs, null.base.anywhere))


def again(null: Null, signal: FloatArray, noise_um: float | None) -> Null:
    """With the noise that is left when causes are known. signal: (n,) mm, what they do to the readings."""
    left = null.values - signal
    found = _with_noise(null.rows, null.base, left, noise_um, null.found)
    return replace(found, values=null.values, outliers=null.outliers, given=null.given)


def rougher(model: MachineModel, null: Null, component: str, noise_um: float | None) -> Null:
    """With a rougher curve of one more component; `given` is that of no value."""
    base = base_of(model, null.rows, (*null.base.rough, component))
    found = _with_noise(null.rows, base, null.values, noise_um, null.found)
    return replace(found, outliers=null.outliers)


def _with_noise(
    rows: Rows, base: Base, values: FloatArray, noise_um: float | None, before: Found | None = None
) -> Null:
    runs, noise, found = noise_of_runs(rows, base, values, noise_um, before)
    white = whitening(rows.run, runs, base.free)
    given = np.zeros((base.of_machine, 0))
    return Null(
        rows=rows, values=values, base=base, whitening=white, noise=noise, outliers=(), found=found, given=given
    )


def what_is_free(null: Null, free: FloatArray) -> Projection:
    """What is no news before any cause is known. free: (n, k), mm, columns that are free besides."""
    columns = null.base.columns.beside(free) if free.size else null.base.columns
    basis = Projection(spanned(columns.whitened(null.whitening)))
    return basis.softened(null.whitening(null.base.by_chance))


def fitted(whiten: Whitening, columns: ByRun, values: FloatArray) -> FloatArray:
    """(p,): coefficients of columns (n, p) by weighted least squares, of least norm in units of their lengths."""
    q, r, size = factored(whiten, columns)
    return np.asarray(np.linalg.lstsq(r, q.transposed(whiten(values)), rcond=RANK)[0] / size)


def factored(whiten: Whitening, columns: ByRun) -> tuple[ByRun, FloatArray, FloatArray]:
    """Q (n, p) and R (p, p) of columns (n, p), mm, whitened and divided by their lengths, and these, (p,)."""
    white = columns.whitened(whiten)
    size = np.linalg.norm(white.weights, axis=0)
    size[size == 0.0] = 1.0
    q, r = np.linalg.qr(white.weights / size)
    return replace(white, weights=q), r, size


def less_own(whiten: Whitening, values: FloatArray) -> FloatArray:
    """(n,), mm: values less what the unknowns of each run's instrument make of them, its drift and the place of its
    ball as they are expected.
    """
    found = values.copy()
    for place, (run, own) in enumerate(zip(whiten.runs, whiten.own, strict=True)):
        here = slice(int(whiten.starts[place]), int(whiten.starts[place + 1]))
        by_chance = run.of_set_up
        sized = np.column_stack([by_chance, own / np.maximum(np.linalg.norm(own, axis=0), 1e-300)])
        both = run.whitened(np.column_stack([sized, values[here]]))
        both = np.vstack([both, np.eye(by_chance.shape[1], both.shape[1])])  # what is expected of these
        found[here] -= sized @ np.linalg.lstsq(both[:, :-1], both[:, -1], rcond=RANK)[0]
    return found


def _expected(null: Null) -> FloatArray:
    """(p,): coefficients of the base with what is expected of them: what nothing else tells of is not any number."""
    q, r, size = factored(null.whitening, null.base.columns)
    wide, inside = null.base.wide(), q.transposed(null.whitening(null.values))
    return np.asarray(wide * (expected_root(r * (size * wide))[:, : inside.size] @ inside))


def expected_root(sized: FloatArray) -> FloatArray:
    """(p, 2 p): a root of the covariance of unknowns in units of what is expected of each, once the readings have had
    their say; its first p columns times what these ask for are the unknowns. sized: (p, p), `factored` columns times
    what is expected. In these units nothing has to be cut off for rounding.
    """
    return np.linalg.pinv(np.vstack([sized, np.eye(sized.shape[1])]))


def _left(null: Null, values: FloatArray) -> FloatArray:
    """(n,), mm: what the base leaves of values."""
    coefficient = fitted(null.whitening, null.base.columns, values)
    return less_own(null.whitening, values - null.base.columns @ coefficient)


def _spoilt(null: Null, left: FloatArray, stays: BoolArray) -> BoolArray:
    """(n,): outliers. stays: (n,), readings that are none, whatever they are."""
    found = np.zeros(null.rows.size, dtype=bool)
    shared = shared_by_repeats(left, _apart(null.rows.target))
    basis = spanned(null.base.columns.whitened(null.whitening))
    for place, (run, (few, weights)) in enumerate(zip(null.base.runs, basis.parts(), strict=True)):
        at = run.rows.at
        by_base = few @ triangle_of([weights.T]).T if at.size <= WINDOW else few[:, :0]
        scale = None if null.found is None else float(null.found.scales[place])
        found[at] = spoilt(_judged(null.whitening, place, left[at], shared[at], by_base, scale), null.rows.size)
    found &= ~stays
    size = np.abs(left) / null.whitening.sigma
    return np.asarray(found & (size >= ALIKE * float(size[found].max(initial=0.0))))


def _judged(
    whiten: Whitening, place: int, left: FloatArray, shared: BoolArray, by_base: FloatArray, scale: float | None
) -> Judged:
    """The readings of a run beside what the base, (n, r) whitened, and its own unknowns make of them.

    scale: of its white noise over that of its instrument, None where it is given.
    """
    run, own = whiten.runs[place], whiten.own[place]
    factor = excess(left, run.sigma) if scale is None else 1.0
    noise, usual = run.noise.sized(factor), 1.0
    if scale is not None:
        usual = (float(np.hypot(noise.white / scale, noise.slow)) / noise.sigma) ** 2
    taken = np.zeros((left.size, 0))
    if left.size <= WINDOW:
        root = np.linalg.cholesky(covariance_of(noise, run.steps, run.chance))
        by_own = orthonormal(solve_triangular(root, own, lower=True))
        by_own = solve_triangular(root, by_own, lower=True, trans="T")
        taken = np.hstack([by_own, whiten.back_of_run(place, by_base) / factor])
    return Judged(
        steps=run.steps,
        left=left,
        shared=shared,
        good=np.ones(left.size, dtype=bool),
        noise=noise,
        chance=run.chance,
        taken=taken,
        usual=usual,
        told=np.inf if scale is None else AS_MANY,
    )


def _apart(target: IntArray) -> IntArray:
    """(n,): the same number where the same target was read, but not in a row: what spoils a reading spoils the next."""
    change = np.diff(target, prepend=-1) != 0
    first = np.flatnonzero(change)
    since = np.arange(target.size) - first[np.cumsum(change) - 1]
    return np.asarray(target * target.size + since)
