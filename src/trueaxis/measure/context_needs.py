"""What effects need to know of readings or points, and which columns lack it."""

from collections.abc import Iterator, Sequence

import numpy as np
import numpy.typing as npt

from trueaxis.effects.kind import Kind
from trueaxis.effects.placement import context_of as variables_of_term
from trueaxis.faults import Fault
from trueaxis.measure.machine import EffectMachine
from trueaxis.measure.reading_effects import concerns
from trueaxis.measure.readings import Readings
from trueaxis.measure.setup import Run
from trueaxis.runtime.context import Context
from trueaxis.runtime.effect_values import EffectValues

BoolArray = npt.NDArray[np.bool_]

_COLUMNS = {"time_s": ("t",), "temperature_c": ("T",), "feed": ("v", "v_b")}


def faults_of_readings(
    machine: EffectMachine, runs: Sequence[Run], readings: Readings, context: Context, asked: BoolArray, file: str
) -> list[Fault]:
    """What the readings lack for the machine's effects in the rows that are asked for, a fault for each column.

    context: of all rows; asked: (n,); file: of the readings, which the faults are of.
    """
    home = context.home or context
    zeroed = np.array([run.instrument != "ballbar" for run in runs])[readings.run]
    unknown = {
        "time_s": np.isnan(context.time) | (zeroed & np.isnan(home.time)),
        "temperature_c": np.isnan(context.temperature) | (zeroed & np.isnan(home.temperature)),
        "feed": np.isnan(context.velocity).any(axis=0),
    }
    found = []
    for column, effects in _needed(machine):
        wrong = np.zeros_like(asked)
        for values, kind in effects:
            concerned = np.array([kind.place == "component" or concerns(kind, values.effect, run) for run in runs])
            wrong |= unknown[column] & asked & concerned[readings.run]
        if wrong.any():
            rows = np.flatnonzero(wrong)
            first = rows[np.lexsort((readings.seq[rows], readings.run[rows]))[0]]
            problem = f'is not known in row {readings.seq[first]} of run "{readings.run_ids[readings.run[first]]}"'
            if zeroed[first] and column != "feed":
                problem += " or where the run began"
            found.append(_fault(file, column, problem, effects))
    return found


def faults_of_points(machine: EffectMachine, context: Context, file: str) -> list[Fault]:
    """What points lack for the machine's effects on component errors, a fault for each column."""
    unknown = {"time_s": np.isnan(context.time), "temperature_c": np.isnan(context.temperature)}
    found = []
    for column, effects in _needed(machine):
        mine = [(values, kind) for values, kind in effects if kind.place == "component"]
        if mine and column in unknown and unknown[column].any():
            found.append(_fault(file, column, f"is not known at point {int(np.argmax(unknown[column])) + 1}", mine))
    return found


def _needed(machine: EffectMachine) -> Iterator[tuple[str, list[tuple[EffectValues, Kind]]]]:
    """Columns and the effects whose terms depend on them."""
    terms = [(values, machine.kinds[values.effect.kind]) for values in machine.effect_values]
    for column, variables in _COLUMNS.items():
        mine = [(values, kind) for values, kind in terms if set(variables) & set(variables_of_term(kind))]
        if mine:
            yield column, mine


def _fault(file: str, column: str, problem: str, effects: Sequence[tuple[EffectValues, Kind]]) -> Fault:
    told = ", ".join(values.effect.label for values, _ in effects)
    more = " (or time_s)" if column == "feed" else ""
    return Fault(file, f"column {column}{more}", problem, f"a value: it is needed for {told}")
