"""Specs with sizes that no machine has, and with more of everything than a machine has: short faults, soon."""

import time

import pytest

from tests.machine.test_faults import BASE, faults_of
from tests.machines import DMU60P
from trueaxis.machine.body import FARTHEST, MOST_DEGREES, SHORTEST_TRAVEL
from trueaxis.machine.read import MOST_BODIES

MILL = DMU60P.read_text()
CODE = 'schema = 1\nname = "m"\nstructure = "[w C\' b X t]"\n[axis.X]\ntravel = {}\n[axis.C]\ntravel = {}\n'


@pytest.mark.parametrize(
    ("linear", "rotary", "place", "problem", "remedy"),
    [
        (
            "[0.0, 1e308]",
            "[0, 9]",
            "line 5, key axis.X.travel",
            "runs from 0 to 1e+308",
            f"at most {FARTHEST:g} from 0",
        ),
        ("[-1e308, 1e308]", "[0, 9]", "line 5, key axis.X.travel", "runs from -1e+308", f"at most {FARTHEST:g} from 0"),
        ("[0.0, 1e-320]", "[0, 9]", "line 5, key axis.X.travel", "runs from 0 to", f"{SHORTEST_TRAVEL:g} mm at least"),
        ("[0, 9]", "[0.0, 1e300]", "line 7, key axis.C.travel", "to 1e+300", f"in deg, at most {MOST_DEGREES:g}"),
    ],
)
def test_travels_that_no_axis_has(linear: str, rotary: str, place: str, problem: str, remedy: str) -> None:
    (fault,) = faults_of(CODE.format(linear, rotary))
    assert fault.place == place
    assert problem in fault.problem
    assert remedy in fault.remedy


@pytest.mark.parametrize("value", ["1e308", "-100001.0", "9223372036854775807", "nan", "1e400"])
def test_positions_that_no_body_has(value: str) -> None:
    (fault,) = faults_of(CODE.format("[0, 9]", "[0, 9]") + f"[tool]\nposition = [0, {value}, 0]\n")
    assert fault.place == "line 9, key tool.position"
    assert f"at most {FARTHEST:g}" in fault.remedy


KIND = '[[effect_kind]]\nname = "k"\n'
EXX = '"EXX",'
LONG_NAME = f'schema = 1\nname = "{"m" * 300}"\nstructure = "[w b X t]"\n[axis.X]\ntravel = [0, 9]\n'


def many(head: str, count: int) -> str:
    return "".join(f'[[body]]\nnumber = {k}\nname = "b{k}"\nlower = {k - 1}\n' for k in range(2, 2 + count)) + head


@pytest.mark.parametrize(
    ("text", "place", "problem"),
    [
        (BASE + f"[{'k' * 1_000_000}]\n", f"line 42, key {'k' * 60} ...", "is not a key of this table"),
        (BASE + f"x = [{'1,' * 1_000_000}]\n", "line 42, key references.x", "is not a key of this table"),
        (MILL.replace('"all"', f"[{EXX * 100_000}]", 1), "", "has 100000 entries"),
        (
            f'schema = 1\nname = "m"\n[ends]\nworkpiece = 1\ntool = 9\n{many("", 20_000)}',
            "line 6, key body",
            "has 20000 tables",
        ),
        (LONG_NAME, "line 2, key name", "is 'mmm"),
        (BASE + KIND + 'expression = "a' + "+a" * 1_000_000 + '"\n', "", "characters are too many"),
        (BASE + KIND + 'expression = "a\\u001b[2J"\n', "line 44", "is 'a\\x1b[2J'"),
        (BASE + "[[effect]]\nkind = 'backlash'\n" * 5_000, "", "is missing"),
    ],
    ids=["key", "array", "motion errors", "bodies", "name", "expression", "control", "effects"],
)  # fmt: skip
def test_more_than_a_machine_has_is_told_short_and_soon(text: str, place: str, problem: str) -> None:
    before = time.perf_counter()
    faults = faults_of(text)
    assert time.perf_counter() - before < 20
    assert any(place in fault.place and problem in fault.problem for fault in faults), [str(one) for one in faults][:9]
    assert max(len(str(fault)) for fault in faults) < 3000


def test_as_many_bodies_as_are_allowed_are_read() -> None:
    head = f"[ends]\nworkpiece = 1\ntool = {MOST_BODIES + 1}\n"
    faults = faults_of('schema = 1\nname = "m"\n' + many(head, MOST_BODIES) + "odd = 1\n")
    assert [fault.problem for fault in faults] == ["is not a key of this table"]
