"""Lines are cut where the errors bend, and only there."""

import numpy as np
import pytest

from tests.compensation.analytic_machine import FloatArray, XyzMachine
from tests.compensation.control import Bench, execute

ORIGIN = np.zeros((3, 1))


def along(machine: XyzMachine, commands: FloatArray, start: FloatArray, end: FloatArray) -> FloatArray:
    """Error vectors along executed lines, 41 samples a block; the line is wanted straight in the axes."""
    shares = np.linspace(0.0, 1.0, 41)
    found = []
    for a, b in zip(commands.T[:-1], commands.T[1:], strict=True):
        at = a[:, None] + shares * (b - a)[:, None]
        tool = machine.actual(at, ORIGIN)
        first, last = machine.ideal(start[:, None], ORIGIN), machine.ideal(end[:, None], ORIGIN)
        way = (last - first) / np.linalg.norm(last - first)
        off = tool - first
        found.append(np.linalg.norm(off - way * (way * off).sum(axis=0), axis=0))
    return np.concatenate(found)


def test_straight_errors_need_no_cut(bench: Bench) -> None:
    machine = XyzMachine({"EXX": lambda x: 1e-4 * x, "EYX": lambda x: 2e-5 * x})
    text = bench.run("G0 X0. Y0. Z0.\nG1 X400. F100\n", machine)
    assert text.count(b"\n") == 2


def test_rapids_are_not_cut(bench: Bench) -> None:
    machine = XyzMachine({"EYX": lambda x: 1e-6 * x * x})
    assert bench.run("G0 X0. Y0. Z0.\nG0 X400.\n", machine).count(b"\n") == 2


@pytest.mark.parametrize(
    "curve",
    [
        lambda x: 1e-7 * x * x,
        lambda x: 1e-9 * (x - 200.0) ** 3,  # odd about the middle: the middle alone shows nothing
        lambda x: 0.004 * np.sin(2 * np.pi * x / 10.0),  # a ball screw's pitch
        lambda x: np.interp(x, np.arange(0.0, 401.0, 40.0), 0.005 * (np.arange(11) % 3 - 1.0)),
    ],
)
def test_the_line_stays_straight(bench: Bench, curve: object) -> None:
    machine = XyzMachine({"EYX": curve, "EZX": curve})  # type: ignore[dict-item]
    text = bench.run("G0 X0. Y0. Z0.\nG1 X400. Y30. F100\n", machine)
    at = execute(text)
    off = along(machine, at, np.zeros(3), np.array([400.0, 30.0, 0.0]))
    # rounding of words, half a step in two directions across; and what the cutting leaves
    assert off.max() <= 0.0005 * np.sqrt(3) + 0.25 * 0.001 + 0.0001
    assert bench.report.points > 3


def test_cuts_follow_the_bend(bench: Bench) -> None:
    machine = XyzMachine({"EYX": lambda x: np.where(x > 300.0, 1e-5 * (x - 300.0) ** 2, 0.0)})
    at = execute(bench.run("G0 X0. Y0. Z0.\nG1 X400. F100\n", machine))
    assert (at[0] <= 300.0).sum() < (at[0] > 300.0).sum() / 3


def test_a_jump_does_not_cut_for_ever(bench: Bench) -> None:
    machine = XyzMachine({"EYX": lambda x: np.where(x > 100.0, 0.05, 0.0)})
    assert bench.run("G0 X0. Y0. Z0.\nG1 X400. F100\n", machine).count(b"\n") < 40
