"""Readings that do not count: disturbed ones, found by what the base, and causes once they are known, leave of them."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.linalg import solve_triangular
from scipy.special import ndtri

from trueaxis.diagnosis.null_model.base import base_of
from trueaxis.diagnosis.null_model.noise_fit import UNEVEN
from trueaxis.diagnosis.null_model.null import Null, coefficients_expected, left_by_base, lent, with_noise
from trueaxis.diagnosis.null_model.projection import orthonormal, spanned
from trueaxis.diagnosis.null_model.rows import DECIMALS, Rows
from trueaxis.diagnosis.null_model.whiten import RANK, Whitening
from trueaxis.diagnosis.result import BoolArray, FloatArray, IntArray, Outlier
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


def null_of(model: MachineModel, rows: Rows, values: FloatArray, noise_um: float | None) -> Null:
    """From the readings, outliers left out. values: (n,) mm, of all rows.

    The farthest readings go first: others wait, as these pull what is fitted to them.
    """
    whole = found = with_noise(rows, base_of(model, rows), values, noise_um)
    good, stays = np.ones((2, rows.size), dtype=bool)
    stays[:] = False
    for _ in range(ROUNDS):
        left = left_by_base(found, found.values)
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
    found = with_noise(found.rows, found.base, found.values, noise_um, found.found)
    back, outliers = explained(whole, found, good & ~never)
    if (back & ~never).any():
        found = whole.only((good | back) & ~never)
        found = with_noise(found.rows, found.base, found.values, noise_um, found.found)
    return replace(found, outliers=tuple(one for at, one in outliers.items() if never[at] or not back[at]))


def left_out(null: Null, taken: BoolArray, noise_um: float | None) -> Null:
    """Without further outliers, (n,), and what may be spoilt in their stead."""
    kept = ~taken & ~undecided(null.rows, ~taken)
    found = null.only(kept)
    found = with_noise(found.rows, found.base, found.values, noise_um, found.found)
    _, outliers = explained(null, found, kept)
    return replace(found, outliers=(*null.outliers, *outliers.values()))


def spoilt_beside(null: Null, signals: Sequence[FloatArray]) -> BoolArray:
    """(n,): outliers that show beside causes alone, of targets that are read again; where a target is read once the
    form of the cause may be what is wrong. signals: (n,) mm, what each cause does to the readings.
    """
    once = np.bincount(null.rows.target)[null.rows.target] == 1
    return _spoilt(null, left_by_base(null, null.values - np.sum(signals, axis=0)), once)


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
    left = whole.values - whole.base.columns @ coefficients_expected(found)
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
