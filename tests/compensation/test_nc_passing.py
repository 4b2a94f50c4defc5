"""What must come back as it was."""

import re

import numpy as np
import pytest

from tests.compensation.analytic_machine import XyzMachine, paper_sized
from tests.compensation.control import Bench, execute

STRAIGHT = (
    b"%\r\n"
    b"O1234 (Gr\xfc\xdfe \x80)\r\n"
    b"  \t \r\n"
    b"; no comment; really   \r\n"
    b"N10 G21 G17 G90 G94 G40 G49 G80\r\n"
    b"N20 T3 M6   (tool)  \r\n"
    b"g0 x10.5Y-3.250z 7.  \n"
    b"N30 S2000 M3 M8\r\n"
    b"G1Z-1.F200.\r\n"
    b"X20. (to the right) Y5. M9\n"
    b"G4 X2.5\r\n"
    b"G91\r\n"
    b"X-1.125 F 150\r\n"
    b"X0.001 Y.5\r\n"
    b"G90 G64 P0.01\r\n"
    b"M30\r\n"
    b"%"
)


def test_without_errors_every_byte_comes_back(bench: Bench) -> None:
    assert bench.run(STRAIGHT) == STRAIGHT
    assert bench.report.blocks_in == STRAIGHT.count(b"\n") + 1 == bench.report.blocks_out - 1  # the mark


def test_with_errors_lines_that_move_nothing_come_back_byte_for_byte(bench: Bench) -> None:
    written = bench.run(STRAIGHT, paper_sized()).split(b"\n")
    source = STRAIGHT.split(b"\n")
    still = [line for line in source if not any(axis in line.split(b"(")[0] for axis in b"xXYZ") or b"G4" in line]
    assert len(still) == 12
    assert [line for line in written if line in still] == still
    assert source[0] == written[0]
    assert source[-1] == written[-1]


def test_moving_blocks_keep_their_other_words(bench: Bench) -> None:
    machine = XyzMachine({"EXX": lambda x: -0.01 + 0.0 * x, "EYX": lambda x: 0.02 + 0.0 * x})
    text = bench.run("G0 X0. Y0. Z0.\nN5 G1 X10. (cut; here) F300 M8 ;end\r\nX5.(a)Y6.F100\n", machine)
    # tool 0.01 short in x, 0.02 far in y; the table's y counts against the tool's
    assert text == b"G0 X0.010 Y0.020 Z0.000\nN5 G1 X10.010 (cut; here) F300 M8 ;end\r\nX5.010 Y6.020(a)F100\n".replace(
        b"X5.010 Y6.020", b"X5.010Y6.020"
    )


@pytest.mark.parametrize("ending", ["", "\n", "\r\n", "\r\r\n"])
def test_the_last_line_end_is_kept(bench: Bench, ending: str) -> None:
    text = bench.run(f"G0 X0. Y0. Z0.{ending or chr(10)}G3 X0. Y2. J1. F9{ending}", chord_tolerance=0.01)
    assert text.decode().endswith(f"Y2.000{ending}")
    assert len(text.splitlines()) > 5


def test_a_split_block_does_late_words_last_and_early_words_first(bench: Bench) -> None:
    text = bench.run("G0 X0. Y0. Z0.\nN7 M8 G3 M5 X0. Y2. J1. F9 (arc)\nM2", chord_tolerance=0.1)
    lines = text.decode().splitlines()
    assert lines[1].startswith("N7 M8 G1 X")
    assert lines[1].endswith(" F9 (arc)")
    assert "M5" not in lines[1]
    assert lines[-2].endswith("X0.000 Y2.000 M5") or lines[-2].endswith("Y2.000 M5")
    assert text.count(b"M5") == text.count(b"M8") == text.count(b"F9") == 1


def test_the_motion_in_force_is_restated_where_arcs_became_lines(bench: Bench) -> None:
    text = bench.run(
        "G0 X0. Y0. Z0.\nG3 X0. Y2. J1. F9\nX0. Y0. J-1.\nG1 X5.\nG2\nX5. Y2. J1.\nG0 X1.\n", chord_tolerance=0.1
    ).decode()
    motion = []
    force = ""
    for line in text.splitlines():
        for code in ("G0", "G1", "G2", "G3"):
            if code in line:
                force = code
        if any(axis in line for axis in "XYZ"):
            motion.append(force)
    assert motion[0] == motion[-1] == "G0"
    assert set(motion[1:-1]) == {"G1"}
    assert "\nG2\n" in text


def test_only_moved_axes_get_words(bench: Bench) -> None:
    machine = XyzMachine({"EZX": lambda x: 1e-4 * x})
    text = bench.run("G0 X0. Y0. Z0.\nG0 Y5.\nX10.\nX10.\n", machine)
    assert text == b"G0 X0. Y0. Z0.\nG0 Y5.\nX10.000 Z-0.001\nX10.000\n"


def test_a_byte_order_mark_is_no_garbage(bench: Bench) -> None:
    assert bench.run(b"\xef\xbb\xbfG21\nG0 X1. Y1. Z1.\n") == b"\xef\xbb\xbfG21\nG0 X1. Y1. Z1.\n"


def test_optional_blocks(bench: Bench) -> None:
    program = "G0 X0. Y0. Z0.\n/ G1 X1. F5\n/2 M8\nX5.\n"
    machine = XyzMachine({"EXX": lambda x: 1e-3 * x})
    assert execute(bench.run(program, machine, block_delete="run"))[0] == pytest.approx([0, 0.999, 4.995], abs=1e-9)
    assert any("a block with / is taken to be run" in note for note in bench.report.notes)
    skipped = bench.run(program.replace("X5.", "G1 X5."), machine, block_delete="skip")
    assert any("a block with / is taken to be skipped" in note for note in bench.report.notes)
    assert b"/ G1 X1. F5\n/2 M8\n" in skipped
    assert np.allclose(execute(skipped.replace(b"/ G1 X1. F5\n", b""))[0], [0, 4.995])


@pytest.mark.parametrize("switch", ["/", "/2", "/9", " /3"])
def test_every_piece_of_an_optional_block_hangs_on_the_same_switch(bench: Bench, switch: str) -> None:
    program = f"G0 X0. Y0. Z0.\n{switch}G2 X20. R10. F9\n{switch} X40. R10.\n"
    pieces = bench.run(program, block_delete="run", chord_tolerance=0.1).decode().splitlines()[1:]
    assert len(pieces) > 10
    assert {re.match(r"\s*(/\d?)", piece)[1] for piece in pieces} == {switch.strip()}  # type: ignore[index]
