"""What a further run would add is what it adds; the run that is proposed separates."""

from dataclasses import replace

import numpy as np
import pytest

from tests.diagnosis.prepared import SIGMA, Field, field, field_of, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from trueaxis.diagnosis.causes.candidates import grid_of
from trueaxis.diagnosis.causes.signatures import signature_of
from trueaxis.diagnosis.further_runs.audit import ISOLATION, Audit, audit
from trueaxis.diagnosis.further_runs.next_runs import Ahead, is_of_use, next_runs, separating_run
from trueaxis.diagnosis.further_runs.of_plan import Placed
from trueaxis.diagnosis.further_runs.prospect import TIMES, Outlook, Prospect, inverse_roots, outlooks_of, prospect_of
from trueaxis.diagnosis.further_runs.separation import separation, told
from trueaxis.diagnosis.judging.structure import Check, StructureClass
from trueaxis.diagnosis.null_model.base import base_of
from trueaxis.diagnosis.procedure import DiagnoseOptions, diagnose
from trueaxis.diagnosis.result import Diagnosis, NoiseOf
from trueaxis.effects.kind import Effect
from trueaxis.measurement.context import context_of
from trueaxis.reporting.diagnosis.json_file import diagnosis_json

PAIR = Effect(kind="backlash", component="EYX"), Effect(kind="backlash", component="EAX")
SCALES = Effect(kind="laser_scale"), Effect(kind="ballbar_length")
DRIFTS = Effect(kind="drift", component="EXX"), Effect(kind="thermal_offset", component="EXX")
WHOLE = Design(repeats=1, targets=21, samples=120)
FEW = Design(lines=3, repeats=2, targets=21, samples=72)


def ahead_in(one: Field) -> Prospect:
    return prospect_of(one.ground(np.zeros(one.readings.rows.size)))


def outlook(prospect: Prospect, effect: Effect) -> Outlook:
    readings = prospect.ground.readings
    points = grid_of(readings.model.machine.kinds[effect.kind], effect, readings.rows)
    return outlooks_of(prospect, [Placed(effect, points[len(points) // 2])])[0]


@pytest.mark.parametrize(
    "words", ["step gauge of 540 mm along X", "laser, Y moving at", "ball bar of 75 mm", "diagonal"]
)
@pytest.mark.parametrize("pair", [PAIR, DRIFTS], ids=["plays", "drifts"])
def test_what_a_run_adds_is_what_a_fit_of_all_readings_says(words: str, pair: tuple[Effect, Effect]) -> None:
    """Base and signatures of all rows at once, weighted by the noise: a least-squares fit, without any update."""
    one = field(WHOLE)
    prospect = ahead_in(one)
    number = next(place for place, run in enumerate(prospect.further) if words in run.what)
    rows, size = prospect.readings.rows, one.readings.rows.size
    part = prospect.innovations[number]
    keep = np.r_[0:size, part.rows]
    every = replace(one, readings=prospect.readings, null=base_of(one.readings.model, rows))
    every = replace(every, whitening=prospect.whitening)
    chance = every.by_chance()[keep]
    chance = chance[:, chance.any(axis=0)]
    base = np.hstack([every.columns, every.without_own()])
    sigma = prospect.whitening.sigma[keep, np.newaxis]
    assert prospect.whitening.sigma[:size] == pytest.approx(SIGMA)
    columns = np.column_stack([signature_of(prospect.readings, effect).over_all()[:, 0] for effect in pair])
    white, signatures = base[keep] / sigma, columns[keep] / sigma
    white = white[:, white.any(axis=0)]
    expected = np.eye(chance.shape[1])  # of each drift and ball, in its standard deviation
    white = np.block(
        [[white / np.linalg.norm(white, axis=0), chance / sigma], [np.zeros((len(expected), white.shape[1])), expected]]
    )
    signatures = np.vstack([signatures, np.zeros((len(expected), 2))])
    rest = signatures - white @ np.linalg.lstsq(white, signatures, rcond=1e-12)[0]
    gram = rest.T @ rest
    mine, rival = (outlook(prospect, effect) for effect in pair)
    found = told(mine, rival, TIMES.index(1))[number]
    assert found.detection == pytest.approx(gram[0, 0], rel=1e-4)
    assert found.r2 == pytest.approx(gram[0, 1] ** 2 / (gram[0, 0] * gram[1, 1]), abs=1e-4)


def test_what_is_said_of_now_is_what_the_audit_says() -> None:
    one = field(WHOLE)
    prospect = ahead_in(one)
    limits = {limit.effect: limit for limit in audit(prospect.ground).limits}
    for effect in (*PAIR, Effect(kind="backlash", component="EYX"), Effect(kind="laser_cosine", runs=("X1",))):
        limit = limits[effect]
        if limit.nearest is not None:
            (nearest,) = outlooks_of(prospect, [Placed(limit.nearest, limit.nearest_at)])
            (found,) = told(outlook(prospect, effect), nearest)
            assert found.r2 == pytest.approx(limit.r2, abs=1e-6)


def test_no_ball_bar_tells_its_length_and_a_gauge_tells_the_scale_of_a_laser() -> None:
    """Every run of a ball bar has a zero of its own, every laser a scale that recalibration would take over."""
    prospect = ahead_in(field(WHOLE))
    scale, length = (outlook(prospect, effect) for effect in SCALES)
    assert np.sum(scale.left**2) < 1e-9 * scale.whole
    assert told(scale, length)[0].strength == 0.0
    gauges = 0
    for number, one in enumerate(prospect.further):
        assert told(length, scale, TIMES.index(1))[number].detection == 0.0, one.what
        visible = told(scale, length, TIMES.index(1))[number].detection > 1e-9 * scale.whole
        assert visible == ("step gauge" in one.what), one.what
        gauges += visible
    assert gauges == 3


def test_play_along_and_play_in_rotation_need_a_straightness_and_then_are_told_apart() -> None:
    prospect = ahead_in(field(WHOLE))
    mine, rival = (outlook(prospect, effect) for effect in PAIR)
    best = separation(prospect, mine, [rival])
    assert told(mine, rival)[0].r2 > 0.95
    assert best is not None
    assert "laser, X moving" in best.further.what
    assert "straightness in y" in best.further.what
    assert told(mine, rival, TIMES.index(1))[prospect.further.index(best.further)].r2 < 0.9


def test_a_linear_temperature_needs_a_swing() -> None:
    swinging, linear = (ahead_in(field_with_temperature(waves)) for waves in (3.0, 0.0))
    mine, rival = (outlook(linear, effect) for effect in DRIFTS)
    assert told(mine, rival)[0].r2 > 0.999
    best = separation(linear, mine, [rival])
    assert best is not None
    assert "temperature rises and falls" in best.further.what
    mine, rival = (outlook(swinging, effect) for effect in DRIFTS)
    assert told(mine, rival)[0].r2 < 0.95


def field_with_temperature(waves: float) -> Field:
    """A ramp of 3 K over all readings and so many waves beside it, read without an error."""
    given = prepared(Case(seed=1, design=WHOLE, noise="none", given="exact"))
    rows = given.rows
    assert rows.time is not None
    share = (rows.time - rows.time.min()) / np.ptp(rows.time)
    rows = replace(rows, temperature=20.0 + 3.0 * share + waves * np.sin(20.0 * np.pi * share))
    rows = replace(rows, context=context_of(rows.runs, rows))
    return field_of(given.model, rows)


def test_no_run_tells_apart_what_is_one_displacement_of_tool_against_workpiece() -> None:
    """A drift of all X positions: of which axis, no reading between tool and workpiece says."""
    prospect = ahead_in(field(WHOLE))
    mine, rival = (outlook(prospect, Effect(kind="drift", component=name)) for name in ("EXX", "EXY"))
    assert separation(prospect, mine, [rival]) is None
    kinds = prospect.ground.readings.model.machine.kinds
    drifts = [Placed(Effect(kind="drift", component=name)) for name in ("EXX", "EXY")]
    said = separating_run(kinds, Ahead(drifts[0], (drifts[1],), 1e-8, None))
    assert said is not None
    assert (said.run, said.told, said.left) == ("", None, (drifts[1],))
    assert said.broken_by == kinds["drift"].broken_by


def test_a_cause_too_small_for_one_run_is_told_how_many() -> None:
    prospect = ahead_in(field(WHOLE))
    mine, rival = (outlook(prospect, effect) for effect in PAIR)
    best, kinds = separation(prospect, mine, [rival]), prospect.ground.readings.model.machine.kinds
    large, small = (
        separating_run(kinds, Ahead(Placed(PAIR[0]), (Placed(PAIR[1]),), size, best)) for size in (1e-2, 1e-7)
    )
    assert large is not None
    assert small is not None
    assert "straightness in y" in large.run
    assert (large.apart, large.left, large.needed) == ((Placed(PAIR[1]),), (), large.times)
    assert large.told is not None
    assert large.told.effect == PAIR[0]
    assert 1e-4 < large.told.with_run < 1e-3
    assert large.told.without > 10.0 * large.told.with_run
    assert small.needed > 1000 * small.times


def test_sizes_that_no_machine_has_and_runs_that_nobody_repeats_so_often_are_not_proposed() -> None:
    prospect = ahead_in(field(WHOLE))
    mine, rival = (outlook(prospect, effect) for effect in PAIR)
    best, kind = separation(prospect, mine, [rival]), prospect.ground.readings.model.machine.kinds[PAIR[0].kind]
    assert best is not None
    assert is_of_use(kind, mine, best)
    assert mine.largest == pytest.approx(0.5, rel=0.05)  # half the width
    assert not is_of_use(kind, mine, replace(best, after=ISOLATION * (0.5 / 6e-3) ** 2))
    nothing = Audit((), (), np.zeros((0, 0)))
    for size, count in ((1e-2, 1), (1e-7, 0)):
        assert (
            len(next_runs(prospect, nothing, (Ahead(Placed(PAIR[0]), (Placed(PAIR[1]),), size, best),), (), ()))
            == count
        )


def test_structure_without_a_name_and_readings_without_repeats_ask_for_runs() -> None:
    prospect = ahead_in(field(WHOLE))
    nothing = Audit((), (), np.zeros((0, 0)))
    checks = (
        Check(structure=StructureClass.LINE_LOCAL, place="Y", p_value=1e-9, fired=True, rms=1e-3),
        Check(structure=StructureClass.CIRCLE_FEED, place="XY", p_value=1e-5, fired=True, rms=1e-3),
        Check(structure=StructureClass.LINE_BY_LINE, place="X", p_value=0.5, fired=False, rms=0.0),
    )
    noise = (
        NoiseOf(
            instrument="laser",
            group="laser",
            white=SIGMA,
            correlated=0.0,
            correlation=0.0,
            settles=0.0,
            freedom=10.0,
            origin="courses",
        ),
    )
    found = next_runs(prospect, nothing, (), checks, noise)
    assert [one.check for one in found] == [*checks[:2], None]
    assert found[2].instrument == "laser"
    courses = (
        Check(structure=StructureClass.LINE_TEMPERATURE, place="Z", p_value=1e-9, fired=True, rms=1e-3),
        Check(structure=StructureClass.CIRCLE_COURSE, place="XY", p_value=1e-8, fired=True, rms=1e-3),
        Check(
            structure=StructureClass.LACK_OF_FIT, place="laser", p_value=1e-7, fired=True, rms=1e-3
        ),  # nothing in particular to measure
    )
    assert [one.check for one in next_runs(prospect, nothing, (), courses, ())] == [*courses]
    repeated = (
        NoiseOf(
            instrument="laser",
            group="laser",
            white=SIGMA,
            correlated=0.0,
            correlation=0.0,
            settles=0.0,
            freedom=100.0,
            origin="repeats",
        ),
        NoiseOf(
            instrument="probe",
            group="probe",
            white=SIGMA,
            correlated=0,
            correlation=0,
            settles=0,
            freedom=1e6,
            origin="given",
        ),
    )
    assert next_runs(prospect, nothing, (), (), repeated) == ()
    named = Ahead(Placed(Effect(kind="backlash", component="EXX")), (), 1e-3, None)
    assert next_runs(prospect, nothing, (named,), checks, ()) == ()


def names(found: Diagnosis) -> set[Effect]:
    return {one for cause in found.causes for one in (cause.effect, *(rival.effect for rival in cause.rivals))}


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "size"), [("backlash", -4e-3), ("backlash_slope", -5e-3)])
def test_the_run_that_is_proposed_leaves_one_name(kind: str, size: float) -> None:
    """Play of X across, told from play in rotation. (A laser that is off in scale or alignment is what recalibration
    or its maker accounts for: without a gauge it has no rival.)
    """
    effect = Hidden(kind, "EYX", size=size)
    before = _diagnosed(Case(4, design=FEW, effects=(effect,)))
    assert before.verdict == "ambiguous"
    assert names(before) == {Effect(kind=kind, component="EYX"), Effect(kind=kind, component="EAX")}
    separating = before.causes[0].separating
    assert separating is not None
    assert "straightness in y" in separating.run
    assert "straightness in y" in before.next_runs[0].run
    after = _diagnosed(Case(4, design=replace(FEW, straightness=True), effects=(effect,)))
    assert after.verdict == "explained"
    assert names(after) == {Effect(kind=kind, component="EYX")}


@pytest.mark.slow
def test_without_further_runs_all_else_is_the_same() -> None:
    case = Case(4, design=FEW, effects=(Hidden("backlash", "EYX", size=-4e-3),))
    found, alone = _diagnosed(case), _diagnosed(case, ahead=False)
    assert alone.next_runs == ()
    assert found.next_runs
    without = tuple(replace(one, separating=None) for one in found.causes)
    expected = replace(found, causes=without, next_runs=())
    assert diagnosis_json(alone, None, None) == diagnosis_json(expected, None, None)


def _diagnosed(case: Case, *, ahead: bool = True) -> Diagnosis:
    given = prepared.__wrapped__(case)
    return diagnose(given.model, given.data, DiagnoseOptions(ahead=ahead))


@pytest.mark.parametrize("far", [1.0, 1e4, 1e8])
def test_runs_far_from_the_readings_at_hand_are_whitened(far: float) -> None:
    """What is known badly is weighted down as far as that, what is known keeps its weight: no rounding in between."""
    draw = np.random.default_rng(3)
    turn = np.linalg.qr(draw.standard_normal((12, 12)))[0]
    known = turn[:, :4] * np.array([0.0, 1.0, far, far])
    for times, root in zip(TIMES, inverse_roots(known), strict=True):
        expected = (turn / (1.0 + times * np.r_[0.0, 1.0, far, far, np.zeros(8)] ** 2)) @ turn.T
        whole = root(np.eye(len(expected)))
        np.testing.assert_allclose(whole.T @ whole, expected, atol=1e-7)
