"""The error-values file: what it says is what is read, and what is wrong in it is said all at once."""

import json
import math
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from trueaxis.io.faults import InputError
from trueaxis.model.curves import PolynomialCurve, TableCurve
from trueaxis.model.errors import ErrorValues, Fit, Undetermined, dump_errors, read_errors

COMPONENTS = ("EXX", "EYX", "EBX", "EXY")
PARAMETERS = ("q_wx", "eps_xy", "eps_xz")

VALID: dict[str, Any] = {
    "schema": 1,
    "machine": "dmu60p",
    "parameters": {"q_wx": 0.0, "eps_xy": -5e-6},
    "motion_errors": {
        "EXX": {"basis": "polynomial", "powers": [1, 2, 3], "coefficients": [1e-5, -2e-8, 1e-11]},
        "EBX": {"basis": "table", "positions": [0, 30, 60], "values": [0, 1e-6, 2e-6]},
    },
}


def read_text(tmp_path: Path, text: str | bytes) -> ErrorValues:
    path = tmp_path / "errors.json"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return read_errors(path, machine="dmu60p", components=COMPONENTS, parameters=PARAMETERS)


def read(tmp_path: Path, tree: Any) -> ErrorValues:
    return read_text(tmp_path, json.dumps(tree))


def faults_of(tmp_path: Path, text: str | bytes) -> list[str]:
    with pytest.raises(InputError) as caught:
        read_text(tmp_path, text)
    return [f"{fault.place}: {fault.problem}; {fault.remedy}" for fault in caught.value.faults]


def with_curve(curve: Any) -> str:
    return json.dumps({**VALID, "motion_errors": {"EXX": curve}})


def test_the_file_of_the_contract_is_read(tmp_path: Path) -> None:
    errors = read(tmp_path, VALID)
    assert errors.parameters == {"q_wx": 0.0, "eps_xy": -5e-6}
    assert errors.motion_errors == {
        "EXX": PolynomialCurve(powers=(1, 2, 3), coefficients=(1e-5, -2e-8, 1e-11)),
        "EBX": TableCurve((0.0, 30.0, 60.0), (0.0, 1e-6, 2e-6)),
    }


def test_what_is_not_named_is_absent_and_so_zero(tmp_path: Path) -> None:
    errors = read(tmp_path, {"schema": 1, "machine": "dmu60p"})
    assert errors == ErrorValues(machine="dmu60p", parameters={}, motion_errors={}, u={}, undetermined=())


@pytest.mark.parametrize(
    "fit", [Fit("converged"), Fit("converged", 1.02), Fit("misfit", 961.0, ("Y2", "X1"))], ids=lambda fit: fit.state
)
def test_how_the_fit_ended_is_kept(tmp_path: Path, fit: Fit) -> None:
    text = dump_errors(ErrorValues(machine="dmu60p", fit=fit), components=COMPONENTS, parameters=PARAMETERS)
    assert read_text(tmp_path, text).fit == fit


@pytest.mark.parametrize(
    ("fit", "place"),
    [
        (3, "fit:"),
        ({}, "fit.state"),
        ({"state": "good"}, "fit.state"),
        ({"state": ["misfit"]}, "fit.state"),
        ({"state": "misfit", "chi2": "big"}, "fit.chi2"),
        ({"state": "misfit", "runs": [1]}, "fit.runs"),
        ({"state": "misfit", "why": ""}, "fit.why"),
    ],
)
def test_a_wrong_fit_is_a_fault(tmp_path: Path, fit: Any, place: str) -> None:
    faults = faults_of(tmp_path, json.dumps({**VALID, "fit": fit}))
    assert any(fault.startswith(place) for fault in faults)


def test_the_measured_range_of_a_polynomial_is_kept(tmp_path: Path) -> None:
    curve = PolynomialCurve(powers=(1, 2), coefficients=(1e-5, -2e-8), u=None, measured=(10.0, 480.0))
    text = dump_errors(
        ErrorValues(machine="dmu60p", motion_errors={"EXX": curve}), components=COMPONENTS, parameters=PARAMETERS
    )
    assert read_text(tmp_path, text).motion_errors == {"EXX": curve}
    assert TableCurve((0.0, 5.0, 9.0), (0.0, 0.0, 0.0)).measured == (0.0, 9.0)


@pytest.mark.parametrize("measured", [5, [1.0], [2.0, 1.0], [0.0, "end"], [0.0, 1.0, 2.0]])
def test_a_wrong_measured_range_is_a_fault(tmp_path: Path, measured: Any) -> None:
    curve = {"basis": "polynomial", "powers": [1], "coefficients": [1e-5], "measured": measured}
    assert any("motion_errors.EXX.measured" in fault for fault in faults_of(tmp_path, with_curve(curve)))


def test_uncertainties_ride_along(tmp_path: Path) -> None:
    tree = {
        **VALID,
        "u": {"eps_xy": 1e-7, "eps_xz": None},
        "motion_errors": {
            "EXX": {"basis": "polynomial", "powers": [2, 1], "coefficients": [3.0, 4.0], "u": [0.5, None]},
            "EBX": {"basis": "table", "positions": [0, 30], "values": [0, 1e-6], "u": [0, 2e-7]},
        },
        "undetermined": [{"combination": "EYX: x^1 + eps_xy", "parameters": ["EYX", "eps_xy"]}],
    }
    errors = read(tmp_path, tree)
    assert errors.u["eps_xy"] == 1e-7
    assert math.isnan(errors.u["eps_xz"])
    assert errors.motion_errors["EBX"].u == (0.0, 2e-7)
    assert errors.undetermined == (Undetermined("EYX: x^1 + eps_xy", ("EYX", "eps_xy")),)
    again = read_text(tmp_path, dump_errors(errors, components=COMPONENTS, parameters=PARAMETERS))
    rewritten = again.motion_errors["EXX"]
    assert isinstance(rewritten, PolynomialCurve)
    assert rewritten.powers == (1, 2)
    assert rewritten.coefficients == (4.0, 3.0)
    assert rewritten.u is not None
    assert math.isnan(rewritten.u[0])
    assert rewritten.u[1] == 0.5
    assert again.undetermined == errors.undetermined


# What is changed in VALID, and how the fault begins.
CHANGES: list[tuple[dict[str, Any], str]] = [
    ({"schema": 2}, "schema: 2 is not a known schema"),
    ({"schema": True}, "schema: true is not a known schema"),
    ({"machine": "other"}, 'machine: "other" is another machine; the machine is "dmu60p"'),
    ({"parameters": {"eps_xX": 1.0}}, "parameters.eps_xX: the machine has no parameter eps_xX; did you mean eps_x"),
    ({"parameters": {"q_wx": "1"}}, 'parameters.q_wx: "1" is not a number'),
    ({"parameters": {"q_wx": True}}, "parameters.q_wx: true is not a number"),
    ({"parameters": []}, "parameters: a list is not an object"),
    ({"motion_errors": {"EXZ": {}}}, "motion_errors.EXZ: the machine has no motion error EXZ"),
    ({"motion_errors": {"EXX": 3}}, "motion_errors.EXX: 3 is not an error curve"),
    ({"effects": [{"kind": "backlash"}]}, "effects[0]: the machine has no effect backlash; add it to the"),
    ({"u": {"eps_xy": -1.0}}, "u.eps_xy: -1.0 is negative"),
    ({"paramters": {}}, "paramters: is not a key of an error-values file; did you mean parameters?"),
    ({"undetermined": {}}, "undetermined: an object is not a list"),
    ({"chain": ["X"]}, "chain: a list is not a text"),
    ({"undetermined": [3]}, "undetermined[0]: is not an object of combination and parameters"),
    ({"undetermined": [{"combination": "", "parameters": [1]}]}, "undetermined[0].parameters: is not a list of n"),
    ({"parameters": {"zzz": 1.0}}, "parameters.zzz: the machine has no parameter zzz; known: q_wx, eps_xy, eps_xz"),
    ({"undetermined": [{"combination": 3, "parameters": []}]}, "undetermined[0].combination: 3 is not a text"),
]


@pytest.mark.parametrize(("change", "expected"), CHANGES)
def test_each_fault_has_its_key_and_remedy(tmp_path: Path, change: dict[str, Any], expected: str) -> None:
    assert any(fault.startswith(expected) for fault in faults_of(tmp_path, json.dumps({**VALID, **change})))


# Wrong curves, and how the fault begins.
CURVES: list[tuple[dict[str, Any], str]] = [
    ({"powers": [1]}, "motion_errors.EXX.basis: is missing"),
    ({"basis": "spline"}, 'motion_errors.EXX.basis: "spline" is not a basis'),
    ({"basis": "polynomial", "powers": [1]}, "motion_errors.EXX.coefficients: is missing"),
    (
        {"basis": "polynomial", "powers": [1, 2], "coefficients": [1.0]},
        "motion_errors.EXX.coefficients: has 1 entr",
    ),
    (
        {"basis": "polynomial", "powers": [1, 1], "coefficients": [1, 2]},
        "motion_errors.EXX.powers[1]: power 1 is gi",
    ),
    (
        {"basis": "polynomial", "powers": [1.5], "coefficients": [1]},
        "motion_errors.EXX.powers[0]: 1.5 is not a powe",
    ),
    (
        {"basis": "polynomial", "powers": [-1], "coefficients": [1]},
        "motion_errors.EXX.powers[0]: -1.0 is not a powe",
    ),
    ({"basis": "polynomial", "powers": 1, "coefficients": [1]}, "motion_errors.EXX.powers: 1 is not a list"),
    ({"basis": "table", "positions": [], "values": []}, "motion_errors.EXX.positions: is empty"),
    ({"basis": "table", "positions": [0, 0], "values": [0, 1]}, "motion_errors.EXX.positions[1]: 0.0 follows 0.0"),
    ({"basis": "table", "positions": [1, 0], "values": [0, 1]}, "motion_errors.EXX.positions[1]: 0.0 follows 1.0"),
    ({"basis": "table", "positions": [0, 1], "values": [0]}, "motion_errors.EXX.values: has 1 entries; as many as"),
    (
        {"basis": "table", "positions": [0], "values": [0], "powers": []},
        "motion_errors.EXX.powers: is not a key of",
    ),
    ({"basis": "table", "positions": [0], "values": [0], "u": 1}, "motion_errors.EXX.u: 1 is not a list"),
    ({"basis": "table", "positions": [0], "values": [10**400]}, "motion_errors.EXX.values[0]: is not a finite nu"),
]


@pytest.mark.parametrize(("curve", "expected"), CURVES)
def test_each_fault_of_a_curve(tmp_path: Path, curve: dict[str, Any], expected: str) -> None:
    found = faults_of(tmp_path, with_curve(curve))
    assert len(found) == 1
    assert found[0].startswith(expected)


@pytest.mark.parametrize("constant", ["NaN", "Infinity", "-Infinity", "1e999"])
def test_only_finite_numbers_are_taken(tmp_path: Path, constant: str) -> None:
    text = f'{{"schema": 1, "machine": "dmu60p", "parameters": {{"eps_xy": {constant}}}}}'
    assert faults_of(tmp_path, text) == ["parameters.eps_xy: is not a finite number; "]


def test_a_key_given_twice_is_a_fault_however_deep(tmp_path: Path) -> None:
    text = '{"schema": 1, "machine": "dmu60p", "parameters": {"eps_xy": 1e-6, "eps_xy": 2e-6}, "schema": 1}'
    assert faults_of(tmp_path, text) == [
        "schema: is given more than once; keep one",
        "parameters.eps_xy: is given more than once; keep one",
    ]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('{"schema": 1,\n "machine": }', "line 2, column 13: is not JSON"),
        (b"", "line 1, column 1: is not JSON"),
        (b"{\n\xff}", "line 2: byte 0xff is not UTF-8"),
        ("null", ": null is not an object"),
        ("[" * 100_000, ": is nested too deeply"),
        ('{"schema": ' + "9" * 5000 + "}", ": has a number with too many digits"),
    ],
    ids=["syntax", "empty", "encoding", "null", "depth", "digits"],
)
def test_what_is_no_json_object(tmp_path: Path, text: str | bytes, expected: str) -> None:
    found = faults_of(tmp_path, text)
    assert len(found) == 1
    assert found[0].startswith(expected)


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="there is no such file"):
        read_errors(tmp_path / "none.json", machine="m", components=(), parameters=())


def test_all_faults_come_at_once(tmp_path: Path) -> None:
    tree = {
        "schema": 3,
        "machine": "x",
        "parameters": {"a": 1},
        "motion_errors": {"EXX": {"basis": "polynomial", "powers": [1, 1, 0.5], "coefficients": ["a"]}},
    }
    places = [fault.split(": ")[0] for fault in faults_of(tmp_path, json.dumps(tree))]
    curve = "motion_errors.EXX"
    assert places == [
        "schema", "machine", "parameters.a", f"{curve}.powers[1]", f"{curve}.powers[2]", f"{curve}.coefficients[0]",
        f"{curve}.coefficients",
    ]  # fmt: skip


FINITE = st.floats(allow_nan=False, allow_infinity=False)
U = st.floats(0.0, 1e6) | st.just(math.nan)


@st.composite
def polynomials(draw: st.DrawFn) -> PolynomialCurve:
    powers = draw(st.lists(st.integers(0, 99), unique=True, max_size=6))
    count = len(powers)
    coefficients = draw(st.lists(FINITE, min_size=count, max_size=count))
    u = draw(st.none() | st.lists(U, min_size=count, max_size=count).map(tuple))
    return PolynomialCurve(powers=tuple(powers), coefficients=tuple(coefficients), u=u)


@given(curve=polynomials(), value=FINITE, order=st.permutations(COMPONENTS))
@settings(deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_what_is_written_reads_back_and_does_not_depend_on_insertion_order(
    tmp_path: Path, curve: PolynomialCurve, value: float, order: list[str]
) -> None:
    errors = ErrorValues(
        machine="dmu60p", parameters={"eps_xz": value, "eps_xy": -value}, motion_errors=dict.fromkeys(order, curve)
    )
    text = dump_errors(errors, components=COMPONENTS, parameters=PARAMETERS)
    straight = ErrorValues(
        machine="dmu60p", parameters={"eps_xy": -value, "eps_xz": value}, motion_errors=dict.fromkeys(COMPONENTS, curve)
    )
    assert text == dump_errors(straight, components=COMPONENTS, parameters=PARAMETERS)
    back = read_text(tmp_path, text)
    assert back.parameters == errors.parameters
    found = back.motion_errors["EYX"]
    assert isinstance(found, PolynomialCurve)
    assert dict(zip(found.powers, found.coefficients, strict=True)) == dict(
        zip(curve.powers, curve.coefficients, strict=True)
    )
    if curve.u is not None:
        order_of_powers = np.argsort(curve.powers)
        assert np.array_equal(np.array(found.u), np.array(curve.u)[order_of_powers], equal_nan=True)


JSON_VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=5), inner, max_size=4),
    max_leaves=8,
)


def mutate(draw: st.DrawFn, node: Any) -> Any:
    """A copy of the tree with one node, somewhere, replaced, removed or renamed."""
    if isinstance(node, dict) and node and draw(st.booleans()):
        key = draw(st.sampled_from(sorted(node)))
        changed = {name: value for name, value in node.items() if name != key}
        choice = draw(st.integers(0, 2))
        if choice == 0:
            changed[key] = mutate(draw, node[key])
        elif choice == 1:
            changed[draw(st.text(max_size=6))] = node[key]
        return changed
    if isinstance(node, list) and node and draw(st.booleans()):
        index = draw(st.integers(0, len(node) - 1))
        return [*node[:index], mutate(draw, node[index]), *node[index + 1 :]]
    return draw(JSON_VALUES)


@given(data=st.data())
@settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_a_mutated_file_reads_or_is_refused_clearly(tmp_path: Path, data: st.DataObject) -> None:
    tree = st.composite(lambda draw: mutate(draw, VALID))()
    mutated = data.draw(tree)
    with suppress(InputError):
        errors = read(tmp_path, mutated)
        values = np.array([curve(np.array([0.0, 1.0])) for curve in errors.motion_errors.values()])
        assert np.isfinite(values).all()
        assert set(errors.parameters) <= set(PARAMETERS)


@given(data=st.binary(max_size=60), at=st.integers(0, 400), cut=st.integers(0, 30))
@settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_a_file_with_damaged_bytes_reads_or_is_refused_clearly(tmp_path: Path, data: bytes, at: int, cut: int) -> None:
    text = json.dumps(VALID).encode()
    with suppress(InputError):
        read_text(tmp_path, text[:at] + data + text[at + cut :])


@pytest.mark.parametrize("positions", [[0.0, 1e-7, 1.0], [0, 3e-298, 6e-298], [0.0, 0.0, 1.0]])
def test_positions_that_nothing_can_take_apart_are_faults(tmp_path: Path, positions: list[float]) -> None:
    curve = {"basis": "table", "positions": positions, "values": [0, 1e-6, 2e-6]}
    assert any(
        "positions must increase, by 1e-06 at least" in fault for fault in faults_of(tmp_path, with_curve(curve))
    )


@pytest.mark.parametrize("u", [1e308, 2e6])
def test_an_uncertainty_that_says_nothing_is_a_fault(tmp_path: Path, u: float) -> None:
    curve = {"basis": "table", "positions": [0, 1, 2], "values": [0, 1e-6, 2e-6], "u": [0, u, None]}
    assert any("is no standard uncertainty" in fault for fault in faults_of(tmp_path, with_curve(curve)))
