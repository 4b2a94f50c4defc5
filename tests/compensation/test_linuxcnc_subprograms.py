"""Subprograms of Fanuc's kind (M98 and M99) by way of LinuxCNC, and what a program may do to frames that are given."""

import re
from pathlib import Path

import pytest

from tests.compensation.analytic_machine import paper_sized
from tests.compensation.control import Bench, execute
from tests.compensation.five_axes import TEXTS, FiveAxes
from tests.compensation.test_via_linuxcnc import INSTALLED, PACKAGE
from tests.shop_programs.grade import OFFSETS, grade, machine
from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.linuxcnc.source import end_faults, may_use_point, offset_faults
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.touched_off import touched_off_of_option
from trueaxis.io.faults import InputError

installed = pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
G54 = Offsets({"G54": {axis: (at, at) for axis, at in zip("XYZ", OFFSETS[0], strict=True)}}, {}, "G54")
NESTED = """\
%
O0001 (PLATE)
G21 G17 G90 G54 G94
T1 M6
G43 H1
G0 X0 Y0 Z5
M98 P1000 L3
M98 P2000 L0
G0 Z10
M98 P2000
M30
O1000
G91 G1 Z-1 F100
G90 X40
M98 P2000
G1 X0 Y0
M99
O2000
G1 Y20 F200
G91 G3 X0 Y10 J5
G90
M99
%
"""


@installed
def test_subprograms_in_the_file_are_right_along_the_path(tmp_path: Path) -> None:
    program = tmp_path / "in.ngc"
    program.write_text(NESTED)
    graded = grade(program, PACKAGE, tmp_path, via=True)
    assert (graded.outcome, graded.kind) == ("accepted", "macro")
    assert graded.before > 0.01
    assert graded.after < 0.0014
    assert (tmp_path / "out.ngc").read_text().count("N20 G3 X") == 4  # once in each call


@installed
@pytest.mark.parametrize(
    ("end", "problem"),
    [
        ("M99\n", "line 4: M99 begins the main program anew, without end; M2 or M30"),
        ("M98 P1234\nM30\n", "line 4: subprogram O1234 is not in the file; put it into the file"),
        ("M98 P31234\nM30\nO1234\nM99\n", "line 4: subprogram O31234 is not in the file"),
    ],
)
def test_subprograms_that_do_not_end_or_are_not_there(tmp_path: Path, end: str, problem: str) -> None:
    """M99 at the end of the main program was taken for its end; the control runs it again and again."""
    program = tmp_path / "in.ngc"
    program.write_text(f"G21 G90 G54\nG0 X0 Y0 Z5\nG1 X5 F100\n{end}")
    with pytest.raises(InputError, match=problem):
        compensate_file(program, tmp_path / "out.ngc", machine(), Settings(offsets=G54), via_linuxcnc=PACKAGE)
    assert not (tmp_path / "out.ngc").exists()


UNROLLED = r"--via-linuxcnc \(LinuxCNC installed here\) expands it"


@pytest.mark.parametrize(
    ("dialect", "remedy"),
    [(None, UNROLLED), ("linuxcnc", UNROLLED), ("fanuc", "write the blocks")],
)
def test_a_call_names_the_way_out(bench: Bench, dialect: str | None, remedy: str) -> None:
    with pytest.raises(InputError, match=f"line 2: M98 calls, .* --pass-m does not pass it; {remedy}"):
        bench.run("G21 G90\nM98 P1000\nM30\n", dialect=dialect)


@pytest.mark.parametrize(
    ("block", "line"), [("M99", 2), ("m 0 9 9", 2), ("N5 M99 (again)", 2), ("M30", 0), ("M2 (M99)", 0), ("M990", 0)]
)
def test_the_block_that_ends_a_program(block: str, line: int) -> None:
    found = end_faults(f"G0 X1\n{block}\n".encode(), 2, "in")
    assert [fault.place for fault in found] == ([f"line {line}"] if line else [])
    assert not end_faults(b"M99\n", 0, "in")
    assert not end_faults(b"M99\n", 7, "in")


@pytest.mark.parametrize(
    ("block", "uses"),
    [
        ("G28", True), ("G91 G 2 8 Z0", True), ("g028.1", True), ("G[20 + 8]", True), ("X#5161", True), ("X##1", True),
        ("G0 X28", False), ("(G28)", False), ("G280", False), ("G30", False), ("X#5181", False), ("X#1", False),
    ],
)  # fmt: skip
def test_what_may_use_a_reference_point(block: str, uses: bool) -> None:
    assert may_use_point(f"G21\n{block}\nM2\n".encode(), "G28") == uses


@pytest.mark.parametrize(
    ("block", "may"),
    [
        ("G10 L2 P1 X0", True), ("G 1 0 L20 P1 X0", True), ("#5221 = 4", True), ("#[#1 + 2] = 4", True),
        ("G[#1] X0", True), ("G92 X0", False), ("G1 X10", False), ("#1 = #5221", False), ("(G10)", False),
        ("X#[#1]", False), ("o1 if [#5221 == 4]", False),
    ],
)  # fmt: skip
def test_what_may_change_a_work_offset(block: str, may: bool) -> None:
    assert bool(offset_faults(f"G21\n{block}\nM2\n".encode(), "in")) == may


PART = """\
G21 G17 G90 G54 G94
G0 X0. Y0. Z5.
G1 Z-2. F200
X40.
G3 X40. Y20. I0. J10.
G1 X0. Y0.
G53 G0 Z50.
M2
"""


@installed
@pytest.mark.parametrize("option", ["G54=L70", "G54=X250,Y-150,Z120"])
def test_a_work_offset_that_was_touched_off(tmp_path: Path, option: str) -> None:
    """By way of LinuxCNC the same machine positions are written as without it; G53 has no datum either way."""
    (tmp_path / "in.ngc").write_text(PART)
    settings = Settings(offsets=G54, touched_off=(touched_off_of_option(option),), dialect="linuxcnc", arcs="chords")
    ends = []
    for via in (None, PACKAGE):
        compensate_file(tmp_path / "in.ngc", tmp_path / "out.ngc", machine(), settings, via_linuxcnc=via)
        text = (tmp_path / "out.ngc").read_text()
        ends.append(execute(re.sub(r"G10 .*|G5[49](\.3)?|G92\.1", "", text).encode()))
    plain, unrolled = ends
    plain[:, :-1] += [[at] for at in OFFSETS[0]]
    assert plain[2, -1] == unrolled[2, -1]
    assert abs(plain - unrolled)[:, :-1].max() < 0.00101  # a word
    settings = Settings(offsets=G54, dialect="linuxcnc", arcs="chords")
    compensate_file(tmp_path / "in.ngc", tmp_path / "out.ngc", machine(), settings, via_linuxcnc=PACKAGE)
    text = re.sub(r"G10 .*|G59\.3|G92\.1", "", (tmp_path / "out.ngc").read_text())
    assert abs(execute(text.encode()) - unrolled).max() > 0.005


def test_what_does_not_go_with_touched_off(tmp_path: Path) -> None:
    touched = (touched_off_of_option("G54"),)
    (tmp_path / "in.ngc").write_text(PART.replace("G0 X0.", "G10 L2 P1 X0.\nG0 X0."))
    with pytest.raises(InputError, match="line 2: may change a work offset, and --touched-off says"):
        compensate_file(
            tmp_path / "in.ngc", tmp_path / "out.ngc", paper_sized(), Settings(offsets=G54, touched_off=touched),
            via_linuxcnc=PACKAGE,
        )  # fmt: skip
    turning = FiveAxes(TEXTS["table-table"], size=1.0, seed=1).model
    with pytest.raises(InputError, match="on a machine with rotary axes, with which the datum turns"):
        compensate_file(
            tmp_path / "in.ngc", tmp_path / "out.ngc", turning, Settings(offsets=G54, touched_off=touched),
            via_linuxcnc=PACKAGE,
        )  # fmt: skip
