"""Cutter location files worked out by hand."""

import math

import numpy as np
import pytest

from tests.compensation.analytic_machine import XyzMachine
from tests.compensation.control import Bench, execute
from trueaxis.io.faults import InputError

CL = """\
$$ written by hand (a test)
PARTNO PLATE, NO. 7
MACHIN/UNCX01,1
UNITS/MM
LOADTL/3,OSETNO,0
SPINDL/RPM,2000.0,CLW
COOLNT/ON
FROM/0,0,100
RAPID
GOTO/10.0,0.0, $
     5.0, $ $$ approach
     0.0,0.0,1.0
FEDRAT/250.0,MMPM
GOTO/10,0,0,0,0,1
CIRCLE/0,0,0,0,0,1,10
GOTO/0,10,0
GODLTA/5,0,-1.5
SPINDL/OFF
RAPID
GOTO/5,10,100
END
FINI
"""


def test_a_file_becomes_a_program(bench: Bench) -> None:
    text = bench.run(CL, language="apt", chord_tolerance=0.1).decode()
    lines = text.splitlines()
    head = [
        "%",
        "(written by hand [a test])",
        "(PARTNO PLATE, NO. 7)",
        "(MACHIN/UNCX01,1)",
        "G21 G17 G90 G94",
        "T3 M6",
        "S2000 M3",
        "M8",
        "(approach)",
        "G0 X10.000 Y0.000 Z5.000",
        "G1 X10.000 Y0.000 Z0.000 F250",
    ]
    assert lines[: len(head)] == head
    assert lines[-5:] == ["X5.000 Y10.000 Z-1.500", "M5", "G0 X5.000 Y10.000 Z100.000", "M30", "%"]
    arc = execute(text.encode())[:, 1:-2]
    assert np.abs(np.hypot(arc[0], arc[1]) - 10.0).max() < 0.0008
    angle = np.degrees(np.unwrap(np.arctan2(arc[1], arc[0])))
    assert (angle[0], angle[-1]) == (pytest.approx(0), pytest.approx(90))
    assert np.all(np.diff(angle) > 0)
    assert any("M6" in note for note in bench.report.notes)


def test_the_compensation_is_the_same_as_of_the_nc_program(bench: Bench) -> None:
    machine = XyzMachine({"EXX": lambda x: 1e-3 * x, "EYX": lambda x: 1e-5 * x * x})
    apt = execute(bench.run("FROM/0,0,0\nFEDRAT/100\nGOTO/30,0,0\nGOTO/30,20,5\nFINI\n", machine, "apt"))
    nc = execute(bench.run("G1 X30. Y0. Z0. F100\nX30. Y20. Z5.\n", machine, start={"X": 0.0, "Y": 0.0, "Z": 0.0}))
    assert apt == pytest.approx(nc)


@pytest.mark.parametrize(
    ("axis", "points", "sense", "degrees"),
    [
        ("0,0,1", [(0, 10)], 1, 90),
        ("0,0,-1", [(0, 10)], -1, 270),
        ("0,0,1", [(0, 10), (-10, 0), (0, -10)], 1, 270),
        ("0,0,1", [(0, -10), (-10, 0), (0, 10)], -1, 270),  # clockwise by its points, whatever the axis says
        ("0,0,1", [(-10, 0), (10, 0)], 1, 360),
        ("0,0,1", [(10, 0)], 1, 360),
    ],
)
def test_circles(bench: Bench, axis: str, points: list[tuple[int, int]], sense: int, degrees: int) -> None:
    goto = "".join(f"GOTO/{x},{y},0\n" for x, y in points)
    program = f"FROM/10,0,0\nFEDRAT/100\nCIRCLE/0,0,0,{axis},10\n{goto}GOTO/50,50,0\nFINI\n"
    at = execute(bench.run(program, language="apt"), start=[10, 0, 0])[:, :-1]
    angle = np.degrees(np.unwrap(np.arctan2(at[1], at[0])))
    assert np.abs(np.hypot(at[0], at[1]) - 10).max() < 0.0008
    first = angle[0] if abs(angle[0]) < 180 else angle[0] - math.copysign(360, angle[0])
    assert abs(angle[-1] - angle[0]) + abs(first) == pytest.approx(degrees, abs=0.01)
    assert np.all(sense * np.diff(angle) > 0)


def test_a_tilted_circle(bench: Bench) -> None:
    c = math.sqrt(0.5)
    program = f"FROM/10,0,0\nFEDRAT/9\nCIRCLE/0,0,0,0,{-c:.9f},{c:.9f},10\nGOTO/-10,0,0\nFINI\n"
    at = execute(bench.run(program, language="apt"), start=[10, 0, 0])
    assert np.abs(np.sqrt((at**2).sum(axis=0)) - 10).max() < 0.001
    assert np.abs(at[1] - at[2]).max() < 0.0011
    assert at[1].max() == pytest.approx(10 * c, abs=0.05)


def test_units_and_feed_units(bench: Bench) -> None:
    text = bench.run(
        "UNITS/INCHES\nFROM/0,0,0\nFEDRAT/254,MMPM\nGOTO/1,2,0\nFEDRAT/0.01,IPR\nGOTO/2,2,0\nFINI", language="apt"
    )
    assert b"G20 G17" in text
    assert b"G1 X1.00000 Y2.00000 Z0.00000 F10\n" in text
    assert b"X2.00000 Y2.00000 Z0.00000 G95 F0.01\n" in text


@pytest.mark.parametrize(
    "statement",
    [
        "CYCLE/DRILL,5", "CUTCOM/LEFT", "TRANS/1,2,3", "ORIGIN/1,2,3", "ROTABL/90", "GOHOME", "CALL/A", "M1 = MACRO/X",
        "COPY/1,SAME,5", "GOFWD/C1", "TLON,GOFWD/(CIRCLE/0,0,0,5),ON,(LINE/0,0,0,1,1,1)", "INSERT/G43", "PREFUN/68",
        "GOTO/1,2", "GOTO/1,2,X", "GOTO/1,2,nan", "GOTO/1e400,2,3", "GOTO/1_0,2,3", "GOTO/P1", "GOTO/1,2,3,0,0,2",
        "GOTO/1,2,3,0,1,0", "CIRCLE/0,0,0,0,0,1", "CIRCLE/0,0,0,0,0,1,99", "CIRCLE/9,9,9,0,0,1,3\nGOTO/1,2,3",
        "UNITS/FURLONGS", "FEDRAT/-5", "FEDRAT/FAST", "WHATEVER/1", "A=5", "@!#", "GODLTA/5", "LOADTL/NONE", "X $ Y",
        "MSYS/0,0,5,1,0,0,0,1,0", "FROM/0,0,0", "AUXFUN/98", "UNITS/INCHES", "GOTO/99999,0,0", "SPINDL/BAD", "\x00",
        "IF (A) 1,2,3", "JUMPTO/L", "NURBS/1", "TRACUT/M1",
    ],
)  # fmt: skip
def test_what_is_not_followed_is_a_fault_of_its_line(bench: Bench, statement: str) -> None:
    with pytest.raises(InputError) as error:
        bench.run(f"FROM/0,0,0\nFEDRAT/100\nGOTO/1,0,0,0,0,1\n{statement}\nGOTO/5,5,5,0,0,1\nFINI\n", language="apt")
    assert any(fault.place in {"line 4", "line 5"} for fault in error.value.faults), error.value
    assert not bench.out.exists()


def test_a_statement_that_never_ends(bench: Bench) -> None:
    with pytest.raises(InputError, match=r"continued by \$"):
        bench.run("GOTO/1,2,3 $\n", language="apt")


@pytest.mark.parametrize(
    ("name", "content", "language"),
    [
        ("a.nc", "GOTO/1,2,3\n", "nc"),
        ("a.cls", "", "apt"),
        ("a.ncl.3", "", "apt"),
        ("a.txt", "$$ hello\nGOTO/1,2,3\n", "apt"),
        ("a.txt", "PARTNO / X\n", "apt"),
        ("a.txt", "%\nG0 X1.\n", "nc"),
        ("a", "", "nc"),
    ],
)
def test_the_language_is_told_by_name_and_content(bench: Bench, name: str, content: str, language: str) -> None:
    from trueaxis.compensation.files import language_of

    path = bench.program.with_name(name)
    path.write_text(content)
    assert language_of(path) == language
