"""The paper's measuring plan, 18 laser runs, at the noise of real lasers: stepwise method and estimate.

`python -m tests.estimation.paper_plan [SEEDS]` prints, for every noise, how far the predicted tool point is from that
of the true machine, from home, over random points of the volume.
"""

import sys
from pathlib import Path

import numpy as np

from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.observations import Observations, observations
from trueaxis.identify.paper.method import identify_paper
from trueaxis.identify.paper.result import PaperOptions
from trueaxis.measure.data import read_data
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.reading_model import expected_readings
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import MachineModel, load_model
from trueaxis.runtime.uncertainty import home_of

ROOT = Path(__file__).parents[2]
PLAN = ROOT / "machines" / "dmu60p_runs"
NOISE_UM = (0.01, 0.1, 0.3, 1.0, 3.0)
POINTS = 300


def true_machine() -> MachineModel:
    """That of `demo`: the paper's curves."""
    machines = ROOT / "machines"
    return load_model(machines / "dmu60p.toml", machines / "dmu60p_errors.json", ROOT / "generated")


def measured(machine: MachineModel, noise_um: float, seed: int) -> Observations:
    """The plan's readings of the machine, with white noise."""
    data = read_data(PLAN, machine)
    plan = data.readings
    reading = expected_readings(machine, data.setup.runs, plan.run, plan.positions)
    reading = reading + 1e-3 * noise_um * np.random.default_rng(seed).standard_normal(reading.size)
    made = type(plan)(**{name: getattr(plan, name) for name in plan.__slots__} | {"reading": reading})
    return observations(str(PLAN), data.setup.runs, made)


def from_home(machine: MachineModel) -> FloatArray:
    """(3, n): deviation of the tool point at random points, less that at home, mm."""
    draw = np.random.default_rng(1)
    positions = np.array([draw.uniform(*machine.travel[axis], POINTS) for axis in machine.axes])
    terms = [("tool_in_workpiece", np.zeros((3, 1)))]
    here, home = machine.view_deviations(terms, positions)[0], machine.view_deviations(terms, home_of(machine))[0]
    return np.asarray(here - home)


def off_um(machine: MachineModel, values: ErrorValues) -> float:
    """Root mean square of the error of predictions with these values, um."""
    error = from_home(machine.with_values(values)) - from_home(machine)
    return 1e3 * float(np.sqrt(np.mean(np.sum(error**2, axis=0))))


def both(machine: MachineModel, noise_um: float, seed: int) -> tuple[float, float]:
    """Errors of predictions by the stepwise method with polynomials, and by the estimate, um."""
    observed = measured(machine, noise_um, seed)
    stepwise = identify_paper(machine, observed, PaperOptions("convention", None, noise_um, "polynomial"))
    return off_um(machine, stepwise.values), off_um(machine, estimate(machine, observed).values)


def main() -> int:
    seeds = int(sys.argv[1]) if len(sys.argv) > 1 else 10
    machine = true_machine()
    print(f"doing nothing: {1e3 * float(np.sqrt(np.mean(np.sum(from_home(machine) ** 2, axis=0)))):.1f} um")
    print("noise um   stepwise: mean  sd  worst     estimate: mean  sd  worst   (um)")
    for noise in NOISE_UM:
        found = np.array([both(machine, noise, seed) for seed in range(seeds)])
        told = "     ".join(f"{row.mean():6.2f}  {row.std(ddof=1):5.2f}  {row.max():6.2f}" for row in found.T)
        print(f"{noise:7.2f}    {told}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
