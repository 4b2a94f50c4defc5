"""What may not pass: each fault with its line, all at once, and no output."""

import pytest

from tests.compensation.control import Bench
from trueaxis.io.faults import InputError

HEAD = "G21 G90 G17\nG0 X1. Y1. Z1.\n"

FAULTY = [
    "G41 D1", "G10 L1 P1 R0.", "G92", "G52 X5. Q1.", "G10 L2 P0 X5.", "G42 D2 X5.",
    "G43 H1 Z10.", "G44 H1", "G91 G53 X0.", "G53 G2 X5. R9.", "G54", "G54.1 P3", "G59",
    "G68 X0. Y0. R30.", "G51 X2.", "G51.1 X0.", "#1=5", "X#1", "X[1+2]", "WHILE [#1 LT 5] DO1", "GOTO 10",
    "IF [1 EQ 1] GOTO 5", "M98 P100", "M99", "G65 P9000", "G30", "G89 Z-1.", "G16",
    "G5 P1", "G6.2", "G7.1 C10.", "G12.1", "G33 Z5. K1.", "G90.1", "G123", "G1.5", "G-1", "M1.5", "M128",
    "A90.", "G1 A5.", "U5.", "X1. X2.", "G0 G1 X5.", "G90 G91", "G20 G21", "G17 G18", "X", "XY5.", "X--1", "X1e400",
    "XNAN", "X1,5", "X1.2.3", "Xinf", "(open", "((nested))", "\x00\x01", "X5. \xa7", "G1 X5. *71", "X1e5", "P5.",
    "G1 I5. J1.", "G2 X5. Y5.", "G2 X5. Y5. I1. J1. R5.", "G2 X9. Y1. R1.", "G2 R5.", "G2 X9. Y9. I1. J0.",
    "G2 I0. J0.",
    "G2 X5. Y1. I2. K1.", "G80 X5.", "G4 X1. Y1.", "H1", "D3", "X9999.", "G91 X-2000.", "/ X5.", "G68.2", "G96 S100",
    "X" + "9" * 400, "=", "$1", "G1 X5. E5.", "T1 Q5.", "G50 X1. G1", "G2 X3. Y1. I1. J0. P2",
    "G2 X3. Y1. I1. J0. P2 M8", "G4 G1 X5.", "G4 P1 X5.", ":7 G54", ":7 X9999.", ":O", "% G70", "%PART G71", "M126",
    "G15", "G23", "G92.3", "G92.1 X5.", "G92.2 X0.", "G69 X5.", "G50 X5.", "G13.1 X5.", "(PY,x=1)", ";py, x", "X5.;Y7.",
    "X100", "G2 X3. Y1. I1 J0.",
]  # fmt: skip


@pytest.mark.parametrize("block", FAULTY)
def test_each_is_a_fault_of_its_line(bench: Bench, block: str) -> None:
    bench.out.write_bytes(b"before")
    with pytest.raises(InputError) as error:
        bench.run(f"{HEAD}{block}\nX2.\n")
    assert any(fault.place == "line 3" for fault in error.value.faults), error.value
    assert all(fault.file == "in.nc" for fault in error.value.faults)
    assert bench.out.read_bytes() == b"before"
    assert sorted(path.name for path in bench.out.parent.iterdir()) == ["in.nc", "out.nc"]


@pytest.mark.parametrize(
    "block",
    [
        "G40", "G49", "G80", "G94", "G95",
        "G64", "G61", "G61.1", "G97 S100", "G69", "G50", "G50.1", "G50.1 X0.", "G98", "G91.1", "G92.1", "G92.2", "G53",
        "D0", "H0", "G4 P1.5", "G4 X1.", "T5", "M6 T5", "S1000 M3", "M9 M5", "G64 P0.01",
        "(M98 G41)", ";G41",
        "/ M8", "", "N5", "%", "G40 G49 G80 G17", "F100", "G9", ":20 M8",
    ],
)  # fmt: skip
def test_the_harmless_comes_back(bench: Bench, block: str) -> None:
    program = f"{HEAD}{block}\nG1 X2.\n".encode()
    assert bench.run(program) == program


@pytest.mark.parametrize(
    ("block", "words"),
    [
        ("G65 P9810 X10. Y10. F1000", "calls a macro"),
        ("G66 P8000 L2", "calls a macro"),
        ("GOTO10", "'GOTO10' is a macro"),
        ("END:", "'END:' is no address"),
        ("G1 FAST", "'FAST' is no address"),
    ],
)
def test_a_call_a_jump_or_a_name_is_one_fault(bench: Bench, block: str, words: str) -> None:
    with pytest.raises(InputError) as error:
        bench.run(f"{HEAD}{block}\nX2.\n")
    (fault,) = error.value.faults
    assert words in fault.problem


def test_all_faults_at_once_with_their_lines(bench: Bench) -> None:
    with pytest.raises(InputError) as error:
        bench.run("G21 G90\nG54\nG0 X1. Y1. Z1.\nG43 H1 G99999\nG1 X2. A3.\nM98 P1\n")
    places = [fault.place for fault in error.value.faults]
    assert places == ["line 2", "line 4", "line 4", "line 5", "line 6"]


def test_faults_come_in_the_order_of_lines(bench: Bench) -> None:
    with pytest.raises(InputError) as error:
        bench.run("G0 X1. Y1. Z1.\nX5000.\nG43\nY-5000.\nG54\n")
    assert [fault.place for fault in error.value.faults] == [f"line {line}" for line in (2, 3, 4, 5)]


def test_a_garbage_file_of_any_length_gives_few_messages_and_the_count(bench: Bench) -> None:
    with pytest.raises(InputError, match="line 1: looks like no NC program") as alone:
        bench.run("@@@@\n" * 5000)
    assert len(alone.value.faults) == 1
    with pytest.raises(InputError) as error:
        bench.run("G1 X1. @@@@\n" * 5000)
    assert len(error.value.faults) == 50
    assert "5000 faults in all" in str(error.value.faults[-1])


def test_one_line_without_end(bench: Bench) -> None:
    with pytest.raises(InputError, match="more than 65536 bytes"):
        bench.run(b"X" * 300_000)


@pytest.mark.parametrize(
    ("program", "line", "words"),
    [
        ("X1. Y1. Z1.\n", 1, "no motion"),
        ("G0 X1. Y1.\nG91 G28 Z0.\nG90 G1 X2. F9\n", 3, "position of Z is not known"),
        ("G0 X1. Y1.\nG18 G2 X2. R3. F9\n", 2, "position of Z is not known"),
        ("G0 X1. Y1.\nG2 X2. Z3. R3. F9\n", 2, "position of Z is not known"),
        ("G0 X1. Y1.\nG91 Z1.\n", 2, "position of Z is not known"),
        ("G91 G0 X1. Y1. Z1.\n", 1, "position of X Y Z is not known"),
        ("G2 X1. Y0. Z0. I5.\n", 1, "is not known"),
        (HEAD + "O2\nG1 X5.\n", 3, "program number after motions"),
        (HEAD + ":2\nG1 X5.\n", 3, "program number after motions"),
        (HEAD + "G80\nX5.\n", 4, "no motion"),
    ],
)
def test_where_it_goes_is_not_known(bench: Bench, program: str, line: int, words: str) -> None:
    with pytest.raises(InputError, match=words) as error:
        bench.run(program)
    assert [fault.place for fault in error.value.faults] == [f"line {line}"]


def test_out_of_travel_says_which_axis_and_its_travel(bench: Bench) -> None:
    with pytest.raises(InputError, match=r"Y = 1000.5 is outside its travel; from -1000 to 1000"):
        bench.run(HEAD + "G1 Y1000.5\n")


def test_an_arc_that_bulges_out_of_the_travel(bench: Bench) -> None:
    with pytest.raises(InputError, match=r"line 3: X = 100\d.* is outside its travel"):
        bench.run("G0 X995. Y0. Z0.\nG3 X985. I-5. F9\nG3 X985. Y1. I10. J0.5\n")
    with pytest.raises(InputError, match=r"takes \d+ chords"):
        bench.run("G0 X100. Y0. Z0.\nG3 I-100. F9\n", chord_tolerance=1e-11)


def test_a_start_outside_the_travel_is_the_fault_of_the_option(bench: Bench) -> None:
    with pytest.raises(InputError, match=r"--start: X = 5000 is outside its travel, from -?\d+ to \d+") as caught:
        bench.run(HEAD, start={"X": 5000.0, "Y": -6000.0})
    assert "Y = -6000" in str(caught.value)
    assert "line" not in str(caught.value)


def test_an_axis_that_the_start_names_must_exist(bench: Bench) -> None:
    with pytest.raises(InputError, match="no axis C"):
        bench.run(HEAD, start={"C": 1.0})


@pytest.mark.parametrize(
    ("block", "words"),
    [
        ("G70", r"G70 reads inches \(Siemens, Heidenhain\) or is a lathe cycle .*; write G20"),
        ("G71", r"G71 reads millimetres \(Siemens, Heidenhain\) or is a lathe cycle .*; leave it out"),
        ("G38.2 Z1.", "G38.2 probes: where the axes stop"),
        ("G92.3", "G92.3 restores a shift"),
        ("G60", r"stops exactly \(Siemens\)"),
        ("G30", r"defines the blank \(Heidenhain\)"),
        ("G15", "G15 ends polar coordinates .*--dialect fanuc"),
        ("G84 Z-1.", "G84 is a canned cycle.*; say --dialect fanuc if it is one; else tap in a program of its own"),
        ("G81 Z-1.", "G81 without Z and R"),
    ],
)
def test_a_refusal_says_what_the_code_means_on_which_control(bench: Bench, block: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        bench.run(f"{HEAD}{block}\n")


def test_a_code_that_one_control_makes_harmless(bench: Bench) -> None:
    assert bench.run(f"{HEAD}G15\nX2.\n", dialect="fanuc") == f"{HEAD}G15\nX2.\n".encode()
    with pytest.raises(InputError, match="G15 and axis words in one block"):
        bench.run(f"{HEAD}G15 X2.\n", dialect="fanuc")
