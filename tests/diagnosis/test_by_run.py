"""Columns kept run by run against the same columns written out."""

from functools import cache
from itertools import pairwise

import numpy as np
import pytest

from tests.diagnosis.prepared import SIGMA, SLOW, SMALL, Field, field
from trueaxis.diagnosis.null_model.by_run import ByRun, by_run
from trueaxis.estimation.factors import few_of


@cache
def where() -> Field:
    return field(SMALL, SLOW, settles=2.0 * SIGMA)


def columns() -> ByRun:
    return where().null.columns


def test_a_smooth_base_holds_but_few_directions_of_a_run_and_loses_nothing() -> None:
    everything = columns().dense()
    starts = columns().starts
    for first, last in pairwise(starts):
        few, weights = few_of(everything[first:last])
        assert few.shape[1] < 60 < everything.shape[1]
        assert few.T @ few == pytest.approx(np.eye(few.shape[1]), abs=1e-12)
        assert few @ weights == pytest.approx(everything[first:last], abs=1e-14 * np.abs(everything).max())


def test_nothing_is_held_by_no_column() -> None:
    few, weights = few_of(np.zeros((4, 3)))
    assert (few.shape, weights.shape) == ((4, 0), (0, 3))
    found = by_run([(few, weights), (np.ones((2, 1)), np.ones((1, 3)))]).dense()
    assert found == pytest.approx(np.repeat([0.0, 1.0], (4, 2))[:, np.newaxis] * np.ones(3), abs=1e-15)


def test_products_are_those_of_the_columns_written_out() -> None:
    source, everything = np.random.default_rng(1), columns().dense()
    n, p = everything.shape
    right, vectors = source.normal(size=(p, 2)), source.normal(size=(n, 2))
    assert columns() @ right == pytest.approx(everything @ right, rel=1e-9, abs=1e-12)
    assert columns().transposed(vectors) == pytest.approx(everything.T @ vectors, rel=1e-9, abs=1e-12)
    assert columns().squares() == pytest.approx(np.sum(everything**2, axis=1), rel=1e-9)
    rows = np.r_[columns().starts[1] : columns().starts[3], columns().starts[5] : columns().starts[6]]
    assert columns().transposed(vectors[rows], rows) == pytest.approx(everything[rows].T @ vectors[rows], abs=1e-12)


def test_whitened_they_are_the_whitened_columns_and_their_products_those_of_the_weights() -> None:
    found, expected = columns().whitened(where().whitening), where().whitening(columns().dense())
    size = np.abs(expected).max(axis=0)
    told = size > 0.0
    assert found.dense()[:, told] / size[told] == pytest.approx(expected[:, told] / size[told], abs=1e-9)
    assert found.weights.T @ found.weights == pytest.approx(expected.T @ expected, rel=1e-8, abs=1e-9)


def test_further_columns_some_rows_and_the_first_runs() -> None:
    source, everything = np.random.default_rng(2), columns().dense()
    more = source.normal(size=(everything.shape[0], 2))
    keep = np.asarray(source.random(everything.shape[0]) < 0.5)
    keep[: columns().starts[1]] = False  # a run of which none is kept
    both = np.hstack([everything, more])
    assert columns().beside(more).dense() == pytest.approx(both, abs=1e-12)
    assert columns().beside(more).only(keep).dense() == pytest.approx(both[keep], abs=1e-12)
    nothing = columns().only(np.zeros(keep.size, dtype=bool))
    assert nothing.dense().shape == nothing.whitened(where().whitening).dense().shape == (0, everything.shape[1])
    assert not columns().transposed(more[:0], np.zeros(0, dtype=np.int64)).any()
    assert columns().first(3).dense() == pytest.approx(everything[: columns().starts[3]], abs=1e-12)
    assert columns().take(slice(5)).times(np.eye(5)[:, ::-1]).dense() == pytest.approx(everything[:, 4::-1], abs=1e-12)
