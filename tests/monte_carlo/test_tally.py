"""Mean, standard deviation and quantiles of draws, against NumPy on all of them at once and against closed forms."""

import numpy as np
import pytest
from scipy import stats

from trueaxis.monte_carlo.drawn import COVERAGE, Bins, Tally, drawn_of, tolerance

DISTRIBUTIONS = {
    "normal": stats.norm(3.0, 0.2),
    "even": stats.uniform(-1.0, 5.0),
    "skew": stats.expon(2.0, 0.7),
    "heavy": stats.t(3.0),
    "length": stats.chi(3, scale=0.4),
}


@pytest.mark.parametrize("name", DISTRIBUTIONS)
def test_its_figures_are_those_of_all_draws_together(name: str) -> None:
    draws = DISTRIBUTIONS[name].rvs((20_000, 1, 1), random_state=np.random.default_rng(1))
    bins = Bins.of_sample(draws[:300])
    whole = Tally(bins)
    for part in np.array_split(draws, 17):
        own = Tally(bins, np.uint16)
        for piece in np.array_split(part, 3):
            own.add(piece)
        whole.merge(own)
    assert whole.count == 20_000
    assert whole.mean[0, 0] == pytest.approx(draws.mean(), rel=1e-12)
    assert whole.deviation[0, 0] == pytest.approx(draws.std(ddof=1), rel=1e-12)
    for share in (0.025, 0.5, 0.975):
        assert whole.quantile(share)[0, 0] == pytest.approx(np.quantile(draws, share), abs=0.03 * draws.std())


def test_what_no_draw_moves_lies_in_its_interval() -> None:
    tally = Tally(Bins.of_sample(np.zeros((100, 4, 1))))
    tally.add(np.zeros((5000, 4, 1)))
    found = drawn_of(tally, np.zeros((3, 1)), np.zeros((3, 1)))
    assert (found.low == 0.0).all()
    assert (found.high == 0.0).all()
    assert not found.differing.any()


def test_quantiles_of_two_values_are_the_values() -> None:
    draws = np.random.default_rng(2).choice([-4e-3, 6e-3], (5000, 1, 1))
    tally = Tally(Bins.of_sample(draws[:100]))
    tally.add(draws)
    low, high = tally.quantile(0.025)[0, 0], tally.quantile(0.975)[0, 0]
    assert (low, high) == pytest.approx((-4e-3, 6e-3), abs=0.04 * draws.std())


def test_what_no_draw_moves_has_no_width() -> None:
    tally = Tally(Bins.of_sample(np.full((10, 4, 2), 0.25)))
    tally.add(np.full((1000, 4, 2), 0.25))
    np.testing.assert_allclose(tally.quantile(0.025), 0.25, atol=1e-11)
    assert not tally.deviation.any()


def test_a_quantile_beyond_the_range_is_not_known() -> None:
    bins = Bins(np.zeros((1, 1)), np.full((1, 1), 1.0))
    tally = Tally(bins)
    tally.add(np.linspace(-5.0, 0.5, 100)[:, np.newaxis, np.newaxis])
    assert np.isnan(tally.quantile(0.025)[0, 0])
    assert tally.quantile(0.975)[0, 0] == pytest.approx(0.4, abs=0.06)


def test_the_tolerance_is_half_of_the_last_digit_of_u() -> None:
    u = np.array([4.2e-3, 9.99e-3, 1.0e-2, 2.5e-4])
    np.testing.assert_allclose(tolerance(u), [5e-4, 5e-4, 5e-3, 5e-5])


def tally_of(draws: np.ndarray) -> Tally:
    values = np.concatenate([draws, np.linalg.norm(draws, axis=1)[:, np.newaxis]], axis=1)
    tally = Tally(Bins.of_sample(values[:500]))
    tally.add(values)
    return tally


def test_where_linear_propagation_says_something_else_is_told() -> None:
    source = np.random.default_rng(3)
    normal = 1e-3 * source.standard_normal((50_000, 3, 4))
    none = drawn_of(tally_of(normal), np.zeros((3, 4)), np.full((3, 4), 1e-3))
    assert not none.differing.any()
    assert not none.apart.any()
    two_sided = normal.copy()
    two_sided[:, 1, 2] += 2e-3 * source.choice([-1.0, 1.0], 50_000)  # play that u does not know
    some = drawn_of(tally_of(two_sided), np.zeros((3, 4)), np.full((3, 4), 1e-3))
    assert np.argwhere(some.differing).tolist() == [[1, 2]]
    exact = -stats.norm.ppf(0.05)  # half of the draws on either side: 2.5 % of all are 5 % of one
    assert some.high[1, 2] == pytest.approx(2e-3 + 1e-3 * exact, rel=0.01)
    assert some.apart[1, 2] == pytest.approx(2e-3 + 1e-3 * (exact - COVERAGE), rel=0.03)


def test_what_nothing_determines_has_no_draws() -> None:
    u = np.full((3, 4), 1e-3)
    u[0, 1] = np.nan
    found = drawn_of(tally_of(1e-3 * np.random.default_rng(4).standard_normal((2000, 3, 4))), np.zeros((3, 4)), u)
    for values in (found.mean, found.sd, found.low, found.high, found.apart):
        assert np.isnan(values[:, 1]).all()
        assert np.isfinite(values[:, [0, 2, 3]]).all()
