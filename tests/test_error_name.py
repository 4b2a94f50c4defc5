"""Names of errors are texts that know their direction and axis, and no other module takes them apart."""

import ast
import copy
import json
import pickle
from pathlib import Path
from typing import TypeGuard

import pytest

import trueaxis
from trueaxis.error_name import DIRECTIONS, ErrorName, positioning_error, rotation_about
from trueaxis.view import VIEWS, view_of

SOURCE = Path(trueaxis.__file__).parent
NAMES = {"component", "name"}  # words of the code for the text of a name


@pytest.mark.parametrize(
    ("text", "direction", "axis", "units"),
    [
        ("EXX", "EX", "X", ("mm", "mm", "mm/mm")),
        ("EYX", "EY", "X", ("mm", "mm", "mm/mm")),
        ("ECY", "EC", "Y", ("rad", "mm", "rad/mm")),
        ("EZC", "EZ", "C", ("mm", "deg", "mm/deg")),
        ("EC0Y", "EC", "Y", ("rad", "mm", "rad/mm")),
    ],
)
def test_parts_of_a_name(text: str, direction: str, axis: str, units: tuple[str, str, str]) -> None:
    name = ErrorName(text)
    assert (name.direction, name.axis) == (direction, axis)
    assert (name.unit, name.axis_unit, name.slope_unit) == units
    assert name.is_rotation is (units[0] == "rad")
    assert name.is_location is ("0" in text)


def test_kinds_of_component_errors_by_iso_230_1() -> None:
    names = [direction.motion_error(axis) for axis in "XC" for direction in DIRECTIONS]
    assert (
        [name for name in names if name.is_positioning] == [positioning_error(axis) for axis in "XC"] == ["EXX", "ECC"]
    )
    assert [name for name in names if name.is_straightness] == ["EYX", "EZX"]
    assert [rotation_about(axis) for axis in "XYZABC"] == ["EA", "EB", "EC"] * 2
    assert [direction.line for direction in DIRECTIONS] == ["X", "Y", "Z"] * 2


@pytest.mark.parametrize("text", ["", "EX", "EXW", "EXXX", "exx", "FXX", "EX1X", "EXX ", "EXX\n", "eps_xy"])
def test_a_text_that_is_no_name_is_refused(text: str) -> None:
    assert ErrorName.parse(text) is None
    with pytest.raises(ValueError, match="is no name of an error"):
        ErrorName(text)


def test_a_name_is_its_text() -> None:
    name = ErrorName("EXY")
    assert {name: 1} == {"EXY": 1}
    assert json.dumps([name]) == '["EXY"]'
    assert f"{name!r} {name}" == "'EXY' EXY"
    for other in (copy.deepcopy(name), pickle.loads(pickle.dumps(name))):
        assert other == name
        assert other.axis == "Y"


def test_views_are_named_by_carrier_and_frame() -> None:
    assert view_of("tool", "bed") in VIEWS
    with pytest.raises(ValueError, match="rest in the frame"):
        view_of("bed", "bed")


def test_no_other_module_takes_a_name_apart() -> None:
    """No letter of `component`, `effect.component` or `name` is asked for, no name and no view is put together."""
    found = []
    for path in SOURCE.rglob("*.py"):
        if path.name in ("error_name.py", "view.py", "effect_library.py"):
            continue
        for node in ast.walk(ast.parse(path.read_text())):
            if _takes_apart(node):
                found.append(f"{path.relative_to(SOURCE)}, line {node.lineno}: {ast.unparse(node)}")
    assert found == []


def _takes_apart(node: ast.AST) -> TypeGuard[ast.expr]:
    if isinstance(node, ast.JoinedStr):
        written = [part.value for part in node.values if isinstance(part, ast.Constant)]
        return "_in_" in written or written[:1] == ["E"]
    if not isinstance(node, ast.Subscript):
        return False
    texts = node.value.values if isinstance(node.value, ast.BoolOp) else [node.value]
    return any(map(_is_name, texts)) and _is_part(node.slice)


def _is_name(node: ast.expr) -> bool:
    name = node.id if isinstance(node, ast.Name) else node.attr if isinstance(node, ast.Attribute) else ""
    return name in NAMES


def _is_part(index: ast.expr) -> bool:
    """Of the letters 0 to 3, or the last: a text that is cut elsewhere is no name of an error."""
    if isinstance(index, ast.Slice):
        return all(part is None or _is_part(part) for part in (index.lower, index.upper))
    return ast.unparse(index) in ("0", "1", "2", "3", "-1")
