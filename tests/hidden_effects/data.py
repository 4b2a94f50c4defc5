"""Measured data as a user has them: what can be read of them, and the files."""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tests.hidden_effects.design import Design
from tests.hidden_effects.given import Given
from tests.hidden_effects.machine import Array, Machine
from tests.hidden_effects.state import Plan, RunPlan


@dataclass(frozen=True, eq=False)
class Data:
    """reading: (n,), mm; thermometer: (n,), degC, as read; leave_out: position errors (EC0X) that the spec has not."""

    machine: Machine
    plan: Plan
    reading: Array
    thermometer: Array
    given: Given
    design: Design
    leave_out: tuple[str, ...] = ()

    @property
    def spec(self) -> str:
        """machine.toml."""
        return self.machine.spec(tuple(self._location_names()[name] for name in self._left_out()))

    @property
    def errors(self) -> str:
        """errors.json."""
        names = self._location_names()
        values = {names[key]: value for key, value in self.given.located.items() if key not in self._left_out()}
        tree = {
            "schema": 1,
            "machine": self.machine.name,
            "parameters": dict(self.machine.dimensions) | values,
            "motion_errors": dict(self.given.motion_errors),
            "effects": [],
        }
        return json.dumps(tree, indent=1) + "\n"

    @property
    def setup(self) -> str:
        """setup.toml."""
        return f'schema = 1\nmachine = "{self.machine.name}"\n' + "".join(map(_run_text, self.plan.runs))

    @property
    def readings(self) -> str:
        """readings.csv."""
        state, axes = self.plan.state, self.machine.axes
        ids = [run.id for run in self.plan.runs]
        columns: dict[str, list[str]] = {
            "run": [ids[index] for index in state.run],
            "seq": [str(seq) for seq in state.seq],
        }
        if self.design.times:
            columns["time_s"] = _cells(np.round(state.time, 3))
        columns |= {axis: _cells(state.positions[axis]) for axis in axes}
        columns |= {f"dir_{axis}": [str(int(value)) for value in state.directions[axis]] for axis in axes}
        columns["feed"] = _cells(state.feed)
        if self.design.temperature:
            columns["temperature_c"] = _cells(self.thermometer)
        columns["reading"] = _cells(self.reading)
        lines = [",".join(columns), *(",".join(row) for row in zip(*columns.values(), strict=True))]
        return "\n".join(lines) + "\n"

    def write(self, folder: Path) -> None:
        """machine.toml, errors.json, data/setup.toml and data/readings.csv."""
        (folder / "data").mkdir(parents=True, exist_ok=True)
        (folder / "machine.toml").write_text(self.spec)
        (folder / "errors.json").write_text(self.errors)
        (folder / "data" / "setup.toml").write_text(self.setup)
        (folder / "data" / "readings.csv").write_text(self.readings)

    def _location_names(self) -> dict[str, str]:
        return {f"{d}0{j.moves}": name for j in self.machine.joints for d, name in j.located.items()}

    def _left_out(self) -> tuple[str, ...]:
        return tuple(name for name in self.leave_out if name in self._location_names())


def _cells(values: Array) -> list[str]:
    return ["" if np.isnan(value) else repr(float(value)) for value in values]


def _run_text(run: RunPlan) -> str:
    lines = ["", "[[run]]", f'id = "{run.id}"', f'instrument = "{run.instrument}"']
    if run.direction is not None:
        lines += [f"direction = {_vector(run.direction)}", 'frame = "bed"']
    if run.home is not None:
        lines.append("home = { " + ", ".join(f"{axis} = {float(value)!r}" for axis, value in run.home.items()) + " }")
    if run.length is not None:
        lines.append(f"length = {run.length!r}")
    for end, (body, point) in (("target", run.target), ("reference", run.reference)):
        lines.append(f'{end} = {{ on = "{body}", point = {_vector(point)} }}')
    return "\n".join([*lines, ""])


def _vector(values: Array) -> str:
    return "[" + ", ".join(repr(float(value)) for value in values) + "]"
