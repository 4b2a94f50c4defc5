"""Values that no machine has are faults, each at its key; values that real machines have are not."""

import json
from pathlib import Path
from typing import Any

import pytest

from tests.machines import ROOT, machine_at
from trueaxis.io.faults import InputError
from trueaxis.machine import Machine
from trueaxis.model.believable import MOST_SIZES
from trueaxis.model.model import load_errors

MACHINE = machine_at(ROOT / "machines" / "dmu60p.toml")


def load(tmp_path: Path, machine: Machine = MACHINE, **keys: Any) -> None:
    path = tmp_path / "errors.json"
    path.write_text(json.dumps({"schema": 1, "machine": machine.name, **keys}))
    load_errors(path, machine)


def places(tmp_path: Path, **keys: Any) -> list[str]:
    with pytest.raises(InputError) as caught:
        load(tmp_path, **keys)
    return [fault.place for fault in caught.value.faults]


def polynomial(*coefficients: float) -> dict[str, Any]:
    return {
        "basis": "polynomial", "powers": list(range(1, len(coefficients) + 1)), "coefficients": list(coefficients)
    }  # fmt: skip


@pytest.mark.parametrize("value", [1e308, -1e308, 1e200, 25.0, -2.1])
def test_tables_beyond_a_hundred_sizes_are_refused(tmp_path: Path, value: float) -> None:
    curve = {"basis": "table", "positions": [0, 540], "values": [0.0, value]}
    assert places(tmp_path, motion_errors={"EXX": curve}) == ["motion_errors.EXX"]


@pytest.mark.parametrize("coefficients", [(1e308,), (0.0, 1e-3), (1e200, -1e200), (0.0,) * 98 + (1e300,)])
def test_polynomials_are_judged_over_the_travel(tmp_path: Path, coefficients: tuple[float, ...]) -> None:
    assert places(tmp_path, motion_errors={"EXX": polynomial(*coefficients)}) == ["motion_errors.EXX"]


def test_every_absurd_value_is_told_at_once(tmp_path: Path) -> None:
    found = places(
        tmp_path,
        parameters={"eps_xy": 1.0, "q_wx": 1e308, "eps_yz": -0.02},
        motion_errors={"EAX": polynomial(1.0), "EZY": {"basis": "table", "positions": [0], "values": [9.0]}},
    )
    assert sorted(found) == [
        "motion_errors.EAX", "motion_errors.EZY", "parameters.eps_xy", "parameters.eps_yz", "parameters.q_wx"
    ]  # fmt: skip


def test_a_poor_machine_is_believed(tmp_path: Path) -> None:
    """A belt-driven router: 1 mm of positioning error, 5 mm/m out of square; dimensions of metres."""
    load(tmp_path, parameters={"eps_xy": 5e-3, "q_wx": 4e3}, motion_errors={"EXX": polynomial(1.0 / 540.0)})


def test_the_prior_of_the_spec_decides(tmp_path: Path) -> None:
    text = (ROOT / "machines" / "dmu60p.toml").read_text().replace('runs = "dmu60p_runs"\n', "")
    spec = tmp_path / "dmu60p.toml"
    spec.write_text(text + "\n[prior.EXX]\num = 500.0\n")
    curve = {"basis": "table", "positions": [0, 540], "values": [0.0, 25.0]}
    load(tmp_path, machine_at(spec), motion_errors={"EXX": curve})


def test_the_limit_is_a_multiple_of_the_prior(tmp_path: Path) -> None:
    limit = MOST_SIZES * 0.02
    load(tmp_path, motion_errors={"EXX": {"basis": "table", "positions": [0, 540], "values": [0.0, 0.999 * limit]}})
    with pytest.raises(InputError, match="times the prior"):
        load(tmp_path, motion_errors={"EXX": {"basis": "table", "positions": [0, 540], "values": [0, 1.001 * limit]}})
