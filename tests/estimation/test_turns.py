"""Errors of a rotary axis that repeat with its turn, on a world; which axes turn round; their prior."""

import numpy as np
import pytest

from tests.worlds.estimates import World, outcome_of, world
from tests.worlds.truth import draw_machine
from tests.worlds.unlike import curve_figures, repeating, turning
from trueaxis.estimation.curve_prior import HARMONICS, SHAPE, CurvePrior, harmonics_of
from trueaxis.estimation.estimate import EstimationOptions
from trueaxis.estimation.sizes import TURNS
from trueaxis.model.bases import travel_basis
from trueaxis.model.curve_json import curve_object

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


@pytest.mark.parametrize("travel", [(-360.0, 360.0), (90.0, 450.0), (0.0, 1080.0)])
def test_draws_of_the_prior_have_its_size_and_half_of_it_repeats(travel: tuple[float, float]) -> None:
    basis = travel_basis(travel, 14, 8)
    log, _ = CurvePrior(basis).log_weights(np.zeros(len(SHAPE)))
    at = np.linspace(*travel, 3601)[:-1]
    variance = (basis(at) * np.exp(log)[:, np.newaxis]) ** 2
    assert variance.sum(axis=0).mean() == pytest.approx(1.0, rel=0.03)
    assert variance[14:].sum(axis=0).mean() == pytest.approx(0.5, rel=0.03)


def test_the_shape_moves_polynomials_alone() -> None:
    prior, step = CurvePrior(travel_basis((-360.0, 360.0), 14, 8)), 1e-5
    _, slope = prior.log_weights(np.zeros(2))
    for place in range(2):
        ends = [prior.log_weights(sign * step * np.eye(2)[place])[0] for sign in (-1.0, 1.0)]
        np.testing.assert_allclose(slope[place], (ends[1] - ends[0]) / (2.0 * step), atol=1e-8)
    assert not slope[:, 14:].any()


def test_one_turn_tells_all_of_an_axis_without_ends() -> None:
    """Whose travel is written as a hundred thousand degrees."""
    basis = travel_basis((-99999.0, 99999.0), 14, HARMONICS)
    at = np.array([-90.0, 0.0, 270.0, 3600.0 - 90.0])
    waves = basis.clamped(at)[14:]
    np.testing.assert_allclose(waves[:, 2], waves[:, 0], atol=1e-11)
    np.testing.assert_allclose(waves[:, 3], waves[:, 0], atol=1e-11)
