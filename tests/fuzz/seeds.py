"""Valid files of every kind for a machine: what the campaign changes."""

import io
import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from random import Random

import numpy as np
import polars as pl

from tests.fuzz import nc_seeds
from tests.fuzz.expressions import expression
from tests.instrument_files.writers import rtl
from tests.machines import ROOT, machine_of
from trueaxis.machine import Machine
from trueaxis.model.bases import travel_basis
from trueaxis.model.covariance import Covariance
from trueaxis.model.covariance_file import dump_covariance

MACHINES = tuple(sorted((ROOT / "machines").glob("*.toml")))  # with kernels in generated/
TINY = """schema = 1
name = "tiny"
structure = "[w b X t]"
[axis.X]
travel = [0.0, 500.0]
[tool]
position = ["q_x", 0.0, 1.0]
[[effect]]
kind = "backlash"
component = "EXX"
[[effect_kind]]
name = "wave"
expression = "a*sin(q/p)"
components = ["along"]
parameters.a = { unit = "u" }
parameters.p = { unit = "axis", grid = [5.0, 10.0] }
"""
_VAR = "5210 0\n5211 0.5\n5220 1\n" + "".join(f"{5221 + n} {0.5 * n:.6f}\n" for n in range(9)) + "5230 0.0\n"
EFFECTS = TINY[TINY.index("[[effect]]") :]


def random_spec(draw: Random) -> str:
    """A machine that no file describes: any axes in any order, on either side."""
    axes = draw.sample("XYZABC", draw.randint(1, 6))
    bed = draw.randrange(len(axes) + 1)
    workpiece, tool = " ".join(f"{axis}'" for axis in axes[:bed]), " ".join(axes[bed:])
    lines = ["schema = 1", f'name = "random-{draw.randrange(1000)}"', f'structure = "[w {workpiece} b {tool} t]"']
    for axis in axes:
        travel = [-round(draw.uniform(0, 400), 1), round(draw.uniform(100, 1000), 1)]
        lines += [f"[axis.{axis}]", f"travel = {travel}", f"sense = {draw.choice((1, -1))}"]
    return "\n".join(
        [
            *lines,
            "[tool]",
            'position = ["q_x", -120.5, 0]',
            draw.choice(("", EFFECTS.replace("EXX", f"E{axes[0]}{axes[0]}"))),
        ]
    )


def valid_files(spec: str, draw: Random) -> dict[str, bytes]:
    """The content of every file by its name; `data/` is a folder of measured data."""
    machine = machine_of(spec)
    runs = _runs(machine, draw)
    table = _readings(machine, runs, draw)
    parquet = io.BytesIO()
    pl.read_csv(table.encode()).write_parquet(parquet)
    return {
        "machine.toml": spec.encode(),
        "tiny.toml": TINY.encode(),
        "expression.txt": expression(draw),
        "data/setup.toml": _setup(machine, runs).encode(),
        "data/readings.csv": table.encode(),
        "data/readings.parquet": parquet.getvalue(),
        "points.csv": _points(machine, draw).encode(),
        "errors.json": _errors(machine, draw).encode(),
        "errors.npz": _covariance(machine, draw),
        "program.nc": _nc(machine, draw).encode(),
        "program.apt": _apt(machine).encode(),
        "program.mpf": nc_seeds.siemens(machine, draw).encode(),
        "program.h": nc_seeds.klartext(machine, draw).encode(),
        "fanuc.nc": nc_seeds.fanuc(machine, draw).encode(),
        "tcp.nc": nc_seeds.point_control(machine, draw).encode(),
        "linuxcnc.var": _VAR.encode(),
        "offsets.toml": b'[offset.G54]\nX = 1.5\nY = [0.0, 2.0]\nZ = -3\n[offset."G54.1 P3"]\nX = 0.5\n',
        "tool.tbl": b"T1 P1 D6.0 Z+5.0 ;end mill\nT2 P2 X0.0 Z7.25\n",
        "tools.toml": b"[tool.1]\nlength = 5.0\n[tool.2]\nlength = 7.25\npoint = [0.0, 0.0, -7.25]\n",
        "fleet.toml": b'[[machine]]\nid = "M1"\nspec = "machine.toml"\nerrors = "errors.json"\ndata = "da*"\n'
        b'[[machine]]\nid = "M2"\nspec = "s/m.toml"\ndata = ["d/2026-*", "data"]\ntasks = ["report", "identify"]\n',
        "test.csv": _positioning(draw).encode(),
        "diagonals.csv": _diagonals(draw).encode(),
        "test.dat": _dat(draw).encode(),
        "laser.rtl": _rtl(machine, draw),
        "laser.rta": _rtl(machine, Random(1)),
        "laser.csv": _laser(machine, draw).encode(),
        "bar.csv": _bar(draw).encode(),
    }


@dataclass(frozen=True)
class Run:
    """A run of a laser along an axis, or of a ball bar."""

    name: str
    axis: str
    point: tuple[float, float, float]


def _runs(machine: Machine, draw: Random) -> list[Run]:
    """Three laser runs along one axis, one along the others; a ball bar in one of three sets."""
    first = draw.choice(machine.axes)
    points = [(0.0, 0.0, 0.0), (0.0, 100.0, -20.5), (100.0, 0.0, 50.0)]
    runs = [Run(f"{first}{number}", first, point) for number, point in enumerate(points)]
    runs += [Run(f"{axis}0", axis, points[0]) for axis in machine.axes if axis != first]
    return runs + [Run("bar", first, points[0])] * (draw.random() < 1 / 3)


def _setup(machine: Machine, runs: Sequence[Run]) -> str:
    parts = [f'schema = 1\nmachine = "{machine.name}"\n']
    for run in runs:
        if run.name == "bar":
            parts.append('[[run]]\nid = "bar"\ninstrument = "ballbar"\nlength = 150.0\n')
            parts.append('reference = { on = "workpiece", point = [\n  10.0,\n  20.0, 5.5] }\n')
        else:
            direction = [1.0 if run.axis in pair else 0.0 for pair in ("XA", "YB", "ZC")]
            parts.append(f'[[run]]\nid = "{run.name}"\ninstrument = "laser"\ndirection = {direction}\n')
            parts.append('reference = { on = "bed" }\nhome = { }\n')
        parts.append(f'target = {{ on = "tool", point = {list(run.point)} }}\n')
    return "".join(parts)


def _readings(machine: Machine, runs: Sequence[Run], draw: Random) -> str:
    lines = [f"run,seq,time_s,feed,temperature_c,{','.join(machine.axes)},reading"]
    for number, run in enumerate(runs):
        low, high = machine.travel[run.axis]
        there = [round(low + share * (high - low), 3) for share in (0.1, 0.35, 0.6, 0.9)]
        for seq, at in enumerate((*there, *reversed(there))):
            cells = [repr(at) if axis == run.axis else "0" for axis in machine.axes]
            cells = [run.name, str(seq), f"{number * 100 + seq}", "1000", "20.5", *cells, f"{draw.gauss(0, 1e-3):.6f}"]
            lines.append(",".join(cells))
    return "\n".join(lines) + "\n"


def _points(machine: Machine, draw: Random) -> str:
    rows = [
        [*(f"{draw.uniform(*machine.travel[axis]):.3f}" for axis in machine.axes), "1.5", "0", "-20"] for _ in range(4)
    ]
    return "\n".join([",".join([*machine.axes, "tool_x", "tool_y", "tool_z"]), *map(",".join, rows)]) + "\n"


def _errors(machine: Machine, draw: Random) -> str:
    curves: dict[str, dict[str, object]] = {}
    for name in machine.components:
        low, high = machine.travel[name[2]]
        if draw.random() < 0.5:
            coefficients = [1e-7, draw.gauss(0, 1e-10), 1e-13]
            curves[name] = {"basis": "polynomial", "powers": [1, 2, 3], "coefficients": coefficients}
        else:
            count = draw.choice((3, 12))  # as many as `fit` needs
            positions = [round(low + (high - low) * index / (count - 1), 3) for index in range(count)]
            values = [draw.gauss(0, 1e-7) + 1e-8 * position for position in positions]
            curves[name] = {
                "basis": "table",
                "positions": positions,
                "values": values,
                "u": [None] + [1e-7] * (count - 1),
            }
    tree = {
        "schema": 1,
        "machine": machine.name,
        "parameters": {name: draw.gauss(0, 1e-5) for name in machine.parameters},
        "motion_errors": curves,
        "effects": [],
        "undetermined": [{"combination": "a + b", "parameters": ["a"]}],
    }
    return json.dumps(tree, indent=draw.choice((None, 1)))


def _covariance(machine: Machine, draw: Random) -> bytes:
    bases = tuple(travel_basis(machine.travel[name[2]], 2) for name in machine.components)
    n = 2 * len(bases) + len(machine.location_errors)
    root = np.random.default_rng(draw.randrange(2**32)).normal(0, 1e-6, (n, n))
    opened = np.zeros((n, 1))
    return dump_covariance(
        Covariance(
            machine=machine.name,
            components=machine.components,
            bases=bases,
            locations=machine.location_errors,
            root=root,
            open=opened,
        )
    )


def _nc(machine: Machine, draw: Random) -> str:
    def at() -> str:
        return " ".join(f"{axis}{draw.uniform(*machine.travel[axis]):.3f}" for axis in machine.axes)

    lines = [
        "%",
        "O100 (part)",
        "G21 G90 G17 G94",
        f"G0 {at()}",
        f"G1 {at()} F200",
        f"N30 G1 {at()}",
        "M5",
        "/N5 M9",
        "; end",
    ]
    if {"X", "Y"} <= set(machine.axes):
        lines[6:6] = [
            "G1 X100. Y100.",
            "G2 X120. Y100. I10. J0. F90 M8",
            "G3 X100. R10.",
            "G91 X1.5 G1",
            "X-.5Y2.(note)",
            "G90",
        ]
    return "\n".join([*lines, "M30", "%"]) + "\n"


def _apt(machine: Machine) -> str:
    x, y, z = (round(sum(machine.travel.get(axis, (0.0, 20.0))) / 2, 3) for axis in "XYZ")
    return (
        f"UNITS/MM\nFROM/{x},{y},{z}\nRAPID\nGOTO/{x + 10},{y},{z}\nFEDRAT/100,MMPM\nGOTO/{x + 10},{y},{z + 1} $$ up\n"
        f"CIRCLE/{x},{y},{z + 1},0,0,1,10\nGOTO/{x},{y + 10},{z + 1}\nGODLTA/1,2,3\nGOTO/{x}, $\n{y},{z}\nEND\nFINI\n"
    )


def _positioning(draw: Random) -> str:
    rows = [f"{target},{cycle},{direction},{target + draw.gauss(0, 1e-3):.5f}"
            for target in (0.0, 25.5, 51.25, 99.0) for cycle in (1, 2, 3) for direction in ("+1", "-1")]  # fmt: skip
    return "\n".join(["target,cycle,direction,measured", *rows]) + "\n"


def _diagonals(draw: Random) -> str:
    """Both of a face of 60 by 80 mm."""
    rows = [
        f"{target},{cycle},{direction},{target + draw.gauss(0, 1e-3):.5f},{run}"
        for run in ("pp", "np")
        for target in (0.0, 51.25, 100.0)
        for cycle in (1, 2)
        for direction in ("+1", "-1")
    ]
    return "\n".join(["target,cycle,direction,measured,run", *rows]) + "\n"


def _dat(draw: Random) -> str:
    lines = ["TEST_DATA=x", "# comment", "UNIT=mm", "CYCLES=2", "POSITIONS=3", "DEC=5"]
    lines += [f"TGT_DATA[{i}]={10.0 * i}" for i in (1, 2, 3)]
    lines += [
        f"REF_DATA_{name}[{i},{j}]={10 * i + draw.gauss(0, 1e-3):.5f}"
        for name in ("FWD", "BWD")
        for i in (1, 2, 3)
        for j in (1, 2)
    ]
    return "\n".join(lines) + "\n"


def _rtl(machine: Machine, draw: Random) -> bytes:
    targets = [round(low + share * (high - low), 3) for low, high in [machine.travel[machine.axes[0]]]
               for share in (0.1, 0.3, 0.5, 0.6, 0.8, 0.9)]  # fmt: skip
    deviations = np.array([[draw.gauss(0, 1) for _ in targets] for _ in range(4)])
    return rtl(targets, deviations, axis=draw.choice(("", machine.axes[0]))).encode(draw.choice(("utf-8", "gbk")))


def _laser(machine: Machine, draw: Random) -> str:
    first = machine.axes[0]
    low, high = machine.travel[first]
    mark, point = draw.choice(((";", ","), ("\t", "."), (",", ".")))
    head = [f"{axis} [{'mm' if axis in 'XYZ' else 'deg'}]" for axis in machine.axes]
    lines = ["run", *head, "Time [s]", "Error [um]"]
    rows = [mark.join(lines)]
    for run in ("one", "two"):
        for number in range(6):
            at = [low + number * (high - low) / 5 if axis == first else sum(machine.travel[axis]) / 2
                  for axis in machine.axes]  # fmt: skip
            cells = [*(f"{value:.3f}" for value in at), str(number), f"{draw.gauss(0, 1):.4f}"]
            rows.append(mark.join([run, *(cell.replace(".", point) for cell in cells)]))
    return "\r\n".join(rows) + "\r\n"


def _bar(draw: Random) -> str:
    rows = [f"{angle};{draw.gauss(0, 3):.2f};1000".replace(".", ",") for angle in range(0, 361, 30)]
    return "\n".join(["Ball bar, 150 mm", "Angle [deg];Deviation [um];Feed [mm/min]", *rows]) + "\n"


def write_all(folder: Path, files: dict[str, bytes]) -> None:
    """Write the files into a folder."""
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
