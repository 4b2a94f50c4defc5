"""The files of docs/tutorials/laser_to_control.md: `python -m tests.laser_to_control.inputs`.

A mill that is known is measured by `trueaxis simulate`, and the readings are written as the instruments' own programs
write them. What they write lies in examples/shop.
"""

import json
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import polars as pl

from tests.instrument_files.writers import rtl
from tests.machines import ROOT
from trueaxis.cli.main import main as trueaxis
from trueaxis.io.files import write_files

FOLDER = ROOT / "examples" / "shop"
NAME, STRUCTURE = "mill", "[w b X Y Z t]"
TRAVEL = {"X": (0.0, 600.0), "Y": (0.0, 400.0), "Z": (-300.0, 0.0)}
MIDDLE = {"X": 300.0, "Y": 200.0, "Z": -150.0}
OPTIC = (0.0, 0.0, -120.0)  # in the tool frame, mm
TARGETS, PASSES = 13, 4
RADIUS, ARM, CIRCLE_POINTS = 150.0, 150.0, 72
NOISE_UM, SEED = 0.3, 7


def true_errors() -> dict[str, object]:
    """A scale that is 40 to 70 um/m long, straightness of 3 um, rotations of 15 urad, squareness of 30 to 60 urad."""
    draw = np.random.default_rng(12)
    curves = {}
    for axis, ends in TRAVEL.items():
        longest = max(map(abs, ends))
        for letter in "XYZABC":
            size = 15e-6 if letter in "ABC" else 3e-3
            coefficients = [float(f"{size * draw.normal() / longest**power:.3e}") for power in (1, 2, 3)]
            if letter == axis:
                coefficients[0] += {"X": 4e-5, "Y": -5e-5, "Z": 7e-5}[axis]
            curves[f"E{letter}{axis}"] = {"basis": "polynomial", "powers": [1, 2, 3], "coefficients": coefficients}
    parameters = {"EC0Y": 4.5e-5, "EA0Z": -3e-5, "EB0Z": 6e-5}
    return {"schema": 1, "machine": NAME, "parameters": parameters, "motion_errors": curves}


def lines() -> dict[str, list[dict[str, float]]]:
    """Axis -> commanded positions of a laser line, there and back PASSES times, the other axes in the middle."""
    return {
        axis: [
            MIDDLE | {axis: float(at), f"dir_{axis}": (-1.0) ** cycle}
            for cycle in range(PASSES)
            for at in np.linspace(*TRAVEL[axis], TARGETS)[:: 1 - 2 * (cycle % 2)]
        ]
        for axis in TRAVEL
    }


def circles() -> list[dict[str, float]]:
    """A circle in XY about the middle, counter-clockwise, then clockwise."""
    angles = np.linspace(0.0, 2.0 * np.pi, CIRCLE_POINTS, endpoint=False)
    return [
        MIDDLE | {"X": 300.0 + RADIUS * np.cos(angle), "Y": 200.0 + RADIUS * np.sin(angle)}
        for angle in (*angles, *angles[::-1])
    ]


def plan_text() -> str:
    point = json.dumps(list(OPTIC))
    text = f'schema = 1\nmachine = "{NAME}"\n'
    for row, axis in enumerate(TRAVEL):
        home = ", ".join(f"{name} = {value}" for name, value in (MIDDLE | {axis: TRAVEL[axis][0]}).items())
        direction = [float(row == k) for k in range(3)]
        text += f'[[run]]\nid = "{axis}"\ninstrument = "laser"\ndirection = {direction}\n'
        text += f'target = {{ on = "tool", point = {point} }}\nhome = {{ {home} }}\n'
    centre = [300.0, 200.0, MIDDLE["Z"] + OPTIC[2]]
    text += f'[[run]]\nid = "circle"\ninstrument = "ballbar"\nlength = {ARM}\n'
    return text + (
        f'target = {{ on = "tool", point = {point} }}\nreference = {{ on = "workpiece", point = {centre} }}\n'
    )


def measured(folder: Path) -> pl.DataFrame:
    """Readings of the true machine, by `simulate`."""
    spec, plan, errors = folder / f"{NAME}.toml", folder / "plan", folder / "true.json"
    errors.write_text(json.dumps(true_errors()))
    travel = [f"{axis}={low:g}:{high:g}" for axis, (low, high) in TRAVEL.items()]
    run("init", spec, "--structure", STRUCTURE, "--travel", *travel)
    run("derive", spec, "--out", folder / "generated")
    plan.mkdir()
    (plan / "setup.toml").write_text(plan_text())
    runs: Mapping[str, Sequence[dict[str, float]]] = lines() | {"circle": circles()}
    rows = [
        {"run": name, "seq": seq, **position}
        for name, positions in runs.items()
        for seq, position in enumerate(positions)
    ]
    table = pl.DataFrame(rows, infer_schema_length=None).with_columns(pl.lit(None, pl.Float64).alias("reading"))
    table.write_csv(plan / "readings.csv")
    noise = ["--noise-um", NOISE_UM, "--seed", SEED]
    run(
        "simulate",
        spec,
        "--errors",
        errors,
        "--data",
        plan,
        "--out",
        folder / "data",
        *noise,
        "--kernels",
        folder / "generated",
    )
    return pl.read_csv(folder / "data" / "readings.csv")


def run(*words: object) -> None:
    if trueaxis([str(word) for word in words]) != 0:
        raise RuntimeError(f"{words[0]} failed")


def instrument_files(readings: pl.DataFrame) -> dict[str, str]:
    files = {}
    for axis, ends in TRAVEL.items():
        one = readings.filter(pl.col("run") == axis)
        passes = one["reading"].to_numpy().reshape(PASSES, TARGETS) * 1e3
        passes[1::2] = passes[1::2, ::-1]
        files[f"{axis.lower()}.rtl"] = rtl(
            np.linspace(*ends, TARGETS).tolist(), passes, axis=axis, machine="Mill 4", digits=2
        )
    one = readings.filter(pl.col("run") == "circle")
    angles = np.degrees(np.arctan2(one["Y"].to_numpy() - 200.0, one["X"].to_numpy() - 300.0)) % 360.0
    names = ["ccw"] * CIRCLE_POINTS + ["cw"] * CIRCLE_POINTS
    rows = [
        f"{name};{angle:.3f};{reading * 1e3:.2f}"
        for name, angle, reading in zip(names, angles, one["reading"].to_numpy(), strict=True)
    ]
    files["circle_xy.csv"] = "\n".join(["run;angle [deg];deviation [um]", *rows, ""])
    return files


PROGRAM = """%
O0042 (PLATE, FOUR HOLES AND A SLOT)
G21 G17 G40 G49 G80 G90 G94
G54
T1 M6
G0 X20. Y20.
G43 H1 Z50.
S3000 M3
G99 G81 X20. Y20. Z-12. R2. F200.
X220.
Y170.
X20.
G80
G0 Z50.
G0 X60. Y95.
Z2.
G1 Z-3. F150.
G1 X160. F600.
G3 X160. Y115. J10.
G1 X60.
G3 X60. Y95. J-10.
G0 Z50.
G49
M30
%
"""
OFFSETS = "[offset.G54]\nX = 180.0\nY = 110.0\nZ = -260.0\n"
TOOLS = "[tool.1]\nlength = 95.0\n"


def all_files() -> dict[str, str]:
    with tempfile.TemporaryDirectory() as folder:
        readings = measured(Path(folder))
    files = instrument_files(readings) | {"plate.nc": PROGRAM, "offsets.toml": OFFSETS, "tools.toml": TOOLS}
    return files | {"true_errors.json": json.dumps(true_errors(), indent=1) + "\n"}


if __name__ == "__main__":
    write_files({FOLDER / name: text for name, text in all_files().items()})
