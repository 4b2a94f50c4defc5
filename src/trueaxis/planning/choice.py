"""The runs that lower the mean variance of what is asked for most, per minute: I- and c-optimal choice, greedy.

With S a root of the covariance (units of the prior) and J the rows of a run, its readings lower the variance of T by
|| (1 + A A')^-1/2 A (T S)' ||^2, A = J S: small matrices, whatever the number of unknowns. A chosen run turns S into
S (1 + A'A)^-1/2, which changes the A of all others by a product of its rank.

Greedy choice is near the best: variances that fall by what runs tell have less to fall with every run (the classic
bound of 1 - 1/e holds for the determinant, and approximately here; tests compare with all pairs).
"""

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from trueaxis.estimation.judgement import NINE_TENTHS
from trueaxis.measurement.machine import FloatArray

LEAST_FALL = 0.01  # of u, by a run that is still worth it: less is within what sizes of errors are off by
KEPT = 1e-6  # of the variance of what is asked for: directions of it that are left out of the sums
NOTHING = 1e-12  # of a variance: rounding


@dataclass(frozen=True, slots=True, eq=False)
class Offer:
    """rows: (m, n), as `informing_rows` gives them; minutes: of the run itself; shared: what it needs that others need,
    too, and that takes its minutes once: a set-up.
    """

    rows: FloatArray
    minutes: float
    shared: tuple[tuple[Hashable, float], ...]


@dataclass(frozen=True, slots=True)
class Chosen:
    """An offer by its index; minutes: that it takes more; u: after it, root of the mean of what is asked for."""

    index: int
    minutes: float
    u: float


def choose(
    spread: FloatArray,
    target: FloatArray,
    offers: Sequence[Offer],
    goes_on: Callable[[Sequence[Chosen]], float],
    there: Sequence[Hashable] = (),
    least_fall: float = 0.0,
) -> list[Chosen]:
    """One offer after the other, each once.

    spread: (n, r), a root of the covariance before, in units of the prior; target: (q, n), whose mean square is to
    fall: sum of squares of target @ spread; goes_on: minutes that are left for another, after those chosen; there:
    what is set up already; least_fall: share of u that a run lowers at least, of the part of u that offers tell at
    all: what none of them tells is no reason to stop.
    """
    if not offers:
        return []
    starts = np.concatenate([[0], np.cumsum([one.rows.shape[0] for one in offers])]).tolist()
    parts = [slice(first, last) for first, last in pairwise(starts)]
    rows = np.vstack([one.rows for one in offers]) @ spread
    wanted = _few(target @ spread)
    told = _told(rows)
    left = np.ones(len(offers), dtype=bool)
    done, chosen = set(there), list[Chosen]()
    while left.any() and (allowed := goes_on(chosen)) > 0.0:
        gains = _gains(rows, wanted, parts)
        taking = np.array([one.minutes + sum(m for key, m in one.shared if key not in done) for one in offers])
        least = max(
            (1.0 - (1.0 - least_fall) ** 2) * float(np.sum((wanted @ told) ** 2)), NOTHING * float(np.sum(wanted**2))
        )
        open_ = left & (taking <= allowed) & (gains > least)
        if not open_.any():
            break
        best = int(np.argmax(np.where(open_, gains / taking, -np.inf)))
        done.update(key for key, _ in offers[best].shared)
        left[best] = False
        rows, wanted = _updated(rows, wanted, parts[best])
        chosen.append(Chosen(best, float(taking[best]), float(np.sqrt(np.sum(wanted**2)))))
    return chosen


def _few(wanted: FloatArray) -> FloatArray:
    """(t, r): as few rows with the same sums of squares, but for KEPT of the whole."""
    _, size, right = np.linalg.svd(wanted, full_matrices=False)
    tail = np.cumsum(size[::-1] ** 2)[::-1]
    kept = tail > KEPT * float(tail[0]) if size.size else np.zeros(0, dtype=bool)
    return np.asarray(size[kept, np.newaxis] * right[kept])


def _told(rows: FloatArray) -> FloatArray:
    """(r, k): orthonormal directions of which all rows together tell more than the prior, by the rule of judgement."""
    information, directions = np.linalg.eigh(rows.T @ rows)
    return np.asarray(directions[:, 1.0 + information > NINE_TENTHS**-2])


def _gains(rows: FloatArray, wanted: FloatArray, parts: Sequence[slice]) -> FloatArray:
    """(n_offers,): by how much each lowers the sum of variances."""
    seen = rows @ wanted.T
    found = np.zeros(len(parts))
    for index, part in enumerate(parts):
        own = rows[part]
        if own.size:
            variance, turned = np.linalg.eigh(own @ own.T)
            squares = np.sum((turned.T @ seen[part]) ** 2, axis=1)
            found[index] = float(np.sum(squares / (1.0 + np.maximum(variance, 0.0))))
    return found


def _updated(rows: FloatArray, wanted: FloatArray, part: slice) -> tuple[FloatArray, FloatArray]:
    """Both after the rows of an offer are known: times (1 + A'A)^-1/2."""
    _, size, right = np.linalg.svd(rows[part], full_matrices=False)
    change = (1.0 - 1.0 / np.hypot(1.0, size))[:, np.newaxis] * right
    return rows - (rows @ right.T) @ change, wanted - (wanted @ right.T) @ change
