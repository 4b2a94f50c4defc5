"""The yardstick: it covers as often as it says, leaves noise alone, and never does worse than nothing."""

import numpy as np
import pytest

from tests.worlds.__main__ import judge
from tests.worlds.design import draw_design
from tests.worlds.oracle import Figures, figures, oracle
from tests.worlds.readings import measure_all
from tests.worlds.truth import draw_machine, random_points

TOOL = np.zeros(3)


def over_machines(seed: int, machines: int, points: int = 20) -> Figures:
    """Of a design whose display is fine: the noise of a coarse one is not normal, which the fit takes it for."""
    design = draw_design(seed)
    half = oracle(design, "prior")
    truths = [draw_machine(design.machine, 10_000 * seed + k, curves="prior") for k in range(machines)]
    sets = measure_all(design, truths, range(machines))
    fits = [half.fit(truth.sizes, data.reading) for truth, data in zip(truths, sets, strict=True)]
    return figures(fits, truths, random_points(design.machine, seed, points), TOOL)


@pytest.mark.parametrize("seed", [45])
def test_its_intervals_cover_where_curves_are_draws_of_the_prior(seed: int) -> None:
    found = over_machines(seed, 200)
    assert 0.93 < found.coverage < 0.97
    assert found.whitened == pytest.approx(1.0, abs=0.01)
    assert found.error_um == pytest.approx(found.u_um, rel=0.15)
    assert found.error_um < found.true_um


@pytest.mark.slow
@pytest.mark.parametrize("seed", [21, 30, 47])
def test_its_intervals_cover_on_more_designs(seed: int) -> None:
    found = over_machines(seed, 200)
    assert 0.93 < found.coverage < 0.97
    assert found.whitened == pytest.approx(1.0, abs=0.01)


def test_it_finds_what_a_thorough_plan_determines() -> None:
    thorough = [d for d in map(draw_design, range(1, 60)) if d.habits.thorough and not d.machine.rotary]
    small = sorted(thorough, key=lambda design: design.plan.count)[:3]
    found = [judge(design, 6, "smooth") for design in small]
    assert all(one.error_um < 0.35 * one.true_um for one in found)
    assert all(0.93 < one.whitened < 1.07 for one in found)


def test_it_is_never_worse_than_doing_nothing() -> None:
    for seed in range(1, 50):
        design = draw_design(seed)
        if design.plan.count < 1000:
            found = judge(design, 5, "smooth")
            assert found.error_um < 1.05 * found.true_um
