"""The three ways to the errors of the paper's machine, and what each leaves, over noises and seeds."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.machines import ROOT
from trueaxis.demo import evaluate as module
from trueaxis.demo.evaluate import ESTIMATE, PROPOSED, STEPWISE, Study, left_um, study, study_text
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, load_model
from trueaxis.reporting.pictures.tool_point import noise_picture

MACHINES = ROOT / "machines"
PLAN = MACHINES / "dmu60p_regular_runs"


@pytest.fixture(scope="module")
def truth() -> MachineModel:
    return load_model(MACHINES / "dmu60p.toml", MACHINES / "dmu60p_errors.json", ROOT / "generated")


def test_what_is_left_is_the_root_mean_square_of_a_coordinate_seen_from_home(truth: MachineModel) -> None:
    """X off by 1e-5 of its position: over 540 mm sqrt(1/3) of 5.4 um in one coordinate of three."""
    low, high = truth.travel["X"]
    grows = ErrorValues(
        machine=truth.name, parameters={}, motion_errors={"EXX": PolynomialCurve(powers=(1,), coefficients=(1e-5,))}
    )
    expected = 1e3 * 1e-5 * np.sqrt((high**3 - low**3) / (3.0 * (high - low))) / np.sqrt(3.0)
    assert left_um(truth.with_values(grows), None) == pytest.approx(expected, rel=0.02)
    assert left_um(truth, truth.errors) == 0.0
    assert left_um(truth, ErrorValues(machine=truth.name)) == left_um(truth, None)


@pytest.mark.parametrize("noise_um", [0.3, 3.0])
def test_the_estimate_leaves_less_than_doing_nothing_at_the_noise_of_lasers(
    truth: MachineModel, noise_um: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "NOISE_UM", (noise_um,))
    (found,) = study(truth, PLAN, PLAN, 1)
    assert found.noise_um == (noise_um,)
    np.testing.assert_array_equal(found.left[ESTIMATE], found.left[PROPOSED])  # the same plan, the same noise
    assert (found.left[ESTIMATE] < 0.6 * found.nothing).all()
    assert (found.left[ESTIMATE] < 0.7 * found.left[STEPWISE]).all()


def test_the_table_and_the_picture_say_what_was_measured(tmp_path: Path) -> None:
    left = {STEPWISE: np.array([[1.0, 3.0], [8.0, 12.0]]), ESTIMATE: np.array([[0.5, 0.5], [1.0, 2.0]])}
    found = Study((0.1, 1.0), 7.0, left)
    head, _, first, second = study_text(found)
    assert head == f"| laser noise, um | {STEPWISE} | {ESTIMATE} |"
    assert first == "| 0.1 | 2.00 ± 1.41 (3.00) | 0.50 ± 0.00 (0.50) |"
    assert second == "| 1 | 10.00 ± 2.83 (12.00) | 1.50 ± 0.71 (2.00) |"
    picture = noise_picture(found.noise_um, found.left, found.nothing, "title")
    assert picture.startswith(b"\x89PNG")
    other = replace(found, left={**left, ESTIMATE: left[ESTIMATE] + 1.0})
    assert noise_picture(other.noise_um, other.left, other.nothing, "title") != picture
