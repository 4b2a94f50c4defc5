"""Canned cycles, written out, against an independent control that runs the cycles themselves."""

import re
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.compensation.analytic_machine import XyzMachine, paper_sized
from tests.compensation.control import Bench
from tests.compensation.few_blocks import FEWEST, runs_of
from tests.compensation.shop_control import AXES, Control
from tests.compensation.test_offsets import KNOWN, both
from trueaxis.io.faults import InputError

ORIGIN = np.zeros((3, 1))
CODES = ["G81", "G82 P0.5", "G83 Q1.5", "G73 Q0.75", "G85", "G86", "G89 P1"]
HEAD = "N1 G21 G90 G17 G54 M3\nN2 G0 X0. Y0. Z20.\n"


def path(control: Control) -> list[tuple[int, int, list[float]]]:
    """Blocks in which the axes go somewhere: number, whether at feed, where to, um."""
    found: list[tuple[int, int, list[float]]] = []
    for number, motion, at, _ in control.trace:
        end = [round(at[axis], 6) for axis in AXES]
        if not found or end != found[-1][2]:
            found.append((number, motion, end))
    return found


@pytest.mark.parametrize("code", CODES)
@pytest.mark.parametrize("level", ["G98", "G99"])
@pytest.mark.parametrize("mode", ["G90", "G91"])
def test_each_cycle(bench: Bench, code: str, level: str, mode: str) -> None:
    z, r = ("Z-6.25", "R2.") if mode == "G90" else ("Z-8.", "R-18.")
    cycle = f"N3 {mode} {level} {code} X10. Y5. {z} {r} F100\nN4 X12.\nN5 X3. Y-4. L3\nN6 G80\n"
    program = f"{HEAD}{cycle}N7 G90 G0 X1. Y1. Z30.\n"
    kind: Any = "linuxcnc"
    written = bench.run(program, XyzMachine(), offsets=KNOWN, dialect=kind, integers="mm")
    source, control = both(program, written)
    assert path(control) == path(source)
    assert len(path(source)) > 9
    machine = paper_sized(3.0)
    source, control = both(program, bench.run(program, machine, offsets=KNOWN, dialect=kind, integers="mm"))
    assert bench.report.good
    wanted = np.array([at for _, _, at in path(source)]).T
    # compensated Z words move X and Y too by squareness: the same blocks, each within its tolerance
    ends = np.array([[at[axis] for axis in AXES] for _, _, at, _ in control.trace]).T
    distance = np.linalg.norm(machine.actual(ends, ORIGIN)[:, None] - machine.ideal(wanted, ORIGIN)[:, :, None], axis=0)
    assert distance.min(axis=1).max() <= 0.0011


@pytest.mark.parametrize(("plane", "letters"), [("G17", "XYZ"), ("G18", "ZXY"), ("G19", "YZX")])
def test_the_axis_across_the_plane_drills(bench: Bench, plane: str, letters: str) -> None:
    first, second, across = tuple(letters)
    program = (
        f"G21 G90 {plane}\nG0 {first}0. {second}0. {across}20.\n"
        f"G98 G83 {first}1. {second}2. {across}-3. R1. Q3. F60\nG99 {second}5.\nG80\n"
    )
    text = bench.run(program).decode().replace(first, "a").replace(second, "b").replace(across, "c")
    blocks = [sorted(re.findall(r"[abc]-?[.\d]+|G[01](?!\d)", line)) for line in text.splitlines()[2:-1]]
    hole = ["G1 c-2.000", "G0 c1.000", "G0 c-1.746", "G1 c-3.000"]
    wanted = ["G0 a1.000 b2.000", "G0 c1.000", *hole, "G0 c20.000", "G0 b5.000", "G0 c1.000", *hole, "G0 c1.000"]
    assert [" ".join(block) for block in blocks] == wanted


def test_the_text_of_a_cycle(bench: Bench) -> None:
    program = (
        "G21 G90 G17\nG0 X0. Y0. Z20.\nN7 G98 G82 X1. Y2. Z-3. R1. P250 F60 M8 (hole)\nX5. M9\n/ X6.\nG80 (done)\n"
    )
    text = bench.run(program, integers="mm", block_delete="run").decode()
    assert text.splitlines()[2:] == [
        "N7 F60 M8 G0 X1.000 Y2.000 (hole)", "G0 Z1.000", "G1 Z-3.000", "G4 P250", "G0 Z20.000",
        "G0 X5.000", "G0 Z1.000", "G1 Z-3.000", "G4 P250", "G0 Z20.000", "M9",
        "/G0 X6.000", "/G0 Z1.000", "/G1 Z-3.000", "/G4 P250", "/G0 Z20.000", "G80 (done)",
    ]  # fmt: skip
    assert any("a canned cycle is written out" in note for note in bench.report.notes)


def test_a_peck_of_the_whole_hole_and_the_exact_path_of_linuxcnc_are_noted(bench: Bench) -> None:
    """Q in thousandths under --integers mm made one plunge of all pecks."""
    program = "G21 G90 G64\nG0 X0. Y0. Z20.\nG98 G83 X5. Y5. Z-20. R3. Q{} F100\nX9.\nG80\n"
    for peck, dialect, noted in (("5.", "linuxcnc", (0, 1)), ("5000", "linuxcnc", (1, 1)), ("5.", None, (0, 0))):
        kind: Any = dialect
        bench.run(program.format(peck), XyzMachine(), dialect=kind)
        report = bench.report
        notes = [note for note in (*report.warnings, *report.notes) if note.startswith("line 3")]
        assert tuple(sum(said in note for note in notes) for said in ("in one peck", "exact path mode")) == noted


@pytest.mark.parametrize("dialect", [None, "fanuc"])
def test_a_whole_number_deeper_than_the_hole_is_no_peck(bench: Bench, dialect: Any) -> None:
    """Q3000 is 3 mm on a Fanuc control that counts X5 as 5 mm: in one plunge of 23 mm it would break the drill."""
    program = "G21 G90\nG0 X0. Y0. Z20.\nG98 G83 X5 Y5 Z-20 R3 Q{} F100\nX9\nG80\n"
    with pytest.raises(InputError, match=r"line 3: G83 Q3000 is deeper than the hole.*Q with a decimal point"):
        bench.run(program.format("3000"), XyzMachine(), dialect=dialect, integers="mm")
    for peck in ("3", "3.", "30."):  # pecks of 3 mm, and one that is meant as a whole
        bench.run(program.format(peck), XyzMachine(), dialect=dialect, integers="mm")
    pecks = bench.run(program.format("3000"), XyzMachine(), dialect=dialect, integers="least-increment").decode()
    assert pecks.count("G1") == 2  # Z-20 is 0.02 mm deep there


@pytest.mark.parametrize(
    ("blocks", "modes"),
    [
        ("G64 P0.05 Q0.01\nCYCLE\nX9.\nG80\nG0 X1.", ["G64 P0.05 Q0.01", "G61", "hole", "G64 P0.05 Q0.01"]),
        ("G64\nCYCLE\nX9.\nG0 X1.", ["G64", "G61", "hole", "G64"]),
        ("G64 P0.002\nG64 P0.05\nCYCLE\nX9.\nM30", ["G64 P0.002", "G64 P0.05", "G61", "hole", "G64 P0.05"]),
        ("G20 G64 P0.002\nG21\nCYCLE\nX9.\nG80", ["G64 P0.002", "G61", "hole", "G64 P0.0508"]),
        ("CYCLE\nX9.\nG80\nCYCLE\nG80", ["G61", "hole"]),
        ("G61\nCYCLE\nG80", ["G61", "hole"]),
        ("G61.1\nCYCLE\nG80", ["G61.1", "hole"]),
        ("G64 P1\nCYCLE\nG64 P0.1\nX9.\nG80 G64 P1", ["G64 P1", "G61", "hole", "G64 P0.1", "G61", "hole", "G64 P1"]),
        ("G64 P1\nCYCLE\nG61\nX9.\nG80", ["G64 P1", "G61", "hole", "G61", "hole"]),
    ],
)
def test_what_is_drilled_is_drilled_in_exact_path_mode(bench: Bench, blocks: str, modes: list[str]) -> None:
    """LinuxCNC does so; under G64 the bottom of a hole may be cut short."""
    cycle, further = "G98 G83 X5. Y5. Z-20. R3. Q8. F100", "".join(f"X{10 + x}.\n" for x in range(20))
    program = f"G21 G90\nG0 X0. Y0. Z20.\n{blocks.replace('CYCLE', cycle).replace('X9.', further)}\n"
    found: list[str] = []
    for line in bench.run(program, dialect="linuxcnc", integers="mm").decode().splitlines():
        said = re.search(r"G6[14].*(?<! G21)", line.removesuffix(" G21"))
        if said or ("Z-20" in line and found[-1:] != ["hole"]):
            found.append(said[0] if said else "hole")
    assert found == modes
    assert sum("exact path mode" in note for note in bench.report.notes) == (modes.count("G61") > blocks.count("G61\n"))
    if "CYCLE\nG64" not in blocks:
        assert bench.run(program, integers="mm").decode().count("G61") == blocks.count("G61")


def test_p_and_q_are_of_the_path_or_of_the_cycle(bench: Bench) -> None:
    head = "G21 G90\nG0 X0. Y0. Z20.\nG98 G83 X5. Y5. Z-20. R3. Q8. F100\n"
    assert bench.run(f"{head}G64 P1 Q1\nX9.\n", dialect="linuxcnc").decode().count("Z-5.000") == 2
    with pytest.raises(InputError, match="whose P and Q are is not determined; make it two blocks"):
        bench.run(f"{head}G64 P1 Q1 X9.\n", dialect="linuxcnc")


def test_boring_stops_the_spindle(bench: Bench) -> None:
    text = bench.run("G21 G90 M4\nG0 X0. Y0. Z20.\nG99 G86 X1. Z-3. R1. F60\n").decode().splitlines()
    assert text[2:] == ["F60 G0 X1.000", "G0 Z1.000", "G1 Z-3.000", "M5", "G0 Z1.000", "M4"]


@pytest.mark.parametrize(
    ("block", "said", "kwargs"),
    [
        ("G81 X1. Z-1. F9", "G81 without Z and R", {}),
        ("G83 X1. Z-1. R2. F9", "G83 without Q above 0", {}),
        ("G81 X1. Z3. R2. F9", "Z is not below R", {}),
        ("G81 Z-1. R2. F9\nR3.", "whether it drills differs by control", {}),
        ("G86 X1. Z-1. R2. F9", "spindle is not known to turn", {}),
        ("G18 G81 X1. Z-1. R2. F9", "G81 without Z and R", {}),
        ("G93 G81 X1. Z-1. R2. F9", "under G93", {}),
        ("G28 G81 X1. Z-1. R2. F9", "axis words that are data, and a motion, in one block", {}),
        ("G92 G81 X1. Z-1. R2. F9", "axis words that are data, and a motion, in one block", {}),
        ("G52 G81 X1. Z-1. R2. F9", "axis words that are data, and a motion, in one block", {}),
        ("G53 G81 X1. Z-1. R2. F9", "G81 in a block with G53; the words of a cycle alone", {"offsets": KNOWN}),
        ("G81 X1. Z-1. R2. F9\nG53 G81 X4.", "G81 in a block with G53", {"offsets": KNOWN}),
        ("G81 X1. Z-1. R2. L0", "no number of repeats", {}),
        ("G81 X1. Z-1. R2. L1.5", "no number of repeats", {}),
        ("G81 X1. Z-1. R2. M6", "a block of its own", {}),
        ("M6\nG81 X1. Z-1. R2.", "goes back to a Z that the program has not commanded", {}),
        ("G53 G0 Z5.\nG54\nG98 G81 X1. Z-1. R2.", "goes back to a Z", {"offsets": KNOWN}),
        ("G91 G99 G81 X1. Z-1. R-2.\nX2.", "what R counts from differs", {}),
        ("G81 G84 X1. Z-1. R-2.", "G84 is a canned cycle", {}),
        ("G81 G82 X1. Z-1. R-2.", "another code of its group", {}),
        ("G81 X1. Z-1. R2.", "is not SINUMERIK", {"dialect": "siemens"}),
        ("/G81 X1. Z-1. R2.", "block with /", {}),
        ("G81 X5000. Z-1. R2.", "outside its travel", {}),
        ("G81 X1. Z-1. R2. F9\nG80\nX5.", "no motion", {}),
        ("G81 X1. Z-1. R2. I3.", "I or J in a block", {}),
        ("G81 X1. Z-1. R2.\nG20 X1.", "line 4: G81 without Z and R", {}),
        ("G81 X1. Z-1. R2.\nG91 X1.", "line 4: G81 without Z and R", {}),
    ],
)
def test_cycles_that_are_refused(bench: Bench, block: str, said: str, kwargs: Any) -> None:
    with pytest.raises(InputError, match=said):
        bench.run(f"G21 G90\nG0 X0. Y0. Z20.\n{block}\n", **kwargs)


def test_a_cycle_under_g99_needs_no_level(bench: Bench) -> None:
    """Z stands where G53 has put it, which is known only roughly in G54: it gets its first word at R."""
    program = f"{HEAD}N3 G53 G0 Z50.\nN4 G99 G81 X1. Y2. Z-1. R2. F9\nN5 X3.\n"
    written = bench.run(program, paper_sized(5.0), offsets=KNOWN)
    true = {"G54": {axis: value[0] + 3.0 for axis, value in KNOWN.systems["G54"].items()}}
    source, control = both(program, written, offsets=true)
    for a, b in zip(path(source)[1:], path(control)[1:], strict=False):
        assert a[2] == pytest.approx(b[2], abs=0.3)


BLOCKS = st.lists(
    st.tuples(
        st.sampled_from(
            [
                "",
                "",
                "",
                "G80",
                "G0",
                "G1",
                *CODES,
                "G98",
                "G99",
                "G54",
                "G55",
                "G53 G0",
                "M6",
                "G91",
                "G90",
                "G20",
                "G21",
            ]
        ),
        st.tuples(*[st.one_of(st.none(), st.integers(-2000, 2000)) for _ in range(2)]),
        st.one_of(st.none(), st.integers(-9000, 0)),
        st.one_of(st.none(), st.integers(1, 4000)),
        st.sampled_from(["", "", "", " L2"]),
    ),
    min_size=2,
    max_size=12,
)


@settings(max_examples=150, deadline=None)
@given(BLOCKS, st.integers(-50, 50), FEWEST)
def test_programs_with_cycles_go_where_the_control_goes(blocks: list[Any], wrong: int, fewest: int) -> None:
    lines = [*HEAD.splitlines()]
    for place, (code, across, z, r, repeats) in enumerate(blocks):
        words = "".join(f" {axis}{v / 1000:.4f}" for axis, v in zip("XY", across, strict=True) if v is not None)
        words += f" Z{z / 1000:.4f}" if z is not None else ""
        drills = code.startswith(("G7", "G8")) and code != "G80"
        words += f" R{r / 1000:.4f}" if r is not None and (drills or code == "") and words else ""
        if code in ("G80", "M6", "G98", "G99", "G91", "G90", "G20", "G21"):
            words = ""
        lines.append(f"N{place + 5} {code}{words}{repeats if drills and words else ''}")
    source = "\n".join(lines) + "\n"
    with tempfile.TemporaryDirectory() as folder, runs_of(fewest):
        bench = Bench(Path(folder))
        try:
            written = bench.run(source, paper_sized(3.0), offsets=KNOWN, dialect="linuxcnc", integers="mm")
        except InputError:
            return
    true = {
        name: {axis: value[0] + wrong / 10 * (1 + (name == "G55")) for axis, value in of.items()}
        for name, of in KNOWN.systems.items()
    }
    by_source, by_written = both(source, written, offsets=true)
    ends = [[{number: at for number, _, at, _ in one.trace} for one in (by_source, by_written)]]
    for one, other in ends:
        assert one.keys() <= other.keys()
        for number, at in one.items():
            assert max(abs(at[axis] - other[number][axis]) for axis in AXES) < 0.3, (number, source, written.decode())


@pytest.mark.parametrize("code", CODES)
def test_a_cycle_feeds_as_a_line_does_where_an_axis_may_stand_anywhere(bench: Bench, code: str) -> None:
    """Y is taken to stand at home and gets no word; that it may stand elsewhere is too much, as of a line."""
    head = "G21 G90 G17 M3\nG0 Z20.\n"
    changes = []
    for blocks in (f"{code} X10. Z-6. R2. F100\nG80\n", "G0 X10. Z2.\nG1 Z-6. F100\n"):
        text = bench.run(head + blocks, paper_sized(), integers="mm")
        assert b"Y" not in text
        assert not bench.report.good
        found = bench.report.unnamed_feeds
        assert found is not None
        assert (found.places, found.near) == ({"Y": 0.0}, None)
        assert found.anywhere is not None
        changes.append(found.anywhere.largest)
    assert changes[0] == pytest.approx(changes[1], rel=0.05)
    bench.run(f"{head}{code} X10. Z-6. R2. F100\nG80\n", paper_sized(), integers="mm", start={"Y": 0.0})
    assert bench.report.good
