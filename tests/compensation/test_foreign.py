"""Files that are no programs, and numbers that are mistyped: the first line says so, and what would be right."""

import struct
from typing import Any

import pytest

from tests.compensation.analytic_machine import XyzMachine
from tests.compensation.control import Bench
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.overview import foreign_alone
from trueaxis.io.faults import Fault, InputError

CSV = "x,y,z\n" + "".join(f"{k},{2 * k},0\n" for k in range(10))
FACET = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n"
LETTER = "Hello, this is the setup sheet for part 4711.\nTool 1: drill 10\nNote: check\nEnd of sheet.\n"
NC = "%\nO1\nG21 G90 G54\nG0 X5. Y5. Z5.\nG1 X6. F100.\nM30\n%\n"


def faults_of(bench: Bench, program: str | bytes, **settings: Any) -> tuple[Fault, ...]:
    bench.out.write_bytes(b"before")
    with pytest.raises(InputError) as error:
        bench.run(program, XyzMachine(), **settings)
    assert bench.out.read_bytes() == b"before"
    return tuple(error.value.faults)


@pytest.mark.parametrize(
    ("content", "what"),
    [
        (b"%PDF-1.4\n%\xe2\xe3\xcf\xd3\n1 0 obj\n", "begins as a PDF document does"),
        (f"solid cube\n{FACET * 20}endsolid\n", "begins as an STL model does"),
        (b"x" * 80 + struct.pack("<I", 3) + b"\0" * 150, "holds bytes of zero"),
        ("  0\nSECTION\n  2\nHEADER\n", "begins as a DXF drawing does"),
        ("ISO-10303-21;\nHEADER;\n", "begins as a STEP model does"),
        (b"PK\x03\x04\x14\0\0\0", "begins as a ZIP archive, such as an office document, does;"),
        ("<html><body>\n<p>404 Not Found</p>\n", "begins as a page of HTML"),
        (LETTER, "0 of its first 4 lines may be blocks"),
        (CSV, "0 of its first 11 lines may be blocks"),
        ("import os\nfor i in range(3):\n    print(i)\n", "0 of its first 3 lines may be blocks"),
    ],
)
def test_a_file_that_is_no_program_is_told_alone(bench: Bench, content: str | bytes, what: str) -> None:
    first = "".join(map(str, faults_of(bench, content)))
    assert first.startswith("in.nc: line 1: looks like no NC program: ")
    assert what in first
    assert first.endswith("; the program that a CAM system or the control wrote")


@pytest.mark.parametrize(
    ("content", "what"),
    [
        (NC.replace("\n", "\r"), "its lines end with CR alone, which this reads as one line; line ends LF or CR LF"),
        (NC.encode("utf-16"), "is text in UTF-16, which no control reads; save it as ASCII or UTF-8"),
    ],
)
def test_a_program_that_was_saved_otherwise(bench: Bench, content: str | bytes, what: str) -> None:
    assert str(faults_of(bench, content)[0]) == f"in.nc: line 1: {what}"


@pytest.mark.parametrize("content", ["", "\n\n  \n", "(only)\n; comments\n", "%\n%\n", "\xef\xbb\xbf(x)\n", "%\r\n"])
def test_a_file_without_a_block_is_a_fault(bench: Bench, content: str) -> None:
    """It wrote an output."""
    (fault,) = faults_of(bench, content)
    assert str(fault).startswith("in.nc: line 1: holds no block: it is empty, or comments alone; ")
    bench.run(f"{content}\nM30\n")  # which is one


@pytest.mark.parametrize(
    "program",
    [
        "G21 G90\nG0 X#1\nG1 X[2+3] F9\n",
        "o<fast> sub\n#1=3\no<fast> endsub\nG1 X#1\n",
        "BEGIN PGM T MM\nL X+Q1 R0 FMAX\nCALL LBL 1\nEND PGM T MM\n",
        "DEF REAL A\nR1=3\nPOCKET3(1,2)\nG1 X=R1\n",
        "G21 G90 G41 D1\n",
        "\0BEGIN PGM T MM\nL X+1 R0 FMAX\nEND PGM T MM\n",
        "\0FROM/0,0,0\nFEDRAT/100\nRAPID\nGOTO/1,1,1\nFINI\n",
    ],
)
def test_a_program_with_faults_is_one(bench: Bench, program: str) -> None:
    assert "looks like no NC" not in str(faults_of(bench, program)[0])


@pytest.mark.parametrize(
    ("block", "dialect", "said"),
    [
        ("G1 X1,5 F100", None, "column 6: X1,5 has a decimal comma: write a decimal point (X1.5)"),
        ("G1 X-1,25F100", "siemens", "X-1,25 has a decimal comma: write a decimal point (X-1.25)"),
        ("G1 X=1,5 F100", "siemens", "X=1,5 has a decimal comma: write a decimal point (X=1.5)"),
        ("G1 X5O F100", None, "column 6: X5O has the letter O for a zero: X50"),
        ("G1 X5O3. F100", None, "X5O3. has the letter O for a zero: X503."),
        ("G1 XO.5 F100", None, "XO.5 has the letter O for a zero: X0.5"),
        ("GO X5. Y5.", None, "GO has the letter O for a zero: G0"),
        ("GO X5. Y5.", "siemens", "GO has the letter O for a zero: G0"),
        ("G1 X-1O. F100", "siemens", "X-1O. has the letter O for a zero: X-10."),
        ("N17O G1 X6. F100", None, "N17O has the letter O for a zero: N170"),
        ("N1O", None, "N1O has the letter O for a zero: N10"),
        ("N1O G1 X6 F100", "siemens", "N1O has the letter O for a zero: N10"),
        ("G1 X6O,25 F100", None, "X6O,25 has the letter O for a zero, and a decimal comma: X60.25"),
        ("G1 X6,O5 F100", None, "X6,O5 has the letter O for a zero, and a decimal comma: X6.05"),
        ("GO X5,5 YO.", None, "column 1: GO has the letter O for a zero: G0, column 6: X5,5 has a decimal comma"),
    ],
)
def test_a_mistyped_number_is_the_only_fault(bench: Bench, block: str, dialect: Any, said: str) -> None:
    """X5 of X5,5 was a number without a decimal point, and that came first."""
    (fault,) = faults_of(
        bench,
        f"G21 G90\nG0 X1. Y1. Z1.\n{block}\nM30\n".replace("G21", "G71" * (dialect == "siemens") or "G21"),
        dialect=dialect,
    )
    assert said in fault.problem
    assert fault.place == "line 3"


@pytest.mark.parametrize(
    ("program", "dialect"),
    [
        ("G21 G90 G17\nG0 X1. Y1. Z1.\nG1 Y5O. F100\nG2 X2. Y51. I1. J0.\nG0 Z5O\nG91 Z960.\n", None),
        ("G71 G90 G17\nG0 X1. Y1. Z1.\nG1 Y=5O. F100\nG2 X2. Y51. I1. J0.\nG0 Z5O\nG91 Z960.\n", "siemens"),
        (
            "BEGIN PGM T MM\nL X+1 Y+1 Z+1 FMAX\nL Y+5O F100\nCC X+2 Y+50\nC X+2 Y+51 DR-\nL Z+5,0\n"
            "L IZ+1000\nEND PGM T MM\n",
            None,
        ),
    ],
)
def test_what_follows_a_mistyped_number_is_read_on_from_where_it_leads(
    bench: Bench, program: str, dialect: Any
) -> None:
    """The arc behind it had no centre, and where the axes were then was not known: what is out of travel is found."""
    found = faults_of(bench, program, dialect=dialect, offsets=Offsets({"G54": dict.fromkeys("XYZ", (0.0, 0.0))}))
    assert [fault.place.split()[-1] for fault in found] == (["3", "6", "7"] if "PGM" in program else ["3", "5", "6"])
    assert "is outside its travel" in found[-1].problem


def test_klartext_is_mistyped_alike(bench: Bench) -> None:
    for word, said in (("X+1,5", "X+1,5 has a decimal comma"), ("X+1O", "X+1O has the letter O for a zero: X+10")):
        (fault,) = faults_of(bench, f"BEGIN PGM T MM\nL X+1 Y+1 Z+1 FMAX\nL {word} F100\nEND PGM T MM\n")
        assert said in fault.problem
        assert not fault.remedy
    (fault,) = faults_of(bench, "BEGIN PGM T MM\nL X+1 Y+1 Z+1 FMAX\nL X+Q1 F100\nEND PGM T MM\n")
    assert str(fault) == "in.nc: line 3: 'X+Q1 F100' is no word with its value; the number itself in place of it"


def test_many_mistyped_numbers_are_told_once_before(bench: Bench) -> None:
    blocks = "".join(f"G1 X{k},5 F100.\n" for k in range(9))
    found = faults_of(bench, f"G21 G90\nG0 X5 Y1. Z1.\n{blocks}M30\n")
    assert str(found[0]) == (
        "in.nc: line 3: 9 blocks hold mistyped numbers; the first: column 6: X0,5 has a decimal comma: write a decimal "
        "point (X0.5); numbers with a decimal point throughout"
    )
    blocks = "".join(f"L X+{k},5 F100\n" for k in range(9))
    found = faults_of(bench, f"BEGIN PGM T MM\nL X+1 Y+1 Z+1 FMAX\n{blocks}END PGM T MM\n")
    assert "9 blocks hold mistyped numbers; the first: X+0,5 has a decimal comma" in str(found[0])


@pytest.mark.parametrize("block", ["GOTO 10", "N10 O100", "G65 P1 D1", "DO1"])
def test_what_has_an_o_of_its_own_is_not_mistyped(bench: Bench, block: str) -> None:
    assert "letter O" not in "".join(map(str, faults_of(bench, f"G21 G90\nG0 X1. Y1. Z1.\n{block}\nM30\n")))


def test_it_is_told_in_place_of_what_an_interpreter_says() -> None:
    refused = Fault("in.nc", "line 1", "LinuxCNC refuses the program: Bad character '%' used")
    for head, told in (("%PDF-1.4\n", "looks like no NC program"), ("G0 X1\n", "LinuxCNC refuses")):
        with pytest.raises(InputError) as error, foreign_alone("in.nc", head):
            raise InputError([refused])
        (fault,) = error.value.faults
        assert told in fault.problem
