"""[[effect]] and [[effect_kind]]: what they make of a machine, and every fault with its place and remedy."""

import re
from dataclasses import replace

import pytest

from tests.kernels import model_of
from tests.machine.test_faults import faults_of
from tests.machines import DMU60P, ROOT, machine_of, serial_text
from trueaxis.effects.kind import Effect, Kind, Parameter
from trueaxis.machine.effect_kinds import LARGEST_GRID, MOST_KINDS

MILL = DMU60P.read_text()
LINES = len(MILL.splitlines())
SAG = """[[effect_kind]]
name = "table_sag"
expression = "sag*s*(1 - s)*T*cos(q/period)"
components = ["EZY", "turn"]
sentence = "the table sags."
parameters.sag = { unit = "u/K", meaning = "in the middle" }
parameters.period = { unit = "axis", grid = [5.0, 10] }
"""


def effect(**keys: object) -> str:
    return "[[effect]]\n" + "".join(f"{key} = {value!r}\n" for key, value in keys.items())


def test_effects_stand_in_the_order_of_the_spec() -> None:
    text = (
        effect(kind="servo_lag", component="EXX")
        + effect(kind="cross_axis", component="EZX", axis="Y")
        + effect(kind="laser_cosine", runs=["X2", "X1"])
        + effect(kind="laser_cosine")
        + effect(kind="ballbar_length")
        + effect(kind="point_offset", runs=["X1"])
        + effect(kind="point_offset", runs=["X1"], end="reference")
        + effect(kind="ballbar_centre")
    )
    assert machine_of(MILL + text).effects == (
        Effect(kind="servo_lag", component="EXX"),
        Effect(kind="cross_axis", component="EZX", axis="Y"),
        Effect(kind="laser_cosine", runs=("X2", "X1")),
        Effect(kind="laser_cosine"),
        Effect(kind="ballbar_length"),
        Effect(kind="point_offset", runs=("X1",), end="target"),
        Effect(kind="point_offset", runs=("X1",), end="reference"),
        Effect(kind="ballbar_centre"),
    )


def test_an_own_kind_is_as_its_table_says() -> None:
    machine = machine_of(MILL + SAG + effect(kind="table_sag", component="ECX"))
    assert machine.effects == (Effect(kind="table_sag", component="ECX"),)
    assert machine.kinds["table_sag"] == Kind(
        name="table_sag",
        place="component",
        expression="sag*s*(1 - s)*T*cos(q/period)",
        parameters=(
            Parameter(name="sag", unit="u/K", meaning="in the middle"),
            Parameter(name="period", unit="axis", meaning="period", role="grid", grid="given", values=(5.0, 10.0)),
        ),
        sentence="the table sags",
        directions=("turn",),
        components=("EZY",),
    )
    assert list(machine.kinds)[-1] == "table_sag"


def test_the_hash_is_that_of_what_is_said() -> None:
    texts = [MILL, MILL + SAG, MILL + SAG.replace("1 - s", "2 - s"), MILL + effect(kind="drift", component="EXX")]
    assert len({machine_of(text).digest for text in texts}) == len(texts)
    assert machine_of(texts[1]).digest == machine_of(MILL + "# a comment\n" + SAG).digest


def test_a_squareness_is_a_position_error_like_others() -> None:
    machine = machine_of(MILL + effect(kind="squareness", component="EB0X"))
    plain = machine_of(MILL)
    assert machine.mover("X").position_errors == (("EB", "EB0X"), ("EC", "eps_xy"))
    assert machine.parameter_unit("EB0X") == "rad"
    # The same machine as one whose spec names it: same equations, same kernels but for the effect itself.
    said = MILL.replace('{ EC = "eps_xy" }', '{ EB = "EB0X", EC = "eps_xy" }')
    assert said != MILL
    assert replace(machine, effects=()) == machine_of(said)
    assert set(machine.parameters) == {*plain.parameters, "EB0X"}
    model = model_of(MILL + effect(kind="squareness", component="EB0X"))
    inputs = {row for routine in model.routines for argument in routine.inputs for row in argument.rows}
    assert "EB0X" in inputs


# Tables, then key, a part of the problem, a part of what would be right.
FAULTS = {
    "an unknown kind": (effect(kind="baklash", component="EXX"), "effect[0].kind", "'baklash'", "backlash or"),
    "no kind like it": (effect(kind="linearisation"), "effect[0].kind", "'linearisation'", "one of backlash"),
    "no kind": (effect(component="EXX"), "effect[0].kind", "is missing", "text"),
    "a number for a kind": (effect(kind=3), "effect[0].kind", "is 3", "text"),
    "no component": (effect(kind="backlash"), "effect[0].component", "is missing", "text"),
    "no such component": (effect(kind="backlash", component="EXA"), "effect[0].component", "'EXA'", "EXX EYX"),
    "not along": (effect(kind="servo_lag", component="EYX"), "effect[0].component", "not act on EYX", "EXX EYY EZZ"),
    "not a rotation": (effect(kind="cyclic", component="ECX"), "effect[0].component", "not act on ECX", "EXX EYX EZX"),
    "not of the own kind": (SAG + effect(kind="table_sag", component="EXX"), "effect[0].component", "EXX", "EAX EBX"),
    "no other axis": (effect(kind="cross_axis", component="EXX"), "effect[0].axis", "is missing", "Y Z"),
    "its own axis": (effect(kind="cross_axis", component="EXX", axis="X"), "effect[0].axis", "EXX itself", "Y Z"),
    "an axis of others": (effect(kind="cross_axis", component="EXX", axis="C"), "effect[0].axis", "no axis C", "Y Z"),
    "no axis at all": (effect(kind="cross_axis", component="EXX", axis="U"), "effect[0].axis", "'U'", "X Y Z"),
    "an axis for nothing": (effect(kind="drift", component="EXX", axis="Y"), "effect[0].axis", "has none", "leave"),
    "runs for nothing": (effect(kind="laser_scale", runs=["X1"]), "effect[0].runs", "has none", "leave it out"),
    "runs are a text": (effect(kind="laser_step", runs="X1"), "effect[0].runs", "'X1'", "a list of texts"),
    "runs are none": (effect(kind="laser_step", runs=[]), "effect[0].runs", "[]", "a list of texts"),
    "a run twice": (effect(kind="laser_step", runs=["a", "a"]), "effect[0].runs", "['a', 'a']", "each once"),
    "no such end": (effect(kind="point_offset", end="tool"), "effect[0].end", "'tool'", "target reference"),
    "an end of a bar": (effect(kind="ballbar_centre", end="target"), "effect[0].end", "has none", "leave it out"),
    "a component of readings": (effect(kind="laser_scale", component="EXX"), "effect[0].component", "has none", "out"),
    "a strange key": (effect(kind="laser_scale", size=3), "effect[0].size", "not a key", "allowed: kind"),
    "twice": (effect(kind="drift", component="EXX") * 2, "effect[1]", "drift EXX is there already", "once"),
    "twice, runs the other way round": (
        effect(kind="laser_step", runs=["a", "b"]) + effect(kind="laser_step", runs=["b", "a"]),
        "effect[1]", "there already", "once",
    ),
    "twice, the end unsaid": (
        effect(kind="point_offset", end="target") + effect(kind="point_offset"), "effect[1]", "there already", "once",
    ),
    "squareness said": (
        effect(kind="squareness", component="EC0X"), "effect[0].component", "the position error EC already, eps_xy",
        "EB0X EA0Y EC0Y",
    ),
    "squareness about itself": (effect(kind="squareness", component="EA0X"), "effect[0].component", "'EA0X'", "EB0X"),
    "squareness of no axis": (effect(kind="squareness", component="EA0C"), "effect[0].component", "'EA0C'", "EB0X"),
    "squareness of a motion": (effect(kind="squareness", component="ECX"), "effect[0].component", "'ECX'", "EB0X"),
    "a name of the library": (SAG.replace("table_sag", "drift"), "effect_kind[0].name", "'drift'", "another name"),
    "a kind twice": (SAG * 2, "effect_kind[1].name", "another kind 'table_sag'", "its own"),
    "a name with capitals": (SAG.replace("table_sag", "Sag"), "effect_kind[0].name", "'Sag'", "small letter"),
    "no expression": (SAG.replace("expression", "# "), "effect_kind[0].expression", "is missing", "text"),
    "a strange key of a kind": (SAG.replace("sentence", "why"), "effect_kind[0].why", "not a key", "sentence"),
    "a component of no axis": (SAG.replace("EZY", "EZA"), "effect_kind[0].components", "'EZA'", "along across turn"),
    "components are a text": (SAG.replace('["EZY", "turn"]', '"EZY"'), "effect_kind[0].components", "'EZY'", "a list"),
    "a sign of HTML": (SAG.replace("the table", "<table>"), "effect_kind[0].sentence", "<table>", "letters, digits"),
    "no parameters": (
        "\n".join(line for line in SAG.splitlines() if not line.startswith("parameters")).replace(
            'sag*s*(1 - s)*T*cos(q/period)', "s"
        ), "effect_kind[0].parameters", "is missing", "a table",
    ),
    "no unit": (SAG.replace('unit = "u/K", ', ""), "effect_kind[0].parameters.sag.unit", "is missing", "text"),
    "no such unit": (SAG.replace("u/K", "um/K"), "effect_kind[0].parameters.sag.unit", "'um/K'", "such as u/K"),
    "an empty grid": (SAG.replace("[5.0, 10]", "[]"), "effect_kind[0].parameters.period.grid", "[]", "1 to 100"),
    "a grid of one twice": (SAG.replace("10]", "5]"), "effect_kind[0].parameters.period.grid", "[5.0, 5]", "different"),
    "a grid that ends nowhere": (SAG.replace("10]", "inf]"), "effect_kind[0].parameters.period.grid", "inf", "finite"),
    "a large grid": (
        SAG.replace("[5.0, 10]", str(list(range(1, LARGEST_GRID + 2)))),
        "effect_kind[0].parameters.period.grid", "[1, 2", "1 to 100",
    ),
    "a parameter that is a variable": (
        SAG.replace("sag*s*(1 - s)", "s*v").replace("parameters.sag", "parameters.s"),
        "effect_kind[0].parameters.s", "language of expressions", "another name",
    ),
    "a parameter that is a word of C": (
        SAG.replace("sag*", "double*").replace("parameters.sag", "parameters.double"),
        "effect_kind[0].parameters.double", "clashes", "another name",
    ),
    "a parameter that is no name": (
        SAG + 'parameters."a b" = { unit = "u", grid = [1] }\n', "effect_kind[0].parameters.a b", "no name", "a letter",
    ),
    "a parameter for nothing": (
        SAG.replace("sag*s*", "sag*").replace("cos(q/period)", "q"),
        "effect_kind[0].parameters", "period is not in the expression", "leave it out",
    ),
    "no linear parameter": (
        SAG.replace('meaning = "in the middle"', "grid = [1.0]"),
        "effect_kind[0].parameters", "no linear one", "without a grid",
    ),
    "not linear": (SAG.replace("sag*s", "sag^2*s"), "effect_kind[0].expression", "not linear in sag", "a grid"),
    "linear but for a constant": (SAG.replace("sag*s", "1 + sag*s"), "effect_kind[0].expression", "linear", "factor"),
    "a root of what is negative": (
        SAG.replace("(1 - s)", "sqrt(s - 1)"), "effect_kind[0].expression", "no finite value where sag = ", "positions",
    ),
    "a quotient at rest": (SAG.replace("(1 - s)", "1/v"), "effect_kind[0].expression", "v = 0", "speeds"),
    "another axis for nothing": (SAG + "other_axis = true\n", "effect_kind[0].other_axis", "no variable", "s_b"),
    "not true": (SAG + "other_axis = 1\n", "effect_kind[0].other_axis", "is 1", "true or false"),
}  # fmt: skip


@pytest.mark.parametrize("case", FAULTS)
def test_one_fault_is_told_once_with_key_problem_and_remedy(case: str) -> None:
    tables, key, problem, remedy = FAULTS[case]
    (fault,) = faults_of(MILL + tables)
    assert fault.place.partition("key ")[2] == key
    assert problem in fault.problem
    assert remedy in fault.remedy
    assert "\n" not in str(fault)


# Changed expression, then column of the caret under it, problem, remedy.
CARETS = {
    "sag*s**2": (6, "'*'", "^ for a power"),
    "sag*log(s)": (4, "no function log", "sin cos exp"),
    "sag*(s": (6, "the end", ") for the ("),
    "sag*cos(q/period)*u": (18, "u is unknown", "one of q s direction v d d_time d_path t T"),
    "sag*cos(q/period)*s_b": (18, "s_b is no variable", "other_axis = true"),
    "along + sag*cos(q/period)": (0, "along is no variable", "one of q s direction v d d_time d_path t T"),
}


@pytest.mark.parametrize("expression", CARETS)
def test_a_fault_of_an_expression_has_a_caret_under_its_place(expression: str) -> None:
    column, problem, remedy = CARETS[expression]
    (fault,) = faults_of(MILL + SAG.replace("sag*s*(1 - s)*T*cos(q/period)", expression))
    assert fault.place == f"line {LINES + 3}, key effect_kind[0].expression"
    assert problem in fault.problem
    assert remedy in fault.remedy
    _, line, caret = str(fault).split("\n")
    assert line.strip() == expression
    assert caret == " " * (len(line) - len(expression) + column) + "^"


def test_all_faults_come_at_once_each_with_its_line() -> None:
    text = MILL + effect(kind="baklash") + effect(kind="drift", component="EXA", axis="Y") + SAG.replace("EZY", "EZ")
    found = {fault.place for fault in faults_of(text)}
    assert found == {
        f"line {LINES + 2}, key effect[0].kind",
        f"line {LINES + 5}, key effect[1].component",
        f"line {LINES + 6}, key effect[1].axis",
        f"line {LINES + 10}, key effect_kind[0].components",
    }


def test_the_examples_of_the_page_on_specs_are_right() -> None:
    page = (ROOT / "docs" / "machine.md").read_text(encoding="utf-8")
    examples = re.findall(r"^```toml\n(\[\[effect.*?)^```$", page, re.MULTILINE | re.DOTALL)
    machine = machine_of(serial_text("Y", "XZ") + "".join(examples))
    assert [effect.kind for effect in machine.effects] == ["backlash", "cross_axis", "point_offset", "squareness"]
    assert [kind.name for kind in machine.effect_kinds] == ["table_sag"]


def test_of_bodies_in_doubt_nothing_is_said_twice() -> None:
    text = MILL.replace('moves = "X"', 'moves = "U"') + effect(kind="drift", component="EXX")
    assert all("effect" not in fault.place for fault in faults_of(text))


def test_there_may_be_so_many_kinds_and_no_more() -> None:
    kinds = [SAG.replace("table_sag", f"sag{index}") for index in range(MOST_KINDS + 1)]
    assert len(machine_of(MILL + "".join(kinds[:-1])).effect_kinds) == MOST_KINDS
    (fault,) = faults_of(MILL + "".join(kinds))
    assert "too many" in fault.problem


def test_rotary_axes_and_their_positioning_errors() -> None:
    text = serial_text("C", "XYZ") + effect(kind="servo_lag", component="ECC")
    assert machine_of(text).effects == (Effect(kind="servo_lag", component="ECC"),)
    text = serial_text("C", "XYZ") + effect(kind="squareness", component="EA0C")
    assert machine_of(text).location_errors == ("EA0C",)
    (fault,) = faults_of(serial_text("C", "XYZ") + effect(kind="squareness", component="EC0C"))
    assert "'EC0C'" in fault.problem


def test_a_squareness_may_not_take_the_name_of_another_parameter() -> None:
    text = serial_text("Y", "XZ", X={"position_errors": {"EX": "EC0Z"}}) + effect(kind="squareness", component="EA0Z")
    assert "EA0Z" in machine_of(text).parameters
    (fault,) = faults_of(text.replace("EC0Z", "EA0Z", 1))
    assert "the name EA0Z is that of another parameter" in fault.problem
