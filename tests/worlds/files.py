"""A world as files, in the formats that users have."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from tests.worlds.design import Design
from tests.worlds.machine import Array, Machine
from tests.worlds.plan import Run
from tests.worlds.readings import Data
from tests.worlds.stale import Given, nothing_given
from tests.worlds.truth import Truth

THERMOMETER = 2  # decimals


def write_world(
    folder: Path, design: Design, truth: Truth, data: Data | None, given: Given | None = None, *, sessions: bool = False
) -> None:
    """Write machine.toml, errors.json, data/setup.toml and data/readings.csv.

    data: None writes a plan, without readings; given: the values of errors.json, else zeros; sessions: say which runs
    are of one session, and what the displays resolve (keys of the second round).
    """
    left_out = tuple(effect.component for effect in truth.effects if effect.kind == "squareness")
    (folder / "data").mkdir(parents=True, exist_ok=True)
    (folder / "machine.toml").write_text(spec_toml(design.machine, left_out))
    (folder / "errors.json").write_text(errors_json(design.machine, given or nothing_given(design.machine), left_out))
    (folder / "data" / "setup.toml").write_text(setup_toml(design, sessions=sessions))
    (folder / "data" / "readings.csv").write_text(readings_csv(design, None if data is None else data.reading))


def spec_toml(machine: Machine, left_out: Sequence[str] = (), prior: Mapping[str, float] | None = None) -> str:
    """left_out: location errors that the spec is not to know; prior: what its table [prior] says."""
    lines = ["schema = 1", f'name = "{machine.name}"', f'title = "{machine.name.replace("_", " ")}"']
    if machine.true_rotations:
        lines.append('rotations = "true"')
    for body in machine.bodies:
        lines += ["", "[[body]]", f"number = {body.number}", f'name = "{body.name}"', f"lower = {body.lower}"]
        if body.moves:
            lines += [f'moves = "{body.moves}"', f"travel = {_numbers(body.travel)}"]
            everything = len(body.motion) == 6
            lines.append("motion_errors = " + ('"all"' if everything else json.dumps(list(body.motion))))
        if body.sense < 0:
            lines.append("sense = -1")
        if body.names:
            lines.append("position = " + json.dumps(list(body.names)))
        elif any(body.offset):
            lines.append(f"position = {_numbers(body.offset)}")
        kept = [f'{direction} = "{name}"' for direction, name in body.located if name not in left_out]
        if kept:
            lines.append("position_errors = { " + ", ".join(kept) + " }")
    lines += ["", "[ends]", f"workpiece = {machine.workpiece}", f"tool = {machine.tool}", ""]
    if prior:
        lines += ["[prior]", *(f"{name} = {size!r}" for name, size in prior.items()), ""]
    return "\n".join(lines)


def errors_json(machine: Machine, given: Given, left_out: Sequence[str] = ()) -> str:
    located = {name: value for name, value in given.located.items() if name not in left_out}
    tree = {
        "schema": 1,
        "machine": machine.name,
        "parameters": dict(machine.dimensions) | located,
        "motion_errors": dict(given.motion_errors),
    }
    return json.dumps(tree, indent=1) + "\n"


def setup_toml(design: Design, *, sessions: bool = False) -> str:
    heads = ["schema = 1", f'machine = "{design.machine.name}"', ""]
    devices = _devices(design) if sessions else []
    return "\n".join(heads) + "".join([*(_run_text(run, sessions) for run in design.plan.runs), *devices])


def _devices(design: Design) -> list[str]:
    """A device per instrument, with the steps of its display where it has some."""
    found = {}
    for index, run in enumerate(design.plan.runs):
        step = float(design.shop.resolution[design.plan.rows(index)[0]])
        resolves = f"resolution_um = {1e3 * step:.6g}\n" if step else ""
        found[run.instrument] = f"\n[device.{run.instrument}]\n{resolves}"
    return list(found.values())


def readings_csv(design: Design, reading: Array | None) -> str:
    """The rows in the order of reading; reading: (n,), mm, or None for a plan."""
    plan, axes, chosen = design.plan, design.machine.axes, design.columns
    columns: dict[str, list[str]] = {
        "run": [plan.runs[index].id for index in plan.run],
        "seq": [str(number) for number in plan.seq],
    }
    if "time_s" in chosen:
        columns["time_s"] = _cells(np.round(plan.time, 3))
    columns |= {axis: _cells(plan.positions[axis]) for axis in axes}
    if "directions" in chosen:
        columns |= {f"dir_{axis}": [str(int(value)) for value in plan.directions[axis]] for axis in axes}
    if "feed" in chosen:
        columns["feed"] = _cells(plan.feed)
    if "temperature_c" in chosen:
        columns["temperature_c"] = _cells(np.round(plan.temperature, THERMOMETER))
    columns["reading"] = [""] * plan.count if reading is None else _cells(reading)
    lines = [",".join(columns), *(",".join(row) for row in zip(*columns.values(), strict=True))]
    return "\n".join(lines) + "\n"


def points_csv(machine: Machine, positions: Mapping[str, Array], tool_point: Array) -> str:
    """A table of points for `predict`."""
    table = np.column_stack([*(positions[axis] for axis in machine.axes)])
    tool = np.broadcast_to(np.asarray(tool_point, float), (len(table), 3))
    head = ",".join([*machine.axes, "tool_x", "tool_y", "tool_z"])
    return "\n".join([head, *(",".join(map(repr, row)) for row in np.hstack([table, tool]).tolist())]) + "\n"


def deviations_csv(deviation: Array) -> str:
    """deviation: (n, 3), mm."""
    return "\n".join(["dx,dy,dz", *(",".join(map(repr, row)) for row in deviation.tolist())]) + "\n"


def _run_text(run: Run, sessions: bool) -> str:
    lines = ["", "[[run]]", f'id = "{run.id}"', f'instrument = "{run.instrument}"']
    if run.direction is not None:
        lines += [f"direction = {_numbers(run.direction)}", f'frame = "{run.frame}"']
    if run.home is not None:
        said = {axis: value for axis, value in run.home.items() if value != 0.0}
        if said:
            lines.append("home = { " + ", ".join(f"{axis} = {value!r}" for axis, value in said.items()) + " }")
    if run.length is not None:
        lines.append(f"length = {run.length!r}")
    if sessions:
        lines += [f'session = "{run.session + 1}"', f'device = "{run.instrument}"']
    for end, (on, point) in (("target", run.target), ("reference", run.reference)):
        lines.append(f'{end} = {{ on = "{on}", point = {_numbers(point)} }}')
    return "\n".join([*lines, ""])


def _numbers(values: Sequence[float]) -> str:
    return "[" + ", ".join(repr(float(value)) for value in values) + "]"


def _cells(values: Array) -> list[str]:
    return ["" if np.isnan(value) else repr(value) for value in values.tolist()]
