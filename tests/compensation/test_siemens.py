"""SINUMERIK programs: what is written does on such a control what the source means on an error-free machine."""

import re
import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.compensation.analytic_machine import paper_sized
from tests.compensation.path_distance import apart, sampled
from tests.compensation.siemens_control import SiemensControl
from trueaxis.compensation.dialects import dialect_of
from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.tools import Tool, ToolTable
from trueaxis.io.faults import InputError

FRAMES = {54: (300.0, -200.0, 100.0), 55: (310.0, -150.0, 90.0)}
LENGTHS = {1: 60.0, 5: 81.5}
OFFSETS = Offsets(
    {f"G{n}": {axis: (v, v) for axis, v in zip("XYZ", values, strict=True)} for n, values in FRAMES.items()}, {}, "G54"
)
TOOLS = ToolTable({tool: Tool(length=length) for tool, length in LENGTHS.items()})
ALONG = 0.0015  # mm
MACHINE = paper_sized()
PROGRAM = """\
%_N_TEST_MPF
;$PATH=/_N_WKS_DIR/_N_TEST_WPD
N10 G17 G71 G90 G40 G60 SOFT FFWON
N20 MSG("start (G0 X5)") ; X5 Y6
N25 WORKPIECE(,"",,"BOX",112,0,-20,-80,0,0,100,80)
N30 T5 M6
N40 D1
N50 G54 G64
N55 TRANS X=10 Y20
N60 G0 X=100.5 Y=20 Z50 S3000 M3
N70 START: G0 Z=10
N80 G1 Z=-2 F=500
N85 G641 ADIS=0.05
N90 G2 X=120.5 Y=20 CR=10
N95 G3 X=IC(10) Y=AC(30) I=AC(120.5) J=AC(30)
N97 ATRANS Z5
N100 G1 X50 Y60.5 Z1
N101 G91 X5 Y=5
N102 G90
N105 G55 G1 X40 Y=30 M8
N110 SUPA G0 Z300 D0
N115 TRANS
N120 M30
"""


def compensated(folder: Path, text: str, **more: object) -> str:
    """What is written; nothing where it is reported not to be right."""
    source, out = folder / "in.mpf", folder / "out.mpf"
    source.write_bytes(text.encode("latin-1"))
    given_too = {"offsets": OFFSETS, "tools": TOOLS, "dialect": "siemens"} | more
    report = compensate_file(source, out, MACHINE, Settings(**given_too), name="in.mpf")  # type: ignore[arg-type]
    waits = any("gets no word" in note for note in report.notes)  # the first feed then starts uncompensated
    return out.read_bytes().decode("latin-1") if report.good and not (waits and "G153" in text) else ""


def largest_error(source: str, written: str, length: float = LENGTHS[5]) -> tuple[float, float]:
    """Largest distance from the path that is meant, with the machine's errors: as programmed, as written."""
    meant, done = (SiemensControl([0.0, 0.0, 0.0], FRAMES, LENGTHS).run(text) for text in (source, written))
    assert len(meant.runs) == len(done.runs)
    assert len(meant.rapids) == len(done.rapids)
    before = after = 0.0
    point = np.array([[0.0], [0.0], [-length]])
    for a, b in zip(meant.paths(), done.paths(), strict=True):
        a, b = sampled(a, 0.3), sampled(b, 0.3)  # noqa: PLW2901
        path = MACHINE.ideal(a, point)
        before = max(before, apart(MACHINE.actual(a, point), path))
        after = max(after, apart(MACHINE.actual(b, point), path))
    return before, after


def test_a_program_of_the_language_is_right_along_the_path(tmp_path: Path) -> None:
    assert dialect_of(PROGRAM) == "siemens"
    written = compensated(tmp_path, PROGRAM, dialect=None)
    before, after = largest_error(PROGRAM, written)
    assert before > 0.01
    assert after < ALONG
    for line in ('N20 MSG("start (G0 X5)") ; X5 Y6', "N55 TRANS X=10 Y20", "N97 ATRANS Z5", "; TRUEAXIS COMPENSATED"):
        assert line in written.splitlines()
    assert re.search(r"N80 G1 X[\d.-]+ Y[\d.-]+ Z-\d\.\d+ F=500|N80 G1 [XYZ .\d-]+ F=500", written)


HOLES = """\
%_N_HOLES_MPF
N10 G17 G71 G90 G54
N20 T5 M6
N30 D1
N40 TRANS X=10 Y20
N50 G0 X100 Y20 Z50 S3000 M3
N60 F300
N70 MCALL CYCLE82(50,-1.5,2,-20.5,,0.5) ; drill
N80 X=100 Y=20
N90 G1 X150 M8
N100 X150 Y60
N110 G91 X=10
N120 G90 X=IC(-5) Y100
N130 MCALL
N140 G1 Z45
N150 G0 Y130
N160 CYCLE81(40, 10, 1.5, , 7.25, , 0, 1, 12)
N170 G1 X10
N180 MCALL CYCLE81(41, 10, 1.5, 2)
N190 G2 X20 Y130 CR=5
N200 M30
"""


def test_drilling_cycles_that_are_called_are_written_out(tmp_path: Path) -> None:
    assert dialect_of(HOLES[HOLES.index("N70") :]) == "siemens"
    written = compensated(tmp_path, HOLES, dialect=None)
    before, after = largest_error(HOLES, written)
    assert before > 0.01
    assert after < ALONG
    lines = written.splitlines()
    assert "; N70 MCALL CYCLE82(50,-1.5,2,-20.5,,0.5) ; drill" in lines
    assert sum(line.startswith("G4 F0.5") for line in lines) == 5
    assert not any(line.lstrip("N0123456789 ").startswith(("CYCLE", "MCALL CYCLE")) for line in lines)
    control = SiemensControl([0.0, 0.0, 0.0], FRAMES, LENGTHS).run(HOLES)
    assert sum(len(run) == 2 and abs(run[0][2] - run[1][2]) > 9 for run in control.runs) > 5


@pytest.mark.parametrize(
    ("arguments", "feeds"),
    [
        ("50,-1.5,2,-20.5,,-6.5,,0,0.5,0.2,1,1", 4), ("50,-1.5,2,,19,,5,,,,,0,,,0.4,1.5", 7),
        ("50,-1.5,2,-31.5,,,10,3,0,0,1,1,0,0,0,0,1.2,0,1,12", 6), ("50,-1.5,2,-50,,-15,,4,,,,0", 15),
        ("50,-1.5,2,-20.5,,-20.5,,,,,1,1", 1), ("50,-1.5,2,-20.5,19,-6.5,5,0,,,1,1,3,5,0,0,0", 4),
        # as Autodesk's posts write it; a share of the peck before, with the least of them
        ("50,-1.5,2,-20.5,,-6.5,,0,,,1,1,,5,0,0,0,0,0,1001110", 4), ("50,-1.5,2,-20.5,,-9.5,,-0.5,,,1,1,,3", 5),
        ("60,5,2,-40,,,9,,,,,1,,,,,,,1,2", 5),
    ],
)  # fmt: skip
def test_deep_holes(tmp_path: Path, arguments: str, feeds: int) -> None:
    """The pecks of CYCLE83 as its description has them; dwells at each depth, at the top and at the last depth."""
    call = f"CYCLE83({arguments})"
    blocks = f"N50 G0 X100 Y20 Z60 S3000 M3\nF300\n{call}\nG0 X140\nMCALL {call}\nX10 Y90.5\nMCALL\nM30\n"
    source = f"G17 G71 G90 G54\nT5 M6\nD1\nTRANS X=10 Z5\n{blocks}"
    written = compensated(tmp_path, source)
    before, after = largest_error(source, written)
    assert before > 0.01
    assert after < ALONG
    assert len(re.findall(r"^G1 ", written, re.MULTILINE)) == 2 * feeds
    dwells = re.findall(r"^G4 (\S+)", written, re.MULTILINE)
    first = arguments.startswith("50,-1.5,2,-20.5,,-6.5,,0,0.5")
    assert dwells == (
        2 * ["F0.5", "F0.2", "F0.5", "F0.2", "F0.5", "F0.2", "F0.5"]
        if first
        else 2 * ["F1.5"] * (",1.5" in arguments[9:])
    )


def test_a_called_cycle_keeps_the_switch_of_its_block_and_a_last_line_without_an_end(tmp_path: Path) -> None:
    source = "G71 G90 G54\nT5 M6\nD1\nG0 X0 Y0 Z10\nF100\nMCALL CYCLE81(10,0,2,-3)\n/X50\nX60"
    written = compensated(tmp_path, source, block_delete="run")
    lines = written.splitlines()
    at = next(n for n, line in enumerate(lines) if line.startswith("/X50") or line.startswith("/X49"))
    assert all(line.startswith("/G") for line in lines[at + 1 : at + 4])
    before, after = largest_error(source.replace("/", ""), written.replace("/", ""))
    assert before > after
    assert after < ALONG


HEAD = "T5 M6\nD1\nG71 G90 G54 G0 X0 Y0 Z10\nG1 F100\n"


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("G1 X=R1", "is no word whose value"),
        ("R1=5", "is no word whose value"),
        ("G1 X=5+3", "is no word whose value"),
        ("X=5*2", "is no word whose value"),
        ("G2 X5 Y5 R5.", "R is a parameter on SINUMERIK"),
        ("G2 X5 Y5 CR=1", "more than 2 R"),
        ("CIP X10 Y10 I1=5 J1=5", "is an arc through a middle point"),
        ("CT X10 Y10", "is a tangential arc"),
        ("G2 X0 Y0 I5 J0 TURN=2", "adds turns to an arc"),
        ("ROT RPL=45", "turns the coordinates"),
        ("ROT Z45", "turns the coordinates"),
        ("AROT Z10", "turns the coordinates"),
        ("MIRROR X0", "mirrors"),
        ("SCALE X2 Y2", "scales"),
        ("CYCLE81(10,0,2,R1)", "the argument 'R1' is no number"),
        ("CYCLE81(10,0,2)", "CYCLE81 without one of DP and DPR"),
        ("CYCLE81(,0,2,-20)", "CYCLE81 without RTP and RFP"),
        ("CYCLE81(10,0,2,-20,19)", "with DP and DPR that are different depths"),
        ("CYCLE81(1,0,2,-20)", "RTP not above it"),
        ("CYCLE82(10,0,2,-20,,1,10,0,10)", "with a mode"),
        ("CYCLE82(10,0,2,-20,,1,0,0,11)", "with a mode"),
        ("CYCLE83(10,0,2,-20)", "CYCLE83 without one of FDEP and FDPR"),
        ("MCALL CYCLE83(10,0,2,-20,,-5,4)", "CYCLE83 with FDEP and FDPR that are different depths"),
        ("CYCLE83(10,0,2,-20,,-5,,,,,1)", "CYCLE83 without VARI 0 or 1"),
        ("CYCLE83(10,0,2,-20,,-5,,-1.2,,,1,1)", "CYCLE83 with _DAM below -1"),
        ("CYCLE83(10,0,2,-20,,-5,,-0.5,,,1,1)", "CYCLE83 with pecks that come to nothing"),
        ("CYCLE83(10,0,2,-20,,-5,,,,,0.5,1)", "CYCLE83 with FRF other than 1"),
        ("CYCLE83(10,0,2,-20,,-5,,,,,1,1,1)", "a cycle along X (_AXN) in a plane across Z"),
        ("CYCLE83(10,0,2,-20,,-5,,,,,1,1,4)", "CYCLE83 with _AXN that is none"),
        ("CYCLE83(10,0,2,-20,,-25,,,,,1,1)", "CYCLE83 with a first depth that is not between"),
        ("CYCLE83(10,0,2,-20,,,0.001,,,,1,1)", "CYCLE83 with more than 10000 pecks"),
        ("CYCLE83(10,0,2,-20,,-5,,,,,1,1,,,,,,,10,11)", "CYCLE83 with a mode"),
        ("CYCLE83(10,0,2,-20,,-5,,,0.5,,1,1,,,,,,,10,20)", "CYCLE83 with a mode"),  # dwells in turns of the spindle
        ("CYCLE83(10,0,2,-20,,-5,,2,,,1,1,,,,,,,10,1001110)", "CYCLE83 with a mode"),  # whether _DAM is a share
        ("CYCLE84(10,0,2,-20)", "CYCLE84 taps: its motions go with the spindle"),
        ("MCALL CYCLE81(10,0,2,-20) X5", "beside other words"),
        ("MCALL CYCLE81(10,0,2,-20)\nSUPA G0 X5", "machine coordinates, or the end"),
        ("G93 G1 X1 F9\nCYCLE81(10,0,2,-20)", "a cycle under G93"),
        ("CYCLE800(1)", "tilts the plane"),
        ("G1 X5,5", "a decimal comma: write a decimal point"),
        ("POCKET3(50,0,1)", "POCKET3 is a cycle or a subprogram"),
        ("MYSUB", "MYSUB is not known, and may be a subprogram"),
        ("L100", "L100 calls a subprogram"),
        ("GOTOF END_LABEL", "is a jump"),
        ("IF R1==1 GOTOF A", "is a branch"),
        ("TRAORI", "no rotary axis"),
        ("BSPLINE X5", "is a spline"),
        ("G41 X5", "G41"),
        ("G58 X5", "shifts single axes"),
        ("G74 X1=0", "is no word"),
        ("G75 X5", "moves to a fixed point"),
        ("G505", "G505: where its zero lies is not known"),
        ("G56", "where its zero lies is not known"),
        ("D2", "selects another edge"),
        ('T="MILL"', 'no tool in --tools has the name "MILL"'),
        ("T77 M6", "tool 77 is not in --tools"),
        ("X1=5", "is no word"),
        ("G1 X5 A=5", "this machine has no axis A"),
        ("$TC_DP3[1,1]=5", "is no word"),
        ("G1 X=AC(5", "is no word"),
        ("G1 X=AC(R1)", "is no word"),
        ("M17", "ends a subprogram"),
        ("M3=55", "is no word"),
        ("POS[X]=5", "is no word"),
        ("G91 T1 M6\nX=AC(5)", "AC or IC, other than"),
        ("G10 X5", "polar motion"),
    ],
)  # fmt: skip
def test_what_is_not_followed_is_named_with_its_line(tmp_path: Path, line: str, words: str) -> None:
    with pytest.raises(InputError) as caught:
        compensated(tmp_path, HEAD + line + "\nM30\n")
    assert any(words in fault.problem for fault in caught.value.faults), [f.problem for f in caught.value.faults]
    assert all(int(fault.place.removeprefix("line ")) >= 5 for fault in caught.value.faults)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("L100 P2", "L100 calls a subprogram"),
        ("L7 P=3 ; X5", "L7 calls a subprogram"),
        ("GOTOF END_LABEL", "GOTOF is a jump"),
        ("IF (R1 > 5) AND R2 GOTOB A", "IF is a branch"),
        ("WHILE R1<=3", "WHILE is a loop"),
        ("DEF INT I", "DEF declares a variable"),
        ("PROC PART(REAL X, INT N)", "PROC begins a subprogram"),
        ("EXTERN PART(REAL)", "EXTERN declares a subprogram"),
    ],
)
def test_a_call_a_jump_or_a_declaration_is_one_fault(tmp_path: Path, line: str, words: str) -> None:
    with pytest.raises(InputError) as caught:
        compensated(tmp_path, f"{HEAD}{line}\nM30\n")
    (fault,) = caught.value.faults
    assert words in fault.problem


def test_supa_is_not_called_g53(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="line 5: G53, G153 and SUPA go with G0 or G1 and G90 only"):
        compensated(tmp_path, HEAD + "G91 SUPA G0 Z5\nM30\n")


def test_machine_coordinates_are_those_of_the_tip_while_a_length_is_in_force(tmp_path: Path) -> None:
    source = HEAD + "SUPA G0 Z150\nM30\n"
    written = compensated(tmp_path, source)
    meant, done = (
        np.array(SiemensControl([0.0, 0.0, 0.0], FRAMES, LENGTHS).run(text).rapids[-1])[:, None]
        for text in (source, written)
    )
    point = np.array([[0.0], [0.0], [-LENGTHS[5]]])
    assert meant[2, 0] == 150.0 + LENGTHS[5]
    # Z alone has a word here: X and Y were commanded in another frame
    assert abs((MACHINE.actual(done, point) - MACHINE.ideal(meant, point))[2, 0]) < 0.001
    assert abs((MACHINE.actual(meant, point) - MACHINE.ideal(meant, point))[2, 0]) > 0.001


def test_inches_by_g700(tmp_path: Path) -> None:
    source = "T5 M6\nD1\nG700 G90 G54 G0 X1 Y1 Z1\nG1 F10 X=2.5 Y2\nG2 X3.5 Y2 CR=0.5\nM30\n"
    before, after = largest_error(source, compensated(tmp_path, source))
    assert after < ALONG < before


def test_length_without_d_is_noted(tmp_path: Path) -> None:
    source, out = tmp_path / "in.mpf", tmp_path / "out.mpf"
    source.write_text("T5 M6\nG71 G90 G54 G0 X0 Y0 Z10\nG1 X5 F100\nM30\n")
    report = compensate_file(source, out, MACHINE, Settings(offsets=OFFSETS, tools=TOOLS, dialect="siemens"))
    assert any("MD20270" in note for note in report.notes)
    source.write_text("T5 M6\nD1\nG71 G90 G54 G0 X0 Y0 Z10\nG1 X5 F100\nM30\n")
    report = compensate_file(source, out, MACHINE, Settings(offsets=OFFSETS, tools=TOOLS, dialect="siemens"))
    assert not any("MD20270" in note for note in report.notes)


@pytest.mark.parametrize(
    "text",
    [
        "G54.1 P3\nT0101\nG0 X5.\n",
        "G5.1 X1 Y1 I2 J2\n",
        "(G43.4 H1)\n; G54.1 P3\nG8\n",
        "G5 I1 J1 P2 Q3 X5 Y5\n",
        "G0 X1 Y2\nG2 X5 R3\n",
        "%\nO1234 (A)\nG54 G0 X=5 is no word\n".replace("X=5", "X5"),
        "",
    ],
)
def test_what_several_controls_read_is_not_recognised(text: str) -> None:
    assert dialect_of(text) is None


@pytest.mark.parametrize(
    ("text", "suffix", "control"),
    [
        ("G71 G90\nG0 X5\nT1 D1\n", ".MPF", "siemens"),
        ("G0 X5.\n", ".spf", "siemens"),
        ("G0 X5.\n", ".nc", None),
        ("%\nO1000\nG0 X5.\n", ".mpf", None),
        ("G43.4 H1\n", ".mpf", "fanuc"),
    ],
)
def test_the_extension_of_sinumerik_tells_its_programs(text: str, suffix: str, control: str | None) -> None:
    assert dialect_of(text, suffix=suffix) == control


NUMBERS = st.integers(-20000, 20000).map(lambda n: f"{n / 1000:.3f}")
BLOCKS = st.one_of(
    st.tuples(st.sampled_from(["G0", "G1", "G90 G1", "G91 G1"]), st.sampled_from(["X", "X=", "Y="]), NUMBERS,
              st.sampled_from(["", " M8", " ; c X5"])).map(lambda t: f"{t[0]} {t[1]}{t[2]}{t[3]}"),
    st.tuples(NUMBERS, NUMBERS).map(lambda t: f"G1 X=AC({t[0]}) Y=IC({t[1]})"),
    st.tuples(st.sampled_from("23"), NUMBERS, NUMBERS, st.sampled_from(["40", "-40"])).map(
        lambda t: f"G{t[0]} X=IC({t[1]}) Y=IC({t[2]}) CR={t[3]}"),
    st.tuples(st.sampled_from("23"), NUMBERS, NUMBERS).map(lambda t: f"G{t[0]} I{t[1]} J={t[2]}"),
    st.tuples(st.sampled_from(["TRANS", "ATRANS"]), st.sampled_from("XYZ"), NUMBERS).map(
        lambda t: f"{t[0]} {t[1]}={t[2]}\nG90 G0 X0 Y0 Z5"),
    st.sampled_from(["TRANS\nG90 G0 X0 Y0 Z5", "G500 G90 G0 X300 Y0 Z5", "G54 G90 G0 X0 Y0 Z5", "G55 G90 G0 X0 Y0 Z5",
                     "G71", "MSG(\"x\")", "D0\nG90 G0 Z100\nD1\nG0 Z100", "G153 G90 G0 Z200", "STOPRE",
                     "M0\nG90 G0 X0 Y0 Z5"]),
)  # fmt: skip


@settings(max_examples=30, deadline=None)
@given(st.lists(BLOCKS, min_size=1, max_size=8))
def test_random_programs_are_right_or_refused(blocks: list[str]) -> None:
    source = HEAD + "\n".join(blocks) + "\nM30\n"
    with tempfile.TemporaryDirectory() as folder:
        try:
            written = compensated(Path(folder), source)
        except InputError as error:
            for fault in error.faults:
                assert re.search("radii|apart|radius 0|coincide|travel|AC or IC", fault.problem), fault
            return
    if written:
        assert largest_error(source, written)[1] < ALONG


@pytest.mark.parametrize("block", ["G{}", "G1 X=AC({})", "T{}", "N{} G1 X1", "G1 X1 F{}", "M{}"])
def test_a_number_of_no_machine_is_a_fault(tmp_path: Path, block: str) -> None:
    """It was read as infinite, and ended the program with a traceback."""
    with pytest.raises(InputError, match="no machine's"):
        compensated(tmp_path, HEAD + block.format("9" * 400) + "\nM30\n")
