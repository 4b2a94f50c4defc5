"""Projection and rank against SciPy's null spaces and explicit least squares."""

import numpy as np
import pytest
from scipy.linalg import null_space, orth, subspace_angles

from tests.diagnosis.prepared import SMALL, WHITE, field
from trueaxis.diagnosis.null_model.by_run import by_run, of_basis
from trueaxis.diagnosis.null_model.projection import Projection, orthonormal, spanned


def dependent(seed: int = 0) -> np.ndarray:
    """(50, 9) of rank 6, columns of sizes from 1e-9 to 1e9."""
    source = np.random.default_rng(seed)
    columns = source.normal(size=(50, 6)) @ source.normal(size=(6, 9))
    return np.asarray(columns * np.logspace(-9, 9, 9))


def projected(columns: np.ndarray) -> Projection:
    return Projection(of_basis(orthonormal(columns)))


def test_basis_is_orthonormal_and_spans_the_columns() -> None:
    columns = dependent()
    basis = orthonormal(columns)
    assert basis.shape == (50, 6)
    assert basis.T @ basis == pytest.approx(np.eye(6), abs=1e-12)
    scaled = columns / np.linalg.norm(columns, axis=0)
    assert np.max(subspace_angles(basis, orth(scaled, rcond=1e-9))) < 1e-6


def test_what_is_left_is_the_part_in_the_null_space() -> None:
    columns = dependent()
    values = np.random.default_rng(1).normal(size=(50, 3))
    outside = null_space(columns.T / np.linalg.norm(columns, axis=0)[:, np.newaxis], rcond=1e-9)
    found = projected(columns).rest(values)
    assert outside.shape[1] == 44
    assert found == pytest.approx(outside @ (outside.T @ values), abs=1e-9)


def test_columns_that_are_nothing_and_no_columns_at_all() -> None:
    assert orthonormal(np.zeros((5, 2))).shape == (5, 0)
    assert orthonormal(np.zeros((5, 0))).shape == (5, 0)
    values = np.arange(5.0)
    assert projected(np.zeros((5, 0))).rest(values) == pytest.approx(values)


def test_extended_by_what_is_new_alone() -> None:
    columns = dependent()
    source = np.random.default_rng(2)
    projection = projected(columns)
    new = source.normal(size=(50, 2))
    old = columns[:, :2]
    found = projection.extended(np.hstack([new, old, new @ np.ones((2, 1))]))
    both = projected(np.hstack([columns, new]))
    assert projection.extended(old) is projection
    assert found.rank == both.rank == 8
    values = source.normal(size=50)
    assert found.rest(values) == pytest.approx(both.rest(values), abs=1e-9)


def test_rank_of_a_whole_base_is_that_of_scipy() -> None:
    whole = field()
    white = whole.whitening(whole.columns)
    size = np.linalg.norm(white, axis=0)
    kept = white[:, size > 0.0] / size[size > 0.0]
    assert kept.shape[1] > whole.base.rank  # some combinations cannot be told apart
    assert whole.base.rank == orth(kept, rcond=1e-9).shape[1]
    assert whole.base.rank < whole.readings.rows.size
    assert np.abs(whole.base.rest(kept)).max() < 1e-7


def test_offsets_of_runs_slopes_of_components_and_centres_are_in_the_base() -> None:
    """What a zero, a scale of an axis, or a ball that is elsewhere puts into the readings leaves nothing."""
    whole = field(SMALL, WHITE)
    rows, theta = whole.readings.rows, whole.readings.reading.theta
    offsets = np.zeros(rows.size)
    centres = np.zeros(rows.size)
    for index in rows.present:
        mine = rows.of_run(index)
        if rows.runs[index].instrument == "laser":
            offsets[mine] = 1e-3 * index
        elif rows.runs[index].id.startswith("XY"):
            centres[mine] = 5e-3 * np.cos(theta[mine] - 0.3)
    scale = whole.readings.sensitivity[whole.readings.model.components.index("EXX")] * rows.positions[0] * 1e-5
    for planted in (offsets, centres, scale):
        left = whole.base.rest(whole.whitening(planted))
        assert np.linalg.norm(left) < 1e-6 * np.linalg.norm(planted / whole.whitening.sigma)


class TestSoft:
    """Columns that may be there in part, as chance of known standard deviation."""

    def parts(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        source = np.random.default_rng(3)
        chance = source.normal(size=(50, 4)) * np.array([0.3, 1.0, 5.0, 200.0])
        return dependent(), chance, source.normal(size=(50, 3))

    def test_squares_are_those_of_generalised_least_squares(self) -> None:
        """The covariance 1 + C C' written out, the base free."""
        base, chance, values = self.parts()
        found = projected(base).softened(chance)
        inverse = np.linalg.inv(np.eye(50) + chance @ chance.T)
        free = orth(base / np.linalg.norm(base, axis=0), rcond=1e-9)
        left = inverse - inverse @ free @ np.linalg.solve(free.T @ inverse @ free, free.T @ inverse)
        rest = found.rest(values)
        assert rest.T @ rest == pytest.approx(values.T @ left @ values, rel=1e-6)

    def test_the_rest_of_such_readings_is_white(self) -> None:
        base, chance, _ = self.parts()
        found = projected(base).softened(chance)
        through = found.rest(np.eye(50))
        covariance = through @ (np.eye(50) + chance @ chance.T) @ through.T
        spread = np.linalg.eigvalsh(covariance)
        assert spread == pytest.approx([0.0] * 6 + [1.0] * 44, abs=1e-6)

    def test_products_are_told_without_the_rest(self) -> None:
        base, chance, values = self.parts()
        cause = np.random.default_rng(4).normal(size=(50, 2))
        for found in (
            projected(base),
            projected(base).softened(chance),
            projected(base).softened(chance).extended(cause),
        ):
            rest = found.rest(values)
            held = found.inner(values, np.arange(50))
            assert rest.T @ rest == pytest.approx(values.T @ values - held.T @ held, rel=1e-9)
            assert values.T @ found.rest_transposed(rest[:, 0]) == pytest.approx(rest.T @ rest[:, 0], rel=1e-9)

    def test_a_cause_leaves_nothing_of_itself_and_counts_as_free(self) -> None:
        base, chance, _ = self.parts()
        cause = np.random.default_rng(4).normal(size=(50, 2))
        soft = projected(base).softened(chance)
        found = soft.extended(cause)
        assert found.rest(cause) == pytest.approx(0.0, abs=1e-9)
        assert (soft.rank, found.rank) == (6, 8)

    def test_next_to_no_chance_changes_nothing(self) -> None:
        base, chance, values = self.parts()
        hard = projected(base)
        assert hard.softened(1e-7 * chance).rest(values) == pytest.approx(hard.rest(values), abs=1e-12)


def test_what_divide_and_conquer_gives_up_on_is_decomposed_otherwise(monkeypatch: pytest.MonkeyPatch) -> None:
    def gives_up(matrix: np.ndarray, full_matrices: bool) -> None:
        raise np.linalg.LinAlgError("SVD did not converge")

    columns = np.random.default_rng(3).standard_normal((30, 4)) @ np.diag([1.0, 1e-3, 1.0, 0.0])
    expected = orthonormal(columns)
    monkeypatch.setattr(np.linalg, "svd", gives_up)
    found = orthonormal(columns)
    assert found @ found.T == pytest.approx(expected @ expected.T, abs=1e-12)


def test_what_columns_explain_is_what_an_orthonormal_basis_of_them_does() -> None:
    source = np.random.default_rng(4)
    runs = by_run((part, np.eye(9)) for part in np.split(dependent(), (3, 11, 20, 45)))
    projection = Projection(spanned(runs)).softened(source.normal(size=(50, 2)))
    projection = projection.extended(source.normal(size=(50, 1)))
    held = projection.basis.dense()[:, :1]
    columns = source.normal(size=(50, 4))
    columns = np.hstack([columns, columns[:, :1] + columns[:, 1:2], held])  # one twice, one that the base has
    residual = projection.rest(source.normal(size=50))
    every = np.arange(50)
    sized = columns * np.logspace(-3, 3, 6)
    weights, count = projection.explaining(every, sized, residual)
    basis = orth(projection.rest(columns[:, :4]))
    assert count == basis.shape[1] == 4
    assert projection.rest(sized @ weights) == pytest.approx(basis @ (basis.T @ residual), abs=1e-9)
    nothing, none = projection.explaining(every, held, residual)
    assert none == 0
    assert nothing == pytest.approx(np.zeros(1), abs=1e-12)
    some = np.r_[3:11, 20:45]
    of_some, _ = projection.explaining(some, columns[some], residual)
    of_all, _ = projection.explaining(every, columns * np.isin(every, some)[:, np.newaxis], residual)
    assert columns[some] @ of_some == pytest.approx(columns[some] @ of_all, abs=1e-9)
