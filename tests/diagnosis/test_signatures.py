"""Signatures against closed forms of the ball bar in the XY plane, and against the exact machine of the generator."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import numpy.typing as npt
import pytest

from tests.diagnosis.prepared import SMALL, field, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.hidden import Hidden
from trueaxis.diagnosis.causes.signature import Readings, readings_of
from trueaxis.diagnosis.causes.signatures import parameter_signature, signature_of
from trueaxis.effects.kind import Effect
from trueaxis.evaluation.circular_test import circularity

FloatArray = npt.NDArray[np.float64]
RADIUS = 150.0
CIRCLES = replace(SMALL, laser=False, samples=360)


def circles() -> tuple[Readings, slice, FloatArray, FloatArray, FloatArray]:
    """Readings, rows of the circles in XY, polar angle, sense of rotation and feed (mm/s) there."""
    readings = field(CIRCLES).readings
    rows = readings.rows
    mine = [index for index in rows.present if rows.runs[index].id.startswith("XY-")]
    part = slice(rows.of_run(mine[0]).start, rows.of_run(mine[-1]).stop)
    assert len(mine) == 4
    assert rows.feed is not None
    sense = np.array([1.0 if rows.runs[index].id.endswith("ccw") else -1.0 for index in rows.run[part]])
    return readings, part, readings.reading.theta[part], sense, rows.feed[part] / 60.0


def of_effect(kind: str, component: str | None = None, **point: float) -> FloatArray:
    readings, part, *_ = circles()
    points = (point,) if point else None
    return signature_of(readings, Effect(kind=kind, component=component), points).over_all()[part, 0]


def of_component(component: str, error: Callable[[FloatArray, FloatArray], FloatArray]) -> FloatArray:
    """Readings of a component error of X (first argument) or Y."""
    readings, part, *_ = circles()
    rows = readings.rows
    x, y = rows.positions[0, part], rows.positions[1, part]
    return readings.sensitivity[readings.model.components.index(component), part] * error(x, y)


def tool_path() -> tuple[FloatArray, FloatArray]:
    """Displacement of the axes from the centre of the circle, mm."""
    readings, part, *_ = circles()
    x, y = readings.rows.positions[:2, part]
    return x - 270.0, y - 350.0


def test_polar_angle_is_that_of_the_tool_seen_from_the_workpiece() -> None:
    """X carries the tool, Y the table: the tool is seen to move against Y."""
    _, _, theta, sense, _ = circles()
    x, y = tool_path()
    assert RADIUS * np.cos(theta) == pytest.approx(x, abs=1e-5)
    assert RADIUS * np.sin(theta) == pytest.approx(-y, abs=1e-5)
    turns = np.diff(theta)
    assert np.median(turns[sense[1:] > 0]) > 0 > np.median(turns[sense[1:] < 0])


def test_backlash_steps_at_the_reversals_of_the_axis() -> None:
    """dir (B/2) sgn(sin theta) cos theta: +x is approached on the lower half of a counter-clockwise circle.

    Lost motion of +B/2 where x grows: dr = (B/2) sgn(vx) cos theta with sgn(vx) = -dir sgn(sin theta).
    """
    _, _, theta, sense, _ = circles()
    assert of_effect("backlash", "EXX") == pytest.approx(-sense * np.sign(np.sin(theta)) * np.cos(theta) / 2, abs=1e-7)


def test_lateral_play_is_a_pair_of_arches_that_flip() -> None:
    """EYX by sgn(vx) moves the tool by Y: -dir (L/2) |sin theta|."""
    _, _, theta, sense, _ = circles()
    assert of_effect("backlash", "EYX") == pytest.approx(-sense * np.abs(np.sin(theta)) / 2, abs=1e-7)


def test_servo_lag_difference_flips_and_grows_with_feed() -> None:
    """X: -tau vx cos theta = dir F tau sin theta cos theta; Y: the same with the other sign; both: nothing."""
    _, _, theta, sense, feed = circles()
    found = of_effect("servo_lag", "EXX")
    assert found == pytest.approx(sense * feed * np.sin(2 * theta) / 2, rel=0.003, abs=2e-3 * feed.max())
    assert of_effect("servo_lag", "EYY") == pytest.approx(-found, abs=4e-3 * feed.max())


def test_bow_makes_a_first_and_a_third_harmonic() -> None:
    """EYX = c x^2: (c R^2/4)(sin theta + sin 3 theta), the same both ways."""
    _, _, theta, _, _ = circles()
    found = of_component("EYX", lambda x, _: 1e-7 * (x - 270.0) ** 2)
    expected = 1e-7 * RADIUS**2 / 4 * (np.sin(theta) + np.sin(3 * theta))
    assert found == pytest.approx(expected, abs=1e-9)


def test_scale_mismatch_makes_an_ellipse() -> None:
    """EXX = k x, EYY = -k y: k R cos 2 theta."""
    _, _, theta, _, _ = circles()
    found = of_component("EXX", lambda x, _: 1e-5 * (x - 270.0)) - of_component("EYY", lambda _, y: 1e-5 * (y - 350.0))
    assert found == pytest.approx(1e-5 * RADIUS * np.cos(2 * theta), abs=1e-9)


def test_squareness_makes_an_ellipse_at_45_degrees() -> None:
    """-(C R/2) sin 2 theta beside what a place of the ball that is off explains (a first harmonic)."""
    given = prepared(Case(seed=1, design=CIRCLES, noise="none", given="exact", effects=(Hidden("squareness", "EC0X"),)))
    rows = given.rows
    readings = readings_of(given.model, rows)
    part = slice(0, rows.of_run(3).stop)
    theta = readings.reading.theta[part]
    found = signature_of(readings, Effect(kind="squareness", component="EC0X")).over_all()[part, 0]
    first = np.stack([np.cos(theta), np.sin(theta), np.ones(theta.size)], axis=1)
    rest = found - RADIUS / 2 * np.sin(2 * theta)  # X turned by C: the tool moves by C x along Y
    assert rest - first @ np.linalg.lstsq(first, rest, rcond=None)[0] == pytest.approx(0.0, abs=1e-6)


def test_a_centre_that_is_off_is_a_first_harmonic() -> None:
    readings, part, theta, _, _ = circles()
    ids = tuple(readings.rows.runs[index].id for index in np.unique(readings.rows.run[part]))
    of_part = signature_of(readings, Effect(kind="ballbar_centre", runs=ids)).over_all()[part]
    # of the ball on the workpiece: the tool's ball comes closer
    assert of_part[:, 0] == pytest.approx(-np.cos(theta), abs=1e-3)
    assert of_part[:, 1] == pytest.approx(-np.sin(theta), abs=1e-3)
    assert of_part[:, 2] == pytest.approx(0.0, abs=1e-3)


def test_length_and_lobes_of_the_bar() -> None:
    readings, part, theta, _, _ = circles()
    assert of_effect("ballbar_length") == pytest.approx(1.0)
    lobes = signature_of(readings, Effect(kind="ballbar_lobes")).over_all()[part]
    assert lobes[:, 0] == pytest.approx(np.cos(3 * theta), abs=1e-9)
    assert lobes[:, 1] == pytest.approx(-np.sin(3 * theta), abs=1e-9)


def test_a_spike_dies_away_after_each_reversal() -> None:
    readings, part, theta, sense, _ = circles()
    found = of_effect("reversal_spike", "EXX", decay=8.0)
    since = np.minimum(RADIUS * (1 - np.abs(np.cos(theta))), RADIUS)
    way = -sense * np.sign(np.sin(theta))
    after = np.where(way * np.cos(theta) < 0, since, 2 * RADIUS - since)  # turned at x = -R where x grows
    expected = way * np.exp(-after / 8.0) * np.cos(theta)
    turned = np.isfinite(readings.context.since_reversal[0, part])
    assert turned.mean() > 0.7
    assert found[turned] == pytest.approx(expected[turned], abs=0.02)
    assert found[~turned] == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    "hidden",
    [
        Hidden("laser_scale", size=4e-6),
        Hidden("servo_lag", "EYY", size=2e-5),
        Hidden("cross_axis", "ECX", axis="Y", size=4e-5),
        Hidden("backlash", "EBZ", size=4e-5),
        Hidden("drift", "EYX", size=2e-7),
        Hidden("ballbar_length", size=3e-3),
    ],
    ids=lambda hidden: hidden.kind,
)
def test_what_an_exact_machine_does_is_first_order_plus_the_flaws_of_the_hidden_effect(hidden: Hidden) -> None:
    """Exact rigid transforms with and without the effect: their difference correlates with the signature."""
    case = Case(seed=3, design=SMALL, noise="none", given="exact", nuisance=False)
    without, with_it = prepared(case), prepared(replace(case, effects=(hidden,)))
    change = with_it.rows.reading - without.rows.reading
    rows = without.rows
    readings = readings_of(without.model, rows)
    effect = Effect(kind=hidden.kind, component=hidden.component or None, axis=hidden.axis or None)
    column = signature_of(readings, effect).over_all()[:, 0] * hidden.size
    offsets = np.equal.outer(rows.run, np.array(rows.present)).astype(float)
    zeroed = np.array([run.instrument != "ballbar" for run in rows.runs])
    offsets = offsets[:, zeroed]
    both = np.stack([change, column], axis=1)
    change, column = (both - offsets @ np.linalg.lstsq(offsets, both, rcond=None)[0]).T
    assert change @ column / (column @ column) == pytest.approx(1.0, abs=0.1)
    assert (change @ column) ** 2 / (change @ change) / (column @ column) > 0.97


@pytest.mark.parametrize(
    ("effect", "values"),
    [
        (Effect(kind="cyclic", component="EXX"), [1e-3, 0.4, 13.0]),
        (Effect(kind="warm_up", component="EYY"), [5e-3, 3000.0]),
        (Effect(kind="reversal_spike", component="EXX"), [1e-3, 5.0]),
        (Effect(kind="ballbar_lobes"), [1e-3, 1.0]),
        (Effect(kind="backlash_slope", component="EZZ"), [1e-3]),
        (Effect(kind="laser_cosine", runs=("X1-1", "X1-2")), [5e-3]),
        (Effect(kind="point_offset", runs=("X1-1", "X1-2"), end="target"), [1.0, 2.0, -1.0]),
    ],
    ids=lambda given: given.kind if isinstance(given, Effect) else "",
)
def test_derivatives_by_parameters_are_finite_differences(effect: Effect, values: list[float]) -> None:
    readings = field(SMALL).readings
    at = np.array(values)
    signal, jacobian = parameter_signature(readings, effect, at)
    assert np.abs(signal).max() > 0.0
    for place, value in enumerate(values):
        step = 1e-5 * abs(value) * np.eye(at.size)[place]
        ahead, behind = (parameter_signature(readings, effect, at + sign * step)[0] for sign in (1, -1))
        numeric = (ahead - behind) / (2 * step[place])
        assert jacobian[:, place] == pytest.approx(numeric, abs=1e-5 * np.abs(numeric).max() + 1e-14)


def test_circularity_is_the_range_about_the_fitted_centre() -> None:
    theta = np.linspace(0.0, 2 * np.pi, 720, endpoint=False)
    oval = 3e-3 + 5e-3 * np.cos(theta) - 2e-3 * np.sin(theta) + 1e-3 * np.cos(2 * theta)
    assert circularity(theta, oval).deviation == pytest.approx(2e-3, rel=1e-9)
