"""What effects need to know of readings or points, and which columns lack it."""

from collections.abc import Iterator, Sequence

import numpy as np
import numpy.typing as npt

from trueaxis.effects.kind import Kind
from trueaxis.effects.placement import concerns, used_variables
from trueaxis.io.faults import Fault
from trueaxis.measurement.readings import Readings
from trueaxis.measurement.setup import Run
from trueaxis.model.context import Context
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.model import MachineModel

BoolArray = npt.NDArray[np.bool_]

_COLUMNS = {  # variables of an axis and what tells them
    "t": "time_s",
    "T": "temperature_c",
    "v": "feed (or time_s)",
    "d_time": "time_s (or, by ball bar, feed)",
}


def faults_of_readings(
    machine: MachineModel, runs: Sequence[Run], readings: Readings, context: Context, asked: BoolArray, file: str
) -> list[Fault]:
    """What the readings lack for the machine's effects in the rows that are asked for, a fault for each column.

    context: of all rows; asked: (n,); file: of the readings, which the faults are of.
    """
    home = context.home or context
    zeroed = np.array([run.instrument != "ballbar" for run in runs])[readings.run]
    unknown = {
        "t": np.isnan(context.time) | (zeroed & np.isnan(home.time)),
        "T": np.isnan(context.temperature) | (zeroed & np.isnan(home.temperature)),
        "v": np.isnan(context.velocity).any(axis=0),
        "d_time": np.isnan(context.time_since).any(axis=0),
    }
    found = []
    for variable, effects in _needed(machine):
        wrong = np.zeros_like(asked)
        for values, kind in effects:
            concerned = np.array([concerns(kind, values.effect, run) for run in runs])
            wrong |= unknown[variable] & asked & concerned[readings.run]
        if wrong.any():
            rows = np.flatnonzero(wrong)
            first = rows[np.lexsort((readings.seq[rows], readings.run[rows]))[0]]
            problem = f'is not known in row {readings.seq[first]} of run "{readings.run_ids[readings.run[first]]}"'
            if zeroed[first] and variable in ("t", "T"):
                problem += " or where the run began"
            found.append(_fault(file, variable, problem, effects))
    return found


def faults_of_points(machine: MachineModel, context: Context, file: str) -> list[Fault]:
    """What points lack for the machine's effects on component errors, a fault for each column."""
    unknown = {"t": np.isnan(context.time), "T": np.isnan(context.temperature)}
    found = []
    for variable, effects in _needed(machine):
        mine = [(values, kind) for values, kind in effects if kind.place == "component"]
        if mine and variable in unknown and unknown[variable].any():
            found.append(_fault(file, variable, f"is not known at point {int(np.argmax(unknown[variable])) + 1}", mine))
    return found


def _needed(machine: MachineModel) -> Iterator[tuple[str, list[tuple[EffectValues, Kind]]]]:
    """What columns tell and the effects whose terms depend on it, of the own or the other axis."""
    terms = [(values, machine.kinds[values.effect.kind]) for values in machine.effect_values]
    for variable in _COLUMNS:
        mine = [(values, kind) for values, kind in terms if {variable, f"{variable}_b"} & set(used_variables(kind))]
        if mine:
            yield variable, mine


def _fault(file: str, variable: str, problem: str, effects: Sequence[tuple[EffectValues, Kind]]) -> Fault:
    told = ", ".join(values.effect.label for values, _ in effects)
    return Fault(file, f"column {_COLUMNS[variable]}", problem, f"a value: it is needed for {told}")
