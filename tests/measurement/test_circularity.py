"""Circular deviation against circles made by hand."""

import numpy as np
import pytest

from trueaxis.evaluation.circular_test import circularity

ANGLES = np.linspace(0.0, 2.0 * np.pi, 360, endpoint=False)


def test_an_offset_centre_is_no_circular_deviation() -> None:
    found = circularity(ANGLES, 0.003 * np.cos(ANGLES) - 0.002 * np.sin(ANGLES) + 0.5)
    assert found.centre == pytest.approx((0.003, -0.002), abs=1e-15)
    assert found.deviation == pytest.approx(0.0, abs=1e-15)


def test_squareness_is_a_two_lobe_of_its_own_size() -> None:
    # A squareness error c on a circle of radius R leaves -(c R / 2) sin 2 theta: peak to peak c R.
    readings = -(20e-6 * 150.0 / 2.0) * np.sin(2.0 * ANGLES) + 0.01 * np.cos(ANGLES)
    assert circularity(ANGLES, readings).deviation == pytest.approx(20e-6 * 150.0, rel=1e-4)


def test_arcs_fix_the_centre_too() -> None:
    arcs = ANGLES[(np.abs(np.sin(ANGLES)) > 0.4)]
    found = circularity(arcs, 0.004 * np.cos(arcs) + 0.001 * np.sin(3.0 * arcs))
    assert found.centre[0] == pytest.approx(0.004, abs=1e-6)


@pytest.mark.parametrize("angles", [np.zeros(3), np.zeros(10)])
def test_too_few_angles_are_refused(angles: np.ndarray) -> None:
    with pytest.raises(ValueError, match=r"four readings|fix a centre"):
        circularity(angles, np.zeros(angles.size))
