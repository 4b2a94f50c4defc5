"""Two neighbouring readings that were disturbed are no cause; what three share may be one."""

import numpy as np
import pytest
from scipy.linalg import block_diag

from tests.diagnosis.prepared import SIGMA, Field, FloatArray, dense_covariance, field, noise_of
from trueaxis.diagnosis.causes.neighbours import among, disturbed, explained_by
from trueaxis.diagnosis.causes.search import Found, Ground, search, whitened_columns


def planted(where: Field, count: int, size: float, seed: int = 3) -> tuple[Ground, list[int]]:
    """A ground of noise with some readings at the start of a laser run off by so many standard deviations."""
    rows = where.readings.rows
    mine = next(rows.of_run(k) for k in rows.present if rows.runs[k].instrument == "laser")
    off = list(range(mine.start, mine.start + count))
    values = noise_of(where, seed)
    values[off] += size * SIGMA
    return where.ground(values), off


@pytest.mark.parametrize("size", [8.0, -15.0, 60.0])
def test_two_neighbours_are_taken_for_a_step_and_are_none(size: float) -> None:
    ground, off = planted(field(), 2, size)
    found = search(ground)
    assert [one.scan.effect.kind for one in found.causes] == ["laser_step"]
    pairs = disturbed(ground, found)
    assert list(pairs) == [found.causes[0].scan.effect]
    (pair,) = pairs.values()
    assert np.flatnonzero(among(ground.readings.rows, pair)).tolist() == off
    assert disturbed(ground, found, real=pairs.keys()) == {}


@pytest.mark.parametrize("count", [3, 6, 18])
@pytest.mark.parametrize("size", [8.0, 60.0])
def test_a_step_of_three_readings_stays(count: int, size: float) -> None:
    ground, _ = planted(field(), count, size)
    found = search(ground)
    assert [one.scan.effect.kind for one in found.causes] == ["laser_step"]
    assert disturbed(ground, found) == {}


def test_a_cause_beyond_any_doubt_stays_beside_readings_that_are_far_off() -> None:
    """The chance that is left of it is too small for a number."""
    where = field()
    ground, off = planted(where, 18, 200.0)
    found = search(ground)
    values = noise_of(where, 3)
    values[off] += 200.0 * SIGMA
    values[off[5:7]] += 5000.0 * SIGMA
    assert disturbed(where.ground(values), found) == {}


def test_what_two_readings_explain_is_that_of_least_squares_with_both_free() -> None:
    """Generalised least squares on all readings, written out, with two columns of their own and with the cause."""
    where = field()
    ground, off = planted(where, 2, 15.0)
    found = search(ground)
    (cause,) = found.causes
    values = noise_of(where, 3)
    values[off] += 15.0 * SIGMA
    pair = np.eye(values.size)[:, off]
    signal = cause.signature.over_all()
    taken, beside = explained_by(ground.whitening, ground.base, off, *_products(ground, cause))
    assert taken == pytest.approx(left(where, values) - left(where, values, pair), rel=1e-6)
    both = left(where, values, pair) - left(where, values, np.hstack([pair, signal]))
    assert beside == pytest.approx(both, rel=1e-6, abs=1e-6)


def _products(ground: Ground, cause: Found) -> tuple[FloatArray, FloatArray]:
    white = np.column_stack([ground.values, whitened_columns(ground, cause.signature)])
    rest = ground.base.rest(white)
    return ground.whitening.back(ground.base.rest_transposed(rest)), rest.T @ rest


def left(where: Field, values: FloatArray, *columns: FloatArray) -> float:
    """The sum of squares that the base, every run's own unknowns and further columns leave."""
    covariance = block_diag(*(dense_covariance(run) for run in where.whitening.runs))
    root = np.linalg.cholesky(covariance)
    free = np.hstack([where.columns, where.without_own(), *columns])
    white = np.linalg.solve(root, np.column_stack([free, values]))
    white[:, :-1] /= np.maximum(np.linalg.norm(white[:, :-1], axis=0), 1e-12)
    rest = white[:, -1] - white[:, :-1] @ np.linalg.lstsq(white[:, :-1], white[:, -1], rcond=1e-9)[0]
    return float(rest @ rest)
