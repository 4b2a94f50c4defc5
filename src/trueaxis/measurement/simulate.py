"""Readings made from a machine model: plans filled in, with noise on request."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from trueaxis.io.faults import Faults
from trueaxis.measurement.instrument_kinds import ARM, unit_of_file
from trueaxis.measurement.machine import MeasuredMachine
from trueaxis.measurement.reading_model import expected_readings
from trueaxis.measurement.readings import Readings, angle_rows
from trueaxis.measurement.readings_reader import LARGEST_READING
from trueaxis.measurement.setup import Run
from trueaxis.model.context import Context


def filled_in(
    machine: MeasuredMachine,
    runs: Sequence[Run],
    readings: Readings,
    *,
    noise_um: float = 0.0,
    noise_urad: float = 0.0,
    seed: int = 0,
    replace_all: bool = False,
    context: Context | None = None,
) -> Readings:
    """The readings with plan rows (all rows where replace_all) filled in from the exact model.

    noise_um, noise_urad: standard deviation of the Gaussian noise added, of angle instruments the latter; the noise of
    a row depends on the seed and the row's place in the file alone. context: of all rows, for a machine with effects.
    """
    fill = rows_to_fill(readings, replace_all)
    filled = readings.reading.copy()
    if context is None:
        filled[fill] = expected_readings(machine, runs, readings.run[fill], readings.positions[:, fill])
    else:  # of whole runs: the plane of a circle is told by all its rows
        filled[fill] = expected_readings(machine, runs, readings.run, readings.positions, context)[fill]
    if noise_um > 0.0 or noise_urad > 0.0:
        sigma = np.where(angle_rows(readings.run, runs), noise_urad * 1e-6 * ARM, noise_um * 1e-3)
        noise = np.random.default_rng(seed).normal(0.0, 1.0, len(filled)) * sigma
        filled[fill] += noise[fill]
    return replace(readings, reading=filled)


def rows_to_fill(readings: Readings, replace_all: bool) -> npt.NDArray[np.bool_]:
    """(n,), the rows that get a reading: those of the plan, or all."""
    return np.ones_like(readings.planned) if replace_all else readings.planned


def check_simulated(readings: Readings, runs: Sequence[Run], file: str) -> None:
    """Raise InputError where a simulated reading is no reading: a bar that does not span its balls, or huge errors.

    file: the plan's readings, which the faults are of.
    """
    faults = Faults(file)
    for index, run_id in enumerate(readings.run_ids):
        rows = readings.of_run(index)
        values = readings.reading[rows]
        wrong = rows[~(np.abs(values) <= LARGEST_READING)]
        if len(wrong):
            unit = unit_of_file(runs[index].instrument)
            reads = readings.reading[wrong[0]] / (ARM if unit == "rad" else 1.0)
            problem = f'row {readings.seq[wrong[0]]} of run "{run_id}" would read {reads:.6g} {unit}'
            faults.add("column reading", problem, "points, positions and length that agree, errors in mm and rad")
    faults.raise_if_any()
