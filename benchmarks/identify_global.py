"""How long `identify --method global` takes and what memory it needs: python benchmarks/identify_global.py

A five-axis machine read at random positions by lasers of three directions at four points; cost by
readings and unknowns.
Memory is the largest size of the process less that before (each case in a process of its own).
"""

import resource
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

from trueaxis.estimation.observations import Observations
from trueaxis.identify.estimated import EstimateOptions, identify_estimated
from trueaxis.identify.weighting import NoiseModel
from trueaxis.measure.setup import PointOn, Run
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import load_model

ROOT = Path(__file__).parents[1]
CASES = ((12_500, 9), (25_000, 9), (50_000, 9), (100_000, 9), (100_000, 4), (100_000, 19))
POINTS = ((0.0, 0.0, 0.0), (100.0, 0.0, -50.0), (0.0, 120.0, 30.0), (-80.0, 60.0, 90.0))


def observed(readings: int, axes: dict[str, tuple[float, float]]) -> Observations:
    """Random positions over the travels, 1 um of noise and nothing else."""
    source = np.random.default_rng(1)
    runs = tuple(
        Run(f"{point}-{way}", "laser", PointOn("tool", at), PointOn("bed"), "bed", dict.fromkeys(axes, 0.0), direction)
        for point, at in enumerate(POINTS)
        for way, direction in enumerate(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))
    )
    low, high = (np.array([travel[end] for travel in axes.values()])[:, np.newaxis] for end in (0, 1))
    positions = source.uniform(low, high, (len(axes), readings))
    return Observations(
        "", runs, source.integers(0, len(runs), readings), positions, source.normal(0.0, 1e-3, readings)
    )


def case(readings: int, degree: int) -> None:
    """Identify once, and print what it took."""
    model = load_model(ROOT / "machines" / "headhead_mill.toml", None, ROOT / "generated")
    data = observed(readings, dict(model.travel))
    known = ErrorValues(model.name, dict.fromkeys(model.dimensions, 10.0))
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    start = time.perf_counter()
    options = EstimateOptions(known=known, noise=NoiseModel(um=1.0), prior=False, degree=degree)
    found = identify_estimated(model, data, options)
    seconds = time.perf_counter() - start
    memory = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
    unknowns = found.covariance.count
    matrix = readings * unknowns * 8 / 2**20
    print(
        f"{readings:8d} {unknowns:8d} {seconds:8.1f} {memory:8.0f} {matrix:8.0f} {found.report.iterations:10d}",
        flush=True,
    )


def main() -> int:
    """Every case in a process of its own."""
    if len(sys.argv) == 3:
        case(int(sys.argv[1]), int(sys.argv[2]))
        return 0
    print("readings unknowns  seconds       MB  (matrix) iterations")
    for readings, degree in CASES:
        subprocess.run([sys.executable, __file__, str(readings), str(degree)], check=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
