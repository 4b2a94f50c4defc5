"""The independent machine is itself checked by hand-worked cases before anything is compared with it."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.generator.dmu60p import TRAVEL, cubic_errors, dmu60p, sine_errors
from tests.generator.instruments import ball_bar, laser, noise
from tests.generator.machine import Body, Generator, inverse3, polynomial, rodrigues, sine

HOME = {"X": 0.0, "Y": 0.0, "Z": 0.0}
FAR = {"X": 540.0, "Y": 700.0, "Z": 600.0}
BED = ("bed", (0.0, 0.0, 0.0))


def test_without_errors_the_tool_is_where_the_axes_put_it() -> None:
    machine = dmu60p({}, {"q_wy": -350.0, "q_Tz": 400.0})
    found = machine.coordinates("tool", "workpiece", {"X": 1.0, "Y": 2.0, "Z": 3.0}, (10.0, 20.0, 30.0))
    assert found.tolist() == [11.0, 20.0 - 2.0 + 350.0, 433.0]


def test_rotations_agree_with_scipy_and_the_inverse_with_numpy() -> None:
    vector = np.array([0.3, -0.2, 0.5])
    assert rodrigues(vector.astype(np.longdouble)).astype(float) == pytest.approx(
        Rotation.from_rotvec(vector).as_matrix(), abs=1e-15
    )
    matrix = np.array([[1.0, 2.0, 0.5], [-1.0, 3.0, 0.0], [0.2, 0.1, 1.0]])
    assert inverse3(matrix.astype(np.longdouble)).astype(float) == pytest.approx(np.linalg.inv(matrix), abs=1e-15)


def test_a_rotary_axis_turns_about_its_own_letter_through_its_position() -> None:
    table = Body(2, lower=1, moves="C", position=(100.0, 0.0, 0.0))
    machine = Generator((table,), ("C",), {"bed": 1, "table": 2}, {}, {})
    found = machine.coordinates("table", "bed", {"C": 90.0}, (10.0, 0.0, 5.0))
    assert found.astype(float) == pytest.approx([100.0, 10.0, 5.0], abs=1e-14)


def test_a_single_error_is_read_with_its_lever() -> None:
    """Eq. (12): a yaw of 10 urad at a point 300 mm across reads -3 um along X; a squareness nothing along X."""
    machine = dmu60p({"ECX": polynomial(p1=1e-5 / 540)}, {"eps_xy": 5e-6})
    far = {"X": 540.0, "Y": 0.0, "Z": 0.0}
    target = ("tool", (0.0, 300.0, 0.0))
    along = laser(machine, far, HOME, direction=(1, 0, 0), frame="bed", target=target, reference=BED)
    assert float(along) == pytest.approx(-3e-3, abs=1e-7)
    across = laser(machine, far, HOME, direction=(0, 1, 0), frame="bed", target=target, reference=BED)
    assert float(across) == pytest.approx(540.0 * 5e-6, abs=1e-7)


def test_a_ball_bar_reads_its_elongation() -> None:
    machine = dmu60p({"EXX": polynomial(p1=0.01 / 540)}, {})
    balls = {"target": ("tool", (0.0, 0.0, 0.0)), "reference": ("workpiece", (240.0, 0.0, 0.0))}
    found = ball_bar(machine, {"X": 540.0, "Y": 0.0, "Z": 0.0}, length=300.0, frame="workpiece", **balls)
    assert float(found) == pytest.approx(0.01, abs=1e-15)


@pytest.mark.parametrize("errors", [cubic_errors(), sine_errors()], ids=["cubic", "sine"])
def test_true_rotations_differ_from_small_angle_matrices_by_second_order(errors: dict) -> None:  # type: ignore[type-arg]
    def difference(scale: float) -> float:
        scaled = {name: (lambda s, f=f: scale * f(s)) for name, f in errors.items()}
        small, true = (dmu60p(scaled, {}, rotations) for rotations in ("small", "true"))
        point = (100.0, -50.0, 80.0)
        gap = small.deviation("tool", "workpiece", FAR, point) - true.deviation("tool", "workpiece", FAR, point)
        return float(np.sqrt(gap @ gap))

    assert 0.0 < difference(1.0) < 1e-4  # (2e-4 rad)^2 at a lever of 1000 mm
    assert difference(1.0) / difference(0.5) == pytest.approx(4.0, rel=1e-2)


def test_curves_are_zero_at_home_and_as_large_as_meant() -> None:
    for function in (*cubic_errors().values(), *sine_errors().values(), sine(1.0, 100.0, 0.4)):
        assert float(function(0.0)) == 0.0
    sizes = [abs(float(f(TRAVEL[name[2]][1]))) for name, f in cubic_errors().items() if name[1] in "XYZ"]
    assert 1e-3 < max(sizes) < 0.1


def test_the_noise_is_gaussian() -> None:
    found = noise(3, 1e-3, 100_000)
    assert np.std(found) == pytest.approx(1e-3, rel=0.02)
    assert np.mean(np.abs(found) < 1e-3) == pytest.approx(0.6827, abs=0.01)
