"""Values that are no longer true: which component, where, by how much; and none where all are true."""

import numpy as np
import pytest

from tests.diagnosis.prepared import SIGMA, SMALL, FloatArray, Prepared, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.causes.signature import readings_of
from trueaxis.diagnosis.causes.signatures import parameter_signature
from trueaxis.diagnosis.judging.stale import _Asked, _chosen, clearest, stale_values
from trueaxis.diagnosis.null_model.freedom import freedom_of
from trueaxis.diagnosis.null_model.outliers import null_of
from trueaxis.diagnosis.result import Stale
from trueaxis.effects.kind import Effect

STRAIGHT = Design(lines=1, repeats=2, targets=21, straightness=True, ball_bar=False)


def given() -> Prepared:
    return prepared(Case(seed=1, design=SMALL, noise="none", given="exact"))


def noise(seed: int) -> FloatArray:
    return SIGMA * np.random.default_rng(seed).standard_normal(given().rows.size)


def curve(component: str, change: FloatArray) -> FloatArray:
    """(n,), mm: what a change of a component error, at every reading's position, does to the readings."""
    readings = readings_of(given().model, given().rows)
    return np.asarray(readings.sensitivity[readings.model.components.index(component)] * change)


def found(values: FloatArray, causes: tuple[FloatArray, ...] = ()) -> tuple[tuple[Stale, ...], float]:
    null = null_of(given().model, given().rows, values, 1e3 * SIGMA)
    assert null.rows.size == given().rows.size
    changes = stale_values(null, causes, (), freedom_of(null.rows, null.whitening, null.noise))
    return changes.stale, changes.p_value


def bump(middle: float, half: float) -> FloatArray:
    off = np.minimum(np.abs(given().rows.positions[1] - middle) / half, 1.0)
    return np.asarray(0.5 * (1.0 + np.cos(np.pi * off)))


@pytest.mark.parametrize("seed", range(4))
def test_true_values_are_not_stale(seed: int) -> None:
    stale, p_value = found(noise(seed))
    assert stale == ()
    assert p_value > 1e-4


@pytest.mark.parametrize("size", [3e-3, -6e-3])
def test_a_worn_spot_is_found_with_place_and_size(size: float) -> None:
    stale, p_value = found(noise(1) + curve("EYY", size * bump(420.0, 180.0)))
    assert p_value < 1e-6
    assert stale[0].component == "EYY"
    assert stale[0].p_value < 1e-6
    assert stale[0].value == pytest.approx(size, abs=max(4.0 * stale[0].u, 0.4 * abs(size)))
    assert stale[0].first is not None
    assert stale[0].last is not None
    assert 0.0 <= stale[0].first < 420.0 < stale[0].last <= 700.0


def test_a_location_error_has_no_place() -> None:
    readings = readings_of(given().model, given().rows)
    names = readings.model.location_errors
    lever = readings.sensitivity[len(readings.model.components) + names.index("eps_xy")]
    stale, _ = found(noise(2) + 3e-5 * lever)
    changed = {one.component: one for one in stale}
    # squareness and slopes of straightness are told together alone
    assert set(changed) & {"eps_xy", "EXY", "EYX", "ECX", "ECY"}
    if "eps_xy" in changed:
        assert changed["eps_xy"].first is None
        assert changed["eps_xy"].last is None


def test_what_a_cause_explains_is_not_stale() -> None:
    """Play of an axis looks like wear where it is not known."""
    readings = readings_of(given().model, given().rows)
    play, _ = parameter_signature(readings, Effect(kind="backlash", component="EYY"), np.array([8e-3]))
    bent = curve("EYY", 5e-3 * bump(350.0, 300.0))
    stale, _ = found(noise(3) + play + bent, (play,))
    assert [one.component for one in stale] == ["EYY"]
    assert found(noise(3) + play, (play,))[0] == ()


def test_the_change_told_is_the_largest_that_is_certain() -> None:
    value = np.array([0.1, -0.7, 0.6, 8.0])
    assert clearest(value, np.array([0.01, 0.1, 0.1, 21.0])) == 1
    assert clearest(value, np.array([0.01, 0.1, 0.1, 0.1])) == 3


def test_where_no_place_is_certain_it_is_the_one_known_best() -> None:
    """The test of the whole curve may be sure where no single place is."""
    assert clearest(np.array([8.0, 0.3, 0.0]), np.array([21.0, 0.2, 0.1])) == 1
    assert clearest(np.zeros(2), np.zeros(2)) == 0


@pytest.mark.parametrize("seed", [1, 2, 3, 4])
def test_one_component_that_changed_is_one_entry(seed: int) -> None:
    """A bend across its axis can be had from many components together: the likeliest alone is told, with the part of it
    that is surest: what its slope is, and more of it, other runs may hold.
    """
    ((one,), _) = found(noise(seed) + curve("EXY", 8e-3 * bump(420.0, 300.0)))
    assert one.component == "EXY"
    assert one.first is not None
    assert one.last is not None
    middle, half = 0.5 * (one.last + one.first), 0.5 * (one.last - one.first)

    def true(at: float) -> float:
        return 8e-3 * 0.5 * (1.0 + float(np.cos(np.pi * min(abs(at - 420.0) / 300.0, 1.0))))

    expected = true(middle) - 0.5 * (true(middle - half) + true(middle + half))
    assert abs(one.value) > 4.0 * one.u
    assert abs(one.value - expected) < 4.0 * one.u


def test_a_change_whose_slope_is_not_told_is_that_from_a_straight_line() -> None:
    """Straightness lines have slopes of their own: their curve tells of its bend alone."""
    case = prepared(Case(seed=2, design=STRAIGHT, noise="none", given="exact"))
    readings = readings_of(case.model, case.rows)
    at = case.rows.positions[1]
    wave = 1.5e-3 * np.cos(2.0 * np.pi * at / np.ptp(at)) + 0.03 * at / np.ptp(at)
    values = readings.sensitivity[readings.model.components.index("EXY")] * wave
    values = values + SIGMA * np.random.default_rng(6).standard_normal(case.rows.size)
    null = null_of(case.model, case.rows, values, 1e3 * SIGMA)
    freedom = freedom_of(null.rows, null.whitening, null.noise)
    (one,) = stale_values(null, (), (), freedom).stale
    assert (one.component, one.bent) == ("EXY", True)
    assert abs(one.value) > 2.0 * one.u


def test_a_direction_in_which_less_is_said_than_expected_is_no_evidence() -> None:
    """A location error that other curves imitate but for a thousandth of its column: what lies there is no change of
    it, which would be thousands of times what is expected, and far below its own uncertainty as it is told.
    """
    source = np.random.default_rng(3)
    axes = np.linalg.qr(source.standard_normal((8, 6)))[0]
    columns = 100.0 * axes[:, :4]
    location = columns @ source.standard_normal(4) + 0.05 * axes[:, 4]
    readings = 50.0 * axes[:, 4] + 0.5 * location + 30.0 * axes[:, 0]
    r = np.asarray(np.linalg.qr(np.column_stack([columns, location, readings]), mode="r"))
    asked = _Asked(r, {"EYX": np.arange(4), "EC0X": np.array([4])}, {"EYX": 1e3, "EC0X": 1e3}, 1e3)
    assert asked.log_p("EC0X", ("EYX",)) == 0.0
    assert asked.log_p("EC0X", ()) < np.log(1e-6)  # without the curve it is the one that changes
    assert asked.log_p("EYX", ("EC0X",)) < np.log(1e-6)


def test_of_two_that_explain_the_same_the_better_one_changed_whatever_shows_it() -> None:
    """A tilt of an axis, and the curve that imitates it but for a little: the readings that show the tilt have a noise
    that is less well known, which is no reason to believe in the curve.
    """
    source = np.random.default_rng(5)
    axes = np.linalg.qr(source.standard_normal((12, 8)))[0]
    tilt = 100.0 * axes[:, [0]]
    curve = np.column_stack([100.0 * axes[:, 0] + 3.0 * axes[:, 1], 100.0 * axes[:, 2:6]])
    r = np.asarray(np.linalg.qr(np.column_stack([curve, tilt, 40.0 * axes[:, 0]]), mode="r"))
    at = {"EAX": np.arange(5), "EC0Y": np.array([5])}
    sizes, _ = _chosen(_Asked(r, at, {"EAX": 1e4, "EC0Y": 40.0}, 1e3))
    assert list(sizes) == ["EC0Y"]
