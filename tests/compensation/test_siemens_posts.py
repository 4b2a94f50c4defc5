"""What CAM posts for SINUMERIK write beside motions: declarations, further work offsets, spindle stops, H."""

import re

import pytest

from tests.compensation.analytic_machine import paper_sized
from tests.compensation.control import Bench
from trueaxis.compensation.offsets import Offsets, offset_of_option
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
        ("G506 G0 X1", "G506: where its zero is is not known; say --offset G506="),
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
