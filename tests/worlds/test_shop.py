"""The shop: noise as it is declared, and the unknowns of the instruments."""

import numpy as np
import pytest

from tests.worlds.design import Design, draw_design
from tests.worlds.oracle import oracle
from tests.worlds.readings import exact_readings, measure_all
from tests.worlds.shop import draw_noise, draw_values
from tests.worlds.truth import Truth, draw_machine

SEEDS = (5, 6, 11, 36, 59)


def perfect(design: Design) -> Truth:
    machine = design.machine
    nothing = draw_machine(machine, 1, sizes=dict.fromkeys(("translation_um", "rotation_urad"), 0.0))
    return Truth(machine, nothing.curves, dict.fromkeys(machine.locations, 0.0), nothing.sizes)


@pytest.mark.parametrize("seed", SEEDS)
def test_what_the_shop_adds_is_white_once_its_covariance_is_taken_out(seed: int) -> None:
    """Noise, steps of the display and unknowns of single runs; those that runs share are taken off by their columns."""
    design = draw_design(seed)
    half = oracle(design, "prior")
    truth = draw_machine(design.machine, seed)  # one with errors: else a display shows the same digit throughout
    sets = measure_all(design, [truth] * 40, range(40))
    clean = exact_readings(design, [truth])[0]
    squares = []
    for data in sets:
        left = data.reading - clean
        for unknown, value in zip(design.shop.unknowns, data.values, strict=True):
            if len(np.unique(design.plan.run[unknown.rows])) > 1:
                left[unknown.rows] -= unknown.column * value
        squares.append(np.mean(half.whitened(left) ** 2))
    spread = np.sqrt(2 / design.plan.count / 40)
    assert np.mean(squares) == pytest.approx(1.0, abs=5 * spread + 0.01)


def test_slow_noise_is_as_slow_as_it_is_said_to_be() -> None:
    design = next(d for d in map(draw_design, range(1, 40)) if d.shop.slow_mm.any() and not d.shop.walk_mm.any())
    plan, shop = design.plan, design.shop
    index = max(range(len(plan.runs)), key=lambda k: len(plan.rows(k)) * (shop.slow_mm[k] > 0))
    rows = plan.rows(index)
    drawn = np.array([draw_noise(np.random.default_rng(k), plan, shop)[rows] for k in range(300)])
    expected = shop.covariance(plan, index) - np.diag(shop.resolution[rows] ** 2 / 12)
    for lag in (0, 1, 5):
        found = np.mean(drawn[:, lag:] * drawn[:, : len(rows) - lag])
        assert found == pytest.approx(np.mean(np.diag(expected, lag)), rel=0.1)


def test_unknowns_have_their_spreads_and_cosines_only_shorten() -> None:
    design = next(
        d for d in map(draw_design, range(1, 60)) if d.ingredients["cosine"] and d.ingredients["ball_centres"]
    )
    drawn = np.array([draw_values(np.random.default_rng(k), design.shop) for k in range(2000)])
    for k, unknown in enumerate(design.shop.unknowns):
        assert np.sqrt(np.mean(drawn[:, k] ** 2)) == pytest.approx(unknown.spread, rel=0.15)
        assert unknown.kind != "cosine" or drawn[:, k].max() < 0.0


def test_columns_of_unknowns_are_what_a_unit_of_them_adds() -> None:
    """The centre of a ball moves the exact readings; its column is the first order of that."""
    design = next(d for d in map(draw_design, range(1, 40)) if d.ingredients["ball_centres"])
    plan, truth = design.plan, perfect(design)
    clean = exact_readings(design, [truth])[0]
    for unknown in [one for one in design.shop.unknowns if one.kind.startswith("centre")][:6]:
        balls = np.zeros((1, len(plan.runs), 3))
        balls[0, np.unique(plan.run[unknown.rows]), "XYZ".index(unknown.kind[-1])] = 1e-4
        change = (exact_readings(design, [truth], balls)[0] - clean) / 1e-4
        expected = np.zeros(plan.count)
        expected[unknown.rows] = unknown.column
        assert change == pytest.approx(expected, abs=1e-5)


def test_outliers_are_few_large_and_where_the_shop_says() -> None:
    design = next(d for d in map(draw_design, range(1, 40)) if d.ingredients["outliers_in_twos"])
    shop, plan = design.shop, design.plan
    assert 2 <= len(shop.outliers) < 0.006 * plan.count + 3
    twos = np.flatnonzero(np.diff(shop.outliers) == 1)
    assert np.all(plan.run[shop.outliers[twos]] == plan.run[shop.outliers[twos + 1]])
    assert shop.outlier_mm > 5 * np.median(shop.white)


def test_the_display_shows_whole_steps() -> None:
    design = next(d for d in map(draw_design, range(1, 40)) if d.ingredients["display_steps"])
    data = measure_all(design, [draw_machine(design.machine, 1)], [1])[0]
    stepped = design.shop.resolution > 0
    steps = data.reading[stepped] / design.shop.resolution[stepped]
    assert np.max(np.abs(steps - np.round(steps))) < 1e-4
