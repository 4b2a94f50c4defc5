"""The paper's machine at the noise of real lasers, over many seeds: three ways to its errors, and what they leave."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from trueaxis.demo.evaluate import left_um
from trueaxis.estimation.observations import Observations, observations
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.identification.paper.method import identify_paper
from trueaxis.identification.paper.solution import PaperOptions
from trueaxis.measurement.data import MeasuredData, read_data
from trueaxis.measurement.simulate import filled_in
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel

FloatArray = NDArray[np.float64]
NOISE_UM = (0.01, 0.03, 0.1, 0.3, 1.0, 3.0)
STEPWISE = "the paper's plan, its stepwise method, polynomials"
ESTIMATE = "the paper's plan, the estimate"
PROPOSED = "a proposed plan, the estimate"


@dataclass(frozen=True, slots=True, eq=False)
class Study:
    """noise_um: (n,); nothing: what is left without compensation, um; left: way -> (n, seeds), um; see volume.py."""

    noise_um: tuple[float, ...]
    nothing: float
    left: Mapping[str, FloatArray]


def study(truth: MachineModel, paper_plan: Path, proposed_plan: Path, seeds: int) -> Iterator[Study]:
    """What each way leaves, after every noise; the last one has all.

    truth: the machine that is measured; paper_plan, proposed_plan: data folders; seeds: of the noise, from 1 on.
    """
    plans = {folder: read_data(folder, truth) for folder in (paper_plan, proposed_plan)}
    ways: dict[str, tuple[Path, Callable[[MachineModel, Observations, float], ErrorValues]]] = {
        STEPWISE: (paper_plan, stepwise),
        ESTIMATE: (paper_plan, estimated),
        PROPOSED: (proposed_plan, estimated),
    }
    left: dict[str, list[list[float]]] = {way: [] for way in ways}
    for count, noise in enumerate(NOISE_UM, start=1):
        for way, (folder, identify) in ways.items():
            each = [measured(truth, plans[folder], str(folder), noise, seed) for seed in range(1, seeds + 1)]
            left[way].append([left_um(truth, identify(truth, one, noise)) for one in each])
        yield Study(NOISE_UM[:count], left_um(truth, None), {way: np.array(rows) for way, rows in left.items()})


def measured(truth: MachineModel, plan: MeasuredData, source: str, noise_um: float, seed: int) -> Observations:
    """The plan's readings of the machine, as `simulate` makes them."""
    readings = filled_in(truth, plan.setup.runs, plan.readings, noise_um=noise_um, seed=seed, replace_all=True)
    return observations(source, plan.setup.runs, readings)


def stepwise(machine: MachineModel, observed: Observations, noise_um: float) -> ErrorValues:
    """As `identify --method stepwise --curves polynomial`, which knows the noise."""
    return identify_paper(machine, observed, PaperOptions("convention", None, noise_um, "polynomial")).values


def estimated(machine: MachineModel, observed: Observations, _: float) -> ErrorValues:
    """As `identify`, which has to find the noise."""
    return identify_estimated(machine, observed, IdentifyOptions()).values


def study_text(found: Study) -> Iterator[str]:
    """The study as a table of Markdown: mean of the seeds, the worst one in brackets."""
    ways = list(found.left)
    yield f"| laser noise, um | {' | '.join(ways)} |"
    yield "|---" * (1 + len(ways)) + "|"
    for row, noise in enumerate(found.noise_um):
        cells = (f"{found.left[way][row].mean():.2f} ± {_spread(found.left[way][row]):.2f}" for way in ways)
        worst = (f"({found.left[way][row].max():.2f})" for way in ways)
        shown = " | ".join(f"{cell} {most}" for cell, most in zip(cells, worst, strict=True))
        yield f"| {noise:g} | {shown} |"


def _spread(values: FloatArray) -> float:
    return float(values.std(ddof=1)) if values.size > 1 else 0.0
