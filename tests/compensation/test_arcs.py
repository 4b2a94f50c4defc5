"""Arcs against analytic circles."""

import math
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.compensation.analytic_machine import XyzMachine
from tests.compensation.control import Bench, execute
from trueaxis.compensation.arcs import ArcError, arc_about, arc_of_radius
from trueaxis.compensation.columns import Arcs, chord_counts, chords

TOLERANCE = 0.002
WORD = 0.0005 * math.sqrt(3) + 1e-9

# block after G0 X10 Y0 Z0 (or as given), plane's axes, centre, a point passed on the way, total angle in degrees
HAND = [
    ("G17 G3 X0. Y10. I-10. J0.", "XY", (0, 0), (7.0711, 7.0711), 90),
    ("G17 G2 X0. Y10. I-10. J0.", "XY", (0, 0), (-7.0711, -7.0711), 270),
    ("G17 G3 X0. Y10. R10.", "XY", (0, 0), (7.0711, 7.0711), 90),
    ("G17 G2 X0. Y10. R10.", "XY", (10, 10), (2.9289, 2.9289), 90),
    ("G17 G3 X0. Y10. R-10.", "XY", (10, 10), (17.0711, 17.0711), 270),
    ("G17 G2 X0. Y10. R-10.", "XY", (0, 0), (-7.0711, -7.0711), 270),
    ("G17 G2 I-10.", "XY", (0, 0), (0, -10), 360),
    ("G17 G3 I-10. X10.", "XY", (0, 0), (-10, 0), 360),
    # G18: first axis Z, second X; counter-clockwise seen from +Y runs from Z to X
    ("G18 G2 X0. Z10. I-10. K0.", "ZX", (0, 0), (7.0711, 7.0711), 90),
    ("G18 G3 X0. Z10. I-10. K0.", "ZX", (0, 0), (-7.0711, -7.0711), 270),
    ("G18 G2 X0. Z10. R10.", "ZX", (0, 0), (7.0711, 7.0711), 90),
    ("G18 G3 X0. Z10. R10.", "ZX", (10, 10), (2.9289, 2.9289), 90),
    ("G18 G3 X0. Z10. R-10.", "ZX", (0, 0), (-7.0711, -7.0711), 270),
]


@pytest.mark.parametrize(("block", "plane", "centre", "passed", "degrees"), HAND)
def test_hand_worked(
    bench: Bench,
    block: str,
    plane: str,
    centre: tuple[float, float],
    passed: tuple[float, float],
    degrees: float,
) -> None:
    at = execute(bench.run(f"G90 G21\nG0 X10. Y0. Z0.\n{block} F100\n", chord_tolerance=TOLERANCE))
    rows = ["XYZ".index(axis) for axis in plane]
    u, v = at[rows]
    cu, cv = centre
    assert np.abs(np.hypot(u - cu, v - cv) - 10.0).max() <= WORD
    middles = np.hypot((u[1:] + u[:-1]) / 2 - cu, (v[1:] + v[:-1]) / 2 - cv)
    assert (10.0 - middles).max() <= TOLERANCE + WORD
    assert np.hypot(u - passed[0], v - passed[1]).min() < 0.5
    angle = np.unwrap(np.arctan2(v - cv, u - cu))
    assert math.degrees(abs(angle[-1] - angle[0])) == pytest.approx(degrees, abs=0.02)
    chord_angle = 2 * math.acos(1 - TOLERANCE / 10.0)
    assert at.shape[1] - 1 == math.ceil(math.radians(degrees) / chord_angle)


def test_arcs_in_yz(bench: Bench) -> None:
    at = execute(bench.run("G0 X1. Y10. Z0.\nG19 G3 Y0. Z10. J-10. K0. F5\n"))
    assert np.allclose(at[0], 1.0)
    assert np.abs(np.hypot(at[1], at[2]) - 10.0).max() <= WORD
    assert np.hypot(at[1] - 7.0711, at[2] - 7.0711).min() < 0.3


def test_helix_rises_evenly(bench: Bench) -> None:
    at = execute(bench.run("G0 X10. Y0. Z0.\nG17 G3 X10. Y0. Z5. I-10. F5\n"))
    angle = np.unwrap(np.arctan2(at[1], at[0]))
    assert angle[-1] == pytest.approx(2 * math.pi, abs=1e-3)
    assert np.abs(at[2] - 5.0 * angle / (2 * math.pi)).max() < 0.0015


def test_inch_and_incremental_arcs(bench: Bench) -> None:
    metric = execute(bench.run("G0 X10. Y0. Z0.\nG3 X0. Y10. I-10. J0. F5\n"))
    incremental = execute(bench.run("G0 X10. Y0. Z0.\nG91 G3 X-10. Y10. I-10. J0. F5\n"))
    assert np.abs(metric - incremental).max() < 1e-6
    inch = execute(bench.run("G20 G0 X1. Y0. Z0.\nG3 X0. Y1. R1. F5\n"))
    assert np.abs(np.hypot(inch[0], inch[1]) - 25.4).max() < 1e-3
    assert inch[:, -1] == pytest.approx([0, 25.4, 0], abs=1e-4)


def test_arcs_are_compensated_on_their_way(bench: Bench) -> None:
    machine = XyzMachine({"EXX": lambda x: 2e-3 * x, "EYX": lambda x: 1e-5 * x * x})
    at = execute(bench.run("G0 X10. Y0. Z0.\nG3 X-10. Y0. I-10. F5\n", machine))
    tool = machine.actual(at, np.zeros((3, 1)))
    assert np.abs(np.hypot(tool[0], tool[1]) - 10.0).max() <= WORD
    assert np.abs(np.hypot(at[0], at[1]) - 10.0).max() > 0.015


@given(
    st.floats(0.01, 500.0),
    st.floats(0.0, 2 * math.pi),
    st.floats(0.001, 2 * math.pi - 0.001),
    st.sampled_from([-1.0, 1.0]),
    st.floats(1e-4, 0.1),
    st.floats(-50.0, 50.0),
)
def test_any_arc(radius: float, begin: float, sweep: float, sense: float, tolerance: float, rise: float) -> None:
    centre = (3.0, -4.0, 5.0)

    def at(angle: float, z: float) -> tuple[float, float, float]:
        return (centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle), centre[2] + z)

    start, end = at(begin, 0.0), at(begin + sense * sweep, rise)
    if math.dist(start[:2], end[:2]) < 1e-5:
        return
    arc = arc_about(start, end, (centre[0], centre[1], 0.0), (0.0, 0.0, sense), 1e-9)
    assert arc.sweep == pytest.approx(sweep, abs=1e-6)
    by_radius = arc_of_radius(start, end, radius if sweep <= math.pi else -radius, (0.0, 0.0, sense), 1e-9)
    # the centre by R is ill-conditioned where the ends are opposite
    assert math.dist(by_radius.centre[:2], centre[:2]) < 1e-5 * radius + 1e-6
    count = chord_counts(np.array([radius]), np.array([arc.sweep]), tolerance)
    cut = chords(np.array([start]).T, np.array([end]).T, Arcs.of([arc], [0], [False], [True]), count)
    assert cut.points[:, -1] == pytest.approx(end)
    path = np.concatenate([np.array([start]).T, cut.points], axis=1)
    middle = 0.5 * (path[:, 1:] + path[:, :-1])
    sagitta = radius - np.hypot(middle[0] - centre[0], middle[1] - centre[1])
    assert sagitta.max() <= tolerance * (1 + 1e-6) + 1e-9
    angle = sense * (np.unwrap(np.arctan2(path[1] - centre[1], path[0] - centre[0])) - begin)
    assert np.all(np.diff(angle) > 0) or path.shape[1] == 2
    assert path[2] == pytest.approx(centre[2] + rise * np.arange(path.shape[1]) / (path.shape[1] - 1))


def test_words_that_make_no_arc() -> None:
    with pytest.raises(ArcError, match="radius 0"):
        arc_about((0, 0, 0), (1, 0, 0), (0, 0, 0), (0, 0, 1), 0.01)
    with pytest.raises(ArcError, match=re.escape("1.00000 and 1.50000 mm; rounding of its words explains 0.01000 mm")):
        arc_about((1, 0, 0), (0, 1.5, 0), (0, 0, 0), (0, 0, 1), 0.01)
    with pytest.raises(ArcError, match="more than 2 R"):
        arc_of_radius((0, 0, 0), (10, 0, 0), 4.9, (0, 0, 1), 0.01)
    with pytest.raises(ArcError, match="coincide"):
        arc_of_radius((1, 0, 0), (1, 0, 0), 4.9, (0, 0, 1), 0.01)


@pytest.mark.parametrize(
    ("plane", "rows", "words"), [(17, (0, 1, 2), "IJ"), (18, (2, 0, 1), "KI"), (19, (1, 2, 0), "JK")]
)
@pytest.mark.parametrize("sense", [1, -1])
def test_helices_in_incremental_inches(
    bench: Bench, plane: int, rows: tuple[int, int, int], words: str, sense: int
) -> None:
    # 3/4 of a turn of 1 inch about the centre at (-1, 0) from the start, in the plane's axes, rising by 0.5 inch
    u, v, w = ("XYZ"[row] for row in rows)
    code = 3 if sense > 0 else 2
    block = f"G{code} {u}-1. {v}{-sense}. {w}.5 {words[0]}-1. {words[1]}0. F5"
    at = execute(bench.run(f"G20 G90 G0 X2. Y2. Z2.\nG91 G{plane}\n{block}\n", inch_resolution=0.0001))
    first, second, along = at[list(rows)] / 25.4
    angle = np.unwrap(np.arctan2(second - 2.0, first - 1.0))
    assert angle[-1] == pytest.approx(sense * 1.5 * math.pi, abs=1e-3)
    assert np.abs(np.hypot(first - 1.0, second - 2.0) - 1.0).max() < 1e-4
    assert along == pytest.approx(2.0 + 0.5 * np.abs(angle) / (1.5 * math.pi), abs=2e-4)
    assert at[list(rows), -1] / 25.4 == pytest.approx([1.0, 2.0 - sense, 2.5], abs=1e-9)
