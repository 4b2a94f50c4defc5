"""Tails against mpmath's incomplete beta and gamma functions, beyond where probabilities underflow."""

import mpmath
import pytest

from trueaxis.estimation.tails import log_chi2_tail, log_f_tail


def exact_f(value: float, k: int, freedom: float) -> float:
    """Logarithm of I_z(freedom / 2, k / 2) at z = freedom / (freedom + k value)."""
    with mpmath.workdps(60):
        z = mpmath.mpf(freedom) / (mpmath.mpf(freedom) + k * mpmath.mpf(value))
        return float(mpmath.log(mpmath.betainc(mpmath.mpf(freedom) / 2, mpmath.mpf(k) / 2, 0, z, regularized=True)))


def exact_chi2(value: float, k: int) -> float:
    with mpmath.workdps(60):
        return float(mpmath.log(mpmath.gammainc(mpmath.mpf(k) / 2, mpmath.mpf(value) / 2, regularized=True)))


@pytest.mark.parametrize("freedom", [9.6, 150.0, 4000.0])
@pytest.mark.parametrize("k", [1, 2, 3])
@pytest.mark.parametrize("value", [0.5, 4.0, 60.0, 3e3, 1e5])
def test_f(value: float, k: int, freedom: float) -> None:
    assert log_f_tail(value, k, freedom) == pytest.approx(exact_f(value, k, freedom), rel=1e-5)


@pytest.mark.parametrize("k", [1, 2, 3])
@pytest.mark.parametrize("value", [0.5, 4.0, 60.0, 1300.0, 1600.0, 1e5])
def test_chi2(value: float, k: int) -> None:
    assert log_chi2_tail(value, k) == pytest.approx(exact_chi2(value, k), rel=1e-5)


def test_of_two_values_beyond_underflow_the_larger_is_the_less_likely() -> None:
    assert log_f_tail(3000.0, 2, 4000.0) < log_f_tail(2999.0, 2, 4000.0) < -745.0
    assert log_chi2_tail(3000.0, 2) < log_chi2_tail(2999.0, 2) < -745.0


def test_nothing_is_certain() -> None:
    assert log_f_tail(0.0, 2, 100.0) == log_chi2_tail(0.0, 2) == 0.0
