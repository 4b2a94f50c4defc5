"""What is said before many faults; small things of reports and options."""

from typing import Any

import pytest

from tests.compensation.analytic_machine import XyzMachine, paper_sized
from tests.compensation.control import Bench
from tests.compensation.five_axes import TEXTS, FiveAxes
from tests.machines import machine_of, serial_text
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.tools import Tool, ToolTable
from trueaxis.io.faults import Fault, InputError
from trueaxis.reporting.compensation import offset_text
from trueaxis.reporting.compensation_checks import tool_frame_sentences

G54 = Offsets({"G54": dict.fromkeys("XYZ", (100.0, 100.0))})


def faults_of(bench: Bench, program: str, **settings: Any) -> tuple[Fault, ...]:
    with pytest.raises(InputError) as error:
        bench.run(program, XyzMachine(), **settings)
    return tuple(error.value.faults)


def test_another_control_is_said_first(bench: Bench) -> None:
    program = 'N1 G0 X=5 Y=5\nTRANS X5\nG1 X=7 F9\nMSG("a")\nG2 X5 Y6 CR=9\n'
    found = faults_of(bench, program, dialect="fanuc")
    assert len(found) == 1  # each block but one would be a fault
    assert str(found[0]) == (
        "in.nc: looks like a program for SINUMERIK (Siemens); 5 faults as one for Fanuc or the like are not listed; "
        "--dialect siemens"
    )
    found = faults_of(bench, 'G0 X1. Y1. Z1.\nMSG("a")\nTRANS X5.\n', dialect="fanuc")
    assert "looks like" in str(found[0])
    assert len(found) > 1  # few are listed
    assert "looks like" not in str(faults_of(bench, program.replace("TRANS", "ROT"), dialect="siemens")[0])


@pytest.mark.parametrize("dialect", ["siemens", "heidenhain"])
def test_a_number_behind_a_percent_sign_is_no_program_of_these(bench: Bench, dialect: str) -> None:
    program = "%\nO1001 (PLATE)\nG21 G90\nG43 H1 Z5.\nM30\n%\n"
    assert str(faults_of(bench, program, dialect=dialect)[0]).endswith("Fanuc or the like; --dialect fanuc")
    assert "looks like" not in str(faults_of(bench, program[program.index("(") :], dialect=dialect)[0])


def test_macros_name_the_way_to_unroll_them(bench: Bench) -> None:
    program = "G21 G90\nG0 X0. Y0. Z0.\n" + "#1=5\nG1 X#1 F9\n" * 4
    for dialect in (None, "linuxcnc"):
        first = faults_of(bench, program, dialect=dialect)[0]
        assert (
            "8 blocks hold macros, variables or expressions; --via-linuxcnc (LinuxCNC installed here) has its"
            in str(first)
        )
    assert "--via-linuxcnc" not in str(faults_of(bench, program, dialect="fanuc")[0])
    [alone] = faults_of(bench, "G0 X#1\n")  # one fault is read at once, and names the way itself
    assert "blocks hold macros" not in str(alone)
    assert alone.remedy.startswith("--via-linuxcnc (LinuxCNC installed here) unrolls it")


def test_travel_is_told_for_the_whole_program(bench: Bench) -> None:
    program = "G21 G90\nG53 G0 Z-1000.\nG54 G0 X0. Y0. Z0.\n" + "".join(f"Z{z}.\n" for z in range(895, 935, 5))
    found = faults_of(bench, program, offsets=G54)
    assert str(found[0]) == (
        "in.nc: Z reaches 100 to 1030, and its travel is from -1000 to 1000: 6 blocks are outside; "
        "moved by at least Z-30 mm it fits: is the work offset right?"
    )
    assert len(found) == 7
    wide = faults_of(bench, program + "G0 Z-2000.\n", offsets=G54)[0]
    assert "another machine, or another clamping" in str(wide)
    assert len(faults_of(bench, "G54 G0 X0. Y0. Z0.\nZ950.\n", offsets=G54)) == 1


def test_a_work_offset_that_is_not_given_is_named(bench: Bench) -> None:
    """The shift fits all axes, those too that no block but one that X takes outside first takes outside."""
    first, *each = faults_of(bench, "G21 G90 G17\nG0 X-1030. Y-1000.0002 Z0.\nG2 X-990. I20. J0.\nG1 X-980. F99\n")
    assert len(each) == 2  # the arc is followed, too
    assert str(first) == (
        "in.nc: X reaches -1030 to -980, and its travel is from -1000 to 1000, Y reaches -1000 to -980.001, and its "
        "travel is from -1000 to 1000: 2 blocks are outside; moved by at least X+30 mm Y+0.001 mm it fits: no work "
        "offset is given; --offset G54=X..,Y..,Z.. says where the zero of the part lies in the machine"
    )
    program = "0 BEGIN PGM A MM\n1 L X+5 Y+5 Z+1001 R0 FMAX\n2 END PGM A MM\n"
    assert ": no preset is given; --offset G54=X..,Y..,Z.. says" in str(faults_of(bench, program)[0])
    (fault,) = faults_of(bench, program, offsets=Offsets({"G54": dict.fromkeys("XYZ", (10.0, 10.0))}))
    assert "preset" not in str(fault)
    assert len(faults_of(bench, "G21 G90\nG0 X0. Y0. Z0.\nG53 G0 Z-1001.\n")) == 1  # no offset would help


def test_numbers_that_may_mean_two_lengths_are_no_positions(bench: Bench) -> None:
    found = faults_of(bench, "G21 G90 G54\nG0 X0. Y0. Z0.\nG0 X10000\n", offsets=G54)
    assert ["without a decimal point" in str(fault) for fault in found] == [True]


def test_a_rounded_corner_is_named(bench: Bench) -> None:
    (fault,) = faults_of(bench, "G21 G90\nG0 X0. Y0. Z0.\nG1 X10.,R2. F9.\n")
    assert "column 8: ',R2. F9.' rounds or chamfers a corner: write it as an arc or a line" in str(fault)
    (fault,) = faults_of(bench, "GOTOF END\n", dialect="siemens")[:1]
    assert "write the blocks that are run, in their order" in str(fault)


def test_a_word_of_linuxcnc_is_one_fault(bench: Bench) -> None:
    found = faults_of(bench, "G21 G90\nG0 X0. Y0. Z0.\no100 call\n")
    assert len(found) == 1
    assert "'call' is a macro" in str(found[0])
    (fault,) = faults_of(bench, "G21 G90\nG0 X0. Y0. Z0.\nO100\n")
    assert "a program number after motions" in str(fault)


@pytest.mark.parametrize(("peck", "noted"), [("Q3", True), ("Q3.", False)])
def test_a_peck_without_a_decimal_point_is_noted(bench: Bench, peck: str, noted: bool) -> None:
    program = f"G21 G90\nG0 X0 Y0 Z9\nG83 X1 Y1 Z-6 R2 {peck} F100\nX2\nX3\n"
    bench.run(program, integers="mm")
    assert any("Q without a decimal point is read as mm" in note for note in bench.report.warnings) == noted
    bench.run(program, dialect="linuxcnc")
    assert not any("Q without" in note for note in bench.report.warnings)
    with pytest.raises(InputError, match="Q30 is deeper than the hole"):
        bench.run(program.replace("Q3", "Q30").replace("Q30.", "Q30"), integers="mm")


BEHIND = "%\nO1\nG21 G90\nG0 X0. Y0. Z0.\nG1 X10. F9.\nM30\n%\n"


@pytest.mark.parametrize("dialect", [None, "fanuc"])
def test_text_before_the_first_percent_sign_is_left(bench: Bench, dialect: str | None) -> None:
    machine = XyzMachine({"EXX": lambda x: 0.02 + 0.0 * x})
    head = "(made by CAM)\n\nPROGRAM: PART.NC, TOOL 5\nX, Y AND Z\n"
    written = bench.run(head + BEHIND, machine, dialect=dialect).decode()
    assert written == head + bench.run(BEHIND, machine, dialect=dialect).decode()
    bench.run(head + BEHIND, machine, dialect=dialect)
    assert any(note.startswith("line 3 (and 1 more): text before the first %") for note in bench.report.notes)
    bench.run("(made by CAM)\n" + BEHIND, machine, dialect=dialect)
    assert not any("text before" in note for note in bench.report.notes)


def test_what_is_no_text_before_a_percent_sign_is_read(bench: Bench) -> None:
    for block in ("T5", "#1=5", "N10 #1=5", "IF[#1 EQ 1]GOTO 5", "X5 Y5 AND MORE", "/G0 X5."):
        found = faults_of(bench, f"CAM\n{block}\n" + BEHIND)  # whether these are read is not known
        assert any("'CAM' is no address" in str(fault) for fault in found)
    assert "'CAM' is no address" in str(faults_of(bench, "CAM\n" + BEHIND.replace("%\n", "", 1))[0])
    (fault,) = faults_of(bench, "(made by CAM)\n" + BEHIND, dialect="linuxcnc")
    assert str(fault) == "in.nc: line 2: % behind other lines, which LinuxCNC refuses; % in the first line, or none"
    assert bench.run("\n \n" + BEHIND, dialect="linuxcnc")
    compensated = bench.run("CAM\n" + BEHIND) and bench.out.read_bytes()
    assert "is compensated already" in str(faults_of(bench, compensated.decode())[0])


def test_how_far_pecks_go_back(bench: Bench) -> None:
    program = "G21 G90\nG0 X0. Y0. Z9.\nG73 X1. Y1. Z-3. R2. Q2. F100\nX2.\nX3.\nX4.\nX5.\nX6.\n"
    text = bench.run(program, peck_return=0.5).decode()
    assert text.count("G0 Z0.500\n") == text.count("G1 Z0.000\n") == 6
    assert any("pecks go back by 0.5 mm" in note for note in bench.report.notes)
    assert "G0 Z0.254\n" in bench.run(program).decode()
    with pytest.raises(ValueError, match="peck_return is 0; it must be above 0"):
        Settings(peck_return=0.0)


def test_an_offset_is_told_once_with_and_without_point_control(bench: Bench) -> None:
    machine = FiveAxes(TEXTS["table-table"]).model
    offsets = Offsets(
        {"G54": {axis: (value, value) for axis, value in zip("XYZAC", (9.0, 8.0, 7.0, 0.0, 0.0), strict=True)}}
    )
    tools = ToolTable({1: Tool(length=50.0)})
    program = (
        "G21 G90 G54\nG0 A0. C0.\nT1 M6\nG0 X10. Y5.\nG43 H1 Z9.\nG49 G0 X0. Y0. Z30.\n"
        "G43.4 H1\nG0 X10. Y5. Z9.\nG1 X20. A5. C9. F100\n"
    )
    bench.run(program, machine, offsets=offsets, tools=tools, dialect="fanuc")
    assert bench.told.count("G54 is taken at") == 1


def test_lengths_of_vectors_are_named_so(bench: Bench) -> None:
    bench.run("G21 G90 G54\nG0 X1. Y1. Z1.\n", paper_sized(3.0), offsets=G54)
    assert "um for Z (length of the vector)" in bench.told
    assert "(deg)" not in offset_text(bench.report.offsets[0])


@pytest.mark.parametrize(("dialect", "said"), [(None, "G54.1 P2 for a further work offset"), ("fanuc", "G54.1 P2")])
def test_a_number_beside_g54_names_what_takes_one(bench: Bench, dialect: Any, said: str) -> None:
    (fault,) = faults_of(bench, "G21 G90 G54 P2\nG0 X1. Y1. Z1.\n", offsets=G54, dialect=dialect)
    assert fault.problem.startswith("P2 has no code here")
    assert said in fault.remedy
    (fault,) = faults_of(bench, "G21 G90\nG0 X1. Y1. Z1. Q2\n", offsets=G54, dialect=dialect)
    assert not fault.remedy


def test_a_pole_of_sinumerik_is_no_offset_of_haas(bench: Bench) -> None:
    (fault,) = faults_of(bench, "G71 G90\nG0 X1 Y1 Z1\nG111 X5 Y5\n", dialect="siemens")
    assert str(fault).startswith("in.nc: line 3: G111 sets the pole of polar positions (SINUMERIK)")
    assert "Haas" in str(faults_of(bench, "G21 G90\nG0 X1. Y1. Z1.\nG111\n")[0])


def test_lines_are_said_to_be_those_of_the_file(bench: Bench) -> None:
    bench.run("G21 G90\nN70 G0 X1. Y1. Z1.\nN80 X2.\n")
    assert bench.told.splitlines()[2].endswith("largest  at line of file")


@pytest.mark.parametrize(
    ("parameters", "said"), [({}, ""), ({"q_Tz": -100.0}, "at 0, 0, -100 (q_Tx, q_Ty, q_Tz) of the body")]
)
def test_from_where_lengths_of_tools_count(parameters: dict[str, float], said: str) -> None:
    found = tool_frame_sentences(machine_of(serial_text("X", "YZ")), parameters)
    assert len(found) == bool(said)
    assert not said or said in found[0]
