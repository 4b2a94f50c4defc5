"""Effects on readings themselves and on the points of a set-up."""

from dataclasses import replace
from typing import Literal

import numpy as np

from trueaxis.effects.kind import Effect
from trueaxis.effects.placement import concerns
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_context import run_reading_context
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.context import Context
from trueaxis.model.model import MachineModel

End = Literal["target", "reference"]


def reading_effects(machine: MachineModel, run: Run, positions: FloatArray, context: Context) -> FloatArray:
    """What effects add to the readings of a run as they are, (n,), mm: no zero point is subtracted.

    positions: (n_axes, n), mm or deg. NaN where the context lacks what an effect depends on.
    """
    total = np.zeros(positions.shape[1])
    mine = [
        values
        for values in machine.effect_values
        if (kind := machine.kinds[values.effect.kind]).place == "reading" and concerns(kind, values.effect, run)
    ]
    if mine:
        here = run_reading_context(machine, run, positions, context.time, context.temperature)
        for values in mine:
            total += machine.reading_effect(values, here)
    return total


def placed_run(machine: MachineModel, run: Run) -> Run:
    """The run with its points where effects say that they are; the run itself where none says so.

    A point moves in the frame of its body by x, y, z (mm): the end that the effect names, else the target of a laser
    and the ball on the workpiece of a ball bar (the reference where no ball is on it).
    """
    for values in machine.effect_values:
        kind = machine.kinds[values.effect.kind]
        if kind.place == "point" and concerns(kind, values.effect, run):
            by = values.vector(kind)
            if moved_end(values.effect, run) == "target":
                run = replace(run, target=_moved(run.target, by))
            else:
                run = replace(run, reference=_moved(run.reference, by))
    return run


def moved_end(effect: Effect, run: Run) -> End:
    """Which point of a run an effect of the place `point` moves."""
    if effect.end is not None:
        return "reference" if effect.end == "reference" else "target"
    if run.instrument == "ballbar":
        return "target" if run.target.on == "workpiece" else "reference"
    return "target"


def _moved(end: PointOn, by: FloatArray) -> PointOn:
    x, y, z = (float(value) for value in np.array(end.point) + by)
    return PointOn(end.on, (x, y, z))
