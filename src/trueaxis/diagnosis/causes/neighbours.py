"""Causes and stale values that two neighbouring readings explain as well: these were disturbed, and are no sign of
anything.

Outliers are looked for before any cause, when nobody knows whether the noise of their run is larger than that of its
instrument. What is named afterwards may rest on two of them still: a step of a laser where the readings before it, or
after it, are two. Two readings that are left out take their part of every cause with them (deletion of cases; Cook and
Weisberg, Residuals and Influence in Regression, 1982): a cause of more than these stays.
"""

from collections.abc import Collection, Sequence

import numpy as np

from trueaxis.diagnosis.causes.search import RIVAL, Found, Ground, Search, beside_causes, whitened_columns
from trueaxis.diagnosis.judging.stale import Changes, free_besides, stale_values
from trueaxis.diagnosis.null_model.freedom import Freedom
from trueaxis.diagnosis.null_model.null import Null
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.null_model.whiten import Whitening
from trueaxis.diagnosis.result import BoolArray, FloatArray, IntArray
from trueaxis.effects.kind import Effect
from trueaxis.estimation.outliers import NEIGHBOURS, ROUNDING
from trueaxis.estimation.tails import LN10, log_chi2_tail

# readings that are looked at beside their neighbours, those that deviate most: each costs a projection of all readings,
# and of two that explain as much as a cause one is among the farthest
LOOKED_AT = 16

LeftOut = frozenset[tuple[int, int]]  # run, by number, and place in it


def disturbed(ground: Ground, found: Search, real: Collection[Effect] = ()) -> dict[Effect, LeftOut]:
    """Causes that two neighbouring readings explain as well, and that are none beside these two, with the two. real:
    causes that are no disturbance.
    """
    rows, pairs = ground.readings.rows, dict[Effect, LeftOut]()
    for index, cause in enumerate(found.causes):
        others = found.causes[:index] + found.causes[index + 1 :]
        pair = [] if cause.scan.effect in real else _two(ground, beside_causes(ground, others), cause)
        if pair:
            pairs[cause.scan.effect] = frozenset((int(rows.run[row]), int(rows.seq[row])) for row in pair)
    return pairs


def among(rows: Rows, some: LeftOut) -> BoolArray:
    """(n,): whether a reading is one of some."""
    return np.array([one in some for one in zip(rows.run.tolist(), rows.seq.tolist(), strict=True)])


def of_one_run(pair: LeftOut, before: LeftOut) -> bool:
    """Whether two readings are of a run of which others were left out before."""
    return not {run for run, _ in pair}.isdisjoint(run for run, _ in before)


def spoilt_values(
    null: Null, changes: Changes, causes: Sequence[FloatArray], besides: Sequence[FloatArray], freedom: Freedom
) -> BoolArray:
    """(n,): two neighbouring readings that explain about as much as all that is stale, and beside which fewer
    components are. causes, besides: see `free_besides`.

    A base that follows any curve may follow two readings, and the search for outliers has then nothing left of them.
    """
    taken = np.zeros(null.rows.size, dtype=bool)
    if not changes.stale:
        return taken
    base = free_besides(null, causes, besides)
    left = base.rest(null.whitening(null.values))[:, np.newaxis]
    back, squares = null.whitening.back(base.rest_transposed(left)), left.T @ left
    every, best, rows = np.arange(taken.size), changes.evidence - RIVAL, list[int]()
    for pair in _pairs(null.rows.run, null.whitening.sigma, every, back[:, 0]):
        explained, _ = explained_by(null.whitening, base, pair, back, squares)
        preference = _decades(explained, NEIGHBOURS, taken.size)
        if preference >= best:
            best, rows = preference, pair
    if rows:
        alone = [np.asarray(every == row, dtype=np.float64) for row in rows]
        beside = stale_values(null, [*causes, *alone], besides, freedom)
        stale = {one.component for one in changes.stale}
        taken[rows] = {one.component for one in beside.stale} < stale
    return taken


def _two(ground: Ground, base: Projection, cause: Found) -> Sequence[int]:
    """The rows of two readings that explain as much as a cause, beside base; none where no two do."""
    both = base.rest(np.column_stack([ground.values, whitened_columns(ground, cause.signature)]))
    back, products = ground.whitening.back(base.rest_transposed(both)), both.T @ both
    best, rows = cause.scan.preference - RIVAL, list[int]()
    support = cause.signature.support
    for pair in _pairs(ground.readings.rows.run, ground.whitening.sigma, support, back[:, 0]):
        explained, beside = explained_by(ground.whitening, base, pair, back, products)
        # as many pairs are tried as readings that the cause acts on: its own preference counts its own places
        preference = _decades(explained, NEIGHBOURS, support.size)
        if preference >= best and _decades(beside, cause.scan.freedom, cause.scan.tries) < ground.threshold:
            best, rows = preference, pair
    return rows


def _decades(square: float, freedom: int, tries: float) -> float:
    """Of evidence, by a chi square at the best of so many places. In logarithms: the chance itself may be too small for
    a number.
    """
    return -log_chi2_tail(square, freedom) / LN10 - float(np.log10(tries))


def _pairs(run: IntArray, sigma: FloatArray, support: IntArray, back: FloatArray) -> list[list[int]]:
    """Rows of neighbours of a run, of which one is among those of the support that deviate most."""
    weighed = np.abs(back) * sigma
    far = support[np.argsort(-weighed[support], kind="stable")[:LOOKED_AT]].tolist()
    firsts = sorted({one - before for one in far for before in range(NEIGHBOURS)})
    return [[one, one + 1] for one in firsts if 0 <= one < run.size - 1 and run[one] == run[one + 1]]


def explained_by(
    whitening: Whitening, base: Projection, pair: list[int], back: FloatArray, products: FloatArray
) -> tuple[float, float]:
    """Chi squares: what two readings explain of what is left, and what the cause does beside them.

    pair: their rows; back: (n, 1 + k), 1/mm, products of what is left and of the cause with single readings; products:
    (1 + k, 1 + k), of what is left and the cause, whitened; k may be 0.
    """
    alone = np.zeros((back.shape[0], len(pair)))
    alone[pair, range(len(pair))] = 1.0
    white = whitening(alone)
    single = base.rest(white)
    gram = single.T @ single
    if (np.diag(gram) <= ROUNDING * np.sum(white**2, axis=0)).any():  # nothing is left of a reading
        return 0.0, float(products[0, 0])
    inside = back[pair].T @ np.linalg.pinv(gram, hermitian=True) @ back[pair]
    rest = products - inside
    return float(inside[0, 0]), float(rest[0, 1:] @ np.linalg.pinv(rest[1:, 1:], hermitian=True) @ rest[1:, 0])
