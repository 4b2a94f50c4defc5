"""Rapids before an axis has a position: compensated for a stated place of it, without a word for it."""

import json
import re
import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.compensation.analytic_machine import FloatArray, XyzMachine, paper_sized
from tests.compensation.control import Bench, execute
from tests.compensation.five_axes import TEXTS, FiveAxes
from tests.compensation.test_command import command
from tests.compensation.test_uncommanded import words
from tests.machine.test_faults import BASE, faults_of
from tests.machines import machine_of
from trueaxis.io.faults import InputError

ORIGIN = np.zeros((3, 1))
LIMITS = {"X": (-50.0, 500.0), "Y": (-50.0, 500.0), "Z": (-20.0, 400.0)}


def machine(size: float = 3.0) -> XyzMachine:
    return XyzMachine(paper_sized(size).curves, paper_sized(size).squareness, travel=LIMITS)


def right_words(of: XyzMachine, wanted: FloatArray) -> FloatArray:
    """Axis positions that bring the tool to `wanted` (3,) exactly, worked out from the matrices alone."""
    at = wanted[:, None].copy()
    for _ in range(6):
        off = of.actual(at, ORIGIN) - of.ideal(wanted[:, None], ORIGIN)
        at -= off * np.array([[1.0], [-1.0], [1.0]])
    return at[:, 0]


@pytest.mark.parametrize("place", [None, 120.0])
def test_a_header_is_compensated_where_z_is_taken_to_stand(bench: Bench, place: float | None) -> None:
    assumed = {} if place is None else {"Z": place}
    text = bench.run("G21 G90\nG0 X300. Y200.\nZ50.\nG1 Z5. F100\nX310.\n", machine(), assumed=assumed)
    assert words(text, "Z")[:2] == [3, 4]
    written = [float(value) for value in re.findall(rb"[XY]([-.\d]+)", text.splitlines()[1])]
    assert written == pytest.approx(right_words(machine(), np.array([300.0, 200.0, place or 0.0]))[:2], abs=0.00051)
    # and right again from the first block on in which everything is known
    assert bench.report.good
    assert bench.report.after is not None
    assert bench.report.after.largest < 0.001
    named = f"Z{place or 0:g}"
    assert f"1 rapids while the position of Z is unknown: their words are for {named} " in bench.told
    found = json.loads(bench.report.to_json())
    assert found["unknown_places"]["assumed"] == {"Z": place or 0.0}


@settings(max_examples=60, deadline=None)
@given(
    st.lists(st.sampled_from("XYZ"), min_size=1, max_size=2, unique=True),
    st.tuples(*[st.integers(0, 400)] * 3),
    st.tuples(*[st.floats(0.0, 1.0)] * 3),
)
def test_what_it_may_cost_is_not_less_than_it_costs(
    named: list[str], at: tuple[int, ...], shares: tuple[float, ...]
) -> None:
    """Wherever the other axes stand, the words would differ by no more than the report says (and what it samples)."""
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(Path(folder))
        text = bench.run("G21 G90\nG0 " + " ".join(f"{axis}{at['XYZ'.index(axis)]}." for axis in named), machine())
        found = bench.report.unknown_places
    assert found is not None
    assert not any(words(text, axis) for axis in "XYZ" if axis not in named)
    assert set(found.assumed) == set("XYZ") - set(named)
    true, taken = np.zeros(3), np.zeros(3)
    for row, axis in enumerate("XYZ"):
        low, high = LIMITS[axis]
        true[row] = at[row] if axis in named else low + shares[row] * (high - low)
        taken[row] = at[row] if axis in named else 0.0
    rows = ["XYZ".index(axis) for axis in named]
    change = (right_words(machine(), true) - true) - (right_words(machine(), taken) - taken)
    assert np.linalg.norm(change[rows]) <= 1.02 * found.change.largest + 1e-6
    assert found.change.largest < 0.5


def test_the_first_cut_from_an_unknown_place_is_not_cut_into_pieces(bench: Bench) -> None:
    text = bench.run("G21 G90\nG0 X450. Y450.\nG1 Z-10. F100\nX-40.\n", machine())
    assert [line[:4] for line in text.splitlines()[1:3]] == [b"G0 X", b"G1 X"]
    assert text.splitlines()[2].count(b"X") == 1
    assert len(text.splitlines()) > 5


FEEDS = ("G1 X250. Y60. F500", "G1 X250.\nY60.", "G2 X260. Y100. I30. F500", "G3 X200. Y160. R60.\nG1 X10. F300")


@settings(max_examples=20, deadline=None)
@given(st.sampled_from(FEEDS), st.integers(-20, 400), st.booleans(), st.integers(0, 200))
def test_feeds_before_z_are_right_in_x_and_y_where_z_stands(feed: str, stands: int, said: bool, change: int) -> None:
    """Z is set by hand: the program never moves it, nor does what is written, and X and Y are right wherever it is."""
    with tempfile.TemporaryDirectory() as folder:
        bench, z = Bench(Path(folder)), {"Z": float(stands)}
        head = f"G21 G90\n{'T1 M6' if change % 2 else '(no tool)'}\nG0 X200. Y100.\n"
        text = bench.run(f"{head}{feed}\n", machine(), start=z if said else {}, assumed={} if said else z)
        plain = bench.run(f"{head}G0 Z{stands}.\n{feed}\n", machine())
    report = bench.report  # with Z commanded
    assert not words(text, "Z")
    with_z = [re.sub(rb" ?Z[-.\d]+", b"", line) for line in plain.splitlines() if not line.startswith(b"G0 Z")]
    assert len(text.splitlines()) <= len(with_z)
    assert text.splitlines()[-1].split()[-1] == with_z[-1].split()[-1]
    assert report.unnamed_feeds is None


@pytest.mark.parametrize("feed", FEEDS)
def test_where_z_stands_must_be_said_if_it_matters(bench: Bench, feed: str) -> None:
    program = f"G21 G90\nG0 X200. Y100.\n{feed}\n"
    bench.run(program, machine())
    found, after = bench.report.unnamed_feeds, bench.report.after
    assert (bench.report.good, bench.report.over_places) == (False, True)
    assert found is not None
    assert found.anywhere is not None
    assert after is not None
    assert (found.places, found.near) == ({"Z": 0.0}, None)
    assert after.largest < 0.001
    assert "say by --start where they stand" in bench.told
    bench.run(program, machine(), start={"Z": 120.0})
    stated = bench.report.unnamed_feeds
    assert bench.report.good
    assert stated is not None
    assert stated.near is not None
    assert stated.left is not None
    assert (stated.places, stated.anywhere) == ({"Z": 120.0}, None)
    assert 0.0 < stated.near.largest < found.anywhere.largest
    # a straight machine: no angle changes what X and Y are off, wherever Z stands
    straight = {name: curve for name, curve in machine().curves.items() if name[1] in "XYZ" and name[2] != "Z"}
    bench.run(program, XyzMachine(straight, travel=LIMITS))
    assert bench.report.good
    assert "is left along it" in bench.told


@settings(max_examples=30, deadline=None)
@given(st.floats(0.0, 1.0), st.integers(0, 400), st.integers(0, 400))
def test_what_a_cut_may_be_off_is_not_less_than_it_is(share: float, x: int, y: int) -> None:
    low, high = LIMITS["Z"]
    stands = low + share * (high - low)
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(Path(folder))
        text = bench.run(f"G21 G90\nG0 X{x}. Y{y}.\nG1 X{400 - x}. F200\nY{400 - y}.\n", machine())
        found, after = bench.report.unnamed_feeds, bench.report.along
    assert found is not None
    assert found.anywhere is not None
    assert after is not None
    last = execute(text)[:, -1]
    wanted = np.array([400.0 - x, 400.0 - y, stands])
    at = np.array([last[0], last[1], stands])[:, None]
    off = machine().actual(at, ORIGIN) - machine().ideal(wanted[:, None], ORIGIN)
    assert np.hypot(*off[:2, 0]) <= 1.02 * found.anywhere.largest + 0.00075


def test_what_a_feed_motion_still_needs(bench: Bench) -> None:
    for program, names in (
        ("G91 G1 X5. F100\n", "X"),
        ("G90 G2 X5. Y0. I2.5 F100\n", "X Y"),
        ("G90 G0 X0. Y0.\nG91 G28 Z0.\nG90 G1 X5. F100\n", "Z"),
        ("G90 G0 X0. Y0.\nG2 X5. Z3. I2.5 F100\n", "Z"),
    ):
        with pytest.raises(InputError, match=f"the position of {names} is not known here"):
            bench.run(f"G21\n{program}", machine())


def test_a_tool_change_before_the_first_motion_is_part_of_the_start(bench: Bench) -> None:
    text = bench.run("G21\nT1 M6\nG91 G1 X50. F100\n", machine(), start={"X": 100.0, "Y": 50.0, "Z": 20.0})
    assert bench.report.good
    assert not words(text, "Z") + words(text, "Y")
    with pytest.raises(InputError, match="the tool change before it may have moved them"):
        bench.run("G21\nG90 G0 X0.\nT1 M6\nG91 G1 X50. F100\n", machine(), start={"Y": 50.0, "Z": 20.0})


def test_rotary_axes_wait_too(bench: Bench) -> None:
    five = FiveAxes(TEXTS["table-table"])
    program = "G21 G90\nG0 X10. Y20. Z30.\nA-20. C40.\nG1 X40. F100\n"
    text = bench.run(program, five.model, orientation="correct")
    assert (words(text, "A"), words(text, "C")) == ([3, 4], [3, 4])
    assert bench.report.unknown_places is not None
    assert set(bench.report.unknown_places.assumed) == {"A", "C"}
    with pytest.raises(InputError, match="position of A C is not known"):
        bench.run("G21 G90\nG1 X10. Y20. Z30. F100\n", five.model)


def test_after_a_tool_change_it_is_said_too(bench: Bench) -> None:
    bench.run("G21 G90\nG0 X10. Y10. Z10.\nT2 M6\nG0 X300. Y20.\nZ5.\n", machine())
    assert bench.report.unknown_places is not None
    assert set(bench.report.unknown_places.assumed) == {"Z"}
    assert bench.report.unknown_places.change.line == 4


def test_play_is_taken_up_only_once_the_direction_is_known(bench: Bench) -> None:
    """Z may come from either side to its first word: which way it went is not known, and so no play is compensated."""
    from tests.compensation.test_effect_programs import plain
    from trueaxis.effects.kind import Effect

    model = plain({Effect(kind="backlash", component="EZZ"): {"width": -0.010}})
    text = bench.run("G21 G90\nG0 X5. Y5.\nZ50.\nZ40.\n", model)
    (first, second) = (float(line.split(b"Z")[1]) for line in text.splitlines()[2:4])
    assert first == 50.0
    assert second == pytest.approx(39.990, abs=0.011)
    assert second != 40.0


def test_the_spec_says_where_axes_stand(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "dmu60p.toml"
    own = Path(__file__).parents[2] / "machines" / "dmu60p.toml"
    spec.write_text(own.read_text() + "\n[start]\nZ = 600.0\n")
    assert command(tmp_path, "G21 G90\nG0 X100. Y100.\nZ10.\n", machine=spec) == 0
    assert "their words are for Z600 " in capsys.readouterr().out


def test_the_tables_are_no_part_of_the_digest() -> None:
    tables = "\n[start]\nY = 1.0\n[reference_points.G28]\nY = 0.0\n[reference_points.G30]\n"
    assert machine_of(BASE + tables).digest == machine_of(BASE).digest
    assert dict(machine_of(BASE + tables).start) == {"Y": 1.0}
    assert dict(machine_of(BASE + tables).reference_points) == {"G28": (("Y", 0.0),), "G30": ()}


@pytest.mark.parametrize(
    ("table", "place"),
    [
        ("[start]\nY = 1e6", "key start.Y"),
        ("[start]\nQ = 1.0", "key start.Q"),
        ("[reference_points.G28]\nY = true", "key reference_points.G28.Y"),
        ("[reference_points.G53]\nX = 0.0", "key reference_points.G53"),
    ],
)
def test_faults_of_the_tables(table: str, place: str) -> None:
    assert any(place in fault.place for fault in faults_of(f"{BASE}\n{table}\n"))
