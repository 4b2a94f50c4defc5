"""Every number of docs/errata/statistics.md is printed in the paper or computed here, to its last digit."""

import re
from decimal import Decimal
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy import stats

from tests.identification.polynomial.test_printed_statistics import (
    ALL,
    EQ50,
    EQ50_F,
    EQ50_T,
    EQ51,
    EQ51_F,
    FIG15_ADJUSTED_R2,
    FIG15_RSE,
    POINTS,
    S_AFTER,
    S_BEFORE,
    TRAVEL,
    columns,
    implied_aic,
    implied_rss,
    interval,
    positions,
    standard_errors_from_t,
    value,
)

PAGE = (Path(__file__).parents[3] / "docs" / "errata" / "statistics.md").read_text(encoding="utf-8")
NUMBER = re.compile(r"(?<![\w.])\d+\.\d+(?:e-\d+)?(?![\w.]*\.md)")
SECTIONS = {"4.2", "4.3", "4.4"}
PRINTED = {
    *("0.00119", "0.000244", "79.5", "0.000249", "0.000119", "52.2", "42.1", "25.1", "40.4"),
    *map(str, (*FIG15_RSE, *FIG15_ADJUSTED_R2, EQ50_F, EQ51_F)),
}
LOOSE = {"1.8": 0.08, "0.08": 0.005}
"""Bounds ("above 1.8", "less than 0.08"): how far they are from what they bound."""


def f_of(polynomial: dict[int, float], s: float) -> float:
    return float(np.sum(value(polynomial, POINTS) ** 2)) / len(polynomial) / s**2


def p_without(powers: tuple[int, ...], out: int) -> float:
    """The p value of one term of a polynomial on the implied data."""
    rest = tuple(k for k in powers if k != out)
    degrees = 28 - len(powers)
    return float(stats.f.sf((implied_rss(rest) / implied_rss(powers) - 1) * degrees, 1, degrees))


def figures() -> dict[str, float]:
    """What each number of the page is."""
    six, five, left = ALL[:6], ALL[:5], tuple(EQ51)
    x = np.linspace(0.0, TRAVEL, 541)
    distance = np.abs(value(EQ50, x) - value(EQ51, x))
    full = value(EQ50, POINTS)
    basis, _ = np.linalg.qr(columns(ALL, POINTS))
    ones = basis @ (basis.T @ np.ones(28))
    two_terms = (implied_rss(left) - implied_rss(ALL)) / 2 / S_BEFORE**2
    r2 = [1 - interval(r)[::-1] for r in FIG15_ADJUSTED_R2]
    rse = [interval(s) for s in FIG15_RSE]
    return {
        "0.43853": S_BEFORE,
        "0.4385": S_BEFORE,
        "0.48562": S_AFTER,
        "0.4856": S_AFTER,
        "0.42846": np.sqrt(implied_rss(six) / 22),
        "0.44848": np.sqrt(implied_rss(five) / 23),
        "0.4485": np.sqrt(implied_rss(five) / 23),
        "4.0385": implied_rss(ALL),
        "5.4240": implied_rss(left),
        "4.0387": implied_rss(six),
        "4.6260": implied_rss(five),
        "40.22": -implied_aic(ALL),
        "35.96": -implied_aic(left),
        "42.22": -implied_aic(six),
        "40.41": -implied_aic(five),
        "1.3855": float(np.sum((full - value(EQ51, POINTS)) ** 2)),
        "1.0475": (1 - FIG15_ADJUSTED_R2[0]) / (1 - FIG15_ADJUSTED_R2[1]),
        "1.0456": r2[0].min() / r2[1].max(),
        "1.0495": r2[0].max() / r2[1].min(),
        "1.0895": (FIG15_RSE[0] / FIG15_RSE[1]) ** 2,
        "1.0887": (rse[0].min() / rse[1].max()) ** 2,
        "1.0903": (rse[0].max() / rse[1].min()) ** 2,
        "0.2771": FIG15_RSE[0] / np.sqrt((1 - FIG15_ADJUSTED_R2[0]) / (1 - FIG15_ADJUSTED_R2[1])),
        "1.46": FIG15_RSE[0] ** 2 / (1 - FIG15_ADJUSTED_R2[0]),
        "0.08": 23 * 0.2771**2 - 21 * FIG15_RSE[0] ** 2,
        "1.8": (full @ full - (full @ ones) ** 2 / (ones @ ones)) / 27,  # without any part that residuals may have
        "516.8": f_of(EQ50, S_BEFORE),
        "588.8": f_of(EQ51, S_AFTER),
        "4.84e-22": stats.f.sf(f_of(EQ50, S_BEFORE), 7, 21),
        "1.81e-23": stats.f.sf(f_of(EQ51, S_AFTER), 5, 23),
        "0.0452": stats.f.sf(two_terms, 2, 21),
        "0.087": p_without(six, 6),
        "0.03": stats.t.isf(EQ50_T[-1] / 2, 21),
        "0.220": np.sqrt(np.mean(distance**2)),
        "0.461": distance.max(),
    }


@cache
def statements() -> dict[str, bool]:
    """Figures of the page that are no decimal numbers: whether what they say is so."""
    left = tuple(EQ51)
    x = np.linspace(0.0, TRAVEL, 541)
    distance = np.abs(value(EQ50, x) - value(EQ51, x))
    spread = {
        key: float((s := standard_errors_from_t(EQ50, EQ50_T, positions(*key))).max() / s.min() - 1)
        for key in ((n, home) for n in range(len(EQ50) + 1, 121) for home in (True, False))
    }
    best = min(spread, key=lambda key: spread[key])
    others = min(size for key, size in spread.items() if key != best)
    (n, home) = best
    grown = implied_rss(left) / implied_rss(ALL) - 1
    refitted = np.linalg.lstsq(columns(left, POINTS), value(EQ50, POINTS), rcond=None)[0] / TRAVEL ** np.array(left)
    off = np.abs(refitted / np.array(list(EQ51.values())) - 1).max()
    degrees = [stats.f.sf(f_of(p, s), k, 27 - k) for p, s, k in ((EQ50, S_BEFORE, 7), (EQ51, S_AFTER, 5))]
    f_off = max(abs(p / printed - 1) for p, printed in zip(degrees, (EQ50_F, EQ51_F), strict=True))
    full = value(EQ50, POINTS)
    return {
        f"**{n} points, every {TRAVEL / (n - 1):.0f} mm, home included, no constant term**": home,
        f"to {np.ceil(spread[best] * 1e5):.0f} parts in 100 000": True,
        "apart by more than 1 in 1000": others > 1e-3,
        "coefficients to 1 part in 100 000": off < 1e-5,
        f"the sum of squares grows by {100 * grown:.0f} %": True,
        f"have a mean square above {np.floor(full @ full / 28):.0f}": True,
        f"(at x = {x[distance.argmax()]:.0f} mm)": True,
        "by more than 0.2717 µrad on a fifth of the travel": abs(float(np.mean(distance > FIG15_RSE[1])) - 0.2) < 0.01,
        f"with {7} and {28 - 7}, and 588.8 with {5} and {28 - 5} degrees of freedom": True,
        "the same F with 20 and 22": f_off < 2e-3,
        f"(printed values met to {np.ceil(f_off * 1e3):.0f} in 1000)": True,
        f"(all {2 ** len(ALL)} subsets)": True,
    }


@pytest.mark.parametrize("words", sorted(statements()))
def test_other_figures_are_those_computed(words: str) -> None:
    """Shares of simulated cases (one in nine, one in four): test_28_points_tell_the_curve_but_not_its_powers."""
    assert words in " ".join(PAGE.split())
    assert statements()[words]


def tokens() -> set[str]:
    return set(NUMBER.findall(PAGE)) - SECTIONS


def test_every_number_is_printed_or_computed() -> None:
    assert tokens() - PRINTED == figures().keys()


@pytest.mark.parametrize("token", sorted(tokens() - PRINTED))
def test_number_is_right_to_its_last_digit(token: str) -> None:
    last = float(Decimal(1).scaleb(int(Decimal(token).as_tuple().exponent)))
    assert figures()[token] == pytest.approx(float(token), abs=LOOSE.get(token, 0.501 * last))
