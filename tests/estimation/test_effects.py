"""Effects as unknowns of the estimate, against readings of the independent generator with terms by hand."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.diagnosis.prepared import SMALL, prepared
from tests.generator.dmu60p import PARAMETERS, cubic_errors
from tests.hidden_effects.case import Case
from tests.hidden_effects.hidden import Hidden
from tests.identification.data import with_estimation
from tests.identification.effect_data import SIGMA, Row, Term, five_axis, measured, model_with, plan
from tests.kernels import kernels_of
from tests.machines import machine_of
from trueaxis.effects.kind import Effect
from trueaxis.estimation.effects import start as start_module
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.giving_way import giving_way
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.observations import Observations, observations
from trueaxis.estimation.runs import measured_runs
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.identification.paper.method import identify_paper
from trueaxis.identification.paper.solution import PaperOptions
from trueaxis.identification.report import Identification
from trueaxis.identification.report_text import report_text
from trueaxis.io.faults import InputError
from trueaxis.measurement.readings import Readings
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.curves import Curve, PolynomialCurve
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues, dump_errors, read_errors
from trueaxis.model.kernels import Kernels
from trueaxis.model.model import MachineModel

KNOWN = ErrorValues(machine="dmu60p", parameters=PARAMETERS)
OPTIONS = IdentifyOptions("known", KNOWN)
VALUES_ALONE = pytest.mark.usefixtures("values_alone")
BACKLASH, THERMAL, LAG = (
    Effect(kind="backlash", component="EXX"),
    Effect(kind="thermal_expansion", component="EYY"),
    Effect(kind="servo_lag", component="EXX"),
)
CYCLIC, WARM = Effect(kind="cyclic", component="EZZ"), Effect(kind="warm_up", component="EXX")
COSINE, LENGTH, LOBES = (
    Effect(kind="laser_cosine", runs=("X-1",)),
    Effect(kind="ballbar_length"),
    Effect(kind="ballbar_lobes"),
)


def expansion(row: Row) -> float:
    return 1.1e-5 * row.at["Y"] * (row.temperature - 20.0)


def cyclic(row: Row) -> float:
    return 2e-3 * float(np.cos(2.0 * np.pi * row.at["Z"] / 13.7 + 1.0))


def values_of(found: Identification, effect: Effect) -> Mapping[str, float]:
    return next(one.parameters for one in found.values.effects if one.effect == effect)


LINEAR: dict[str, tuple[Effect, dict[str, Term], list[Term], dict[str, float]]] = {
    "backlash": (BACKLASH, {"EXX": lambda row: 3e-3 * row.direction["X"]}, [], {"width": 6e-3}),
    "lateral play": (
        Effect(kind="backlash", component="EAZ"), {"EAZ": lambda row: 4e-6 * row.direction["Z"]}, [], {"width": 8e-6},
    ),
    "thermal": (THERMAL, {"EYY": expansion}, [], {"coefficient": 1.1e-5}),
    "lag": (LAG, {"EXX": lambda row: -1e-4 * row.velocity["X"]}, [], {"tau": 1e-4}),
    "cross": (
        Effect(kind="cross_axis", component="EZX", axis="Z"),
        {"EZX": lambda row: 5e-3 * row.at["X"] / 540.0 * (row.at["Z"] / 600.0) ** 2},
        [],
        {"k": 5e-3},
    ),
    "length": (LENGTH, {}, [lambda row: 3e-3 if row.run.length else 0.0], {"length": 3e-3}),
    "angle": (COSINE, {}, [lambda row: -0.5 * 4e-3**2 * row.along if row.run.id == "X-1" else 0.0], {"angle": 4e-3}),
    "lobes": (
        LOBES,
        {},
        [lambda row: 2e-3 * float(np.cos(3.0 * row.theta - 2.0)) if row.run.length else 0.0],
        {"amplitude": 2e-3, "phase": -2.0},
    ),
}  # fmt: skip


def off_by(found: Identification, effect: Effect, truth: Mapping[str, float]) -> list[float]:
    """By how many standard uncertainties each parameter is off."""
    (one,) = (each for each in found.values.effects if each.effect == effect)
    return [abs(one.parameters[name] - value) / one.u[name] for name, value in truth.items()]


def small(found: Identification, effect: Effect, share: float) -> bool:
    """Whether every uncertainty is below a share of its value."""
    (one,) = (each for each in found.values.effects if each.effect == effect)
    return all(one.u[name] < share * abs(value) for name, value in one.parameters.items())


def test_effects_that_are_linear_in_their_amplitudes_come_back_with_the_curves() -> None:
    components: dict[str, Term] = {}
    for _, terms, _, _ in LINEAR.values():
        components |= terms
    readings = [term for _, _, terms, _ in LINEAR.values() for term in terms]
    effects = [effect for effect, _, _, _ in LINEAR.values() if effect != LAG]  # EXX has a backlash already
    components["EXX"] = LINEAR["backlash"][1]["EXX"]
    found = identify_estimated(model_with(*effects), measured(components, readings, seed=1), OPTIONS)
    for effect, _, _, truth in LINEAR.values():
        if effect != LAG:
            assert max(off_by(found, effect, truth)) < 4.0, effect.label
            assert small(found, effect, 0.35), effect.label
    assert [one.effect for one in found.values.effects] == effects
    assert found.report.quality.fit.state == "converged"  # and no run is taken for a misread one
    curves = cubic_errors()
    for name in ("EXX", "EYY", "EZZ"):
        at = np.linspace(0.0, 500.0, 11)
        expected = np.array([float(curves[name](s)) for s in at])
        assert np.abs(found.values.motion_errors[name](at) - expected).max() < 5.0 * SIGMA
    told = report_text(found.report)
    assert "lobes" in told
    assert "backlash EXX: width 5." in told or "backlash EXX: width 6" in told


@VALUES_ALONE
def test_a_lag_is_told_by_the_feeds() -> None:
    effect, components, _, truth = LINEAR["lag"]
    found = identify_estimated(model_with(effect), measured(components, seed=2), OPTIONS)
    assert max(off_by(found, effect, truth)) < 4.0
    assert small(found, effect, 0.05)


@VALUES_ALONE
def test_a_period_and_a_time_constant_are_found_wherever_they_are() -> None:
    warm = {"EXX": lambda row: 8e-3 * row.at["X"] / 540.0 * float(np.exp(-row.time / 900.0))}
    data = measured({"EZZ": cyclic, **warm}, seed=3)
    found = identify_estimated(model_with(CYCLIC, WARM), data, OPTIONS)
    assert max(off_by(found, CYCLIC, {"amplitude": 2e-3, "phase": 1.0, "pitch": 13.7})) < 4.0
    assert max(off_by(found, WARM, {"amplitude": 8e-3, "tau": 900.0})) < 4.0
    assert small(found, CYCLIC, 0.1)
    assert small(found, WARM, 0.3)


@VALUES_ALONE
def test_the_moment_of_a_jump_lies_between_the_readings_beside_it() -> None:
    effect = Effect(kind="laser_step", runs=("Z-8",))
    clean = measured(seed=4)
    mine = np.flatnonzero(np.array([clean.runs[index].id == "Z-8" for index in clean.run]))
    assert clean.context is not None
    before, after = clean.context.time[mine[5]], clean.context.time[mine[6]]
    reading = clean.reading.copy()
    reading[mine[6:]] += 5e-3
    found = identify_estimated(model_with(effect), replace(clean, reading=reading), OPTIONS)
    values = values_of(found, effect)
    assert abs(values["jump"] - 5e-3) < 4.0 * found.values.effects[0].u["jump"]
    assert before < values["t_0"] <= after
    assert np.isnan(found.values.effects[0].u["t_0"])


@VALUES_ALONE
def test_the_instrument_gives_way_where_an_effect_is_the_same() -> None:
    data = measured({}, LINEAR["length"][2], seed=5)
    model = model_with(LENGTH)
    found = estimate(model, data, KNOWN)
    assert "ballbar length" not in {one.kind for one in found.layout.shared}
    assert "ballbar centre" in {one.kind for one in found.layout.shared}
    written = identify_estimated(model, data, OPTIONS)
    assert max(off_by(written, LENGTH, {"length": 3e-3})) < 4.0
    assert small(written, LENGTH, 0.2)


@VALUES_ALONE
def test_a_point_that_is_off_is_told_from_the_rotations_that_other_lines_give() -> None:
    effect = Effect(kind="point_offset", runs=("X-2",))
    quiet = measured(moved={"X-2": (0.0, 4.0, -6.0)})
    data = replace(quiet, reading=quiet.reading + np.random.default_rng(6).normal(0.0, 2e-6, quiet.reading.size))
    found = identify_estimated(model_with(effect), data, OPTIONS)
    assert max(off_by(found, effect, {"y": 4.0, "z": -6.0})) < 4.0
    assert found.values.effects[0].u["y"] < 8.0
    assert np.isnan(found.values.effects[0].u["x"])  # along the line: no reading holds it
    assert found.report.effects[0].origin == "partly undetermined"


@VALUES_ALONE
def test_what_is_known_stays_fixed() -> None:
    model = model_with(BACKLASH, THERMAL)
    data = measured({"EXX": lambda row: 3e-3 * row.direction["X"], "EYY": expansion}, seed=7)
    known = replace(KNOWN, effects=(EffectValues(THERMAL, {"coefficient": 1.1e-5}),))
    found = identify_estimated(model, data, replace(OPTIONS, known=known))
    assert values_of(found, THERMAL) == {"coefficient": 1.1e-5}
    assert max(off_by(found, BACKLASH, {"width": 6e-3})) < 4.0
    assert [one.origin for one in found.report.effects] == ["from the readings", "given"]


@VALUES_ALONE
def test_the_covariance_holds_the_parameters_of_effects() -> None:
    found = identify_estimated(model_with(BACKLASH, CYCLIC), measured({"EZZ": cyclic}, seed=8), OPTIONS)
    covariance = found.covariance
    assert covariance.effects == (BACKLASH.label, CYCLIC.label)
    u = np.sqrt(np.diag(covariance.matrix))[-4:]
    told = [*found.values.effects[0].u.values(), *found.values.effects[1].u.values()]
    assert u == pytest.approx(told, rel=1e-12)


def squareness(angle: float) -> tuple[MachineModel, Observations]:
    """A table mill whose spec leaves out that X is not square to Y, and tells it by an effect; exact readings."""
    given = prepared(Case(1, design=SMALL, effects=(Hidden("squareness", "EC0X", size=angle),), noise="none"))
    text = f'{given.generated.spec}\n[[effect]]\nkind = "squareness"\ncomponent = "EC0X"\n'
    module = kernels_of(text)
    kernels = Kernels(
        meta=module.META,
        module=module,
        routines={n: getattr(module, n) for n in module.META["routines"]},
        backend="numpy",
        note="",
    )
    model = MachineModel(machine_of(text), kernels, ErrorValues(machine=given.model.name))
    return model, observations("readings.csv", given.data.setup.runs, given.data.readings)


def at_home(model: MachineModel, *known: EffectValues) -> IdentifyOptions:
    given = prepared(Case(1, design=SMALL, effects=(Hidden("squareness", "EC0X"),), noise="none")).model.errors
    dimensions = {name: given.parameters[name] for name in model.dimensions}
    return IdentifyOptions(known=ErrorValues(machine=model.name, parameters=dimensions, effects=known))


@VALUES_ALONE
def test_a_squareness_is_told_once_and_as_the_location_error_that_it_is(tmp_path: Path) -> None:
    """As of a machine whose spec names that location error, and says nothing of an effect."""
    model, data = squareness(3e-5)
    values = identify_estimated(model, data, at_home(model)).values
    named = replace(model, machine=replace(model.machine, effects=()))
    assert "EC0X" in named.location_errors
    alone = identify_estimated(named, data, at_home(model)).values
    assert values.effects == ()
    assert values.parameters == pytest.approx(alone.parameters, rel=1e-9)
    file = tmp_path / "errors.json"
    components, parameters, effects = model.components, model.parameters, model.effects
    file.write_text(dump_errors(values, components=components, parameters=parameters, effects=effects))
    again = read_errors(
        file, machine=model.name, components=components, parameters=parameters, effects=effects, kinds=model.kinds
    )
    assert again.parameters == values.parameters


@VALUES_ALONE
def test_a_squareness_that_is_known_as_an_effect_stays() -> None:
    model, data = squareness(3e-5)
    (effect,) = model.effects
    options = at_home(model, EffectValues(effect, {"angle": 2e-5}))
    values = identify_estimated(model, data, options).values
    assert (values.parameters["EC0X"], values.effects) == (2e-5, ())


@VALUES_ALONE
def test_a_start_spares_the_search(monkeypatch: pytest.MonkeyPatch) -> None:
    def no_search(*_: object) -> None:
        pytest.fail("searched")

    monkeypatch.setattr(start_module, "searched_start", no_search)
    start = EffectValues(CYCLIC, {"amplitude": 1e-3, "phase": 0.5, "pitch": 13.72})
    found = identify_estimated(
        model_with(CYCLIC), measured({"EZZ": cyclic}, seed=9), with_estimation(OPTIONS, start=(start,))
    )
    assert max(off_by(found, CYCLIC, {"amplitude": 2e-3, "phase": 1.0, "pitch": 13.7})) < 4.0


@VALUES_ALONE
def test_a_negative_square_is_zero() -> None:
    data = measured({}, [lambda row: 0.5 * 4e-3**2 * row.along if row.run.id == "X-1" else 0.0], seed=10)
    found = identify_estimated(model_with(COSINE), data, OPTIONS)
    assert values_of(found, COSINE) == {"angle": 0.0}
    assert found.report.effects[0].origin.startswith("zero")


@VALUES_ALONE
def test_outliers_lead_no_effect_astray() -> None:
    data = measured({"EXX": lambda row: 3e-3 * row.direction["X"], "EZZ": cyclic}, seed=3)
    spoilt = data.reading.copy()
    spoilt[::97] += 0.02
    start = EffectValues(CYCLIC, {"amplitude": 1e-3, "phase": 0.5, "pitch": 13.72})
    options = with_estimation(OPTIONS, start=(start,))
    found = identify_estimated(model_with(BACKLASH, CYCLIC), replace(data, reading=spoilt), options)
    assert max(off_by(found, BACKLASH, {"width": 6e-3})) < 4.0
    assert max(off_by(found, CYCLIC, {"amplitude": 2e-3, "pitch": 13.7})) < 4.0


@VALUES_ALONE
@pytest.mark.slow
def test_the_uncertainty_covers_the_scatter() -> None:
    components: dict[str, Term] = {"EXX": lambda row: 3e-3 * row.direction["X"], "EZZ": cyclic}
    clean, model = measured(components), model_with(BACKLASH, CYCLIC)
    truth = {"width": 6e-3, "amplitude": 2e-3, "phase": 1.0, "pitch": 13.7}
    ratios: dict[str, list[float]] = {name: [] for name in truth}
    start = EffectValues(CYCLIC, {"amplitude": 1e-3, "phase": 0.5, "pitch": 13.72})
    for seed in range(9):
        noise = np.random.default_rng(seed).normal(0.0, SIGMA, clean.reading.size)
        found = identify_estimated(
            model, replace(clean, reading=clean.reading + noise), with_estimation(OPTIONS, start=(start,))
        )
        for one in found.values.effects:
            for name, value in one.parameters.items():
                ratios[name].append((value - truth[name]) / one.u[name])
    for name, each in ratios.items():
        assert 0.5 < np.sqrt(np.mean(np.square(each))) < 1.6, name


@pytest.mark.parametrize(
    ("effect", "column"), [(THERMAL, "temperature"), (LAG, "feed"), (WARM, "time")], ids=["T", "v", "t"]
)
def test_a_column_that_is_missing_is_a_fault_at_once(effect: Effect, column: str) -> None:
    changes = {
        "temperature": lambda rows: replace(rows, temperature=None),
        "feed": lambda rows: replace(rows, feed=None, time=None),
        "time": lambda rows: replace(rows, time=None),
    }
    data = measured(change=changes[column])
    with pytest.raises(InputError) as caught:
        identify_estimated(model_with(effect), data, OPTIONS)
    (fault,) = caught.value.faults
    assert (
        fault.place
        == f"column {'temperature_c' if column == 'temperature' else 'time_s' if column == 'time' else 'feed'}"
    )
    assert effect.label in fault.problem


def test_the_paper_takes_known_effects_off_and_refuses_others() -> None:
    data = measured({"EXX": lambda row: 3e-3 * row.direction["X"]}, even=True)
    model = model_with(BACKLASH)
    with pytest.raises(InputError, match="--method global"):
        identify_paper(model, data, PaperOptions("known", KNOWN))
    effect = EffectValues(BACKLASH, {"width": 6e-3})
    found = identify_paper(model, data, PaperOptions("known", replace(KNOWN, effects=(effect,))))
    plain = identify_paper(model_with(), measured(even=True), PaperOptions("known", KNOWN))
    assert found.values.effects == (effect,)
    for name, curve in plain.values.motion_errors.items():
        at = np.linspace(0.0, 500.0, 7)
        assert found.values.motion_errors[name](at) == pytest.approx(curve(at), abs=1e-8)


@VALUES_ALONE
def test_lost_motion_of_a_rotary_axis_in_degrees_and_radians() -> None:
    """A table C: two displacement lines on it, there and back; the reading is radius x angle, by hand."""
    model = five_axis(Effect(kind="backlash", component="ECC"))
    width, point = 4e-5, (0.0, 150.0, 0.0)
    run = Run(
        id="C1",
        instrument="laser",
        target=PointOn("workpiece", point),
        reference=PointOn("bed"),
        frame="bed",
        home=dict.fromkeys(model.axes, 0.0),
        direction=(1.0, 0.0, 0.0),
    )
    turns = np.array([*range(5, 65, 5), *range(60, 0, -5)], dtype=float)
    positions = np.zeros((5, turns.size))
    positions[model.axes.index("C")] = turns
    direction = np.zeros((5, turns.size), dtype=np.int8)
    direction[model.axes.index("C")] = np.repeat([1, -1], [12, 12])
    # the table turns by -C (sense), its error by +ECC before it: x' = -y sin(ECC - C) with y = 150
    turned = np.radians(-turns)
    error = 0.5 * width * direction[model.axes.index("C")]
    reading = -150.0 * (np.sin(turned + error) - np.sin(turned))
    rows = Readings(
        axes=model.axes,
        run_ids=("C1",),
        run=np.zeros(24, dtype=np.int64),
        seq=np.arange(24),
        positions=positions,
        directions=direction,
        reading=reading,
        given_directions=model.axes,
    )
    given = ErrorValues(machine="five_axis", parameters=dict.fromkeys((*model.dimensions, *model.location_errors), 0.0))
    curves: dict[str, Curve] = {
        name: PolynomialCurve(powers=(), coefficients=()) for name in model.components if name != "ECC"
    }
    known = replace(given, motion_errors=curves)
    found = identify_estimated(model, observations("readings.csv", [run], rows), IdentifyOptions("known", known))
    assert found.values.effects[0].parameters["width"] == pytest.approx(width, rel=1e-3)
    assert found.report.effects[0].parameters[0].unit == "rad"


ZERO, BAR_ZERO = Effect(kind="reading_zero", runs=("X-1",)), Effect(kind="reading_zero", runs=("xy+1F500",))
SLOPE = Effect(kind="reading_slope", runs=("X-2",))


@VALUES_ALONE
def test_what_an_instrument_has_of_the_shape_gives_way_to_zeros_and_slopes_of_runs() -> None:
    """Else a zero is as uncertain as that of any laser, 3 um."""
    data = measured(
        {},
        [
            lambda row: 40e-3 if row.run.id == "X-1" else 0.0,
            lambda row: -15e-3 if row.run.id == "xy+1F500" else 0.0,
            lambda row: 3e-4 * row.at["X"] if row.run.id == "X-2" else 0.0,
        ],
        seed=11,
    )
    found = identify_estimated(model_with(ZERO, BAR_ZERO, SLOPE), data, OPTIONS)
    for effect, truth in (ZERO, {"zero": 40e-3}), (BAR_ZERO, {"zero": -15e-3}), (SLOPE, {"slope": 3e-4}):
        assert max(off_by(found, effect, truth)) < 4.0
        assert small(found, effect, 0.03)
    assert found.values.effects[0].u["zero"] < 1e-3


def silenced(*effects: Effect) -> dict[str, tuple[int, ...]]:
    """Own unknowns that give way, by run; X-3 is made a run of straightness."""
    data, model = measured(), model_with(*effects)
    runs = tuple(replace(run, direction=(0.0, 1.0, 0.0)) if run.id == "X-3" else run for run in data.runs)
    data = replace(data, runs=runs)
    unknowns = start_module.sought_effects(model, data, KNOWN).at_once
    layout = giving_way(layout_of(model, data, KNOWN, unknowns), measured_runs(data))
    return {runs[index].id: columns for index, columns in layout.silent.items()}


def test_an_unknown_of_a_run_gives_way_to_an_effect_of_that_run_alone() -> None:
    assert silenced(BACKLASH) == {}
    assert silenced(ZERO, BAR_ZERO, SLOPE) == {"X-1": (0,), "xy+1F500": (0,)}
    of_straightness = [Effect(kind=kind, runs=("X-3",)) for kind in ("reading_zero", "reading_slope")]
    assert silenced(*of_straightness) == {"X-3": (0, 2)}
    assert silenced(Effect(kind="reading_zero", runs=("X-1", "X-2"))) == {}
    assert silenced(Effect(kind="reading_zero", runs=("X-1", "X-2")), ZERO) == {"X-1": (0,)}


def since_reversals() -> dict[float, tuple[float, float]]:
    """Of X, by the time of the reading: time and way of X and Y and Z together since the reading before it turned."""
    runs, rows = plan()
    assert rows.time is not None
    found = {}
    for index, run in enumerate(runs):
        way, turn = 0.0, None if run.length else (np.inf, 0.0)
        before = None
        for n in np.flatnonzero(rows.run == index):
            here, at, sense = float(rows.time[n]), rows.positions[:, n], float(rows.directions[0, n])
            if before is not None:
                if sense * before[2] < 0.0:
                    turn = (before[0], way)
                way += float(np.linalg.norm(at - before[1]))
            before = (here, at, sense or (before[2] if before else 0.0))
            passed = np.inf if turn is None or np.isinf(turn[0]) else here - turn[0]
            found[here] = passed, np.inf if turn is None else way - turn[1]
    return found


@VALUES_ALONE
@pytest.mark.parametrize(
    ("kind", "name", "truth"),
    [("path", "decay", 150.0), pytest.param("time", "tau", 20.0, marks=pytest.mark.slow)],
)
def test_a_spike_over_time_or_path_comes_back(kind: str, name: str, truth: float) -> None:
    """Four times what the grid ends with: before the first reversal nothing has passed that a grid could go by."""
    since, effect = since_reversals(), Effect(kind=f"reversal_spike_{kind}", component="EXX")

    def spike(row: Row) -> float:
        time, way = since.get(row.time, (0.0, 0.0))
        return 0.01 * row.direction["X"] * float(np.exp(-(way if kind == "path" else time) / truth))

    data = measured({"EXX": spike}, seed=13)
    some = np.array([kind == "time" or run.id.startswith(("X-", "xy")) for run in data.runs])[data.run]
    found = estimate(model_with(effect), data.of(np.flatnonzero(some)), KNOWN)
    assert found.iteration.converged
    u = np.linalg.norm(found.spread[found.layout.of_effects], axis=1)
    assert (u < 0.2 * np.array([0.01, truth])).all()
    for of, value, each in zip(("height", name), (0.01, truth), u, strict=True):
        assert abs(found.values.effects[0].parameters[of] - value) < 4.0 * each
