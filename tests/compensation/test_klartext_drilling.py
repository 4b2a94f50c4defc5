"""CYCL DEF 200 of Heidenhain: its holes are written out where it is called."""

import re
from pathlib import Path

import pytest

from tests.compensation.test_klartext import ALONG, compensated, control, largest_error, notes_of
from trueaxis.io.faults import InputError

CYCLE = """\
CYCL DEF 200 DRILLING ~
  Q200=+2 ;SET-UP CLEARANCE ~
  Q201=-20 ;DEPTH ~
  Q206=+150 ;FEED RATE FOR PLNGNG ~
  Q202={peck} ;PLUNGING DEPTH ~
  Q210=+0.1 ;DWELL TIME AT TOP ~
  Q203=+1.5 ;SURFACE COORDINATE ~
  Q204={second} ;2ND SET-UP CLEARANCE ~
  Q211=+0.2 ;DWELL TIME AT DEPTH ~
  Q395=+0 ;DEPTH REFERENCE
"""
HEAD = "BEGIN PGM D MM\nTOOL CALL 5 Z S3000\n"
BLOCKS = """\
CYCL DEF 7.0 DATUM SHIFT
CYCL DEF 7.1 Z-3
L X+0 Y+0 Z+50 R0 FMAX M3
L Z+40 F300
L X+110 Y+5 R0 FMAX M99
L X+130.5 Y+5 M99 ; second
L X+130.5 Y+45 FMAX
CYCL CALL
L X+160 R0
CYCL DEF 32.0 TOLERANCE
L X+170 R0 M99
L X+175
L Z+60 R0 FMAX
END PGM D MM
"""


@pytest.mark.parametrize(("peck", "second", "holes"), [("+20", "+50", 1), ("+0", "+1", 1), ("+8", "+50", 3)])
def test_holes_are_right_along_the_path(tmp_path: Path, peck: str, second: str, holes: int) -> None:
    source = HEAD + CYCLE.format(peck=peck, second=second) + BLOCKS
    meant = source.replace("Q202=+0 ", "Q202=+99 ")  # 0: the whole depth at once
    written = compensated(tmp_path, source)
    assert "M99" not in written
    assert "CALL\n" not in written
    before, after = largest_error(meant, written)
    assert before > 0.01
    assert after < ALONG
    assert written.count("F150\n") == 4 * holes
    assert written.count("DWELL 0.2\n") == 4
    assert written.count("DWELL 0.1\n") == 4 * (holes - 1)
    feeds = {
        r"L X1\d\d\.\d+ Y\d\.\d+(?: Z[\d.]+)? F300 ; second",
        r"L X1(?:59|60)\.\d+ .*R0 F300",
        r"L X17[45]\.\d+ .*F300",
    }
    assert all(re.search(feed, written) for feed in feeds)  # in force again behind a hole
    numbers = control(written).numbers
    assert numbers == sorted(set(numbers))


def test_without_a_call_nothing_is_drilled(tmp_path: Path) -> None:
    blocks = "L X+50 F100\nL X+60\n"
    assert not [note for note in notes_of(tmp_path, CYCLE.format(peck=9, second=9) + blocks) if "written out" in note]
    found = notes_of(tmp_path, CYCLE.format(peck=9, second=9) + "L X+50 F100 M99\nL X+60 M99\n")
    assert len([note for note in found if "(and 1 more): CYCL DEF 200 is written out" in note]) == 1


@pytest.mark.parametrize(
    ("blocks", "words"),
    [
        ("L X+5 F100 M99", "M99 calls the cycle that is defined before"),
        ("CYCL CALL", "calls a cycle"),
        (CYCLE.format(peck="Q5", second=9) + "L X+5 F100 M99", "M99 calls the cycle that is defined before"),
        (CYCLE.format(peck=9, second=9).replace("Q201=-", "Q201=+") + "CYCL CALL", "calls a cycle"),
        (CYCLE.format(peck=9, second=9).replace("Q395=+0", "Q395=+1") + "CYCL CALL", "calls a cycle"),
        (CYCLE.format(peck=9, second=9) + "CYCL DEF 201 REAMING~\n Q200=2\nCYCL CALL", "calls a cycle"),
        (CYCLE.format(peck=9, second=9) + "CYCL CALL PAT F300", "calls a cycle"),
        (CYCLE.format(peck=9, second=9) + "L X+5 F100 M9 M99", "a code due at its end"),
        (CYCLE.format(peck=9, second=9) + "/L X+5 F100 M99", "a block with /"),
        (CYCLE.format(peck=9, second=9) + "M0\nCYCL CALL", "a drilling cycle where X or Y is not certain"),
    ],
)
def test_calls_that_are_not_followed_are_named(tmp_path: Path, blocks: str, words: str) -> None:
    with pytest.raises(InputError) as caught:
        compensated(tmp_path, f"{HEAD}L X+0 Y+0 Z+50 R0 FMAX\n{blocks}\nEND PGM D MM\n")
    assert any(words in fault.problem for fault in caught.value.faults), [f.problem for f in caught.value.faults]
    if "M99 calls" in words:
        assert "CYCL DEF 200 with numbers is followed" in caught.value.faults[0].remedy
