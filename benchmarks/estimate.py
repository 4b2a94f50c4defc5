"""How long the estimate takes and what memory it needs: python benchmarks/estimate.py

Machines of three and five axes, whose errors are drawn, read by lasers of three directions at four points: along each
axis in turn while the others stand still (`lines`), or at random positions, where no reading is like another
(`random`, the most that so many readings can cost). Cost by readings and unknowns, of the whole (noise, sizes and
outliers estimated) and of one pass at a noise that is known.
`python benchmarks/estimate.py dmu60p 1000000 random` is one more case.
Memory is the largest size of the process less that before (each case in a process of its own).
"""

import resource
import subprocess
import sys
import time
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.residuals import residuals_of
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.state import linearised, started
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, load_model

ROOT = Path(__file__).parents[1]
NOISE = 1e-3
CASES = tuple(
    (machine, readings, plan)
    for plan in ("lines", "random")
    for machine, readings in (
        ("dmu60p", 1_000),
        ("dmu60p", 10_000),
        ("dmu60p", 100_000),
        ("headhead_mill", 10_000),
        ("headhead_mill", 100_000),
    )
)
POINTS = ((0.0, 0.0, 0.0), (100.0, 0.0, -50.0), (0.0, 120.0, 30.0), (-80.0, 60.0, 90.0))


def observed(readings: int, axes: Mapping[str, tuple[float, float]], plan: str) -> Observations:
    """Positions over the travels, read as zero."""
    source = np.random.default_rng(1)
    moving = list(axes) if plan == "lines" else [""]
    runs = tuple(
        Run(
            id=f"{point}-{way}-{axis}",
            instrument="laser",
            target=PointOn("tool", at),
            reference=PointOn("bed"),
            frame="bed",
            home=dict.fromkeys(axes, 0.0),
            direction=direction,
        )
        for point, at in enumerate(POINTS)
        for way, direction in enumerate(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))
        for axis in moving
    )
    low, high = (np.array([travel[end] for travel in axes.values()])[:, np.newaxis] for end in (0, 1))
    run = np.sort(source.integers(0, len(runs), readings))
    positions = source.uniform(low, high, (len(axes), readings))
    if plan == "lines":
        still = source.uniform(low, high, (len(axes), len(runs)))
        for row, axis in enumerate(axes):
            there = np.array([moving[one % len(moving)] != axis for one in run])
            positions[row, there] = still[row, run[there]]
    return Observations(source="", runs=runs, run=run, positions=positions, reading=np.zeros(readings))


def measured(data: Observations, model: MachineModel, known: ErrorValues) -> Observations:
    """What a machine whose errors are drawn makes of it, with 1 um of noise."""
    source = np.random.default_rng(2)
    layout = layout_of(model, data, known)
    drawn = source.standard_normal(layout.count)
    drawn[layout.of_machine :] = 0.0
    runs = tuple(measured_runs(data))
    errors = residuals_of(layout, runs, drawn * layout.sizes, [np.zeros(2)] * len(runs), known)
    reading = source.normal(0.0, NOISE, data.reading.size)
    for one, error in zip(runs, errors, strict=True):
        reading[one.rows.at] -= error
    return replace(data, reading=reading)


def case(machine: str, readings: int, plan: str) -> None:
    """Estimate once, and print what it took."""
    model = load_model(ROOT / "machines" / f"{machine}.toml", None, ROOT / "generated")
    known = ErrorValues(machine=model.name, parameters=dict.fromkeys(model.dimensions, 10.0))
    data = measured(observed(readings, model.travel, plan), model.with_values(known), known)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    start = time.process_time()
    found = estimate(model, data, known)
    seconds = time.process_time() - start
    memory = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
    layout = layout_of(model.with_values(known), data, known)
    state = started(layout, tuple(measured_runs(data)), known, dict.fromkeys(range(len(data.runs)), NOISE))
    start = time.process_time()
    linearised(state)
    one_pass = time.process_time() - start
    matrix = readings * layout.count * 8 / 2**20
    sigma = found.noise.of_group["laser"].sigma * 1e3
    print(
        f"{machine:14s} {readings:8d} {plan:7s} {layout.count:8d} {seconds:8.1f} {one_pass:8.2f} {memory:8.0f} "
        f"{matrix:8.0f} {sigma:8.4f}",
        flush=True,
    )


def main() -> int:
    """Every case in a process of its own."""
    if len(sys.argv) == 4:
        case(sys.argv[1], int(sys.argv[2]), sys.argv[3])
        return 0
    print("machine        readings plan    unknowns  seconds one pass       MB (matrix) noise um")
    for machine, readings, plan in CASES:
        subprocess.run([sys.executable, __file__, machine, str(readings), plan], check=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
