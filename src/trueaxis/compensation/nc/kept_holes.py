"""Holes of canned cycles that stay cycles, since their motions cannot be written out: tapping, which couples Z to the
spindle, and boring that turns the tool away at the bottom. The control makes the hole; its words say where.

X and Y are those of the middle of the hole: they stay the same from R to the bottom, and so what errors differ by along
the hole is halved. R and Z are right at the top and at the bottom.
"""

from dataclasses import dataclass

import numpy as np

from trueaxis.compensation.lattice import Lattice, word_steps
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import ErrorModel, FloatArray
from trueaxis.compensation.moves import KeptHole
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.solve import solve

TOP, MIDDLE, BOTTOM = 0, 1, 2


@dataclass(frozen=True, slots=True)
class Drilled:
    """programmed, words: (n_axes, 3), top, middle and bottom of the hole, and where the words then put the axes, mm and
    deg; error: (3, 3), of the tool there, mm, workpiece frame; before: (3, 3), without compensation.
    """

    programmed: FloatArray
    words: FloatArray
    error: FloatArray
    before: FloatArray


def drilled(hole: KeptHole, model: ErrorModel, tool_point: FloatArray, settings: Settings) -> Drilled:
    """What the words of a hole are to be."""
    row = model.axes.index("Z")
    programmed = np.repeat(np.array(hole.bottom)[:, np.newaxis], 3, axis=1)
    programmed[row] = [hole.top, 0.5 * (hole.top + hole.bottom[row]), hole.bottom[row]]
    solved = solve(programmed, programmed, model, tool_point, settings.aim, settings.method).commands
    depth = solved[row].copy()
    commands = np.repeat(solved[:, [MIDDLE]], 3, axis=1)
    commands[row] = depth
    shift = np.array(hole.shift or [0.0] * len(model.axes))[:, np.newaxis]
    words = Lattice(shift, word_steps(model.axes, settings, hole.inch)).nearest(commands)
    target = model.ideal(programmed, tool_point)
    error = model.ideal(words, tool_point) + model.deviation(words, tool_point) - target
    return Drilled(programmed, words, error, model.deviation(programmed, tool_point))


def check_travel(hole: KeptHole, found: Drilled, model: ErrorModel, faults: FaultLog) -> None:
    """A fault where the hole, as programmed or as written, leaves the travel."""
    for axis, programmed, words in zip(model.axes, found.programmed, found.words, strict=True):
        low, high = model.travel[axis]
        ends = (programmed[BOTTOM], programmed[TOP], words[BOTTOM], words[TOP])
        if out := [at for at in ends if not low - 1e-9 <= at <= high + 1e-9]:
            right = f"from {low:g} to {high:g}, correction included"
            faults.add(hole.line, f"{axis} = {out[0]:g} is outside its travel", right)
