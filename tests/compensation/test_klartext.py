"""Heidenhain Klartext: what is written does on a Heidenhain control what the source means on an error-free machine."""

import re
import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests.compensation.analytic_machine import XyzMachine, paper_sized
from tests.compensation.control import without_mark
from tests.compensation.klartext_control import KlartextControl
from tests.compensation.path_distance import apart, sampled
from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.nc.g_codes import ROUNDS
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.report import CompensationReport
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.tools import Tool, ToolTable
from trueaxis.io.faults import Fault, InputError

PRESET = (300.0, -200.0, 100.0)
LENGTHS = {1: 60.0, 5: 81.5}
OFFSETS = Offsets({"G54": {axis: (value, value) for axis, value in zip("XYZ", PRESET, strict=True)}}, {}, "G54")
TOOLS = ToolTable({tool: Tool(length=length) for tool, length in LENGTHS.items()})
ALONG = 0.0015  # mm: half a word in each axis, and the height of a chord
OF_RADIUS = 0.0001  # mm: what a radius in words of 1 um adds on circles of 7 um, which random programs have
MACHINE = paper_sized()
PROGRAM = """\
0 BEGIN PGM T MM
1 BLK FORM 0.1 Z X+0 Y+0 Z-20
2 BLK FORM 0.2 X+100 Y+100 Z+0
3 * - contour
4 TOOL CALL 5 Z S3000 DL+0
4 TOOL DEF 5 L+81.5 R+3
5 CYCL DEF 7.0 DATUM SHIFT
6 CYCL DEF 7.1 X+10
9 CYCL DEF 7.2 IY-5
10 L X+10 Y-5 Z+50 R0 FMAX M3
11 L Z-2 F300 M8 ; down
12 L X+10.5 F500
13 CC X+20.5 Y-5
14 C X+30.5 Y-5 DR-
15 C DR+ F400
16 CR X+40 Y-5 R+7 DR+
17 CR X+45 Y-5 R-4 DR- M9
18 L IX+5 IY-2.5 IZ+1
19 CC IX+4 IY+0
20 CP IPA+720 IZ-3 DR+
21 LP PR+8 PA+90
22 CP PA+10 DR-
23 CYCL DEF 32.0 TOLERANCE~
   Q1=0
24 L Z+50 R0 FMAX
25 L Z+299 FMAX M91
26 M30
27 L X+1
28 END PGM T MM
"""


def compensated(tmp_path: Path, text: str, machine: XyzMachine = MACHINE, **more: object) -> str:
    source, out = tmp_path / "in.h", tmp_path / "out.h"
    source.write_bytes(text.encode("latin-1"))
    compensate_file(source, out, machine, Settings(offsets=OFFSETS, tools=TOOLS, **more), name="in.h")  # type: ignore[arg-type]
    return out.read_bytes().decode("latin-1")


def control(text: str) -> KlartextControl:
    return KlartextControl([0.0, 0.0, 0.0], PRESET, LENGTHS).run(text)


def largest_error(source: str, written: str, machine: XyzMachine = MACHINE) -> tuple[float, float]:
    """Largest distance from the path that is meant, with the machine's errors: as programmed, as written."""
    meant, done = control(source), control(written)
    assert len(meant.runs) == len(done.runs)
    assert len(meant.rapids) == len(done.rapids)
    before = after = 0.0
    point = np.array([[0.0], [0.0], [-meant.length]])
    for a, b in zip(meant.paths(), done.paths(), strict=True):
        a, b = sampled(a, 0.3, least=16), sampled(b, 0.3, least=16)  # noqa: PLW2901
        path = machine.ideal(a, point)
        before = max(before, apart(machine.actual(a, point), path))
        after = max(after, apart(machine.actual(b, point), path))
    return before, after


def test_a_program_of_every_path_function_is_right_along_the_path(tmp_path: Path) -> None:
    written = compensated(tmp_path, PROGRAM)
    before, after = largest_error(PROGRAM, written)
    assert before > 0.01
    assert after < ALONG
    numbers = control(written).numbers
    assert numbers == sorted(set(numbers))
    assert "\n1 ; TRUEAXIS COMPENSATED\n" in written
    assert re.search(r"\n\d+ L [-XYZ .\d]+ F300 M8 ; down\n", written)
    assert written.count(" M9\n") == 1
    assert "L X+1\n" in written  # after the end, as it was


def test_without_errors_lines_stay_as_they_are(tmp_path: Path) -> None:
    source = "BEGIN PGM T MM\nTOOL CALL 5 Z S100\nL X+10 Y+20. Z+5 R0 FMAX\nL X+10.5 F100\nL Z-1.25 M9\nEND PGM T MM\n"
    written = compensated(tmp_path, source, XyzMachine())
    assert without_mark(written.encode()) == source.encode()


def test_inches(tmp_path: Path) -> None:
    source = (
        "0 BEGIN PGM T INCH\n1 TOOL CALL 5 Z S100\n2 L X+1 Y+2 Z+1 FMAX\n3 L Z-0.1 F50\n4 CC X+2 Y+2\n"
        "5 C X+3 Y+2 DR+\n6 END PGM T INCH\n"
    )
    before, after = largest_error(source, compensated(tmp_path, source))
    assert after < ALONG < before


HEAD = "BEGIN PGM T MM\nTOOL CALL 5 Z S100\nL X+0 Y+0 Z+10 R0 FMAX\n"


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("L X+1 RL F100", "RL compensates the cutter's radius"),
        ("L X+Q1 F100", "'X+Q1 F100' is no word"),
        ("L X+1 FQ2", "is no word"),
        ("FN 0: Q1 = 5", "is a parameter"),
        ("Q1 = 5", "is a parameter"),
        ("CALL LBL 1 REP 3", "calls a part of the program"),
        ("CALL PGM 12", "calls a program"),
        ("CYCL CALL M3", "calls a cycle"),
        ("L X+5 FMAX M99", "M99 calls the cycle that is defined before"),
        ("RND R2", "rounds a corner"),
        ("CHF 2", "bevels a corner"),
        ("CT X+10 Y+10", "is a path by its tangent or normal"),
        ("APPR LT X+10 Y+10 LEN10", "approaches or leaves"),
        ("FL AN+0 LEN20", "free contour"),
        ("PLANE SPATIAL SPA+45 SPB+0 SPC+0 STAY", "tilts the plane"),
        ("FUNCTION TCPM F TCP AXIS POS", "moves the linear axes with the rotary ones"),
        ("L A+5 F100", "this machine has no axis A"),
        ("L X+5 M128", "no rotary axis"),
        ("CYCL DEF 10.1 ROT+35", "turns the coordinates"),
        ("CYCL DEF 8.1 X", "mirrors"),
        ("CYCL DEF 11.1 SCL 0.5", "scales"),
        ("CYCL DEF 7.1 #5", "takes a shift from a table"),
        ("CYCL DEF 220 POLAR PATTERN", "calls a cycle at the points of a pattern"),
        ("CYCL DEF 210 SLOT RECIP.PLNG", "is a cycle, which is not followed"),
        ("TOOL CALL 5 Z S100 DL+0.5", "DL changes the length"),
        ("TOOL CALL 5 X S100", "the tool axis X"),
        ("TOOL CALL 77 Z S100", "tool 77 is not in --tools"),
        ("TOOL CALL \"MILL\" Z S100", 'no tool in --tools has the name "MILL"'),
        ("L X+1,5 F100", "a decimal comma"),
        ("M140", "retracts along the tool axis"),
        ("L X+5 M140 MB MAX", "M140 and a position in one block"),
        ("TOOL DEF 5 L+50 R+3", "gives tool 5 the length 50 mm, and --tools says 81.5"),
        ("TOOL DEF 7 L+50 R+3", "--tools has no such tool"),
        ("TOOL DEF 5 LQ1 R+3", "gives tool data"),
        ("C X+10 Y+10 DR+", "without a pole"),
        ("CR X+100 Y+0 R+20 DR+", "more than 2 R"),
        ("CC X+5 Y+0\nC X+11 Y+0 DR+", "different radii"),
        ("CC X+5 Y+0\nCP IPA+90 DR-", "differ in sign"),
        ("CC X+5 Y+0\nC X+10 Y+0", "without DR+ or DR-"),
        ("CYCL DEF 247 DATUM SETTING~\nQ339=1\nCYCL DEF 247 DATUM SETTING~\nQ339=2", "preset 2 after preset 1"),
        ("GOTO 5", "is not known"),
        ("/L X+5", "depends on a switch"),
        ("L X+5 Y+5 X+6", "X occurs twice"),
        ("L X+2000 F100", "outside its travel"),
    ],
)  # fmt: skip
def test_what_is_not_followed_is_named_with_its_line(tmp_path: Path, line: str, words: str) -> None:
    with pytest.raises(InputError) as caught:
        compensated(tmp_path, HEAD + line + "\nEND PGM T MM\n")
    assert any(words in fault.problem for fault in caught.value.faults), [f.problem for f in caught.value.faults]
    assert all(int(fault.place.removeprefix("line ")) >= 4 for fault in caught.value.faults)


def test_increments_need_a_certain_place(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="counts from where X stands"):
        compensated(tmp_path, "BEGIN PGM T MM\nTOOL CALL 5 Z S1\nL IX+5 F100\nEND PGM T MM\n", start={"X": 0.0})


def test_without_tools_a_call_is_a_fault(tmp_path: Path) -> None:
    source = tmp_path / "in.h"
    source.write_text(HEAD)
    with pytest.raises(InputError, match="TOOL CALL shifts positions by a tool value"):
        compensate_file(source, tmp_path / "out.h", MACHINE, Settings())


def test_retracting_loses_the_position(tmp_path: Path) -> None:
    for retract in ("L M140 MB MAX", "M140 MB MAX", "M140 MB+50 FMAX", "L M140 MB 50 F5000"):
        source = f"{HEAD}{retract}\nL X+50 FMAX\nL Z+20 FMAX\nL X+60 F100\nEND PGM T MM\n"
        written = compensated(tmp_path, source)
        lines = written.splitlines()
        at = lines.index(retract)
        assert "Z" not in lines[at + 1]  # where it stands is the control's to know
        assert "Z" in lines[at + 2]
        with pytest.raises(InputError, match="the position of Z is not known"):
            compensated(tmp_path, f"{HEAD}{retract}\nL X+50 F100\nEND PGM T MM\n")


def notes_of(tmp_path: Path, text: str) -> list[str]:
    """The notes of a program with these blocks behind its head."""
    (tmp_path / "in.h").write_text(f"{HEAD}{text}END PGM T MM\n")
    report = compensate_file(tmp_path / "in.h", tmp_path / "out.h", MACHINE, Settings(offsets=OFFSETS, tools=TOOLS))
    return list(report.notes)


def test_a_path_tolerance_of_the_control_is_noted_once(tmp_path: Path) -> None:
    cycle = "CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.05\nCYCL DEF 32.2 HSC-MODE:0 TA0.5\n"
    found = [note for note in notes_of(tmp_path, f"L X+50 F100\n{cycle}L X+60\n") if "tolerance" in note]
    assert found == [f"line {HEAD.count(chr(10)) + 2}: CYCL DEF 32 (tolerance): {ROUNDS}"]


def test_a_feed_motion_without_a_feed_is_noted(tmp_path: Path) -> None:
    first = HEAD.count("\n") + 1
    for blocks, line in (
        ("L X+50\nL X+60\n", first), ("L X+50 FMAX\nCR X+60 Y+0 R+40 DR+\n", first + 1), ("L X+50 F100\nL X+60\n", 0),
        ("L X+50 FAUTO\nL X+60\n", 0), ("L X+50 F AUTO\n", 0), ("L X+50 FMAX\nL X+60 FMAX\n", 0),
    ):  # fmt: skip
        found = [note.partition(":")[0] for note in notes_of(tmp_path, blocks) if "no F above 0" in note]
        assert found == ([f"line {line}"] if line else []), blocks


def test_a_tool_by_its_name_is_that_of_its_number(tmp_path: Path) -> None:
    named = ToolTable({5: Tool(length=LENGTHS[5])}, {"MILL 10": 5})
    source = HEAD + "L X+50 F100\nEND PGM T MM\n"
    by_number = compensated(tmp_path, source)
    (tmp_path / "in.h").write_text(source.replace("TOOL CALL 5", 'TOOL CALL "MILL 10"'))
    compensate_file(tmp_path / "in.h", tmp_path / "out.h", MACHINE, Settings(offsets=OFFSETS, tools=named))
    by_name = (tmp_path / "out.h").read_text()
    assert by_name.replace('"MILL 10"', "5") == by_number


NUMBERS = st.integers(-20000, 20000).map(lambda n: f"{n / 1000:+.3f}")
BLOCKS = st.one_of(
    st.tuples(
        st.sampled_from(["", "I"]), NUMBERS, NUMBERS, st.sampled_from(["", " FMAX", " F300", " M8", " R0 F200 M9"])
    ).map(lambda t: f"L {t[0]}X{t[1]} {t[0]}Y{t[2]}{t[3]}"),
    st.tuples(st.sampled_from(["", "I"]), NUMBERS).map(lambda t: f"L {t[0]}Z{t[1]} F100"),
    st.tuples(NUMBERS, NUMBERS, st.integers(-350, 350).filter(bool), st.integers(-3000, 3000)).map(
        lambda t: f"CC IX{t[0]} IY{t[1]}\nCP IPA{t[2]:+d} IZ{t[3] / 1000:+.3f} DR{'+' if t[2] > 0 else '-'}"),
    st.tuples(NUMBERS, NUMBERS, st.sampled_from("+-")).map(lambda t: f"CC IX{t[0]} IY{t[1]}\nC DR{t[2]}"),
    st.tuples(NUMBERS, NUMBERS, st.sampled_from("+-"), st.sampled_from("+-")).map(
        lambda t: f"CR IX{t[0]} IY{t[1]} R{t[2]}40 DR{t[3]}"),
    st.tuples(NUMBERS, st.integers(1, 30), st.integers(-180, 180)).map(
        lambda t: f"CC X{t[0]} Y+0\nLP PR+{t[1]} PA{t[2]:+d} F200"),
    st.tuples(st.sampled_from("XYZ"), NUMBERS).map(lambda t: f"CYCL DEF 7.1 I{t[0]}{t[1]}\nL X+0 Y+0 Z+5 FMAX"),
    st.sampled_from(["STOP\nL X+0 Y+0 Z+3 FMAX", "* - text", "TOOL CALL 5 Z S1\nL X+1 Y+1 Z+20 FMAX", "; c", "M5"]),
)  # fmt: skip


@settings(max_examples=25, deadline=None)
@given(st.lists(BLOCKS, min_size=1, max_size=8))
@example(["CR IX-0.014 IY+0.001 R+40 DR+", "CC IX+0.007 IY+0.000\nC DR+"])  # a circle about the middle of a line
@example(["CR IX+0.000 IY-0.030 R+40 DR+", "CC IX+0.000 IY+0.007\nC DR+"])
def test_random_programs_are_right_or_refused(blocks: list[str]) -> None:
    source = HEAD + "\n".join(blocks) + "\nEND PGM T MM\n"
    with tempfile.TemporaryDirectory() as folder:
        try:
            written = compensated(Path(folder), source)
        except InputError as error:
            for fault in error.faults:
                assert re.search("radii|apart|radius 0|coincide|travel|not certain", fault.problem), fault
            return
    assert largest_error(source, written)[1] < ALONG + OF_RADIUS


TOKENS = st.sampled_from([
    "L", "C", "CC", "CR", "CP", "X+5", "IY-3", "Z", "R0", "RL", "FMAX", "F100", "M3", "M91", "M30", "DR+", "R+5", "~",
    ";", "1 ", "Q1", "IPA+90", "\n", " ", "+", "END PGM T MM", "TOOL CALL 1 Z", "CYCL DEF 7.1 X+5", "STOP", "LBL 1",
    "\x00",
])  # fmt: skip


@settings(max_examples=80, deadline=None)
@given(st.lists(st.tuples(st.floats(0, 1), st.integers(0, 5), TOKENS), max_size=5))
def test_mutated_programs_are_right_or_refused(mutations: list[tuple[float, int, str]]) -> None:
    text = PROGRAM
    for share, removed, inserted in mutations:
        place = len("0 BEGIN PGM T MM\n") + int(share * (len(text) - 20))
        text = text[:place] + inserted + text[place + removed :]
    with tempfile.TemporaryDirectory() as folder:
        source, out = Path(folder) / "in.h", Path(folder) / "out.h"
        source.write_bytes(text.encode("latin-1"))
        faults: tuple[Fault, ...] = ()
        report: CompensationReport | None
        try:
            report = compensate_file(source, out, MACHINE, Settings(offsets=OFFSETS, tools=TOOLS))
        except InputError as error:
            faults, report = error.faults, None
        assert all(fault.problem and fault.place.startswith("line ") for fault in faults[:40])
        assert out.exists() == (report is not None)
        # a feed motion that starts where axes had no word is right at its end alone, and the report says so
        if report is not None and report.good and not any("gets no word" in note for note in report.notes):
            assert largest_error(text, out.read_text("latin-1"))[1] < ALONG


@pytest.mark.parametrize(
    "block", ["{} L X+1", "7 L X+{}", "7 L M{}", "7 TOOL CALL {} Z", "7 CYCL DEF 7.1 X+{}", "7 CR X+5 R+{}"]
)
def test_a_number_of_no_machine_is_a_fault(tmp_path: Path, block: str) -> None:
    source = tmp_path / "in.h"
    source.write_text(f"0 BEGIN PGM A MM\n{block.format('9' * 5000)}\n9 END PGM A MM\n")
    with pytest.raises(InputError, match="no machine's number"):
        compensate_file(source, tmp_path / "out.h", MACHINE, Settings(dialect="heidenhain"))


def test_a_call_of_the_tool_in_the_spindle_changes_no_tool(tmp_path: Path) -> None:
    """With another speed it was taken for a change, behind which no axis got a word."""
    moves = "L X+10 Y+10 Z+50 FMAX\nTOOL CALL 5 Z S500\nL X+20 FMAX\nL Z+5 F100\nEND PGM T MM\n"
    for first, waits in ((5, 0), (1, 2)):
        (tmp_path / "in.h").write_text(f"BEGIN PGM T MM\nTOOL CALL {first} Z S3000\n{moves}")
        given = Settings(offsets=OFFSETS, tools=TOOLS)
        report = compensate_file(tmp_path / "in.h", tmp_path / "out.h", MACHINE, given)
        assert report.uncommanded.points == waits
