"""What the diagnosis says of the poses of the real head-head mill: python -m tests.real_data.headhead_diagnosis"""

import sys
import tempfile
from functools import cache
from itertools import product
from pathlib import Path

import numpy as np

from tests.kernels import kernels_of
from tests.real_data.headhead import SPEC
from tests.real_data.headhead_data import DIMENSIONS, FILE, probe_data, write
from tests.real_data.headhead_least_squares import rms_3d
from trueaxis.cli.main import main as trueaxis
from trueaxis.diagnosis.causes.signature import readings_of
from trueaxis.diagnosis.causes.signatures import parameter_signature
from trueaxis.diagnosis.null_model.base import base_of
from trueaxis.diagnosis.null_model.rows import Rows, rows_of
from trueaxis.diagnosis.procedure import diagnose
from trueaxis.diagnosis.result import Diagnosis, FloatArray
from trueaxis.effects.kind import Effect
from trueaxis.io.faults import Faults
from trueaxis.machine.read import parse_machine
from trueaxis.measurement.data import MeasuredData, read_data
from trueaxis.model.errors import ErrorValues
from trueaxis.model.kernels import Kernels
from trueaxis.model.model import MachineModel

LOBES = """
[[effect_kind]]
name = "lobes"
expression = "a*cos(k*q*pi/180) + b*sin(k*q*pi/180)"
components = ["EXB", "EYB", "EZB", "EAB", "EBB", "ECB", "EXC", "EYC", "EZC", "EAC", "EBC", "ECC"]
parameters.a = { unit = "u", meaning = "cosine" }
parameters.b = { unit = "u", meaning = "sine" }
parameters.k = { unit = "1", meaning = "lobes in a turn", grid = [1.0, 2.0] }
sentence = "an eccentric bearing, encoder or gear of the rotary axis"
"""
LOBES_TRIED = ((1,), (2,), (1, 2))


@cache
def given(kinds: str = "") -> tuple[MachineModel, MeasuredData]:
    """The nominal machine and the readings, through the files that a user would have. kinds: TOML of kinds."""
    model = _model(SPEC.read_text() + kinds)
    with tempfile.TemporaryDirectory() as name:
        data, _ = write(Path(name))
        return model, read_data(data, model.machine)


@cache
def _model(spec: str) -> MachineModel:
    module = kernels_of(spec)
    kernels = Kernels(
        meta=module.META,
        module=module,
        routines={name: getattr(module, name) for name in module.META["routines"]},
        backend="numpy",
        note="",
    )
    return MachineModel(
        parse_machine(spec, Faults(SPEC.name)), kernels, ErrorValues(machine="headhead_mill", parameters=DIMENSIONS)
    )


@cache
def diagnosis(kinds: str = "") -> Diagnosis:
    """Diagnosed in process."""
    return diagnose(*given(kinds))


@cache
def base_left_out(degree: int, turns: bool = False) -> tuple[int, float]:
    """Rank of the base of a degree, and 3-D rms (mm) of poses that it predicts from the others.

    The poses at B0 C0 go together: each of them alone is told by the others. turns: with the harmonics of C, which
    turns round.
    """
    model, data = given()
    rows = rows_of(data)
    return _left_out(rows, _columns(model, rows, degree, turns))


@cache
def lobes_left_out(axis: str, lobes: tuple[int, ...]) -> tuple[int, float]:
    """The same for the base of degree 1 and cosines and sines of all six motion errors of a rotary axis."""
    model, data = given(LOBES)
    rows = rows_of(data)
    readings = readings_of(model, rows)
    found = [_columns(model, rows, 1)]
    for direction, count, (a, b) in product("XYZABC", lobes, ((1.0, 0.0), (0.0, 1.0))):
        effect = Effect(kind="lobes", component=f"E{direction}{axis}")
        found.append(parameter_signature(readings, effect, np.array([a, b, count]))[0][:, np.newaxis])
    return _left_out(rows, np.hstack(found))


def _columns(model: MachineModel, rows: Rows, degree: int, turns: bool = False) -> FloatArray:
    """(n, k): errors of the machine and the zeros of the probe runs: where the one sphere is. It has no alignment."""
    base = base_of(model, rows, degree=degree)
    order = [count for basis in base.bases.values() for count in range(basis.count)]
    order += [0] * (base.of_machine - len(order))
    machine = base.machine.dense()
    machine = machine if turns else machine[:, np.array(order) < degree]
    zeros = [np.isin(np.arange(rows.size), run.rows.at).astype(np.float64) for run in base.runs]
    return np.column_stack([machine, *zeros])


def _left_out(rows: Rows, columns: FloatArray) -> tuple[int, float]:
    columns = columns / np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
    left = np.zeros(rows.size)
    for out in _poses(rows):
        kept = np.setdiff1d(np.arange(rows.size), out)
        # an error-free machine reads 0
        found = np.linalg.lstsq(columns[kept], rows.reading[kept], rcond=1e-8)[0]
        left[out] = rows.reading[out] - columns[out] @ found
    return int(np.linalg.matrix_rank(columns, tol=1e-9)), rms_3d(left)


def _poses(rows: Rows) -> list[np.ndarray[tuple[int], np.dtype[np.int64]]]:
    _, group = np.unique(rows.positions[3:], axis=1, return_inverse=True)
    return [np.flatnonzero(group.reshape(-1) == one) for one in range(group.max() + 1)]


def command() -> int:
    """`trueaxis diagnose` on the machine as it is checked in."""
    with tempfile.TemporaryDirectory() as name:
        data, errors = write(Path(name))
        out, kernels = Path(name) / "out", SPEC.parents[1] / "generated"
        options = ["--errors", str(errors), "--data", str(data), "--kernels", str(kernels), "--out", str(out)]
        return trueaxis(["diagnose", str(SPEC), *options])


def main() -> int:
    """Print what the command says, and what the base is worth; 1 where there are no data."""
    if not FILE.exists():
        print(f"there are no data: {FILE} is missing", file=sys.stderr)
        return 1
    command()
    found = diagnosis()
    best = max(found.scan, key=lambda one: one.evidence)
    drifts = [one.state for one in found.limits if one.effect.kind == "drift"]
    print(f"values given are right: p {found.recalibration_p:.0e}")
    print(f"best evidence: {best.evidence:.1f} ({best.effect.kind}), {found.threshold:.1f} is asked")
    print(f"drifts: {drifts.count('confounded')} of {len(drifts)} confounded")
    kept = rows_of(given()[1]).size
    print(f"readings: {probe_data().reading.size}, of which {kept} are used; base by degree: rank, poses left out")
    for degree in (12, 3, 2, 1):
        rank, left = base_left_out(degree)
        print(f"  {degree:2d}   {rank:2d}   {left:.3f} mm")
    print("lobes of the motion errors of one axis beside degree 1: rank, poses left out")
    for axis, lobes in product("BC", LOBES_TRIED):
        rank, left = lobes_left_out(axis, lobes)
        print(f"  {axis}, {' and '.join(map(str, lobes)):<8} {rank:2d}   {left:.3f} mm")
    for kind in ("cyclic", "lobes"):
        limits = [limit for limit in diagnosis(LOBES).limits if limit.effect.kind == kind]
        print(f"{kind}: {len(limits)} places, {', '.join(sorted({f'{one.state}: {one.reason}' for one in limits}))}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
