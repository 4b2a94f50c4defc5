"""Identify the location errors of the real head-head mill; how well they fit: python -m tests.real_data.headhead"""

import contextlib
import io
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from tests.real_data.headhead_data import DIMENSIONS, FILE, probe_data, write
from tests.real_data.headhead_least_squares import BIG, FORMS, SMALL, Form, fitted, left_out, rms_3d
from trueaxis.cli.main import main as trueaxis
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.instruments import own_kinds
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.residuals import residual_of
from trueaxis.estimation.runs import measured_runs
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, load_model

ROOT = Path(__file__).parents[2]
SPEC = ROOT / "machines" / "headhead_mill.toml"


def model(sense_of_b: int = 1) -> MachineModel:
    """The checked-in machine, or one derived with B turning the other way."""
    if sense_of_b == 1:
        return load_model(SPEC, None, ROOT / "generated", backend="numpy")
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
        spec = Path(folder) / SPEC.name
        spec.write_text(SPEC.read_text().replace("[axis.B]\n", f"[axis.B]\nsense = {sense_of_b}\n"))
        trueaxis(["derive", str(spec), "--out", folder])
        return load_model(spec, None, Path(folder), backend="numpy")


def left_out_of_estimate(machine: MachineModel, observed: Observations, poses: Sequence[int]) -> float:
    """3-D rms of some poses predicted by the estimate from the 31 others, all errors free, mm."""
    found = np.zeros((len(poses), 3))
    for place, pose in enumerate(poses):
        mine = np.arange(3 * pose, 3 * pose + 3)
        rest = observed.of(np.setdiff1d(np.arange(observed.reading.size), mine))
        estimated = estimate(machine, rest, ErrorValues(machine=machine.name, parameters=DIMENSIONS))
        here = machine.with_values(estimated.values)
        for run in measured_runs(observed):
            own = np.zeros(len(own_kinds(run.rows.run, straightness=False)))
            left = residual_of(estimated.layout, here, run, estimated.unknowns, own)
            found[place, run.rows.index] = left[np.isin(run.rows.at, mine)][0]
    return rms_3d(found.ravel())


def repeats(observed: Observations) -> float:
    """3-D standard deviation of the poses at B0 C0, mm: what no model of the geometry can go below."""
    at_home = np.flatnonzero((observed.positions[3:] == 0.0).all(axis=0))
    vectors = observed.reading[at_home].reshape(-1, 3)
    return float(np.sqrt(((vectors - vectors.mean(axis=0)) ** 2).sum() / (len(vectors) - 1)))


def table(machine: MachineModel, sense_of_b: int, forms: Sequence[Form]) -> list[str]:
    """A line for each form: rank, 3-D rms in mm, in brackets that of left-out poses."""
    observed = probe_data(sense_of_b)
    lines = []
    for form in forms:
        fit = fitted(machine, observed, form)
        inside, outside = rms_3d(fit.residual), left_out(machine, observed, form)
        lines.append(f"  {form.title:<45} rank {fit.rank:2d}   {inside:.3f} ({outside:.3f})")
    return lines


def main() -> int:
    """Print the comparison and the location errors of the small model; 1 where there are no data."""
    if not FILE.exists():
        print(f"there are no data: {FILE} is missing", file=sys.stderr)
        return 1
    for sense, title in ((1, "B as the right hand turns"), (-1, "B the other way (sense = -1)")):
        print(f"{title}: 3-D rms, mm (of left-out poses)")
        print("\n".join(table(model(sense), sense, FORMS)))
    observed = probe_data()
    inside = rms_3d(
        estimate(model(), observed, ErrorValues(machine="headhead_mill", parameters=DIMENSIONS)).readings.residual
    )
    outside = left_out_of_estimate(model(), observed, range(observed.reading.size // 3))
    print(f"  {'all errors with their prior, the estimate':<45}           {inside:.3f} ({outside:.3f})")
    print(f"repeats of B0 C0: 3-D standard deviation {repeats(observed):.3f} mm\n")
    for form in (SMALL, BIG):
        fit = fitted(model(), observed, form)
        print(f"{form.title}: {fit.unknowns.size} unknowns, {fit.rank} told; +- one standard uncertainty")
        for name, value, u in zip(form.locations, fit.unknowns[3:], fit.u[3:], strict=False):
            print(f"  {name} {1e3 * value:9.3f} +- {1e3 * u:.3f} {'um' if name[1] in 'XYZ' else 'mrad'}")
    print("\nidentify on the same poses as files:")
    return command()


def command() -> int:
    """`trueaxis identify` on the readings as a user's folder, the nominal dimensions known; its exit code."""
    with tempfile.TemporaryDirectory() as name:
        data, known = write(Path(name))
        options = ["--data", str(data), "--known", str(known), "--kernels", str(ROOT / "generated")]
        return trueaxis(["identify", str(SPEC), *options, "--out", str(Path(name) / "errors.json")])


if __name__ == "__main__":
    sys.exit(main())
