"""Drilling cycles of Heidenhain: their holes are written out where they are called."""

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
COMMON = "Q200=2 ~\nQ201=-20 ~\nQ206=150 ~\nQ211=0 ~\nQ203=1.5 ~\nQ204=50"
REAMING = f"CYCL DEF 201 REAMING ~\n{COMMON} ~\nQ208=500\n"
UNIVERSAL = (
    f"CYCL DEF 203 UNIVERSAL DRILLING ~\n{COMMON} ~\nQ202=8 ~\nQ210=0 ~\nQ212=0 ~\nQ213=0 ~\nQ205=3 ~\nQ208=900 ~\n"
    "Q256=0.2\n"
)
PECKING = (
    f"CYCL DEF 205 UNIVERSAL PECKING ~\n{COMMON} ~\nQ202=6 ~\nQ212=0 ~\nQ205=3 ~\nQ258=0.4 ~\nQ259=0.4 ~\nQ257=0 ~\n"
    "Q256=0.2 ~\nQ379=0\n"
)
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


@pytest.mark.parametrize(
    ("cycle", "feeds"),
    [
        (REAMING, {"150": 1, "500": 1}), (REAMING.replace("Q208=500", "Q208=0"), {"150": 2}),
        (REAMING.replace("Q204=50", "Q204=2"), {"150": 1, "500": 1}), (UNIVERSAL, {"150": 3, "900": 3}),
        (UNIVERSAL.replace("Q208=900", "Q208=+99999"), {"150": 3}), (PECKING, {"150": 4}),
        (PECKING.replace("Q379=0", "Q379=0 ~\nQ208=700"), {"150": 4, "700": 1}),
        (PECKING.replace("Q379=0", "Q379=0 ~\nQ373=450"), {"150": 4, "450": 3}),
        # chips broken: in 203 as often as Q213 says, then out of the hole; in 205 each Q257 within Q202
        (UNIVERSAL.replace("Q213=0", "Q213=1").replace("Q202=8", "Q202=3"), {"150": 7, "900": 4}),
        (UNIVERSAL.replace("Q213=0", "Q213=9"), {"150": 3, "900": 1}),
        (PECKING.replace("Q257=0", "Q257=2.5"), {"150": 10}),
        # each peck smaller: 6, 5, 4, 3 and the rest
        (PECKING.replace("Q212=0", "Q212=1"), {"150": 5}),
        (UNIVERSAL.replace("Q212=0", "Q212=2").replace("Q213=0", "Q213=2"), {"150": 4, "900": 2}),
        # as Autodesk's posts write it
        (PECKING.replace("Q259=0.4", "Q259=1").replace("Q257=0", "Q257=5"), {"150": 7}),
    ],
)  # fmt: skip
def test_other_drilling_cycles(tmp_path: Path, cycle: str, feeds: dict[str, int]) -> None:
    """By the cycles' descriptions in the manuals, called in place, by M99 and at a position with a shift in Z."""
    calls = "CYCL CALL\nL X+150 Y+3 R0 FMAX M99\nCYCL CALL POS X+120 Y+40.5 Z-7.25 FMAX M8 ; third\nL Z+80 R0 FMAX\n"
    source = f"{HEAD}L X+10 Y+5 Z+70 R0 FMAX M3\n{cycle}{calls}END PGM D MM\n"
    written = compensated(tmp_path, source)
    ends_of_dos = compensated(tmp_path, source.replace("\n", "\r\n"))
    assert ends_of_dos == written.replace("\n", "\r\n")
    before, after = largest_error(source, written)
    assert before > 0.01
    assert after < ALONG
    for feed, number in feeds.items():
        assert len(re.findall(rf" F{feed}$", written, re.MULTILINE)) == 3 * number
    assert "M8 ; third\n" in written
    assert "CALL POS" not in written


OLDER = (
    "CYCL DEF 1.0 PECKING\nCYCL DEF 1.1 DIST-2.5\nCYCL DEF 1.2 DEPTH-{depth}\nCYCL DEF 1.3 PLNGNG8\n"
    "CYCL DEF 1.4 DWELL0.2\nCYCL DEF 1.5 F170\n"
)


@pytest.mark.parametrize(("depth", "holes"), [("20", 3), ("40", 5), ("8", 1)])
def test_the_older_pecking_begins_where_z_stands(tmp_path: Path, depth: str, holes: int) -> None:
    calls = "L X+150 Y+3 R0 FMAX M99\nL Z+61.5 FMAX\nL X+120 FMAX\nCYCL CALL\nL Z+80 R0 FMAX\n"
    source = f"{HEAD}L X+10 Y+5 Z+70 R0 FMAX M3\n{OLDER.format(depth=depth)}{calls}END PGM D MM\n"
    written = compensated(tmp_path, source)
    before, after = largest_error(source, written)
    assert before > 0.01
    assert after < ALONG
    assert len(re.findall(r"^L .* F170$", written, re.MULTILINE)) == 2 * holes
    assert written.count("DWELL 0.2\n") == 2


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
        (
            CYCLE.format(peck="Q5", second=9) + "L X+5 F100 M99",
            "CYCL DEF 200 is called with Q202=Q5, which is no number",
        ),
        (
            CYCLE.format(peck=9, second=9).replace("Q201=-", "Q201=+") + "CYCL CALL",
            "CYCL DEF 200 is called with a depth Q201 that is not below 0",
        ),
        (
            CYCLE.format(peck=9, second=9).replace("Q395=+0", "Q395=+1") + "CYCL CALL",
            "with Q395, which counts the depth from the edge",
        ),
        (
            CYCLE.format(peck=9, second=9) + "CYCL DEF 201 REAMING~\n Q200=2\nCYCL CALL",
            "CYCL DEF 201 is called without Q201",
        ),
        (
            CYCLE.format(peck=9, second=9) + "CYCL DEF 207 TAPPING~\n Q200=2\nCYCL CALL M3",
            "CYCL DEF 207 is called, which taps: its motions go with the spindle",
        ),
        (OLDER.format(depth="Q5") + "CYCL CALL", "CYCL DEF 1 is called without its five values"),
        (OLDER.format(depth="-5") + "CYCL CALL", "CYCL DEF 1 is called without its five values"),
        (OLDER.replace("-{depth}", "+5") + "CYCL CALL", "CYCL DEF 1 is called with a depth 1.2 that is not below 0"),
        (OLDER.format(depth=5) + "L M140 MB MAX\nCYCL CALL", "CYCL DEF 1 from where Z is not certain"),
        (UNIVERSAL.replace("Q213=0", "Q213=1.5") + "CYCL CALL", "with Q213, a number of breaks"),
        (PECKING.replace("Q212=0", "Q212=2").replace("Q205=3", "Q205=0") + "CYCL CALL", "more than 10000 pecks"),
        (PECKING.replace("Q257=0", "Q257=0.001") + "CYCL CALL", "more than 10000 pecks"),
        (PECKING.replace("Q256=0.2", "Q256=-0.2") + "CYCL CALL", "with Q256 below 0"),
        (PECKING.replace("Q379=0", "Q379=3") + "CYCL CALL", "Q379, which begins in a hole"),
        (UNIVERSAL + "CYCL CALL POS X+1 Y+2 FMAX", "CYCL CALL POS with other words"),
        (UNIVERSAL + "CYCL CALL POS X+1 Y+2 IZ+0 FMAX", "CYCL CALL POS with other words"),
        (UNIVERSAL + "CYCL CALL POS X+1 Y+2 Z+0 F500", "CYCL CALL POS with other words"),
        (UNIVERSAL + "CYCL CALL POS X+1 Y+2 Z+60 FMAX", "below the surface"),
        (UNIVERSAL + "CYCL CALL POS X+1 Y+2 Z+0 FMAX M9", "a code due at its end"),
        ("CYCL CALL POS X+1 Y+2 Z+0 FMAX M3", "calls a cycle"),
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
        assert "CYCL DEF 1, 200, 201, 203 and 205 with numbers" in caught.value.faults[0].remedy
