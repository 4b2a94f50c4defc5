"""Programs unrolled by LinuxCNC's interpreter: the calls that are written, what is refused, and the interpreter itself.

The last tests run where LinuxCNC is installed, or unpacked into the folder that TRUEAXIS_LINUXCNC names.
"""

import json
import os
from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.compensation.analytic_machine import XyzMachine, paper_sized
from tests.compensation.control import execute
from tests.shop_programs.grade import OFFSETS, grade
from tests.shop_programs.interpreter import run
from trueaxis.cli.main import main
from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.linuxcnc import interpreter as via_linuxcnc
from trueaxis.compensation.linuxcnc.interpreter import unroll
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.tools import Tool, ToolTable
from trueaxis.io.faults import InputError

PACKAGE = Path(os.environ.get("TRUEAXIS_LINUXCNC", "/"))
INSTALLED = (PACKAGE / "usr/bin/rs274").is_file()
AT_ZERO = Offsets({"G54": dict.fromkeys("XYZ", (0.0, 0.0))}, {}, "G54")
END = ["end", 9, 0, ""]
TOOL = ToolTable({1: Tool(length=20.0)})


def motion(
    kind: str, line: int, end: Sequence[float], plane: int = 0, turns: int = 0, centre: Sequence[float] = ()
) -> list[object]:
    return [kind, line, plane, turns, list(centre), [*end, *(0.0,) * (6 - len(end))]]


def call(name: str, *given: object, line: int = 1) -> list[object]:
    return ["call", line, name, *given]


class FakePackage:
    """A folder that looks like the package, and what the interpreter would ask for in its three runs."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.folder, self.program = folder / "package", folder / "in.ngc"
        self.program.write_text("M2\n")
        (self.folder / "usr/lib/python3/dist-packages").mkdir(parents=True)
        (self.folder / "usr/lib/python3/dist-packages/gcode.so").touch()
        self.rounds: list[list[list[object]]] = []
        monkeypatch.setattr(via_linuxcnc, "_run", lambda *_: self.rounds.pop(0))

    def unroll(
        self, first: list[list[object]], second: list[list[object]] | None = None, tools: ToolTable | None = None,
        third: list[list[object]] | None = None, diameters: bool = False,
    ) -> list[str]:  # fmt: skip
        starts = [motion("rapid", 0, at) for at in ([1.0, 2.0, 19.7], [1.5, 2.5, 31.3, 7.0, 8.0, 9.0])]
        second = second or json.loads(json.dumps(first))
        for one in second:
            if one[0] in ("rapid", "feed", "arc"):
                one[5] = [*one[5][:3], 7.0, 8.0, 9.0]  # type: ignore[index]  # no rotary axis is commanded
        third = [starts[0], *(third or first)]
        self.rounds = [[starts[0], *first], [starts[1], *second], third, third if diameters else [starts[0], *first]]
        known = Offsets({"G54": dict.fromkeys("XYZ", (0.0, 0.0))})
        return unroll(self.program, self.folder, known, tools, "in.ngc").text.splitlines()[4:]


@pytest.fixture
def fake(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> FakePackage:
    return FakePackage(tmp_path, monkeypatch)


def test_calls_become_blocks_in_their_order(fake: FakePackage) -> None:
    found = fake.unroll([
        call("USE_LENGTH_UNITS", 2), call("SELECT_TOOL", 3), call("START_CHANGE"), call("STOP_SPINDLE_TURNING", 0),
        call("CHANGE_TOOL", 3), call("SET_SPINDLE_SPEED", 0, 1200.0), call("START_SPINDLE_CLOCKWISE", 0, 1),
        call("FLOOD_ON"), motion("rapid", 1, [10.0, 20.0, 5.0]), call("SET_FEED_RATE", 150.0),
        motion("feed", 2, [10.0, 20.0, -1.0]), call("DWELL", 0.5),
        motion("arc", 3, [10.0, 20.0, -2.0], 1, -2, [15.0, 20.0]), call("USE_LENGTH_UNITS", 1),
        call("SET_FEED_RATE", 50.8), motion("feed", 4, [11.0, 20.0, -2.0]),
        call("SET_MOTION_CONTROL_MODE", 3, 0.001), call("SET_NAIVECAM_TOLERANCE", 0.00003),
        call("SET_MOTION_CONTROL_MODE", 2, 0.0), call("SET_MOTION_CONTROL_MODE", 1, 0.0),
        call("SET_AUX_OUTPUT_BIT", 2), call("DISABLE_FEED_OVERRIDE"), call("MIST_OFF"), call("FLOOD_OFF"),
        call("SET_MOTION_OUTPUT_VALUE", 1, 0.25), call("ENABLE_ADAPTIVE_FEED"), call("MESSAGE", "hello"),
        call("PALLET_SHUTTLE"), call("PROGRAM_STOP"), call("PROGRAM_STOP"), call("OPTIONAL_PROGRAM_STOP"),
        call("SET_FEED_MODE", 0, 1), call("SET_FEED_MODE", 0, 0, line=9), call("STOP_SPINDLE_TURNING", 0, line=9),
        call("MIST_OFF", line=9), call("PALLET_SHUTTLE", line=9), call("PROGRAM_END", line=9), END,
    ], tools=ToolTable({9: Tool(), 3: Tool()}))  # fmt: skip
    assert found == [
        "T3", "M6", "S1200", "M3", "M8", "N1 G0 X10.0000000 Y20.0000000 Z5.0000000", "N2 G1 Z-1.0000000 F150",
        "G4 P0.5", "N3 G2 Z-2.0000000 I5.0000000 J0.0000000 P2 F150", "N4 G1 X11.0000000 F50.8",
        "G64 P0.0254 Q0.000762", "G61", "G61.1", "M64 P2", "M50 P0", "M9", "M67 E1 Q0.25", "M52 P1", "(MSG,hello)",
        "M60", "M0", "M1", "G95", "M9", "M30",
    ]  # fmt: skip


def test_turns_of_rotary_axes_are_in_degrees_a_minute(fake: FakePackage) -> None:
    """Under G20 too: F100 of a rotary axis became F2540."""
    rotary = [1.0, 2.0, 3.0, 90.0]
    first = [
        call("USE_LENGTH_UNITS", 1), motion("rapid", 1, [1.0, 2.0, 3.0, 0.0, 0.0, 0.0]),
        call("SET_FEED_RATE", 2540.0), motion("feed", 2, rotary), motion("feed", 3, [5.0, 2.0, 3.0, 90.0]), END,
    ]  # fmt: skip
    fake.rounds = [[motion("rapid", 0, at), *first] for at in ([7.0] * 6, [8.0] * 6, [7.0] * 6)]
    text = unroll(fake.program, fake.folder, AT_ZERO, None, "in").text.splitlines()[5:]
    assert text == ["N2 G1 A90.0000000 F100", "N3 G1 X5.0000000 F2540"]


def test_a_speed_along_the_surface_is_written_in_metres(fake: FakePackage) -> None:
    """What is written is in millimetres, where S of G96 is in m/min; in inches it is in ft/min, 0.3048 m each."""
    expected = ["G96 D2500 S200", "G96 S152.4", "G97", "S1200"]
    assert fake.unroll([
        call("SET_SPINDLE_MODE", 0, 0.0), call("SET_SPINDLE_MODE", 0, 2500.0), call("SET_SPINDLE_SPEED", 0, 200.0),
        call("USE_LENGTH_UNITS", 1), call("SET_SPINDLE_MODE", 0, 1e30), call("SET_SPINDLE_SPEED", 0, 500.0),
        call("SET_SPINDLE_MODE", 0, 0.0), call("SET_SPINDLE_SPEED", 0, 1200.0), END,
    ]) == expected  # fmt: skip


def test_what_depends_on_the_start_gets_no_word(fake: FakePackage) -> None:
    first = [motion("rapid", 1, [10.0, 20.0, 19.7]), motion("rapid", 2, [10.0, 20.0, 5.0]), END]
    second = [motion("rapid", 1, [10.0, 20.0, 31.3]), motion("rapid", 2, [10.0, 20.0, 5.0]), END]
    assert fake.unroll(first, second) == ["N1 G0 X10.0000000 Y20.0000000", "N2 G0 Z5.0000000"]


def test_increments_from_the_start_stay_increments(fake: FakePackage) -> None:
    """They had no words at all: what was written left the motion out, with exit code 0."""
    ends = [[11.0, 2.0, 19.7], [11.0, 5.0, 17.7], [40.0, 5.0, 17.7]]
    others = [[11.5, 2.5, 31.3], [11.5, 5.0, 29.3], [40.0, 5.0, 29.3]]
    first, second = (
        [motion("rapid" if n == 0 else "feed", n + 1, at) for n, at in enumerate(of)] + [END] for of in (ends, others)
    )
    second_z = [json.loads(json.dumps(one)) for one in second]
    second[1][5] = [11.5, 5.5, 29.3, 0.0, 0.0, 0.0]
    second[2][5] = [40.0, 5.5, 29.3, 0.0, 0.0, 0.0]
    assert fake.unroll(first, second) == [
        "G91", "N1 G0 X10.0000000", "N2 G1 Y3.0000000 Z-2.0000000", "G90", "N3 G1 X40.0000000",
    ]  # fmt: skip
    with pytest.raises(InputError, match="line 2: moves axes by increments and to positions"):
        fake.unroll(first, second_z)
    second[2][5] = [40.0, 5.5, 28.0, 0.0, 0.0, 0.0]
    with pytest.raises(InputError, match="line 3: where this motion goes depends on where the axes stand"):
        fake.unroll(first, second)


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
@pytest.mark.parametrize("via", [False, True])
def test_a_speed_along_the_surface_passes(tmp_path: Path, via: bool) -> None:
    program = tmp_path / "in.ngc"
    program.write_text("G20 G90\nG0 X1 Y1 Z.5\nG96 D2500 S200 M3\nG1 X2 F4\nG97 S1000\nX3\nM2\n")
    assert grade(program, PACKAGE, tmp_path, via=via).outcome == "accepted"
    written = (tmp_path / "out.ngc").read_text()
    assert ("G96 D2500 S60.96" if via else "G96 D2500 S200 M3") in written


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
@pytest.mark.parametrize("via", [None, PACKAGE])
def test_rapids_to_the_end_of_the_travel_are_no_fault(tmp_path: Path, via: Path | None) -> None:
    """G53 is kept: what a program of the shop ends with went beyond the travel when it was compensated."""
    (tmp_path / "in.ngc").write_text("G21 G90 G54\nG0 X1 Y1 Z1\nG1 X9 F100\nG53 G0 Z600\nM2\n")
    made = paper_sized()
    machine = XyzMachine(made.curves, made.squareness, travel=dict.fromkeys("XYZ", (-600.0, 600.0)))
    settings = Settings(dialect="linuxcnc", offsets=Offsets({"G54": dict.fromkeys("XYZ", (300.0, 300.0))}, {}, "G54"))
    report = compensate_file(tmp_path / "in.ngc", tmp_path / "out.ngc", machine, settings, via_linuxcnc=via)
    assert report.good
    assert "G53 G0" in (tmp_path / "out.ngc").read_text()


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
def test_increments_need_to_know_where_they_start(tmp_path: Path) -> None:
    program = tmp_path / "in.ngc"
    program.write_text("G21 G91 G1 X10 F100\nG90 G0 X5 Y5 Z5\nG1 X9\nM2\n")
    graded = grade(program, PACKAGE, tmp_path, via=True)
    assert (graded.outcome, graded.reason.split(" but")[0]) == ("accepted", "with --start")
    assert graded.after < 0.0015
    assert b"G91\nN1 G1 X10." in (tmp_path / "out.ngc").read_bytes()


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
@pytest.mark.parametrize("via", [False, True])
def test_the_tool_in_the_spindle_may_be_told(tmp_path: Path, via: bool) -> None:
    """LinuxCNC with that tool in its spindle judges; H0 and no H are its length, and M61 names another."""
    program = tmp_path / "in.ngc"
    length = "[#5403 + 5]" if via else "85"
    program.write_text(
        "G21 G90 G54\nG43 H0\nG0 X1 Y1 Z1\nG1 X200 F100\nM61 Q40\nG0 X210 Z2\nG1 X300\nG43\n"
        f"G0 Z{length}\nG1 X400 Z9\nT2 M6\nG0 X5 Y5 Z5\nM61 Q50\nG43 H0\nG0 X7 Z7\nG1 X50\nM2\n"
    )
    graded = grade(program, PACKAGE, tmp_path, via=via)
    assert (graded.outcome, graded.reason) == ("accepted", "with --start, --pass-m 0,1,6 and --spindle-tool")
    assert graded.after < 0.0015 < graded.before
    assert b"M61 Q40" in (tmp_path / "out.ngc").read_bytes()


@pytest.mark.parametrize(
    ("made", "words"),
    [
        (["other", 4, "probing (G38)"], "line 4: probing"),
        (call("WAIT", 0, 1, 0, 0.0, line=4), "line 4: M66 waits for an input"),
        (call("ORIENT_SPINDLE", 0, 90.0, 0, line=4), "line 4: turning the spindle to an angle (M19)"),
        (call("SET_TOOL_TABLE_ENTRY", 1, 1, line=4), "line 4: a change of the tool table (G10 L1, L10, L11)"),
        (call("START_SPEED_FEED_SYNCH", 0, 1.0, False, line=4), "line 4: motion by the turns of the spindle (G33"),
        (call("ANOTHER", 1, line=4), "line 4: the program calls ANOTHER"),
        (call("NURBS_FEED", 5, line=4), "line 4: where a spline goes depends on"),
        (motion("arc", 7, [1.0, 2.0, 3.0], 1, 1, [0.0, 0.0]), "line 7: where this arc begins depends on"),
        (call("USE_TOOL_LENGTH_OFFSET", 0.0, 0.0, 81.0, line=4), "a length of 81.0000 mm is in force before a tool"),
    ],
)  # fmt: skip
def test_what_is_not_written_is_refused(fake: FakePackage, made: list[object], words: str) -> None:
    with pytest.raises(InputError, match=words.replace("(", r"\(").replace(")", r"\)")):
        fake.unroll([made, END], tools=ToolTable({1: Tool(length=80.0)}))


def test_faults_of_the_interpreter(fake: FakePackage) -> None:
    with pytest.raises(InputError, match=r"line 9: LinuxCNC refuses the program: Unknown g code"):
        fake.unroll([["end", 9, 5, "Unknown g code used"]])
    with pytest.raises(InputError, match="broke off"):
        fake.unroll([])
    with pytest.raises(InputError, match="this version of LinuxCNC is not known: no call FLOOD_ON"):
        fake.unroll([["end", 0, -1, "FLOOD_ON"]])
    with pytest.raises(InputError, match="line 3: what the program does depends on where the axes stand"):
        fake.unroll([motion("feed", 3, [1.0]), END], [END])


def test_other_values_of_what_is_not_known_may_change_nothing(fake: FakePackage) -> None:
    first = [motion("feed", 3, [1.0]), END]
    with pytest.raises(InputError, match="line 3: what the program does here depends on a parameter"):
        fake.unroll(first, third=[motion("feed", 3, [1.1]), END])
    with pytest.raises(InputError, match="line 3: what the program does here depends on a parameter"):
        fake.unroll(first, third=[["end", 3, 5, "Unknown g code used"]])
    with pytest.raises(InputError, match=r"line 3: this \(cutter radius compensation\) depends on the diameter"):
        fake.unroll(first, third=[motion("feed", 3, [1.1]), END], diameters=True)


def test_offsets_are_to_be_known_exactly(fake: FakePackage) -> None:
    """What is written is in machine coordinates: an offset that is 10 mm wrong would put the tool 10 mm wrong."""
    made = [call("SET_G5X_OFFSET", 2), motion("rapid", 4, [1.0, 2.0, 3.0]), END]
    with pytest.raises(
        InputError, match=r"line 4: G55: where its zero lies is not known; say --offset G55=X\.\.,Y\.\.,Z\.\., exactly"
    ):
        fake.unroll(made)
    ranged = Offsets({"G55": {"X": (0.0, 500.0)}}, {}, "G55")
    fake.rounds = [[motion("rapid", 0, [0.0] * 3), *made]] * 3
    with pytest.raises(InputError, match="a range does not go with --via-linuxcnc"):
        unroll(fake.program, fake.folder, ranged, None, "in.ngc")
    with pytest.raises(InputError, match="G92 in force"):
        unroll(fake.program, fake.folder, Offsets({}, {"X": 1.0}), None, "in.ngc")


def test_a_file_behind_the_option_is_the_program(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It was taken for the folder of LinuxCNC, and the program was missing."""
    (tmp_path / "in.ngc").write_text("M2\n")
    words = ["compensate", str(tmp_path / "no.toml"), "--errors", "no.json", "--out", str(tmp_path / "out.ngc")]
    assert main([*words, "--via-linuxcnc", str(tmp_path / "in.ngc")]) == 2
    assert "no.toml: there is no such file" in capsys.readouterr().err


def test_where_linuxcnc_is_not_installed(tmp_path: Path) -> None:
    program = tmp_path / "in.ngc"
    program.write_text("M2\n")
    with pytest.raises(InputError, match="linuxcnc-uspace"):
        unroll(program, tmp_path, Offsets(), None, "in.ngc")


MACRO = """\
G21 G90 G17
T1 M6
G43 H1
G0 X0 Y0
G0 Z5
S1000 M3
#<depth> = 2
o100 sub
G1 Z[0 - #1] F200
G1 X[10 * #1]
G3 X[10 * #1] Y20 J10
G1 X0 Y0
o100 endsub
o100 call [1]
o100 call [#<depth>]
G0 Z5
G41.1 D6 G1 X20 Y-10
X40
Y20
G40 G0 Z20
M5
M2
"""


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
def test_macros_and_cutter_compensation_are_right_along_the_path(tmp_path: Path) -> None:
    program = tmp_path / "in.ngc"
    program.write_text(MACRO)
    graded = grade(program, PACKAGE, tmp_path, via=True)
    assert (graded.outcome, graded.kind) == ("accepted", "macro")
    assert graded.before > 0.01
    assert graded.after < 0.0014
    written = (tmp_path / "out.ngc").read_text()
    assert "T1\nM6" in written
    assert "M3" in written


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
def test_tools_keep_their_numbers_and_lengths(tmp_path: Path) -> None:
    """The interpreter names tools by their place in the table."""
    program = tmp_path / "in.ngc"
    program.write_text("G21 G90\nT7 M6\nG43 H7\nG0 Z5\nT3 M6\nG43 H3\nG0 Z6\nM2\n")
    tools = ToolTable({7: Tool(length=70.0), 3: Tool(length=30.0)})
    text = unroll(program, PACKAGE, AT_ZERO, tools, "in").text
    assert [line for line in text.splitlines() if line[0] in "TN" or line == "M6"] == [
        "T7", "M6", "N4 G0 Z75.0000000", "T3", "M6", "N7 G0 Z36.0000000",
    ]  # fmt: skip


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
def test_optional_blocks_are_as_the_switch_stands(tmp_path: Path) -> None:
    program = tmp_path / "in.ngc"
    program.write_text("G21 G90\nG0 X1\n/G0 X2\n/M3 S5\nM2\n")
    texts = {way: unroll(program, PACKAGE, AT_ZERO, None, "in", way).text for way in ("run", "skip")}
    assert "X2.0" in texts["run"]
    assert "M3" in texts["run"]
    assert "X2.0" not in texts["skip"]
    assert "M3" not in texts["skip"]
    with pytest.raises(InputError, match="line 3: whether a block with / is run"):
        unroll(program, PACKAGE, AT_ZERO, None, "in")


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
def test_an_axis_that_is_never_commanded_gets_no_word(tmp_path: Path) -> None:
    program = tmp_path / "in.ngc"
    program.write_text("G21 G90\nG0 X1 Y2\nG0 X3\nM2\n")
    at = Offsets({"G54": {a: (v, v) for a, v in zip("XYZ", OFFSETS[0], strict=True)}})
    text = unroll(program, PACKAGE, at, None, "in").text
    assert "Z" not in text.split("G59.3")[1]
    (tmp_path / "out.ngc").write_text(text)
    assert run(tmp_path / "out.ngc", PACKAGE, {}, OFFSETS).ends[-1, :2].tolist() == pytest.approx([303.0, -198.0])
    assert execute(text.replace("G10 L2 P9 X0 Y0 Z0\n", "").encode())[:2, -1].tolist() == pytest.approx([303.0, -198.0])
