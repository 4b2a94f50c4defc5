"""Tiny sets of data drawn at random, through `plan` and `identify` with options drawn at random.

`python -m tests.identification.random_data 1000 0` draws so many from that seed on and prints whatever ends with a
traceback or another exit code than 0, 1 and 2.
"""

import contextlib
import io
import sys
import tempfile
import traceback
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np

from trueaxis.cli.main import main
from trueaxis.measurement.instrument_kinds import Instrument
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import ideal_bar
from trueaxis.measurement.setup import PointOn, Run, Vector
from trueaxis.model.model import MachineModel, load_model
from trueaxis.view import Carrier

ROOT = Path(__file__).parents[2]
MACHINES = ("dmu60p", "gantry_mill", "bridge_cmm")
DIRECTIONS: tuple[Vector, ...] = (
    (1.0, 0.0, 0.0),
    (0.0, 1.0, 0.0),
    (0.0, 0.0, 1.0),
    (0.6, 0.8, 0.0),
    (0.0, -0.6, 0.8),
)
PLAN_OPTIONS = (
    (),
    ("--noise-um", "0.01"),
    ("--location-errors-only",),
    ("--propose", "1"),
    ("--propose", "1", "--propose-with", "ballbar", "--datum", "best-fit"),
)
PAPER_OPTIONS = (
    (),
    ("--curves", "held-out"),
    ("--curves", "polynomial"),
    ("--squareness", "from-angles"),
    ("--noise-um", "0.3"),
    ("--noise-um", "1e-6"),
)
GLOBAL_OPTIONS = (
    (),
    ("--degree", "18"),
    ("--degree", "1"),
    ("--prior", "none"),
    ("--prior", "none", "--degree", "18"),
    ("--prior", "none", "--instruments", "ideal", "--noise-um", "0.3"),
    ("--squareness", "convention", "--prior", "none", "--noise-um", "1e-6"),
    ("--noise-um", "repeats"),
    ("--noise-um", "repeats-by-run"),
    ("--noise-um", "laser=0.3,ballbar=1,probe=2"),
    ("--noise-um", "1e4"),
    ("--instruments", "ideal"),
)


@cache
def model_of(name: str) -> MachineModel:
    return load_model(ROOT / "machines" / f"{name}.toml", None, ROOT / "generated", backend="numpy")


def data(rng: np.random.Generator, folder: Path, name: str) -> None:
    """One to four runs of one to forty readings in all; ball bars as long as their balls are apart on average."""
    model = model_of(name)
    runs = int(rng.integers(1, 5))
    setup, rows = [f'schema = 1\nmachine = "{name}"\n'], []
    for number in range(runs):
        run = _run(rng, f"r{number}", model)
        positions = _positions(rng, model, int(rng.integers(1, 40 // runs + 1)))
        reading = _reading(rng, positions.shape[1])
        if run.instrument == "ballbar":
            distance = np.linalg.norm(ideal_bar(model, run, positions), axis=0)
            run = replace(run, length=float(distance.mean()) + 1e-3)
            reading += distance - distance.mean() - 1e-3
        setup.append(_text(run))
        rows += [
            f"{run.id},{number},{','.join(repr(float(part)) for part in position)},{float(value)!r}"
            for number, (position, value) in enumerate(zip(positions.T, reading, strict=True))
        ]
    (folder / "setup.toml").write_text("".join(setup))
    (folder / "readings.csv").write_text("\n".join([f"run,seq,{','.join(model.axes)},reading", *rows]) + "\n")


def _run(rng: np.random.Generator, run_id: str, model: MachineModel) -> Run:
    kind: Instrument = ("laser", "laser", "ballbar", "probe")[rng.integers(4)]
    carriers: list[Carrier] = ["tool", "workpiece"]
    first = int(rng.integers(2))
    target, other = (PointOn(carriers[place], _point(rng)) for place in (first, 1 - first))
    reference = other if kind == "ballbar" or rng.random() < 0.4 else PointOn("bed")
    home = {axis: float(np.clip(0.0, *model.travel[axis])) for axis in model.axes}
    if rng.random() < 0.4:
        axis = model.axes[rng.integers(len(model.axes))]
        home[axis] = float(rng.uniform(*model.travel[axis]))
    direction = None if kind == "ballbar" else DIRECTIONS[rng.integers(len(DIRECTIONS))]
    return Run(
        id=run_id, instrument=kind, target=target, reference=reference, frame="bed", home=home, direction=direction
    )


def _point(rng: np.random.Generator) -> Vector:
    x, y, z = rng.choice([0.0, 10.0, -37.5, 120.0], 3).tolist()
    return (x, y, z)


def _text(run: Run) -> str:
    lines = [f'[[run]]\nid = "{run.id}"\ninstrument = "{run.instrument}"\n']
    for name, end in (("target", run.target), ("reference", run.reference)):
        at = "" if end.on == "bed" else f", point = {list(end.point)}"
        lines.append(f'{name} = {{ on = "{end.on}"{at} }}\n')
    lines.append(f"home = {{ {', '.join(f'{axis} = {at!r}' for axis, at in run.home.items())} }}\n")
    lines.append(f"length = {run.length!r}\n" if run.direction is None else f"direction = {list(run.direction)}\n")
    return "".join(lines)


def _positions(rng: np.random.Generator, model: MachineModel, count: int) -> FloatArray:
    """(n_axes, count): a line, the same position again and again, anything, or a few positions repeated."""
    low, high = np.array([model.travel[axis] for axis in model.axes]).T
    way = rng.integers(4)
    at = low + rng.random((count, low.size)) * (high - low)
    if way == 0:
        start = np.clip(np.zeros(low.size), low, high)
        moving = rng.random(low.size) < 0.4
        at = np.where(moving, start + np.linspace(0.0, 1.0, count)[:, np.newaxis] * (high - start), start)
    elif way == 1:
        at = np.repeat(at[:1], count, axis=0)
    elif way == 2:
        at = at[rng.integers(0, min(3, count), count)]
    return np.ascontiguousarray(at.T)


def _reading(rng: np.random.Generator, count: int) -> FloatArray:
    size = float(rng.choice([0.0, 1e-3, 1e-9]))
    return rng.normal(0.0, size, count) if rng.random() < 0.7 else np.full(count, size)


def ended(seed: int, folder: Path) -> tuple[list[str], int | str, str]:
    """The command, its exit code or traceback, and what it said of errors."""
    rng = np.random.default_rng(seed)
    name = str(rng.choice(MACHINES))
    data(rng, folder, name)
    words = [str(ROOT / "machines" / f"{name}.toml"), "--data", str(folder), "--kernels", str(ROOT / "generated")]
    which = rng.integers(4)
    if which == 0:
        words = ["plan", *words, *PLAN_OPTIONS[rng.integers(len(PLAN_OPTIONS))]]
    else:
        more = PAPER_OPTIONS if which == 1 else GLOBAL_OPTIONS
        method = "paper" if which == 1 else "global"
        words = ["identify", *words, "--out", str(folder / "e.json"), "--method", method]
        words += more[rng.integers(len(more))]
    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(said), np.errstate(all="ignore"):
            return words, main(words), said.getvalue()
    except BaseException:  # whatever it is, it is the finding
        return words, traceback.format_exc(), said.getvalue()


if __name__ == "__main__":
    total, first = int(sys.argv[1]), int(sys.argv[2])
    codes: dict[str, int] = {}
    for number in range(first, first + total):
        with tempfile.TemporaryDirectory() as place:
            command, code, errors = ended(number, Path(place))
        key = f"{command[0]} {code if isinstance(code, int) else 'traceback'}"
        codes[key] = codes.get(key, 0) + 1
        if code not in (0, 1, 2):
            print(number, command, code, errors, flush=True)
        if number % 50 == 49:
            print(number, codes, flush=True)
    print(codes)
