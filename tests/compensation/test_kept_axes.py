"""Stops and tool changes at which axes stay where they are, as --pass-m 0,1,6 says."""

from pathlib import Path

import pytest

from tests.compensation.analytic_machine import paper_sized
from tests.compensation.control import Bench
from tests.compensation.test_via_linuxcnc import INSTALLED, PACKAGE
from tests.shop_programs.grade import grade
from trueaxis.io.faults import InputError

HEAD = "G21 G90\nG0 X100. Y-100. Z50.\n"


@pytest.mark.parametrize("block", ["M0", "M1", "T2 M6"])
def test_an_axis_that_stays_gets_words_at_once(bench: Bench, block: str) -> None:
    """Y is commanded before the block alone; its error is taken back after it where it stands as before."""
    program = f"{HEAD}{block}\nG0 X300.\nG1 X310. F100\n"
    code = 6 if "M6" in block else int(block[1:])
    unsure = bench.run(program, paper_sized(), dialect="linuxcnc").decode().splitlines()[3:]
    kept = bench.run(program, paper_sized(), dialect="linuxcnc", pass_m=(code,)).decode().splitlines()[3:]
    assert not any("Y" in line for line in unsure)
    assert "Y" in kept[0]
    assert [(one.code, one.lines.points) for one in bench.report.passed] == [(code, 1)]
    assert not any("may have moved" in str(note) or "may move" in str(note) for note in bench.report.notes)


def test_increments_after_a_tool_change(bench: Bench) -> None:
    program = f"{HEAD}T2 M6\nG91 G1 X10. F100\n"
    with pytest.raises(InputError, match="the tool change before it may have moved them"):
        bench.run(program, paper_sized(), dialect="linuxcnc")
    assert bench.run(program, paper_sized(), dialect="linuxcnc", pass_m=(6,)).count(b"X") == 2


def test_a_turret_that_changes_by_t_is_no_m6(bench: Bench) -> None:
    with pytest.raises(InputError, match="the tool change before it may have moved them"):
        bench.run(f"{HEAD}T2\nG91 G1 X10. F100\n", paper_sized(), pass_m=(6,))


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
@pytest.mark.parametrize("via", [False, True])
def test_increments_after_stops_and_tools_are_right_along_the_path(tmp_path: Path, via: bool) -> None:
    program = tmp_path / "in.ngc"
    program.write_text(
        "G21 G90 G17\nT1 M6\nG43 H1\nG0 X10 Y0 Z5\nG1 Z-1 F200\nX60\nM0\nG91 G2 X20 Y20 I20 J0\nG90 G0 Z5\n"
        "T2 M6\nG43 H2\nG1 Z-2\nG91 X-30 Y10\nM2\n"
    )
    graded = grade(program, PACKAGE, tmp_path, via=via)
    assert (graded.outcome, graded.reason) == ("accepted", "with --start and --pass-m 0,1,6"), graded
    assert graded.after < 0.0014
    assert graded.before > 0.01
