"""The demonstration: its paths by hand, its evaluation by itself, and the whole of it once."""

from pathlib import Path

import numpy as np
import pytest

from tests.command_lines import run
from tests.hostile import make_hostile, run_of
from tests.machines import ROOT
from trueaxis.compensation.files import commanded_ends
from trueaxis.demo import inputs
from trueaxis.demo.evaluate import ESTIMATE, PROPOSED, STEPWISE, path_errors, read_wanted
from trueaxis.io.faults import InputError


class ShiftedMachine:
    """A machine whose tool is 0.001 mm off in X everywhere; workpiece frame and axes coincide."""

    def ideal(self, positions: np.ndarray, point: np.ndarray) -> np.ndarray:
        return np.asarray(positions + point)

    def deviation(self, positions: np.ndarray, _: np.ndarray) -> np.ndarray:
        return np.repeat([[1e-3], [0.0], [0.0]], positions.shape[1], axis=1)


def test_path_errors_are_those_of_the_nearest_end_or_middle() -> None:
    wanted = np.array([[0.0, 10.0, 20.0], [0.0] * 3, [0.0] * 3])
    ball = np.array([[-100.0], [0.0], [0.0]])
    errors = path_errors(ShiftedMachine(), wanted, wanted, ball)  # type: ignore[arg-type]
    np.testing.assert_allclose(errors.positioning, 1e-3, rtol=1e-9)
    corrected = wanted - np.array([[1e-3], [0.0], [0.0]])
    # The middle of the block from 0 to 20 is the wanted point at 10, though no block ends there.
    errors = path_errors(ShiftedMachine(), wanted, corrected[:, [0, 2]], ball)  # type: ignore[arg-type]
    np.testing.assert_allclose(errors.vector, 0.0, atol=1e-12)


def test_the_s_path_is_two_circles_inside_the_travel(tmp_path: Path) -> None:
    cl = tmp_path / "s.cl"
    cl.write_text(inputs.s_path())
    x, y, _ = read_wanted(cl)
    upper = np.hypot(x - 270.0, y - 250.0)
    lower = np.hypot(x - 270.0, y - 450.0)
    np.testing.assert_allclose(np.minimum(np.abs(upper - 100.0), np.abs(lower - 100.0)), 0.0, atol=1e-5)
    assert np.hypot(np.diff(x), np.diff(y)).max() < 1.01
    assert x.min() > 0
    assert x.max() < 540


def test_the_circle_stays_within_the_stroke_of_x() -> None:
    positions = np.array(inputs.circle_positions(False) + inputs.circle_positions(True))
    np.testing.assert_allclose(np.hypot(positions[:, 0] - 270.0, positions[:, 1] - 350.0), 300.0, rtol=1e-12)
    assert positions[:, 0].min() >= 0.0
    assert positions[:, 0].max() <= 540.0


def test_commanded_ends_refuse_arcs(tmp_path: Path) -> None:
    program = tmp_path / "c.nc"
    program.write_text(inputs.circle(False))
    with pytest.raises(InputError, match="is an arc"):
        commanded_ends(program, ("X", "Y", "Z"))


@pytest.mark.slow
def test_the_whole_demonstration_gains_what_it_says_and_runs_nothing_of_its_folder(tmp_path: Path) -> None:
    make_hostile(tmp_path, tmp_path / "results")
    done = run(tmp_path, "demo --out results --noise-um 0.3 --seed 1", env={"EVIDENCE": str(tmp_path / "evidence")})
    assert done.returncode == 0, done.stderr
    assert "WARNING: no work offset" not in done.stdout  # its circles are in machine coordinates, and say so
    assert run_of(tmp_path / "evidence") == []
    summary = (tmp_path / "results" / "summary.txt").read_text()
    nothing, by_stepwise, by_estimate, by_proposed = (
        float(next(line for line in summary.splitlines() if line.strip().startswith(way)).split()[-1])
        for way in ("not compensated  ", STEPWISE, ESTIMATE, PROPOSED)
    )
    assert 6.8 < nothing < 7.1
    assert by_estimate < 2.0 < by_stepwise < nothing
    assert by_proposed < 0.6 * by_estimate
    rows = {line.split()[0]: line.split() for line in summary.splitlines() if line.startswith("  ")}
    # |E| mean at most 0.1 um with the error vector nowhere above one word; plain rounding at its own 0.24 um.
    assert float(rows["iterative-middles"][1]) <= 0.1
    assert float(rows["iterative-middles"][4]) <= 1.0
    assert 0.2 < float(rows["iterative"][1]) < 0.28
    assert float(rows["ccw"][3]) > 85.0
    # README's table, rounded as there.
    readme = (ROOT / "README.md").read_text()
    for way, cells in (
        ("not", ("not compensated |", 2, 2, 2)),
        ("iterative", ("words rounded |", 3, 2, 2)),
        ("iterative-middles", ("at the points |", 3, 2, 2)),
    ):
        line = next(line for line in readme.splitlines() if cells[0] in line).replace("*", "")
        figures = rows[way][2:] if way == "not" else rows[way][1:]
        mean, largest, vector = float(figures[0]), float(figures[2]), float(figures[3])
        shown = f"| {mean:.{cells[1]}f} | {largest:.{cells[2]}f} | {vector:.{cells[3]}f} |"
        assert shown in line
    for name in ("error_curves.png", "error_map.png", "ball_bar.png", "identified.json", "summary.txt"):
        assert (tmp_path / "results" / name).stat().st_size > 0
