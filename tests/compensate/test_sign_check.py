"""The point of the sign check, against a machine of matrices."""

import json
import math

import numpy as np
import pytest

from tests.compensate.analytic_machine import XyzMachine, paper_sized
from tests.compensate.control import Bench, execute

ORIGIN = np.zeros((3, 1))


def test_it_is_where_a_gauge_moves_most(bench: Bench) -> None:
    points = np.round(np.random.default_rng(5).uniform(-400, 400, (40, 3)), 3)
    program = "G21 G90\n" + "".join(f"G0 X{x:.3f} Y{y:.3f} Z{z:.3f}\n" for x, y, z in points)
    machine = paper_sized()
    at = execute(bench.run(program, machine))
    since = machine.deviation(points.T, ORIGIN) - machine.deviation(ORIGIN, ORIGIN)
    direction, index = np.unravel_index(np.argmax(np.abs(since)), since.shape)
    check = bench.report.sign_check
    assert check is not None
    assert (check.line, check.direction, check.axis) == (int(index) + 2, "XYZ"[direction], "XYZ"[direction])
    assert check.since_home == pytest.approx(since[direction, index])
    assert check.deviation == pytest.approx(machine.deviation(points.T, ORIGIN)[direction, index])
    assert check.command == pytest.approx(at[direction, index])
    # the command undoes what the gauge shows: in X and Z against it, in Y, which moves the table, with it
    moved = check.command - check.position[check.axis]
    assert check.sense == (-1 if check.axis == "Y" else 1)
    assert math.copysign(1.0, moved) == -check.sense * math.copysign(1.0, check.deviation)
    assert json.loads(bench.report.to_json())["sign_check"]["since_home"] == check.since_home


def test_the_words_of_a_table_that_moves(bench: Bench) -> None:
    text = bench.run("G21 G90\nG0 X0. Y0. Z0.\nY200.\n", XyzMachine({"EYY": lambda y: -6e-5 * y}))
    # the table goes 12 um too little to Y+, so the tool stands 12 um too far to Y+ of the workpiece; Y+ takes it to Y-
    assert text.endswith(b"Y200.012\n")
    shown = str(bench.report)
    assert "at X0 Y200 Z0 (line 3) the error values displace the tool point by dY = +0.0120 mm" in shown
    assert "that is zero at X0 Y0 Z0 must show +0.0120 mm there" in shown
    assert "towards Y+ of the workpiece (which is where Y- commands move it)" in shown
    assert "commands Y200.012, +0.0120 mm" in shown


def test_it_is_left_out_where_nothing_is_to_be_seen(bench: Bench) -> None:
    bench.run("G21 G90\nG0 X1. Y1. Z1.\n")
    assert bench.report.sign_check is None
    bench.run("G21 G90\nG0 X1. Y1. Z1.\n", XyzMachine({"EXX": lambda x: 0.01 + 0.0 * x}))
    assert bench.report.sign_check is None  # the same at home: a gauge set to zero there shows nothing
