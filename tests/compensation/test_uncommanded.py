"""An axis that the program has not commanded gets no word, and no word leaves the travel."""

import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.compensation.analytic_machine import XyzMachine, paper_sized
from tests.compensation.control import Bench, execute
from trueaxis.io.faults import InputError

START = {"X": 0.0, "Y": 0.0, "Z": 600.0}


def bent() -> XyzMachine:
    """Z is 12 um low everywhere and sinks with X; X and Y err along their travels."""
    curves = {
        "EZZ": lambda z: -0.012 + 0.0 * z,
        "EZX": lambda x: -3e-5 * (x - 120.0),
        "EXX": lambda x: 1e-7 * x * x,
        "EYY": lambda y: 2e-5 * y,
    }
    return XyzMachine(curves, travel={"X": (-10.0, 900.0), "Y": (-10.0, 900.0), "Z": (0.0, 600.0)})


def words(text: bytes, axis: str) -> list[int]:
    """Lines (from 1) with a word of the axis."""
    return [n for n, line in enumerate(text.decode().splitlines(), 1) if re.search(rf"{axis}[-+.\d]", line)]


def test_the_start_is_no_command(bench: Bench) -> None:
    text = bench.run("G21 G90\nG0 X100. Y100.\nX120.\nZ10.\nX430.\n", bent(), start=START)
    assert words(text, "Z") == [4, 5]
    assert text.splitlines()[3].split()[-1] == b"Z10.012"
    report = bench.report
    assert report.good  # rapids on the way: what is left in Z is stated
    assert report.uncommanded.first == (2, 3)
    assert report.uncommanded_left is not None
    assert report.uncommanded_left.largest == pytest.approx(0.012, abs=1e-4)
    assert report.after is not None
    assert report.after.largest < 0.001
    assert (
        "axes not commanded yet in the frame in force get no words: 2 points, lines 2, 3; largest error left 0.0120 mm"
        in bench.told
    )
    assert any("Z gets no word here" in note for note in report.notes)


def test_a_cut_with_what_is_left_is_above_the_tolerance(bench: Bench) -> None:
    """The program has said where Z is to be, and Z gets no word because a tool change may have moved it."""
    bench.run("G21 G90\nG0 X0. Y0. Z500.\nM6\nG1 X100. Y100. F100\n", bent())
    assert not bench.report.good
    assert bench.report.over_tolerance.first == (4,)


def test_a_line_from_a_stated_start_is_not_cut(bench: Bench) -> None:
    """Cut, it would first go to points between where it is taken to start and its end."""
    text = bench.run("G21 G90\nG1 X900. Y0. Z500. F100\nX0.\n", bent(), start=START)
    lines = text.splitlines()
    assert lines[1].startswith(b"G1 X899.9")
    assert len(lines) > 6  # the way back is


def test_a_tool_change_may_have_moved_every_axis(bench: Bench) -> None:
    program = "G21 G90\nG0 X10. Y10. Z10.\nT2 M6\nG0 X300.\nY300.\nG0 Z20.\nX20.\n"
    text = bench.run(program, bent())
    assert words(text, "Z") == [2, 6, 7]
    assert words(text, "Y") == [2, 5]
    straight = bench.run("G21 G90\nG0 X10. Y10. Z10.\nM6\nG1 X900. F9\n", bent())
    assert len(straight.splitlines()) == 4
    for block in ("G91 X5.", "G2 X20. I5. F9", "G91 G3 I5. F9"):
        with pytest.raises(InputError, match=r"line 4: .* tool change before it may have moved"):
            bench.run(f"G21 G90\nG0 X10. Y10. Z10.\nM6\n{block}\n", bent())


@pytest.mark.parametrize("stop", ["M0", "M1"])
def test_after_a_stop_axes_wait_for_their_words(bench: Bench, stop: str) -> None:
    text = bench.run(f"G21 G90\nG0 X10. Y10. Z10.\n{stop}\nG0 X300.\nG91 X5.\nG90 Z5.\nX10.\n", bent())
    assert words(text, "Z") == [2, 5, 6, 7]  # none in line 4; an increment in line 5 is right wherever Z is


@pytest.mark.parametrize(
    "block", ["G2 X140. I20. J0. F100", "G2 X140. R20. F100", "G3 I20. F100", "G18 G2 X140. R20. F9"]
)
@pytest.mark.parametrize("before", ["M0\n", "M1\nG91 ", "start", "plain"])
def test_an_arc_commands_both_axes_of_its_plane(bench: Bench, block: str, before: str) -> None:
    """Its way is determined by them: without words of the axis that it does not name it would be a straight cut."""
    start: dict[str, float] = {}
    if before == "start":
        start, head = {"X": 100.0, "Y": 200.0, "Z": 300.0}, "G91 "
    else:
        head = f"G90 G0 X100. Y200. Z300.\n{before.removeprefix('plain')}"
    block = block if "G91" not in head else block.replace("X140.", "X40.")
    text = bench.run(f"G21\n{head}{block}\n", XyzMachine({"EXX": lambda x: 1e-5 * x}), start=start)
    at = execute(text, start=[100.0, 200.0, 300.0])[:, 0 if start else 1 :]
    across = 2 if "G18" in block else 1
    radius = np.hypot(at[0] * (1 + 1e-5) - 120.0, at[across] - (300.0 if across == 2 else 200.0))
    assert radius.size > 20
    assert radius == pytest.approx(20.0, abs=0.002)


def test_increments_from_a_start_get_no_absolute_words_later(bench: Bench) -> None:
    machine = paper_sized(10.0)
    text = bench.run(
        "G21\nG91 G0 X10. Z-5.\nX300.\nG90 Y50.\nX60.\nZ10.\n", machine, start={"X": 0.0, "Y": 0.0, "Z": 0.0}
    )
    assert words(text, "Z") == [2, 3, 6]  # line 3: an increment, right wherever Z is
    assert words(text, "X") == [2, 3, 5, 6]
    assert words(text, "Y") == [4, 5, 6]


def test_reversals_are_not_taken_up_by_axes_that_wait(bench: Bench) -> None:
    from tests.compensation.test_effect_programs import plain
    from trueaxis.effects.kind import Effect

    model = plain({Effect(kind="backlash", component="EXX"): {"width": -0.010}})
    text = bench.run("G21 G90\nG1 X5. F100\nX0.\nZ-5.\n", model, start={"X": 0.0, "Y": 0.0, "Z": 0.0})
    assert words(text, "Y") == []
    assert words(text, "Z") == [5]


def test_no_word_leaves_the_travel(bench: Bench) -> None:
    text = bench.run("G21 G90\nG0 X-10. Y-10. Z600.\nG1 X900. F100\nZ0.\nG91 Z600.\nG20 Z0.\n", bent())
    at = execute(text)
    assert at[2].max() == pytest.approx(600.0)
    assert at[0].max() <= 900.0
    assert not bench.report.good
    assert bench.report.out_of_travel.points >= 2
    assert 0.0 < bench.report.beyond_travel["Z"] < 0.2
    assert "X" not in bench.report.beyond_travel
    assert "out of travel, words stop at its end (" in bench.told


MOVES = st.lists(
    st.tuples(
        st.sampled_from(["G90 G0", "G90 G1", "G91 G0", "G91 G1", "M6", "M0", "G90 G3"]),
        st.tuples(*[st.one_of(st.none(), st.integers(-600, 600)) for _ in range(3)]),
    ),
    min_size=1,
    max_size=12,
)


@settings(max_examples=150, deadline=None)
@given(MOVES, st.booleans(), st.sampled_from(["nearest", "ends", "middles"]))
def test_absolute_words_only_for_commanded_axes(
    blocks: list[tuple[str, tuple[int | None, ...]]], started: bool, choice: str
) -> None:
    """Whatever the program: an axis has no absolute word before the program names it in G90, nor after M6."""
    import tempfile
    from pathlib import Path

    lines = ["G21"] if started else ["G21 G90 G0 X1. Y2. Z3."]
    for code, values in blocks:
        text = "".join(f" {axis}{v}." for axis, v in zip("XYZ", values, strict=True) if v is not None)
        lines.append(code if code[0] == "M" else (code + text + (" R900." if "G3" in code else "")) if text else "")
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(Path(folder))
        start = {"X": 5.0, "Y": 6.0, "Z": 7.0} if started else {}
        limits = dict.fromkeys("XYZ", (-1000.0, 1000.0))
        machine = XyzMachine(paper_sized(3.0).curves, travel=limits)
        try:
            written = bench.run(
                "\n".join(lines), machine, start=start, words=choice, ball=(0.0, 0.0, 99.0), chord_tolerance=1.0
            )
        except InputError:
            return
    source = iter(lines)
    named: set[str] = set()
    absolute = True
    at = dict(start)
    for line in written.decode().splitlines():
        if re.match(r"(G21|G9|M|$)", line):  # first of the blocks of a source block
            block = next(source)
            assert block.split()[:1] == line.split()[:1]
            if "G9" in block:
                absolute = "G90" in block
            named = set() if block in ("M6", "M0") else named
            own = set(re.findall("[XYZ]", block)) | (set("XY") if "G3" in block else set())
            named |= own if absolute else set()
        for axis, value in re.findall(r"([XYZ])([-.\d]+)", line):
            if absolute:
                assert axis in named, (line, lines)
                at[axis] = float(value)
            elif axis in at:
                at[axis] += float(value)
        assert all(abs(value) <= 1000.0 + 1e-9 for value in at.values())


def test_rotary_axes_that_are_kept_wait_for_nothing(bench: Bench) -> None:
    from tests.compensation.five_axes import TEXTS, FiveAxes

    machine = FiveAxes(TEXTS["table-table"])
    program = "G21 G90\nG0 X10. Y20. Z30.\nG1 X40. F100\n"
    text = bench.run(program, machine.model, start={"A": -20.00005, "C": 40.0})
    assert not words(text, "A") + words(text, "C")
    report = bench.report
    assert (report.uncommanded.points, report.uncommanded_left, report.good) == (0, None, True)
    assert not any("gets no word" in note for note in report.notes)
    assert report.sign_check is not None
    turned = bench.run(program, machine.model, start={"A": -20.0, "C": 40.0}, orientation="correct")
    assert not words(turned, "A") + words(turned, "C")
    assert not bench.report.good  # the tool axis of the cut is not corrected
    assert any("A C gets no word" in note for note in bench.report.notes)


def test_the_word_of_a_whole_step_has_a_decimal_point(bench: Bench) -> None:
    text = bench.run("G0 X10. Y0. Z0.\n", XyzMachine({"EXX": lambda x: 1.0 + 0 * x}), resolution=1.0, tolerance=1.0)
    assert text == b"G0 X9.0 Y0.0 Z0.0\n"
    assert np.isfinite(execute(text)).all()
