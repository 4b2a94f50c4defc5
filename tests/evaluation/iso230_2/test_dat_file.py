"""The .dat reader: right values, or every fault at its line; never anything else."""

import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.evaluation.iso230_2.builders import dat_text, made_up
from trueaxis.evaluation.positioning_dat_file import read_dat
from trueaxis.evaluation.positioning_test import PositioningTest
from trueaxis.io.faults import Fault, InputError

SETTINGS = settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
SMALL = made_up(3, 2)
TEXT = dat_text(SMALL)
LINES = TEXT.splitlines()
REAL = Path(__file__).parents[4] / "shared" / "data" / "ess_iso230_2" / "axis_x.dat"


def read(tmp_path: Path, text: str | bytes) -> PositioningTest:
    path = tmp_path / "axis.dat"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return read_dat(path)


def faults_of(tmp_path: Path, text: str | bytes) -> tuple[Fault, ...]:
    with pytest.raises(InputError) as caught:
        read(tmp_path, text)
    return caught.value.faults


def line_of(start: str) -> int:
    return next(number for number, line in enumerate(LINES, 1) if line.startswith(start))


@pytest.mark.parametrize("ending", ["\n", "\r\n", "\r"])
def test_values_arrive_where_their_indices_say(tmp_path: Path, ending: str) -> None:
    found = read(tmp_path, "\N{BOM}" + TEXT.replace("\n", ending))
    assert np.array_equal(found.targets, SMALL.targets)
    assert np.array_equal(found.positive, SMALL.positive)
    assert np.array_equal(found.negative, SMALL.negative)


def test_order_of_lines_and_declared_counts_do_not_matter(tmp_path: Path) -> None:
    kept = [line for line in LINES if not line.startswith(("CYCLES", "POSITIONS", "DEC", "UNIT", "TEST", "REF_PV"))]
    found = read(tmp_path, "\n".join(reversed(kept)))
    assert np.array_equal(found.negative, SMALL.negative)


def test_numbers_and_indices_as_loggers_print_them(tmp_path: Path) -> None:
    """bc drops the zero before the point; seq -w puts zeros before an index."""
    text = (
        "TGT_DATA[01]=0\nTGT_DATA[02] = 5.\nREF_DATA_FWD[01, 01]=-.0471\nREF_DATA_FWD[02,01]=+5e0 # comment\n"
        "REF_DATA_FWD[1,2]=.5\nREF_DATA_FWD[2,2]=50E-1\nREF_DATA_BWD[ 1 , 1 ]=1\n\tREF_DATA_BWD[2,1]=4.25\t\n"
        "REF_DATA_BWD[1,2]=-0\nREF_DATA_BWD[2,2]=0005"
    )
    found = read(tmp_path, text)
    assert found.targets.tolist() == [0.0, 5.0]
    assert found.positive.tolist() == [[-0.0471, 0.5], [5.0, 5.0]]
    assert found.negative.tolist() == [[1.0, 0.0], [4.25, 5.0]]


@pytest.mark.parametrize(
    ("start", "replacement", "words"),
    [
        ("TGT_DATA[2]", "TGT_DATA[2]=__import__('os')", "is not a number"),
        ("TGT_DATA[2]", "TGT_DATA[2]=1+1", "is not a number"),
        ("TGT_DATA[2]", "TGT_DATA[2]=nan", "is not a number"),
        ("TGT_DATA[2]", "TGT_DATA[2]=1_0", "is not a number"),
        ("TGT_DATA[2]", "TGT_DATA[2]=\N{FULLWIDTH DIGIT ONE}", "is not a number"),
        ("TGT_DATA[2]", "TGT_DATA[2]=1e999", "is not a finite number"),
        ("TGT_DATA[2]", "TGT_DATA[2]=1e6", "is too far"),
        ("REF_DATA_FWD[2,1]", "REF_DATA_FWD[2,1]=", "is empty"),
        ("REF_DATA_FWD[2,1]", "REF_DATA_FWD[2,1]=99999", "mm off its target"),
        ("REF_DATA_FWD[2,1]", "REF_DATA_FWD[2,1]=-99999", "mm off its target"),
        ("TGT_DATA[2]", "TGT_DATA[2]=-1e6", "is too far"),
        ("REF_PV", "REF_DATA_FWD[1]=1", "another number of indices"),
        ("REF_PV", "CYCLES[1]=1", "another number of indices"),
        ("REF_PV", "TGT_DATA=1", "another number of indices"),
        ("REF_PV", "TGT_DATA[0]=1", "is not an index"),
        ("REF_PV", "TGT_DATA[-1]=1", "is not an index"),
        ("REF_PV", "TGT_DATA[1,]=1", "is not an index"),
        ("REF_PV", "TGT_DATA[999999999]=1", "is too high"),
        ("REF_PV", "TGT_DATA[" + "9" * 5000 + "]=1", "is not an index"),
        ("REF_PV", "REF_DATA_FWD[1,1001]=1", "is too high"),
        ("REF_PV", "REF_DATA_FWD[1,1]=1", None),
        ("REF_PV", "REF_DATA_FWT[1,1]=1", "is not a known name"),
        ("REF_PV", "import os", "is not an assignment"),
        ("REF_PV", "\x1b[2J", "is not an assignment"),
        ("UNIT", "UNIT=um", "is not mm"),
        ("UNIT", "UNIT=", "is not mm"),
        ("DEC", "DEC=five", "is not a whole number"),
        ("CYCLES", "CYCLES=1", "has 1 cycle: an evaluation needs at least 2"),
        ("CYCLES", "CYCLES=1e1", "is not a count"),
        ("CYCLES", "CYCLES=" + "9" * 5000, "is not a count"),
        ("POSITIONS", "POSITIONS=2", "POSITIONS is 2, but there is a position 3"),
    ],
)
def test_a_fault_names_its_line(tmp_path: Path, start: str, replacement: str, words: str | None) -> None:
    number = line_of(start)
    if words is None:  # the repetition is found where it stands last
        number, words = line_of("REF_DATA_FWD[1,1]"), f"is given already in line {number}"
    lines = list(LINES)
    lines[line_of(start) - 1] = replacement
    found = faults_of(tmp_path, "\n".join(lines))
    assert [fault.place for fault in found] == [f"line {number}"]
    assert words in found[0].problem
    assert len(str(found[0])) < 400
    assert str(found[0]).isprintable()


def test_all_faults_are_told_at_once(tmp_path: Path) -> None:
    lines = [line for line in LINES if not line.startswith("REF_DATA_BWD[3,2]")]
    lines[2] = "nonsense"
    lines[3] = "UNIT=inch"
    lines[line_of("TGT_DATA[1]") - 1] = "TGT_DATA[1]=x"
    found = faults_of(tmp_path, "\n".join(lines))
    assert [fault.place for fault in found] == ["line 3", "line 4", f"line {line_of('TGT_DATA[1]')}", ""]
    assert found[-1].problem == "REF_DATA_BWD[3,2] is missing"


def test_a_target_given_twice_is_told(tmp_path: Path) -> None:
    readings = "".join(f"REF_DATA_{d}WD[{i},{j}]=5\n" for d in "FB" for i in (1, 2) for j in (1, 2))
    found = faults_of(tmp_path, "TGT_DATA[1]=5\n" + readings + "TGT_DATA[2]=5.0")
    assert [(fault.place, fault.problem) for fault in found] == [("line 10", "TGT_DATA[2] is the same as TGT_DATA[1]")]


def test_missing_directions_and_few_cycles_are_told(tmp_path: Path) -> None:
    one_way = "TGT_DATA[1]=0\nTGT_DATA[2]=5\nREF_DATA_FWD[1,1]=0\nREF_DATA_FWD[2,1]=5"
    problems = [fault.problem for fault in faults_of(tmp_path, one_way)]
    assert any(problem.startswith("has 1 cycle:") for problem in problems)
    assert "there is no REF_DATA_BWD[position,cycle]" in problems


@pytest.mark.parametrize("text", ["", "\n\n", "# comment only", "UNIT=mm"])
def test_a_file_without_data_is_a_fault(tmp_path: Path, text: str) -> None:
    assert "there is no TGT_DATA[position]" in [fault.problem for fault in faults_of(tmp_path, text)]


def test_gaps_of_a_large_declaration_are_counted(tmp_path: Path) -> None:
    text = TEXT.replace("CYCLES=2", "CYCLES=1000").replace("POSITIONS=3", "POSITIONS=2000")
    found = faults_of(tmp_path, text)
    assert len(found) < 100
    assert found[-1].problem == f"and so {2000 * 1000 - 6 - 20} more values of REF_DATA_BWD"


def test_a_file_of_another_kind_is_left_soon(tmp_path: Path) -> None:
    found = faults_of(tmp_path, "0.1 0.2 0.3\n" * 1_000_000)
    assert len(found) == 1001
    assert found[-1].problem.startswith("reading stopped here")


@pytest.mark.parametrize(
    "line", ["TGT_DATA[1]=" + "9" * 10**6 + "x", "A" + " " * 10**6 + "x", "TGT_DATA[" + "1," * 10**6]
)
def test_long_lines_take_no_time(tmp_path: Path, line: str) -> None:
    """Two ways to read the same digits would take a time that grows with their square: minutes."""
    found = faults_of(tmp_path, line)
    assert found[0].place == "line 1"
    assert len(str(found[0])) < 400


def test_bytes_that_are_no_text_are_a_fault(tmp_path: Path) -> None:
    assert [fault.place for fault in faults_of(tmp_path, b"UNIT=mm\nTGT_DATA[1]=\xff")] == ["line 2"]


@given(data=st.one_of(st.binary(max_size=200), st.text(max_size=200).map(lambda text: text.encode("utf-8", "replace"))))
@SETTINGS
def test_arbitrary_bytes_are_faults(tmp_path: Path, data: bytes) -> None:
    assert faults_of(tmp_path, data)


@given(
    text=st.lists(
        st.sampled_from(["TGT_DATA", "REF_DATA_FWD", "CYCLES", *"[],12=\n -.e#"]),
        max_size=60,
    ).map("".join)
)
@SETTINGS
def test_pieces_of_the_grammar_in_any_order_are_faults(tmp_path: Path, text: str) -> None:
    assert faults_of(tmp_path, text)  # too short to hold a whole test


def mutations(lines: list[str]) -> st.SearchStrategy[str]:
    """A file with up to three lines dropped, doubled, moved, cut, or changed in a character."""

    def mutate(draw: st.DrawFn) -> str:
        found = list(lines)
        for _ in range(draw(st.integers(1, 3))):
            at = draw(st.integers(0, len(found) - 1))
            line, column = found[at], draw(st.integers(0, len(found[at])))
            match draw(st.sampled_from(["drop", "double", "move", "cut", "change", "insert"])):
                case "drop":
                    del found[at]
                case "double":
                    found.insert(at, line)
                case "move":
                    found.insert(draw(st.integers(0, len(found) - 1)), found.pop(at))
                case "cut":
                    found[at] = line[:column]
                case "change":
                    found[at] = line[:column] + draw(st.characters(codec="utf-8")) + line[column + 1 :]
                case _:
                    found[at] = line[:column] + draw(st.sampled_from("0123456789-+.eE=[],#\t\r\n ")) + line[column:]
        return "\n".join(found)

    return st.composite(mutate)()


def naive(text: str) -> dict[str, float]:
    """What is assigned in a file that is right, read in the simplest way."""
    found = {}
    for line in re.split(r"\r\n|\r|\n", text):
        name, _, value = line.split("#")[0].partition("=")
        if name.strip().startswith(("TGT_DATA", "REF_DATA")):
            inside = name[name.index("[") + 1 : name.index("]")]
            name = name.partition("[")[0].strip()
            found[name + str([int(number) for number in inside.split(",")])] = float(value)
    return found


def check_mutated(tmp_path: Path, text: str) -> None:
    try:
        test = read(tmp_path, text)
    except InputError as error:
        count = len(re.split(r"\r\n|\r|\n", text))
        for fault in error.faults:
            assert not fault.place or 1 <= int(fault.place.removeprefix("line ")) <= count
            assert str(fault).isprintable()
        return
    expected = {f"TGT_DATA[{i + 1}]": value for i, value in enumerate(test.targets)}
    for name, grid in (("REF_DATA_FWD", test.positive), ("REF_DATA_BWD", test.negative)):
        expected |= {f"{name}[{i + 1}, {j + 1}]": value for (i, j), value in np.ndenumerate(grid)}
    assert naive(text) == expected


@given(text=mutations(LINES))
@SETTINGS
def test_a_mutated_file_is_a_fault_or_read_right(tmp_path: Path, text: str) -> None:
    check_mutated(tmp_path, text)


@pytest.mark.skipif(not REAL.is_file(), reason="the measured data of others are not here (shared/data/ess_iso230_2)")
@given(data=st.data())
@SETTINGS
def test_a_mutated_real_file_is_a_fault_or_read_right(tmp_path: Path, data: st.DataObject) -> None:
    check_mutated(tmp_path, data.draw(mutations(REAL.read_text(encoding="utf-8").splitlines())))
