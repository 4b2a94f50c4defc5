"""Where a tool may have been changed, no axis gets a word before the program commands it again."""

import re

import pytest

from tests.compensation.analytic_machine import paper_sized
from tests.compensation.control import Bench
from tests.compensation.test_uncommanded import words
from trueaxis.io.faults import InputError

HEAD = "G21 G90\nG0 X500. Y600. Z100.\n"


def test_a_tool_change_in_a_block_that_moves_may_act_after_the_motion(bench: Bench) -> None:
    text = bench.run(f"{HEAD}G0 X200. Y200. Z300. M6\nG0 Y690.\nX210.\nZ590.\n", paper_sized(3.0))
    assert [words(text, axis) for axis in "XYZ"] == [[2, 3, 5, 6], [2, 3, 4, 5, 6], [2, 3, 6]]
    assert any(note.startswith("line 4") and "X Z gets no word here" in note for note in bench.report.notes)


@pytest.mark.parametrize("code", ["M6", "T2"])
def test_a_block_that_may_change_the_tool_stays_one_block(bench: Bench, code: str) -> None:
    """Cut, the change would be at the start of the first or at the end of the last: which is not known."""
    straight = bench.run(f"{HEAD}G1 X-500. Y-600. Z50. F100 {code}\n", paper_sized(3.0))
    assert len(straight.splitlines()) == 3
    assert len(bench.run(f"{HEAD}G1 X-500. Y-600. Z50. F100\n{code}\n", paper_sized(3.0)).splitlines()) > 6
    with pytest.raises(InputError, match=f"may have moved them.* and give {code} a block of its own"):
        bench.run(f"{HEAD}G2 X520. I10. J0. F100 {code}\n", paper_sized(3.0))


@pytest.mark.parametrize("dialect", [None, "siemens", "heidenhain"])
@pytest.mark.parametrize("block", ["T2", "N30 T2 S1000", "T2 D0", "G0 X500. T2"])
def test_a_tool_word_alone_may_change_the_tool(bench: Bench, dialect: str | None, block: str) -> None:
    text = bench.run(f"{HEAD}{block}\nG0 Z590.\nX-500.\nY-600.\n", paper_sized(3.0), dialect=dialect)
    assert [[line for line in words(text, axis) if line > 3] for axis in "XYZ"] == [[5, 6], [6], [4, 5, 6]]
    (note,) = (note for note in bench.report.notes if note.startswith("line 3: T "))
    assert "may change the tool" in note
    remedy = "or M6 behind T" if dialect == "siemens" else "--dialect fanuc"
    with pytest.raises(InputError, match=f"line 4: .* tool change before it may have moved .*{remedy}"):
        bench.run(f"{HEAD}{block}\nG91 X5.\n", paper_sized(3.0), dialect=dialect)


@pytest.mark.parametrize("dialect", ["fanuc", "linuxcnc"])
def test_a_tool_word_selects_where_m6_changes_the_tool(bench: Bench, dialect: str) -> None:
    text = bench.run(f"{HEAD}T2\nG0 Z590.\nG91 X5.\n", paper_sized(3.0), dialect=dialect)
    assert re.fullmatch(rb"G0 X\S+ Y\S+ Z\S+", text.splitlines()[3])
    assert any("T is taken to select a tool only" in note for note in bench.report.notes)


@pytest.mark.parametrize("dialect", [None, "siemens"])
def test_a_program_that_changes_tools_by_m6_selects_them_by_t(bench: Bench, dialect: str | None) -> None:
    program = f"G21 G90\nT1 M6\n{HEAD[8:]}G1 Z90. F100\nT2\nG2 X520. I10. J0.\nG0 Z590.\nM6\nG0 X1.\n"
    text = bench.run(program, paper_sized(3.0), dialect=dialect)
    assert bench.report.good
    assert words(text, "Z")[-1] == len(text.splitlines()) - 2
    assert any("line 5: T is taken to select a tool only" in note for note in bench.report.notes)


def test_a_tool_word_is_a_change_on_heidenhain_whatever_came_before(bench: Bench) -> None:
    text = bench.run(f"T1 M6\n{HEAD}T2\nG0 Z590.\n", paper_sized(3.0), dialect="heidenhain")
    assert re.fullmatch(rb"G0 Z[\d.]+", text.splitlines()[-1])


def test_a_tool_word_followed_by_m6_is_no_news(bench: Bench) -> None:
    bench.run(f"{HEAD}T2\nM6\n{HEAD}T3 M6\n", paper_sized(3.0))
    assert not any("T " in note.split(": ")[1][:2] for note in bench.report.notes)
