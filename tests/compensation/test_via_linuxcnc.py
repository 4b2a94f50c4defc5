"""Programs unrolled by LinuxCNC's interpreter: the calls that are written, what is refused, and the interpreter itself.

The last tests run where LinuxCNC is installed, or unpacked into the folder that TRUEAXIS_LINUXCNC names.
"""

import json
import os
from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.compensation.control import execute
from tests.shop_programs.grade import OFFSETS, grade
from tests.shop_programs.interpreter import run
from trueaxis.compensation import via_linuxcnc
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.tools import Tool, ToolTable
from trueaxis.compensation.via_linuxcnc import unrolled
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


class FakePackage:
    """A folder that looks like the package, and what its programs would print."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.folder, self.program = folder / "package", folder / "in.ngc"
        self.program.write_text("M2\n")
        (self.folder / "usr/bin").mkdir(parents=True)
        (self.folder / "usr/bin/rs274").touch()
        (self.folder / "usr/lib/python3/dist-packages").mkdir(parents=True)
        (self.folder / "usr/lib/python3/dist-packages/gcode.so").touch()
        self.calls: list[str] = []
        self.rounds: list[list[list[object]]] = [[], []]
        monkeypatch.setattr(via_linuxcnc, "_run", self._run)
        self._round = 0

    def _run(self, command: Sequence[str], folder: Path, env: object) -> str:  # noqa: ARG002
        if command[0].endswith("rs274"):
            return "\n".join(f"  {number} N..... {call}" for number, call in enumerate(self.calls))
        self._round += 1
        return "\n".join(json.dumps(one) for one in self.rounds[self._round - 1])

    def unroll(
        self, first: list[list[object]], second: list[list[object]] | None = None, tools: ToolTable | None = None
    ) -> list[str]:
        starts = [motion("rapid", 0, at) for at in ([1.0, 2.0, 19.7], [1.5, 2.5, 31.3, 7.0, 8.0, 9.0])]
        second = second or json.loads(json.dumps(first))
        for one in second:
            if len(one) > 5:
                one[5] = [*one[5][:3], 7.0, 8.0, 9.0]  # type: ignore[index]  # no rotary axis is commanded
        self.rounds, self._round = [[starts[0], *first], [starts[1], *second]], 0
        return unrolled(self.program, self.folder, Offsets(), tools, "in.ngc").text.splitlines()[4:]


@pytest.fixture
def fake(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> FakePackage:
    return FakePackage(tmp_path, monkeypatch)


def test_calls_become_blocks_in_their_order(fake: FakePackage) -> None:
    fake.calls = [
        "USE_LENGTH_UNITS(CANON_UNITS_MM)", "CHANGE_TOOL(2)", "SET_SPINDLE_SPEED(0, 1200.0000)",
        "START_SPINDLE_CLOCKWISE(0)", "FLOOD_ON()", "STRAIGHT_TRAVERSE(1, 2)", "SET_FEED_RATE(150.0000)",
        "STRAIGHT_FEED(1)", "DWELL(0.5000)", "ARC_FEED(1)", "USE_LENGTH_UNITS(CANON_UNITS_INCHES)",
        "SET_FEED_RATE(2.0000)", "STRAIGHT_FEED(1)", "SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS, 0.0200)",
        "SET_AUX_OUTPUT_BIT(2)", "DISABLE_FEED_OVERRIDE()", "FLOOD_OFF()", "STOP_SPINDLE_TURNING(0)", "PROGRAM_END()",
    ]  # fmt: skip
    found = fake.unroll([
        motion("rapid", 1, [10.0, 20.0, 5.0]), motion("feed", 2, [10.0, 20.0, -1.0]),
        motion("arc", 3, [10.0, 20.0, -2.0], 1, -2, [15.0, 20.0]), motion("feed", 4, [11.0, 20.0, -2.0]), END,
    ], tools=ToolTable({9: Tool(), 3: Tool()}))  # fmt: skip
    assert found == [
        "T3 M6", "S1200.0000", "M3", "M8", "N1 G0 X10.0000000 Y20.0000000 Z5.0000000", "N2 G1 Z-1.0000000 F150.0000",
        "G4 P0.5000", "N3 G2 Z-2.0000000 I5.0000000 J0.0000000 P2 F150.0000", "N4 G1 X11.0000000 F50.8000",
        "G64 P0.0200", "M64 P2", "M50 P0", "M9", "M5", "M2",
    ]  # fmt: skip


def test_a_speed_along_the_surface_is_written_in_metres(fake: FakePackage) -> None:
    """What is written is in millimetres, where S of G96 is in m/min; in inches it is in ft/min, 0.3048 m each."""
    none = "1000000000000000019884624838656.0000"
    fake.calls = [
        "SET_SPINDLE_MODE(0 0.0000)", "SET_SPINDLE_MODE(0 2500.0000)", "SET_SPINDLE_SPEED(0, 200.0000)",
        "USE_LENGTH_UNITS(CANON_UNITS_INCHES)", f"SET_SPINDLE_MODE(0 {none})", "SET_SPINDLE_SPEED(0, 500.0000)",
        "SET_SPINDLE_MODE(0 0.0000)", "SET_SPINDLE_SPEED(0, 1200.0000)",
    ]  # fmt: skip
    expected = ["G96 D2500.0000 S200.0000", "G96 S152.4000", "G97", "S1200.0000"]
    assert fake.unroll([END]) == expected


def test_what_depends_on_the_start_gets_no_word(fake: FakePackage) -> None:
    fake.calls = ["STRAIGHT_TRAVERSE(1)", "STRAIGHT_TRAVERSE(2)"]
    first = [motion("rapid", 1, [10.0, 20.0, 19.7]), motion("rapid", 2, [10.0, 20.0, 5.0]), END]
    second = [motion("rapid", 1, [10.0, 20.0, 31.3]), motion("rapid", 2, [10.0, 20.0, 5.0]), END]
    assert fake.unroll(first, second) == ["N1 G0 X10.0000000 Y20.0000000", "N2 G0 Z5.0000000"]


def test_increments_from_the_start_stay_increments(fake: FakePackage) -> None:
    """They had no words at all: what was written left the motion out, with exit code 0."""
    fake.calls = ["STRAIGHT_TRAVERSE(1)", "STRAIGHT_FEED(2)", "STRAIGHT_FEED(3)"]
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
    with pytest.raises(InputError, match="line 2 moves axes by increments and to positions"):
        fake.unroll(first, second_z)
    second[2][5] = [40.0, 5.5, 28.0, 0.0, 0.0, 0.0]
    with pytest.raises(InputError, match="where the motion of line 3 goes depends on where the axes stand"):
        fake.unroll(first, second)


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
@pytest.mark.parametrize("via", [False, True])
def test_a_speed_along_the_surface_passes(tmp_path: Path, via: bool) -> None:
    program = tmp_path / "in.ngc"
    program.write_text("G20 G90\nG0 X1 Y1 Z.5\nG96 D2500 S200 M3\nG1 X2 F4\nG97 S1000\nX3\nM2\n")
    assert grade(program, PACKAGE, tmp_path, via=via).outcome == "accepted"
    written = (tmp_path / "out.ngc").read_text()
    assert ("G96 D2500.0000 S60.9600" if via else "G96 D2500 S200 M3") in written


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
def test_increments_need_to_know_where_they_start(tmp_path: Path) -> None:
    program = tmp_path / "in.ngc"
    program.write_text("G21 G91 G1 X10 F100\nG90 G0 X5 Y5 Z5\nG1 X9\nM2\n")
    graded = grade(program, PACKAGE, tmp_path, via=True)
    assert (graded.outcome, graded.reason.split(" but")[0]) == ("accepted", "with --start")
    assert graded.after < 0.0015
    assert b"G91\nN1 G1 X10." in (tmp_path / "out.ngc").read_bytes()


@pytest.mark.parametrize(
    ("calls", "motions", "words"),
    [
        (["STRAIGHT_PROBE(1)"], [["other", 4, "probing (G38)"]], "probing"),
        (["RIGID_TAP(1)"], [], "the program calls RIGID_TAP"),
        (["NURBS_FEED(5, ...)"], [], "where a spline goes depends on"),
        (["STRAIGHT_FEED(1)"], [], "more motions than the module"),
        ([], [motion("feed", 1, [1.0, 2.0, 3.0])], "more motions than rs274"),
        (["ARC_FEED(1)"], [motion("arc", 7, [1.0, 2.0, 3.0], 1, 1, [0.0, 0.0])], "where the arc of line 7 begins"),
        (["USE_TOOL_LENGTH_OFFSET(0.0 0.0 81.0)"], [], "a length of 81.0000 mm is in force before a tool change"),
    ],
)  # fmt: skip
def test_what_is_not_written_is_refused(
    fake: FakePackage, calls: list[str], motions: list[list[object]], words: str
) -> None:
    fake.calls = calls
    with pytest.raises(InputError, match=words.replace("(", r"\(").replace(")", r"\)")):
        fake.unroll([*motions, END], tools=ToolTable({1: Tool(length=80.0)}))


def test_faults_of_the_interpreter(fake: FakePackage) -> None:
    with pytest.raises(InputError, match=r"line 9: LinuxCNC refuses the program: Unknown g code"):
        fake.unroll([["end", 9, 5, "Unknown g code used"]])
    with pytest.raises(InputError, match="broke off"):
        fake.unroll([])
    with pytest.raises(InputError, match="depends on where the axes stand"):
        fake.unroll([motion("feed", 1, [1.0]), END], [END])


def test_offsets_are_to_be_known_exactly(fake: FakePackage) -> None:
    """What is written is in machine coordinates: an offset that is 10 mm wrong would put the tool 10 mm wrong."""
    fake.calls = ["SET_G5X_OFFSET(2, 0.0, 0.0)"]
    with pytest.raises(
        InputError, match=r"G55: where its zero is is not known; say --offset G55=X\.\.,Y\.\.,Z\.\., exactly"
    ):
        fake.unroll([END])
    ranged = Offsets({"G55": {"X": (0.0, 500.0)}}, {"X": 1.0}, "G55")
    fake.rounds, fake._round = [[], []], 0
    with pytest.raises(InputError) as caught:
        unrolled(fake.program, fake.folder, ranged, None, "in.ngc")
    assert [fault.problem.split(" does")[0] for fault in caught.value.faults] == ["a range", "G92 in force"]


def test_where_linuxcnc_is_not_installed(tmp_path: Path) -> None:
    program = tmp_path / "in.ngc"
    program.write_text("M2\n")
    with pytest.raises(InputError, match="linuxcnc-uspace"):
        unrolled(program, tmp_path, Offsets(), None, "in.ngc")


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
    assert "T1 M6" in written
    assert "M3" in written


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
def test_tools_keep_their_numbers_and_lengths(tmp_path: Path) -> None:
    """The interpreter names tools by their place in the table."""
    program = tmp_path / "in.ngc"
    program.write_text("G21 G90\nT7 M6\nG43 H7\nG0 Z5\nT3 M6\nG43 H3\nG0 Z6\nM2\n")
    tools = ToolTable({7: Tool(length=70.0), 3: Tool(length=30.0)})
    text = unrolled(program, PACKAGE, AT_ZERO, tools, "in").text
    assert [line for line in text.splitlines() if line[0] in "TN"] == [
        "T7 M6", "N4 G0 Z75.0000000", "T3 M6", "N7 G0 Z36.0000000",
    ]  # fmt: skip


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
def test_optional_blocks_are_as_the_switch_stands(tmp_path: Path) -> None:
    program = tmp_path / "in.ngc"
    program.write_text("G21 G90\nG0 X1\n/G0 X2\n/M3 S5\nM2\n")
    texts = {way: unrolled(program, PACKAGE, AT_ZERO, None, "in", way).text for way in ("run", "skip")}
    assert "X2.0" in texts["run"]
    assert "M3" in texts["run"]
    assert "X2.0" not in texts["skip"]
    assert "M3" not in texts["skip"]
    with pytest.raises(InputError, match="line 3: whether a block with / is run"):
        unrolled(program, PACKAGE, AT_ZERO, None, "in")


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
def test_an_axis_that_is_never_commanded_gets_no_word(tmp_path: Path) -> None:
    program = tmp_path / "in.ngc"
    program.write_text("G21 G90\nG0 X1 Y2\nG0 X3\nM2\n")
    at = Offsets({"G54": {a: (v, v) for a, v in zip("XYZ", OFFSETS[0], strict=True)}})
    text = unrolled(program, PACKAGE, at, None, "in").text
    assert "Z" not in text.split("G59.3")[1]
    (tmp_path / "out.ngc").write_text(text)
    assert run(tmp_path / "out.ngc", PACKAGE, {}, OFFSETS).ends[-1, :2].tolist() == pytest.approx([303.0, -198.0])
    assert execute(text.replace("G10 L2 P9 X0 Y0 Z0\n", "").encode())[:2, -1].tolist() == pytest.approx([303.0, -198.0])
