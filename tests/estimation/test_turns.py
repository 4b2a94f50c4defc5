"""Errors of a rotary axis that repeat with its turn, on a world; which axes turn round."""

from dataclasses import replace

import numpy as np
import pytest

from tests.worlds.estimates import World, outcome_of, world
from tests.worlds.truth import draw_machine
from tests.worlds.unlike import curve_figures, repeating, turning
from trueaxis.estimation.curve_prior import HARMONICS, harmonics_of, range_of
from trueaxis.estimation.setting import EstimationOptions
from trueaxis.estimation.sizes import TURNS
from trueaxis.model.bases import travel_basis
from trueaxis.model.curve_json import curve_object
from trueaxis.model.curves import LegendreCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.measured_range import beyond_measured

pytestmark = pytest.mark.usefixtures("values_alone")
SEED = 8112  # 1227 readings; C has two turns


@pytest.fixture(scope="module")
def two_turns(tmp_path_factory: pytest.TempPathFactory) -> World:
    return world(SEED, tmp_path_factory.mktemp("world"), 5)


def test_what_repeats_with_the_turn_is_followed_over_two_turns(two_turns: World) -> None:
    """By polynomials alone the tool point was 41 um off where doing nothing was 36, and after three minutes."""
    seed = 1000 * SEED + 2
    truth = turning(draw_machine(two_turns.design.machine, seed), np.random.default_rng([seed, 31]))
    found = outcome_of(two_turns, truth, seed)
    assert found.found.iteration.converged
    assert found.error < 0.4 * found.true
    assert found.coverage > 0.9
    assert np.mean([curve_figures(found, truth, name)[2] for name in repeating(truth)]) > 0.9
    assert 1 / 3 < found.found.factors[f"{TURNS}C"] < 3.0  # half of the errors, as drawn
    forms = {name[2]: curve_object(curve)["basis"] for name, curve in found.found.values.motion_errors.items()}
    assert {axis for axis, form in forms.items() if form == "turn"} == {"C"}


def test_without_a_prior_nothing_says_how_much_repeats(two_turns: World) -> None:
    truth = draw_machine(two_turns.design.machine, SEED)
    found = outcome_of(two_turns, truth, SEED, options=EstimationOptions(prior=False, degree=3))
    assert {basis.count for basis in found.found.layout.bases} == {3}


@pytest.mark.parametrize(
    ("axis", "travel", "harmonics"),
    [
        ("C", (-360.0, 360.0), HARMONICS),
        ("A", (0.0, 360.0), HARMONICS),
        ("B", (-110.0, 110.0), 0),
        ("C", (-179.0, 180.0), 0),
        ("X", (0.0, 700.0), 0),
    ],
)
def test_axes_that_can_turn_round_have_harmonics(axis: str, travel: tuple[float, float], harmonics: int) -> None:
    assert harmonics_of(axis, travel) == harmonics


def test_one_turn_tells_all_of_an_axis_without_ends() -> None:
    """Whose travel is written as a hundred thousand degrees."""
    basis = travel_basis((-99999.0, 99999.0), 14, HARMONICS)
    at = np.array([-90.0, 0.0, 270.0, 3600.0 - 90.0])
    waves = basis(at)[14:]
    np.testing.assert_allclose(waves[:, 2], waves[:, 0], atol=1e-11)
    np.testing.assert_allclose(waves[:, 3], waves[:, 0], atol=1e-11)


@pytest.mark.parametrize(
    ("travel", "read", "expected"),
    [
        ((-360.0, 360.0), (-90.0, 90.0), (-360.0, 360.0)),
        ((-99999.0, 99999.0), (-180.0, 200.0), (-540.0, 560.0)),
        ((-99999.0, 99999.0), (), (-360.0, 360.0)),
        ((720.0, 99999.0), (1000.0,), (720.0, 1360.0)),
    ],
)
def test_an_axis_without_ends_is_followed_about_where_it_is_read(
    travel: tuple[float, float], read: tuple[float, ...], expected: tuple[float, float]
) -> None:
    """Over 555 turns what changes in two would be next to nothing, and u would hold nothing of it."""
    assert range_of(travel, HARMONICS, np.array(read)) == expected


def test_curves_are_looked_at_as_finely_as_they_may_change() -> None:
    """At every 45 deg the largest value of four waves a turn may be missed by all of them."""
    basis = travel_basis((-720.0, 720.0), 14, HARMONICS)
    assert np.diff(basis.evenly(33)).max() <= 360.0 / (5 * HARMONICS)
    assert basis.polynomials.evenly(33).size == 33


def test_what_repeats_with_a_measured_turn_is_measured_beyond_it() -> None:
    curve = LegendreCurve(basis=travel_basis((-360.0, 360.0), 2, 1), coefficients=(1e-3,) * 4, measured=(-180.0, 150.0))
    part = replace(curve, measured=(-90.0, 90.0))
    at = np.array([[300.0]])
    assert beyond_measured(ErrorValues(machine="m", motion_errors={"EXC": curve}), ["C"], at) == ()
    assert beyond_measured(ErrorValues(machine="m", motion_errors={"EXC": part}), ["C"], at) != ()
