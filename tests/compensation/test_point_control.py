"""Tool centre point control: by a control that solves the chain itself, what is written puts the tip where it is meant.

The control and the machine are the chain in forty digits of tests/exact_chain; nothing of the package computes here.
"""

import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from tests.compensation.analytic_machine import FloatArray, XyzMachine
from tests.compensation.five_axes import TEXTS, FiveAxes
from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.report import CompensationReport
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.tools import Tool, ToolTable
from trueaxis.io.faults import InputError

LENGTH = 95.0
TOOLS = ToolTable({1: Tool(length=LENGTH)})
POINT = np.array([[0.0], [0.0], [-LENGTH]])
AXES = "XYZ"


def p_of(machine: FiveAxes, column: Sequence[float] | FloatArray, ideal: bool) -> FloatArray:
    point, _ = machine.pose_of(np.array(column), POINT, ideal=ideal)
    return np.array([float(value) for value in point])


def axes_at(machine: FiveAxes, tip: FloatArray) -> FloatArray:
    """What a control makes of words of the tip: Newton on the ideal chain, its derivative by differences."""
    target = p_of(machine, [*tip[:3], 0.0, 0.0], ideal=True)
    found = np.array(tip, dtype=float)
    here = p_of(machine, found, ideal=True)
    columns = [p_of(machine, found + np.eye(5)[row], ideal=True) - here for row in range(3)]
    found[:3] += np.linalg.solve(np.array(columns).T, target - here)
    assert np.linalg.norm(p_of(machine, found, ideal=True) - target) < 1e-9
    return found


def tips(program: str, rotary: str, machine: FiveAxes) -> list[tuple[bool, FloatArray]]:
    """Whether by feed, and the position of the tip as words have it plus the length of the tool, of every motion."""
    at, feeding, found, length = np.zeros(5), False, [], 0.0
    for line in program.splitlines():
        text = re.sub(r"\(.*?\)|;.*|\bFMAX\b|\bR0\b", "", line)
        feeding = bool(re.search(r"\bG0?1\b|^\s*(?:\d+ )?L\b", text)) or (feeding and not re.search(r"\bG0?0\b", text))
        if "FMAX" in line:
            feeding = False
        if re.search(r"G43.4|TRAORI|D1|M428|M128|TOOL CALL 1|G43 ", line):
            length = LENGTH
        words = dict(re.findall(r"([XYZABC])\s*=?\s*([-+]?[\d.]+)", text))
        if not words or "TOOL" in line or "BEGIN" in line:
            continue
        for row, axis in enumerate(AXES + rotary):
            if axis in words:
                at[row] = float(words[axis]) + (length if axis == "Z" else 0.0)
        found.append((feeding, at.copy()))
    return found


def run(
    folder: Path, text: str, machine: "FiveAxes | Narrow", dialect: str, **more: object
) -> tuple[CompensationReport, str]:
    source, out = folder / ("in.h" if "BEGIN" in text else "in.nc"), folder / "out.nc"
    source.write_text(text)
    given = {"dialect": dialect, "tools": TOOLS, "integers": "mm"} | more
    report = compensate_file(source, out, machine.model, Settings(**given), language="nc")  # type: ignore[arg-type]
    return report, out.read_text()


def meant_tip(machine: FiveAxes, tip: FloatArray) -> FloatArray:
    """Where the error-free machine has the tip, workpiece frame."""
    return p_of(machine, [*tip[:3], 0.0, 0.0], ideal=True)


def actual_tip(machine: FiveAxes, tip: FloatArray) -> FloatArray:
    """Where the machine with errors has it under the control."""
    return p_of(machine, axes_at(machine, tip), ideal=False)


def distance_from_line(point: FloatArray, start: FloatArray, end: FloatArray) -> float:
    line = end - start
    length = float(line @ line)
    share = float(np.clip((point - start) @ line / length, 0.0, 1.0)) if length > 1e-12 else 0.0
    return float(np.linalg.norm(point - start - share * line))


def errors(source: str, written: str, rotary: str, machine: FiveAxes) -> tuple[float, float]:
    """Largest error before, at the source's ends, and after, along the written feed motions too."""
    meant, done = tips(source, rotary, machine), tips(written, rotary, machine)
    before = max(float(np.linalg.norm(actual_tip(machine, tip) - meant_tip(machine, tip))) for _, tip in meant)
    after, place = 0.0, 0  # place: the motion of the source that the written one is part of
    ends = [tip for _, tip in meant]
    for index, (feeding, tip) in enumerate(done):
        goal = meant_tip(machine, ends[place])
        for share in (0.4,) if feeding else ():
            begin = done[index - 1][1]
            actual = actual_tip(machine, begin + share * (tip - begin))
            after = max(after, distance_from_line(actual, meant_tip(machine, ends[place - 1]), goal))
        if np.abs(ends[place][3:] - tip[3:]).max() < 1e-6 and np.linalg.norm(ends[place][:3] - tip[:3]) < 0.5:
            after = max(after, float(np.linalg.norm(actual_tip(machine, tip) - goal)))
            place += 1
    assert place == len(ends)
    return before, after


def program_of(dialect: str, rotary: str) -> str:
    a, b = list(rotary)
    moves = [
        f"X10. Y20. Z30. {a}0. {b}0.", f"X40. Y-30. Z5. {a}10. {b}20.", f"X60. Y-10. Z8. {a}35. {b}-15.",
        f"Z20. {b}10.", f"X20. Y15. {a}-25.",
    ]  # fmt: skip
    if dialect == "heidenhain":
        lines = [f"L {text} F1000" for text in moves]
        lines[0] = f"L {moves[0]} FMAX"
        return "\n".join(["BEGIN PGM T MM", "TOOL CALL 1 Z S1000", "L M128", *lines, "M129", "END PGM T MM", ""])
    on = {"fanuc": "G43.4 H1", "siemens": "TRAORI", "linuxcnc": "G43 H1\nM428"}[dialect]
    off = {"fanuc": "G49", "siemens": "TRAFOOF", "linuxcnc": "M429"}[dialect]
    change = "T1 M6\nD1" if dialect == "siemens" else "T1 M6"
    return "\n".join([
        "G21" if dialect != "siemens" else "G71", "G90", change, f"G0 X0. Y0. Z0. {a}0. {b}0.", on, f"G0 {moves[0]}",
        f"G1 {moves[1]} F1000", *moves[2:], off, "M30", "",
    ])  # fmt: skip


CASES = [("fanuc", "table-table", "AC"), ("siemens", "head-head", "BC"), ("heidenhain", "head and table", "BC"),
         ("linuxcnc", "slanted order", "AB")]  # fmt: skip


@pytest.mark.parametrize(("dialect", "name", "rotary"), CASES)
def test_the_tip_is_right_by_a_control_that_solves_the_chain(
    tmp_path: Path, dialect: str, name: str, rotary: str
) -> None:
    machine = FiveAxes(TEXTS[name])
    source = program_of(dialect, rotary)
    report, written = run(tmp_path, source, machine, dialect)
    assert report.good
    assert any("tool centre point control" in note for note in report.notes)
    before, after = errors(source, written, rotary, machine)
    assert before > 0.005
    assert after < 0.0013
    for word in ("G43.4 H1", "TRAORI", "L M128", "M428"):
        assert (word in source) == (word in written)


def test_how_fast_the_linear_axes_follow_changes_no_position(tmp_path: Path) -> None:
    machine, source = FiveAxes(TEXTS["head and table"]), program_of("heidenhain", "BC")
    (_, plain), (_, with_feed) = [
        run(tmp_path, source.replace("L M128", words), machine, "heidenhain") for words in ("M128", "M128 F5000")
    ]
    assert "M128 F5000" in with_feed
    assert with_feed.replace("M128 F5000", "M128") == plain
    assert plain != source.replace("L M128", "M128")


def test_positions_are_lost_at_the_switch_unless_rotary_axes_stand_at_0(tmp_path: Path) -> None:
    machine = FiveAxes(TEXTS["table-table"])
    head = "G21 G90\nT1 M6\nG0 X0. Y0. Z0. A10. C0.\nG43.4 H1\n"
    with pytest.raises(InputError, match="the position of X Y is not known"):
        run(tmp_path, head + "G1 Z5. F100\nM30\n", machine, "fanuc")


@pytest.mark.parametrize(
    ("dialect", "line", "words"),
    [
        ("fanuc", "G43.4 H1\nG53 G0 Z0.", "machine coordinates under"),
        ("fanuc", "G43.5 H1", "G43.5"),
        ("linuxcnc", "M430", "M430"),
        ("siemens", "TRAORI(2)", "another transformation"),
        ("fanuc", "G43.4 H1\nG0 X5000. Y0. Z0.", "outside its travel"),
        ("linuxcnc", "G43.4 H1", "G43.4"),
    ],
)  # fmt: skip
def test_faults(tmp_path: Path, dialect: str, line: str, words: str) -> None:
    with pytest.raises(InputError) as caught:
        run(
            tmp_path, "G90\nT1 M6\nG0 X0. Y0. Z0. A0. C0.\n" + line + "\nM30\n", FiveAxes(TEXTS["table-table"]), dialect
        )
    assert any(words in fault.problem for fault in caught.value.faults), [f.problem for f in caught.value.faults]


class Narrow:
    """A machine with other travel."""

    def __init__(self, model: object, travel: dict[str, tuple[float, float]]) -> None:
        self._model, self.travel, self.model = model, travel, self

    def __getattr__(self, name: str) -> object:
        return getattr(self._model, name)


@pytest.mark.parametrize(("name", "rotary"), [("table-table", "AC"), ("head-head", "BC"), ("head and table", "BC")])
def test_travel_is_that_of_the_axes_all_along_the_block(tmp_path: Path, name: str, rotary: str) -> None:
    """Axes go on arcs while rotary axes turn: both ends may lie within the travel, and the way between them not."""
    machine, random = FiveAxes(TEXTS[name]), np.random.default_rng(5)
    beyond = 0
    for _ in range(2):
        start, end = (
            np.concatenate([random.uniform(-40.0, 40.0, 3), random.uniform(-30.0, 30.0, 1), [side]])
            for side in (-50.0, 50.0)
        )
        way = np.array([axes_at(machine, start + k / 20 * (end - start)) for k in range(21)])
        sides = np.concatenate([way[:, :3], -way[:, :3]], axis=1)  # how far each axis goes up, and down
        side = int(np.argmax(sides.max(axis=0) - np.maximum(sides[0], sides[-1])))
        highest, at_ends, row = sides[:, side].max(), max(sides[0, side], sides[-1, side]), side % 3
        stands, tip = axes_at(machine, start), start - [0.0, 0.0, LENGTH, 0.0, 0.0]
        letters = AXES + rotary
        first, begin, last = (
            " ".join(f"{axis}{value:.6f}" for axis, value in zip(letters, of, strict=False))
            for of in (stands, tip[:3], end - [0.0, 0.0, LENGTH, 0.0, 0.0])
        )
        source = f"G21 G90\nT1 M6\nG0 {first}\nG43.4 H1\nG0 {begin}\nG1 {last} F500\nG49\nM30\n"
        beyond += highest > at_ends + 0.5
        for margin in (0.2, -0.01):
            wide = dict.fromkeys(machine.model.axes, (-1e4, 1e4))
            limit = float(highest + margin)
            limits = (-1e4, limit) if side < 3 else (-limit, 1e4)
            narrow = Narrow(machine.model, wide | {AXES[row]: limits})
            if margin > 0.0:
                assert run(tmp_path, source, narrow, "fanuc")[0].moves == 3
            if margin > 0.0 or highest < at_ends + 0.5:
                continue
            with pytest.raises(InputError) as caught:
                run(tmp_path, source, narrow, "fanuc")
            reaches, fault = caught.value.faults
            assert (fault.place, fault.problem.split(" =")[0]) == ("line 6", AXES[row])
            assert reaches.problem.startswith(f"{AXES[row]} reaches ")
            assert reaches.remedy.startswith("no work offset is given")  # a shift of the program is none of the axes
    assert beyond


@pytest.mark.parametrize(("name", "rotary"), [("table-table", "AC"), ("head-head", "BC")])
@pytest.mark.parametrize("end", ["X90. Y-80. Z95.", "X-70. Y90. Z-60."])
def test_words_of_the_tip_take_no_axis_out_of_its_travel(tmp_path: Path, name: str, rotary: str, end: str) -> None:
    """The control would stop at its limit switch: what is written ends before it, and exit code 1 says so."""
    machine = FiveAxes(TEXTS[name])
    a, b = list(rotary)
    start = f"X10. Y20. Z30. {a}35. {b}-15."
    source = f"G21 G90\nT1 M6\nG0 X0. Y0. Z0. {a}0. {b}0.\nG43.4 H1\nG0 {start}\nG1 {end} F1000\nG49\nM30\n"
    wide = dict.fromkeys(machine.model.axes, (-1e4, 1e4))
    free, written = run(tmp_path, source, Narrow(machine.model, wide), "fanuc")
    meant, done = (axes_at(machine, tips(text, rotary, machine)[-1][1]) for text in (source, written))
    assert free.good
    stopped = 0
    for row, axis in enumerate(AXES):
        sign = float(np.sign(done[row] - meant[row]))
        limit = sign * float(meant[row]) + 1e-5  # of a row of programmed positions the last, which just fits
        limits = (-1e4, limit) if sign > 0.0 else (-limit, 1e4)
        try:
            report, text = run(tmp_path, source, Narrow(machine.model, wide | {axis: limits}), "fanuc")
        except InputError:  # the way to there leads out of the travel
            continue
        there = axes_at(machine, tips(text, rotary, machine)[-1][1])
        assert sign * there[row] < limit < sign * done[row]
        assert np.abs(there - done).max() < 0.06
        assert not report.good
        assert report.out_of_travel.first[-1] == 6
        stopped += 1
    assert stopped


def test_a_machine_without_rotary_axes(tmp_path: Path) -> None:
    source = tmp_path / "in.nc"
    source.write_text("G21 G90\nT1 M6\nG43.4 H1\nG0 X1. Y1. Z1.\nM30\n")
    with pytest.raises(InputError, match="no rotary axis"):
        compensate_file(source, tmp_path / "out.nc", XyzMachine(), Settings(dialect="fanuc", tools=TOOLS))


def test_correcting_the_orientation_too_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="--orientation keep"):
        run(tmp_path, program_of("fanuc", "AC"), FiveAxes(TEXTS["table-table"]), "fanuc", orientation="correct")
