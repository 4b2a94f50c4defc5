"""What compensation leaves: of a program, of the machine over its whole volume, over many seeds.

What a program leaves is read from its file alone. Compensation takes away what is predicted: what is left is the true
deviation less the predicted one, to first order. Both are seen from home, where work offsets are touched off. The
figure is the root mean square of the coordinates X, Y and Z over random points; the length of the error vector is
sqrt(3) times that. The study has the paper's machine at the noise of real lasers, three ways to its errors, and what
each leaves.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.word_choice import bar_error
from trueaxis.estimation.observations import Observations, observations
from trueaxis.evaluation.circular_test import Circularity, circularity
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.identification.paper.method import identify_paper
from trueaxis.identification.paper.solution import PaperOptions
from trueaxis.measurement.data import MeasuredData, read_data
from trueaxis.measurement.reading_model import ideal_bar
from trueaxis.measurement.simulate import filled_in
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, home_of
from trueaxis.reporting.pictures.tool_point import PathErrors
from trueaxis.view import View

FloatArray = NDArray[np.float64]
_ORIGIN = np.zeros((3, 1))
POINTS, SEED = 4000, 1
NOISE_UM = (0.01, 0.03, 0.1, 0.3, 1.0, 3.0)
STEPWISE = "the paper's plan, its stepwise method, polynomials"
ESTIMATE = "the paper's plan, the estimate"
PROPOSED = "a proposed plan, the estimate"


def path_errors(model: MachineModel, wanted: FloatArray, commanded: FloatArray, ball: FloatArray) -> PathErrors:
    """Errors at the wanted points (3, n; axis positions) of a path executed block by block.

    commanded: (3, m) ends of the blocks. A wanted point is held against the block end or block middle that comes
    nearest to it: words are met at ends, and half steps of words in the middles. ball: (3, 1), workpiece frame.
    """
    target = model.ideal(wanted, _ORIGIN)
    middles = 0.5 * (commanded[:, :-1] + commanded[:, 1:])
    reached = np.concatenate([commanded, middles], axis=1)
    actual = model.ideal(reached, _ORIGIN) + model.deviation(reached, _ORIGIN)
    error = np.empty_like(target)
    for index in range(target.shape[1]):
        off = actual - target[:, index : index + 1]
        error[:, index] = off[:, np.argmin(np.einsum("in,in->n", off, off))]
    return PathErrors(bar_error(target, error, ball), np.linalg.norm(error, axis=0))


def read_wanted(cl_file: Path) -> FloatArray:
    """The GOTO points of the demonstration's CL file, (3, n), axis positions."""
    rows = [line[5:].split(",") for line in cl_file.read_text().splitlines() if line.startswith("GOTO/")]
    return np.array(rows, dtype=np.float64).T


def circles(model: MachineModel, folder: Path) -> dict[str, tuple[FloatArray, Circularity]]:
    """Polar angles (rad) and circular deviation of each ball-bar run of a data folder."""
    data = read_data(folder, model)
    found: dict[str, tuple[FloatArray, Circularity]] = {}
    for index, run in enumerate(data.setup.runs):
        rows = data.readings.of_run(index)
        bar = ideal_bar(model, run, np.ascontiguousarray(data.readings.positions[:, rows]))
        angles = np.arctan2(bar[1], bar[0])
        found[run.id] = angles, circularity(angles, data.readings.reading[rows])
    return found


def left_um(truth: MachineModel, values: ErrorValues | None) -> float:
    """Root mean square of a coordinate, um, of the true machine compensated with these values; None: not at all."""
    left = _from_home(truth)
    if values is not None:
        left = left - _from_home(truth.with_values(values))
    return 1e3 * float(np.sqrt(np.mean(left**2)))


def _from_home(machine: MachineModel) -> FloatArray:
    """(3, n): deviation of the tool point at random points, less that at home, mm."""
    draw = np.random.default_rng(SEED)
    positions = np.array([draw.uniform(*machine.travel[axis], POINTS) for axis in machine.axes])
    terms: list[tuple[View, FloatArray]] = [("tool_in_workpiece", np.zeros((3, 1)))]
    here, home = machine.view_deviations(terms, positions)[0], machine.view_deviations(terms, home_of(machine))[0]
    return np.asarray(here - home)


@dataclass(frozen=True, slots=True, eq=False)
class Study:
    """noise_um: (n,); nothing: what is left without compensation, um; left: way -> (n, seeds), um; see `left_um`."""

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
