"""Legendre curves: values against NumPy's series, harmonics of a turn, home, ends, other forms, the file."""

import json

import numpy as np
import pytest
from numpy.polynomial import Legendre

from trueaxis.io.faults import Faults
from trueaxis.model.bases import travel_basis
from trueaxis.model.curve_json import curve_object, read_curve
from trueaxis.model.curves import LegendreCurve, evaluate_components, polynomial_of

TRAVELS = [(-300.0, 500.0), (0.0, 700.0), (-900.0, -150.0), (20.0, 40.0)]
COEFFICIENTS = (3e-3, -1e-3, 5e-4, 0.0, 2e-4)
WAVES = (1e-3, -2e-3, 5e-4, 3e-4)  # of cos and sin of the angle, of cos and sin of twice the angle


@pytest.fixture(params=TRAVELS, ids=str)
def curve(request: pytest.FixtureRequest) -> LegendreCurve:
    return LegendreCurve(basis=travel_basis(request.param, len(COEFFICIENTS)), coefficients=COEFFICIENTS)


@pytest.fixture(params=[(-360.0, 360.0), (0.0, 360.0), (30.0, 700.0)], ids=str)
def turning(request: pytest.FixtureRequest) -> LegendreCurve:
    """With two harmonics."""
    return LegendreCurve(basis=travel_basis(request.param, 5, 2), coefficients=(*COEFFICIENTS, *WAVES))


def home_of(curve: LegendreCurve) -> float:
    return min(max(0.0, curve.basis.low), curve.basis.high)


def test_it_is_the_series_of_numpy_less_its_value_at_home(curve: LegendreCurve) -> None:
    series = Legendre([0.0, *COEFFICIENTS], domain=[curve.basis.low, curve.basis.high])
    at = np.linspace(curve.basis.low, curve.basis.high, 101)
    np.testing.assert_allclose(curve(at), series(at) - series(home_of(curve)), atol=1e-16)
    assert curve(np.array([home_of(curve)]))[0] == 0.0


def test_beyond_the_travel_the_ends_hold(curve: LegendreCurve) -> None:
    low, high = curve.basis.low, curve.basis.high
    assert curve(np.array([low - 50.0, high + 50.0])).tolist() == curve(np.array([low, high])).tolist()


def test_it_is_a_polynomial_within_the_travel(curve: LegendreCurve) -> None:
    at = np.linspace(curve.basis.low, curve.basis.high, 101)
    np.testing.assert_allclose(polynomial_of(curve)(at), curve(at), atol=1e-14)


def test_components_of_an_axis_are_evaluated_together(curve: LegendreCurve) -> None:
    other = LegendreCurve(basis=curve.basis, coefficients=tuple(2.0 * c for c in COEFFICIENTS))
    positions = np.linspace(curve.basis.low - 1.0, curve.basis.high + 1.0, 7)[np.newaxis]
    found = evaluate_components({"EXX": curve, "EYX": other}, ("EXX", "EYX", "EZX"), (0, 0, 0), positions)
    np.testing.assert_allclose(found, [curve(positions[0]), 2.0 * curve(positions[0]), 0.0 * positions[0]], atol=1e-16)


def test_the_file_gives_it_back(curve: LegendreCurve) -> None:
    whole = LegendreCurve(
        basis=curve.basis,
        coefficients=COEFFICIENTS,
        u=(1e-4, float("nan"), 0.0, 1e-5, 1e-6),
        measured=(curve.basis.low, 30.0),
    )
    tree = json.loads(json.dumps(curve_object(whole)))
    assert set(tree) == {"basis", "range", "coefficients", "u", "measured"}
    faults = Faults("e.json")
    again = read_curve(tree, ("motion_errors", "EXX"), faults)
    assert isinstance(again, LegendreCurve)
    assert again.basis == curve.basis
    assert curve_object(again) == curve_object(whole)


def test_harmonics_add_what_repeats_with_the_turn(turning: LegendreCurve) -> None:
    plain = LegendreCurve(basis=turning.basis.polynomials, coefficients=COEFFICIENTS)
    at = np.linspace(turning.basis.low, turning.basis.high, 101)

    def waves(degrees: np.ndarray) -> np.ndarray:
        a = np.pi / 180.0 * degrees
        return WAVES[0] * np.cos(a) + WAVES[1] * np.sin(a) + WAVES[2] * np.cos(2 * a) + WAVES[3] * np.sin(2 * a)

    expected = plain(at) + waves(at) - waves(np.array(home_of(turning)))
    np.testing.assert_allclose(turning(at), expected, atol=1e-16)
    assert turning(np.array([home_of(turning)]))[0] == 0.0
    beyond = np.array([turning.basis.low - 50.0, turning.basis.high + 50.0])
    np.testing.assert_allclose(
        turning(beyond) - plain(beyond), waves(beyond) - waves(np.array(home_of(turning))), atol=1e-16
    )


def test_curves_with_and_without_harmonics_are_evaluated_together(turning: LegendreCurve) -> None:
    plain = LegendreCurve(basis=travel_basis((-360.0, 360.0), 5), coefficients=COEFFICIENTS)
    positions = np.linspace(-400.0, 800.0, 7)[np.newaxis]
    found = evaluate_components({"EXC": turning, "EYC": plain}, ("EXC", "EYC"), (0, 0), positions)
    np.testing.assert_allclose(found, [turning(positions[0]), plain(positions[0])], atol=1e-16)


def test_the_file_gives_harmonics_back(turning: LegendreCurve) -> None:
    tree = json.loads(json.dumps(curve_object(turning)))
    assert tree == {
        "basis": "turn",
        "range": [turning.basis.low, turning.basis.high],
        "harmonics": 2,
        "coefficients": [*COEFFICIENTS, *WAVES],
    }
    assert read_curve(tree, ("motion_errors", "EXC"), Faults("e.json")) == turning


@pytest.mark.parametrize(
    ("harmonics", "told"),
    [(0, "0.0 is no number of"), (1.5, "1.5 is no number of"), ("two", "is not a number"), (2, "are 3, cosine and")],
)
def test_harmonics_that_are_none_are_named(harmonics: object, told: str) -> None:
    tree = {"basis": "turn", "range": [0.0, 360.0], "harmonics": harmonics, "coefficients": [1e-3] * 3}
    faults = Faults("e.json")
    assert read_curve(tree, ("motion_errors", "EXC"), faults) is None
    assert any(told in str(fault) for fault in faults.found), faults.found


@pytest.mark.parametrize(
    ("key", "value", "told"),
    [
        ("range", [1.0], "is no range"),
        ("range", [5.0, 5.0], "is no range"),
        ("range", "all", "is not a list"),
        ("coefficients", [0.0] * 100, "are 100"),
        ("u", [1.0], "has 1 entries"),
        ("knots", [1.0], "is not a key"),
    ],
)
def test_what_is_wrong_is_named(key: str, value: object, told: str) -> None:
    tree = {"basis": "legendre", "range": [0.0, 10.0], "coefficients": [1e-3, 2e-3], key: value}
    faults = Faults("e.json")
    assert read_curve(tree, ("motion_errors", "EXX"), faults) is None
    assert any(told in str(fault) for fault in faults.found), faults.found
