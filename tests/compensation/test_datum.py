"""Work offsets that were touched off without compensation: the part is measured against the datum that the shop probed.

The machine, the probe and the control are the chain of matrices of tests/exact_chain with exact rotations, and a reader
of words of its own; nothing of the package computes what is asserted.
"""

import json
import re
from typing import Any

import numpy as np
import pytest

from tests.compensation.analytic_machine import FloatArray, XyzMachine, paper_sized
from tests.compensation.control import Bench
from tests.compensation.extended_model import extended
from tests.compensation.five_axes import TEXTS, FiveAxes
from tests.compensation.test_command import command
from tests.compensation.test_effects import SQUARENESS, coefficients
from tests.exact_chain import rotated
from tests.machines import serial_text
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.tools import Tool, ToolTable
from trueaxis.compensation.touched_off import TouchedOff, touched_off_of_option
from trueaxis.effects.kind import Effect
from trueaxis.io.faults import InputError
from trueaxis.reporting.compensation_checks import sign_check_text

PROBE, CUTTER = 118.0, 74.5
TOOLS = ToolTable({3: Tool(length=CUTTER)})
MACHINES = {"three axes": serial_text("Y", "XZ"), **{name: TEXTS[name] for name in ("table-table", "head and table")}}


def exact(name: str, seed: int) -> FiveAxes:
    machine = FiveAxes(MACHINES[name], size=2.0, seed=seed)
    machine.chain.error = rotated
    return machine


def tip(machine: FiveAxes, at: FloatArray, length: float, ideal: bool = False) -> FloatArray:
    """The tip of a tool of that length in the workpiece frame, axes at these machine positions."""
    point, _ = machine.pose_of(at, np.array([[0.0], [0.0], [-length]]), ideal=ideal)
    return np.array([float(part) for part in point])


def places(program: str, axes: str, zero: FloatArray) -> list[tuple[bool, FloatArray]]:
    """Whether by feed, and the machine position, after every block; the control holds `zero` in G54, G43 in Z."""
    at, feeding, found = zero.copy(), False, []
    for line in program.splitlines():
        words = re.findall(r"([A-Z])([-+]?[\d.]+)", re.sub(r"\(.*?\)", "", line))
        codes = {float(value) for letter, value in words if letter == "G"}
        feeding = (feeding or 1.0 in codes) and 0.0 not in codes
        named = {letter: float(value) for letter, value in words if letter in axes}
        for row, axis in enumerate(axes):
            if axis in named:
                shift = 0.0 if 53.0 in codes else zero[row] + (CUTTER if axis == "Z" else 0.0)
                at[row] = named[axis] + shift
        if named:
            found.append((feeding, at.copy()))
    return found


def part_program(axes: str, random: np.random.Generator) -> str:
    rotary = axes[3:]
    lines = ["G21 G90 G54 G94", "G0 " + " ".join(f"{axis}0.0" for axis in rotary) if rotary else "G17", "T3 M6"]
    lines += ["G0 X10. Y10. " + " ".join(f"{axis}5." for axis in rotary), "G43 H3 Z30.", "G1 Z-2. F400"]
    for _ in range(12):
        x, y, z = np.round(random.uniform([-30.0, -40.0, -20.0], [60.0, 40.0, 5.0]), 3)
        turns = " ".join(f"{axis}{angle:.3f}" for axis, angle in zip(rotary, random.uniform(-70, 70, 2), strict=False))
        lines.append(f"X{x} Y{y} Z{z} {turns}".rstrip())
    return "\n".join([*lines, "G0 Z40.", "M30", ""])


def worst_against_datum(machine: FiveAxes, source: str, written: str, zero: FloatArray, probed: FloatArray) -> float:
    """Largest distance of a cut from where it is to be seen from the datum: source and result, block by block."""
    axes = "".join(machine.chain.axes)
    datum = tip(machine, probed, PROBE)  # where the ball truly was when the control took over the zero
    nominal = tip(machine, probed, PROBE, ideal=True)
    wanted = [at for feed, at in places(source, axes, zero) if feed]
    cut = [at for feed, at in places(written, axes, zero) if feed]
    ends = [min(cut, key=lambda one: np.abs(one - at).max()) for at in wanted]
    return max(
        float(np.linalg.norm((tip(machine, got, CUTTER) - datum) - (tip(machine, at, CUTTER, ideal=True) - nominal)))
        for got, at in zip(ends, wanted, strict=True)
    )


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize("name", MACHINES)
def test_the_part_is_right_against_the_datum_that_was_probed(bench: Bench, name: str, seed: int) -> None:
    """A control without compensation holds what it displays where the ball touched, less the length of the probe."""
    machine, random = exact(name, seed), np.random.default_rng(100 + seed)
    axes = "".join(machine.chain.axes)
    probed = np.array([120.0, -90.0, 160.0, 30.0, -25.0][: len(axes)])  # a rotary table is turned while it is probed
    zero = probed - np.array([0.0, 0.0, PROBE, 0.0, 0.0])[: len(axes)]
    offsets = Offsets({"G54": {axis: (value, value) for axis, value in zip(axes, zero.tolist(), strict=True)}})
    source = part_program(axes, random)
    found = {}
    for touched in ((), (touched_off_of_option(f"G54=L{PROBE:g}"),)):
        written = bench.run(source, machine.model, offsets=offsets, tools=TOOLS, touched_off=touched, dialect="fanuc")
        assert bench.report.good
        found[bool(touched)] = worst_against_datum(machine, source, written.decode(), zero, probed)
    off = float(np.linalg.norm(tip(machine, probed, PROBE) - tip(machine, probed, PROBE, ideal=True)))
    assert found[True] <= 0.001
    assert found[False] == pytest.approx(off, abs=0.0025)
    assert off > 0.01
    (use,) = bench.report.offsets
    assert use.zero.touched_off
    assert np.linalg.norm(use.zero.off) == pytest.approx(
        off, abs=1e-5
    )  # the spec's small rotations are not of length 1


G54 = {"X": 120.5, "Y": -80.25, "Z": -150.125}
KNOWN = Offsets({name: {axis: (v, v) for axis, v in G54.items()} for name in ("G54", "G55")})


def words(text: bytes) -> list[dict[str, float]]:
    found = [re.findall(r"([XYZ])([-+]?[\d.]+)", line) for line in text.decode().splitlines()]
    return [{axis: float(value) for axis, value in line} for line in found if line]


def correction(machine: XyzMachine, at: dict[str, float]) -> FloatArray:
    position = np.array([[at[axis]] for axis in "XYZ"])
    return np.asarray(machine.correction(position, -machine.deviation(position, np.zeros((3, 1)))))[:, 0]


def test_each_offset_and_machine_coordinates_for_themselves(bench: Bench) -> None:
    machine = paper_sized(3.0)
    program = (
        "G21 G90\nG54 G0 X10. Y20. Z5.\nG55 G0 X10. Y20. Z5.\nG53 G0 X200. Y100. Z50.\nG54 G1 X10. Y20. Z5. F100\n"
    )
    plain = words(bench.run(program, machine, offsets=KNOWN))
    touched = words(bench.run(program, machine, offsets=KNOWN, touched_off=(TouchedOff(system="G54"),)))
    datum = correction(machine, G54)
    assert np.abs(datum).max() > 0.01
    for block in (0, 3):
        apart = [plain[block][axis] - touched[block][axis] for axis in "XYZ"]
        assert apart == pytest.approx(datum.tolist(), abs=0.0011)
    assert (plain[1], plain[2]) == (touched[1], touched[2])


def test_each_direction_where_it_was_touched(bench: Bench) -> None:
    machine = paper_sized(3.0)
    program = "G21 G90 G54\nG0 X0. Y0. Z0.\n"
    stated = ("G54:X=X60,Y-50,Z-160", "G54:Y=X130,Y-120,Z-160", "G54:Z=X150,Y-60,L40")
    touched = tuple(map(touched_off_of_option, stated))
    plain = words(bench.run(program, machine, offsets=KNOWN))[0]
    found = words(bench.run(program, machine, offsets=KNOWN, touched_off=touched))[0]
    probe = np.array([[0.0], [0.0], [-40.0]])
    above = np.array([[150.0], [-60.0], [G54["Z"] + 40.0]])
    wanted = {
        "X": correction(machine, {"X": 60.0, "Y": -50.0, "Z": -160.0})[0],
        "Y": correction(machine, {"X": 130.0, "Y": -120.0, "Z": -160.0})[1],
        "Z": machine.correction(above, -machine.deviation(above, probe))[2, 0],
    }
    for axis, value in wanted.items():
        assert plain[axis] - found[axis] == pytest.approx(value, abs=0.0011), axis


def test_the_report_says_what_the_zero_means_for_the_part(bench: Bench) -> None:
    machine = paper_sized(3.0)
    program = "G21 G90 G54\nG0 X0. Y0. Z0.\nG1 X40. Y10. F100\n"
    bench.run(program, machine, offsets=KNOWN)
    off = 1e3 * machine.deviation(np.array([[value] for value in G54.values()]), np.zeros((3, 1)))[:, 0]
    (use,) = bench.report.offsets
    assert np.array(use.zero.off) * 1e3 == pytest.approx(off)
    back = " ".join(f"{axis} {-part:+.1f}" for axis, part in zip("XYZ", off, strict=True))
    assert f"the whole part comes to lie {back} um off its datum: say --touched-off G54, with" in bench.told
    before = bench.report.before
    bench.run(program, machine, offsets=KNOWN, touched_off=(TouchedOff(system="G54"),))
    assert "G54 was touched off without compensation" in bench.told
    assert json.loads(bench.report.to_json())["offsets"][0]["zero"]["touched_off"] is True
    # uncompensated, a part is off its own datum by the difference of the deviations alone
    assert bench.report.before is not None
    assert before is not None
    assert bench.report.before.largest < before.largest


def test_the_advice_has_the_length_of_the_first_tool(bench: Bench) -> None:
    """Motions before the first G43 are of no tool: the place of the spindle nose is 80 mm from where the tip was."""
    program = "G21 G90 G54\nG0 X0. Y0.\nT1 M6\nG43 H1 Z50.\nG0 X0. Y0. Z20.\nG1 X40. Y10. F100\n"
    bench.run(program, paper_sized(3.0), offsets=KNOWN, tools=ToolTable({1: Tool(80.0)}), dialect="fanuc")
    assert "say --touched-off G54=L80, the length being that of the tool which the program uses first" in bench.told


def test_the_advice_has_the_rotary_position_in_which_an_offset_is_used(bench: Bench) -> None:
    """Of every indexed face: the displacement of the datum is that of the table as it stands there."""
    machine = exact("table-table", 3)
    zero = {"X": 20.0, "Y": -30.0, "Z": 40.0, "A": 0.0, "C": 0.0}
    offsets = Offsets({name: {axis: (at, at) for axis, at in zero.items()} for name in ("G54", "G55")})
    face = "G0 X0. Y0. Z50. A0. C{}.\nG1 Z0. F200\nX20.\nG0 Z50.\n"
    program = f"G21 G90 G17 G54\n{face.format(0)}G55\n{face.format(90)}M30\n"
    bench.run(program, machine.model, offsets=offsets)
    assert "say --touched-off G54, with L120" in bench.told
    assert "say --touched-off G55=C90, C being where the program first cuts with it" in bench.told
    found = {use.system: np.array(use.zero.off) for use in bench.report.offsets}
    for system, turned in (("G54", 0.0), ("G55", 90.0)):
        at = np.array([*list(zero.values())[:4], turned])
        off = tip(machine, at, 0.0) - tip(machine, at, 0.0, ideal=True)
        assert found[system] == pytest.approx(off, abs=1e-5)
    apart = 1e3 * float(np.linalg.norm(found["G54"] - found["G55"]))
    assert "WARNING: G54, G55: if they were touched off without compensation, what is machined from one" in bench.told
    assert f"by {apart:.3g} um from G54 to G55" in bench.told
    bench.run(
        program, machine.model, offsets=offsets, touched_off=tuple(map(touched_off_of_option, ("G54", "G55=C90")))
    )
    assert "WARNING" not in bench.told


def test_the_sign_check_is_of_the_machine_whatever_the_datum(bench: Bench) -> None:
    machine = paper_sized(3.0)
    program = "G21 G90 G54\nG0 X0. Y0. Z0.\nG1 X300. Y200. Z100. F100\n"
    checks = []
    for touched in ((), (TouchedOff(system="G54"),)):
        bench.run(program, machine, offsets=KNOWN, touched_off=touched)
        checks.append(bench.report.sign_check)
    plain, datum = checks
    assert plain is not None
    assert datum is not None
    assert (plain.position, plain.direction, plain.since_home) == (datum.position, datum.direction, datum.since_home)
    assert datum.correction - datum.datum == pytest.approx(plain.correction, abs=0.0011)
    assert datum.compensated == pytest.approx(datum.datum - datum.at_home, abs=0.0011)
    said = f"it must show {datum.compensated:+.4f} mm (not zero, as home itself is not corrected)"
    assert said in sign_check_text(datum)


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("G54:Z", r"nothing says where X Y was touched off"),
        ("G56", r"G56: where its zero lies is not known; --offset G56=X"),
        ("G54=Z-5000", r"Z = -5000 is outside its travel, from -1000 to 1000"),
        ("G54=C5", r"this machine has no axis C"),
    ],
)
def test_what_cannot_be(bench: Bench, text: str, problem: str) -> None:
    with pytest.raises(InputError, match=problem):
        bench.run("G54 G0 X1.\n", offsets=KNOWN, touched_off=(touched_off_of_option(text),))


@pytest.mark.parametrize("text", ["G99", "G54=", "G54=Q1", "G54:=X1", "G54:XX", "G54=X1,X2", "G54=X1e9", "G54:A=X1"])
def test_an_option_that_is_none(text: str) -> None:
    with pytest.raises(ValueError, match="G54"):
        touched_off_of_option(text)


def test_an_offset_that_the_program_writes_was_not_touched_off(bench: Bench) -> None:
    with pytest.raises(InputError, match="line 2: G10 gives G54 a value, and --touched-off says"):
        bench.run(
            "G21 G90\nG10 L2 P1 X1. Y2. Z3.\nG54 G0 X1.\n", offsets=KNOWN, touched_off=(TouchedOff(system="G54"),)
        )


TAUGHT = {
    "fanuc": ("G21 G90 G54\nG0 X10. Y20. Z5.\nG53 G0 Z50.\nG53 X200. Y100.\nG0 X10. Y20.\nZ5.\n", "G53"),
    "siemens": ("G71 G90 G54\nG0 X10. Y20. Z5.\nG0 SUPA Z=50.\nSUPA X200. Y100.\nG0 X10. Y20.\nZ5.\n", "SUPA"),
    "heidenhain": (
        "BEGIN PGM A MM\nL X+10 Y+20 Z+5 R0 FMAX\nL Z+50 R0 FMAX M91\nL X+200 Y+100 R0 FMAX M91\n"
        "L X+10 Y+20 R0 FMAX\nL Z+5 R0 FMAX\nEND PGM A MM\n",
        "M91",
    ),
}


@pytest.mark.parametrize("dialect", TAUGHT)
def test_taught_places_stay(bench: Bench, dialect: Any) -> None:
    program, code = TAUGHT[dialect]
    machine = paper_sized(3.0)
    given: dict[str, Any] = {"offsets": KNOWN, "dialect": dialect}
    moved = bench.run(program, machine, **given).decode().splitlines()
    kept = bench.run(program, machine, keep_g53=True, **given).decode().splitlines()
    source = program.splitlines()
    for line, other, same in zip(source, moved, kept, strict=True):
        if code in line:
            assert same == line
            assert other != line
    # the blocks in G54 are compensated all the same, to the same words
    assert [line for line in moved if code not in line] == [line for line in kept if code not in line]
    assert any("left as it is (--keep-g53)" in note for note in bench.report.notes)


def test_by_the_command(tmp_path: Any, capsys: pytest.CaptureFixture[str]) -> None:
    program = "G21 G90\nG54 G0 X10. Y10. Z10.\nG1 X50. F900\nG53 G0 Z555.\n"
    offset = ["--offset", "G54=X200,Y150,Z100"]
    assert command(tmp_path, program, *offset, "--touched-off", "G54=L60", "--keep-g53") == 0
    shown = capsys.readouterr().out
    assert "G54 was touched off without compensation" in shown
    assert "G53 G0 Z555.\n" in (tmp_path / "out.nc").read_text()
    with pytest.raises(SystemExit):
        command(tmp_path, program, *offset, "--touched-off", "G77")
    with pytest.raises(InputError, match="--keep-g53: does not go with --via-linuxcnc"):
        command(tmp_path, program, *offset, "--keep-g53", "--via-linuxcnc")


def test_what_it_relies_on_counts_from_the_datum(tmp_path: Any, capsys: pytest.CaptureFixture[str]) -> None:
    """At the datum itself nothing is uncertain but what the program adds; home counts no more."""
    program = "G21 G90\nG54 G0 X1. Y1. Z1.\nG1 X2. F900\n"
    offset = ["--offset", "G54=X200,Y150,Z100"]
    report = tmp_path / "r.json"
    found = []
    for touched in ((), ("--touched-off", "G54")):
        assert command(tmp_path, program, *offset, *touched, "--report", str(report)) == 0
        reliance = json.loads(report.read_text())["reliance"]
        found.append((reliance["uncertainty"]["datum"], reliance["uncertainty"]["correction_rms"]))
        assert ("displace this tool point by" in capsys.readouterr().out.split("note: ")[-1]) <= (not touched)
    assert [name for name, _ in found] == ["home", "the datum of G54"]
    assert found[1][1] <= 1e-3


def test_with_effects_the_datum_stays_the_same(bench: Bench) -> None:
    """Play is taken up as without a datum; all words lie off by what the errors displace the probe by at the zero."""
    effects = {Effect(kind="backlash", component="EXX"): {"width": -0.01}}
    machine = extended(coefficients(), SQUARENESS, effects)
    program = "G21 G90 G54\nG0 X10. Y20. Z5.\nG1 X60. F400\nX20.\nY50.\n"
    found, take_ups = [], []
    for option in ((), (TouchedOff(system="G54"),)):
        found.append(words(bench.run(program, machine, offsets=KNOWN, touched_off=option)))
        take_ups.append(bench.report.take_ups)
    assert take_ups[0] == take_ups[1] > 0
    plain, touched = found
    at = np.array([[value] for value in G54.values()])
    datum = machine.correction(at, -machine.deviation(at, np.zeros((3, 1))))[:, 0]
    for before, after in zip(plain, touched, strict=True):
        for axis, value in zip("XYZ", datum, strict=True):
            if axis in before and axis in after:
                assert before[axis] - after[axis] == pytest.approx(value, abs=0.0011)
