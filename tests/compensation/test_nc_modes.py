"""Programs whose positions are worked out by hand."""

import numpy as np
import pytest

from tests.compensation.analytic_machine import XyzMachine, paper_sized
from tests.compensation.control import Bench, execute


def shifted() -> XyzMachine:
    """The tool stands 0.02 mm too far in x everywhere."""
    return XyzMachine({"EXX": lambda x: 0.02 + 0.0 * x})


def test_inch_and_metric(bench: Bench) -> None:
    text = bench.run("G20 G0 X1. Y2. Z0.\nG21 X30.\nG20 X1.5\n", shifted(), inch_resolution=0.0001)
    assert text == b"G20 G0 X0.9992 Y2. Z0.\nG21 X29.980\nG20 X1.4992\n".replace(b"Y2. Z0.", b"Y2.0000 Z0.0000")


def test_incremental_words_are_differences_of_rounded_positions(bench: Bench) -> None:
    machine = XyzMachine({"EXX": lambda x: 1e-3 * x})
    steps = 1000
    text = bench.run("G90 G0 X0. Y0. Z0.\nG91 G1 F100\n" + "X0.1234\n" * steps, machine)
    at = execute(text)[0][1:]
    wanted = 0.1234 * np.arange(1, steps + 1) / 1.001
    assert at.size == steps
    assert np.abs(at - wanted).max() <= 0.0005 + 1e-9  # the rounding of one word, after a thousand of them


def test_absolute_and_incremental_programs_agree(bench: Bench) -> None:
    points = np.round(np.random.default_rng(3).uniform(-200, 200, (30, 3)), 3)
    absolute = "G90 G0 X0. Y0. Z0.\n" + "".join(f"G1 X{x:.3f} Y{y:.3f} Z{z:.3f} F9\n" for x, y, z in points)
    steps = np.diff(points, axis=0, prepend=0.0)
    incremental = "G90 G0 X0. Y0. Z0.\nG91\n" + "".join(f"G1 X{x:.3f} Y{y:.3f} Z{z:.3f} F9\n" for x, y, z in steps)
    machine = paper_sized()
    a, b = execute(bench.run(absolute, machine)), execute(bench.run(incremental, machine))
    assert a.shape == b.shape
    assert np.abs(a - b).max() < 1e-6


def test_inch_and_metric_programs_agree(bench: Bench) -> None:
    points = np.round(np.random.default_rng(4).uniform(-7, 7, (20, 3)), 4)
    inch = "G20\n" + "".join(f"G0 X{x:.4f} Y{y:.4f} Z{z:.4f}\n" for x, y, z in points)
    metric = "G21\n" + "".join(f"G0 X{25.4 * x:.5f} Y{25.4 * y:.5f} Z{25.4 * z:.5f}\n" for x, y, z in points)
    machine = paper_sized()
    a, b = execute(bench.run(inch, machine)), execute(bench.run(metric, machine))
    assert np.abs(a - b).max() < 0.0005 + 0.000127 + 1e-9


def test_incremental_inch_after_metric_does_not_lose_the_lattice(bench: Bench) -> None:
    text = bench.run("G90 G21 G0 X0.123 Y0. Z0.\nG91 G20 G1 F10\n" + "X0.0333\n" * 200, shifted())
    at = execute(text)[0][1:]
    wanted = 0.123 - 0.02 + 0.0333 * 25.4 * np.arange(1, 201)
    assert np.abs(at - wanted).max() <= 0.00001 * 25.4 / 2 + 1e-9


def test_start_makes_a_first_incremental_move_possible(bench: Bench) -> None:
    text = bench.run("G91 G0 X10.\n", shifted(), start={"X": 5.0, "Y": 1.0, "Z": 2.0})
    assert text == b"G91 G0 X9.980\n"  # from 5, where the machine stands uncorrected, to 15 - 0.02


def test_unknown_start_is_complete_after_one_block(bench: Bench) -> None:
    text = bench.run("G1 X1. Y2. Z3. F5\n", shifted())
    assert text == b"G1 X0.980 Y2.000 Z3.000 F5\n"
    assert any("unknown position" in note for note in bench.report.notes)


def test_dwell_is_no_position(bench: Bench) -> None:
    assert execute(bench.run("G0 X1. Y1. Z1.\nG4 X5.\nG91 X1.\n", shifted()))[0] == pytest.approx([0.98, 1.98])


def test_a_block_numbered_by_a_colon_is_a_block(bench: Bench) -> None:
    assert bench.run(":1234\nG0 X1. Y2. Z3.\n:20 G1 X5. F9\n", shifted()) == (
        b":1234\nG0 X0.980 Y2.000 Z3.000\n:20 G1 X4.980 F9\n"
    )


def test_a_block_in_machine_coordinates(bench: Bench) -> None:
    machine = XyzMachine({"EXX": lambda x: 0.02 + 0.0 * x, "EZX": lambda x: 1e-7 * x * x})
    text = bench.run("G21 G90\nG0 X0. Y0. Z0.\nG53 Z5.\nG53 G0 X500.\nX0.\nG53 G1 X900. F9\n", machine).splitlines()
    assert text[2:5] == [b"G53 Z5.000", b"G53 G0 X499.980 Z4.975", b"X-0.020 Z5.000"]
    # a cut block stays one in machine coordinates
    assert len(text) > 8
    assert all(line.startswith(b"G53 ") for line in text[5:])
    assert any("no work offset may be active" in note for note in bench.report.warnings)
    assert any("at rapid even under G1" in note for note in bench.report.notes)


@pytest.mark.parametrize(
    ("said", "missing"),
    [("", ["G20 or G21", "G90 or G91"]), ("G21 ", ["G90 or G91"]), ("G90 ", ["G20 or G21"]), ("G20 G90 ", [])],
)
def test_modes_that_are_not_stated_are_noted(bench: Bench, said: str, missing: list[str]) -> None:
    bench.run(f"{said}G0 X1. Y1. Z1.\nX2.\n")
    found = [note for note in bench.report.warnings if "before this motion" in note]
    assert len(found) == len(missing)
    assert all(note.startswith(f"line 1: no {mode}") for note, mode in zip(found, missing, strict=True))


UNFED = "no F above 0 before this feed motion"
MANY = "".join(f"X{n}.\n" for n in range(40))  # taken together where they are plain


@pytest.mark.parametrize(
    ("program", "line"),
    [
        ("G0 X0. Y0. Z0.\nG1 X1.\nX2.\n", 2),
        ("G0 X0. Y0. Z0.\n" + MANY + "G1\n" + MANY, 43),
        ("G0 X0. Y0. Z0.\n" + MANY + "G1 X1. F0.\n" + MANY, 42),
        ("G0 X0. Y0. Z0.\n" + MANY + "G1 X1. F100.\n" + MANY, 0),
        ("G0 X0. Y0. Z0.\n" + MANY + "F100.\nG1\n" + MANY, 0),
        ("G0 X0. Y0. Z0.\n" + MANY, 0),
        ("G0 X0. Y0. Z0.\nG3 X2. I1. J0.\n", 2),
        ("G0 X0. Y0. Z9.\nG81 X1. Y1. Z-3. R2.\n", 2),
        ("G0 X0. Y0. Z0.\nG1 X1. F9.\nG95\nX2.\nX3. F0.1\n", 4),
        ("G0 X0. Y0. Z0.\nG93 G1 X1. F9.\nX2. F9.\n", 0),
    ],
)
def test_a_feed_motion_without_a_feed_is_noted_once(bench: Bench, program: str, line: int) -> None:
    """LinuxCNC, Fanuc and SINUMERIK stop at such a block."""
    bench.run("G21 G90 " + program)
    found = [note for note in bench.report.notes if UNFED in note]
    assert found == ([f"line {line}: {found[0][found[0].index(UNFED) :]}"] if line else [])
