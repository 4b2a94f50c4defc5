"""Whether set-up and readings can be of this machine: points, positions, length and readings that contradict others.

A reading is refused where it is off by more than BELIEVED times what the prior sizes of the errors allow there, besides
what its instrument may be off by. A contradiction of this size is a slip of writing: a wrong point, sign or unit.
"""

from pathlib import Path
from typing import cast

import numpy as np

from trueaxis.estimation.set_up import is_straightness, relative_motion
from trueaxis.identification.ball_causes import ball_causes
from trueaxis.identification.expected_size import expected_size
from trueaxis.io.faults import Fault
from trueaxis.measurement.data import MeasuredData, readings_path
from trueaxis.measurement.instrument_kinds import ARM, unit_of_file
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_geometry import along_line
from trueaxis.measurement.reading_model import ideal_reading
from trueaxis.measurement.readings import Readings
from trueaxis.measurement.setup import FILE_NAME, Run
from trueaxis.model.model import MachineModel

BELIEVED = 5.0  # times the prior standard deviation of a reading
# mm, what instruments may be off by: a ball or sphere is set up within a millimetre, with a ruler within five; the
# range of straightness optics; a laser's dead path and the growth of a cold machine, which a sensor at rest is to show;
# half of the range of an electronic autocollimator, 1 mrad (mm at ARM)
SET_UP = {"ballbar": 5.0, "probe": 5.0, "straightness": 2.5, "laser": 0.5, "displacement": 0.5, "angle": 1.0}
BY_EYE = 5e-4  # rad, one standard deviation: what a line of straightness is off by that nobody has aligned with care
MOST_ROWS = 5  # named of a run
IN_UNIT = "is the reading in {unit}? [prior] of the machine's spec says what errors may be expected"


def setup_faults(model: MachineModel, data: MeasuredData, folder: Path) -> list[Fault]:
    """Runs whose set-up or readings are not believable on the machine; dimensions are those of the model's values."""
    found: dict[str, list[Fault]] = {}
    for index, run in enumerate(data.setup.runs):
        rows = data.readings.of_run(index)
        if rows.size:
            found[run.id] = _faults_of_run(model, run, data.readings, rows, folder)
    wrong = [run for run, faults in found.items() if faults]
    silent = _silent(model)
    if not silent or len(wrong) < 2:
        return [fault for faults in found.values() for fault in faults]
    problem = f"{len(wrong)} runs contradict them as zero, which is what they are taken for: {', '.join(wrong)}"
    remedy = (
        "give them with --known E.json (a file of error values with these parameters, mm); the first of these runs:"
    )
    return [Fault("dimensions not given", ", ".join(silent), problem, remedy), found[wrong[0]][0]]


def _silent(model: MachineModel) -> list[str]:
    """Dimensions that no error value gives: one missing file is more likely than several wrong runs."""
    return [name for name in model.dimensions if name not in model.errors.parameters]


def _faults_of_run(model: MachineModel, run: Run, readings: Readings, rows: np.ndarray, folder: Path) -> list[Fault]:
    positions = np.ascontiguousarray(readings.positions[:, rows])
    reading = np.nan_to_num(readings.reading[rows])  # a plan's rows are checked for their geometry
    ideal = ideal_reading(model, run, positions)
    allowed = BELIEVED * expected_size(model, run, positions) + _set_up(model, run, positions)
    wrong = np.flatnonzero(~(np.abs(ideal - reading) <= allowed))
    if wrong.size == 0:
        return []
    first = int(wrong[0])
    if run.instrument == "ballbar" and not abs(ideal[first]) <= allowed[first]:
        return [
            Fault(
                str(folder / FILE_NAME),
                f"run {run.id}",
                _apart(run, ideal[first], first),
                ball_causes(model, run, positions, reading),
            )
        ]
    named = ", ".join(str(readings.seq[rows[row]]) for row in wrong[:MOST_ROWS])
    more = f" and {wrong.size - MOST_ROWS} more" if wrong.size > MOST_ROWS else ""
    worst = int(wrong[np.argmax(np.abs(reading[wrong]))])
    unit = unit_of_file(run.instrument)
    off, most = (float(one[worst]) / (ARM if unit == "rad" else 1.0) for one in (reading, allowed))
    problem = (
        f"run {run.id}, seq {named}{more}: up to {off:.6g} {unit}, where errors of machine and set-up let "
        f"expect {most:.2g} {unit} at most"
    )
    return [Fault(str(readings_path(folder)), "column reading", problem, IN_UNIT.format(unit=unit))]


def _set_up(model: MachineModel, run: Run, positions: FloatArray) -> FloatArray | float:
    if run.instrument != "laser" or not is_straightness(model, run, positions):
        return SET_UP[run.instrument]
    along = np.abs(along_line(relative_motion(model, run, positions)))
    return np.asarray(SET_UP["straightness"] + BELIEVED * BY_EYE * along)


def _apart(run: Run, off: float, row: int) -> str:
    length = cast(float, run.length)
    at = "at the first position" if row == 0 else f"at position {row + 1}"
    return f"the balls are {length + off:.6g} mm apart {at}, not {length:g} mm"
