"""Error curves against exact rational arithmetic and hand-worked values."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trueaxis.model.curves import PolynomialCurve, TableCurve, evaluate_components, pack_polynomials

POWERS = st.lists(st.integers(0, 12), min_size=1, max_size=8, unique=True)


@given(powers=POWERS, data=st.data())
@settings(deadline=None)
def test_a_polynomial_is_as_good_as_rational_arithmetic_allows(powers: list[int], data: st.DataObject) -> None:
    scaled = st.floats(-1.0, 1.0).filter(lambda v: v == 0.0 or abs(v) > 1e-6)
    coefficients = tuple(data.draw(scaled) / 700.0**power for power in powers)
    s = data.draw(st.floats(-700.0, 700.0).filter(lambda v: v == 0.0 or abs(v) > 1e-3))
    found = float(PolynomialCurve(powers=tuple(powers), coefficients=coefficients)(np.array([s]))[0])
    terms = [Fraction(c) * Fraction(s) ** p for c, p in zip(coefficients, powers, strict=True)]
    error = abs(Fraction(found) - sum(terms))
    # the bound of Horner's scheme: 2 n eps sum |c s^p|
    assert error <= 2 * 14 * Fraction(np.finfo(float).eps) * sum(map(abs, terms)) + Fraction(1e-300)


def test_powers_come_in_any_order_and_with_gaps() -> None:
    curve = PolynomialCurve(powers=(6, 1, 3), coefficients=(3.0, 1.0, 2.0))
    assert curve(np.array([0.0, 1.0, 2.0, -1.0])).tolist() == [0.0, 6.0, 2.0 + 16.0 + 192.0, 0.0]


def test_a_constant_and_an_empty_polynomial() -> None:
    assert PolynomialCurve(powers=(0,), coefficients=(4.0,))(np.array([0.0, 9.0])).tolist() == [4.0, 4.0]
    assert PolynomialCurve(powers=(), coefficients=())(np.array([3.0])).tolist() == [0.0]


def test_eq_52_at_the_end_of_the_travel() -> None:
    curve = PolynomialCurve(
        powers=(1, 2, 3, 5, 6), coefficients=(8.22104e-2, -6.40509e-4, 1.87087e-6, -7.44546e-12, 7.93764e-15)
    )
    s = Fraction(540)
    exact = sum(Fraction(c) * s**p for c, p in zip(curve.coefficients, curve.powers, strict=True))
    assert float(curve(np.array([540.0]))[0]) == pytest.approx(float(exact), rel=1e-14)


def test_a_table_is_straight_between_and_held_beyond_its_ends() -> None:
    curve = TableCurve((10.0, 20.0, 40.0), (1.0, 3.0, -1.0))
    assert curve(np.array([0.0, 10.0, 15.0, 30.0, 40.0, 99.0])).tolist() == [1.0, 1.0, 2.0, 1.0, -1.0, -1.0]


def test_components_take_their_own_axis_and_are_zero_without_a_curve() -> None:
    curves = {
        "EXX": PolynomialCurve(powers=(1,), coefficients=(2.0,)),
        "EXY": PolynomialCurve(powers=(1,), coefficients=(3.0,)),
    }
    positions = np.array([[1.0, 2.0], [10.0, 20.0]])
    found = evaluate_components(curves, ("EXX", "EYX", "EXY"), (0, 0, 1), positions)
    assert found.tolist() == [[2.0, 4.0], [0.0, 0.0], [30.0, 60.0]]


@given(data=st.data())
def test_curves_of_one_axis_at_once_are_each_its_own_to_the_last_digit(data: st.DataObject) -> None:
    size = st.floats(-1.0, 1.0, allow_subnormal=False)
    curves = {}
    for name in ("EXX", "EYX", "EZX"):
        powers = data.draw(POWERS)
        curves[name] = PolynomialCurve(powers=tuple(powers), coefficients=tuple(data.draw(size) for _ in powers))
    positions = np.array([data.draw(st.lists(st.floats(-700.0, 700.0), min_size=1, max_size=4))])
    found = evaluate_components(curves, tuple(curves), (0, 0, 0), positions)
    assert np.array_equal(found, [curve(positions[0]) for curve in curves.values()])


def test_packing_puts_each_power_in_its_column() -> None:
    curves = {
        "EXX": PolynomialCurve(powers=(3, 1), coefficients=(7.0, 5.0)),
        "EYX": PolynomialCurve(powers=(0, 9), coefficients=(0.0, 0.0)),
    }
    packed = pack_polynomials(curves, ("EXX", "EYX", "EZX"), 3)
    assert packed is not None
    assert packed.tolist() == [[5.0, 0.0, 7.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]


@pytest.mark.parametrize(
    "curve",
    [
        PolynomialCurve(powers=(0, 1), coefficients=(1.0, 1.0)),
        PolynomialCurve(powers=(4,), coefficients=(1.0,)),
        TableCurve((0.0, 1.0), (0.0, 1.0)),
    ],
    ids=["constant", "power too high", "table"],
)
def test_what_a_fixed_form_cannot_hold_is_not_packed(curve: PolynomialCurve | TableCurve) -> None:
    assert pack_polynomials({"EXX": curve}, ("EXX",), 3) is None
