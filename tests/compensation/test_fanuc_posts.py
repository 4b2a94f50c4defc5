"""What posts for Fanuc controls write: G80 before a position, looking ahead, tapping, K0, parking at machine zero."""

import json
import re

import numpy as np
import pytest

from tests.compensation.analytic_machine import FloatArray, XyzMachine, paper_sized
from tests.compensation.control import Bench
from trueaxis.compensation.offsets import Offsets
from trueaxis.io.faults import InputError

ZERO = {"X": 300.0, "Y": 200.0, "Z": -100.0}
G54 = Offsets({"G54": {axis: (value, value) for axis, value in ZERO.items()}})
ORIGIN = np.zeros((3, 1))
HEAD = "G21 G90 G54\nG0 X0. Y0. Z15.\n"


def off(machine: XyzMachine, at: dict[str, float], wanted: dict[str, float]) -> FloatArray:
    """Error of the tool at words of G54, mm."""
    got, ideal = (np.array([[one[axis] + ZERO[axis]] for axis in "XYZ"]) for one in (at, wanted))
    return np.asarray(machine.actual(got, ORIGIN) - machine.ideal(ideal, ORIGIN))[:, 0]


def words(line: str) -> dict[str, float]:
    return {letter: float(value) for letter, value in re.findall(r"([XYZR])([-+]?[\d.]+)", line)}


@pytest.mark.parametrize("code", ["G84", "G74", "G76", "G84.2", "G84.3"])
def test_a_tapping_cycle_stays_one_at_corrected_words(bench: Bench, code: str) -> None:
    machine = paper_sized(3.0)
    source = f"{HEAD}M29 S500\nG98 {code} X10. Y20. Z-30. R2. P200 F100\nX50.\nG99 Y60. Z-12.\nG80\nZ40.\n"
    text = bench.run(source, machine, offsets=G54, dialect="fanuc").decode()
    lines = text.splitlines()
    assert lines[2] == "M29 S500"
    assert re.fullmatch(rf"G98 {re.escape(code)} X[-.\d]+ Y[-.\d]+ Z[-.\d]+ R[-.\d]+ P200 F100", lines[3])
    holes = [(10.0, 20.0, -30.0), (50.0, 20.0, -30.0), (50.0, 60.0, -12.0)]
    ends = []
    for line, (x, y, z) in zip(lines[3:6], holes, strict=True):
        found = words(line)
        middle = 0.5 * (found["Z"] + found["R"])
        error = off(machine, {**found, "Z": middle}, {"X": x, "Y": y, "Z": 0.5 * (z + 2.0)})
        assert np.abs(error[:2]).max() <= 0.0006  # X and Y at the middle
        for letter, depth in (("Z", z), ("R", 2.0)):
            error = off(machine, {**found, "Z": found[letter]}, {"X": x, "Y": y, "Z": depth})
            assert abs(error[2]) <= 0.0006
            ends.append(float(np.linalg.norm(error)))
    assert bench.report.kept_holes is not None
    assert bench.report.kept_holes.count == 3
    assert bench.report.kept_holes.largest == pytest.approx(max(ends), abs=1e-6)
    assert max(ends) > 0.002  # what one X and Y for the whole depth leaves here: stated, and no fault of the words
    assert bench.report.good
    assert f"{bench.report.kept_holes.largest:.4f} mm at most at an end" in bench.told
    # after G99 Z stands at R of the last hole, as written; Z40. is a rapid again, and not by way of a cycle
    assert lines[6] == "G80"
    assert lines[7].startswith("G0 ")


def test_the_level_of_a_tapping_cycle_is_that_of_the_control(bench: Bench) -> None:
    """G98 takes the control back to where Z stood when the cycle began in what it reads, not in the source."""
    source = f"{HEAD}G99 G81 X1. Y2. Z-5. R2. F100\nG84 X5. Z-9. F1.\nG98 X9.\n"
    with pytest.raises(InputError, match="line 5: G84 goes back to where another cycle began; G80 before it, and Z"):
        bench.run(source, offsets=G54, dialect="fanuc")
    assert bench.run(source.replace("G98 X9.", "X9."), offsets=G54, dialect="fanuc")


def places(text: str) -> list[dict[str, float]]:
    """Where the axes are after each block, in the words' own frame; G28 and cycles are not followed."""
    at, found, absolute = dict.fromkeys("XYZ", 0.0), [], True
    for line in text.splitlines():
        absolute = {"G90": True, "G91": False}.get((re.findall("G9[01](?![0-9.])", line) or [""])[-1], absolute)
        for axis, value in re.findall(r"([XYZ])([-+]?[\d.]+)", line):
            at[axis] = float(value) + (0.0 if absolute else at[axis])
        found.append({axis: round(value, 6) for axis, value in at.items()})
    return [one for one, before in zip(found[1:], found, strict=False) if one != before]


@pytest.mark.parametrize("level", ["G98", "G99"])
@pytest.mark.parametrize("code", ["G81", "G83 Q3."])
def test_a_row_of_holes_by_increments_keeps_its_depth(bench: Bench, level: str, code: str) -> None:
    """Z and R of before G91 are the places that they were: the row of holes of Fanuc's and Haas's manuals."""
    head, tail = f"{HEAD}{level} {code} X10. Y10. Z-8. R2. F150\n", "G80\nG90 G0 Z50.\n"
    row = bench.run(f"{head}G91 X20. K3\nY5.\n{tail}", XyzMachine(), offsets=G54, dialect="fanuc").decode()
    each = bench.run(f"{head}X30.\nX50.\nX70.\nX70. Y15.\n{tail}", XyzMachine(), offsets=G54, dialect="fanuc").decode()
    assert places(row) == places(each)
    assert min(one["Z"] for one in places(row)) == -8.0
    for wrong in ("G91 X20. Z-9. K3", "G20 X1."):
        with pytest.raises(InputError, match="without Z and R"):
            bench.run(f"{head}{wrong}\n{tail}", offsets=G54, dialect="fanuc")
    with pytest.raises(InputError, match=r"without Z and R; give both where .* differ there; --dialect fanuc says"):
        bench.run(f"{head}G91 X20. K3\n{tail}", offsets=G54, dialect=None)


def test_the_largest_speed_of_the_spindle_is_no_work_offset(bench: Bench) -> None:
    lines = bench.run(f"{HEAD}G92 S3000\nG92S250\nX5.\n", offsets=G54, dialect="fanuc").decode().splitlines()
    assert lines[2:4] == ["G92 S3000", "G92S250"]
    for block, dialect in (("G92 S3000", None), ("G92", "fanuc"), ("G92 S3000 F5.", "fanuc")):
        with pytest.raises(InputError, match="G92 without axis words"):
            bench.run(f"{HEAD}{block}\nX5.\n", offsets=G54, dialect=dialect)


def levels(text: str) -> list[str]:
    """Of G98 and G99 the one that is in force at each hole of G84: neither G80 nor another cycle changes it."""
    found, level, tapping = [], "G98", False
    for line in text.splitlines():
        codes = re.findall(r"G\d+", line)
        level = next((code for code in codes if code in ("G98", "G99")), level)
        tapping = "G84" in codes or (tapping and not {"G80", "G0", "G1", "G81", "G83"} & set(codes))
        if tapping and re.search("[XY]", line):
            found.append(level)
    return found


@pytest.mark.parametrize("seed", range(8))
def test_the_control_is_left_with_the_level_that_the_program_has(bench: Bench, seed: int) -> None:
    """G98 and G99 of cycles that are written out hold for those that stay: the tool would be elsewhere after them."""
    draw = np.random.default_rng(seed)
    source = HEAD + str(draw.choice(["", "G99\n", "G98\n"]))
    for x in range(0, 120, 10):
        level, code = draw.choice(["", "G98 ", "G99 "]), draw.choice(["G81", "G83", "G84"])
        source += f"{level}{code} X{x}. Y9. Z-8. R5. {'Q3. ' * (code == 'G83')}F300.\nX{x + 4}.\nG80\nG0 Z50.\n"
    written = bench.run(source, offsets=G54, dialect="fanuc").decode()
    assert levels(source)
    assert levels(written) == levels(source)


@pytest.mark.parametrize(
    ("blocks", "problem"),
    [
        ("G82 X1. Y1. Z-9. R2. P500 F100\nG84 X5.", "line 4: G84 after a cycle with P or Q, still in force"),
        ("G83 X1. Y1. Z-9. R2. Q3. F100\nX3.\nG76 X5. P200", "line 5: G76 after a cycle with P or Q"),
        ("G82 X1. Y1. Z-9. R2. P500 F100\nG89 X5.", "line 4: G89 after a cycle with P, still in force"),
        ("G82 X1. Y1. Z-9. R2. P500 F100\nG84 X5. P0", ""),
        ("G83 X1. Y1. Z-9. R2. Q3. F100\nG81 X5.", ""),
        ("G82 X1. Y1. Z-9. R2. P500 F100\nG80\nG84 X5. Y1. Z-9. R2.", ""),
        ("G84 X1. Y1. Z-9. R2. P500 F100\nG74 X5.", ""),
    ],
)
def test_a_dwell_or_peck_that_is_still_in_force_is_not_lost(bench: Bench, blocks: str, problem: str) -> None:
    """P and Q of cycles that are written out are no longer in the program, where Fanuc's control has them until G80."""
    if not problem:
        assert bench.run(f"{HEAD}{blocks}\n", offsets=G54, dialect="fanuc")
        return
    with pytest.raises(InputError, match=problem):
        bench.run(f"{HEAD}{blocks}\n", offsets=G54, dialect="fanuc")


@pytest.mark.parametrize(
    ("blocks", "problem"),
    [
        ("G84 X1. Y1. Z-9. R2. K3", "line 3: G84 with repeats; a block for each hole"),
        ("G91 G84 X1. Y1. Z-9. R2.", "line 3: G84 under G91"),
        ("G18 G84 X1. Y-9. Z1. R2.", "line 3: G84 in another plane than G17"),
        ("G84 X1. Y1. Z-9. R2. I1.", "line 3: I or J in a block of G84"),
        ("G84 X1. Y1. Z-9.", "line 3: G84 without Z and R"),
        ("G84 X1. Y1. Z-2000. R2.", "line 3: Z = -2100 is outside its travel"),
        (
            "M98 P1000",
            "line 3: M98 calls, ends or repeats a subprogram, .* write the blocks of the subprogram in place",
        ),
    ],
)
def test_what_is_not_followed(bench: Bench, blocks: str, problem: str) -> None:
    with pytest.raises(InputError, match=problem):
        bench.run(f"{HEAD}{blocks}\n", offsets=G54, dialect="fanuc")


def test_without_the_control_tapping_is_refused(bench: Bench) -> None:
    with pytest.raises(InputError, match="line 3: G84 is a canned cycle"):
        bench.run(f"{HEAD}G84 X1. Y1. Z-9. R2.\n", offsets=G54)


@pytest.mark.parametrize(("before", "code"), [("G0 X1. Y1. Z15.", "G0"), ("G1 X1. Y1. Z15. F99", "G1")])
def test_g80_leaves_the_motion_that_was_before_the_cycle(bench: Bench, before: str, code: str) -> None:
    """On Fanuc G80 is of group 09 and G0 and G1 of group 01; elsewhere no motion is in force."""
    source = f"{HEAD}{before}\nG81 X5. Y5. Z-3. R2. F100\nG80\nX8.\n"
    lines = bench.run(source, offsets=G54, dialect="fanuc").decode().splitlines()
    assert lines[-2:] == ["G80", f"{code} X8.000"]
    for dialect in (None, "linuxcnc"):
        with pytest.raises(InputError, match="line 6: a position, but no motion"):
            bench.run(source, offsets=G54, dialect=dialect)
    with pytest.raises(InputError, match="line 6: a position, but no motion"):
        bench.run(source.replace(before, "G2 X2. Y0. I1. J0. F99"), offsets=G54, dialect="fanuc")


def test_k0_stores_the_words_of_a_cycle(bench: Bench) -> None:
    machine = paper_sized(3.0)
    stored = bench.run(f"{HEAD}G81 Z-5. R2. K0 F100\nX1. Y1.\nX9.\n", machine, offsets=G54, dialect="fanuc")
    at_once = bench.run(f"{HEAD}G81 X1. Y1. Z-5. R2. F100\nX9.\n", machine, offsets=G54, dialect="fanuc")
    assert stored.replace(b"\nF100\n", b"\n").decode() == at_once.decode().replace("F100 ", "")
    tapped = bench.run(f"{HEAD}G84 Z-5. R2. L0 F1.\nX1. Y1.\n", machine, offsets=G54, dialect="fanuc").decode()
    assert "\nG84 Z-5. R2. L0 F1.\nX" in tapped
    with pytest.raises(InputError, match="no number of repeats"):
        bench.run(f"{HEAD}G81 X1. Y1. Z-5. R2. L0 F100\n", offsets=G54)
    with pytest.raises(InputError, match="line 4: the position of X is not known here"):  # X5. may be gone to, or not
        bench.run(f"{HEAD}G81 X5. Z-5. R2. K0 F100\nY1.\n", offsets=G54, dialect="fanuc")


def test_looking_ahead_passes_with_a_note(bench: Bench) -> None:
    source = f"G5.1 Q1 R5\n{HEAD}G05 P10000\nG1 X5. F100\nG05 P0\nG08 P1\nG5.1 Q0\n"
    text = bench.run(source, offsets=G54, dialect="fanuc").decode()
    assert [line for line in text.splitlines() if line.startswith(("G5", "G0 5", "G05", "G08"))] == [
        "G5.1 Q1 R5", "G05 P10000", "G05 P0", "G08 P1", "G5.1 Q0",
    ]  # fmt: skip
    assert sum("the control may round the path" in note for note in bench.report.notes) == 3
    for wrong in ("G5 P3", "G5", "G5.1 Q1 X0.", "G8 P1 X4.", "G5.1 Q1 X5 R5", "G5.1 Q1 E2"):
        with pytest.raises(InputError, match="line 1"):
            bench.run(f"{wrong}\n{HEAD}", offsets=G54, dialect="fanuc")
    with pytest.raises(InputError, match=r"line 1: G5\.1 is a curve"):
        bench.run(f"G5.1 Q1\n{HEAD}", offsets=G54, dialect="linuxcnc")


class AtTheEnd(XyzMachine):
    """A machine whose home is at the end of its travel, as that of most machining centres."""

    def __init__(self) -> None:
        low = dict.fromkeys("XYZ", (-600.0, 0.0))
        super().__init__({**paper_sized(3.0).curves, "EZX": lambda x: 1e-4 * x}, travel=low)


PARKED = "G21 G90 G54\nG0 X-290. Y-190. Z-80.\nG1 Z-95. F100\nX-250.\n{end}\nM30\n"
AT = Offsets({"G54": dict.fromkeys("XYZ", (0.0, 0.0))})


def test_parking_at_machine_zero_is_no_failure(bench: Bench) -> None:
    text = bench.run(PARKED.format(end="G53 G0 Z0."), AtTheEnd(), offsets=AT).decode()
    assert re.search(r"\nG53 G0 .*Z0\.000\n", text)  # the word would be above 0
    report = bench.report
    assert report.good
    assert (report.parked_at_end.points, report.out_of_travel.points, report.over_tolerance.points) == (1, 0, 0)
    assert report.after is not None
    assert report.after.largest <= 0.001
    assert "note: rapids in machine coordinates (G53) stop at the end of travel: 1 points, lines 5" in bench.told
    # a cut there, or a rapid of the part's own frame, counts as before
    for end in ("G53 G1 Z0. F100", "G0 Z0."):
        bench.run(PARKED.format(end=end), AtTheEnd(), offsets=AT)
        assert not bench.report.good
        assert bench.report.out_of_travel.points == 1
        assert "not good, exit code 1: points above the tolerance, points out of travel" in bench.told


def test_the_sign_check_is_at_a_cut(bench: Bench) -> None:
    """Neither a word that stops at the end of travel nor a parking place tells whether the sign is right."""
    bench.run(PARKED.format(end="G53 G0 X-600. Y-600. Z0."), AtTheEnd(), offsets=AT)
    check = bench.report.sign_check
    assert check is not None
    assert check.line in (3, 4)
    assert check.correction == pytest.approx(-check.deviation, abs=0.0011)


def test_an_offset_without_an_axis_is_a_fault(bench: Bench) -> None:
    part = Offsets({"G54": {"X": (1.0, 1.0), "Y": (2.0, 2.0)}})
    with pytest.raises(InputError, match=r"line 2: G54 has no value of Z: .*; say --offset G54=Z\.\. too") as error:
        bench.run("G21 G90\nG54 G0 X1. Y1. Z1.\nX9999.\n", offsets=part)
    assert len(error.value.faults) == 1
    with pytest.raises(InputError, match=r"line 3: G55 has no value of Y Z"):
        bench.run("G21 G90\nG10 L2 P2 X1.\nG55 G0 X1. Y1. Z1.\n", offsets=part)
    assert bench.run("G21 G90\nG10 L2 P1 Z1.\nG54 G0 X1. Y1. Z1.\n", offsets=part)
    assert bench.run("G21 G90\nG55\nG0 X1. Y1. Z1.\n", offsets=Offsets({**G54.systems, "G55": G54.systems["G54"]}))


def test_a_program_that_moves_nothing_is_not_good(bench: Bench) -> None:
    bench.run("G21 G90\nM30\n")
    assert not bench.report.good
    assert "not good, exit code 1: nothing in the program moves an axis" in bench.told
    bench.run("G21 G90\nG91 G28 Z0.\nM30\n")
    assert bench.report.good


def test_words_in_inch_have_the_decimals_that_the_control_reads(bench: Bench) -> None:
    """Least increments of 0.0001 inch on Fanuc (IS-B), where more decimals are lost."""
    cuts = "".join(f"X{n / 7:.4f} Y{n / 11:.4f} Z{n / 13:.4f}\n" for n in range(9, 30))
    source = f"G20 G90 G54\nG0 X1. Y1. Z0.\nG1 X2. F9.\n{cuts}"
    for dialect, step, decimals in (("fanuc", None, 4), ("linuxcnc", None, 5), ("fanuc", 0.00001, 5)):
        text = bench.run(source, paper_sized(3.0), dialect=dialect, offsets=G54, inch_resolution=step).decode()
        assert {len(found) for found in re.findall(r"[XYZ]-?\d+\.(\d+)", text)} == {decimals}
    bench.run(source, paper_sized(3.0), dialect="fanuc", offsets=G54, tolerance=0.001)
    assert "words of 0.0001 inch are up to 2.2 um off, more than the tolerance" in bench.told
    assert "a finer --inch-resolution where the control reads it, or --tolerance 0.0022" in " ".join(bench.told.split())
    assert not bench.report.good


INCHES = "".join(f"X{n / 7:.4f} Y{n / 11:.4f} Z{n / 13:.4f}\n" for n in range(9, 60))


def test_the_tolerance_is_one_step_of_the_words_unless_it_is_stated(bench: Bench) -> None:
    """Words of 0.0001 inch are 2.2 um off by rounding, as those of 0.001 mm are 0.9 um."""
    source = f"G20 G90 G54\nG0 X1. Y1. Z0.\nG1 X2. F9.\n{INCHES}"
    bench.run(source, paper_sized(3.0), dialect="fanuc", offsets=G54)
    after = bench.report.after
    assert after is not None
    assert 0.001 < after.largest <= 0.0022  # what rounding leaves
    assert bench.report.good
    assert "resolution 0.0001 inch, tolerance 0.00254 mm" in bench.told
    assert "--inch-resolution 0.00001 is finer, where the control reads it (IS-C)" in bench.told
    assert json.loads(bench.report.to_json())["settings"]["tolerance"] == 0.00254
    bench.run(source, paper_sized(3.0), dialect="fanuc", offsets=G54, inch_resolution=0.001)
    assert not bench.report.good  # coarser words than the control's are no reason for a larger one
    bench.run(source, paper_sized(3.0), dialect="linuxcnc", offsets=G54)
    assert bench.report.good
    assert "resolution 1e-05 inch, tolerance 0.001 mm" in bench.told
    assert "IS-B" not in bench.told
    bench.run(source, paper_sized(3.0), offsets=G54)
    assert "a control that reads four (IS-B of Fanuc and the like) rounds them" in bench.told


def test_each_unit_of_a_program_has_its_tolerance(bench: Bench) -> None:
    source = f"G20 G90 G54\nG0 X1. Y1. Z0.\nG1 X2. F9.\n{INCHES}G21\n{INCHES}"
    bench.run(source, paper_sized(3.0), dialect="fanuc", offsets=G54, resolution=0.003)
    first = source[: source.index("G21")].count("\n") + 1
    assert bench.report.over_tolerance.points > 10
    assert min(bench.report.over_tolerance.first) > first


def test_arcs_of_a_program_in_inch_stay_arcs(bench: Bench) -> None:
    source = "G20 G90 G54\nG0 X2. Y1. Z1.\nG3 X0. Y3. I-2. J0. F9.\n"
    text = bench.run(source, paper_sized(3.0), dialect="fanuc", offsets=G54, arcs="keep").decode()
    assert len(re.findall("G3 X", text)) >= 1
    assert "G1" not in text


def test_an_arc_stays_one_while_z_was_never_commanded(bench: Bench) -> None:
    """Laser, plasma, water jet: Z gets no word, and the arc is one in its plane."""
    source = "G21 G90\nG0 X300. Y100.\nG1 X250. F1000.\nY200.\nG2 X260. Y210. I10. J0.\nG0 X0. Y0.\nM2\n"
    text = bench.run(source, paper_sized(3.0), arcs="keep", start={"Z": 20.0}).decode()
    assert "Z" not in text
    assert 1 <= len(re.findall(r"(?m)^G2 X", text)) <= 3
    assert len(text.splitlines()) < 12
    # every piece goes round the arc that it is to be: ends and middles, by a machine and a reader of words apart
    at, worst = np.array([250.0, 200.0]), 0.0
    machine = paper_sized(3.0)
    for line in text.splitlines():
        found = {letter: float(value) for letter, value in re.findall(r"([XYIJ])([-+]?[\d.]+)", line)}
        end = np.array([found.get("X", at[0]), found.get("Y", at[1])])
        if line.startswith("G2 "):
            centre = at + np.array([found["I"], found["J"]])
            half = (at - centre) + (end - centre)
            middle = centre + half / np.linalg.norm(half) * np.linalg.norm(at - centre)
            for x, y in (middle, end):
                tool = machine.actual(np.array([[x], [y], [20.0]]), ORIGIN)[:, 0] * [1.0, -1.0, 1.0]
                worst = max(worst, abs(float(np.linalg.norm(tool[:2] - [260.0, 200.0])) - 10.0))
        at = end
    assert 0.0 < worst <= 0.0015


@pytest.mark.parametrize("block", ["M29 S500", "G84 X10. Y20. Z-3. R2. F100", "G76 X10. Y20. Z-3. R2. Q1. F100"])
def test_without_a_dialect_the_control_that_has_it_is_named(bench: Bench, block: str) -> None:
    with pytest.raises(InputError) as error:
        bench.run(f"{HEAD}{block}\n", offsets=G54)
    assert error.value.faults[0].place == "line 3"
    assert error.value.faults[0].remedy.startswith("say --dialect fanuc if it is one; else ")
