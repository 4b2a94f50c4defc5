"""Values found anew change where the readings say so, and nowhere else."""

from dataclasses import replace

import numpy as np
import pytest

from tests.diagnosis.prepared import SMALL, prepared
from tests.generator.dmu60p import PARAMETERS, coefficients, cubic_errors, dmu60p
from tests.generator.machine import Generator, polynomial
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from tests.identification.data import TRAVEL, line, moving, observed, paper_runs
from tests.machines import DMU60P, ROOT
from tests.reporting.diagnosis.builders import cause, diagnosis
from trueaxis.diagnosis.extend import changed, identified_anew, kept_readings, named_effects, reidentified, start_values
from trueaxis.diagnosis.null_model.temperature import smoothed
from trueaxis.diagnosis.result import Evidence, FloatArray, Verdict
from trueaxis.effects.kind import Effect
from trueaxis.measurement.data import MeasuredData
from trueaxis.model.bases import travel_basis
from trueaxis.model.curves import Curve, LegendreCurve, PolynomialCurve, TableCurve
from trueaxis.model.errors import ErrorValues, Undetermined
from trueaxis.model.model import load_model


class TestNamed:
    RIVAL = Evidence(
        effect=Effect(kind="servo_lag", component="EXX"), evidence=5.0, p_value=1e-6, tries=1.0, freedom=100
    )

    def test_causes_that_were_named_extend_the_machine(self) -> None:
        causes = (
            cause(Effect(kind="backlash", component="EXX")),
            cause(Effect(kind="drift", component="EYY"), rivals=(self.RIVAL,)),
        )
        found = replace(diagnosis("ambiguous"), causes=causes)
        assert named_effects(found) == (Effect(kind="backlash", component="EXX"),)
        assert named_effects(replace(found, verdict="explained", causes=causes[:1])) == (
            Effect(kind="backlash", component="EXX"),
        )

    @pytest.mark.parametrize("verdict", ["no_discrepancy", "recalibrate", "unexplained_structure"])
    def test_nothing_does_where_nothing_was_named(self, verdict: Verdict) -> None:
        found = replace(
            diagnosis("explained"), verdict=verdict, causes=(cause(Effect(kind="backlash", component="EXX")),)
        )
        assert named_effects(found) == ()

    def test_the_fit_starts_at_what_the_diagnosis_found(self) -> None:
        found = replace(diagnosis("explained"), causes=(cause(Effect(kind="backlash", component="EXX")),))
        (one,) = start_values(found)
        assert one.effect == Effect(kind="backlash", component="EXX")
        assert one.parameters == {each.name: each.value for each in found.causes[0].parameters}
        assert one.parameters.keys() == {"width"}


def test_readings_are_those_that_were_taken_without_flicker() -> None:
    given = prepared(Case(seed=1, design=SMALL, noise="none", given="exact"))
    rows = given.rows.only(given.rows.run != 0)
    found = diagnosis("explained")
    observed = kept_readings(given.data, replace(found, residuals=replace(found.residuals, row=rows.row)))
    assert observed.context is not None
    order = np.argsort(rows.row)
    np.testing.assert_array_equal(observed.reading, rows.reading[order])
    temperature = smoothed(given.data).readings.temperature
    assert temperature is not None
    np.testing.assert_array_equal(observed.context.temperature, temperature[np.sort(rows.row)])


class TestChanged:
    GIVEN = ErrorValues(
        machine="m",
        parameters={"q": 5.0, "kept": 1e-5, "moved": 2e-5},
        motion_errors={
            "EXX": PolynomialCurve(powers=(0, 2), coefficients=(1.0, 3.0), u=(0.5, 0.5)),
            "EYX": TableCurve((0.0, 10.0), (0.0, 2.0), (0.1, 0.1)),
            "EZX": PolynomialCurve(powers=(1,), coefficients=(7.0,)),
        },
        u={"kept": 1e-7, "moved": 1e-7},
    )
    CHANGE = ErrorValues(
        machine="m",
        parameters={"q": 5.0, "moved": 1e-6},
        motion_errors={
            "EXX": PolynomialCurve(powers=(1, 2), coefficients=(10.0, 0.25), u=(0.01, 0.02)),
            "EYX": PolynomialCurve(powers=(1,), coefficients=(0.5,), u=(0.01,)),
            "EAX": PolynomialCurve(powers=(1,), coefficients=(9.0,), u=(0.03,)),
        },
        u={"moved": 3e-8},
        undetermined=(Undetermined("EAX and moved: 1 combination; the solution of least norm", ("moved", "EAX")),),
    )

    def test_curves_and_location_errors_are_sums(self) -> None:
        found = changed(self.GIVEN, self.CHANGE, ["kept", "moved"])
        assert found.parameters == {"q": 5.0, "kept": 1e-5, "moved": pytest.approx(2.1e-5, abs=1e-20)}
        assert found.u == {"moved": 3e-8}
        exx = found.motion_errors["EXX"]
        assert isinstance(exx, PolynomialCurve)
        assert (exx.powers, exx.coefficients) == ((0, 1, 2), (1.0, 10.0, 3.25))
        assert exx.u is not None
        np.testing.assert_array_equal(exx.u, [np.nan, 0.01, 0.02])
        assert found.motion_errors["EYX"] == TableCurve((0.0, 10.0), (0.0, 7.0))
        assert found.motion_errors["EZX"] is self.GIVEN.motion_errors["EZX"]
        assert found.motion_errors["EAX"] is self.CHANGE.motion_errors["EAX"]

    def test_what_is_open_is_not_said_to_be_of_least_norm(self) -> None:
        (left,) = changed(self.GIVEN, self.CHANGE, ["kept", "moved"]).undetermined
        assert left.parameters == ("moved", "EAX")
        assert left.combination.startswith("moved and EAX: not settled by the readings, as near to what was given")


GIVEN = ErrorValues(
    machine="dmu60p",
    parameters=PARAMETERS,
    motion_errors={
        name: PolynomialCurve(powers=(1, 2, 3), coefficients=tuple(one.values()))
        for name, one in coefficients().items()
    },
)
SHIFT = {"p1": 3e-6, "p3": -8e-12}  # by which EXX has changed: 1.3 um at most


def worn() -> Generator:
    """The machine of GIVEN with another EXX."""
    exx = {power: value + SHIFT.get(power, 0.0) for power, value in coefficients()["EXX"].items()}
    return dmu60p({**cubic_errors(), "EXX": polynomial(**exx)})


def change_of(found: ErrorValues, name: str) -> FloatArray:
    """Of a component, over its travel, um; of a rotation what it moves at 1 m."""
    x = np.linspace(0.0, TRAVEL[name[2]], 40)
    change = found.motion_errors[name](x) - GIVEN.motion_errors[name](x)
    return np.asarray(change * (1e3 if name[1] in "XYZ" else 1e6))


class TestReidentified:
    MODEL = load_model(DMU60P, None, ROOT / "generated")
    RUNS = paper_runs()
    X = np.linspace(0.0, TRAVEL["X"], 40)
    WANTED = 1e3 * (SHIFT["p1"] * X + SHIFT["p3"] * X**3)

    def test_only_what_the_readings_hold_changes(self) -> None:
        # lines of X that sense X at three levers: EXX, EBX and ECX, nothing else
        runs = [run for run in self.RUNS if moving(run) == "X"]
        found, _, _ = reidentified(self.MODEL, GIVEN, observed(worn(), runs, [line("X", 15) for _ in runs]))
        for name in GIVEN.motion_errors:
            wanted = self.WANTED if name == "EXX" else np.zeros(40)
            np.testing.assert_allclose(change_of(found, name), wanted, rtol=0.0, atol=0.02)
        assert found.parameters == pytest.approx(PARAMETERS, abs=1e-9)
        (left,) = [one for one in found.undetermined if "EZY" in one.parameters]
        assert "not settled by the readings" in left.combination

    def test_values_that_are_right_stay(self) -> None:
        data = observed(dmu60p(cubic_errors()), self.RUNS, [line(moving(run), 9) for run in self.RUNS])
        found, _, _ = reidentified(self.MODEL, GIVEN, data)
        for name in GIVEN.motion_errors:
            np.testing.assert_allclose(change_of(found, name), 0.0, atol=1e-4)
        assert found.parameters == pytest.approx(PARAMETERS, abs=1e-9)

    @pytest.mark.parametrize("seed", [1, 2, 3])
    def test_zeros_of_instruments_and_noise_are_no_errors_of_the_machine(self, seed: int) -> None:
        """Every run has a zero of its own, 3 um, twice the change: what stays right stays, what changed is found."""
        draw = np.random.default_rng(seed)
        data = observed(worn(), self.RUNS, [line(moving(run), 25) for run in self.RUNS])
        zeros = draw.normal(0.0, 3e-3, len(self.RUNS))[data.run]
        reading = data.reading + zeros + draw.normal(0.0, 2e-4, data.reading.size)
        found, table, fit = reidentified(self.MODEL, GIVEN, replace(data, reading=reading))
        assert fit is not None
        assert fit.state == "converged"
        (exx,) = [one for one in table if one.name == "EXX"]
        assert exx.determined in ("data", "partly")
        assert exx.change == pytest.approx(1e-3 * self.WANTED[-1], abs=3.0 * exx.u)
        assert abs(exx.given) == pytest.approx(np.abs(GIVEN.motion_errors["EXX"](self.X)).max(), rel=0.02)
        left = change_of(found, "EXX") - self.WANTED
        assert np.sqrt(np.mean(left**2)) < 0.5 * np.sqrt(np.mean(self.WANTED**2))
        for name in ("EYY", "EZZ", "EYX", "EXZ"):
            assert np.abs(change_of(found, name)).max() < 1.0


def test_a_run_whose_sign_is_reversed_is_no_cause_of_its_instrument() -> None:
    """A laser cosine of 13 mrad was named, marked as certain: reversed, a line looks like another scale of its own."""
    plan = Design(lines=2, repeats=2, targets=9, samples=24, feeds=(1000.0,))
    given = prepared(Case(seed=1, design=plan, noise="white", given="exact"))
    (index, *_) = (k for k, run in enumerate(given.data.setup.runs) if run.instrument == "laser")
    run = given.data.setup.runs[index].id
    readings = given.data.readings
    reversed_ = np.where(readings.run == index, -1.0, 1.0) * readings.reading
    wrong = replace(given.data, readings=replace(readings, reading=reversed_))

    def misfits(data: MeasuredData, effect: Effect) -> tuple[str, ...]:
        everything = np.arange(readings.reading.size)
        found = diagnosis("explained")
        found = replace(found, causes=(cause(effect),), residuals=replace(found.residuals, row=everything))
        return identified_anew(given.model, data, found, lambda _: given.model).misfits

    cosine = Effect(kind="laser_cosine", runs=(run,))
    assert run in misfits(wrong, cosine)
    assert misfits(given.data, cosine) == ()


def test_two_runs_whose_readings_are_swapped_are_told_beside_right_values() -> None:
    """They looked like noise beside changes that are none; `identify` tells them, of the readings as they are."""
    plan = Design(lines=3, repeats=2, targets=11, samples=24, feeds=(1000.0,))
    given = prepared(Case(3, design=plan, given="exact", curvature=6.0))
    readings, swapped = given.data.readings, ("X1-1", "X2-1")
    one, other = (readings.run == readings.run_ids.index(name) for name in swapped)
    values = readings.reading.copy()
    values[one], values[other] = readings.reading[other], readings.reading[one]
    found = diagnosis("no_discrepancy")
    found = replace(found, residuals=replace(found.residuals, row=np.arange(values.size)))

    def misfits(data: MeasuredData) -> tuple[str, ...]:
        return identified_anew(given.model, data, found, lambda _: given.model).misfits

    assert set(misfits(replace(given.data, readings=replace(readings, reading=values)))) == set(swapped)
    assert misfits(given.data) == ()


TURNING = LegendreCurve(
    basis=travel_basis((-360.0, 360.0), 3, 2), coefficients=(1e-3, -2e-3, 5e-4, 3e-3, 1e-3, 0, 2e-3)
)


@pytest.mark.parametrize(
    ("given", "form", "near"),
    [
        (PolynomialCurve(powers=(1, 5), coefficients=(1e-5, 1e-15)), LegendreCurve, 1e-14),
        (LegendreCurve(basis=travel_basis((-360.0, 360.0), 5), coefficients=(1e-3,) * 5), LegendreCurve, 1e-14),
        (replace(TURNING, basis=travel_basis((-360.0, 360.0), 1, 3)), LegendreCurve, 1e-14),
        # not zero at home: a table of every degree, straight between
        (PolynomialCurve(powers=(0, 1), coefficients=(1e-3, 1e-5)), TableCurve, 1e-6),
    ],
)
def test_curves_with_harmonics_are_added(given: Curve, form: type[Curve], near: float) -> None:
    before, change = (ErrorValues(machine="m", motion_errors={"EXC": curve}) for curve in (given, TURNING))
    total = changed(before, change, []).motion_errors["EXC"]
    at = np.linspace(-360.0, 360.0, 97)
    assert isinstance(total, form)
    np.testing.assert_allclose(total(at), given(at) + TURNING(at), atol=near)
