"""Values found anew change where the readings say so, and nowhere else."""

from dataclasses import replace

import numpy as np
import pytest

from tests.diagnose.prepared import SMALL, prepared
from tests.diagnose.report.builders import cause, diagnosis
from tests.generator.dmu60p import PARAMETERS, coefficients, cubic_errors, dmu60p
from tests.generator.machine import polynomial
from tests.hidden_effects.case import Case
from tests.identify.data import TRAVEL, line, moving, observed, paper_runs
from tests.machines import DMU60P, ROOT
from trueaxis.diagnose.extend import changed, kept_readings, named_effects, reidentified, start_values
from trueaxis.diagnose.result import Evidence, NoiseOf, Verdict
from trueaxis.diagnose.temperature import smoothed
from trueaxis.effects.kind import Effect
from trueaxis.runtime.curves import PolynomialCurve, TableCurve
from trueaxis.runtime.errors import ErrorValues, Undetermined
from trueaxis.runtime.model import load_model

NOISE = (NoiseOf("laser", 3e-4, 0.0, 0.0, 0.0, 100, "given"),)


class TestNamed:
    RIVAL = Evidence(Effect("servo_lag", "EXX"), 5.0, 1e-6, 1.0, 100)

    def test_causes_that_were_named_extend_the_machine(self) -> None:
        causes = (cause(Effect("backlash", "EXX")), cause(Effect("drift", "EYY"), rivals=(self.RIVAL,)))
        found = replace(diagnosis("ambiguous"), causes=causes)
        assert named_effects(found) == (Effect("backlash", "EXX"),)
        assert named_effects(replace(found, verdict="explained", causes=causes[:1])) == (Effect("backlash", "EXX"),)

    @pytest.mark.parametrize("verdict", ["no_discrepancy", "recalibrate", "unexplained_structure"])
    def test_nothing_does_where_nothing_was_named(self, verdict: Verdict) -> None:
        found = replace(diagnosis("explained"), verdict=verdict, causes=(cause(Effect("backlash", "EXX")),))
        assert named_effects(found) == ()

    def test_the_fit_starts_at_what_the_diagnosis_found(self) -> None:
        found = replace(diagnosis("explained"), causes=(cause(Effect("backlash", "EXX")),))
        (one,) = start_values(found)
        assert one.effect == Effect("backlash", "EXX")
        assert one.parameters == {each.name: each.value for each in found.causes[0].parameters}
        assert one.parameters.keys() == {"width"}


def test_readings_are_those_that_were_taken_less_what_instruments_added_and_without_flicker() -> None:
    given = prepared(Case(seed=1, design=SMALL, noise="none", given="exact"))
    rows = given.rows.only(given.rows.run != 0)
    found = diagnosis("explained")
    added = np.linspace(1e-3, 2e-3, rows.size)
    residuals = replace(found.residuals, row=rows.row, of_instruments=added)
    observed = kept_readings(given.data, replace(found, residuals=residuals), "here")
    assert observed.context is not None
    order = np.argsort(rows.row)
    np.testing.assert_allclose(observed.reading, (rows.reading - added)[order], rtol=0.0, atol=1e-15)
    temperature = smoothed(given.data).readings.temperature
    assert temperature is not None
    np.testing.assert_array_equal(observed.context.temperature, temperature[np.sort(rows.row)])


class TestChanged:
    GIVEN = ErrorValues(
        "m",
        parameters={"q": 5.0, "kept": 1e-5, "moved": 2e-5},
        motion_errors={
            "EXX": PolynomialCurve((0, 2), (1.0, 3.0), (0.5, 0.5)),
            "EYX": TableCurve((0.0, 10.0), (0.0, 2.0), (0.1, 0.1)),
            "EZX": PolynomialCurve((1,), (7.0,)),
        },
        u={"kept": 1e-7, "moved": 1e-7},
    )
    CHANGE = ErrorValues(
        "m",
        parameters={"q": 5.0, "moved": 1e-6},
        motion_errors={
            "EXX": PolynomialCurve((1, 2), (10.0, 0.25), (0.01, 0.02)),
            "EYX": PolynomialCurve((1,), (0.5,), (0.01,)),
            "EAX": PolynomialCurve((1,), (9.0,), (0.03,)),
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


class TestReidentified:
    # what is open at the stated noise does not change: 50 nm of what did, a sixth of the noise
    @pytest.mark.parametrize(("noise", "close"), [(NOISE, 5e-5), ((), 2e-8)])
    def test_only_what_the_readings_hold_changes(self, noise: tuple[NoiseOf, ...], close: float) -> None:
        # lines of X that sense X at three levers: EXX, EBX and ECX, nothing else
        shift = {"p1": 3e-6, "p3": -8e-12}
        terms = coefficients()
        true = {**cubic_errors(), "EXX": polynomial(**{p: v + shift.get(p, 0.0) for p, v in terms["EXX"].items()})}
        runs = [run for run in paper_runs() if moving(run) == "X"]
        data = observed(dmu60p(true), runs, [line("X", 15) for _ in runs])
        given = ErrorValues(
            "dmu60p",
            PARAMETERS,
            {name: PolynomialCurve((1, 2, 3), tuple(one.values())) for name, one in terms.items()},
        )
        model = load_model(DMU60P, None, ROOT / "generated")
        found = reidentified(model, given, data, noise)
        at = {axis: np.linspace(0.0, high, 40) for axis, high in TRAVEL.items()}
        for name, old in given.motion_errors.items():
            x = at[name[2]]
            wanted = old(x) + (3e-6 * x - 8e-12 * x**3 if name == "EXX" else 0.0)
            lever = 1.0 if name[1] in "XYZ" else 1e3
            np.testing.assert_allclose(found.motion_errors[name](x) * lever, wanted * lever, rtol=0.0, atol=close)
        assert found.parameters == pytest.approx(PARAMETERS, abs=1e-12)
        assert "EZX" in {name for left in found.undetermined for name in left.parameters}
        spread = found.motion_errors["EXX"].u
        assert spread is not None
        # beside the stated noise the other rotations of X are open, as large as expected: then nothing is said of EXX
        assert np.isfinite(spread).all() != bool(noise)

    def test_values_that_are_right_stay(self) -> None:
        data = observed(dmu60p(cubic_errors()), paper_runs(), [line(moving(run), 9) for run in paper_runs()])
        given = ErrorValues(
            "dmu60p",
            PARAMETERS,
            {name: PolynomialCurve((1, 2, 3), tuple(one.values())) for name, one in coefficients().items()},
        )
        found = reidentified(load_model(DMU60P, None, ROOT / "generated"), given, data, NOISE)
        for name, old in given.motion_errors.items():
            x = np.linspace(0.0, TRAVEL[name[2]], 30)
            lever = 1.0 if name[1] in "XYZ" else 1e3
            np.testing.assert_allclose(found.motion_errors[name](x) * lever, old(x) * lever, rtol=0.0, atol=1e-8)
        assert found.parameters == pytest.approx(PARAMETERS, abs=1e-11)
