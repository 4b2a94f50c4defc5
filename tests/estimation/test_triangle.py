"""Triangles against what they stand for: the same sums of squares as the rows that went into them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from trueaxis.estimation.factors import inverse, triangle_of, with_rows, with_triangle
from trueaxis.measurement.machine import FloatArray

SEEDS = st.integers(0, 2**32 - 1)


def squares(rows: FloatArray) -> FloatArray:
    return rows.T @ rows


@given(SEEDS, st.integers(0, 60), st.integers(1, 50))
def test_rows_become_a_triangle(seed: int, m: int, n: int) -> None:
    rows = np.random.default_rng(seed).standard_normal((m, n))
    found = triangle_of([rows[: m // 3], rows[m // 3 :]])
    assert found.shape == (min(m, n), n)
    assert not np.tril(found, -1).any()
    np.testing.assert_allclose(squares(found), squares(rows), atol=1e-11)


@given(SEEDS, st.integers(0, 60), st.integers(1, 50), st.integers(0, 50))
def test_a_triangle_takes_rows_and_a_triangle(seed: int, m: int, n: int, first: int) -> None:
    draw = np.random.default_rng(seed)
    triangle, rows = np.triu(draw.standard_normal((n, n))), draw.standard_normal((m, n))
    other = np.triu(draw.standard_normal((n, n)))[: min(first, n)]
    for found, more in ((with_rows(triangle, rows.copy()), rows), (with_triangle(triangle, other.copy()), other)):
        assert not np.tril(found, -1).any()
        np.testing.assert_allclose(squares(found), squares(triangle) + squares(more), atol=1e-11)


@pytest.mark.parametrize("large", [1.0, 1e9])
def test_what_large_rows_say_leaves_what_small_ones_say(large: float) -> None:
    """One combination read 1e9 times as well as the prior knows the others; the least squares are known in integers."""
    n = 6
    rows = large * np.vander(np.arange(1.0, 4.0), n)  # three readings of six unknowns
    known = np.arange(1.0, n + 1.0)
    triangle = with_rows(np.zeros((n, n)), rows.copy())
    triangle = with_triangle(triangle, np.eye(n))
    assert np.linalg.norm(triangle @ known) == pytest.approx(np.hypot(np.linalg.norm(rows @ known), np.sqrt(91.0)))
    open_part = np.linalg.svd(rows)[2][3:]  # combinations that no reading holds: the prior alone, 1
    root = open_part @ inverse(triangle)
    np.testing.assert_allclose(root @ root.T, np.eye(3), atol=1e-6)
