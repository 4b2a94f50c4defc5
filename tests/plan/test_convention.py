"""The split of straightness and squareness, against closed forms."""

import numpy as np
import pytest

from tests.plan.data import IDEAL, known_but, laser, observations, path, plan
from trueaxis.plan.convention import echelon
from trueaxis.plan.instruments import Assumptions
from trueaxis.plan.method import PlanOptions, judge
from trueaxis.plan.report import PlanReport

STEPS = [0.0, 100.0, 200.0, 300.0, 500.0]
ONE = observations([laser("S", "y", (0.0, 0.0, 0.0))], [path("X", STEPS)])
KNOWN = known_but("EYX", "eps_xy")


def judged(ideal: bool) -> PlanReport:
    """Straightness of X in y, as many powers as positions: every position has its own value."""
    return judge(plan(ONE, PlanOptions(degree=7, known=KNOWN, assumed=IDEAL if ideal else Assumptions())))


def test_squareness_from_one_straightness_run_has_the_uncertainty_of_a_slope() -> None:
    report = judged(ideal=True)
    (squareness,) = [one for one in report.locations if one.name == "eps_xy"]
    at = np.array(STEPS) - np.mean(STEPS)
    weights = at / (at @ at)
    assert squareness.state == "by convention"
    assert squareness.u == pytest.approx(1e-3 * np.linalg.norm(weights[1:]), rel=1e-9)  # at home nothing is read
    assert squareness.u_end_point == pytest.approx(1e-3 / 500.0, rel=1e-9)
    assert report.rank == 4
    assert report.settled == 1


def test_only_the_sum_is_determined_in_words() -> None:
    (item,) = judged(ideal=True).undetermined
    assert item.settled
    assert item.parameters == ("eps_xy", "EYX")
    assert "eps_xy and the slope of EYX: only their sum is determined" in item.combination


def test_a_line_of_unknown_slope_leaves_nothing_for_squareness() -> None:
    """The straightness keeps what is left of its slope; squareness is no more seen than the slope of the line."""
    report = judged(ideal=False)
    curve = next(one for one in report.curves if one.name == "EYX")
    squareness = next(one for one in report.locations if one.name == "eps_xy")
    at = np.array(STEPS) - np.mean(STEPS)
    from_home = np.eye(5) - np.eye(5)[0]  # the reading at home gives the offset of the line
    levelled = (np.eye(5) - np.outer(STEPS, at / (at @ at))) @ from_home
    assert curve.state == "by convention"
    assert curve.u_measured == pytest.approx(1e-3 * np.linalg.norm(levelled, axis=1).max(), rel=1e-9)
    assert squareness.state == "undetermined"
    assert report.instrument_unknowns == 2
    assert report.rank == 3
    assert any("slope of run S" in item.combination for item in report.undetermined)


def test_sense_of_the_sum() -> None:
    """In YZ the workpiece and the squareness of the paper have the other sign: a difference."""
    observed = observations([laser("S", "y", (0.0, 0.0, 0.0))], [path("Z", STEPS)])
    report = judge(plan(observed, PlanOptions(known=known_but("EYZ", "eps_yz"), assumed=IDEAL)))
    assert "only their difference is determined" in report.undetermined[0].combination


def test_the_basis_of_a_space_does_not_depend_on_how_the_space_is_given() -> None:
    draw = np.random.default_rng(3)
    space = np.array([[1.0, 0.0], [2.0, 0.0], [0.0, 1.0], [0.0, -3.0], [5.0, 1.0]])
    for _ in range(5):
        basis, leads = echelon(space @ draw.normal(size=(2, 2)), [4, 0, 1, 2, 3])
        assert leads == [4, 0]
        assert np.allclose(basis, [[0.0, 1.0], [0.0, 2.0], [1.0, -5.0], [-3.0, 15.0], [1.0, 0.0]])
    assert echelon(np.zeros((5, 0)), range(5))[0].shape == (5, 0)
