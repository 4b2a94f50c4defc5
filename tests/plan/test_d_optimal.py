"""D-optimal choice against all choices there are."""

from itertools import combinations

import numpy as np
import pytest

from trueaxis.plan.d_optimal import choose, gains

DRAW = np.random.default_rng(7)
CANDIDATES = [DRAW.normal(size=(3, 5)) * DRAW.uniform(0.2, 3.0) for _ in range(9)]
START = 1e-3 * np.eye(5)


def log_det(matrix: np.ndarray) -> float:
    return float(np.linalg.slogdet(matrix)[1])


def test_gains_are_differences_of_log_determinants() -> None:
    expected = [log_det(START + rows.T @ rows) - log_det(START) for rows in CANDIDATES]
    assert gains(START, CANDIDATES) == pytest.approx(expected, rel=1e-9)
    tall = [np.vstack([rows] * 4) for rows in CANDIDATES]
    expected = [log_det(START + rows.T @ rows) - log_det(START) for rows in tall]
    assert gains(START, tall) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_no_single_exchange_is_better_and_hardly_any_choice(count: int) -> None:
    found = choose(START, CANDIDATES, count)
    assert len(set(found.indices)) == count

    def value(indices: tuple[int, ...]) -> float:
        return log_det(START + sum((CANDIDATES[i].T @ CANDIDATES[i] for i in indices), np.zeros((5, 5))))

    reached = value(found.indices)
    assert sum(found.gains) == pytest.approx(reached - log_det(START))
    for place in range(count):
        rest = found.indices[:place] + found.indices[place + 1 :]
        assert all(value((*rest, other)) <= reached + 1e-4 for other in range(9) if other not in found.indices)
    best = max(value(indices) for indices in combinations(range(9), count))
    assert reached >= best - 0.05 * abs(best - log_det(START))


def test_exchange_mends_what_greed_spoils() -> None:
    """Greedy takes the long compromise first; the best pair is the other two."""
    rows = [np.array([[1.0, 1.0]]) * 0.8, np.array([[1.0, 0.0]]), np.array([[0.0, 1.0]])]
    found = choose(1e-6 * np.eye(2), rows, 2)
    assert sorted(found.indices) == [1, 2]
    assert found.exchanges == 1
    assert list(choose(1e-6 * np.eye(2), rows, 1).indices) == [0]


def test_more_runs_than_candidates() -> None:
    assert sorted(choose(START, CANDIDATES[:2], 5).indices) == [0, 1]
