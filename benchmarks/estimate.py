"""How long the estimate takes and what memory it needs: python benchmarks/estimate.py

Machines of three and five axes read at random positions by lasers of three directions at four points; cost by readings
and unknowns, of the whole (noise, sizes and outliers estimated) and of one pass at a noise that is known.
`python benchmarks/estimate.py dmu60p 1000000` is one more case.
Memory is the largest size of the process less that before (each case in a process of its own).
"""

import resource
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.state import linearised, started
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import load_model

ROOT = Path(__file__).parents[1]
NOISE = 1e-3
CASES = (
    ("dmu60p", 1_000),
    ("dmu60p", 10_000),
    ("dmu60p", 100_000),
    ("headhead_mill", 10_000),
    ("headhead_mill", 100_000),
)
POINTS = ((0.0, 0.0, 0.0), (100.0, 0.0, -50.0), (0.0, 120.0, 30.0), (-80.0, 60.0, 90.0))


def observed(readings: int, axes: dict[str, tuple[float, float]]) -> Observations:
    """Random positions over the travels, 1 um of noise and nothing else."""
    source = np.random.default_rng(1)
    runs = tuple(
        Run(
            id=f"{point}-{way}",
            instrument="laser",
            target=PointOn("tool", at),
            reference=PointOn("bed"),
            frame="bed",
            home=dict.fromkeys(axes, 0.0),
            direction=direction,
        )
        for point, at in enumerate(POINTS)
        for way, direction in enumerate(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))
    )
    low, high = (np.array([travel[end] for travel in axes.values()])[:, np.newaxis] for end in (0, 1))
    positions = source.uniform(low, high, (len(axes), readings))
    return Observations(
        source="",
        runs=runs,
        run=source.integers(0, len(runs), readings),
        positions=positions,
        reading=source.normal(0.0, NOISE, readings),
    )


def case(machine: str, readings: int) -> None:
    """Estimate once, and print what it took."""
    model = load_model(ROOT / "machines" / f"{machine}.toml", None, ROOT / "generated")
    data = observed(readings, dict(model.travel))
    known = ErrorValues(machine=model.name, parameters=dict.fromkeys(model.dimensions, 10.0))
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
    sigma = found.noise.of_instrument["laser"].sigma * 1e3
    print(
        f"{machine:14s} {readings:8d} {layout.count:8d} {seconds:8.1f} {one_pass:8.2f} {memory:8.0f} {matrix:8.0f} "
        f"{sigma:8.4f}",
        flush=True,
    )


def main() -> int:
    """Every case in a process of its own."""
    if len(sys.argv) == 3:
        case(sys.argv[1], int(sys.argv[2]))
        return 0
    print("machine        readings unknowns  seconds one pass       MB (matrix) noise um")
    for machine, readings in CASES:
        subprocess.run([sys.executable, __file__, machine, str(readings)], check=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
