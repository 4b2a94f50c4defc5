"""What CAM posts for SINUMERIK write beside motions: declarations, further work offsets, spindle stops, H."""

import re

import pytest

from tests.compensation.analytic_machine import paper_sized
from tests.compensation.control import Bench
from trueaxis.compensation.offsets import Offsets, offset_of_option
from trueaxis.compensation.tools import Tool, ToolTable
from trueaxis.io.faults import InputError

VALUES = {"X": (300.0, 300.0), "Y": (-200.0, -200.0), "Z": (100.0, 100.0)}
OFFSETS = Offsets({"G54": VALUES, "G505": VALUES, "G599": {**VALUES, "X": (310.0, 310.0)}})


def run(bench: Bench, *blocks: str) -> list[str]:
    text = "\n".join(["G71 G90 G54", *blocks, "G0 X0 Y0 Z0", "G1 X5 F100", "M30", ""])
    return bench.run(text, paper_sized(3.0), dialect="siemens", offsets=OFFSETS).decode().splitlines()


@pytest.mark.parametrize(
    "block",
    [
        "DEF REAL _camtol",
        "N10 DEF REAL _camtol=0.01, _F_HSC = 500 ; X5",
        "DEF INT N_A1",
        "DEF STRING[32] NAME_1",
        "SPOS=0",
        "M5 SPOS[1]=AC(90.5)",
        "SPOSA=DC(12)",
        "H5",
    ],
)
def test_what_moves_no_axis_passes_as_it_is(bench: Bench, block: str) -> None:
    lines = run(bench, block)
    assert lines[1] == block
    assert any("goes to the machine's own control" in note for note in bench.report.notes) == (block == "H5")
    assert lines[2:] == run(bench)[1:]


def test_the_end_of_a_tilted_plane_passes_with_a_note(bench: Bench) -> None:
    lines = run(bench, "CYCLE800()")
    assert lines[1] == "CYCLE800()"
    assert any("CYCLE800() ends a tilted plane" in note for note in bench.report.notes)


def test_a_tool_by_its_name_is_that_of_its_number(bench: Bench) -> None:
    tools, text = ToolTable({7: Tool(80.0)}, {"DRILL 8.5": 7}), "G71 G90 G54\n{}\nM6\nD1\nG0 X0 Y0 Z0\nG1 X5 F100\n"
    written = [
        bench.run(text.format(word), paper_sized(3.0), dialect="siemens", offsets=OFFSETS, tools=tools).decode()
        for word in ("T7", 'T="DRILL 8.5"')
    ]
    assert written[1].replace('T="DRILL 8.5"', "T7") == written[0]
    assert "tool 7: the point 0, 0, -80" in bench.told
    with pytest.raises(InputError) as caught:
        bench.run(text.format('T="X"\nM6\nT="x"'), dialect="siemens", offsets=OFFSETS, tools=tools)
    (fault,) = caught.value.faults
    assert (fault.place, fault.problem) == ("line 2", 'no tool in --tools has the name "X"')


@pytest.mark.parametrize(
    ("block", "problem"),
    [
        ("_camtol=0.01", "'_camtol=0.01' is no word whose value is in the program"),
        ("DEF REAL", "DEF declares a variable"),
        ("DEF REAL A1 X5", "DEF declares a variable"),
        ("G1 X5 DEF REAL A1", "DEF declares a variable"),
        ("X=_camtol", "is no word whose value is in the program"),
        ("SPOS=R1", "is no word whose value"),
        ("G1 X5 RND=2", r"'RND=2' rounds a corner, which is not followed"),
        ("ROT RPL=45", r"'RPL=45' turns the coordinates, which is not followed"),
        ("G2 X5 Y5 I1 J0 TURN=2", r"'TURN=2' adds turns to an arc"),
        ("G504", "G504 is not a known code"),
        ("G506 G0 X1", "G506: where its zero lies is not known; say --offset G506="),
    ],
)
def test_what_does_is_named(bench: Bench, block: str, problem: str) -> None:
    with pytest.raises(InputError, match=problem):
        run(bench, block)


def test_further_work_offsets(bench: Bench) -> None:
    first, far = (run(bench, code)[2] for code in ("G505", "G599"))
    assert first == run(bench)[1]
    assert re.findall(r"X[-.\d]+", first) != re.findall(r"X[-.\d]+", far)  # 10 mm further on
    assert offset_of_option("G505=X1,Y2,Z3") == ("G505", {"X": (1.0, 1.0), "Y": (2.0, 2.0), "Z": (3.0, 3.0)})
    with pytest.raises(ValueError, match="G505 to G599"):
        offset_of_option("G600=X1")
    with pytest.raises(InputError, match="G505 is not a known code"):
        bench.run("G21 G90 G505\nG0 X0. Y0. Z0.\n", dialect="fanuc", offsets=OFFSETS)
