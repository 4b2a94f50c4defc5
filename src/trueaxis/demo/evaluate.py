"""What a compensated program leaves, read from the program file alone, and the machine over its whole volume.

Compensation takes away what is predicted: what is left is the true deviation less the predicted one, to first order.
Both are seen from home, where work offsets are touched off. The figure is the root mean square of the coordinates X, Y
and Z over random points; the length of the error vector is sqrt(3) times that.
"""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.word_choice import bar_error
from trueaxis.evaluation.circular_test import Circularity, circularity
from trueaxis.measurement.data import read_data
from trueaxis.measurement.reading_model import ideal_bar
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel
from trueaxis.model.uncertainty import home_of
from trueaxis.reporting.pictures.tool_point import PathErrors
from trueaxis.view import View

FloatArray = NDArray[np.float64]
_ORIGIN = np.zeros((3, 1))
POINTS, SEED = 4000, 1


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
