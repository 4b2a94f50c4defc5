"""Arcs that stay arcs: checked along the path against the exact machine by a control that makes arcs of their words."""

import math
import re
import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests.compensation.analytic_machine import XyzMachine, paper_sized, polynomial
from tests.compensation.control import Bench
from tests.compensation.few_blocks import FEWEST, runs_of
from tests.compensation.path_distance import apart, sampled
from trueaxis.io.faults import InputError

PLANES = {17: (0, 1, 2), 18: (2, 0, 1), 19: (1, 2, 0)}
ALONG = 0.00101  # mm: the tolerance of points, which an arc keeps everywhere
MACHINE = paper_sized()


def executed(program: bytes, finely: float = 1e-5) -> np.ndarray:
    """Points (3, n) of a program of G0 to G3 in G90 or G91, mm or inch, arcs by I J K or R, cut finely."""
    at, points = [0.0, 0.0, 0.0], []
    motion, plane, absolute, unit = 0, 17, True, 1.0
    for line in program.decode().splitlines():
        words = re.findall(r"([A-Z])\s*([-+]?[\d.]+)", re.sub(r"\(.*?\)", "", line))
        for letter, text in words:
            value = float(text)
            if letter == "G":
                motion = int(value) if value in (0, 1, 2, 3) else motion
                plane = int(value) if value in PLANES else plane
                absolute = {90.0: True, 91.0: False}.get(value, absolute)
                unit = {20.0: 25.4, 21.0: 1.0}.get(value, unit)
        given_ = {letter: float(text) * unit for letter, text in words if letter in "XYZIJKR"}
        if not given_:
            continue
        end = at.copy()
        for row, axis in enumerate("XYZ"):
            if axis in given_:
                end[row] = given_[axis] if absolute else at[row] + given_[axis]
        if motion > 1:
            a, b, c = PLANES[plane]
            turn = 1 if motion == 3 else -1
            if "R" in given_:
                x, y = end[a] - at[a], end[b] - at[b]
                chord = math.hypot(x, y)
                rise = math.sqrt(max(given_["R"] ** 2 - chord**2 / 4, 0.0)) * math.copysign(1, given_["R"]) * turn
                centre = at[a] + x / 2 - y / chord * rise, at[b] + y / 2 + x / chord * rise
            else:
                centre = at[a] + given_.get("IJK"[a], 0.0), at[b] + given_.get("IJK"[b], 0.0)
            first, last = (math.dist((p[a], p[b]), centre) for p in (at, end))
            assert abs(first - last) < 0.004 * unit / 1.0, line  # controls refuse more
            begin = math.atan2(at[b] - centre[1], at[a] - centre[0])
            sweep = (turn * (math.atan2(end[b] - centre[1], end[a] - centre[0]) - begin)) % (2 * math.pi)
            if sweep < 1e-9 or math.dist((at[a], at[b]), (end[a], end[b])) < 1e-9:
                sweep = 2 * math.pi
            count = max(2, math.ceil(sweep / math.sqrt(8 * finely / max(first, 0.01))))
            for k in range(1, count + 1):
                share = k / count
                radius, angle = first + share * (last - first), begin + turn * share * sweep
                point = at.copy()
                point[a], point[b] = centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)
                point[c] = at[c] + share * (end[c] - at[c])
                points.append(point)
        else:
            points.append(end)
        at = end
    return np.array(points).T


def errors(bench: Bench, program: str, machine: XyzMachine = MACHINE) -> tuple[float, float, bytes]:
    written = bench.run(program, machine, "nc", arcs="keep")
    zero = np.zeros((3, 1))
    meant, done = (sampled(executed(text), 0.2) for text in (program.encode(), written))
    path = machine.ideal(meant, zero)
    return apart(machine.actual(meant, zero), path), apart(machine.actual(done, zero), path), written


HEAD = "G21 G90 G17\nG0 X300. Y-200. Z100.\n"


@pytest.mark.parametrize(
    ("blocks", "most"),
    [
        ("G2 X340. Y-200. I20. J0. F100\n", 2),
        ("G3 X300. Y-200. I-15. J5.\n", 4),
        ("G2 X310. Y-190. R10.\nX320. Y-180. R10.\n", 3),
        ("G2 X310. Y-190. R-10.\n", 4),
        ("G18 G3 X320. Z100. R10.\nG1 X310.\nG19 G2 Y-190. Z110. J10. K0.\n", 5),
        ("G91 G2 X10. Y10. I10. J0.\nG90 G1 X300.\n", 2),
        ("G2 X300. Y-200. Z90. I5. J0.\n", 4),
        ("G20\nG2 X12.5 Y-7.874016 R0.5\n", 6),
    ],
)  # fmt: skip
def test_arcs_stay_arcs_and_keep_the_tolerance_along_the_path(bench: Bench, blocks: str, most: int) -> None:
    before, after, written = errors(bench, HEAD + blocks)
    assert before > 0.01
    assert after < ALONG
    assert after < bench.report.along.largest + 0.0002  # type: ignore[union-attr]
    moved = written.decode().splitlines()[3:]
    assert len([line for line in moved if re.search("[XYZ]", line)]) <= most
    assert len(re.findall(r"G[23](?!\d)", written.decode())) >= 1


def test_strongly_bent_errors_cut_arcs_further(bench: Bench) -> None:
    """Where errors wave along the arc no arc holds the tolerance for long, and none is written that does not."""
    waving = XyzMachine({"EXX": lambda x: 0.02 * np.sin(x / 0.8), "EYY": lambda y: 0.01 * np.cos(y / 0.5)})
    before, after, written = errors(bench, HEAD + "G2 X340. Y-200. I20. J0.\n", waving)
    assert before > 0.002
    assert after < 0.0016  # lines, where three chords are left
    assert 30 < written.count(b"\n") < 400
    assert b"G1 X" in written


def test_turns_of_linuxcnc_are_made_one_by_one(bench: Bench) -> None:
    """P3: two whole turns and the rest; other controls mean otherwise by P, or nothing."""
    program = HEAD + "G2 X320. Y-220. Z94. I20. J0. P3\n"
    written = bench.run(program, MACHINE, "nc", arcs="keep", dialect="linuxcnc")
    sweeps = len(re.findall(rb"G2 ", written))
    assert sweeps == math.ceil((2.0 + 0.75) * 4)
    assert b"P3" not in written
    points = executed(written)
    assert points[2, -1] == pytest.approx(94.0, abs=0.1)
    turned = np.unwrap(np.arctan2(points[1] + 200.0, points[0] - 320.0))
    assert turned[-1] - turned[0] == pytest.approx(-2.75 * 2.0 * math.pi, abs=0.01)
    share = (turned - turned[0]) / (turned[-1] - turned[0])
    assert np.abs(points[2] - points[2, 0] - share * (points[2, -1] - points[2, 0])).max() < 0.01
    assert "P3" not in bench.run(program, MACHINE, "nc", arcs="chords", dialect="linuxcnc").decode()
    with pytest.raises(InputError, match="P3"):
        bench.run(program, MACHINE)


def test_chords_when_asked(bench: Bench) -> None:
    assert not re.search(rb"G[23](?!\d)|I\d", bench.run(HEAD + "G2 X340. Y-200. I20. J0.\n", MACHINE, arcs="chords"))


def test_words_of_time_and_of_the_end_of_a_block(bench: Bench) -> None:
    written = bench.run(HEAD + "G93\nG2 X340. Y-200. I20. J0. F3. M9 (c)\n", MACHINE, arcs="keep").decode()
    feeds = [float(text) for text in re.findall(r"F([\d.]+)", written)]
    assert sum(1.0 / feed for feed in feeds) == pytest.approx(1.0 / 3.0, rel=1e-5)
    assert written.rstrip().endswith("M9")
    assert written.count("M9") == 1


ARCS = st.tuples(
    st.sampled_from("23"), st.floats(-30, 30), st.floats(-30, 30), st.integers(-359, 359), st.floats(-5, 5),
    st.booleans(), st.sampled_from(["G17", "G18", "G19"]),
)  # fmt: skip


# the end in X is 0.001 mm from the start before rounding, and gets no word
@example(arcs=[("2", -19.0, 0.34375, -358, 0.0, False, "G17")], way="G90", seed=1, fewest=12)
@settings(max_examples=20, deadline=None)
@given(st.lists(ARCS, min_size=1, max_size=4), st.sampled_from(["G90", "G91"]), st.integers(1, 1000), FEWEST)
def test_random_arcs(
    arcs: list[tuple[str, float, float, int, float, bool, str]], way: str, seed: int, fewest: int
) -> None:
    random = np.random.default_rng(seed)
    curves = {f"E{way}{axis}": polynomial(*random.uniform(-0.03, 0.03, 2)) for way in "XYZ" for axis in "XYZ"}
    machine = XyzMachine(curves, (5e-5, -3e-5, 2e-5))
    at, lines = [300.0, -200.0, 100.0], []
    for code, i, j, degrees, rise, by_radius, plane in arcs:
        a, b, c = PLANES[int(plane[1:])]
        i, j = round(i, 3), round(j, 3)  # noqa: PLW2901
        radius = math.hypot(i, j)
        if (
            radius < 3.0
        ):  # on a small radius, words of 0.001 mm may make two radii that differ by more than they explain
            continue
        begin = math.atan2(-j, -i)
        finish = begin + math.radians(degrees)
        end = at.copy()
        end[a] = round(at[a] + i + radius * math.cos(finish), 3)
        end[b] = round(at[b] + j + radius * math.sin(finish), 3)
        end[c] = round(at[c] + rise, 3)
        chord = math.hypot(end[a] - at[a], end[b] - at[b])
        words = [
            (axis, end[row], end[row] - at[row]) for row, axis in enumerate("XYZ") if abs(end[row] - at[row]) > 1e-9
        ]
        text = " ".join(f"{axis}{(p if way == 'G90' else d):.3f}" for axis, p, d in words)
        if by_radius and 0.1 < chord < 1.9 * radius:
            centre = f"R{radius:.3f}"
        else:
            centre = f"{'IJK'[a]}{i:.3f} {'IJK'[b]}{j:.3f}"
        lines += [f"{plane} {way}", f"G{code} {text} {centre}"]
        at = end
    if not lines:
        return
    with tempfile.TemporaryDirectory() as folder, runs_of(fewest):
        bench = Bench(Path(folder))
        assert errors(bench, HEAD + "\n".join(lines) + "\n", machine)[1] < 0.0014


def test_as_few_points_as_errors_allow(bench: Bench) -> None:
    """An arc is looked at every 2.5 mm where errors are smooth, and by all of its chords where they wave."""
    program = HEAD + "G2 X340. Y-200. I20. J0.\n"
    way = 20.0 * math.pi
    errors(bench, program)
    assert way / 2.5 < bench.report.points < way / 2.5 + 8
    waving = XyzMachine({"EXX": lambda x: 0.003 * np.sin(2.0 * math.pi * x / 5.0)})
    _, after, written = errors(bench, program, waving)
    assert bench.report.points > 2.0 * way / 2.5
    assert after < 0.0012
    assert re.search(rb"G2 ", written)


def test_an_arc_that_leaves_the_travel_between_its_points(bench: Bench) -> None:
    """Of few chords X would end at 309.981, 309.830 and 309.096; the arc reaches 310."""
    program = HEAD + "G1 X309.981 Y-199.564 F100\nG2 X309.096 Y-202.868 I-4.981 J-0.436\n"
    for most, outside in ((310.01, False), (309.99, True)):
        narrow = XyzMachine(MACHINE.curves, MACHINE.squareness, travel={**MACHINE.travel, "X": (-600.0, most)})
        if outside:
            with pytest.raises(InputError, match=r"X = (309\.99|310).* is outside its travel"):
                bench.run(program, narrow, "nc", arcs="keep")
        else:
            assert re.search(rb"G2 ", bench.run(program, narrow, "nc", arcs="keep"))
