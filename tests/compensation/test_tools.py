"""Tools: their length in Z under G43, and the tip of each where the program wants it."""

import re
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.compensation.analytic_machine import XyzMachine, paper_sized
from tests.compensation.control import Bench
from tests.compensation.shop_control import AXES, Control
from tests.compensation.test_command import command
from tests.compensation.test_offsets import KNOWN, both
from tests.compensation.test_uncommanded import words
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.tools import Cutter, Tool, ToolTable, read_tools
from trueaxis.io.faults import InputError

LENGTHS = {1: 80.0, 2: 215.5, 3: 31.25, 4: 80.0}
TABLE = ToolTable({number: Tool(length) for number, length in LENGTHS.items()})
ON_LINUXCNC: dict[str, Any] = {"tools": TABLE, "dialect": "linuxcnc"}
NONE = Offsets()


def tip(number: int) -> np.ndarray:
    """The tip of a tool below the spindle nose, tool frame."""
    return np.array([[0.0], [0.0], [-LENGTHS.get(number, 0.0)]])


def off(machine: XyzMachine, source: Control, written: Control) -> float:
    """Largest distance of the tip of the tool in the spindle from where it is to be, at the ends of feed blocks."""
    ends, worst = {number: at for number, _, at, _ in written.trace}, 0.0
    for number, motion, at, tool in source.trace:
        got, wanted = (np.array([[one[axis]] for axis in AXES]) for one in (ends[number], at))
        error = machine.actual(got, tip(tool)) - machine.ideal(wanted, tip(tool))
        worst = max(worst, float(np.linalg.norm(error)) if motion else 0.0)
    return worst


PROGRAM = """N1 G21 G90 G54 G49
N2 T1 M6
N3 G0 X10. Y20.
N4 G43 H1 Z50.
N5 G1 Z-2. F200
N6 X90. Y75.
N7 G0 Z50.
N8 T2 M6
N9 G55 G0 X-5. Y0.
N10 G43 Z8. H2
N11 G1 X120. F100
N12 G91 X10. Y5.
N13 G90 G49 Z300.
N14 T3
N15 G1 X11.
N16 M6
N17 G43 H3
N18 G0 X0. Y0. Z1.
N19 G1 X40. Y-40. Z-9.
"""


@pytest.mark.parametrize("dialect", [None, "fanuc", "linuxcnc"])
def test_each_tool_meets_the_tolerance(bench: Bench, dialect: Any) -> None:
    machine = paper_sized(3.0)
    written = bench.run(PROGRAM, machine, offsets=KNOWN, tools=TABLE, dialect=dialect)
    assert bench.report.good
    source, control = both(PROGRAM, written, lengths=LENGTHS)
    assert off(machine, source, control) <= 0.001
    # a tip taken at the spindle nose would be off by the errors' tilt over the length
    once = bench.run(PROGRAM.replace("M6", "M5"), machine, offsets=KNOWN, tools=TABLE, dialect="linuxcnc")
    assert once != written
    shown = bench.told
    assert "tool 1: the point 0, 0, -80 of the tool frame is compensated" in shown


def test_the_tilt_over_the_length_counts(bench: Bench) -> None:
    machine = XyzMachine({"EBX": lambda x: 1e-6 * x})  # turns the head about Y
    text = bench.run("G21 G90\nT2 M6\nG0 X100. Y0. Z0.\n", machine, tools=TABLE)
    x = float(re.findall(rb"X([-.\d]+)", text.splitlines()[2])[0])
    assert x == pytest.approx(100.0 + 1e-4 * 215.5, abs=0.00051)


@pytest.mark.parametrize("dialect", [None, "fanuc"])
def test_a_length_that_may_have_moved_z(bench: Bench, dialect: Any) -> None:
    """On some controls Z moves by the new length at once, on others with its next word."""
    program = "G21 G90\nT1 M6\nG0 X10. Y20. Z500.\nG43 H1\nX400. Y300.\nZ50.\nX1.\n"
    text = bench.run(program, paper_sized(5.0), tools=TABLE, dialect=dialect)
    assert words(text, "Z")[:2] == [3, 6]
    known = bench.run(program, paper_sized(5.0), tools=TABLE, dialect="linuxcnc")
    assert words(known, "Z")[:2] == [3, 6]  # the length is known only roughly there
    with pytest.raises(InputError, match="increment of Z beside a new tool length"):
        bench.run(f"{program}G91 G43 H2 Z1.\n", tools=TABLE, dialect=dialect)


def test_a_length_below_zero_is_noted_once(bench: Bench) -> None:
    """Touched off on the workpiece, a length is no lever: the tip would be taken to lie in the spindle."""
    program = "G21 G90\nT1 M6\nG0 X1. Y2. Z300.\nG43 H1 Z10.\nG49 Z300.\nG43 H1 Z10.\n"
    for tool, noted in ((Tool(-80.0), 1), (Tool(80.0), 0), (Tool(-80.0, point=(0.0, 0.0, -120.0)), 0)):
        bench.run(program, tools=ToolTable({1: tool}), dialect="linuxcnc")
        assert sum("below 0: the tip is taken to lie 80 mm" in note for note in bench.report.notes) == noted


@pytest.mark.parametrize("dialect", [None, "linuxcnc"])
def test_tools_of_the_same_length_may_differ_on_the_control(bench: Bench, dialect: Any) -> None:
    program = "G21 G90\nT1 M6\nG43 H1 G0 X10. Y20. Z50.\nG43 H4\nX400.\nZ30.\n"
    assert words(bench.run(program, paper_sized(9.0), tools=TABLE, dialect=dialect), "Z") == [3, 6]


def test_lengths_of_the_program(bench: Bench) -> None:
    program = "G21 G90\nG0 X1. Y2. Z300.\nG43.1 Z80.\nZ10.\n"
    text = bench.run(program, paper_sized(5.0), dialect="linuxcnc", tools=TABLE)
    other = bench.run("G21 G90\nG0 X1. Y2. Z300.\nZ90.\n", paper_sized(5.0))
    z = [float(re.findall(rb"Z([-.\d]+)", one.splitlines()[-1])[0]) for one in (text, other)]
    assert z[0] == pytest.approx(z[1] - 80.0, abs=1e-9)
    with pytest.raises(InputError, match=r"G43.1 gives tool lengths \(LinuxCNC\) or follows the tool axis"):
        bench.run(program, dialect="fanuc", tools=TABLE)


@pytest.mark.parametrize(
    ("program", "said", "kwargs"),
    [
        ("G43 H1 Z5.", "say --tools FILE", {}),
        ("G43 H7 Z5.", "tool 7 is not in --tools", {"tools": TABLE}),
        ("G43 Z5.", "G43 without H", {"tools": TABLE}),
        ("T9 M6", "tool 9 is not in --tools", {"tools": TABLE}),
        ("M6", "which tool comes is not known", {"tools": TABLE}),
        ("G43 H0 Z5.", "H0 is no length .Fanuc., or that of the tool in the spindle", {"tools": TABLE}),
        ("G43 H0 Z5.", "takes the length of the tool in the spindle, which is not known", ON_LINUXCNC),
        ("G43 Z5.", "T and M6 before it, or --spindle-tool", ON_LINUXCNC),
        ("M61", "M61 without the number of the tool", ON_LINUXCNC),
        ("M61 Q1.5", "M61 without the number of the tool", ON_LINUXCNC),
        ("M61 Q9", "tool 9 is not in --tools", ON_LINUXCNC),
        ("T1 M6 M61 Q2", "M6 and M61 in one block", ON_LINUXCNC),
        ("M61 Q1", "M61 does not mean the same on every control", {"tools": TABLE}),
        ("T1\nG0 X5. Y5. Z5.", "line 2: whether T changes the tool here is not certain", {"tools": TABLE}),
        ("T1\nG0 X5. Y5. Z5.", "certain, .*M6 behind T, if M6 changes", {"tools": TABLE, "dialect": "siemens"}),
        ("T1 M6 G0 X5. Y5. Z5.", "give the tool change a block of its own", {"tools": TABLE}),
        ("H1", "calls a tool offset", {"tools": TABLE}),
        ("G44 H1 Z5.", "shifts positions by a tool value", {"tools": TABLE}),
        ("G43 H1 Z5.", "lengthens the path", {"tools": TABLE, "dialect": "heidenhain"}),
        ("G43 H1 Z5.", "LinuxCNC adds them", {"tools": ToolTable({1: Tool(5.0, (1.0, 0.0, 0.0))})}),
        ("/G43 H1", "block with /", {"tools": TABLE}),
    ],
)
def test_what_is_not_certain(bench: Bench, program: str, said: str, kwargs: Any) -> None:
    with pytest.raises(InputError, match=said):
        bench.run(f"G21 G90\n{program}\n", **kwargs)


def test_a_cutter_location_file_has_neither_offsets_nor_tools(bench: Bench) -> None:
    for kwargs in ({"tools": TABLE}, {"offsets": KNOWN}):
        with pytest.raises(InputError, match="a CL file is in machine coordinates"):
            bench.run("FROM/0,0,0\nGOTO/1,2,3\nFINI\n", language="apt", **kwargs)


def test_a_tool_that_is_in_the_spindle_from_the_start(bench: Bench) -> None:
    bench.run("G21 G90\nG43 H2 G0 X5. Y5. Z5.\n", paper_sized(), tools=TABLE)
    assert any("tool 2 is taken to be in the spindle" in note for note in bench.report.notes)
    assert [use.number for use in bench.report.tools] == [2]


@pytest.mark.parametrize("block", ["G43 H0 G0 X5. Y5. Z5.", "G43 G0 X5. Y5. Z5.", "M61 Q2 G43 G0 X5. Y5. Z5."])
def test_the_tool_in_the_spindle_may_be_told(bench: Bench, block: str) -> None:
    """On LinuxCNC H0 and no H mean its length."""
    told = bench.run(f"G21 G90\n{block}\nG1 X500. F100\n", paper_sized(), spindle_tool=2, **ON_LINUXCNC)
    assert [use.number for use in bench.report.tools] == [2]
    assert not any("is taken to be in the spindle" in note for note in bench.report.notes)
    named = bench.run("G21 G90\nG43 H2 G0 X5. Y5. Z5.\nG1 X500. F100\n", paper_sized(), **ON_LINUXCNC)
    assert told.splitlines()[3:] == named.splitlines()[3:]


def test_the_length_follows_a_tool_number_that_is_said(bench: Bench) -> None:
    """With M61 the length in force stays until G43, which then is that of the tool."""
    program = "G21 G90\nT1 M6\nG43 G0 X5. Y5. Z5.\nM61 Q2\nG1 X500. F100\nG43 H0\nX5.\n"
    bench.run(program, paper_sized(), **ON_LINUXCNC)
    assert [use.number for use in bench.report.tools] == [1, 2]
    assert any(
        "line 5: tool 2" in note and "the length of tool 1 stays in force" in note for note in bench.report.warnings
    )


def test_the_tool_in_the_spindle_is_one_of_those_given(bench: Bench) -> None:
    for kwargs in ({"spindle_tool": 9, "tools": TABLE}, {"spindle_tool": 1}):
        with pytest.raises(ValueError, match=r"tool \d is in the spindle .*not (in|known: say) --tools"):
            bench.run("G21 G90\nG0 X1.\n", paper_sized(), **kwargs)
    with pytest.raises(InputError) as caught:  # it was told alone, before the faults of the program
        bench.run("G21 G90 G55\nG0 X1.\n", paper_sized(), spindle_tool=9, tools=TABLE)
    assert [fault.file for fault in caught.value.faults] == ["--spindle-tool", "in.nc"]
    bench.run("G21 G90\nG0 X1.\n", paper_sized(), spindle_tool=0)


def test_a_table_that_is_wrong_is_the_only_fault(tmp_path: Path) -> None:
    """With --spindle-tool it ended in a traceback."""
    (tmp_path / "tool.tbl").write_text("T1 P1 Zten\n")
    options = ["--tools", str(tmp_path / "tool.tbl"), "--spindle-tool", "1"]
    with pytest.raises(InputError, match="line 1: ") as refused:
        command(tmp_path, "G21 G90\nG0 X1. Y1. Z1.\n", *options)
    assert [fault.file for fault in refused.value.faults] == [str(tmp_path / "tool.tbl")]


def test_a_tool_that_is_missing_is_told_once(bench: Bench) -> None:
    blocks = "G21 G90 G54\nT9 M6\nG43 H9\nG0 X0. Y0. Z0.\nT9 M6\nG43 H9 Z5.\nT8 M6\n"
    with pytest.raises(InputError) as caught:
        bench.run(blocks, offsets=KNOWN, **ON_LINUXCNC)
    assert [(f.place, f.problem) for f in caught.value.faults] == [
        ("line 2", "tool 9 is not in --tools"), ("line 7", "tool 8 is not in --tools"),
    ]  # fmt: skip


def test_the_length_of_another_tool_is_said(bench: Bench) -> None:
    bench.run("G21 G90\nT1\nM6\nG43 H2 G0 X5. Y5. Z5.\n", paper_sized(), tools=TABLE)
    assert any("the length of tool 2 is put in force while tool 1" in note for note in bench.report.warnings)
    bench.run("G21 G90\nT1\nM6\nG43 H1 G0 X5. Y5. Z5.\n", paper_sized(), tools=TABLE)
    assert not any("is put in force while" in note for note in bench.report.warnings)


def test_a_table_of_linuxcnc_adds_x_and_y(bench: Bench) -> None:
    machine = XyzMachine({"EXX": lambda x: 1e-4 * x, "ECX": lambda x: 1e-5 + 0.0 * x})
    table = ToolTable({1: Tool(50.0, (3.0, 2.0, 0.0))})
    text = bench.run("G21 G90\nT1 M6\nG43 G0 X100. Y0. Z0.\n", machine, tools=table, dialect="linuxcnc")
    x = float(re.findall(rb"X([-.\d]+)", text.splitlines()[2])[0])
    # the head stands at X 103, the tip 3 mm behind it in x and 2 mm before it in y: Y+ moves the table
    assert x == pytest.approx(103.0 / 1.0001 - 3.0 + 2.0 * 1e-5, abs=0.00051)
    (use,) = bench.report.tools
    assert use.tool_point == (-3.0, 2.0, -50.0)


BLOCKS = st.lists(
    st.tuples(
        st.sampled_from(
            [
                "",
                "",
                "G0",
                "G1",
                "T1 M6",
                "T2 M6",
                "G43 H0",
                "G43",
                "G43 H1",
                "G43 H2",
                "G43 H4",
                "M61 Q3",
                "G49",
                "G54",
                "G53",
                "G91",
                "G90",
            ]
        ),
        st.tuples(*[st.one_of(st.none(), st.integers(-40000, 40000)) for _ in range(3)]),
    ),
    min_size=3,
    max_size=16,
)


@settings(max_examples=150, deadline=None)
@given(BLOCKS, st.tuples(*[st.integers(-50, 50)] * 5), st.sampled_from([None, "linuxcnc"]))
def test_no_axis_is_put_elsewhere_whatever_the_true_lengths_are(
    blocks: list[tuple[str, tuple[int | None, ...]]], wrong: tuple[int, ...], dialect: Any
) -> None:
    lines = ["N1 G21 G90 G1 F100"]
    for place, (code, values) in enumerate(blocks):
        text = "".join(f" {axis}{v / 1000:.3f}" for axis, v in zip(AXES, values, strict=True) if v is not None)
        if code == "G53":
            lines.append(f"N{2 * place + 2} G90")
        lines.append(f"N{2 * place + 3} {code}{'' if code in ('T1 M6', 'T2 M6', 'G90', 'G91') else text}")
    source = "\n".join(lines) + "\n"
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(Path(folder))
        try:
            written = bench.run(source, paper_sized(5.0), offsets=KNOWN, tools=TABLE, dialect=dialect)
        except InputError:
            return
    true = {number: length + wrong[number] / 10 for number, length in LENGTHS.items()}
    by_source, by_written = both(source, written, lengths=true)
    ends = {number: end for number, _, end, _ in by_written.trace}
    assert [number for number, *_ in by_source.trace] == list(ends)
    for number, _, end, _ in by_source.trace:
        assert max(abs(ends[number][axis] - end[axis]) for axis in AXES) < 0.3, (number, source, written.decode())


def test_files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    toml = tmp_path / "tools.toml"
    toml.write_text(
        "[tool.1]\nlength = 80.0\n[tool.2]\nlength = 5\noffset = [1.0, 2.0, 0.0]\npoint = [0.0, 0.0, -9.0]\n"
    )
    assert read_tools(toml).tools == {1: Tool(80.0), 2: Tool(5.0, (1.0, 2.0, 0.0), (0.0, 0.0, -9.0))}
    table = tmp_path / "tool.tbl"
    table.write_text("T1 P1 D6.0 Z+80.0 ;end mill\n; a comment\nt2 p2 z5 x-1.5 q0\n\n")
    assert read_tools(table).tools == {
        1: Tool(80.0, cutter=Cutter(6.0)), 2: Tool(5.0, (-1.5, 0.0, 0.0), cutter=Cutter(0.0)),
    }  # fmt: skip
    toml.write_text('[tool.1]\nlength = 80.0\ndiameter = 6.0\nname = "Mill 6"\n')
    assert read_tools(toml).number_of("MILL 6") == read_tools(toml).number_of("mill 6") == 1
    table.write_text("T1 P1 Z80 D-0.02 I95 J155 Q6\n")
    assert read_tools(toml).tools == {1: Tool(80.0, cutter=Cutter(6.0))}
    assert read_tools(table).tools == {1: Tool(80.0, cutter=Cutter(-0.02, (95.0, 155.0), 6))}
    program = "G21 G90\nT1 M6\nG0 X100. Y100.\nG43 H1 Z50.\nG1 X150. F900\n"
    for path in (toml, table):
        assert command(tmp_path, program, "--tools", str(path)) == 0
        assert "tool 1: the point 0, 0, -80" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("a.toml", "[tool.0]\nlength = 1.0\n", "is no number of a tool"),
        ("a.toml", "[tool.1]\n", "tool.1.length: is missing"),
        ("a.toml", "[tool.1]\nlength = 80000.0\n", "a length in mm"),
        ("a.toml", "[tool.1]\nlength = 80.0\noffset = [1, 2]\nwidth = 3\n", "width"),
        (
            "a.toml",
            '[tool.1]\nlength = 8.0\nname = "A"\n[tool.2]\nlength = 9.0\nname = "a"\n',
            "the name of another tool",
        ),
        ("a.toml", "[tool.1]\nlength = 8.0\nname = 7\n", "tool.1.name: is 7; a text in quotes"),
        ("a.tbl", "T1 Z80.0\nT1 Z80.0\n", "line 2: T1 is there twice"),
        ("a.tbl", "POC FMS LEN\n1 1 3.0\n", "line 1"),
        ("a.tbl", "T1 Z80000.0\n", "a table in mm"),
        ("a.tbl", "; nothing\n", "holds no tool"),
    ],
)
def test_faults_of_files(tmp_path: Path, name: str, text: str, said: str) -> None:
    (tmp_path / name).write_text(text)
    with pytest.raises(InputError, match=said):
        read_tools(tmp_path / name)


@pytest.mark.parametrize(
    ("blocks", "line"),
    [
        ("G0 X30.\nG1 Z5. F99\n", 6),
        ("G1 X30. F99\n", 5),
        ("G0 X30. Y9.\nG43 H2 Z50.\nG1 Z5. F99\n", 0),  # the usual way: above the place, then down with its length
        ("G49 Z200.\nG1 Z5. F99\n", 0),
    ],
)
def test_the_length_of_the_tool_before_is_said(bench: Bench, blocks: str, line: int) -> None:
    program = f"G21 G90\nT1 M6\nG43 H1 G0 X10. Y20. Z50.\nT2 M6\n{blocks}"
    bench.run(program, paper_sized(5.0), tools=TABLE, dialect="linuxcnc")
    said = f"line {line}: tool 2 came with a tool change and no G43 since: the length of tool 1 stays in force"
    assert (said in bench.told) == bool(line)
    assert ("stays in force" in bench.told) == bool(line)


@pytest.mark.parametrize("blocks", [1, 40])
@pytest.mark.parametrize("feed", ["G1 F100 Z{}.", "Z{}.5", "g1 z{}."])
def test_a_motion_with_the_length_of_the_tool_before_is_noted(bench: Bench, feed: str, blocks: int) -> None:
    """Alone or as the first of many, which are read together."""
    head = "G21 G90 G94\nT1 M6\nG43 H1 G0 X0. Y0. Z50.\nG1 X5. F100\nT2 M6\n"
    after = "\n".join(feed.format(k + 1) for k in range(blocks))
    bench.run(f"{head}{after}\nG43 H2 Z9.\nM30\n", XyzMachine(), tools=TABLE, pass_m=(6,), offsets=NONE)
    assert [note for note in bench.report.warnings if "line 6" in note and "tool 2" in note]
