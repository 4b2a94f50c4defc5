"""Effects in an error-values file: those of the machine, each with all its parameters, and every fault at its key."""

import json
import math
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from trueaxis.effects.kind import Effect
from trueaxis.effects.library import BY_NAME
from trueaxis.io.faults import InputError
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues, dump_errors, read_errors

EFFECTS = (
    Effect(kind="backlash", component="EXX"),
    Effect(kind="cross_axis", component="EXX", axis="Y"),
    Effect(kind="cyclic", component="EYY"),
    Effect(kind="point_offset", runs=("X1", "X2"), end="target"),
    Effect(kind="laser_scale"),
)
CYCLIC = {"amplitude": 1e-3, "phase": 0.0, "pitch": 10.0}


def read_text(tmp_path: Path, text: str) -> ErrorValues:
    path = tmp_path / "errors.json"
    path.write_text(text)
    return read_errors(path, machine="m", components=("EXX", "EYY"), parameters=(), effects=EFFECTS)


def read(tmp_path: Path, *effects: Any) -> tuple[EffectValues, ...]:
    return read_text(tmp_path, json.dumps({"schema": 1, "machine": "m", "effects": list(effects)})).effects


def faults_of(tmp_path: Path, *effects: Any) -> list[str]:
    with pytest.raises(InputError) as caught:
        read(tmp_path, *effects)
    return [f"{fault.place}: {fault.problem}; {fault.remedy}" for fault in caught.value.faults]


def test_effects_come_in_the_order_of_the_machine(tmp_path: Path) -> None:
    offset = {"kind": "point_offset", "runs": ["X2", "X1"], "parameters": {"x": 1, "y": 2, "z": 3}}
    lost = {"kind": "backlash", "component": "EXX", "parameters": {"width": 0.006}, "u": {"width": 2e-4}}
    assert read(tmp_path, offset, lost) == (
        EffectValues(EFFECTS[0], {"width": 0.006}, {"width": 2e-4}),
        EffectValues(EFFECTS[3], {"x": 1.0, "y": 2.0, "z": 3.0}),
    )


def test_a_vector_has_the_order_of_the_kind() -> None:
    values = EffectValues(EFFECTS[2], {"pitch": 10.0, "amplitude": 1e-3})
    assert values.vector(BY_NAME["cyclic"]).tolist() == [1e-3, 0.0, 10.0]


@pytest.mark.parametrize(
    ("effect", "expected"),
    [
        (3, "effects[0]: 3 is not an effect"),
        ({"component": "EXX"}, "effects[0].kind: is missing"),
        ({"kind": 3}, "effects[0].kind: 3 is not a text"),
        ({"kind": "backlash", "component": ["EXX"]}, "effects[0].component: a list is not a text"),
        ({"kind": "backlash", "component": "EYY"}, "effects[0]: the machine has no effect backlash EYY; the machine's"),
        ({"kind": "cross_axis", "component": "EXX"}, "effects[0]: the machine has no effect cross_axis EXX; "),
        ({"kind": "laser_scale", "runs": "X1"}, 'effects[0].runs: "X1" is not a list of run ids'),
        ({"kind": "laser_scale", "sum": 1}, "effects[0].sum: is not a key of an effect"),
        ({"kind": "laser_scale"}, "effects[0].parameters.k: is missing; relative error"),
        ({"kind": "laser_scale", "parameters": 1}, "effects[0].parameters: 1 is not an object"),
        ({"kind": "laser_scale", "parameters": {"k": "1"}}, 'effects[0].parameters.k: "1" is not a number'),
        ({"kind": "laser_scale", "parameters": {"k": 1, "kk": 1}}, "effects[0].parameters.kk: laser_scale has no para"),
        ({"kind": "laser_scale", "parameters": {"k": 1}, "u": {"k": -1}}, "effects[0].u.k: -1.0 is negative"),
        (
            {"kind": "cyclic", "component": "EYY", "parameters": {**CYCLIC, "pitch": 0}},
            "effects[0].parameters.pitch: 0.0 is not above 0",
        ),
    ],
)
def test_each_fault_has_its_key_and_remedy(tmp_path: Path, effect: Any, expected: str) -> None:
    assert any(fault.startswith(expected) for fault in faults_of(tmp_path, effect)), faults_of(tmp_path, effect)


def test_all_faults_come_at_once_and_an_effect_comes_once(tmp_path: Path) -> None:
    scale = {"kind": "laser_scale", "parameters": {"k": 1e-6}}
    found = faults_of(tmp_path, scale, scale, {"kind": "backlash", "component": "EXX", "parameters": {"wide": 1}}, 1)
    assert [fault.split(";")[0] for fault in found] == [
        "effects[1]: laser_scale is given more than once",
        "effects[2].parameters.wide: backlash has no parameter wide",
        "effects[2].parameters.width: is missing",
        "effects[3]: 1 is not an effect",
    ]


def test_effects_must_be_a_list(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="effects: an object is not a list"):
        read_text(tmp_path, '{"schema": 1, "machine": "m", "effects": {}}')


FINITE = st.floats(allow_nan=False, allow_infinity=False)


@given(value=FINITE, u=st.floats(0.0, 1e6) | st.just(math.nan), order=st.permutations(EFFECTS))
@settings(deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_what_is_written_reads_back_in_the_order_of_the_machine(
    tmp_path: Path, value: float, u: float, order: list[Effect]
) -> None:
    values = {
        effect: EffectValues(
            effect,
            {one.name: 1.0 if one.grid else value for one in BY_NAME[effect.kind].parameters},
            {one.name: u for one in BY_NAME[effect.kind].parameters},
        )
        for effect in order
    }
    errors = ErrorValues(machine="m", effects=tuple(values[effect] for effect in order))
    text = dump_errors(errors, components=(), parameters=(), effects=EFFECTS)
    found = read_text(tmp_path, text).effects
    assert [one.effect for one in found] == list(EFFECTS)
    assert all(one.parameters == values[one.effect].parameters for one in found)
    for one in found:
        assert all(again == u or (math.isnan(again) and math.isnan(u)) for again in one.u.values())


JSON_VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
    max_leaves=6,
)


@given(
    kind=st.sampled_from(sorted(BY_NAME)) | JSON_VALUES,
    key=st.sampled_from(("component", "axis", "runs", "end", "parameters", "u")),
    value=JSON_VALUES | st.sampled_from(("EXX", "Y", "target")),
    parameters=st.dictionaries(st.sampled_from(("width", "k", "x", "y", "z", "pitch")), JSON_VALUES),
)
@settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_any_effect_reads_or_is_refused_clearly(
    tmp_path: Path, kind: Any, key: str, value: Any, parameters: Any
) -> None:
    with suppress(InputError):
        found = read(tmp_path, {"component": "EXX", "parameters": parameters, "kind": kind, key: value})
        assert all(math.isfinite(number) for one in found for number in one.parameters.values())
