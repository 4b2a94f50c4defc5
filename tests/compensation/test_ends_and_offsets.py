"""What a whole program leaves unsaid: its work offset, and its end; and what a code of the builder may not be."""

import pytest

from tests.compensation.analytic_machine import XyzMachine
from tests.compensation.control import Bench
from tests.compensation.test_uncommanded import bent
from trueaxis.compensation.offsets import Offsets
from trueaxis.io.faults import InputError

NC = "G21 G90\n{}G0 X10. Y10. Z30.\nG1 X20. F500\n{}"
KLARTEXT = "BEGIN PGM T MM\nL X+10 Y+10 Z+30 R0 FMAX M3\nL X+20 F500\n{}"
CUT_OFF = "is it whole?"


def noted(bench: Bench, text: str) -> bool:
    return any(text in note for note in bench.report.warnings)


@pytest.mark.parametrize(("selected", "wanted"), [("", True), ("G54\n", False), ("G53 G0 Z30.\nG54\n", False)])
@pytest.mark.parametrize("dialect", [None, "fanuc", "siemens", "linuxcnc"])
def test_a_program_without_any_work_offset_is_told(
    bench: Bench, dialect: str | None, selected: str, wanted: bool
) -> None:
    known = Offsets({"G54": dict.fromkeys("XYZ", (20.0, 20.0))}) if selected else Offsets()
    bench.run(NC.format(selected, "M30\n"), bent(), dialect=dialect, offsets=known)
    assert (bench.report.unplaced is not None) is wanted
    first = bench.told.splitlines()[1]
    assert (first.startswith("WARNING: no work offset is given or selected")) is wanted


def test_what_it_may_cost_is_the_change_with_the_zero_anywhere_in_the_travel(bench: Bench) -> None:
    """EXX grows by 1e-5 per mm: the program fills 10 mm of X, and begins at an end of it."""
    machine = XyzMachine({"EXX": lambda x: 1e-5 * x})
    low, high = machine.travel["X"]
    bench.run(f"G21 G90\nG0 X{low:.1f} Y0. Z0.\nG1 X{low + 10:.1f} F500\nM30\n", machine)
    assert bench.report.unplaced == pytest.approx(1e-5 * (high - low - 10.0), rel=1e-3)
    assert f"up to {bench.report.unplaced:.4f} mm" in bench.told
    given = Offsets({"G54": dict.fromkeys("XYZ", (0.0, 0.0))})
    bench.run("G21 G90\nG0 X0. Y0. Z0.\nG1 X10. F500\nM30\n", machine, offsets=given)
    assert bench.report.unplaced is None
    assert "WARNING" not in bench.told


@pytest.mark.parametrize(
    ("program", "wanted"),
    [
        (NC.format("", ""), False),  # such a program is no more than blocks
        ("%\n" + NC.format("", ""), True),
        ("%\n" + NC.format("", "%\n"), False),
        ("%\n" + NC.format("", "M30\n"), False),
        (KLARTEXT.format(""), True),
        (KLARTEXT.format("END PGM T MM\n"), False),
        (KLARTEXT.format("M30\n"), False),
    ],
)
def test_a_program_that_is_cut_off_is_told(bench: Bench, program: str, wanted: bool) -> None:
    bench.run(program, bent())
    assert noted(bench, CUT_OFF) is wanted


@pytest.mark.parametrize("code", [101, 110, 129, 150, 154, 234, 254])
def test_codes_of_a_builder_that_shift_or_move_cannot_be_passed(bench: Bench, code: int) -> None:
    with pytest.raises(InputError) as error:
        bench.run(f"G21 G90\nG0 X1. Y1. Z1.\nG{code}\nG1 X2. F100\n", bent(), pass_g=frozenset({code}))
    assert "--pass-g" not in str(error.value)


def test_after_a_reference_point_the_remedy_is_a_block_not_an_option(bench: Bench) -> None:
    text = "G21 G90\nG0 X1. Y1. Z1.\nG91 G28 Z0.\nG90 G1 X2. F100\n"
    with pytest.raises(
        InputError, match=r"line 4: the position of Z is not known here after a reference point .*; a rapid with Z"
    ) as error:
        bench.run(text, bent(), start={"X": 0.0, "Y": 0.0, "Z": 0.0})
    assert "--start" not in str(error.value)


def test_a_file_that_is_no_text_is_told_once(bench: Bench) -> None:
    with pytest.raises(InputError, match="line 3: a byte of zero: no text file") as error:
        bench.run("G21\nG90\nG0 X1.\0\0\n#1=2\n", bent())
    assert len(error.value.faults) == 1
