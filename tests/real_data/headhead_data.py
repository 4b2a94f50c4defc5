"""The 32 poses of a real head-head mill (../shared/data/headhead_5axis) as probe readings of the contract.

With tool-centre-point control the control moves X Y Z so that, for its nominal geometry, the tool centre is where the
program says. A fixed sphere was probed at each pose and its centre found at P in program coordinates, so that

    axis positions = P - R_C(C) (q_B + R_B(B) q_T)      (nominal inverse kinematics: C carries B, B the tool)

and the tool's deviation there is S - P, S being where the sphere is, which nobody knows: the reading in a direction d
is -d . (P - P_home), and the zero of the probe an unknown.

The positions handed on are those for the centre of the first pose, off by the 1 mm that P moves. With P itself in them
the readings would be part of the regressors, and axes that do not move at all (every scale error -100 %, the tool at
the sphere) a perfect fit.
"""

import json
from pathlib import Path

import numpy as np
import polars as pl
from scipy.spatial.transform import Rotation

from trueaxis.estimation.observations import Observations
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import PointOn, Run, Vector

FOLDER = Path(__file__).parents[3] / "shared" / "data" / "headhead_5axis"
FILE = FOLDER / "zero_correction.csv"
AXES = ("X", "Y", "Z", "B", "C")
C_TO_B = (0.010934, 0.0, -270.0)  # mm, nominal
B_TO_TOOL = (-0.668710, -26.721365, -308.980001)
DIMENSIONS = dict(zip(("q_Bx", "q_By", "q_Bz", "q_Tx", "q_Ty", "q_Tz"), (*C_TO_B, *B_TO_TOOL), strict=True))
DIRECTIONS: dict[str, Vector] = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


def poses() -> tuple[FloatArray, FloatArray]:
    """(2, 32): B and C, deg; (3, 32): sphere centres in program coordinates, mm; in the order of seq."""
    table = pl.read_csv(FILE).sort("seq")
    angles = table.select("B_deg", "C_deg").to_numpy().astype(np.float64).T
    return angles, table.select("X_mm", "Y_mm", "Z_mm").to_numpy().astype(np.float64).T


def axis_positions(angles: FloatArray, centres: FloatArray, sense_of_b: int = 1) -> FloatArray:
    """(5, n): where the axes were, X Y Z (mm), B C (deg)."""
    turn_b = Rotation.from_rotvec(np.outer(sense_of_b * angles[0], (0.0, 1.0, 0.0)), degrees=True)
    turn_c = Rotation.from_rotvec(np.outer(angles[1], (0.0, 0.0, 1.0)), degrees=True)
    arm = turn_c.apply(np.array(C_TO_B) + turn_b.apply(np.array(B_TO_TOOL)))
    return np.vstack([centres - arm.T, angles])


def probe_data(sense_of_b: int = 1) -> Observations:
    """Three readings (x, y, z) of each pose, pose by pose, zeroed at the first pose."""
    angles, centres = poses()
    at = axis_positions(angles, np.repeat(centres[:, :1], angles.shape[1], axis=1), sense_of_b)
    home = dict(zip(AXES, at[:, 0].tolist(), strict=True))
    runs = tuple(
        Run(
            id=f"sphere-{name}",
            instrument="probe",
            target=PointOn("tool"),
            reference=PointOn("workpiece"),
            frame="workpiece",
            home=home,
            direction=direction,
        )
        for name, direction in DIRECTIONS.items()
    )
    n = angles.shape[1]
    reading = -(centres - centres[:, :1])
    return Observations(
        source=str(FILE),
        runs=runs,
        run=np.tile(np.arange(3), n),
        positions=np.repeat(at, 3, axis=1),
        reading=np.ascontiguousarray(reading.T).ravel(),
        seq=np.repeat(np.arange(1, n + 1), 3),
    )


SETUP = """\
[[run]]
id = "{run.id}"
instrument = "probe"
direction = {direction}
frame = "workpiece"
target = {{ on = "tool", point = [0.0, 0.0, 0.0] }}
reference = {{ on = "workpiece", point = [0.0, 0.0, 0.0] }}
home = {{ {home} }}
"""


def write(folder: Path, sense_of_b: int = 1) -> tuple[Path, Path]:
    """Write the readings as a data folder, and error values of the nominal machine beside it; where both are.

    No times were recorded: time_s counts the poses, an assumption of equal time steps.
    """
    observed = probe_data(sense_of_b)
    data = folder / "readings"
    data.mkdir(parents=True)
    tables = ["schema = 1", 'machine = "headhead_mill"']
    for run in observed.runs:
        assert run.home is not None
        home = ", ".join(f"{axis} = {value!r}" for axis, value in run.home.items())
        tables.append(SETUP.format(run=run, direction=list(run.direction or ()), home=home))
    (data / "setup.toml").write_text("\n".join(tables))
    pl.DataFrame(
        {
            "run": [observed.runs[index].id for index in observed.run],
            "seq": observed.seq,
            "time_s": np.repeat(np.arange(len(observed.reading) // 3, dtype=np.float64), 3),
            **dict(zip(AXES, observed.positions, strict=True)),
            "reading": observed.reading,
        }
    ).write_csv(data / "readings.csv")
    errors = folder / "nominal.json"
    errors.write_text(json.dumps({"schema": 1, "machine": "headhead_mill", "parameters": DIMENSIONS}))
    return data, errors
