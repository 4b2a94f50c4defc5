"""Identify the location errors of the real head-head mill; how well they fit: python -m tests.real_data.headhead"""

import contextlib
import io
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tests.real_data.headhead_data import DIMENSIONS, FILE, probe_data
from trueaxis.cli import main as trueaxis
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.instruments import own_kinds
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.residuals import residual_of
from trueaxis.estimation.runs import measured_runs
from trueaxis.identify.global_fit.design import Design
from trueaxis.identify.global_fit.method import fit_global
from trueaxis.identify.global_fit.result import GlobalOptions, GlobalResult
from trueaxis.identify.global_fit.solve import residuals
from trueaxis.identify.global_fit.write_up import identification
from trueaxis.identify.report_text import report_text
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.curves import PolynomialCurve
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import MachineModel, load_model

ROOT = Path(__file__).parents[2]
SPEC = ROOT / "machines" / "headhead_mill.toml"
ZERO = PolynomialCurve((), ())

OFFSETS = ("EX0C", "EY0C", "EX0B", "EZ0B", "EX0T", "EY0T", "EZ0T")
TILTS = ("EA0C", "EB0C", "EA0B", "EC0B")
SQUARENESS = ("EC0Y", "EA0Z", "EB0Z")
SCALES = ("EXX", "EYY", "EZZ")
OF_C, OF_B = (tuple(f"E{direction}{axis}" for direction in "XYZABC") for axis in "CB")


@dataclass(frozen=True)
class Form:
    """What is unknown besides the centre of the sphere; motion errors of the given degree."""

    title: str
    locations: tuple[str, ...] = ()
    components: tuple[str, ...] = ()
    degree: int = 1


CENTRE = Form("sphere centre only")
AXES_ONLY = Form("and the rotary axes by ISO 230-7, no tool", (*OFFSETS[:4], *TILTS))
SMALL = Form("centre, offsets of rotary axes and tool", OFFSETS)
TILTED = Form("and tilts of the rotary axes", (*OFFSETS, *TILTS))
BIG = Form("and linear scale and squareness", (*OFFSETS, *TILTS, *SQUARENESS), SCALES)
CURVED_B = Form("these and motion errors of B, degree 2", BIG.locations, (*SCALES, *OF_B), 2)
CURVED_C = Form("these and motion errors of C, degree 2", BIG.locations, (*SCALES, *OF_C), 2)
FORMS = (CENTRE, AXES_ONLY, SMALL, TILTED, BIG, CURVED_B, CURVED_C)


def model(sense_of_b: int = 1) -> MachineModel:
    """The checked-in machine, or one derived with B turning the other way."""
    if sense_of_b == 1:
        return load_model(SPEC, None, ROOT / "generated", backend="numpy")
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
        spec = Path(folder) / SPEC.name
        spec.write_text(SPEC.read_text().replace("[axis.B]\n", f"[axis.B]\nsense = {sense_of_b}\n"))
        trueaxis(["derive", str(spec), "--out", folder])
        return load_model(spec, None, Path(folder), backend="numpy")


def fitted(machine: MachineModel, observed: Observations, form: Form) -> GlobalResult:
    """Least squares of all readings, every reading counting the same."""
    given = ErrorValues(
        machine.name,
        {**DIMENSIONS, **{name: 0.0 for name in machine.location_errors if name not in form.locations}},
        {name: ZERO for name in machine.components if name not in form.components},
    )
    degree = {name: 1 if name in SCALES else form.degree for name in form.components}
    return fit_global(machine, observed, GlobalOptions(known=given, degree=degree))


def rms_3d(residual: FloatArray) -> float:
    """Root mean square of the lengths of the residual vectors, mm; residual: (3 n,), pose by pose."""
    return float(np.sqrt((residual.reshape(-1, 3) ** 2).sum(axis=1).mean()))


def left_out(machine: MachineModel, observed: Observations, form: Form) -> float:
    """3-D rms of poses predicted from the 31 others, mm."""
    n = observed.reading.size // 3
    found = np.zeros((n, 3))
    for pose in range(n):
        mine = np.arange(3 * pose, 3 * pose + 3)
        fit = fitted(machine, observed.of(np.setdiff1d(np.arange(3 * n), mine)), form)
        whole = Design(fit.layout, observed)
        found[pose] = residuals(whole, fit.given, fit.unknowns / fit.layout.scale)[mine]
    return rms_3d(found.ravel())


def left_out_of_estimate(machine: MachineModel, observed: Observations, poses: Sequence[int]) -> float:
    """3-D rms of some poses predicted by the estimate from the 31 others, all errors free, mm."""
    found = np.zeros((len(poses), 3))
    for place, pose in enumerate(poses):
        mine = np.arange(3 * pose, 3 * pose + 3)
        rest = observed.of(np.setdiff1d(np.arange(observed.reading.size), mine))
        estimated = estimate(machine, rest, ErrorValues(machine.name, DIMENSIONS))
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
        lines.append(f"  {form.title:<45} rank {fit.factors.rank:2d}   {inside:.3f} ({outside:.3f})")
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
    inside = rms_3d(estimate(model(), observed, ErrorValues("headhead_mill", DIMENSIONS)).residual)
    outside = left_out_of_estimate(model(), observed, range(observed.reading.size // 3))
    print(f"  {'all errors with their prior, the estimate':<45}           {inside:.3f} ({outside:.3f})")
    print(f"repeats of B0 C0: 3-D standard deviation {repeats(observed):.3f} mm\n")
    for form in (SMALL, BIG):
        print(report_text(identification(fitted(model(), observed, form)).report))
    return 0


if __name__ == "__main__":
    sys.exit(main())
