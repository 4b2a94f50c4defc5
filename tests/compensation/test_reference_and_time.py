"""G28 and G30, G93, what follows the end of a program, names of programs, blocks with /."""

import math
import re

import numpy as np
import pytest

from tests.compensation.analytic_machine import XyzMachine, paper_sized
from tests.compensation.control import Bench
from tests.compensation.shop_control import AXES
from tests.compensation.test_offsets import KNOWN, both, off
from tests.compensation.test_uncommanded import words
from trueaxis.io.faults import InputError

POINTS = {"G28": {"X": 0.0, "Y": 0.0, "Z": 300.0}, "G30": {"Z": 250.0}}
HOMING = """N1 G21 G90 G54
N2 G91 G28 Z0.
N3 G90 G0 X10. Y20.
N4 Z5.
N5 G1 X50. F100
N6 G91 G28 Z0.
N7 G28 X0. Y0.
N8 G90 G0 X5.
N9 Y9.
N10 Z8.
N11 G1 X70. Y7. F90
N12 G91 G30 Z0
N13 G1 X-5.
N14 G90 G28 X30. Y30.
"""


@pytest.mark.parametrize("points", [{}, POINTS])
def test_reference_points(bench: Bench, points: dict[str, dict[str, float]]) -> None:
    machine = paper_sized(3.0)
    program = HOMING if points else HOMING.replace("N13 G1 X-5.\n", "")
    written = bench.run(program, machine, offsets=KNOWN, reference_points=points)
    lines = written.decode().splitlines()
    for block in ("N2 G91 G28 Z0.", "N7 G28 X0. Y0.", "N12 G91 G30 Z0", "N14 G90 G28 X30. Y30."):
        assert block in lines
    true = {"G54": {axis: value[0] + 4.0 for axis, value in KNOWN.systems["G54"].items()}}
    for offsets in ({}, {"offsets": true}):
        source, control = both(
            program, written, references={28: POINTS["G28"], 30: {**POINTS["G28"], **POINTS["G30"]}}, **offsets
        )
        ends = {number: at for number, _, at, _ in control.trace}
        for number, _, at, _ in source.trace:
            assert max(abs(at[axis] - ends[number][axis]) for axis in AXES) < 0.3, number
        if not offsets and not points:
            assert off(machine, source, control) <= 0.0011
    assert bool(points) != any("[reference_points] of the spec can say" in note for note in bench.report.notes)


def test_no_word_after_a_reference_point_before_the_program_gives_one(bench: Bench) -> None:
    text = bench.run("G21 G90\nG0 X1. Y2. Z3.\nG91 G28 Z0.\nG90 X500.\nY-500.\nZ1.\n", paper_sized(9.0))
    assert words(text, "Z") == [2, 3, 6]
    with pytest.raises(InputError, match="position of Z is not known"):
        bench.run("G21 G90\nG0 X1. Y2. Z3.\nG91 G28 Z0.\nG1 X5. F100\n")
    with pytest.raises(InputError, match="G28 without axis words"):
        bench.run("G21 G90\nG28\n")
    assert bench.run("G21 G90\nG28\n", dialect="linuxcnc") == b"G21 G90\nG28\n"
    with pytest.raises(InputError, match="a motion, in one block"):
        bench.run("G21 G90\nG0 X1. Y2. Z3.\nG2 G28 X0.\n")


def test_other_reference_points_are_not_known(bench: Bench) -> None:
    bench.run("G21 G90\nG91 G30 P3 Z0.\nG90 G0 X1. Y1.\n", reference_points=POINTS)
    assert any("G30 Z: where it leads is not known" in note for note in bench.report.notes)


def test_inverse_time_is_split_over_the_pieces(bench: Bench) -> None:
    machine = XyzMachine({"EYX": lambda x: 1e-7 * x * x})
    program = (
        "N1 G21 G90\nN2 G0 X0. Y0. Z0.\nN3 G93 G1 X400. Y30. F0.5 M8\nN4 X0. F2. M9\n"
        "N5 G2 X20. Y30. R10. F12.5\nN6 G1 X21. F100.\nN7 G94 X50. F300\n"
    )
    text = bench.run(program, machine, integers="mm").decode()
    times: dict[int, float] = {}
    number, inverse = 0, False
    for line in text.splitlines():
        found = dict(re.findall(r"([A-Z])([-.\d]+)", line))
        number = int(found.get("N", number))
        inverse = ("G93" in line or inverse) and "G94" not in line
        if inverse and number > 2:
            times[number] = times.get(number, 0.0) + 1.0 / float(found["F"])
    assert times == pytest.approx({3: 2.0, 4: 0.5, 5: 0.08, 6: 0.01}, rel=1e-5)
    pieces = [line for line in text.splitlines() if line.startswith("N3") or (line[0] == "X" and "Y" in line)]
    assert len(pieces) > 6
    assert text.count("M8") == text.count("M9") == 1
    # equal speed all along a cut line
    cut = text[text.index("N3") : text.index("N4")].splitlines()
    at, speeds = np.zeros(2), []
    for line in cut:
        found = dict(re.findall(r"([A-Z])([-.\d]+)", line))
        end = np.array([float(found["X"]), float(found.get("Y", at[1]))])
        speeds.append(float(np.linalg.norm(end - at)) * float(found["F"]))
        at = end
    assert speeds == pytest.approx([0.5 * math.hypot(400.0, 30.0)] * len(cut), rel=1e-3)


@pytest.mark.parametrize("block", ["G93 G1 X5.", "G93 G1 X5. F0", "G93 G1 F5\nX5.", "G93 G1 X5. F5\nX6."])
def test_inverse_time_needs_f_in_each_block(bench: Bench, block: str) -> None:
    with pytest.raises(InputError, match="under G93 without F"):
        bench.run(f"G21 G90\nG0 X0. Y0. Z0.\n{block}\n", integers="mm")


def test_what_follows_the_end_is_copied(bench: Bench) -> None:
    machine = XyzMachine({"EXX": lambda x: 0.02 + 0.0 * x})
    tail = "M30\n(rest)\nG1 X5. Y7. @#!\nO5\nG54\n%\n"
    text = bench.run(f"G21 G90\nG0 X1. Y1. Z1.\n{tail}", machine).decode()
    assert text == f"G21 G90\nG0 X0.980 Y1.000 Z1.000\n{tail}"
    (note,) = (note for note in bench.report.warnings if "end of the program" in note)
    assert note.startswith("line 5: ")
    assert not any("end of the program" in note for note in _notes(bench, "G0 X1. Y1. Z1.\nM30\n(X5.)\n%\n"))
    with pytest.raises(InputError, match="depends on a switch"):
        bench.run("G21 G90\nG0 X1. Y1. Z1.\n/M30\nG1 X5. F9\n")


def _notes(bench: Bench, program: str) -> tuple[str, ...]:
    bench.run(program)
    return bench.report.notes


def test_names_of_programs(bench: Bench) -> None:
    program = b"%\nO<PART-7> (first)\nG21 G90\nG0 X1. Y1. Z1.\nM30\n%\n"
    assert bench.run(program) == program
    with pytest.raises(InputError):
        bench.run("O<part> sub\nG0 X1. Y1. Z1.\n")
    with pytest.raises(InputError, match="a program number after motions"):
        bench.run("G0 X1. Y1. Z1.\nO<part>\n")
