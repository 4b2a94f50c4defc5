"""A small machine with effects, its kernels, and readings simulated on it by the command.

The tool stands on Z on Y on X, the workpiece on the bed: at X Y Z the tool is at (X, Y, Z) of the workpiece.
"""

import json
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import polars as pl

from tests.kernels import model_of
from tests.machines import HEAD, toml
from tests.measurement.command_line import command_line
from trueaxis.cli import simulate
from trueaxis.codegen.render import render
from trueaxis.io.files import write_files

FloatArray = npt.NDArray[np.float64]

SPIKES = ("reversal_spike", "reversal_spike_time", "reversal_spike_path")
TRAVEL = (-300.0, 500.0)
EFFECTS: tuple[dict[str, Any], ...] = (
    *({"kind": "backlash", "component": name} for name in ("EXX", "EYX", "EYY")),
    *({"kind": "servo_lag", "component": name} for name in ("EXX", "EYY")),
    *(
        {"kind": name, "component": "EXX"}
        for name in ("cyclic", "thermal_expansion", "warm_up", "drift", *SPIKES, "table_sag")
    ),
    {"kind": "cross_axis", "component": "EXX", "axis": "Y"},
    {"kind": "squareness", "component": "EC0Y"},
    {"kind": "laser_cosine", "runs": ["X1"]},
    {"kind": "laser_step", "runs": ["X1"]},
    {"kind": "laser_scale"},
    {"kind": "reading_zero", "runs": ["X1", "ccw"]},
    {"kind": "reading_slope", "runs": ["X1"]},
    {"kind": "point_offset", "runs": ["X1"], "end": "target"},
    {"kind": "ballbar_centre", "runs": ["ccw"]},
    {"kind": "ballbar_length"},
    {"kind": "ballbar_lobes"},
)


@cache
def spec_text() -> str:
    errors = {"X": ["EXX", "EYX", "ECX"], "Y": ["EXY", "EYY"], "Z": ["EZZ"]}
    parts = [HEAD, '[[body]]\nnumber = 2\nname = "table"\nlower = 1\n']
    for number, axis in zip((3, 4, 5), "XYZ", strict=True):
        body = {"number": number, "name": axis, "lower": 1 if axis == "X" else number - 1, "moves": axis}
        body |= {"travel": list(TRAVEL), "motion_errors": errors[axis]}
        parts.append("[[body]]\n" + "".join(f"{key} = {toml(value)}\n" for key, value in body.items()))
    parts.append('[[body]]\nnumber = 6\nname = "tool"\nlower = 5\n[ends]\nworkpiece = 2\ntool = 6\n')
    parts.append(
        '[[effect_kind]]\nname = "table_sag"\nexpression = "sag*s*(1 - s)*T"\ncomponents = ["EXX"]\n'
        'parameters.sag = { unit = "u/K", meaning = "sag" }\n'
    )
    parts += ["[[effect]]\n" + "".join(f"{key} = {toml(value)}\n" for key, value in one.items()) for one in EFFECTS]
    return "".join(parts)


def write_machine(folder: Path) -> Path:
    """The spec and, in folder/generated, its kernels."""
    spec = folder / "test.toml"
    spec.write_text(spec_text())
    files = render(model_of(spec_text()))
    write_files({folder / "generated" / "test" / name: content for name, content in files.items()})
    return spec


def effect(kind: str, component: str | None = None, **parameters: float) -> dict[str, Any]:
    """An effect of the machine as errors.json has it."""
    found = next(one for one in EFFECTS if one["kind"] == kind and one.get("component") == component)
    return {**found, "parameters": parameters}


def errors_text(effects: Sequence[Mapping[str, Any]], **curves: Sequence[float]) -> str:
    """curves: coefficients of the powers 1, 2, ... by component."""
    motion = {
        name: {"basis": "polynomial", "powers": list(range(1, len(row) + 1)), "coefficients": list(row)}
        for name, row in curves.items()
    }
    return json.dumps({"schema": 1, "machine": "test", "motion_errors": motion, "effects": list(effects)})


def simulated(
    spec: Path, work: Path, setup: str, columns: Mapping[str, Any], effects: Sequence[Mapping[str, Any]], **curves: Any
) -> FloatArray:
    """Readings, in the order of the rows, from columns of readings.csv without the readings."""
    plan, out = work / "plan", work / "out"
    plan.mkdir(exist_ok=True)
    (plan / "setup.toml").write_text('schema = 1\nmachine = "test"\n' + setup)
    frame = pl.DataFrame(dict(columns)).with_columns(reading=pl.lit(""))
    frame.write_csv(plan / "readings.csv")
    (work / "errors.json").write_text(errors_text(effects, **curves))
    options = ("--errors", work / "errors.json", "--data", plan, "--out", out)
    assert command_line(simulate, spec, spec.parent / "generated", *options) == 0
    return pl.read_csv(out / "readings.csv")["reading"].to_numpy()
