"""The JSON Schemas for editors against the readers, whose verdict counts.

Whatever a reader takes a schema has to take: an editor that marks what is right is worse than none. Of faulty files a
schema catches what can be said without the machine; what it cannot is named here, case by case.
"""

import copy
import json
import tomllib
from pathlib import Path
from random import Random
from typing import Any

import pytest
from jsonschema import Draft7Validator

from tests.fuzz import mutate, seeds
from tests.machine.test_faults import BASE, ONE_FAULT, TWO_FAULTS
from tests.machines import ROOT, machine_of
from tests.measurement.test_setup import CONTRACT, FAULTS
from tests.model.test_errors import CHANGES, CURVES, VALID
from trueaxis.io.faults import Faults, InputError
from trueaxis.machine.read import parse_machine
from trueaxis.measurement.setup_reader import read_setup
from trueaxis.model.errors import read_errors
from trueaxis.schemas.__main__ import main, schemas

FOLDER = ROOT / "docs" / "schemas"


def takes(name: str, tree: Any) -> bool:
    return bool(Draft7Validator(schemas()[f"{name}.schema.json"]).is_valid(tree))


def test_the_files_are_what_the_command_writes(tmp_path: Path) -> None:
    assert main([str(tmp_path)]) == 0
    assert {path.name for path in FOLDER.iterdir()} == set(schemas())
    for path in FOLDER.iterdir():
        assert path.read_text() == (tmp_path / path.name).read_text(), "python -m trueaxis.schemas docs/schemas"


def test_wrong_use_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == main(["--help"]) == 2
    assert "python -m trueaxis.schemas FOLDER" in capsys.readouterr().err


@pytest.mark.parametrize("name", schemas())
def test_each_is_a_schema(name: str) -> None:
    Draft7Validator.check_schema(schemas()[name])


OF_CONTROLS = ("offsets.toml", "tools.toml")  # of `compensate`, with no schema
SPECS = [
    path
    for part in ("machines", "examples", "tests")
    for path in sorted((ROOT / part).rglob("*.toml"))
    if path.name not in OF_CONTROLS
]


@pytest.mark.parametrize("path", SPECS, ids=lambda path: str(path.relative_to(ROOT)))
def test_files_of_the_repository_are_taken(path: Path) -> None:
    tree = tomllib.loads(path.read_text(encoding="utf-8"))
    name = "setup" if path.name == "setup.toml" else "machine"
    assert list(Draft7Validator(schemas()[f"{name}.schema.json"]).iter_errors(tree)) == []


def test_error_values_of_the_repository_are_taken() -> None:
    for path in (ROOT / "machines" / "dmu60p_errors.json", ROOT / "examples" / "worn_mill_errors.json"):
        assert takes("errors", json.loads(path.read_text()))
    assert takes("errors", VALID)


# What a schema cannot say of a spec: bodies, parameters and names together, the order of a travel, NaN, fractions.
BEYOND_MACHINE = {
    *("axis moved twice", "no such end", "ends the same", "idle body", "clash of parameters", "two bodies of a name"),
    *("travel the wrong way round", "travel of nothing", "travel is not finite", "travel is no number"),
    *("travel is beyond doubles", "a word of Python", "a word of C", "a component's name", "an axis's name"),
    *("a coordinate", "a fraction", "quotes in prose", "bars in a table", "position of nan", "another axis's error"),
    *("no lower body", "two bodies of one number", "a body on itself"),
}


def test_faulty_specs_are_marked_as_far_as_a_schema_can() -> None:
    changes = {case: (one[0], one[1]) for case, one in ONE_FAULT.items()}
    changes |= {case: one[0] for case, one in TWO_FAULTS.items()}
    assert takes("machine", tomllib.loads(BASE))
    taken = {case for case, (old, new) in changes.items() if takes("machine", tomllib.loads(BASE.replace(old, new)))}
    assert taken == BEYOND_MACHINE


# Of a set-up: the machine's name, axes and travel, ids that others have, lengths of vectors, NaN, two bodies together.
BEYOND_SETUP = {
    *('"other"', 'id = "XY-300-cw"', 'id = " X1"', "[0.7071, 0.7071, 0.0] ", "[0, 0, 0] ", "[nan, 0, 0] "),
    *("home = { A = 0.0,", "home = { X = 541.0,", '{ on = "tool", point = [270'),
}


def test_faulty_set_ups_are_marked_as_far_as_a_schema_can() -> None:
    assert takes("setup", tomllib.loads(CONTRACT))
    taken = set()
    for old, new, expected in FAULTS:
        if "is not TOML" not in expected and takes("setup", tomllib.loads(CONTRACT.replace(old, new, 1))):
            taken.add(new)
    assert taken == BEYOND_SETUP


# Of error values: which machine they are of and what it has, equal powers, lists of one length, rising positions.
BEYOND_ERRORS = {
    *("machine: ", "parameters.eps_xX: ", "parameters.zzz: "),
    *("motion_errors.EXX.coefficients: has ", "motion_errors.EXX.positions[1]: ", "motion_errors.EXX.values: has "),
    "motion_errors.EXX.values[0]: is not a finite",
}


def test_faulty_error_values_are_marked_as_far_as_a_schema_can() -> None:
    cases = [({**VALID, **change}, fault) for change, fault in CHANGES]
    cases += [({**VALID, "motion_errors": {"EXX": curve}}, fault) for curve, fault in CURVES]
    taken = {fault for tree, fault in cases if takes("errors", tree)}
    assert all(any(fault.startswith(one) for one in BEYOND_ERRORS) for fault in taken), taken
    assert all(any(fault.startswith(one) for fault in taken) for one in BEYOND_ERRORS), taken


@pytest.mark.parametrize("seed", range(12))
def test_what_a_reader_takes_no_schema_marks(seed: int, tmp_path: Path) -> None:
    """Valid files of random machines, each changed at random in many ways."""
    draw = Random(seed)
    spec = seeds.random_spec(draw)
    machine = machine_of(spec)
    files = seeds.valid_files(spec, draw)
    names = {"machine.toml": "machine", "data/setup.toml": "setup", "errors.json": "errors"}
    accepted = 0
    for file, name in names.items():
        for round_ in range(40):
            data = files[file] if round_ == 0 else mutate.text(files[file], draw)
            path = tmp_path / Path(file).name
            path.write_bytes(data)
            if not read(name, path, machine):
                continue
            accepted += 1
            text = data.decode().removeprefix("\ufeff")
            tree = json.loads(text) if name == "errors" else tomllib.loads(text)
            assert takes(name, tree), text
    assert accepted > len(names)


def read(name: str, path: Path, machine: Any) -> bool:
    """Whether the reader takes the file."""
    try:
        if name == "machine":
            parse_machine(path.read_bytes().decode("utf-8", "strict"), Faults(str(path)))
        elif name == "setup":
            read_setup(path, _Axes(machine))
        else:
            components = [str(one) for one in machine.components]
            parameters = machine.parameters
            read_errors(path, machine=machine.name, components=components, parameters=parameters)
    except (InputError, UnicodeDecodeError):
        return False
    return True


class _Axes:
    """What the reader of a set-up asks of a machine."""

    def __init__(self, machine: Any) -> None:
        self.name, self.axes, self.travel = machine.name, machine.axes, machine.travel


def test_a_slip_of_the_pen_is_marked() -> None:
    tree = copy.deepcopy(VALID)
    tree["motion_errors"]["EXX"]["coeficients"] = tree["motion_errors"]["EXX"].pop("coefficients")
    assert not takes("errors", tree)
