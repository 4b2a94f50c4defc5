"""What is known only in combination."""

from dataclasses import replace

import numpy as np
import pytest

from tests.planning.data import folder, model
from trueaxis.estimation.combinations import Combination, Part, _label, combinations
from trueaxis.estimation.expected import expected
from trueaxis.estimation.instruments import SharedUnknown
from trueaxis.estimation.result import Estimate
from trueaxis.identification.words import combination_text
from trueaxis.model.errors import ErrorValues

RUNS = [f"R{index}" for index in range(40)]


def found(name: str, um: float, **known: float) -> Estimate:
    observed = folder(name).observed
    noise = dict.fromkeys(range(len(observed.runs)), 1e-3 * um)
    return expected(model(), observed, ErrorValues(machine="dmu60p", parameters=known), noise)


def test_squareness_and_slopes_of_the_papers_plan() -> None:
    """At 10 nm each squareness stands with a slope of straightness, by +-1, as the kinematics have it."""
    each = combinations(found("dmu60p_regular_runs", 0.01), RUNS)
    assert {("eps_xy", "EYX"), ("eps_yz", "EYZ")} <= {
        (one.parts[0].name, part.name) for one in each for part in one.parts[1:]
    }
    for one in each:
        slopes = [part for part in one.parts if part.name in ("EYX", "EYZ", "EXZ")]
        assert all(abs(part.factor) == pytest.approx(1.0, abs=0.01) for part in slopes)
        assert one.u < 0.1 * one.alone[0]


def test_it_is_the_uncertainty_of_the_sum() -> None:
    estimate = found("dmu60p_runs", 1.0)
    for one in combinations(estimate, RUNS):
        layout = estimate.layout
        change = np.zeros(layout.count)
        for part in one.parts:
            if part.what == "location":
                change[int(layout.offsets[-1]) + layout.locations.index(part.name)] = part.factor
            else:
                place = layout.components.index(part.name)
                change[int(layout.offsets[place])] = part.factor * layout.bases[place].per_position
        assert np.linalg.norm(change @ estimate.spread) == pytest.approx(one.u, rel=1e-6)


def test_known_squareness_leaves_the_slopes_alone() -> None:
    names = dict.fromkeys(model().location_errors, 0.0)
    parts = [part.name for one in combinations(found("dmu60p_regular_runs", 0.01, **names), RUNS) for part in one.parts]
    assert not set(parts) & {"eps_xy", "eps_yz", "eps_xz"}


def test_nothing_measured_is_no_combination() -> None:
    estimate = found("dmu60p_runs", 1.0)
    assert combinations(replace(estimate, spread=np.diag(estimate.scale)), RUNS) == ()


@pytest.mark.parametrize(
    ("runs", "told"),
    [((2,), "laser scale (R2)"), ((0, 2), "laser scale (R0, R2)"), ((0, 1, 2, 3), "laser scale (R0 and 3 more)")],
)
def test_unknowns_of_instruments_are_named_with_their_runs(runs: tuple[int, ...], told: str) -> None:
    """Scales of two lasers, cosines of two lines have one name otherwise."""
    assert _label(SharedUnknown(kind="laser scale", of=None, runs=runs), RUNS) == told


def test_in_words() -> None:
    parts = (Part("location", "eps_xy", 1.0, "rad"), Part("slope", "EYX", 1.0002, "mm/mm"))
    one = Combination(parts, 0.8e-6, (40.6e-6, 38.7e-6))
    expected_text = (
        "eps_xy and the slope of EYX: only their sum, to 0.8 urad (by themselves to 40.6 urad and 38.7 urad)"
    )
    assert combination_text(one) == expected_text
    turned = replace(one, parts=(parts[0], replace(parts[1], factor=-1.0)))
    assert "only their difference, to 0.8 urad" in combination_text(turned)
    third = Part("slope", "EBX", -754.3, "rad/mm")
    three = replace(one, parts=(*parts, third), alone=(*one.alone, 0.0512e-6))
    assert combination_text(three) == (
        "eps_xy + the slope of EYX - 754 x the slope of EBX: to 0.8 urad (by themselves: eps_xy to 40.6 urad, the "
        "slope of EYX to 38.7 urad and the slope of EBX to 0.0512 urad/mm)"
    )
    scale = Part("instrument", "laser scale", -1.0, "1")
    apart = Combination((Part("slope", "EXX", 1.0, "1"), scale), 0.2e-6, (1.1e-6, 1.0e-6))
    expected_text = (
        "the slope of EXX and laser scale: only their difference, to 0.2 ppm (by themselves to 1.1 ppm and 1 ppm)"
    )
    assert combination_text(apart) == expected_text
