"""The iteration of Eqs. (55) and (56) on machines worked out independently."""

import numpy as np
import pytest

from tests.compensation.analytic_machine import FloatArray, XyzMachine, paper_sized
from tests.compensation.control import Bench, execute
from trueaxis.compensation.solve import MOST_STEPS, solve

ORIGIN = np.zeros((3, 1))


def points(count: int = 200) -> FloatArray:
    return np.random.default_rng(1).uniform(0.0, 500.0, (3, count))


def test_the_tool_gets_where_an_error_free_machine_would_be() -> None:
    machine, tool = paper_sized(), np.array([[10.0], [-20.0], [-150.0]])
    programmed = points()
    solution = solve(programmed, programmed, machine, tool, 1e-9)
    off = machine.actual(solution.commands, tool) - machine.ideal(programmed, tool)
    assert solution.before.min() > 1e-4
    assert np.abs(off).max() < 1e-10
    assert solution.converged.all()
    assert solution.residual == pytest.approx(np.sqrt((off**2).sum(axis=0)), abs=1e-12)


def test_one_constant_error_is_undone_in_one_step() -> None:
    machine = XyzMachine({"EXX": lambda x: 0.02 + 0.0 * x})
    solution = solve(points(), points(), machine, ORIGIN, 1e-9)
    assert solution.steps.max() == 1
    assert solution.commands[0] == pytest.approx(points()[0] - 0.02)


@pytest.mark.parametrize("gradient", [1e-4, 1e-2, -1e-2, 0.2])
def test_each_step_leaves_the_error_times_its_gradient(gradient: float) -> None:
    machine = XyzMachine({"EXX": lambda x: gradient * x})
    programmed = points()
    left = []
    for tolerance in (1e-3, 1e-6, 1e-9):
        solution = solve(programmed, programmed, machine, ORIGIN, tolerance)
        worst = np.abs(gradient) ** (solution.steps + 1) * programmed[0]  # |c x| |c|^k, the fixed-point series
        assert solution.residual == pytest.approx(worst, rel=1e-3, abs=1e-11)
        left.append(solution.residual.max())
        assert solution.residual.max() <= 0.01 * tolerance
    assert left == sorted(left, reverse=True)
    exact = programmed[0] / (1.0 + gradient)
    assert solution.commands[0] == pytest.approx(exact, abs=1e-10)


def test_ordinary_is_the_first_step_and_no_more() -> None:
    machine = paper_sized(scale=300.0)
    programmed = points()
    once = solve(programmed, programmed, machine, ORIGIN, 0.001, "ordinary")
    deviation = machine.deviation(programmed, ORIGIN)
    assert once.commands == pytest.approx(programmed - deviation * np.array([[1.0], [-1.0], [1.0]]))
    more = solve(programmed, programmed, machine, ORIGIN, 0.001)
    assert once.residual.max() > 0.01
    assert more.residual.max() < 1e-5
    assert more.steps.min() >= 2


def test_what_does_not_converge_is_told_and_keeps_the_best(bench: Bench) -> None:
    machine = XyzMachine({"EXX": lambda x: 3.0 * np.sin(40.0 * x)})  # gradient far above 1
    programmed = points()
    solution = solve(programmed, programmed, machine, ORIGIN, 0.001)
    assert not solution.converged.all()
    assert (solution.residual <= solution.before).all()
    assert solution.steps.max() <= MOST_STEPS
    bench.run("G0 X1. Y1. Z1.\nG0 X2.3\nX2.71\n", machine)
    assert not bench.report.good
    assert bench.report.not_converged.points
    assert set(bench.report.not_converged.first) <= {1, 2, 3}


def test_a_model_that_is_not_finite_is_no_result(bench: Bench) -> None:
    machine = XyzMachine({"EXX": lambda x: np.where(x > 50.0, np.nan, 0.001)})
    text = bench.run("G0 X1. Y1. Z1.\nG0 X60.\n", machine)
    assert bench.report.not_converged.first == (2,)
    assert execute(text)[0] == pytest.approx([0.999, 60.0])
    assert not bench.report.good


class Turntable(XyzMachine):
    """The same with a table C on the Y slide: the workpiece frame turns by C (deg)."""

    def __init__(self) -> None:
        super().__init__(
            {"EXX": lambda x: 1e-4 * x, "ECY": lambda y: 1e-6 * y},
            (1e-5, 2e-5, 3e-5),
            ("X", "Y", "Z", "C"),
            {**XyzMachine().travel, "C": (-360.0, 360.0)},
        )

    @staticmethod
    def turned(vectors: FloatArray, c: FloatArray, sense: float) -> FloatArray:
        angle = sense * np.radians(c)
        cos, sin = np.cos(angle), np.sin(angle)
        return np.stack([cos * vectors[0] - sin * vectors[1], sin * vectors[0] + cos * vectors[1], vectors[2]])

    def ideal(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        return self.turned(super().ideal(positions[:3], point), positions[3], -1.0)

    def actual(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        wobble = 2e-4 * np.sin(np.radians(positions[3]))  # EXC
        moved = super().actual(positions[:3], point) + np.stack([wobble, 0.0 * wobble, 0.0 * wobble])
        return self.turned(moved, positions[3] + 0.002, -1.0)  # C stands 0.002 deg off

    def correction(self, positions: FloatArray, deviation: FloatArray) -> FloatArray:
        slides = self.turned(deviation, positions[3], 1.0) * np.array([[1.0], [-1.0], [1.0]])
        return np.concatenate([slides, np.zeros((1, positions.shape[1]))])


def test_rotary_axes_keep_their_words_and_the_slides_make_up(bench: Bench) -> None:
    machine = Turntable()
    program = "G0 X100. Y50. Z10. C0.\nG1 X120. C30. F100\nC90.12345\nG91 C-20.\n"
    text = bench.run(program, machine)
    at = execute(text, "XYZC")
    assert at[3, -1] == pytest.approx(70.1235, abs=1.1e-4)
    last = np.array([[120.0], [50.0], [10.0], [70.12345]])
    off = machine.actual(at[:, -1:], ORIGIN) - machine.ideal(last, ORIGIN)
    assert np.abs(off).max() < 0.0009
    before = machine.actual(last, ORIGIN) - machine.ideal(last, ORIGIN)
    assert np.abs(before).max() > 0.005
    assert bench.report.good
