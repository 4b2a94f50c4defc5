"""The statistics that the paper prints in Sect. 4.4 and Fig. 15, held against one another and against its equations.

The paper's discrete data are not published. Yet the printed coefficients and p values determine them as far as any
polynomial of powers 1 to 7 is concerned: see docs/errata/statistics.md for what follows.
"""

import json
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import stats

from trueaxis.identification.polynomial import fit_optimal

FloatArray = NDArray[np.float64]

EQ50 = {
    1: 1.16302e-1, 2: -1.43581e-3, 3: 8.16363e-6, 4: -2.21082e-8, 5: 2.76963e-11, 6: -1.15323e-14, 7: -2.13978e-18,
}  # fmt: skip
EQ50_T = (3.91759e-5, 0.034867, 0.240908, 0.533366, 0.770712, 0.928049, 0.974858)
EQ50_F = 3.5341e-21
EQ51 = {1: 8.22104e-2, 2: -6.40509e-4, 3: 1.87087e-6, 5: -7.44546e-12, 6: 7.93764e-15}
EQ51_T = (7.59006e-10, 1.45651e-6, 1.15052e-5, 8.80975e-5, 1.76691e-4)
EQ51_F = 1.19152e-22
FIG15_RSE = (0.2836, 0.2717)
FIG15_ADJUSTED_R2 = (0.9449, 0.9474)
ALL = tuple(range(1, 8))
TRAVEL = 540.0


def positions(n: int, home: bool) -> FloatArray:
    return np.linspace(0.0, TRAVEL, n) if home else np.linspace(0.0, TRAVEL, n + 1)[1:]


def value(polynomial: dict[int, float], x: FloatArray) -> FloatArray:
    return np.asarray(sum(a * x**k for k, a in polynomial.items()))


def columns(powers: tuple[int, ...], x: FloatArray) -> FloatArray:
    return np.stack([(x / TRAVEL) ** k for k in powers], axis=1)


def standard_errors_from_t(polynomial: dict[int, float], p_values: tuple[float, ...], x: FloatArray) -> FloatArray:
    """Residual standard error that each printed p value implies for fits to points at x; they must be one number."""
    powers = tuple(polynomial)
    triangle = np.linalg.qr(columns(powers, x), mode="r")
    spread = np.linalg.norm(np.linalg.inv(triangle), axis=1)
    scaled = np.abs([a * TRAVEL**k for k, a in polynomial.items()])
    t = stats.t.isf(np.array(p_values) / 2, x.size - len(powers))
    return np.asarray(scaled / spread / t)


POINTS = positions(28, home=True)
S_BEFORE = float(standard_errors_from_t(EQ50, EQ50_T, POINTS).mean())
S_AFTER = float(standard_errors_from_t(EQ51, EQ51_T, POINTS).mean())


def implied_rss(powers: tuple[int, ...]) -> float:
    """Residual sum of squares of any sub-model on the paper's own data: that of Eq. (50) plus what is missed of it."""
    full = value(EQ50, POINTS)
    if powers:
        basis, _ = np.linalg.qr(columns(powers, POINTS))
        full = full - basis @ (basis.T @ full)
    return 21 * S_BEFORE**2 + float(full @ full)


def implied_aic(powers: tuple[int, ...]) -> float:
    return 28 * float(np.log(implied_rss(powers) / 28)) + 2 * len(powers)


@pytest.mark.parametrize(("polynomial", "p_values"), [(EQ50, EQ50_T), (EQ51, EQ51_T)], ids=["Eq50", "Eq51"])
def test_the_t_tests_are_those_of_28_points_every_20_mm_and_of_no_other_number(
    polynomial: dict[int, float], p_values: tuple[float, ...]
) -> None:
    spread = {}
    for n in range(len(polynomial) + 1, 121):
        for home in (True, False):
            s = standard_errors_from_t(polynomial, p_values, positions(n, home))
            spread[n, home] = float(s.max() / s.min() - 1)
    consistent = spread.pop((28, True))
    assert consistent < 3e-5
    assert min(spread.values()) > 1e-3


def test_the_residual_standard_error_behind_the_t_tests_rises() -> None:
    assert pytest.approx(0.43853, abs=2e-5) == S_BEFORE
    assert pytest.approx(0.48562, abs=2e-5) == S_AFTER


def test_eq51_is_the_least_squares_fit_to_the_values_of_eq50() -> None:
    powers = tuple(EQ51)
    scaled = np.linalg.lstsq(columns(powers, POINTS), value(EQ50, POINTS), rcond=None)[0]
    refitted = scaled / TRAVEL ** np.array(powers)
    assert refitted == pytest.approx(list(EQ51.values()), rel=8e-5)


def test_the_sums_of_squares_behind_the_t_tests_differ_by_the_distance_of_the_two_polynomials() -> None:
    distance = value(EQ50, POINTS) - value(EQ51, POINTS)
    lost = 23 * S_AFTER**2 - 21 * S_BEFORE**2
    assert lost == pytest.approx(distance @ distance, rel=2e-4)


@pytest.mark.parametrize(
    ("polynomial", "s", "printed"), [(EQ50, S_BEFORE, EQ50_F), (EQ51, S_AFTER, EQ51_F)], ids=["Eq50", "Eq51"]
)
def test_the_p_value_of_the_equation_has_one_degree_of_freedom_too_few(
    polynomial: dict[int, float], s: float, printed: float
) -> None:
    terms = len(polynomial)
    f = float(np.sum(value(polynomial, POINTS) ** 2)) / terms / s**2
    assert stats.f.sf(f, terms, 28 - terms - 1) == pytest.approx(printed, rel=2e-3)
    assert stats.f.sf(f, terms, 28 - terms) < 0.16 * printed


def interval(printed: float, unit: float = 1e-4) -> FloatArray:
    return printed + np.array([-0.5, 0.5]) * unit


def test_adjusted_r2_and_residual_standard_error_of_fig15_contradict_one_another() -> None:
    # For one data set 1 - adjusted R^2 = s^2 / c with c = sum(y^2)/n (no constant) or sum((y - mean)^2)/(n - 1).
    before, after = (1 - interval(r2)[::-1] for r2 in FIG15_ADJUSTED_R2)
    from_r2 = before / after[::-1]
    from_s = (interval(FIG15_RSE[0]) / interval(FIG15_RSE[1])[::-1]) ** 2
    assert from_s.min() > from_r2.max() + 0.035
    digits_swapped = (interval(FIG15_RSE[0]) / interval(0.2771)[::-1]) ** 2
    assert from_r2.min() < digits_swapped.min() < digits_swapped.max() < from_r2.max()


def test_fig15_is_of_other_data_than_eqs_50_and_51() -> None:
    full = value(EQ50, POINTS)
    basis, _ = np.linalg.qr(columns(ALL, POINTS))
    ones = basis @ (basis.T @ np.ones(28))
    uncentred = full @ full / 28
    centred = (full @ full - (full @ ones) ** 2 / (ones @ ones)) / 27  # below the variance of any data with this fit
    for s, r2 in zip((FIG15_RSE[0], 0.2771), FIG15_ADJUSTED_R2, strict=True):
        total = s**2 / (1 - r2)
        assert total == pytest.approx(1.4597, abs=0.003)
        assert uncentred > 17 * total
        assert centred > 1.25 * total
    # Nor can two sums of squares this close belong to polynomials this far apart.
    for after in (FIG15_RSE[1], 0.2771):
        assert 23 * after**2 - 21 * FIG15_RSE[0] ** 2 < 0.08
    assert np.sum((full - value(EQ51, POINTS)) ** 2) == pytest.approx(1.3855, abs=1e-3)


def test_fewer_terms_lie_farther_from_the_points_whatever_the_terms() -> None:
    subsets = [subset for size in range(8) for subset in combinations(ALL, size)]
    rss = {subset: implied_rss(subset) for subset in subsets}
    for subset in subsets[1:]:
        for out in subset:
            assert rss[tuple(k for k in subset if k != out)] >= rss[subset]
    assert rss[tuple(EQ51)] == pytest.approx(1.343 * rss[ALL], rel=1e-3)


def test_eqs_49_and_52_agree_in_the_mean_to_the_residual_error_but_not_everywhere() -> None:
    x = np.linspace(0.0, TRAVEL, 541)
    distance = np.abs(value(EQ50, x) - value(EQ51, x))
    assert np.sqrt(np.mean(distance**2)) == pytest.approx(0.220, abs=1e-3)
    assert distance.max() == pytest.approx(0.4607, abs=1e-4)
    assert x[distance.argmax()] == 32.0
    assert np.mean(distance > FIG15_RSE[1]) == pytest.approx(0.196, abs=0.002)


def test_aic_prefers_eq50_to_eq51_and_r_would_have_stopped_at_six_terms() -> None:
    assert implied_aic(ALL) == pytest.approx(-40.22, abs=0.01)
    assert implied_aic(tuple(EQ51)) == pytest.approx(-35.96, abs=0.01)
    extra = (implied_rss(tuple(EQ51)) - implied_rss(ALL)) / 2 / S_BEFORE**2
    assert stats.f.sf(extra, 2, 21) == pytest.approx(0.0452, abs=5e-5)
    first = {out: implied_aic(tuple(k for k in ALL if k != out)) for out in ALL}
    assert min(first, key=lambda out: first[out]) == 7
    six = tuple(range(1, 7))
    assert first[7] < implied_aic(ALL)
    assert all(implied_aic(tuple(k for k in six if k != out)) > first[7] for out in six)


def test_the_mean_square_error_points_to_order_six_not_seven() -> None:
    mean_squares = [implied_rss(tuple(range(1, p + 1))) / (28 - p) for p in range(1, 8)]
    assert int(np.argmin(mean_squares)) + 1 == 6
    assert np.sqrt(mean_squares[5]) == pytest.approx(0.42846, abs=2e-5)
    assert stats.t.isf(EQ50_T[-1] / 2, 21) < 1  # a last term with |t| < 1 always raises the mean square


def test_the_paper_s_own_procedure_on_its_own_data_gives_a_better_polynomial_of_five_terms() -> None:
    random = np.random.default_rng(0).normal(size=27)
    basis, _ = np.linalg.qr(columns(ALL, POINTS)[1:])
    for _ in range(2):
        random -= basis @ (basis.T @ random)
    residuals = np.append(0.0, random * np.sqrt(21) * S_BEFORE / np.linalg.norm(random))
    fit = fit_optimal(POINTS, value(EQ50, POINTS) + residuals, order=7)
    assert fit.before.p_values == pytest.approx(EQ50_T, rel=2e-4)
    assert [(step.reason, step.change) for step in fit.steps[1:]] == [
        ("AIC", "-7"),
        ("t test", "-6"),
        ("AIC", "+7"),
        ("t test", "-7"),
    ]
    assert fit.after.powers == (1, 2, 3, 4, 5)
    assert fit.after.residual_standard_error == pytest.approx(0.44848, abs=2e-5)
    assert fit.after.residual_standard_error < S_AFTER
    best = min(combinations(ALL, 5), key=implied_rss)
    assert best == fit.after.powers


def test_r_finds_the_printed_p_values_of_the_terms_on_the_implied_data() -> None:
    stored = json.loads((Path(__file__).parents[2] / "data" / "eq52" / "r_reference.json").read_text())["implied"]
    assert stored["before"]["p_values"] == pytest.approx(EQ50_T, rel=2e-4)
    assert stored["after"]["powers"] == [1, 2, 3, 4, 5, 6]
    assert stored["before"]["f_p_value"] == pytest.approx(4.84e-22, rel=2e-3)


def test_28_points_tell_the_curve_but_not_its_powers() -> None:
    truth = value(EQ51, POINTS)
    for order, share in ((7, 1 / 9), (None, 1 / 4)):
        drawn = [truth + np.random.default_rng(seed).normal(0.0, 0.2717, 28) for seed in range(300)]
        fits = [fit_optimal(POINTS, y, order=order).after for y in drawn]
        assert np.mean([fit.powers == tuple(EQ51) for fit in fits]) == pytest.approx(share, abs=0.05)
        off = [np.sqrt(np.mean((fit.at(POINTS) - truth) ** 2)) for fit in fits]
        assert np.median(off) < 0.2717 / 2
        assert np.quantile(off, 0.99) < 0.2717


@pytest.mark.parametrize(
    ("before", "after", "printed"), [(0.00119, 0.000244, 79.5), (0.000249, 0.000119, 52.2), (42.1, 25.1, 40.4)]
)
def test_the_printed_gains_of_sect_5_follow(before: float, after: float, printed: float) -> None:
    assert 100 * (1 - after / before) == pytest.approx(printed, abs=0.05)
