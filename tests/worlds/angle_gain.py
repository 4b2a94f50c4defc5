"""What angle runs tell: angular errors from laser lines along the motions alone, and with angle runs beside.

    python -m tests.worlds.angle_gain FIRST LAST

Pitch and yaw of the linear axes: root mean squares over the travels, from home, of the true errors and of what the
estimate is off by; how many are determined by data; coverage of 95 % intervals at 11 points of each travel.
"""

import sys
import tempfile
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from tests.kept import derived
from tests.worlds.angles import draw_angles, write_angles
from tests.worlds.design import draw_design
from tests.worlds.files import write_world
from tests.worlds.readings import measure
from tests.worlds.truth import Truth, draw_machine
from trueaxis.jobs.identify import Identified, identify
from trueaxis.jobs.load import DataFolder, load_data, load_errors, load_model
from trueaxis.measurement.data import MeasuredData
from trueaxis.model.curves import LegendreCurve
from trueaxis.model.model import MachineModel
from trueaxis.planning.runs import PlannedRuns

URAD, WITHIN, POINTS = 1e-6, 1.96, 11


def main(arguments: Sequence[str]) -> int:
    first, last = map(int, arguments)
    print("seed  runs               lines                          lines and angles")
    print("      lines angles true  off   determined     coverage  off   determined     coverage  (urad)")
    for seed in range(first, last + 1):
        with tempfile.TemporaryDirectory() as folder:
            print(line(seed, Path(folder)), flush=True)
    return 0


def line(seed: int, folder: Path) -> str:
    design = draw_design(seed)
    truth = draw_machine(design.machine, seed)
    write_world(folder, design, truth, measure(design, truth, seed), sessions=True)
    write_angles(folder, design, draw_angles(design, truth, seed))
    model = load_model(folder / "machine.toml", derived(folder / "machine.toml"))
    known = load_errors(folder / "errors.json", model)
    dimensions = {name: known.values.parameters[name] for name in model.dimensions}
    known = replace(known, values=replace(known.values, motion_errors={}, parameters=dimensions))
    data = load_data(folder / "data", model)
    lines = {run.id for run in design.plan.runs if run.instrument == "laser" and not run.across}
    angles = {run.id for run in data.data.setup.runs if run.instrument == "angle"}
    said = [f"{seed}  {len(lines):5d} {len(angles):6d}"]
    for ids in (lines, lines | angles):
        if not lines:
            return f"{said[0]}  no lines"
        found = identify(model, of_runs(data, ids), known=known)
        true, off, states, coverage = figures(model, truth, found)
        told = " ".join(f"{state} {count}" for state, count in sorted(states.items()))
        said += [f"{true / URAD:5.1f}"] if len(said) == 1 else []
        said.append(f"{off / URAD:5.2f} {told:<22s} {coverage:5.2f}")
    return " ".join(said)


def of_runs(data: DataFolder, ids: set[str]) -> DataFolder:
    some = PlannedRuns(str(data.folder), data.data.setup.runs, data.data.readings).of(ids)
    return replace(data, data=MeasuredData(replace(data.data.setup, runs=some.runs), some.readings))


def figures(model: MachineModel, truth: Truth, found: Identified) -> tuple[float, float, Counter[str], float]:
    """RMS of the true errors and of what the estimate is off by, rad; what determines them; coverage."""
    squares, within, states = [], [], Counter[str]()
    for name in model.components:
        if not (name.is_rotation and name.is_of_linear_axis) or name.direction.line == name.axis:
            continue
        low, high = model.travel[name.axis]
        at, home = np.linspace(low, high, POINTS), np.array([min(max(0.0, low), high)])
        true = np.asarray(truth.curves[name](at)) - np.asarray(truth.curves[name](home))
        curve = found.errors.values.motion_errors[name]
        assert isinstance(curve, LegendreCurve)
        off = curve(at) - true
        rows = found.errors.covariance.rows_of(name)
        shapes, own = curve.basis(at), found.errors.covariance.matrix[rows, rows]
        variance = np.einsum("in,ij,jn->n", shapes, own, shapes)
        squares.append((np.mean(true**2), np.mean(off**2)))
        away = at != home
        within += (np.abs(off[away]) <= WITHIN * np.sqrt(variance[away])).tolist()
        states[found.errors.values.determined[name]] += 1
    true_square, off_square = np.mean(squares, axis=0)
    return float(np.sqrt(true_square)), float(np.sqrt(off_square)), states, float(np.mean(within))


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
