"""What an instrument comes back to was set up anew, as far as nobody says otherwise."""

from collections.abc import Sequence
from dataclasses import replace

import pytest

from tests.identification.data import bar, tool
from trueaxis.estimation.instruments import shared_unknowns
from trueaxis.estimation.set_up_anew import Taken, set_ups
from trueaxis.measurement.setup import Device, PointOn, Run

HOUR = 3600.0
SHARED = {"laser": "laser cosine", "ballbar": "ballbar centre"}


def run_of(letter: str, name: str, session: str) -> Run:
    """X, Y, Z: a line of a laser; x: the same of another laser; B, C: two balls of a ball bar; P: a probe."""
    if letter in "BC":
        one = replace(bar(name, 600.0), session=session)
        return one if letter == "B" else replace(one, reference=PointOn("workpiece", (5.0, 5.0, 5.0)))
    one = tool(name, letter.lower() if letter != "P" else "z", (0.0, 0.0, 0.0))
    one = replace(one, session=session, instrument="probe") if letter == "P" else replace(one, session=session)
    return replace(one, device=Device(id="other")) if letter.islower() else one


def numbers(letters: str, sessions: str = "", ends: Sequence[float] = ()) -> tuple[list[Run], list[Taken], list[int]]:
    """Runs, as they were taken, each an hour long and so many hours after the start; numbers of their set-ups."""
    runs = [run_of(one, str(k), sessions[k : k + 1].strip()) for k, one in enumerate(letters)]
    taken = [Taken(k, *((ends[k] - 1.0) * HOUR, ends[k] * HOUR) if ends else ()) for k in range(len(runs))]
    found = set_ups(runs, taken)
    return runs, taken, [found.get(k, -1) for k in range(len(runs))]


@pytest.mark.parametrize(
    ("letters", "sessions", "expected"),
    [
        ("XXYX", "", [0, 0, 1, 2]),  # back on the line after another: aligned anew
        ("XXYX", "1112", [0, 0, 0, 0]),  # sessions are named: they tell it
        ("XXYYZZ", "", [0, 0, 1, 1, 2, 2]),
        ("XBX", "", [0, 0, 0]),  # a ball bar leaves the laser where it is
        ("XxX", "", [0, 0, 0]),  # another laser, by its name
        ("BBCB", "", [0, 0, 1, 2]),  # back on the ball after another
        ("BBCB", "1122", [0, 0, 0, 0]),
        ("BXB", "", [0, 0, 1]),  # the optics of the laser took the place of the ball in the spindle
        ("BPB", "", [0, -1, 1]),
    ],
)
def test_what_it_comes_back_to_was_set_up_anew(letters: str, sessions: str, expected: list[int]) -> None:
    runs, taken, found = numbers(letters, sessions)
    assert found == expected
    unknowns = shared_unknowns(runs, taken, [False] * len(runs))
    for instrument, kind in SHARED.items():
        told = {
            (one.session, one.device, one.reference, one.direction, number)
            for one, number in zip(runs, found, strict=True)
            if one.instrument == instrument
        }
        assert len([one for one in unknowns if one.kind == kind and one.coordinate == 0]) == len(told)


@pytest.mark.parametrize("letter", ["X", "B"])
def test_a_night_ends_a_set_up_and_a_break_does_not(letter: str) -> None:
    assert numbers(letter * 4, ends=[1.0, 3.0, 20.0, 24.0])[2] == [0, 0, 1, 1]


def test_a_night_is_not_told_without_a_clock() -> None:
    assert numbers("BB")[2] == [0, 0]
