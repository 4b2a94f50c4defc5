"""Structure codes: hand-worked orders, the machine they build, and refusals."""

from itertools import permutations

import pytest
import sympy as sp

from trueaxis.derivation.first_order import squarenesses
from trueaxis.io.faults import Faults, InputError
from trueaxis.machine.machine import Machine
from trueaxis.machine.read import parse_machine
from trueaxis.machine.structure_code import AxisOrder, StructureCodeError, parse_structure
from trueaxis.machine.topology import branches

LINEAR_TABLES = "".join(f"[axis.{axis}]\ntravel = [0.0, 500.0]\n" for axis in "XYZ")


def machine(code: str, tables: str = LINEAR_TABLES) -> Machine:
    return parse_machine(f'schema = 1\nname = "m"\nstructure = "{code}"\n{tables}', Faults("m.toml"))


@pytest.mark.parametrize(
    ("code", "workpiece", "tool"),
    [
        ("[w C' Y' b X Z B t]", "YC", "XZB"),
        ("w C' Y' b X Z B t", "YC", "XZB"),
        ("[t Z X b Y' C' w]", "YC", "XZ"),
        ("[w b X Y Z t]", "", "XYZ"),
        ("[w Z' Y' X' b t]", "XYZ", ""),
        ("YFXZ", "Y", "XZ"),
        ("CYFXZB", "YC", "XZB"),
        ("FXYZ", "", "XYZ"),
        ("XZB+YC", "YC", "XZB"),
        ("X-Z-B + Y C", "YC", "XZB"),
    ],
)
def test_codes_name_both_branches_from_the_bed_outwards(code: str, workpiece: str, tool: str) -> None:
    assert parse_structure(code) == AxisOrder(tuple(workpiece), tuple(tool))


@pytest.mark.parametrize(
    "code",
    ["XYZ", "[w X b Y Z t]", "[w X' b Y' t]", "[w b X X t]", "XFYZF", "UFXY", "[w b t]", "[w X' b Y w]", "+", "b"],
)
def test_what_is_no_code_is_refused(code: str) -> None:
    with pytest.raises(StructureCodeError):
        parse_structure(code)


def test_the_code_of_the_paper_builds_its_bodies() -> None:
    built = machine("[w C' Y' b X Z B t]")
    names = [[body.name for body in branch] for branch in branches(built)]
    assert names == [["Y slide", "C table", "workpiece"], ["X slide", "Z slide", "B head", "tool"]]
    assert built.axes == ("X", "Y", "Z", "B", "C")
    assert len(built.components) == 30
    assert built.location_errors == tuple("EC0Y EX0C EY0C EA0C EB0C EA0Z EB0Z EX0B EZ0B EA0B EC0B".split())


@pytest.mark.parametrize(
    ("code", "errors"),
    [
        ("[w b X Y Z t]", "EC0Y EA0Z EB0Z"),
        ("[w b Y X Z t]", "EC0X EA0Z EB0Z"),  # a rotation of Y would turn X as well
        ("[w X' Y' b Z t]", "EC0X EA0Z EB0Z"),
        ("[w b Z X Y t]", "EB0X EA0Y EC0Y"),
    ],
)
def test_squareness_is_on_the_outer_of_two_axes(code: str, errors: str) -> None:
    assert sorted(machine(code).location_errors) == sorted(errors.split())


@pytest.mark.parametrize("order", list(permutations("XYZ")))
@pytest.mark.parametrize("bed", range(4))
def test_default_squarenesses_determine_the_three_right_angles(order: tuple[str, ...], bed: int) -> None:
    # Their effects on the three scalar products of axis directions must be independent.
    code = (
        "[w" + "".join(f" {axis}'" for axis in order[:bed]) + " b" + "".join(f" {axis}" for axis in order[bed:]) + " t]"
    )
    built = machine(code)
    names = [sp.Symbol(name, real=True) for name in built.location_errors]
    products = sp.Matrix([pair.product for pair in squarenesses(built)])
    assert products.jacobian(names).rank() == 3


def test_tables_set_what_the_code_leaves_open() -> None:
    tables = LINEAR_TABLES.replace("[axis.Y]", "[axis.Y]\nsense = -1\nposition_errors = {}") + (
        '[axis.C]\ntravel = [-90.0, 90.0]\nposition = [1.0, "q_c", 0.0]\n'
        'motion_errors = ["EXC"]\n[tool]\nposition = [0.0, 0.0, "L"]\n'
    )
    built = machine("[w C' Y' b X Z t]", tables)
    table = built.mover("C")
    assert (table.travel, table.position, table.motion_errors) == ((-90.0, 90.0), (1.0, "q_c", 0.0), ("EXC",))
    assert built.mover("Y").sense == -1
    assert built.mover("Y").position_errors == ()
    assert built.body(built.tool).position == (0.0, 0.0, "L")


def test_every_fault_is_told_at_its_table() -> None:
    with pytest.raises(InputError) as caught:
        machine(
            "[w Y' b X Z t]",
            '[axis.X]\ntravel = [5.0, 1.0]\n[axis.Z]\nposition = ["q", 0, "q"]\n'
            "travel = [0, 1]\n[axis.B]\ntravel = [0, 1]\n[ends]\ntool = 3\n",
        )
    told = [str(fault) for fault in caught.value.faults]
    for part in (
        "line 5, key axis.X.travel: runs",
        "axis.Y.travel: is missing",
        "key axis.Z.position: the name 'q' clashes",
        "key axis.B: is not a key",
        "key ends: stands beside structure",
    ):
        assert any(part in line for line in told), (part, told)


def test_the_chain_names_axes_and_senses_from_workpiece_to_tool() -> None:
    assert machine("YFXZ").chain == "+Y bed +X +Z"
    assert machine("YFXZ", LINEAR_TABLES.replace("[axis.Y]", "[axis.Y]\nsense = -1")).chain == "-Y bed +X +Z"
    assert machine("XYFZ").chain == "+X +Y bed +Z"
    assert machine("YXFZ").chain == "+Y +X bed +Z"
