"""setup.toml: the contract's example is read, defaults are the contract's, and every fault is named."""

from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.measurement.adapter import Dmu60pAxes
from trueaxis.io.faults import InputError
from trueaxis.measurement.setup import PointOn, Run, Setup
from trueaxis.measurement.setup_reader import read_setup

CONTRACT = """schema = 1
machine = "dmu60p"
[[run]]
id = "X1"
instrument = "laser"                          # "laser" or "ballbar" or "probe"
direction = [1.0, 0.0, 0.0]                   # laser, probe: unit vector of the sensed direction, in `frame`
frame = "bed"                                 # or "workpiece"
target = { on = "tool", point = [167.0, 30.0, -195.0] }     # moving optic: point in the tool or workpiece frame
reference = { on = "bed" }                                  # or { on = "workpiece", point = [...] } or "tool"
home = { X = 0.0, Y = 0.0, Z = 0.0 }          # where the reading was set to zero
[[run]]
id = "XY-300-cw"
instrument = "ballbar"
length = 300.0                                # nominal
target = { on = "tool", point = [0.0, 0.0, 0.0] }            # tool ball
reference = { on = "workpiece", point = [270.0, 350.0, 0.0] } # workpiece ball
"""


def read_text(tmp_path: Path, text: str | bytes) -> Setup:
    path = tmp_path / "setup.toml"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return read_setup(path, Dmu60pAxes())


def faults_of(tmp_path: Path, text: str) -> list[str]:
    with pytest.raises(InputError) as caught:
        read_text(tmp_path, text)
    return [f"{fault.place}: {fault.problem}; {fault.remedy}" for fault in caught.value.faults]


def test_the_file_of_the_contract_is_read(tmp_path: Path) -> None:
    home = {"X": 0.0, "Y": 0.0, "Z": 0.0}
    laser = Run(
        id="X1",
        instrument="laser",
        target=PointOn("tool", (167.0, 30.0, -195.0)),
        reference=PointOn("bed"),
        frame="bed",
        home=home,
        direction=(1.0, 0.0, 0.0),
    )
    bar = Run(
        id="XY-300-cw",
        instrument="ballbar",
        target=PointOn("tool"),
        reference=PointOn("workpiece", (270.0, 350.0, 0.0)),
        frame="bed",
        home=home,
        length=300.0,
    )
    assert read_text(tmp_path, CONTRACT) == Setup("dmu60p", (laser, bar))


def test_defaults_are_bed_and_home_at_zero(tmp_path: Path) -> None:
    text = (
        'schema = 1\nmachine = "dmu60p"\n[[run]]\nid = "P"\ninstrument = "probe"\ndirection = [0, 0.6, 0.8]\n'
        'target = { on = "workpiece", point = [1, 2, 3] }\nhome = { Y = 350 }\n'
    )
    (run,) = read_text(tmp_path, text).runs
    assert (run.frame, run.reference, run.home) == ("bed", PointOn("bed"), {"X": 0.0, "Y": 350.0, "Z": 0.0})
    assert run.direction == (0.0, 0.6, 0.8)


# What of the contract is replaced by what, and how the fault begins.
FAULTS = [
    ("schema = 1", "schema = 2", "line 1, key schema: 2 is not a schema"),
    ('"dmu60p"', '"other"', "line 2, key machine: 'other' is another machine; machine = \"dmu60p\""),
    ('id = "X1"', 'id = "XY-300-cw"', 'line 12, key run[1].id: "XY-300-cw" names another run already'),
    ('id = "X1"\n', "", "line 3, key run[0].id: is missing"),
    ('id = "X1"', 'id = " X1"', "line 4, key run[0].id: is ' X1'"),
    ('"laser"  ', '"lazer"  ', "line 5, key run[0].instrument: is 'lazer'"),
    ("[1.0, 0.0, 0.0]  ", "[0.7071, 0.7071, 0.0] ", "line 6, key run[0].direction: has length 0.99999"),
    ("[1.0, 0.0, 0.0]  ", "[0, 0, 0] ", "line 6, key run[0].direction: has length 0 where a unit vector has 1"),
    ("[1.0, 0.0, 0.0]  ", "[nan, 0, 0] ", "line 6, key run[0].direction: is [nan, 0, 0]"),
    ("[1.0, 0.0, 0.0]  ", "[1.0, 0.0] ", "line 6, key run[0].direction: is [1.0, 0.0]"),
    ("direction = [1.0, 0.0, 0.0]", "", "line 3, key run[0].direction: is missing"),
    ('"bed"     ', '"tool"   ', "line 7, key run[0].frame: is 'tool'"),
    ('{ on = "tool", point = [167.0', '{ on = "bed", point = [167.0', "line 8, key run[0].target.on: is 'bed'"),
    ("point = [167.0, 30.0, -195.0]", "pt = [1, 2, 3]", "line 8, key run[0].target.point: is missing"),
    ("point = [167.0, 30.0, -195.0]", "pt = [1, 2, 3]", "line 8, key run[0].target.pt: is not a key"),
    ("{ on = \"bed\" }", '"bed"', "line 9, key run[0].reference: is 'bed'"),
    ("home = { X = 0.0,", "home = { A = 0.0,", "line 10, key run[0].home.A: machine dmu60p has no axis A"),
    ("home = { X = 0.0,", "home = { X = 541.0,", "line 10, key run[0].home.X: 541.0 is outside the travel"),
    ("home = { X = 0.0,", 'home = { X = "0",', "line 10, key run[0].home.X: is '0'; a finite number"),
    ("length = 300.0", "", "line 11, key run[1].length: is missing; the nominal length of the ball bar"),
    ("length = 300.0", "length = 0", "line 14, key run[1].length: is 0"),
    ("length = 300.0", "length = inf", "line 14, key run[1].length: is inf"),
    ("length = 300.0", "length = 3.0\ndirection = [1, 0, 0]", "line 15, key run[1].direction: a ball bar senses"),
    ('home = { X', 'length = 1.0\nhome = { X', "line 10, key run[0].length: a laser has no length"),
    ("reference = { on = \"workpiece\"", "ref = { on = \"workpiece\"", "line 11, key run[1].reference: is missing"),
    ('{ on = "workpiece", point = [270', '{ on = "tool", point = [270', "line 16, key run[1].reference: both"),
    ("[[run]]\nid", "[run]\nid", "line 11: is not TOML: Cannot"),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "expected"), FAULTS)
def test_each_fault_has_its_line_key_and_remedy(tmp_path: Path, old: str, new: str, expected: str) -> None:
    assert old in CONTRACT
    found = faults_of(tmp_path, CONTRACT.replace(old, new, 1))
    assert any(fault.startswith(expected) for fault in found), found


def test_a_run_that_senses_nothing_is_a_fault(tmp_path: Path) -> None:
    text = CONTRACT.replace('frame = "bed" ', 'frame = "workpiece" ').replace(
        'target = { on = "tool", point = [167.0', 'target = { on = "workpiece", point = [167.0'
    )
    resting = text.replace('reference = { on = "bed" }', 'reference = { on = "workpiece", point = [0, 0, 0] }')
    read_text(tmp_path, text)  # against the bed it senses the table's motion
    assert "nothing is sensed" in faults_of(tmp_path, resting)[0]


def test_homes_of_another_machine_are_one_fault_of_each_axis(tmp_path: Path) -> None:
    run = CONTRACT[CONTRACT.index("[[run]]") :].split("[[run]]")[1].replace("X = 0.0", "X = -1.0")
    text = 'schema = 1\nmachine = "dmu60p"\n' + "".join("[[run]]" + run.replace('"X1"', f'"X{k}"') for k in range(9))
    (fault,) = faults_of(tmp_path, text)
    assert "run[0].home.X: -1.0 is outside the travel, and so in 8 more runs; from 0.0 to 540.0" in fault


def test_a_home_that_is_no_table_is_one_fault(tmp_path: Path) -> None:
    found = faults_of(tmp_path, CONTRACT.replace("home = { X = 0.0,", "home = 5 #"))
    assert [one for one in found if "home" in one] == ["line 10, key run[0].home: is 5; a table [home]"]


def test_without_runs_there_is_nothing_to_read(tmp_path: Path) -> None:
    assert "key run: is missing" in faults_of(tmp_path, 'schema = 1\nmachine = "dmu60p"\n')[0]


def test_all_faults_come_at_once(tmp_path: Path) -> None:
    text = CONTRACT.replace("schema = 1", "schema = 9").replace('"X1"', "3").replace("300.0", "-300.0")
    assert [fault.split(":")[0] for fault in faults_of(tmp_path, text)] == [
        "line 1, key schema",
        "line 4, key run[0].id",
        "line 14, key run[1].length",
    ]


def check(setup: Setup) -> None:
    assert len({run.id for run in setup.runs}) == len(setup.runs) > 0
    for run in setup.runs:
        assert (run.length is None) == (run.instrument != "ballbar") == (run.direction is not None)
        assert set(run.home) == {"X", "Y", "Z"}


@given(at=st.integers(0, len(CONTRACT)), cut=st.integers(0, 20), piece=st.binary(max_size=6))
@settings(max_examples=400, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_damaged_bytes_read_or_are_refused_clearly(tmp_path: Path, at: int, cut: int, piece: bytes) -> None:
    raw = CONTRACT.encode()
    with suppress(InputError):
        check(read_text(tmp_path, raw[:at] + piece + raw[at + cut :]))


TOML_VALUES = st.sampled_from(
    ["1", "-0.0", "nan", "inf", "1e400", "9" * 5000, '"bed"', '"tool"', '""', "[]", "[[1]]", "true", "{}",
     "1979-05-27", "{ on = 3 }", '{ on = "bed", point = [1, 2] }', "{ X = true }", '["a", 1, 2]']
)  # fmt: skip


@given(data=st.data())
@settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_any_value_under_any_key_reads_or_is_refused_clearly(tmp_path: Path, data: st.DataObject) -> None:
    lines = CONTRACT.splitlines()
    for _ in range(data.draw(st.integers(1, 3))):
        number = data.draw(st.sampled_from([n for n, line in enumerate(lines) if " = " in line]))
        lines[number] = f"{lines[number].split(' = ')[0]} = {data.draw(TOML_VALUES)}"
    with suppress(InputError):
        check(read_text(tmp_path, "\n".join(lines)))


def test_compensation_and_report_are_read(tmp_path: Path) -> None:
    text = CONTRACT.replace("[[run]]", 'compensation = "active.json"\n\n[report]\nserial = "4711"\n\n[[run]]', 1)
    setup = read_text(tmp_path, text)
    assert setup.compensation is not None
    assert (setup.compensation.file, setup.compensation.location) == ("active.json", "line 3, key compensation")
    assert setup.report == {"serial": "4711"}
    assert read_text(tmp_path, CONTRACT).compensation is None
    none = read_text(tmp_path, CONTRACT.replace("[[run]]", 'compensation = "none"\n[[run]]', 1)).compensation
    assert none is not None
    assert none.file is None


def test_report_holds_texts_and_compensation_is_one(tmp_path: Path) -> None:
    faults = faults_of(tmp_path, CONTRACT.replace("[[run]]", "compensation = 3\n\n[report]\nserial = 4\n[[run]]", 1))
    assert {fault.split(":")[0] for fault in faults} == {"line 3, key compensation", "line 6, key report.serial"}


def test_a_point_beyond_any_machine_is_a_fault(tmp_path: Path) -> None:
    """Points of 1e308 mm ended in the linear algebra."""
    (fault,) = faults_of(tmp_path, CONTRACT.replace("[270.0, 350.0, 0.0]", "[1e308, 350.0, 0.0]"))
    assert "line 16, key run[1].reference.point" in fault
    assert "coordinates in mm, at most 100000" in fault
