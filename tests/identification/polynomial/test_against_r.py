"""fit_optimal beside R's lm, summary.lm, extractAIC and step, on the numbers of tests/data/eq52/readings.csv."""

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import polars
import pytest

from trueaxis.identification.polynomial import OptimalFit, PolynomialFit, fit_optimal, fit_terms
from trueaxis.identification.polynomial.optimal import step_by_aic
from trueaxis.identification.polynomial.records import checked_samples
from trueaxis.identification.polynomial.regression import reduced_system

DATA = Path(__file__).parents[2] / "data" / "eq52"
STORED: dict[str, Any] = json.loads((DATA / "r_reference.json").read_text())
READINGS = polars.read_csv(DATA / "readings.csv")
CASES = {
    "drawn": ("drawn_urad", False),
    "drawn_order_6": ("drawn_urad", False),
    "drawn_scaled": ("drawn_urad", False),
    "drawn_weighted": ("drawn_urad", True),
    "implied": ("implied_urad", False),
    "walk": ("walk_urad", False),
}
SCALARS = (
    "r_squared", "adjusted_r_squared", "residual_standard_error", "residual_df", "rss", "aic",
    "f_statistic", "f_p_value",
)  # fmt: skip
PER_TERM = ("coefficients", "u", "t_values", "p_values")


def arrays(case: str) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any], np.ndarray[Any, Any] | None]:
    column, weighted = CASES[case]
    weights = READINGS["u_urad"].to_numpy() ** -2.0 if weighted else None
    return READINGS["position_mm"].to_numpy(), READINGS[column].to_numpy(), weights


def fitted(case: str) -> OptimalFit:
    x, y, weights = arrays(case)
    return fit_optimal(x, y, weights=weights, order=STORED[case]["order"])


def assert_same(ours: PolynomialFit, r: dict[str, Any], scale: float) -> None:
    order = np.argsort(r["powers"])
    assert ours.powers == tuple(sorted(r["powers"]))
    per_power = scale ** np.array(ours.powers, dtype=np.float64)
    for name in PER_TERM:
        theirs = np.array(r[name])[order] / (per_power if name in ("coefficients", "u") else 1.0)
        assert getattr(ours, name) == pytest.approx(theirs, rel=1e-9), name
    for name in SCALARS:
        assert getattr(ours, name) == pytest.approx(r[name], rel=1e-9), name


@pytest.mark.parametrize("case", CASES)
def test_statistics_of_all_powers_are_those_of_lm(case: str) -> None:
    r = STORED[case]
    assert r["before"]["rank"] == r["order"], "R dropped a power: its figures would not be of this model"
    assert_same(fitted(case).before, r["before"], r["scale"])
    assert fitted(case).mean_squares == pytest.approx(r["mean_squares"], rel=1e-9)


@pytest.mark.parametrize("case", CASES)
def test_steps_terms_and_statistics_after_the_aic_search_are_those_of_step(case: str) -> None:
    r = STORED[case]
    samples = checked_samples(*arrays(case))
    scope = tuple(range(1, r["order"] + 1))
    powers, steps = step_by_aic(reduced_system(samples, r["order"]), scope, scope)
    assert [step.change for step in steps] == r["changes"]
    assert [step.aic for step in steps] == pytest.approx(r["step_aic"][1:], rel=1e-9)
    assert_same(fit_terms(samples, powers), r["after"], r["scale"])


@pytest.mark.parametrize("case", ["drawn", "drawn_order_6", "drawn_weighted"])
def test_where_step_leaves_significant_terms_only_its_polynomial_is_the_optimal_one(case: str) -> None:
    r = STORED[case]["after"]
    fit = fitted(case)
    assert max(r["p_values"]) < 0.05
    assert fit.passed
    assert_same(fit.after, r, STORED[case]["scale"])


def test_the_gain_on_eq52_with_noise_is_the_gain_that_r_finds() -> None:
    fit, r = fitted("drawn"), STORED["drawn"]
    gain = fit.after.residual_standard_error / fit.before.residual_standard_error
    assert gain == pytest.approx(
        r["after"]["residual_standard_error"] / r["before"]["residual_standard_error"], rel=1e-10
    )
    assert gain < 1
    assert fit.after.adjusted_r_squared > fit.before.adjusted_r_squared


def test_where_step_leaves_an_insignificant_term_the_search_goes_on() -> None:
    r = STORED["implied"]["after"]
    assert max(r["p_values"]) > 0.05
    fit = fitted("implied")
    assert fit.after.powers == (1, 2, 3, 4, 5)
    assert fit.passed
    assert fit.steps[-1].reason == "t test"


def test_one_case_takes_a_term_in_again_where_r_s_backward_default_does_not() -> None:
    assert "+1" in STORED["walk"]["changes"]
    assert sorted(STORED["walk"]["default_powers"]) != sorted(STORED["walk"]["after"]["powers"])


@pytest.mark.skipif(shutil.which("Rscript") is None, reason="R is not installed; the stored figures of R are compared")
def test_r_gives_the_stored_figures_again() -> None:
    run = subprocess.run(
        ["Rscript", "--vanilla", str(DATA / "reference.R"), str(DATA / "readings.csv")],
        capture_output=True,
        text=True,
        check=True,
    )
    again = json.loads(run.stdout)
    assert again.keys() == STORED.keys()
    for case in CASES:
        assert_close(again[case], STORED[case])


def assert_close(again: Any, stored: Any) -> None:
    if isinstance(stored, dict):
        assert again.keys() == stored.keys()
        for key, value in stored.items():
            assert_close(again[key], value)
    elif isinstance(stored, list):
        assert len(again) == len(stored)
        for one, other in zip(again, stored, strict=True):
            assert_close(one, other)
    elif isinstance(stored, float):
        assert again == pytest.approx(stored, rel=1e-9)
    else:
        assert again == stored
