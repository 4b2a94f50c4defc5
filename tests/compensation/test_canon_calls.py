"""Programs unrolled by --via-linuxcnc, compared call by call with the source in LinuxCNC's stand-alone interpreter.

The judge is `rs274`, which src does not use: motions, modes in force, spindle, coolant, tools, dwells and stops of the
source and of what is written, with the same table of tools and the same parameters.
"""

from itertools import groupby
from pathlib import Path

import pytest

from tests.compensation.analytic_machine import XyzMachine, paper_sized
from tests.compensation.rs274_calls import INCH, PRINTED, calls_of, different
from tests.compensation.test_via_linuxcnc import INSTALLED, PACKAGE
from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.offsets import read_offsets
from trueaxis.compensation.report import CompensationReport
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.tools import read_tools
from trueaxis.io.faults import InputError

pytestmark = pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")

ZERO = {"X": 300.0, "Y": -200.0, "Z": 100.0}  # of G54, mm
TABLE = {1: (20.0, 8.0), 3: (35.0, 10.0), 7: (41.5, 25.4)}  # length and diameter, mm
HEAD = "G21 G90 G17 G40 G49 G80 G54\nT1 M6\nG43 H1\nG0 X0 Y0 Z5\n"
CORRECTED = 0.15  # mm: more than this machine's errors are
ERRORS = paper_sized()
MACHINE = XyzMachine(ERRORS.curves, ERRORS.squareness, travel=dict.fromkeys("XYZ", (-1500.0, 1500.0)))
PARAMETERS = {31: 4.0, 150: 7.0, 151: 2.0, 5161: 1.0, 5162: 2.0, 5163: 300.0}


def table(scale: float) -> str:
    return "".join(f"T{t} P{t} Z{z / scale:.9f} D{d / scale:.9f}\n" for t, (z, d) in TABLE.items())


def parameters(scale: float) -> dict[int, float]:
    """Of a .var file of LinuxCNC; lengths: of the reference point and of G54."""
    values = dict.fromkeys((*range(5161, 5170), *range(5181, 5190), *range(5210, 5220)), 0.0)
    values |= {5221 + 20 * system + row: 0.0 for system in range(9) for row in range(10)}
    values |= PARAMETERS | {5220: 1.0} | {5221 + row: at for row, at in enumerate(ZERO.values())}
    lengths = {*range(5161, 5164), *range(5221, 5224)}
    return {number: value / scale if number in lengths else value for number, value in values.items()}


def compensated(
    folder: Path, text: str, tools: str = "", suffix: str = ".tbl", via: Path | None = PACKAGE
) -> CompensationReport:
    """Compensate a program with the .var file and the table; tools: another one; via: None, without the interpreter."""
    (folder / "in.ngc").write_text(text)
    (folder / f"tools{suffix}").write_text(tools or table(1.0))
    (folder / "control.var").write_text("".join(f"{n}\t{v:.6f}\n" for n, v in sorted(parameters(1.0).items())))
    settings = Settings(
        dialect="linuxcnc", offsets=read_offsets(folder / "control.var"), tools=read_tools(folder / f"tools{suffix}"),
        start=dict.fromkeys("XYZ", 0.0), pass_m=(0, 1, 6, 60), integers="mm",
    )  # fmt: skip
    return compensate_file(folder / "in.ngc", folder / "out.ngc", MACHINE, settings, via_linuxcnc=via)


@pytest.mark.parametrize(
    "blocks",
    [
        "G64 P.05 Q.01\nG0 X9 Y9\nG81 X10 Y10 Z-1 R2 F50\nX20\nY30\nX40\nX50\nX60\nX70\nG80\nG1 X30 F80\n",
        "G64\nG0 X9 Y9\nG99 G83 X10 Y10 Z-1 R2 Q.5 F50\nX20\nG64 P.1\nX30\nG64 P.2\nG1 Y30 F80\n",
        "G61\nG0 X9 Y9\nG82 X10 Y10 Z-1 R2 P.5 F50\nG64 P.2\nG1 Y30 F80\nG89 Y40 Z-1 R2 P.5\nG1 Y30\nG61\nX2\n",
        "G20 G64 P.01 Q.004\nG0 X.9 Y.9\nG73 X1 Y1 Z-.1 R.1 Q.05 F5\nX2\nG1 X3 F9\n",
    ],
)
def test_cycles_that_are_written_out_go_in_the_path_mode_of_linuxcnc(tmp_path: Path, blocks: str) -> None:
    """They went in that of the program, G64. Nothing here is unrolled by the interpreter."""
    assert compensated(tmp_path, f"{HEAD}{blocks}M2\n", via=None).good
    source = calls_of(tmp_path / "in.ngc", tmp_path / "source", table(INCH), parameters(INCH), package=PACKAGE)
    written = calls_of(tmp_path / "out.ngc", tmp_path / "written", table(INCH), parameters(INCH), package=PACKAGE)
    modes = [
        [mode for mode, _ in groupby((one.modes["path"], one.modes["P"], one.modes["Q"]) for one in made if one.end)]
        for made in (source, written)
    ]
    assert modes[0] == modes[1]
    assert len(modes[0]) > 2


def check(folder: Path, text: str, scale: float = INCH, tools: str = "", suffix: str = ".tbl") -> None:
    """That the control does the same; scale: INCH, or 1 where numbers of the tables are read by the program."""
    report = compensated(folder, text, tools, suffix)
    assert report.good
    source = calls_of(folder / "in.ngc", folder / "source", table(scale), parameters(scale), package=PACKAGE)
    written = calls_of(folder / "out.ngc", folder / "written", table(INCH), parameters(INCH), package=PACKAGE)
    assert different(source, written, PRINTED + CORRECTED) == ""
    assert different(source, written[:-2] + written[-1:], PRINTED + CORRECTED)  # it is seen when one call is gone


CONTOUR = "{} X20 Y20 F400\nG1 X60\nG3 X70 Y30 J10\nG1 Y60\nX20\nY20\nG40 X0 Y0\nG0 Z50\nM5\nM30\n"


@pytest.mark.parametrize("code", ["G41 D1", "G42 D1", "G41", "G42 D3", "G41.1 D6", "G42 D7"])
def test_cutter_radius_compensation(tmp_path: Path, code: str) -> None:
    """The radius was 0, whatever the table said."""
    check(tmp_path, HEAD + "S5000 M3\nG1 Z-2 F200\n" + CONTOUR.format(code))


@pytest.mark.parametrize("code", ["G41 D1", "G42"])
def test_diameters_of_toml(tmp_path: Path, code: str) -> None:
    toml = "".join(f"[tool.{t}]\nlength = {z}\ndiameter = {d}\n" for t, (z, d) in TABLE.items())
    check(tmp_path, HEAD + CONTOUR.format(code), tools=toml, suffix=".toml")


@pytest.mark.parametrize(
    ("blocks", "scale"),
    [
        # parameters 5400 to 5413 were 0
        ("T3 M6\nO1 IF [#5400 EQ 3]\nG1 Z-3 F100\nO1 ELSE\nG1 Z0 F90\nO1 ENDIF\n", INCH),
        ("T3 M6\nG1 X[10 * #<_current_tool>] F100\n", INCH),
        ("G49\nT3 M6\nG1 X[10 + #5410 / 2] F[10 * #5410] S[10000 / #5410]\nY#5403\n", 1.0),
        ("G49\nT7 M6\nO1 IF [#5410 GT 20]\nM8\nO1 ENDIF\nG1 X3 F100\n", 1.0),
        # persistent parameters of the .var file were 0
        ("G1 X[60 + #150] F[#31 * 100]\n", INCH),
        ("#1 = 149\nG1 X#[#1 + 1] F100\nY##31\n#4 = 3\nX[#4]\n".replace("Y##31\n#4 = 3\n", "#4 = 3\nY##31\n"), INCH),
        ("#200 = 3 (set) #201 = 8\nG1 X[#200 * #201] F100\n", INCH),
        ("o<a> sub\nG1 X[#1 + #2] Y#3 F100\n#4 = 5\nG1 X#4\no<a> endsub\no<a> call [3] [#151]\n", INCH),
        ("G28\nG0 X0 Y0 Z5\n", INCH),
    ],
)
def test_parameters(tmp_path: Path, blocks: str, scale: float) -> None:
    if scale == 1.0:  # lengths of the tables are taken as they are, and so is the work offset
        text = f"G21 G90 G10 L2 P1 X{ZERO['X']} Y{ZERO['Y']} Z{ZERO['Z']}\nG54\nG0 X0 Y0 Z5\n{blocks}M2\n"
        check(tmp_path, text, scale)
    else:
        check(tmp_path, f"{HEAD}{blocks}M2\n", scale)


@pytest.mark.parametrize(
    "blocks",
    [
        "G61\nG1 X1 F100\nG61.1\nX2\nG64\nX3\nG64 P.01\nX4\nG64 P.01 Q.02\nX5\nG64 P.02 Q0\nX6\nG61\nX7\n",
        "G20\nG64 P.001\nG1 X1 F10\nG64 P.001 Q.0004\nX1.5\nG21\nX42\n",
        "G64 P.05 Q.01\nG81 X10 Y10 Z-1 R2 F50\nX20\nG80\nG1 X30 F80\n",  # cycles go in exact path mode
        "G61.1\nG73 X10 Y10 Z-1 R2 Q.5 F50\nG80\nG1 X30 F80\nG20 G83 X1 Y1 Z-.1 R.1 Q.05 F2\nG80\n",
    ],
)
def test_path_modes(tmp_path: Path, blocks: str) -> None:
    """G61 and G61.1 were exchanged, P in inches became mm, and Q was lost."""
    check(tmp_path, f"{HEAD}{blocks}M2\n")


@pytest.mark.parametrize(
    "blocks",
    [
        "M0\nG1 X1 F100\nM1\nG1 X2\nM60\nG1 X3\n",
        "S1200 M3\nG1 X1 F100\nM4 S900\nX2\nM5\nX3\nG96 D2000 S100 M3\nX4\nG97 S700\nX5\n",
        "M3 S500\nG95 G1 X1 F.1\nX2\nG94 F80\nX3\nG93 X4 F8\nX5 F4\nG94 X6 F70\nG20 G1 X1 F5\nG95 X2 F.005\n",
        "M7\nG1 X1 F100\nM8\nX2\nM9\nX3\nG4 P1.5\nX4\nM8 M3 S100\n",
        "M64 P1\nM65 P1\nM62 P0\nG1 X1 F100\nM63 P0\nX2\nM67 E0 Q1.5\nX3\nM68 E1 Q-2.25\n",
        "M48\nG1 X1 F100\nM49\nX2\nM50 P1\nX3\nM51 P1\nX4\nM52 P1\nX5\nM52 P0\nM53 P1\nX6\nM53 P0\n",
        "T3\nG1 X1 F100\nM6\nT7\nG43 H3\nG0 Z9\nM6\nG43\nG0 Z9\nG1 X2\n",
        "(MSG,next part)\nG1 X1 F100\n(a comment)\n#1 = 4\n(DEBUG,now #1)\n",
        "G18 G2 X10 Z5 I5 K0 F100\nG19 G3 Y10 Z5 J5 K0\nG17 G2 X0 Y0 R20\n",
        "M70\nG91 G1 X1 F100\nM72\nG1 X5 F100\n",
    ],
)
@pytest.mark.parametrize("end", ["M2", "M30", "M5 M9 M30"])
def test_calls_that_move_nothing(tmp_path: Path, blocks: str, end: str) -> None:
    check(tmp_path, f"{HEAD}{blocks}{end}\n")


@pytest.mark.parametrize(
    ("blocks", "words"),
    [
        (
            "G41 D9 X20 Y20 F400\nX60\nG40 X0\n",
            "line 5: this .cutter radius compensation. depends on the diameter of a tool",
        ),
        ("T9 M6\nG41 X20 Y20 F400\nX60\nG40 X0\n", "line 6: this .cutter radius compensation. depends on"),
        ("G1 X[60 + #160] F100\n", "line 5: parameter #160 is read, and its value is not known; set it in the program"),
        ("#160 = [#160 + 1]\n", "line 5: parameter #160 is read"),
        ("O1 if [#5061 GT 3]\nG1 X1 F100\nO1 endif\n", "line 5: parameter #5061 is read"),
        ("#7 = 160\nG1 X#[#7] F100\n", "line 6: what the program does here depends on a parameter"),
        ("G1 X#<_ini[trueaxis]limit> F100\n", r"line 5: #<_ini\[trueaxis\]limit> is a value of the control"),
        ("O1 if [EXISTS[#<_hal[a.b]>]]\nO1 endif\n", r"line 5: #<_hal\[a.b\]> is a value of the control"),
        ("O1 if [#<_task> EQ 1]\nG1 X1 F100\nO1 endif\n", "line 5: #<_task> is a value of the control"),
        ("O1 if [EXISTS[#<_part>]]\nO1 endif\n", "line 5: whether #<_part> exists on the control is not known"),
        ("G1 X1 F100\nM66 P0 L0\n", "line 6: M66 waits for an input"),
        ("G10 L1 P1 R3\n", "line 5: a change of the tool table"),
        ("M19 R10\n", "line 5: turning the spindle to an angle"),
        ("G38.2 Z-9 F50\n", "line 5: probing"),
        ("M3 S100\nG33 Z-5 K1\n", "line 6: motion by the turns of the spindle"),
        ("G1 X1 F100\nG1 X2 F100 @\n", "line 6: LinuxCNC refuses the program"),
    ],
)
def test_what_is_not_known_is_a_fault_of_its_line(tmp_path: Path, blocks: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        compensated(tmp_path, f"{HEAD}{blocks}M2\n", tools=table(1.0) + "T9 P9 Z20\n")


def test_the_number_of_the_tool_in_the_spindle(tmp_path: Path) -> None:
    blocks = "G1 Z-2 F200\nM61 Q3\nX20\nG43 H3\nX41 Z5\nM61 Q0\nX30\nG49\nX40 Z50\nM2\n"
    check(tmp_path, HEAD.replace("T1 M6", "T1 M6\nM61 Q7\nM61 Q1") + blocks)


@pytest.mark.parametrize(
    ("blocks", "words"),
    [
        ("G0 X#5403\n", "line 2: a parameter of the tool in the spindle is read before a tool change"),
        ("O1 if [#<_current_tool> EQ 3]\nG0 X1\nO1 endif\n", "line 2: a parameter of the tool in the spindle is read"),
        ("G43\nG0 Z5\n", "line 2: what the program does here depends on"),
        ("G41 X20 Y20 F400\nX60\nG40 X0\n", "line 2: this .cutter radius compensation. depends on"),
    ],
)
def test_the_tool_at_first_is_not_known(tmp_path: Path, blocks: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        compensated(tmp_path, f"G21 G90 G54 G1 F100 X0 Y0 Z5\n{blocks}M2\n")


def test_a_diameter_that_toml_does_not_say_is_not_read(tmp_path: Path) -> None:
    toml = "[tool.1]\nlength = 20.0\n[tool.3]\nlength = 35.0\ndiameter = 10.0\n"
    with pytest.raises(InputError, match="line 5: #5410 is a diameter, and that of T1 is not known; diameter in"):
        compensated(tmp_path, f"{HEAD}O1 if [#5410 GT 5]\nG1 X1 F100\nO1 endif\nM2\n", tools=toml, suffix=".toml")


def test_reference_points_of_control_and_spec_are_the_same(tmp_path: Path) -> None:
    (tmp_path / "in.ngc").write_text("G21 G90 F100\nG1 X1 Y2 Z3\nM2\n")
    (tmp_path / "control.var").write_text("".join(f"{n}\t{v:.6f}\n" for n, v in sorted(parameters(1.0).items())))
    settings = Settings(
        offsets=read_offsets(tmp_path / "control.var"), reference_points={"G28": {"X": 1.0, "Z": 0.0}},
        start=dict.fromkeys("XYZ", 0.0),
    )  # fmt: skip
    compensate_file(tmp_path / "in.ngc", tmp_path / "out.ngc", MACHINE, settings, via_linuxcnc=PACKAGE)
    (tmp_path / "in.ngc").write_text("G21 G90\nG91 G 28 Z0\nM2\n")
    with pytest.raises(InputError, match=r"Z of G28 is 300 there, and 0 in \[reference_points\] of the spec"):
        compensate_file(tmp_path / "in.ngc", tmp_path / "out.ngc", MACHINE, settings, via_linuxcnc=PACKAGE)


def test_motions_in_machine_coordinates_are_not_kept(tmp_path: Path) -> None:
    """All of what is written is in machine coordinates: --keep-g53 would be lost."""
    (tmp_path / "in.ngc").write_text("G21 G90\nG53 G0 Z0\nM2\n")
    with pytest.raises(InputError, match="--keep-g53: does not go with --via-linuxcnc"):
        compensate_file(
            tmp_path / "in.ngc", tmp_path / "out.ngc", MACHINE, Settings(keep_g53=True), via_linuxcnc=PACKAGE
        )


def test_lines_of_the_report_are_those_of_the_source(tmp_path: Path) -> None:
    text = HEAD + "".join(f"o<a{n}> repeat [4]\nG91 G1 X1 F100\nG90\no<a{n}> endrepeat\n" for n in range(5)) + "M2\n"
    report = compensated(tmp_path, text)
    lines = (tmp_path / "out.ngc").read_text().count("\n")
    assert lines > report.blocks_in == text.count("\n") == 25
    assert report.after is not None
    assert report.after.line in {4, *range(6, 26, 4)}
    assert not report.offsets
    assert [one.code for one in report.passed] == [6]  # what the user vouches for, and not all that is written
    with pytest.raises(InputError, match="line 5: X = 99300 is outside its travel"):
        compensated(tmp_path, HEAD + "G0 X99000\nM2\n")


def test_a_cycle_without_a_path_mode_leaves_exact_path(tmp_path: Path) -> None:
    """LinuxCNC would put the control's own mode in force again, whose tolerance is not known."""
    report = compensated(tmp_path, HEAD + "G81 X10 Y10 Z-1 R2 F50\nG80\nG1 X3\nM2\n")
    assert any("line 5: the program does not say its path mode" in note for note in report.notes)
    assert "G61\n" in (tmp_path / "out.ngc").read_text()
    assert "G64" not in (tmp_path / "out.ngc").read_text()
