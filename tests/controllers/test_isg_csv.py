"""The ISG file, read again and put into the chain of transforms that it describes, is what `predict` says."""

from dataclasses import replace

import numpy as np
import pytest

from tests.controllers import control_files
from tests.controllers.machines import FIVE, FIXED, FIXED_ON_TABLE, GANTRY, TABLE, FloatArray, random_model
from trueaxis.controllers.formats import export_tables, problem_of
from trueaxis.controllers.isg_csv import ComponentTable, ControlModel, control_model, csv_text, reversed_axes
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.model import MachineModel
from trueaxis.reporting.export import export_sentences

TOOL = np.array([[3.0], [-2.0], [-60.0]])
BOTH = TABLE.replace("[axis.X]", "[axis.X]\nsense = -1")


def turn(vector: FloatArray) -> FloatArray:
    x, y, z = vector
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def motion(axis: str, at: float, points: dict[str, FloatArray]) -> FloatArray:
    """An axis of the chain, in coordinates whose origin is that of the machine."""
    matrix = np.eye(4)
    if axis in "XYZ":
        matrix["XYZ".index(axis), 3] = at
        return matrix
    angle, around = np.radians(at), turn(np.eye(3)["ABC".index(axis)])
    matrix[:3, :3] += np.sin(angle) * around + (1 - np.cos(angle)) * around @ around
    matrix[:3, 3] = points[f"P{axis}"] - matrix[:3, :3] @ points[f"P{axis}"]
    return matrix


def tool_point(text: str, chain: str, position: dict[str, float], *, errors: bool) -> FloatArray:
    """Where the chain puts the tool point: every axis moves, then its errors act."""
    points, tables = control_files.isg(text)
    matrix = np.eye(4)
    for axis in chain:
        matrix = matrix @ motion(axis, position[axis], points)
        arguments, components = tables[axis]
        if errors:
            value = {name: control_files.isg_value(arguments, one, position) for name, one in components.items()}
            error = np.eye(4)
            error[:3, :3] += turn(np.array([value[f"E{letter}{axis}"] for letter in "ABC"]))
            error[:3, 3] = [value[f"E{letter}{axis}"] for letter in "XYZ"]
            matrix = matrix @ error
    found: FloatArray = (matrix @ np.append(points["P0"], 1.0))[:3]
    return found


MACHINES = {
    "gantry": (GANTRY, "XYZ"),
    "table": (BOTH, "YXZ"),
    "five axes": (FIVE, "CYXZB"),
    "fixed bodies": (FIXED, "XYZ"),
    "fixed bodies on a table": (FIXED_ON_TABLE, "YXZ"),
}


@pytest.mark.parametrize(("text", "chain"), MACHINES.values(), ids=MACHINES)
@pytest.mark.parametrize("seed", range(3))
def test_the_deviations_of_the_chain_are_those_predicted(text: str, chain: str, seed: int) -> None:
    model = random_model(text, seed, scale=0.01)
    assert reversed_axes(model) == ()
    control = control_model(model, TOOL[:, 0], None)
    assert "".join(control.chain) == chain
    written = csv_text(control)
    draw = np.random.default_rng(seed)
    nodes = {table.axis: table.positions for table in control.tables}
    at = np.array([draw.choice(nodes[axis], 12) for axis in model.axes])
    predicted = model.deviation(at, TOOL)
    assert np.abs(predicted).max() > 2e-4
    for column in range(at.shape[1]):
        position = dict(zip(model.axes, at[:, column], strict=True))
        actual, ideal = (tool_point(written, chain, position, errors=errors) for errors in (True, False))
        np.testing.assert_allclose(actual - ideal, predicted[:, column], atol=4e-7)


# errors that depend on two axes: on the tool side, of a table, of a rotary axis; of one axis on two others
BENT = {
    "gantry": (GANTRY, [("EZX", "Y", 0.02), ("EAX", "Y", 3e-5)]),
    "table": (BOTH, [("EZY", "X", 0.02), ("EZY", "Z", -0.01)]),
    "five axes": (FIVE, [("EBC", "Y", 3e-5), ("EXZ", "X", 0.02)]),
}


def bent(text: str, effects: list[tuple[str, str, float]], seed: int) -> MachineModel:
    added = "".join(
        f'[[effect]]\nkind = "cross_axis"\ncomponent = "{component}"\naxis = "{axis}"\n'
        for component, axis, _ in effects
    )
    plain = random_model(text + added, seed, scale=0.01)
    values = [
        EffectValues(effect, {"k": 0.01 * size}) for effect, (_, _, size) in zip(plain.effects, effects, strict=True)
    ]
    return plain.with_values(replace(plain.errors, effects=tuple(values)))


@pytest.mark.parametrize(("text", "effects"), BENT.values(), ids=BENT)
def test_errors_of_two_axes_are_a_grid(text: str, effects: list[tuple[str, str, float]]) -> None:
    """At its nodes the control knows all of it; without the second axis it would not."""
    model = bent(text, effects, 3)
    control = control_model(model, TOOL[:, 0], 50.0)
    nodes = {table.axis: np.unique(table.positions) for table in control.tables}
    for table in control.tables:
        for axis, positions in table.beside.items():
            nodes[axis] = np.intersect1d(nodes[axis], positions)
    assert {axis for table in control.tables for axis in table.beside} == {axis for _, axis, _ in effects}
    assert all(places.size >= 2 for places in nodes.values())
    written = csv_text(control)
    draw = np.random.default_rng(3)
    at = np.array([draw.choice(nodes[axis], 12) for axis in model.axes])
    predicted = model.deviation(at, TOOL)
    plain = model.with_values(replace(model.errors, effects=())).deviation(at, TOOL)
    assert np.abs(predicted - plain).max() > 2e-5
    for column in range(at.shape[1]):
        position = dict(zip(model.axes, at[:, column], strict=True))
        chain = "".join(control.chain)
        actual, ideal = (tool_point(written, chain, position, errors=errors) for errors in (True, False))
        np.testing.assert_allclose(actual - ideal, predicted[:, column], atol=4e-7)


def test_what_remains_with_a_grid_is_the_bend_between_its_nodes() -> None:
    model = bent(GANTRY, [("EZX", "Y", 2.0)], 3)
    draw = np.random.default_rng(7)
    positions = np.array([draw.uniform(*model.travel[axis], 200) for axis in model.axes])
    left = export_tables("isg-csv", model, TOOL, None, positions).remaining
    assert 1e-5 < left.after < 20e-3 / 1600 * 4  # steps of 50 mm, not of 30, between the nodes of Y
    assert left.before > 5e-3
    (sentence,) = [
        one
        for one in export_sentences("isg-csv", model, export_tables("isg-csv", model, TOOL, None, positions))
        if "grid" in one
    ]
    assert sentence == "errors of X also depend on Y, and are written as a grid"


def test_the_published_grid() -> None:
    """The example of `ISG CSV format`, `Component errors of the X axis for Z = 0 and Z = 100`."""
    published = """Z      X      EXX    EYX    EZX    EAX    EBX    ECX
0.0    0.0    0.02   0.01   0.07   0.00   0.0042 0.003
0.0    10.0   0.00   -0.1   0.01   0.00   0.0011 0.002
100.0  0.0    0.01   0.02   0.03   0.07   0.0040 0.003
100.0  10.0   0.03   -0.09  0.03   0.06   0.0015 0.000"""
    head, *rows = [line.split() for line in published.splitlines()]
    values = np.array([[float(cell) for cell in row] for row in rows])
    table = ComponentTable(axis="X", positions=values[:, 1], errors=values[:, 2:].T, beside={"Z": values[:, 0]})
    text = csv_text(ControlModel(chain=("X",), tables=(table,), centres={}, tool=np.zeros(3)))
    ours = [line.split() for line in text.split("#\n")[1].splitlines()]
    assert ours[0] == head
    assert [[float(cell) for cell in row] for row in ours[1:]] == values.tolist()


def test_what_remains_is_the_bend_between_nodes() -> None:
    model = random_model(FIVE, 7)
    draw = np.random.default_rng(7)
    positions = np.array([draw.uniform(*model.travel[axis], 50) for axis in model.axes])
    left = export_tables("isg-csv", model, TOOL, None, positions).remaining
    assert left.before > 0.01
    assert left.after < 1e-3 * left.before


def test_axes_that_count_the_other_way_are_refused() -> None:
    model = random_model(TABLE, 0)
    assert reversed_axes(model) == ("X",)
    assert "positive commands of X move the tool in the negative direction" in problem_of("isg-csv", model, None)


def test_the_published_components_of_an_axis() -> None:
    """The example of `ISG CSV format`, `Component errors of the X axis`."""
    published = """X      EXX    EYX    EZX    EAX    EBX    ECX
0.0    0.02   0.01   0.07   0.00   0.0042 0.003
10.0   0.00   -0.1   0.01   0.00   0.0011 0.002"""
    head, *rows = [line.split() for line in published.splitlines()]
    values = np.array([[float(cell) for cell in row] for row in rows])
    table = ComponentTable(axis="X", positions=values[:, 0], errors=values[:, 1:].T)
    text = csv_text(ControlModel(chain=("X",), tables=(table,), centres={}, tool=np.zeros(3)))
    ours = [line.split() for line in text.split("#\n")[1].splitlines()]
    assert ours[0] == head
    assert [[float(cell) for cell in row] for row in ours[1:]] == values.tolist()


def test_the_file_is_laid_out_as_published() -> None:
    """`ISG CSV format` (Beckhoff TF5280, ISG kernel): a header of names, rows, `//` before comments, `#` between."""
    export = export_tables("isg-csv", random_model(GANTRY, 1), TOOL, 250.0, np.zeros((3, 1)))
    lines = export.files[""].splitlines()
    assert [line for line in lines if not line.startswith("//")][:2] == ["P0X P0Y P0Z", "3 -2 -60"]
    assert "X EXX EYX EZX EAX EBX ECX" in lines
    assert lines.count("#") == 3
    row = lines[lines.index("X EXX EYX EZX EAX EBX ECX") + 2].split()
    assert row[0] == "250"
    assert len(row) == 7
