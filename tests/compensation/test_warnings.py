"""What may cost a crash or a wrong part is said apart from what is only to be known, and before it."""

import re
from typing import Any

import pytest

from tests.compensation.analytic_machine import paper_sized
from tests.compensation.control import Bench
from tests.compensation.test_offsets import KNOWN
from tests.compensation.test_tools import TABLE
from trueaxis.compensation.offsets import Offsets
from trueaxis.io.faults import InputError

FANUC: dict[str, Any] = {"dialect": "fanuc", "tools": TABLE, "offsets": KNOWN, "pass_m": (6,)}
HEAD = "G21 G90 G17 G54\nT1 M6\nG43 H1 G0 X10. Y10. Z150.\nG1 Z140. F200.\n"
WITHOUT = "is moved without its length"


def test_warnings_stand_first(bench: Bench) -> None:
    """A note, which the same program has too, stands behind the figures."""
    bench.run(HEAD + "T2\nM6\nG43 H1 G0 Z120.\nG91 G28 Z0.\nM30\n", paper_sized(), **FANUC)
    lines = bench.told.splitlines()
    assert lines[1].startswith("WARNING: line 7: the length of tool 1 is put in force while tool 2")
    assert not any("WARNING" in line for line in lines[2:])
    assert next(number for number, line in enumerate(lines) if line.startswith("note: ")) > 4
    assert not set(bench.report.warnings) & set(bench.report.notes)


def test_what_is_not_good_is_said_before_warnings(bench: Bench) -> None:
    bench.run("G21 G90\nG0 X10. Y10. Z30.\nG1 X20. F500\nM30\nX5.\n", paper_sized(), tolerance=1e-5)
    lines = bench.told.splitlines()
    assert lines[1].startswith("not good")
    assert all(line.startswith("WARNING: ") for line in lines[2:4])


@pytest.mark.parametrize(
    ("blocks", "line"),
    [
        ("G49\nG0 Z150.\n", 6),
        ("G49\nG1 X20.\n", 6),
        ("G49\nG0 X20.\nZ150.\n", 7),  # a rapid across changes no depth
        ("T2 M6\nG0 X20. Y10.\nG1 X30.\nG43 H2 Z150.\n", 0),  # the length of tool 1 is said to stay
        ("G49\nT2 M6\nG0 X20. Y10.\nZ160.\nG1 Z150.\n", 8),
        ("G49\nG53 G0 Z0.\n", 0),
        ("G91 G49 G28 Z0.\nG90 T2 M6\nG43 H2 G0 Z150.\n", 0),
        ("G49\nM30\n", 0),
    ],
)
def test_a_tool_that_is_moved_without_its_length(bench: Bench, blocks: str, line: int) -> None:
    bench.run(f"{HEAD}{blocks}", paper_sized(), **FANUC)
    found = [one for one in bench.report.warnings if WITHOUT in one]
    assert len(found) == bool(line)
    assert not line or found[0].startswith(f"line {line}: tool ")


def test_a_length_of_zero_is_missed_by_nobody(bench: Bench) -> None:
    table = type(TABLE)({1: type(TABLE.tools[1])(0.0, point=(0.0, 0.0, -80.0))})
    bench.run("G21 G90 G54\nT1 M6\nG0 X1. Y1. Z1.\nG1 X2. F100\nM30\n", paper_sized(), **(FANUC | {"tools": table}))
    assert not bench.report.warnings


def test_lengths_in_the_words_of_an_unrolled_program_are_missed_by_nobody(bench: Bench) -> None:
    unrolled = "G21 G90 G94 G17 G40 G49 G80\nG10 L2 P9 X0 Y0 Z0\nG59.3\nT1\nM6\nG0 X1. Y1. Z200.\nG1 X2. F100\nM2\n"
    on_linuxcnc = FANUC | {"dialect": "linuxcnc", "offsets": Offsets()}
    bench.run(unrolled, paper_sized(), judged=True, **on_linuxcnc)
    assert not bench.report.warnings
    bench.run(unrolled, paper_sized(), **on_linuxcnc)
    assert WITHOUT in bench.report.warnings[0]


SINUMERIK: dict[str, Any] = {"dialect": "siemens", "tools": TABLE, "offsets": KNOWN, "pass_m": (6,)}
SHOP = "N10 G71 G90 G17 G54 G94\nT1 D1 M6\nG0 X10 Y10 Z50 S900 M3\nG1 Z0 F200\nG153 G0 Z499 D0\nD1\n"


def test_a_length_put_in_force_moves_no_axis_on_sinumerik(bench: Bench) -> None:
    """The report said that Z was never commanded, and took it to stand at home."""
    bench.run(f"{SHOP}G0 X40 Y20\nZ50\nG1 X60 F200\nM30\n", paper_sized(), **SINUMERIK)
    assert bench.report.unknown_places is None
    assert not bench.report.failures
    bench.run(f"{SHOP}G1 X40 F200\nM30\n", paper_sized(), tolerance=1e-4, **SINUMERIK)
    assert bench.report.unnamed_feeds is None
    assert "lines 7: an axis has no word there" in bench.told


@pytest.mark.parametrize("step", ["Z=IC(-5)", "G91 Z-5"])
def test_an_increment_behind_a_new_length(bench: Bench, step: str) -> None:
    """Whether the length is added to it depends on the control's setting data."""
    with pytest.raises(InputError, match=r"line 8: an increment of Z beside a new tool length"):
        bench.run(f"{SHOP}G0 X40 Y20\n{step}\nM30\n", paper_sized(), **SINUMERIK)
    bench.run(f"{SHOP}G0 X40 Y20 Z50\n{step}\nM30\n", paper_sized(), **SINUMERIK)


def test_a_length_that_is_ended_in_machine_coordinates_is_no_warning(bench: Bench) -> None:
    bench.run(f"{SHOP}G0 Z50\nG1 X40 F200\nSUPA G0 Z499 D0\nM30\n", paper_sized(), **SINUMERIK)
    assert not bench.report.warnings
    bench.run(f"{SHOP}G0 Z50\nD0\nG1 X40 F200\nM30\n", paper_sized(), **SINUMERIK)
    assert re.match(r"line 9: tool 1 is moved without its length .*: D0 has ended it", bench.report.warnings[0])


def test_a_program_without_offset_names_what_to_say(bench: Bench) -> None:
    bench.run("G21 G90\nG0 X10. Y10. Z30.\nM30\n", paper_sized(), offsets=Offsets(), dialect="fanuc")
    assert "--offset G54=X..,Y..,Z.." in bench.told.splitlines()[1]
