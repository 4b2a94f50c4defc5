"""Work offsets: the model sees machine positions, the words go back in the frame in which they came."""

import math
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
from tests.compensation.shop_control import AXES, Control
from tests.compensation.test_command import command
from trueaxis.compensation.offsets import Offsets, offset_of_option, read_offsets
from trueaxis.io.faults import InputError

ORIGIN = np.zeros((3, 1))
G54, G55 = {"X": 120.5, "Y": -80.25, "Z": -150.125}, {"X": -200.0, "Y": 150.0, "Z": 40.0}
KNOWN = Offsets({name: {axis: (v, v) for axis, v in of.items()} for name, of in (("G54", G54), ("G55", G55))})


def off(machine: XyzMachine, source: Control, written: Control, feeds_only: bool = True) -> float:
    """Largest distance of the tool from where the error-free machine has it, at the ends of the source's blocks."""
    worst = 0.0
    ends = {number: at for number, _, at, _ in written.trace}
    for number, motion, at, _ in source.trace:
        if feeds_only and not motion:
            continue
        got, wanted = (np.array([[one[axis]] for axis in AXES]) for one in (ends[number], at))
        worst = max(worst, float(np.linalg.norm(machine.actual(got, ORIGIN) - machine.ideal(wanted, ORIGIN))))
    return worst


def both(source: str, written: bytes, **known: Any) -> tuple[Control, Control]:
    """A control that has run the source, and one that has run what was written; each with its own tables."""
    found = []
    for program in (source, written.decode()):
        at = dict(known.get("at", dict.fromkeys(AXES, 0.0)))
        offsets = {name: dict(of) for name, of in known.get("offsets", {"G54": G54, "G55": G55}).items()}
        rest = {key: value for key, value in known.items() if key not in ("at", "offsets")}
        control = Control(at, offsets, **rest)
        control.run(program)
        found.append(control)
    return found[0], found[1]


PROGRAM = """N1 G21 G90 G54
N2 G0 X10. Y20. Z5.
N3 G1 Z-2. F200
N4 X60. Y25.
N5 G55 G0 X-5. Y0.
N6 Z8.
N7 G1 X20. F100
N8 G91 X10. Y5.
N9 G90 G54 G0 X0. Y0. Z10.
N10 G53 G0 Z0.
N11 X5.
N12 Z3.
N13 G1 X6.5 F90
"""


def test_positions_are_right_in_every_frame(bench: Bench) -> None:
    machine = paper_sized(3.0)
    written = bench.run(PROGRAM, machine, offsets=KNOWN)
    assert bench.report.good
    source, control = both(PROGRAM, written)
    assert off(machine, source, control) <= 0.001
    uncompensated, _ = both(PROGRAM, written)
    assert off(machine, source, uncompensated) > 0.01
    shown = bench.told
    assert (
        "G54 is taken at X120.5 Y-80.25 Z-150.125 in machine coordinates; if its zero is 10 mm elsewhere, compensated"
        in shown
    )
    assert "G55 is taken at" in shown


def test_the_words_are_those_of_machine_positions_less_the_offset(bench: Bench) -> None:
    machine = XyzMachine({"EXX": lambda x: 1e-4 * x})
    text = bench.run("G21 G90 G54\nG0 X10. Y20. Z5.\nG20 X1.\nG91 X1.\n", machine, offsets=KNOWN).splitlines()
    x = float(re.findall(rb"X([-.\d]+)", text[1])[0])
    assert x == pytest.approx((10.0 + 120.5) / 1.0001 - 120.5, abs=0.00051)
    inch = float(re.findall(rb"X([-.\d]+)", text[2])[0])
    assert 25.4 * inch == pytest.approx((25.4 + 120.5) / 1.0001 - 120.5, abs=0.00013)
    assert float(re.findall(rb"X([-.\d]+)", text[3])[0]) == pytest.approx(1 / 1.0001, abs=0.00002)


def test_a_control_begins_in_g54(bench: Bench) -> None:
    machine = paper_sized(3.0)
    program = "N1 G21 G90\nN2 G0 X10. Y20. Z5.\nN3 G1 X60. F100\n"
    source, control = both(program, bench.run(program, machine, offsets=KNOWN))
    assert off(machine, source, control) <= 0.001
    assert any("G54 is taken to be in force" in note for note in bench.report.notes)
    only = Offsets({"G55": KNOWN.systems["G55"]})
    with pytest.raises(InputError, match=r"line 2: which work offset is in force here is not known") as error:
        bench.run(program, machine, offsets=only)
    assert len(error.value.faults) == 2
    assert bench.run(program.replace("G90", "G90 G55"), machine, offsets=only)
    running = Offsets(KNOWN.systems, active="G55")
    source, control = both(program, bench.run(program, machine, offsets=running), system="G55")
    assert off(machine, source, control) <= 0.001


def test_an_offset_that_is_not_known(bench: Bench) -> None:
    with pytest.raises(InputError, match=r"line 2: G56: where its zero lies is not known; say --offset G56=X") as error:
        bench.run("G21 G90\nG56 G0 X1. Y1. Z1.\n", offsets=KNOWN)
    assert len(error.value.faults) == 1
    with pytest.raises(InputError, match="G54"):
        bench.run("G21 G90\nG54\nG0 X1. Y1. Z1.\n")


def test_an_offset_that_is_not_known_is_the_one_fault_of_all_its_positions(bench: Bench) -> None:
    """Where the axes would be if the zero were that of the machine is no fault of its own."""
    program = "G21 G90\nG0 X9999. Y0. Z0.\nG56 G0 X9999. Y1. Z1.\nY8888.\nG56\nX-7777.\n"
    with pytest.raises(InputError) as error:
        bench.run(program, offsets=KNOWN)
    assert [fault.place for fault in error.value.faults] == ["line 2", "line 3"]


def test_an_axis_that_stays_outside_its_travel_is_one_fault(bench: Bench) -> None:
    with pytest.raises(InputError) as error:
        bench.run("G21 G90 G53\nG0 G53 X0. Y0. Z0.\nG53 G0 X9999.\nG53 G0 Y10.\nG53 G0 Y8888.\nG53 G0 X9998.\n")
    assert [str(fault).split(": ", 1)[1].split(" is")[0] for fault in error.value.faults] == [
        "line 3: X = 9999", "line 5: Y = 8888", "line 6: X = 9998",
    ]  # fmt: skip


def test_travel_is_that_of_machine_positions(bench: Bench) -> None:
    of_offset = "line 2: X = 1020.5 is outside its travel; from -1000 to 1000; 120.5 of it are the work offset"
    with pytest.raises(InputError, match=of_offset):
        bench.run("G54 G21 G90\nG0 X900. Y0. Z0.\n", offsets=KNOWN)


def test_arcs_in_a_frame(bench: Bench) -> None:
    machine = paper_sized(3.0)
    written = bench.run("N1 G21 G90 G55\nN2 G0 X30. Y0. Z1.\nN3 G2 X30. Y0. I-30. J0. F100\n", machine, offsets=KNOWN)
    _, control = both("", written)
    at = np.array([[one[axis] for axis in AXES] for _, motion, one, _ in control.trace if motion == 1]).T
    centre = machine.ideal(np.array([[-200.0], [150.0], [41.0]]), ORIGIN)
    radius = np.linalg.norm((machine.actual(at, ORIGIN) - centre)[:2], axis=0)
    assert at.shape[1] > 20
    assert np.abs(radius - 30.0).max() <= 0.0012


@pytest.mark.parametrize(
    ("shift", "dialect"),
    [
        ("G52 X15. Y-3.", None), ("G52 X15. Z2.5", "linuxcnc"), ("G10 L2 P1 X130. Y-80.25\nN7 G0 X1. Y2.", None),
        ("G92 X0. Y0.", None),
        ("G10 L20 P1 X7. Z1.125", "linuxcnc"), ("G10 L20 P2 X7. Z1.", "linuxcnc"), ("G20\nN7 G92 X0.5\nN8 G21", None),
        ("G92 X5.\nN7 G92.2\nN8 G0 X9.", "linuxcnc"), ("G92 Z5.\nN7 G92.1\nN8 G0 Z9.", "linuxcnc"),
        ("G92 X5. Y1. Z7.\nN7 G91\nN8 G1 X5. F90\nN9 G90\nN10 G92 X3. Z1.", None),
    ],
)  # fmt: skip
def test_shifts_of_the_program(bench: Bench, shift: str, dialect: str | None) -> None:
    """What G92 takes over is where the machine stands: where the words put it, not the program."""
    machine = paper_sized(30.0)  # 0.6 mm
    program = (
        f"N1 G21 G90 G54\nN2 G0 X10. Y20. Z5.\nN3 G1 X40.5 Y22. F100\nN6 {shift}\nN20 G1 X20. F90\nN21 Y10. Z4.\n"
        "N22 X30. Y11. Z6.\nN23 G55 G0 X3. Y4. Z5.\nN24 G1 X1. F90\n"
    )
    written = bench.run(program, machine, offsets=KNOWN, dialect=dialect)
    source, control = both(program, written, linuxcnc=dialect == "linuxcnc")
    assert off(machine, source, control) <= 0.0011
    before = machine.deviation(np.array([[160.5], [-58.25], [-145.125]]), ORIGIN)
    assert np.linalg.norm(before) > 0.1


@pytest.mark.parametrize(
    ("block", "words", "dialect"),
    [
        ("G92 X0.", "where that is is not known", None),
        ("G0 X1. Y1. Z1.\nM0\nG92 X0.", "line 4: G92 gives X a value where it stands", None),
        ("G0 X1. Y1. Z1.\nM6\nG92 X0.", "line 4: G92 gives X a value where it stands", None),
        ("G10 L20 P1 X0.", "say --dialect linuxcnc or fanuc", None),
        ("G10 L1 P1 R5.", "changes data that are not followed", None),
        ("G10 L2 P0 X0.", "P1 to P6", None),
        ("G10 L2 P1 X0. R30.", "G10 with R turns", None),
        ("G91 G10 L2 P1 X0.", "differs by control", "fanuc"),
        ("G91 G52 X0.", "differs by control", None),
        ("G0 X1. Y1. Z1.\nG92 X0.\nG52 X1.", "G52 and G92 together", None),
        ("G0 X1. Y1. Z1.\nG92 X0.\nG92.1", "G92.1 ends all of G92", None),
        ("G92.3", "G92.3 restores a shift", "linuxcnc"),
        ("G2 G52 X0.", "axis words that are data, and a motion", None),
        ("G58", "SINUMERIK", "siemens"), ("G54", "shifts the datum", "heidenhain"), ("G52 X1.", "SINUMERIK", "siemens"),
        ("G54 G55", "another code of its group", None), ("/G54", "block with /", None),
        ("/G52 X5.", "block with /", None),
        ("G52 Q5.", "address Q|Q5", None), ("G54.1 P3", r"G54.1 P3: .*--offset G54.1P3=", None),
    ],
)  # fmt: skip
def test_shifts_that_are_refused(bench: Bench, block: str, words: str, dialect: Any) -> None:
    with pytest.raises(InputError, match=words):
        bench.run(f"G21 G90\n{block}\n", offsets=KNOWN, dialect=dialect)


def test_extended_offsets_of_fanuc(bench: Bench) -> None:
    machine = paper_sized(3.0)
    known = Offsets({"G54.1 P3": KNOWN.systems["G55"]})
    text = bench.run("G21 G90\nG54.1 P3\nG0 X1. Y2. Z3.\n", machine, offsets=known)
    expected = bench.run("G21 G90\nG55\nG0 X1. Y2. Z3.\n", machine, offsets=KNOWN)
    assert text.splitlines()[2] == expected.splitlines()[2]
    written = bench.run("G21 G90\nG10 L20 P3 X-200. Y150. Z40.\nG54.1 P3\nG0 X1. Y2. Z3.\n", machine, dialect="fanuc")
    assert written.splitlines()[3] == expected.splitlines()[2]


BLOCKS = st.lists(
    st.tuples(
        st.sampled_from(
            ["", "", "", "G54", "G55", "G53", "G91", "G90", "G52", "G92", "G10 L2 P1", "G10 L2 P2", "M6", "G0"]
        ),
        st.tuples(*[st.one_of(st.none(), st.integers(-40000, 40000)) for _ in range(3)]),
    ),
    min_size=3,
    max_size=14,
)
TENTHS = st.tuples(*[st.integers(-100, 100)] * 6)


@settings(max_examples=150, deadline=None)
@given(BLOCKS, TENTHS, st.tuples(*[st.integers(-200, 200)] * 3), st.booleans())
def test_no_axis_is_put_elsewhere_whatever_the_true_offsets_are(
    blocks: list[tuple[str, tuple[int | None, ...]]], wrong: tuple[int, ...], at: tuple[int, ...], linuxcnc: bool
) -> None:
    """The offsets that are given may be 10 mm wrong, and axes stand anywhere: no axis goes where the source has not
    sent it, to within the compensation, which is below 0.2 mm here.
    """
    lines = ["N1 G21 G90 G1 F100"]
    for place, (code, values) in enumerate(blocks):
        text = "".join(f" {axis}{v / 1000:.3f}" for axis, v in zip(AXES, values, strict=True) if v is not None)
        if code in ("G91", "G90", "M6") or (code in ("G54", "G55", "G0") and not text):
            text = ""
        elif not text:
            continue
        if code == "G53":
            lines.append(f"N{2 * place + 2} G90")
        lines.append(f"N{2 * place + 3} {code}{text}")
    source = "\n".join(lines) + "\n"
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(Path(folder))
        try:
            written = bench.run(
                source, paper_sized(5.0), offsets=KNOWN, dialect="linuxcnc" if linuxcnc else None, words="nearest"
            )
        except InputError:
            return
    true = {
        name: {axis: of[axis] + wrong[3 * row + k] / 10 for k, axis in enumerate(AXES)}
        for row, (name, of) in enumerate((("G54", G54), ("G55", G55)))
    }
    stands = dict(zip(AXES, map(float, at), strict=True))
    by_source, by_written = both(source, written, at=stands, offsets=true, linuxcnc=linuxcnc)
    ends = {number: end for number, _, end, _ in by_written.trace}
    assert [number for number, *_ in by_source.trace] == list(ends)
    for number, _, end, _ in by_source.trace:
        assert max(abs(ends[number][axis] - end[axis]) for axis in AXES) < 0.3, (number, source, written.decode())


def test_a_range_gives_the_worst_case(bench: Bench) -> None:
    machine = XyzMachine({"EXX": lambda x: 2e-8 * x * x, "EYX": lambda x: 1e-6 * x})
    program = "G21 G90 G54\nG0 X0. Y0. Z0.\nG1 X10. F100\n"
    ranged = Offsets({"G54": {"X": (0.0, 500.0), "Y": (1.0, 1.0), "Z": (2.0, 2.0)}})
    bench.run(program, machine, offsets=ranged, tolerance=0.02)
    (use,) = bench.report.offsets
    assert use.value["X"] == 250.0
    # between X = 250 and 510 mm, by hand
    worst = math.hypot(2e-8 * (510.0**2 - 260.0**2), 1e-6 * 250.0)
    assert use.change == pytest.approx(worst, rel=0.02)
    assert use.slopes["X"] == pytest.approx(math.hypot(2 * 2e-8 * 260.0, 1e-6), rel=0.02)
    assert use.slopes["Y"] == pytest.approx(0.0, abs=1e-12)
    assert "within the range by at most" in bench.told
    assert bench.report.good
    bench.run(program, machine, offsets=ranged, tolerance=0.003)
    assert not bench.report.good
    assert "within the ranges given" in bench.told
    narrow = Offsets({"G54": {**ranged.systems["G54"], "X": (995.0, 999.9)}})
    with pytest.raises(InputError, match="outside its travel"):
        bench.run(program, machine, offsets=narrow)


def test_files_and_options(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert offset_of_option("g054=X1.0,Y-2,Z0:500") == ("G54", {"X": (1.0, 1.0), "Y": (-2.0, -2.0), "Z": (0.0, 500.0)})
    toml = tmp_path / "offsets.toml"
    toml.write_text('[offset.G54]\nX = 100.0\nY = 100.0\nZ = [50.0, 60.0]\n[offset."G59.1"]\nX = 1\n')
    assert read_offsets(toml).systems == {
        "G54": {"X": (100.0, 100.0), "Y": (100.0, 100.0), "Z": (50.0, 60.0)}, "G59.1": {"X": (1.0, 1.0)}
    }  # fmt: skip
    var = tmp_path / "linuxcnc.var"
    values = {5210: 1, 5211: 0.5, 5220: 2, 5221: 10, 5222: 20, 5223: 30, 5241: 100, 5242: 200, 5243: 50, 5250: 0}
    var.write_text("".join(f"{number}\t{value:.6f}\n" for number, value in values.items()))
    found = read_offsets(var)
    assert found.active == "G55"
    assert found.shift["X"] == 0.5
    assert found.systems["G55"]["Z"] == (50.0, 50.0)
    program = "G21 G90\nG54 G0 X1. Y2. Z3.\nG1 X50. F900\n"
    for options in (["--offsets", str(toml)], ["--offset", "G54=X100,Y100,Z50:60"], ["--offsets", str(var)]):
        assert command(tmp_path, program, *options) == 0
        assert "10 mm elsewhere" in capsys.readouterr().out
    with pytest.raises(InputError, match="G54 is given twice"):
        command(tmp_path, program, "--offset", "G54=X1", "--offset", "G54=X2")


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("a.toml", "[offset.G53]\nX = 1.0\n", "is no work offset"),
        ("a.toml", '[offset.G54]\nX = "1"\nQ = 1\n', "lowest, highest"),
        ("a.toml", "[offset.G54]\nX = [2.0, 1.0]\n", "from 2 down to 1"),
        ("a.toml", "[tool.1]\nlength = 1\n", "offset"),
        ("a.var", "5221 1.0\nhello\n", "line 2"),
        ("a.var", "5221 1.0\n5230 30.0\n", "G54 is turned"),
        ("a.var", "5161 1.0\n", "holds no work offset"),
        ("a.var", "5221 1e9\n", "beyond"),
        ("a.var", "5220 1e400\n5221 1.0\n", "5220 is inf, no work offset"),
        ("a.var", "5220 1.5\n5221 1.0\n", "5220 is 1.5, no work offset"),
        ("a.var", "5210 1\n5211 1e400\n5221 1.0\n", "G92 X is not finite"),
        ("a.var", "5221 1.0\n5230 1e400\n", "G54 is turned"),
    ],
)
def test_faults_of_files(tmp_path: Path, name: str, text: str, words: str) -> None:
    (tmp_path / name).write_text(text)
    with pytest.raises(InputError, match=words):
        read_offsets(tmp_path / name)


@pytest.mark.parametrize("text", ["G53=X1", "G54", "G54=", "G54=X1,X2", "G54=X2:1", "G54=Q1", "G54=X1e9", "G54=Xnan"])
def test_options_that_are_none(text: str) -> None:
    with pytest.raises(ValueError, match="G5"):
        offset_of_option(text)
