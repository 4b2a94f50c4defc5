"""Blocks read and written in runs come out as they do one by one."""

import dataclasses
import re
from unittest.mock import patch

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests.compensation.analytic_machine import XyzMachine, paper_sized
from tests.compensation.control import Bench
from tests.compensation.few_blocks import runs_of
from trueaxis.compensation.nc.plain_text import plain_text
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.report import CompensationReport
from trueaxis.io.faults import InputError

LIMITS = dict.fromkeys("XYZ", (-2000.0, 2000.0))
NUMBERS = st.one_of(
    st.integers(-9000, 9000).map(lambda n: f"{n / 100:.3f}"),
    st.integers(-90, 90).map(lambda n: f"{n}."),
    st.sampled_from(["0.", "-.5", "+1.25", ".125", "-0.000", "7", "0", "00012.50", "12.3456789", "2e3", "1.2.3", "-"]),
)
WORDS = st.tuples(*[st.one_of(st.none(), NUMBERS)] * 3)
GAPS = st.sampled_from([" ", " ", " ", "", "  ", "\t"])
AXES_ALONE = st.tuples(WORDS, GAPS, st.sampled_from(["", "", "", "", " ", "\t "])).map(
    lambda made: made[1].join(f"{a}{made[2]}{n}" for a, n in zip("XYZ", made[0], strict=True) if n is not None)
)
LEADS = st.sampled_from(
    [
        "",
        "",
        "N7 ",
        "N12",
        "G1 ",
        "G01",
        "G0",
        "N3 G1 ",
        "N4G00 ",
        "G2 ",
        "G001",
        "N1234567890 ",
        "G10 ",
        "G90 ",
        "N5 G0 G90 ",
        "G90G1",
        "G17 G90 G1 ",
        "G54 G1 ",
        "G91 G1 ",
        "G1 G0 ",
        "G40 ",
        "G1 G1 ",
        "G94 S9 ",
        "G53 G0 ",
        "F90 ",
        "G1 F95",
        "N5 G3F80.",
        "F1 F2 ",
        "G0 F100. G1 ",
        "F70 G1",
        "G90 F60 G1 ",
        "F 8. ",
        "G 1 ",
        "X 1.5 ",
        "N 5 ",
    ]
)
TAILS = st.sampled_from(
    ["", "", " F300", "F300.", " F.5", "  F450 ", " ", " F", " F1e3", " F-3", " F2F3", " F9 S100", " M8", " G90",
     " X1.", "Y2.5F3", "F7 Z1."]
)  # fmt: skip
PLAIN = st.one_of(AXES_ALONE, st.tuples(LEADS, AXES_ALONE, TAILS).map("".join))
ASIDE = [  # what moves nothing, and what it is next to
    "S500 M3", "M3 S500", "M5", "N4 M9", "M5 M9", "S1000.", "S1 S2", "M8 F90", "F90 M8", "G90 G94 G17", "N3 G17 G90",
    "G54 G90", "G90 G91", "G21 G40 G64", "G17 G18", "G1 M8", "G0 G1", "G1 S300 M3", "M3 M30", "T3",
    "T1 M6", "M03.5", "M7 M8 (both)",
    "G94 M3 S100 G90", "G61", "G59", "G55 M3", "M", "S-5", "T1", "T2 M6", "G4 P1", "S2e3", "m8", "s100m3", "G95 F.1",
]  # fmt: skip
OTHER = st.sampled_from(
    ["G0", "G1", "G91", "G90", "G20", "G21", "G0 X5. Y5. Z5.", "G1 F300", "N7 X1. Y2. F90", "(text)", "", "M6", "M0",
     "G2 X5. Y5. R90.", "G54", "G55", "G93", "G94", "M30", "Y1. X2.", "x3. y4.", "/X1.", "A5.", "X1. (end)", " X3.",
     "g1 x2.5 y3.",
     "g1x2.5", "g0z5.f30", "G1Z-.1F24", "g1f20y3.", "N3g1x4.y.5",
     "X4. ; words", "X4. ;Y5.", "(py,1)", "X5. (py,1)", "; alone", "N9", "N9 G0", "G3", "F250.",
     "G2 F90", "X1. (a) Y2.", "X1. (a) (b)", "G17", "G18", "G19", "G1 X9. Y8. (to the corner) ", "M8", "G95",
     "G18 X5.", *ASIDE]
)  # fmt: skip
# from anywhere: by R to places far less than 2 R apart, full circles, half circles where G91 is in force; no arcs
ARC_CODES = st.sampled_from(
    [
        "G2 ",
        "G03 ",
        "N4 G3 ",
        "N5G02",
        "",
        "",
        "N8 ",
        "G3",
        "g2 ",
        "G17 G2 ",
        "G90G3",
        "G2 G90 ",
        "G2 F40. ",
        "G3 R280. ",
    ]
)
ARCS = st.one_of(
    st.tuples(
        ARC_CODES,
        AXES_ALONE,
        st.sampled_from([" R300.", "R300.", " R300. F90.", " R-300.", " r250.5", "R300.X9.", " R 300. "]),
    ).map("".join),
    st.tuples(
        ARC_CODES,
        st.sampled_from(["", "Z4.5 ", "X0. Y0.", "X10. Y0. ", "X10.0 Z1.", "X0. Z10. "]),
        st.sampled_from(
            [
                "I5.",
                "J-5.125",
                "I5. J0.",
                "I5. K0",
                "I3. J4. F200",
                "K4.",
                "J2.K3.",
                "I5. J0. R5.",
                "R0.",
                "I 5. J -0.",
                "I\t5.",
            ]
        ),
        st.sampled_from(["", "", " (round)", "  ", " P2"]),
    ).map("".join),
)
# a cycle, and blocks that go on with it or end it
CYCLES = st.sampled_from([
    "G98 G81 X5. Y6. Z-20. R-10. F100", "G99 G81 X5. Y6. Z-20. R-10.", "N5 G83 X1. Z-20. R-10. Q3.",
    "G73 X2. Z-30. R5. Q8.", "G82 X1. Z-20. R-10. P0.5", "G85 Y1. Z-20. R-10.", "G89 X3. Z-20. R-10. P1",
    "M3\nG86 X3. Z-20. R2.", "G99 G86 X3. Z-20. R2.", "G98", "G99", "G80", "G80\nG0 Z50.", "Z-15.", "R-5.", "X5. L3",
    "G91 X5. K2", "G90", "G0 Z60.", "G17", "G18 G81 X1. Z2. Y-5. R3.",
    "M4", "M5", "M8", "S300 M3", "G90 G17", "G98 X4.", "G17 X6. Y1.",
])  # fmt: skip
PLACES = st.one_of(
    st.tuples(
        *[st.integers(-90, 90)] * 2, st.sampled_from(["X{0}.5 Y{1}.", "N7X{0}.Y{1}.2 ", "Y{1}.", "X{0}."])
    ).map(lambda place: place[2].format(*place)),
    st.sampled_from([
        "X1. (hole)", "(between)", "", "N6", "X1. F90", "x3.5 y2.", "X1.Y2.", " X4. Y5.", "N8X2.", "X5. Z-12.",
        "  N5  X3. ",
    ]),
)  # fmt: skip
# the first block, said again
AGAIN = st.sampled_from([
    "{}", "{}", "N9 {}", "{} F100", "{} F100.", "{}X1.", "F100. {}", "{} Z-20.", "{} Q3", "G98 {}", "G99 {}",
    # behind an end of the cycle, where it may be another
    "G80\nG0 Z30.\n{}", "G80\nG0 Z30.\n{}", "G80\nG0 Z30.\n{}", "N1 G80\nN2 G0 X3. Y4.\nN3 G0 Z30. \nN4 {}",
    "G80\nG0 Z20.\n(up)\nG0 Z30.\n{} F90.", "G80\nG0 Z20.\n{}", "G80\n{}", "G80\nG0Z30.\n{}", "G80\nG0 Z30. F50.\n{}",
    "G80 M9\nG0 Z30.\n{}", "G80\nG0 Z30.\nX5.\n{}", "G80\nG0 Z-10.\n{}", "G80\nG0 X1.\n{}", "G80\nG80\nG0 Z30.\n{}",
])  # fmt: skip
DRILLED = st.tuples(
    st.sampled_from(["\n", "\n", "\r\n"]),
    st.lists(
        st.one_of(PLACES, PLACES, PLACES, PLACES, PLACES, PLACES, AGAIN, AGAIN, CYCLES, PLAIN), min_size=6, max_size=40
    ).flatmap(lambda lines: CYCLES.map(lambda first: [first, *(line.replace("{}", first) for line in lines)])),
    st.booleans(),
)
TEXTS = st.tuples(
    st.sampled_from(["\n", "\n", "\r\n"]),
    st.lists(st.one_of(PLAIN, PLAIN, PLAIN, PLAIN, ARCS, ARCS, OTHER), min_size=4, max_size=40),
    st.booleans(),
)
OFFSETS = Offsets({"G54": {"X": (5.0, 5.0)}, "G55": {"X": (7.0, 7.0), "Z": (-3.0, -3.0)}}, {}, "G54")
HEAD = ["G21 G90 G94", "G0 X10. Y20. Z30.", "G1 X11. Y20. F500"]
WITHOUT_Z = ["G21 G90 G94", "G0 X10. Y20.", "G1 X11. Y20. F500"]
WITHOUT_Y = ["G90 G94", "G0 Z10.", "X10.", "M3", "G1 X11. F500"]


def outcome(bench: Bench, text: str, fewest: int, options: dict[str, object]) -> tuple[object, ...]:
    """What is written or refused, and the report, with runs of no fewer blocks."""
    of = paper_sized(3.0)
    machine = XyzMachine(of.curves, of.squareness, travel=LIMITS)
    with runs_of(fewest):
        try:
            written = bench.run(text, machine, **options)  # type: ignore[arg-type]
        except InputError as error:
            return tuple(error.faults)
    return written, *figures(bench.report)


def figures(report: CompensationReport) -> list[object]:
    """All of a report, numbers to nine digits."""

    def rounded(value: object) -> object:
        if isinstance(value, float):
            return f"{value:.9g}"
        if isinstance(value, dict):
            return {key: rounded(item) for key, item in value.items()}
        return [rounded(item) for item in value] if isinstance(value, (list, tuple)) else value

    tree = dataclasses.asdict(report)
    del tree["settings"], tree["solved"]  # the latter depends on batches where an axis gets no word
    if tree["along"] is not None:
        del tree["along"][
            "line"
        ]  # middles and ends of a batch: of equal errors it depends on batches which comes first
    return [rounded(tree)]


@pytest.fixture(scope="module")
def module_bench(tmp_path_factory: pytest.TempPathFactory) -> Bench:
    return Bench(tmp_path_factory.mktemp("runs"))


@example(  # the dwell of further holes is written as their own blocks are
    text=("\n", ["G82 X1. Y2. Z-20. R-10. P1", "X3.Y4.", "X4.Y5.", "X5.Y6.", "X6.Y7."], True), arcs="keep",
    integers=None, few=50, dialect=None, head=HEAD, start={},
)  # fmt: skip
@settings(max_examples=80, deadline=None)
@given(
    text=st.one_of(TEXTS, DRILLED),
    arcs=st.sampled_from(["keep", "keep", "chords"]),
    integers=st.sampled_from([None, "mm", "least-increment"]),
    few=st.sampled_from([1, 3, 50, 16384]),
    dialect=st.sampled_from([None, "linuxcnc", "fanuc", "siemens"]),
    head=st.sampled_from([HEAD, HEAD, WITHOUT_Z, WITHOUT_Y]),
    start=st.sampled_from([{}, {"Z": 12.5}, {"Y": 3.0}]),
)
def test_runs_are_what_their_blocks_are(
    module_bench: Bench,
    text: tuple[str, list[str], bool],
    arcs: str,
    integers: str | None,
    few: int,
    dialect: str | None,
    head: list[str],
    start: dict[str, float],
) -> None:
    """However blocks are taken together: the same bytes, the same faults, the same figures."""
    eol, lines, ends = text
    program = eol.join([*head, *lines]) + (eol if ends else "")
    options: dict[str, object] = {
        "integers": integers, "batch_points": few, "offsets": OFFSETS, "block_delete": "skip",
        "arcs": arcs, "dialect": dialect, "start": start,
    }  # fmt: skip
    by_blocks = outcome(module_bench, program, 10**9, options)
    assert outcome(module_bench, program, 1, options) == by_blocks
    assert outcome(module_bench, program, 3, options) == by_blocks


CHORDS = [f"X{100 + 0.4 * k:.4f} Y{100 + 20 * np.sin(k):.3f}" for k in range(60)]


@pytest.mark.parametrize(
    ("head", "tool_path"),
    [
        (HEAD, [f"{line} Z-{k % 7}.5" for k, line in enumerate(CHORDS)]),
        (  # as CAM systems write them
            [*HEAD[1:], "G17 G21 G90 G94"],
            ["(path)", "S8000 M3", "G90 G94 G17", "M8", "G0 X9. Y9.", "Z5.", "G1 Z-1. F300.", *CHORDS, "G0 Z50.", "M9"],
        ),
        (HEAD, ["G0 G90 X1. Y2.", "G1 F300. Z-2.", *CHORDS, "G2 F500. X100. Y101. R80.", "M5", "G00 Z9."]),
        (WITHOUT_Z, ["M5", "G0 X3. Y4.", "M3 S100", *CHORDS]),  # laser: Z stands where it was set by hand
        (HEAD, [line.replace("X", "X ").replace("Y", "Y  ") for line in CHORDS]),
        (HEAD, [f"R200. Y{line[-1]}.5 X{k}.25" if k else "G2 X0. Y0. R200." for k, line in enumerate(CHORDS)]),
        (HEAD, ["G80", "G0 Z30.", "G98 G83 X1. Y2. Z-20. R5. Q4. F90.", *CHORDS]),
    ],
    ids=["points", "tool paths", "G90 and F first", "no Z", "blanks in words", "any order", "cycles that end"],
)
def test_most_of_a_long_program_is_runs(bench: Bench, head: list[str], tool_path: list[str]) -> None:
    from trueaxis.compensation.nc.reader import NcReader, plain_move

    by_rule = patch("trueaxis.compensation.nc.reader.plain_move", side_effect=plain_move)
    by_words = patch.object(NcReader, "_any", autospec=True, side_effect=NcReader._any)
    with by_rule as plain, by_words as others:
        text = bench.run("\n".join([*head, *30 * tool_path, "M30\n"]), paper_sized())
    assert plain.call_count + others.call_count < 40
    assert len(re.findall(rb"X[-0-9]", text)) >= 30 * len(CHORDS)


def test_a_long_line_is_no_program(bench: Bench) -> None:
    head = "\n".join(HEAD) + "\n"
    for before in (0, 3000, 9000):
        text = head + "X1.\n" * before + "X" + "1" * 70_000 + "\nX2.\n"
        with pytest.raises(InputError, match=rf"line {before + 4}: a line of more than 65536 bytes"):
            bench.run(text)


def test_texts_without_a_last_line_end(bench: Bench) -> None:
    rows = [f"X{k}.5" for k in range(40)]
    text = bench.run("\n".join([*HEAD, *rows]), XyzMachine())
    assert text == "\n".join([*HEAD, *rows]).encode()
    assert bench.report.blocks_in == bench.report.blocks_out - 1 == 43


@settings(max_examples=200, deadline=None)
@given(numbers=st.lists(st.from_regex(r"[-+]?([0-9]{1,8}\.[0-9]{0,7}|\.[0-9]{1,15})", fullmatch=True), min_size=1))
def test_numbers_are_what_float_makes_of_them(numbers: list[str]) -> None:
    read = plain_text("".join(f"N1 G1 X{number} F100.\n" for number in numbers), undotted_mm=False)
    assert read.plain.all()
    assert read.value.tolist() == [float(number) for number in numbers]


def test_codes_stand_beside_words_or_alone() -> None:
    lines = [
        "G90 G1 X1. F2", "F5. G1 X1.", "G1 F5. Y2. X1.", "X1. F5. Y2.", "X1. X2.", "M3 S500", "M3 X1.", "G91 G90",
        "G28", "G0 G1", "S1 M3 S2", "",
    ]  # fmt: skip
    text = "\n".join(lines)
    read = plain_text(text, undotted_mm=False, modes={90, 91}, switches={3})
    assert read.plain.tolist() == [True, False, True, False, False, True, False, True, False, False, False]
    assert [code.tolist() for code in read.modes.of(7, 8)] == [[0, 0], [91, 90]]
    assert [code.tolist() for code in read.switches.of(5, 6)] == [[0], [3]]
    assert not plain_text(text, undotted_mm=False).plain[[0, 5, 7]].any()


def test_a_line_that_is_not_plain_leaves_the_others_as_they_are() -> None:
    read = plain_text("X1.5 Y-2.\n(text (7))\nX3.\n; 99\nY.5 F20\nG4 X1.\nX1.2.3\nN5\nX4.", undotted_mm=False)
    assert read.plain.tolist() == [True, False, True, True, True, False, False, True]
    assert [read.value[slice(*read.first[[k, k + 1]])].tolist() for k in (0, 2, 4)] == [[1.5, -2.0], [3.0], [0.5]]
    assert (read.lead[4] - read.starts[4], read.starts[5] - read.tail[4], read.feed[4]) == (0, 5, 20.0)
