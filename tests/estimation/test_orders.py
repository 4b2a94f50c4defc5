"""Up to which order curves go, on worlds: readings tell the orders, and what they tell the curve follows."""

from dataclasses import replace
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from tests.worlds.estimates import World, outcome_of, world
from tests.worlds.truth import Truth, draw_machine
from tests.worlds.unlike import large
from trueaxis.error_name import ErrorName
from trueaxis.estimation.curve_prior import DEGREE
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.orders import HIGHEST_DEGREE, higher_degrees
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.setting import EstimationOptions
from trueaxis.model.bases import travel_basis

pytestmark = pytest.mark.usefixtures("values_alone")
SEED, MACHINE = 7003, 7003000  # lasers of 16 targets and a noise of 0.1 um; EZZ is 117 um, others 5 to 20


@pytest.fixture(scope="module")
def dense(tmp_path_factory: pytest.TempPathFactory) -> World:
    return world(SEED, tmp_path_factory.mktemp("world"), 3)


@pytest.fixture(scope="module")
def machine(dense: World) -> Truth:
    """One axis of which is far worse than the others."""
    return large(draw_machine(dense.design.machine, MACHINE), np.random.default_rng([MACHINE, 31]))


def test_a_curve_far_larger_than_others_bends_nothing_beyond_its_targets(dense: World, machine: Truth) -> None:
    """By 14 orders it was off by 43 um between home and its first target, where u was 6 um, and by 2 um elsewhere."""
    found = outcome_of(dense, machine, MACHINE)
    fixed = outcome_of(dense, machine, MACHINE, options=EstimationOptions(degree=DEGREE))
    assert found.found.iteration.converged
    assert fixed.coverage < 0.5
    assert found.coverage > 0.9
    assert found.error < 0.5 * fixed.error
    degrees = dict(zip(found.found.layout.components, (one.degree for one in found.found.layout.bases), strict=True))
    assert degrees[ErrorName("EZZ")] > DEGREE
    assert DEGREE in degrees.values()  # angles that no reading tells
    assert {basis.degree for basis in fixed.found.layout.bases} == {DEGREE}


def test_without_a_prior_nothing_says_how_orders_shrink(dense: World, machine: Truth) -> None:
    found = outcome_of(dense, machine, MACHINE, options=EstimationOptions(prior=False))
    assert {basis.degree for basis in found.found.layout.bases} == {DEGREE}


@pytest.mark.parametrize(
    ("left", "expected"),
    [
        ((0.9, 0.9, 0.9), {}),
        ((0.1, 0.9, 0.9), {}),  # a low order, which says nothing of the higher ones
        ((0.9, 0.9, 0.1), {"EXX": HIGHEST_DEGREE}),
        ((0.9, 0.1, 0.9), {"EXX": HIGHEST_DEGREE}),  # even orders alone
    ],
)
def test_orders_are_added_where_the_last_ones_are_told(
    left: tuple[float, float, float], expected: dict[str, int]
) -> None:
    """left: variance of each order of EXX over that of its prior."""
    scale = np.array([3.0, 2.0, 1.0, 5.0, 4.0, 1.0])
    spread = np.diag(scale * np.sqrt([*left, 1.0, 1.0, 1.0]))
    bases = (travel_basis((0.0, 100.0), 3), travel_basis((0.0, 300.0), 3))
    layout = SimpleNamespace(
        components=(ErrorName("EXX"), ErrorName("EYX")), bases=bases, offsets=np.array([0, 3, 6]), count=6
    )
    posterior = Posterior(mean=np.zeros(6), spread=spread, scale=scale, own=(), own_told=(), told=0.0)
    assert higher_degrees(cast(Layout, layout), posterior) == expected
    highest = replace(bases[0], degree=HIGHEST_DEGREE)
    scale, told = np.ones(HIGHEST_DEGREE), np.full(HIGHEST_DEGREE, 0.1)
    layout.components, layout.bases, layout.offsets = layout.components[:1], (highest,), np.array([0, HIGHEST_DEGREE])
    posterior = replace(posterior, mean=np.zeros(HIGHEST_DEGREE), spread=np.diag(np.sqrt(told)), scale=scale)
    assert higher_degrees(cast(Layout, layout), posterior) == {}
