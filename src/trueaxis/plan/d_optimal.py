"""Runs that add most to a plan: D-optimal choice, greedy first, then by exchange (Fedorov 1972).

The criterion is the logarithm of the determinant of the information with what is expected of the errors beforehand
(Bayesian D-optimality, Chaloner & Verdinelli 1995): log det(A'A + (noise/prior)^2 I) in scaled unknowns. So it is
finite where the plan is singular, and nothing is gained by unknowns that are small beyond measuring anyway.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import solve_triangular

from trueaxis.measure.machine import FloatArray

ENOUGH = 1e-6  # relative gain of an exchange that is still made


@dataclass(frozen=True, slots=True)
class Chosen:
    """Indices of the candidates in the order of their gains (n,), and how many exchanges were made."""

    indices: tuple[int, ...]
    gains: tuple[float, ...]
    exchanges: int


def choose(information: FloatArray, candidates: Sequence[FloatArray], count: int, most_exchanges: int = 50) -> Chosen:
    """The best `count` candidates, each once, added to an information matrix (n, n), positive definite.

    candidates: rows (m, n) of each.
    """
    chosen: list[int] = []
    current = information.copy()
    for _ in range(min(count, len(candidates))):
        gain = gains(current, candidates)
        gain[chosen] = -np.inf
        chosen.append(int(gain.argmax()))
        current = current + candidates[chosen[-1]].T @ candidates[chosen[-1]]
    exchanges = 0
    while exchanges < most_exchanges and _exchange(information, candidates, chosen):
        exchanges += 1
    return Chosen(*_in_order(information, candidates, chosen), exchanges)


def gains(information: FloatArray, candidates: Sequence[FloatArray]) -> FloatArray:
    """(n_candidates,): growth of log det by each, log det(I + B M^-1 B')."""
    factor = np.linalg.cholesky(information)
    found = np.empty(len(candidates))
    sizes = np.array([rows.shape[0] for rows in candidates])
    for size in np.unique(sizes):
        same = np.flatnonzero(sizes == size).tolist()
        stacked = np.vstack([candidates[index] for index in same])
        whitened = solve_triangular(factor, stacked.T, lower=True, check_finite=False).T.reshape(len(same), size, -1)
        turned = whitened.transpose(0, 2, 1)
        small = whitened @ turned if size <= information.shape[0] else turned @ whitened
        found[same] = np.linalg.slogdet(np.eye(small.shape[1]) + small)[1]
    return found


def _exchange(information: FloatArray, candidates: Sequence[FloatArray], chosen: list[int]) -> bool:
    """Make the best exchange of a chosen candidate for another; whether there was one."""
    best, at = ENOUGH, None
    for place in range(len(chosen)):
        kept = [index for index in chosen if index != chosen[place]]
        rest = information + sum((candidates[i].T @ candidates[i] for i in kept), np.zeros_like(information))
        gain = gains(rest, candidates)
        own = gain[chosen[place]]
        gain[chosen] = -np.inf
        other = int(gain.argmax())
        if gain[other] - own > best * max(1.0, own):
            best, at = (gain[other] - own) / max(1.0, own), (place, other)
    if at is None:
        return False
    chosen[at[0]] = at[1]
    return True


def _in_order(
    information: FloatArray, candidates: Sequence[FloatArray], chosen: Sequence[int]
) -> tuple[tuple[int, ...], tuple[float, ...]]:
    left, order, gained = list(chosen), [], []
    current = information.copy()
    while left:
        gain = gains(current, [candidates[index] for index in left])
        best = int(gain.argmax())
        gained.append(float(gain[best]))
        order.append(left.pop(best))
        current = current + candidates[order[-1]].T @ candidates[order[-1]]
    return tuple(order), tuple(gained)
