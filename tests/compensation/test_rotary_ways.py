"""DC, ACP and ACN of SINUMERIK and M126 of Heidenhain: followed where the axis does not pass its zero, else refused."""

import re
from typing import Any

import pytest

from tests.compensation.control import Bench
from tests.compensation.five_axes import FiveAxes
from tests.machines import serial_text
from trueaxis.compensation.nc.rotary_ways import goes_round
from trueaxis.io.faults import Fault, InputError

HEAD = "G71 G90 G17\nG0 X0 Y0 Z50 B0 C{}\n"
KLARTEXT = "BEGIN PGM T MM\nL X+0 Y+0 Z+50 B+0 C+{} R0 FMAX\n{}\nEND PGM T MM\n"


@pytest.fixture(scope="module")
def machine() -> Any:
    """A table that turns all round, and a head."""
    return FiveAxes(serial_text("YC", "XZB", B={"position": [1.5, 0, 80.0]}, C={"travel": [-360.0, 360.0]})).model


def faults_of(bench: Bench, program: str, machine: Any, **settings: Any) -> tuple[Fault, ...]:
    with pytest.raises(InputError) as error:
        bench.run(program, machine, **settings)
    return tuple(error.value.faults)


@pytest.mark.parametrize(
    ("turn", "round_"),
    [(20.0, "N"), (-20.0, "P"), (179.0, "N"), (-179.0, "P"), (180.0, "DN"), (-340.0, "DP"), (340.0, "DN"), (0.0, "")],
)
def test_which_ways_pass_the_zero(turn: float, round_: str) -> None:
    assert {way for way in ("DC", "ACP", "ACN") if goes_round(turn, way)} == {
        {"D": "DC", "P": "ACP", "N": "ACN"}[letter] for letter in round_
    }


@pytest.mark.parametrize(
    ("way", "begin", "end"), [("DC", 10, 100), ("DC", 100, 10), ("ACP", 10, 300), ("ACN", 300, 10)]
)
def test_a_way_through_the_positions_is_that_of_plain_words(
    bench: Bench, machine: Any, way: str, begin: int, end: int
) -> None:
    source = HEAD.format(begin) + f"G1 X40 C={way}({end}) F500\nX60 Y20\n"
    written = bench.run(source, machine, dialect="siemens").decode()
    plain = bench.run(source.replace(f"={way}({end})", f"{end}"), machine, dialect="siemens").decode()
    assert re.sub(rf"={way}\(([\d.]+)\)", r"\1", written) == plain
    assert written.count(f"C={way}(") > 3  # each piece of the block, which is cut
    assert f"C={way}({end}.0000)" in written


def test_a_rapid_may_pass_the_zero(bench: Bench, machine: Any) -> None:
    source = HEAD.format(350) + "G0 X40 C=DC(10)\nG1 X60 F500\nG0 C=ACN(340)\nX20\n"
    written = bench.run(source, machine, dialect="siemens").decode()
    assert "C=DC(10.0000)" in written  # C10 would turn by 340 deg the other way
    assert "C=ACN(340.0000)" in written
    from_there = bench.run(HEAD.format(10) + "G0 X40\nG1 X60 F500\n", machine, dialect="siemens").decode()
    feeds = [[line for line in text.splitlines() if line.startswith("G1 ")] for text in (from_there, written)]
    assert feeds[0] == feeds[1] != []


@pytest.mark.parametrize(
    ("begin", "block", "words"),
    [
        (350, "G1 C=DC(10) F500", "C=DC(..): C may pass its zero on the way from 350 to 10"),
        (10, "G1 C=DC(190) F500", "may pass its zero"),
        (10, "G1 C=ACN(20) F500", "C=ACN(..): C may pass its zero"),
        (20, "G1 C=ACP(10) F500", "C=ACP(..): C may pass its zero"),
        (0, "G1 C=DC(360) F500", "it takes 0 to below 360"),
        (0, "G1 C=DC(-10) F500", "it takes 0 to below 360"),
        (0, "G1 X=DC(10) F500", "X is no rotary axis"),
        (0, "G91 G1 C=DC(10) F500", "DC under G91"),
        (0, "TRAORI\nG0 X0 Y0 Z50\nG0 C=ACN(10)", "may pass its zero"),
    ],
)
def test_what_is_not_followed_is_named(bench: Bench, machine: Any, begin: int, block: str, words: str) -> None:
    found = faults_of(bench, HEAD.format(begin) + block + "\n", machine, dialect="siemens")
    assert any(words in fault.problem for fault in found), found


def test_ways_go_with_kept_orientation_alone(bench: Bench, machine: Any) -> None:
    source = HEAD.format(0) + "G0 C=DC(10)\n"
    (fault,) = faults_of(bench, source, machine, dialect="siemens", orientation="correct")
    assert "--orientation correct" in fault.problem


def test_the_shorter_way_of_heidenhain(bench: Bench, machine: Any) -> None:
    source = KLARTEXT.format(10, "L M126\nL X+40 C+100 F500\nL C+350 FMAX\nL C+10 FMAX\nL X+60 F500\nL M127\nL C+300")
    written = bench.run(source, machine, dialect="heidenhain").decode()
    plain = bench.run(source.replace("M126", "M127"), machine, dialect="heidenhain").decode()
    assert written.replace("M126", "M127") == plain
    for feed in ("L C+350 F500 M126", "L M126\nL X+5 F500\nL C+350 R0", "L M126\nL C+100 FMAX\nL C+290 F100"):
        found = faults_of(bench, KLARTEXT.format(10, feed), machine, dialect="heidenhain")
        assert ["M126: C may pass its zero" in fault.problem for fault in found] == [True]
    found = faults_of(bench, KLARTEXT.format(10, "L M126\nL C+20 FMAX M127"), machine, dialect="heidenhain")
    assert "M127 beside positions" in found[0].problem


def test_the_shorter_way_in_iso_programs_of_heidenhain(bench: Bench, machine: Any) -> None:
    source = "G71 G90\nG0 X0. Y0. Z50. B0. C10.\nM126\n" + "".join(f"G1 C{c}. F500\n" for c in (20, 30, 40, 350))
    found = faults_of(bench, source, machine, dialect="heidenhain")
    assert [fault.place for fault in found] == ["line 7"]
    (fault,) = faults_of(bench, source.replace("G71 ", "G21 "), machine)
    assert fault.place == "line 3"
    assert fault.remedy.startswith("say --dialect heidenhain if it is one; else")
