"""Which lattice points become words, and what that leaves along the ball bar (Eqs. 5, 6)."""

from itertools import product

import numpy as np
import pytest

from tests.compensation.analytic_machine import FloatArray, XyzMachine, paper_sized
from tests.compensation.control import Bench, execute
from trueaxis.compensation.settings import Settings, decimals
from trueaxis.compensation.word_choice import choose

ORIGIN = np.zeros((3, 1))
BALL = np.array([[270.0], [-350.0], [40.0]])
PAPER = {"mean": 0.000244, "sd": 0.000119, "largest": 0.00053}  # Sect. 5.2, iterative method


def s_path(count: int = 600) -> FloatArray:
    """Axis positions on an S of two arcs of 270 deg, radius 60 mm, climbing, (3, count), four decimals."""
    share = np.linspace(0.0, 1.0, count)
    turn = np.pi * (3.0 * np.minimum(share, 1.0 - share) - 0.5)
    side = np.where(share < 0.5, 60.0, -60.0)
    x, y = side * np.sin(turn), side * (1.0 + np.cos(turn))
    return np.asarray(np.round(np.stack([270.0 + x, 350.0 + y, 100.0 + 30.0 * share]), 4), dtype=np.float64)


def program(path: FloatArray) -> str:
    first = "G90 G21\nG0 X{:.4f} Y{:.4f} Z{:.4f}\n".format(*path[:, 0])
    return first + "".join(f"G1 X{x:.4f} Y{y:.4f} Z{z:.4f} F1000\n" for x, y, z in path[:, 1:].T)


def bar_error(machine: XyzMachine, commands: FloatArray, wanted: FloatArray) -> FloatArray:
    """E of Eq. (6) with l1 the ideal length."""
    ideal = machine.ideal(wanted, ORIGIN)
    actual = machine.actual(commands, ORIGIN)
    return np.asarray(np.linalg.norm(actual - BALL, axis=0) - np.linalg.norm(ideal - BALL, axis=0))


def vector(machine: XyzMachine, commands: FloatArray, wanted: FloatArray) -> FloatArray:
    return np.asarray(np.linalg.norm(machine.actual(commands, ORIGIN) - machine.ideal(wanted, ORIGIN), axis=0))


def ball() -> tuple[float, float, float]:
    return (float(BALL[0, 0]), float(BALL[1, 0]), float(BALL[2, 0]))


@pytest.mark.parametrize(("resolution", "digits"), [(0.001, 3), (0.01, 2), (1.0, 0), (0.0005, 4), (0.00001, 5)])
def test_decimals(resolution: float, digits: int) -> None:
    assert decimals(resolution) == digits
    with pytest.raises(ValueError, match="more than 7"):
        decimals(1.0 / 3.0)


@pytest.mark.parametrize("resolution", [0.001, 0.0005, 0.002, 0.01])
def test_words_are_the_nearest_multiples(bench: Bench, resolution: float) -> None:
    path, machine = s_path(200), paper_sized()
    at = execute(bench.run(program(path), machine, resolution=resolution, tolerance=0.02))
    assert np.abs(at / resolution - np.rint(at / resolution)).max() < 1e-6
    off = machine.actual(at, ORIGIN) - machine.ideal(path, ORIGIN)
    assert np.abs(off).max() <= resolution / 2 + 1e-5
    assert np.abs(off).max() > 0.45 * resolution


def test_plain_rounding_is_all_that_the_papers_result_holds(bench: Bench) -> None:
    """The commands are right to 1e-5 mm before they are rounded; rounding alone makes the paper's mean of E."""
    path, machine = s_path(3000), paper_sized()
    at = execute(bench.run(program(path), machine, ball=ball()))
    e = np.abs(bar_error(machine, at, path))
    assert bench.report.ball is not None
    assert bench.report.ball.solved is not None
    assert bench.report.ball.solved.largest < 1e-5
    assert e.mean() == pytest.approx(PAPER["mean"], rel=0.03)
    # rounding with no machine at all: uniform in a cube of one step, seen along random directions
    random = np.random.default_rng(2)
    cube = random.uniform(-0.0005, 0.0005, (3, 400_000))
    anywhere = random.normal(size=cube.shape)
    in_plane = anywhere * np.array([[1.0], [1.0], [0.0]])
    for way, close in ((anywhere, 0.03), (in_plane, 0.005)):
        e = np.abs((cube * way).sum(axis=0)) / np.linalg.norm(way, axis=0)
        assert e.mean() == pytest.approx(PAPER["mean"], rel=close)


def test_report_is_what_an_independent_control_and_machine_find(bench: Bench) -> None:
    path, machine = s_path(400), paper_sized()
    at = execute(bench.run(program(path), machine, ball=ball()))
    e, v = np.abs(bar_error(machine, at, path)), vector(machine, at, path)
    report = bench.report
    assert report.ball is not None
    for found, values in ((report.ball.after, e), (report.after, v), (report.before, vector(machine, path, path))):
        assert found is not None
        assert found.mean == pytest.approx(values.mean(), rel=1e-6)
        assert found.sd == pytest.approx(values.std(), rel=1e-6)
        assert found.largest == pytest.approx(values.max(), rel=1e-6)
        assert found.line == int(np.argmax(values)) + 2


def test_ends_are_the_best_lattice_points_within_one_step(bench: Bench) -> None:
    """Against all lattice points of a wider neighbourhood: none within the limit is better."""
    path, machine = s_path(120), paper_sized()
    at = execute(bench.run(program(path), machine, ball=ball(), words="ends"))
    chosen = np.abs(bar_error(machine, at, path))
    assert vector(machine, at, path).max() <= 0.001
    best = np.full(path.shape[1], np.inf)
    for offset in product(range(-3, 4), repeat=3):
        tried = np.round(at, 3) + 0.001 * np.array([offset]).T
        inside = vector(machine, tried, path) <= 0.001
        best = np.where(inside, np.minimum(best, np.abs(bar_error(machine, tried, path))), best)
    assert chosen == pytest.approx(best, abs=2e-7)  # candidates are judged to first order


def test_ends_halve_the_mean_and_middles_do_better(bench: Bench) -> None:
    path, machine = s_path(1500), paper_sized()
    text = program(path)
    mean = {}
    for words in ("nearest", "ends", "middles"):
        bench.run(text, machine, ball=ball(), words=words)
        report = bench.report
        assert report.after is not None
        assert report.along is not None
        assert report.ball is not None
        assert report.ball.after is not None
        assert report.after.largest <= 0.001
        assert report.along.largest <= 0.001 + 1e-5
        mean[words] = report.ball.after.mean
        assert report.good
    assert mean["ends"] < 0.6 * mean["nearest"]
    assert mean["middles"] <= 0.00005


def test_middles_pass_the_points_half_way_between_words(bench: Bench) -> None:
    path, machine = s_path(300), paper_sized()
    at = execute(bench.run(program(path), machine, ball=ball(), words="middles"))
    step = np.linalg.norm(np.diff(at, axis=1), axis=0)
    short = np.flatnonzero(step < 0.05)
    assert short.size == bench.report.short_blocks > 290
    assert step[short].min() > 0.012
    assert step[short].max() < 0.043
    passed = 0.5 * (at[:, short] + at[:, short + 1])
    nearest = np.argmin(np.linalg.norm(passed[:, :, None] - path[:, None, :], axis=0), axis=1)
    assert np.all(np.diff(nearest) > 0)
    wanted = path[:, nearest]
    assert vector(machine, passed, wanted).max() <= 0.001
    assert np.abs(bar_error(machine, passed, wanted)).mean() < 0.00006
    # the way between, seen from the wanted lines: nowhere off by more than a step
    for end in (short, short + 1):
        off = machine.actual(at[:, end], ORIGIN) - machine.ideal(wanted, ORIGIN)
        tangent = np.gradient(machine.ideal(path, ORIGIN), axis=1)[:, nearest]
        tangent /= np.linalg.norm(tangent, axis=0)
        across = off - (off * tangent).sum(axis=0) * tangent
        assert np.linalg.norm(across, axis=0)[1:-1].max() <= 0.0013


def test_points_where_something_is_due_are_not_run_through(bench: Bench) -> None:
    path = s_path(300)
    lines = program(path).splitlines()
    lines[10] += " M5"
    lines.insert(20, "G4 P1.")
    at = execute(bench.run("\n".join(lines), paper_sized(), ball=ball(), words="middles"))
    stops = path[:, [9, 18]]

    def blocks_near(point: FloatArray) -> int:
        return int((np.linalg.norm(at - point[:, None], axis=0) < 0.1).sum())

    assert [blocks_near(point) for point in stops.T] == [1, 1]
    assert [blocks_near(path[:, index]) for index in (7, 11, 16, 20)] == [2, 2, 2, 2]


def test_incremental_and_inch_programs_choose_words_too(bench: Bench) -> None:
    path, machine = s_path(200), paper_sized()
    steps = np.diff(path, axis=1)
    text = program(path[:, :1]) + "G91 G1 F1000\n" + "".join(f"X{x:.4f} Y{y:.4f} Z{z:.4f}\n" for x, y, z in steps.T)
    for words, most in (("ends", 0.00016), ("middles", 0.00006)):
        at = execute(bench.run(text, machine, ball=ball(), words=words))
        assert bench.report.ball is not None
        assert bench.report.ball.after is not None
        assert bench.report.ball.after.mean < most
        if words == "ends":
            assert np.abs(bar_error(machine, at, path)).mean() < most


def test_choose_counts_only_what_is_within_the_limit() -> None:
    error = np.array([[0.0004, 0.0], [0.0, 0.0], [0.0, 0.0]])
    target = np.array([[100.0, 0.0], [0.0, 0.0], [0.0, 100.0]])
    moves = np.repeat((0.001 * np.eye(3))[:, :, None], 2, axis=2)
    offset, least = choose(error, target, ORIGIN, moves, 1, 0.0003)
    assert np.isinf(least[0, 0])
    assert not offset[:, 0, 0].any()
    offset, least = choose(error, target, ORIGIN, moves, 1, 0.001)
    assert least[0] == pytest.approx([0.0004, 0.0])  # along x nothing but whole steps helps


def test_settings_say_what_is_wrong() -> None:
    with pytest.raises(ValueError, match="give the ball"):
        Settings(words="ends")
    for wrong in ({"tolerance": 0.0}, {"resolution": float("nan")}, {"ball": (0.0, 0.0, float("inf"))}):
        with pytest.raises(ValueError, match="must"):
            Settings(**wrong)
