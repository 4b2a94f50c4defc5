"""What LinuxCNC's interpreter asks of the machine while it unrolls: where axes stand, the tool, reference points."""

import re
from pathlib import Path

import pytest

from tests.compensation.test_via_linuxcnc import INSTALLED, PACKAGE
from tests.shop_programs.grade import OFFSETS, grade
from trueaxis.compensation.linuxcnc.interpreter import unroll
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.tools import Tool, ToolTable
from trueaxis.io.faults import InputError

pytestmark = pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")

FRAMES = Offsets(
    {name: {a: (v, v) for a, v in zip("XYZ", OFFSETS[k], strict=True)} for k, name in enumerate(("G54", "G55"))},
    {}, "G54",
)  # fmt: skip
TOOLS = ToolTable({1: Tool(length=20.0), 2: Tool(length=35.0)})
HEAD = "G21 G90\nT1 M6\nG43 H1\nG0 X0 Y0 Z5\nG1 X10 F100\n"


def motions(folder: Path, program: str, **more: object) -> list[str]:
    """The blocks with axis words that a program is unrolled to, without their numbers."""
    path = folder / "in.ngc"
    path.write_text(program)
    text = unroll(path, PACKAGE, FRAMES, TOOLS, "in", axes="XYZ", **more).text  # type: ignore[arg-type]
    return [line.split(" ", 1)[1].replace("00000", "") for line in text.splitlines() if re.match(r"N\d+ ", line)]


@pytest.mark.parametrize(
    ("blocks", "after"),
    [
        # the module has X10 still, from before the arc: X went back there with Z
        ("G2 X20 I5 J0\nT2 M6\nG0 Z10\nX20 Y0\n", ["G0 Z130.00", "G0 X320.00 Y-200.00"]),
        # it has X10 of G54: Y and Z were moved by the difference of the offsets
        ("G55\nT2 M6\nG0 X10\n", ["G0 X320.00"]),
        ("G55 T2 M6\nG0 X10\n", ["G0 X320.00"]),
        ("G49\nT2 M6\nG0 X10\n", ["G0 X310.00"]),
        ("T2 M6 G43 H2\nG0 X10\n", ["G0 X310.00"]),
        # it has the numbers of mm, and takes them for inches
        ("G20\nT2 M6\nG0 X1\n", ["G0 X325.40"]),
        ("G92 X0\nT2 M6\nG0 Y1\n", ["G0 Y-199.00"]),
    ],
)  # fmt: skip
def test_a_tool_change_moves_no_axis(tmp_path: Path, blocks: str, after: list[str]) -> None:
    """An axis gets words again once the program commands it, to the same place too."""
    found = motions(tmp_path, HEAD + blocks + "M2\n")
    assert found[2 + blocks.startswith("G2 ") :] == after


def test_units_that_change_with_the_tool_are_a_fault(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="line 6: a tool change and a change of units in one block"):
        motions(tmp_path, HEAD + "G20 T2 M6\nG0 X1\nM2\n")


@pytest.mark.parametrize("blocks", ["T2 M6\nG2 X20 I5 J0\n", "T2 M6\nG0 X[#5420 * 2]\n", "G28\n"])
def test_what_depends_on_where_axes_stand_is_a_fault(tmp_path: Path, blocks: str) -> None:
    with pytest.raises(InputError, match="depends on where the axes stand at first or after"):
        motions(tmp_path, HEAD + blocks + "M2\n")


def test_calls_of_blocks_with_long_numbers_are_written(tmp_path: Path) -> None:
    """A tool change was left out."""
    path = tmp_path / "in.ngc"
    path.write_text("G21 G90\nG0 X0 Y0 Z5\nN100010 M5 T2 M6\nN1000020 S300 M3\nG0 X1\nN1000030 G1 X2 F100\nM2\n")
    text = unroll(path, PACKAGE, FRAMES, TOOLS, "in", axes="XYZ").text
    assert [line for line in text.splitlines() if line in ("T2", "M6", "S300", "M3")] == ["T2", "M6", "S300", "M3"]
    assert "G1 X302.0000000 F100" in text


def test_reference_points_are_those_of_the_machine(tmp_path: Path) -> None:
    """They were taken to be 0, and G28 became a rapid to there."""
    point = {"G28": {"X": 1.0, "Y": 2.0, "Z": 303.0}}
    assert motions(tmp_path, HEAD + "G28\nM2\n", reference_points=point)[2:] == ["G0 X1.00 Y2.00 Z303.00"]
    found = motions(tmp_path, HEAD + "G91 G28 Z0\nG90\nM2\n", reference_points={"G28": {"Z": 303.0}})
    assert found[2:] == ["G0 Z303.00"]


def test_speeds_by_time_are_those_of_the_ways_in_millimetres(tmp_path: Path) -> None:
    """rs274 takes offsets for inches: the way to machine coordinates was 25 times as long, and so was F."""
    path = tmp_path / "in.ngc"
    path.write_text("G21 G90\nG0 X0 Y0 Z5\nG93 G53 G1 X200 F2\nM2\n")
    assert "N3 G1 X200.0000000 F200" in unroll(path, PACKAGE, FRAMES, TOOLS, "in", axes="XYZ").text


@pytest.mark.parametrize("block", ["M66 P0 L3 Q1", "m 066 P0 L0"])
def test_inputs_are_not_known(tmp_path: Path, block: str) -> None:
    """Waiting for them was left out."""
    with pytest.raises(InputError, match="line 6: M66 waits for an input"):
        motions(tmp_path, f"{HEAD}{block} (M66)\nG0 X1\nM2\n")


def test_the_tool_of_the_first_length_is_in_the_spindle(tmp_path: Path) -> None:
    program = tmp_path / "in.ngc"
    program.write_text("G21 G90\nG43 H2\nG0 X0 Y0 Z5\nG1 X10 F100\nM2\n")
    assert unroll(program, PACKAGE, FRAMES, TOOLS, "in").tool == 2
    alike = {1: Tool(length=20.0, point=(0.0, 0.0, 1.0)), 2: Tool(length=20.0)}
    with pytest.raises(InputError, match=r"a length of 20\.0000 mm is in force before a tool change: of which tool"):
        unroll(program, PACKAGE, FRAMES, ToolTable(alike), "in")
    program.write_text("G21 G90\nG43 H2\nG0 X0 Y0 Z5\nG43 H1\nG1 X10 F100\nM2\n")
    assert unroll(program, PACKAGE, FRAMES, TOOLS, "in").tool == 2
    program.write_text("G21 G90\nG43 H30\nG0 X0 Y0 Z5\nG1 X90 F100\nY70\nM2\n")
    graded = grade(program, PACKAGE, tmp_path, via=True)
    assert (graded.outcome, graded.after < 0.0012 < graded.before) == ("accepted", True)
