"""The machine model with effects: what they add to component errors, in a context and without one."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tests.measurement.effect_machine import TRAVEL, write_machine
from trueaxis.effects.kind import Effect
from trueaxis.model.context import Context, ReadingContext
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.effect_terms import component_term, reading_term
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, load_model

AT = np.array([[10.0, 200.0, -50.0], [0.0, 5.0, 7.0], [1.0, 2.0, 3.0]])
TOOL = np.zeros((3, 1))
CURVES = {"EXX": PolynomialCurve(powers=(1,), coefficients=(1e-5,))}
BACKLASH = EffectValues(Effect(kind="backlash", component="EXX"), {"width": 4e-3})
COUPLED = EffectValues(Effect(kind="cross_axis", component="EXX", axis="Y"), {"k": 1e-3})
DRIFT = EffectValues(Effect(kind="drift", component="EXX"), {"rate": 1e-6})
SQUARENESS = EffectValues(Effect(kind="squareness", component="EC0Y"), {"angle": 1e-5})


@pytest.fixture(scope="module", params=["numpy", "c"])
def model(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> MachineModel:
    spec = write_machine(tmp_path_factory.mktemp("machine"))
    return load_model(spec, None, spec.parent / "generated", backend=request.param)


def with_effects(model: MachineModel, *effects: EffectValues) -> MachineModel:
    return model.with_values(ErrorValues(machine="test", parameters={}, motion_errors=CURVES, effects=effects))


def context(**columns: Any) -> Context:
    return replace(Context.at_rest(3, 3), **columns)


def test_a_term_is_added_to_the_curve_of_its_component_in_every_view(model: MachineModel) -> None:
    plain, found = with_effects(model), with_effects(model, BACKLASH)
    found = found.in_context(context(directions=np.array([[1.0, -1, 0], [1, 1, 1], [1, 1, 1]])))
    by_hand = np.zeros((len(model.components), 3))
    by_hand[model.components.index("EXX")] = [2e-3, -2e-3, 0.0]
    np.testing.assert_allclose(found.component_errors(AT) - plain.component_errors(AT), by_hand, rtol=0, atol=1e-17)
    for view in ("tool_in_workpiece", "tool_in_bed"):  # the former of curves alone, unless there are effects
        moved = found.view_deviation(view, AT, TOOL) - plain.view_deviation(view, AT, TOOL)
        np.testing.assert_allclose(moved, np.array([[2e-3, -2e-3, 0.0], [0.0] * 3, [0.0] * 3]), rtol=0, atol=1e-17)


def test_without_a_context_axes_stand_and_positions_still_count(model: MachineModel) -> None:
    row = model.components.index("EXX")
    moving = [BACKLASH, DRIFT, EffectValues(Effect(kind="servo_lag", component="EXX"), {"tau": 1.0})]
    moving += [EffectValues(Effect(kind="thermal_expansion", component="EXX"), {"coefficient": 1.0})]
    moving += [EffectValues(Effect(kind="reversal_spike", component="EXX"), {"height": 1.0, "decay": 1.0})]
    found = with_effects(model, *moving, COUPLED).component_errors(AT)[row]
    x, y = ((AT[index] - TRAVEL[0]) / (TRAVEL[1] - TRAVEL[0]) for index in (0, 1))
    np.testing.assert_allclose(found, 1e-5 * AT[0] + 1e-3 * x * y**2, rtol=1e-13)


def test_what_the_context_does_not_know_is_unknown_in_that_row_alone(model: MachineModel) -> None:
    time = np.array([0.0, np.nan, 5.0])
    found = with_effects(model, BACKLASH, DRIFT).in_context(context(time=time)).component_errors(AT)
    row = model.components.index("EXX")
    assert np.isnan(found[row]).tolist() == [False, True, False]
    assert np.isfinite(np.delete(found, row, axis=0)).all()


def test_a_step_at_an_unknown_time_is_unknown(model: MachineModel) -> None:
    step = Effect(kind="laser_step", runs=("X1",))
    nothing, time = np.full(3, np.nan), np.array([1.0, np.nan, 3.0])
    term = reading_term(
        model.kernels,
        model.machine,
        step,
        np.array([0.5, 2.0]),
        ReadingContext(along=nothing, theta=nothing, way=nothing, time=time, temperature=nothing),
    )
    np.testing.assert_array_equal(term[0], [0.0, np.nan, 0.5])


def test_before_the_first_reversal_a_spike_and_its_derivatives_are_zero(model: MachineModel) -> None:
    spike = Effect(kind="reversal_spike", component="EXX")
    moved = context(directions=np.ones((3, 3)))
    term = component_term(model.kernels, model.machine, spike, np.array([1e-3, 5.0]), AT, moved)
    assert term.shape == (3, 3)
    assert not term.any()


@pytest.mark.parametrize("kind", ["reversal_spike_time", "reversal_spike_path"])
def test_spikes_over_time_and_path_take_what_has_passed_of_it(model: MachineModel, kind: str) -> None:
    passed = np.full((3, 3), np.inf)
    passed[0] = [0.0, 2.0, np.nan]
    name = "time_since" if kind == "reversal_spike_time" else "path_since"
    moved = context(directions=-np.ones((3, 3)), **{name: passed})
    term = component_term(
        model.kernels, model.machine, Effect(kind=kind, component="EXX"), np.array([1e-3, 4.0]), AT, moved
    )
    np.testing.assert_allclose(term[0], [-1e-3, -1e-3 * np.exp(-0.5), np.nan], rtol=1e-14)
    other = component_term(
        model.kernels, model.machine, Effect(kind=kind, component="EYY"), np.array([1e-3, 4.0]), AT, moved
    )
    assert not other.any()  # Y has not turned back


def reading_context(values: np.ndarray) -> ReadingContext:
    """Everything at the same values."""
    return ReadingContext(along=values, theta=values, way=values, time=values, temperature=values)


def test_what_a_term_does_not_use_may_be_unknown(model: MachineModel) -> None:
    nothing = reading_context(np.full(3, np.nan))
    zero = Effect(kind="reading_zero", runs=("c",))
    np.testing.assert_array_equal(reading_term(model.kernels, model.machine, zero, np.array([2e-3]), nothing)[0], 2e-3)
    slope = Effect(kind="reading_slope", runs=("c",))
    assert np.isnan(reading_term(model.kernels, model.machine, slope, np.array([2e-3]), nothing)).all()


def test_a_context_is_of_as_many_positions(model: MachineModel) -> None:
    found = with_effects(model, DRIFT).in_context(context())
    with pytest.raises(ValueError, match="the context is of 3 positions, not 2"):
        found.component_errors(AT[:, :2])


def test_terms_of_another_place_are_refused(model: MachineModel) -> None:
    scale = Effect(kind="laser_scale")
    with pytest.raises(ValueError, match="laser_scale is no effect on a component"):
        component_term(model.kernels, model.machine, scale, np.zeros(1), AT, context())
    nothing = reading_context(np.zeros(3))
    with pytest.raises(ValueError, match="backlash EXX is no effect on a reading"):
        reading_term(model.kernels, model.machine, BACKLASH.effect, np.zeros(1), nothing)


def test_a_squareness_turns_the_axis_before_it_moves(model: MachineModel) -> None:
    found = with_effects(model, SQUARENESS).deviation(AT, TOOL) - with_effects(model).deviation(AT, TOOL)
    np.testing.assert_allclose(found, np.array([-1e-5 * AT[1], np.zeros(3), np.zeros(3)]), rtol=0, atol=1e-15)
