"""The audit's limits, by planting what it says can just be found."""

from dataclasses import replace

import numpy as np
import pytest

from tests.diagnosis.prepared import WHITE, Field, field
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.causes.prepared import inner_of, prepared
from trueaxis.diagnosis.causes.scan import residual_of, scanned
from trueaxis.diagnosis.causes.search import Ground
from trueaxis.diagnosis.causes.signatures import parameter_signature, signature_of
from trueaxis.diagnosis.further_runs.audit import Audit, audit
from trueaxis.effects.kind import Effect
from trueaxis.estimation.effects.unknowns import unit_in

DESIGN = Design(lines=4, repeats=2, targets=21, samples=72)


def audited(design: Design = DESIGN) -> tuple[Field, Ground, Audit]:
    where = field(design, WHITE)
    ground = where.ground(np.zeros(where.readings.rows.size))
    return where, ground, audit(ground)


@pytest.mark.parametrize(
    "effect",
    [
        Effect(kind="backlash", component="EXX"),
        Effect(kind="backlash", component="ECY"),
        Effect(kind="servo_lag", component="EYY"),
        Effect(kind="cross_axis", component="EXX", axis="Y"),
        Effect(kind="laser_cosine", runs=("Y2-1", "Y2-2")),
        Effect(kind="drift", component="EZZ"),
    ],
    ids=lambda effect: effect.label,
)
def test_what_is_as_large_as_the_detection_limit_is_found_about_half_the_time(effect: Effect) -> None:
    where, ground, found = audited()
    limit = next(one for one in found.limits if one.effect == effect)
    assert limit.state != "unobservable"
    source = np.random.default_rng(3)
    signature = signature_of(where.readings, effect)
    known = prepared(signature, inner_of(where.whitening, where.base))
    shares = []
    for factor in (0.3, 1.0, 3.0):
        signal = parameter_signature(where.readings, effect, np.array([factor * limit.detection]))[0]
        if any(one.role == "root" for one in signature.kind.parameters):
            signal = signal / factor  # its signature grows with the square
        hits = []
        for _ in range(120):
            values = where.base.rest(where.whitening(signal) + source.standard_normal(signal.size))
            one = scanned(signature, known, residual_of(where.whitening, where.base, values, where.freedom))
            hits.append(one.evidence >= ground.threshold)
        shares.append(float(np.mean(hits)))
    few, half, nearly_all = shares
    assert few < 0.05
    assert 0.3 < half < 0.95
    assert nearly_all > 0.99


def test_where_few_degrees_of_freedom_tell_the_noise_the_limit_is_as_much_farther_out() -> None:
    where, ground, found = audited()
    few, effect = 10.0, Effect(kind="backlash", component="EXX")
    freedom = replace(ground.freedom, of_rows=np.full(ground.values.size, few))
    limit, known_noise = (
        next(one.detection for one in limits if one.effect == effect)
        for limits in (audit(replace(ground, freedom=freedom)).limits, found.limits)
    )
    assert limit / known_noise == pytest.approx(np.sqrt(5.7589), rel=1e-3)  # F of 1 and 10 at 2e-7, over 27
    signature = signature_of(where.readings, effect)
    known = prepared(signature, inner_of(where.whitening, where.base))
    signal = parameter_signature(where.readings, effect, np.array([limit]))[0]
    source, hits = np.random.default_rng(5), []
    for _ in range(200):
        estimated = np.sqrt(source.chisquare(few) / few)  # the noise that was found, over the true one
        values = where.base.rest(where.whitening(signal) + source.standard_normal(signal.size)) / estimated
        one = scanned(signature, known, residual_of(where.whitening, where.base, values, freedom))
        hits.append(one.evidence >= ground.threshold)
    assert 0.3 < np.mean(hits) < 0.95


def test_correlations_are_cosines_of_what_the_base_leaves() -> None:
    """By explicit regression of each signature on the base and the other."""
    where, _, found = audited()
    one, other = Effect(kind="servo_lag", component="EXX"), Effect(kind="backlash", component="EXX")
    columns = [where.whitening(signature_of(where.readings, each).over_all()[:, 0]) for each in (one, other)]
    size = np.linalg.norm(where.whitening(where.columns), axis=0)
    base = where.whitening(where.columns)[:, size > 0.0] / size[size > 0.0]
    left = [column - base @ np.linalg.lstsq(base, column, rcond=1e-9)[0] for column in columns]
    cosine = left[0] @ left[1] / np.linalg.norm(left[0]) / np.linalg.norm(left[1])
    places = [found.isolable.index(each) for each in (one, other)]
    assert found.correlation[places[0], places[1]] == pytest.approx(cosine**2, abs=1e-6)
    assert found.correlation == pytest.approx(found.correlation.T)
    assert np.diag(found.correlation) == pytest.approx(1.0)
    assert found.correlation.max() <= 1.0


def test_with_three_lines_the_beam_of_one_is_the_beam_of_the_others() -> None:
    """Four lines tell whose laser was not parallel; three leave its cosine to the scale and rotations of the axis."""
    r2 = {}
    for lines in (3, 4):
        _, _, found = audited(Design(lines=lines, repeats=2, targets=15, samples=48))
        of_x = [one for one in found.limits if one.effect.kind == "laser_cosine" and one.effect.runs[0].startswith("X")]
        r2[lines] = [one.r2 if one.state != "unobservable" else 1.0 for one in of_x]
    assert min(r2[3]) > 0.999
    assert len(r2[4]) == 4


def test_a_laser_scale_is_told_from_nothing_without_a_bar() -> None:
    _, _, found = audited(Design(lines=2, repeats=2, targets=15, ball_bar=False))
    limit = next(one for one in found.limits if one.effect.kind == "laser_scale")
    assert limit.state == "unobservable"
    assert limit.detection == np.inf
    assert limit.reason


@pytest.mark.parametrize(
    ("unit", "effect", "expected"),
    [
        ("u", Effect(kind="backlash", component="EXX"), "mm"),
        ("u", Effect(kind="backlash", component="ECX"), "rad"),
        ("u/axis/K", Effect(kind="thermal_expansion", component="ECC"), "rad/deg/K"),
        ("axis", Effect(kind="cyclic", component="EYZ"), "mm"),
        ("mm", Effect(kind="laser_step", runs=("X1",)), "mm"),
    ],
)
def test_units_where_an_effect_acts(unit: str, effect: Effect, expected: str) -> None:
    assert unit_in(unit, effect) == expected
