"""Figures of a diagonal test against a machine that is skewed by exact rotations."""

import numpy as np
import pytest

from tests.evaluation.iso230_6.skewed import Skewed
from trueaxis.evaluation.diagonal_test import DIAGONALS, DiagonalTest, diagonal_figures, diagonal_test
from trueaxis.evaluation.positioning_test import PositioningTest, evaluate

VOLUME = {"X": 500.0, "Y": 400.0, "Z": 300.0}
FACE = {"X": 500.0, "Y": 400.0}
MACHINE = Skewed(xy=80e-6, xz=-50e-6, yz=30e-6, scale=(20e-6, -35e-6, 10e-6), lost=(-6e-3, -4e-3, 2e-3))


def of(machine: Skewed, lengths: dict[str, float], noise: np.ndarray | None = None, cycles: int = 2) -> DiagonalTest:
    """noise: (diagonals, 2, m, cycles)."""
    names, sides = DIAGONALS[len(lengths)], np.array(list(lengths.values()))
    targets = np.linalg.norm(sides) * np.array([0.0, 0.13, 0.31, 0.52, 0.68, 0.87, 1.0])
    runs = []
    for k, name in enumerate(names):
        ways = [np.repeat(machine.measured(name, sides, targets, way)[:, np.newaxis], cycles, 1) for way in (1, -1)]
        if noise is not None:
            ways = [one + noise[k, i] for i, one in enumerate(ways)]
        runs.append(("file", name, PositioningTest(targets, ways[0], ways[1])))
    return diagonal_test(runs, lengths, "test")


def test_squareness_of_a_volume_is_that_of_the_rotations() -> None:
    found = diagonal_figures(of(MACHINE, VOLUME))
    assert [one.of for one in found.squareness] == ["XY", "XZ", "YZ"]
    np.testing.assert_allclose([one.value for one in found.squareness], [80e-6, -50e-6, 30e-6], atol=2e-8)
    assert found.scale is not None
    weights = np.square([500.0, 400.0, 300.0]) / 500000.0
    assert found.scale.value == pytest.approx(float(weights @ [20e-6, -35e-6, 10e-6]), abs=1e-8)
    assert found.scale.u == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("names", [("pp", "np"), ("nn", "pn")])
def test_squareness_of_a_face(names: tuple[str, str]) -> None:
    test = of(MACHINE, FACE)
    renamed = [("file", name, one) for name, one in zip(names, test.tests.values(), strict=True)]
    found = diagonal_figures(diagonal_test(renamed, FACE, "test"))
    (square,) = found.squareness
    assert square.of == "XY"
    assert square.value == pytest.approx(80e-6, abs=2e-8)


def test_each_diagonal_has_the_figures_of_an_axis_and_the_largest_are_named() -> None:
    noise = np.random.default_rng(3).normal(0.0, 1e-3, (4, 2, 7, 5))
    test = of(MACHINE, VOLUME, noise, 5)
    found = diagonal_figures(test)
    for one, (name, readings) in zip(found.diagonals, test.tests.items(), strict=True):
        alone = evaluate(readings)
        assert one.name == name
        for figure in "EBRAM":
            assert getattr(one.evaluation, figure) == getattr(alone, figure)
    assert found.E_d == max(evaluate(one).E for one in test.tests.values())
    assert found.B_d == max(evaluate(one).B for one in test.tests.values())
    # lost motion of the axes, each by its share in the diagonal
    quiet = diagonal_figures(of(MACHINE, VOLUME))
    expected = (6e-3 * 500.0 + 4e-3 * 400.0 - 2e-3 * 300.0) / np.sqrt(500000.0)
    assert quiet.B_d == pytest.approx(expected, rel=1e-3)
    assert quiet.E_d > 0.02


def test_u_is_the_spread_of_what_noise_makes_of_the_squareness() -> None:
    draw = np.random.default_rng(5)
    tests = [diagonal_figures(of(Skewed(), VOLUME, draw.normal(0.0, 1e-3, (4, 2, 7, 5)), 5)) for _ in range(300)]
    values = np.array([[one.value for one in found.squareness] for found in tests])
    u = np.array([[one.u for one in found.squareness] for found in tests], dtype=float)
    np.testing.assert_allclose(np.sqrt(np.mean(u**2, axis=0)), values.std(axis=0), rtol=0.15)


def test_equal_diagonals_hide_scale_errors_that_cancel() -> None:
    cube = {"X": 400.0, "Y": 400.0, "Z": 400.0}
    found = diagonal_figures(of(Skewed(scale=(30e-6, -30e-6, 0.0)), cube))
    assert found.E_d < 1e-6
    assert found.scale_range < 1e-9


def test_a_diagonal_that_is_missing_leaves_squareness_open() -> None:
    test = of(MACHINE, VOLUME)
    runs = [("file", name, one) for name, one in test.tests.items() if name != "pnp"]
    found = diagonal_test(runs, VOLUME, "test")
    assert found.missing == ("pnp",)
    figures = diagonal_figures(found)
    assert (figures.scale, figures.squareness) == (None, ())
