"""Laser lines: along which line a target moves, and what a line that is not where it should be does to readings."""

from collections.abc import Sequence
from typing import Literal

import numpy as np

from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.reading_model import home_positions, ideal_bar
from trueaxis.measure.setup import Run

LineKind = Literal["displacement", "straightness", "linkage", "none"]
ACROSS = 1e-6  # share of the sensed direction along the motion up to which a run reads across its motion
STRAIGHT = 1e-6  # second singular value of a path over the first up to which the path is a line


def path_line(machine: IdentifiedMachine, run: Run, positions: FloatArray) -> tuple[FloatArray, FloatArray] | None:
    """Unit direction (3,) in which the target of a laser moves against the reference, and the way (n,) from home, mm;
    None where it rests or does not move on a line.
    """
    home = home_positions(run, machine.axes)
    if home is None or not positions.shape[1]:
        return None
    path = ideal_bar(machine, run, positions) - ideal_bar(machine, run, home)
    _, size, along = np.linalg.svd(path.T, full_matrices=False)
    if size[0] < STRAIGHT or size[1:].max(initial=0.0) > STRAIGHT * size[0]:
        return None
    motion = along[0] * np.sign(along[0][np.abs(along[0]).argmax()])
    return motion, motion @ path


def line_kind(run: Run, line: tuple[FloatArray, FloatArray] | None) -> LineKind:
    """What a laser run measures of its line: along it, across it, or (two axes at once) something of both."""
    if run.instrument != "laser" or run.direction is None or line is None:
        return "none"
    share = abs(float(np.array(run.direction) @ line[0]))
    return "displacement" if share > 1.0 - ACROSS else "straightness" if share < ACROSS else "linkage"


def misplaced(directions: Sequence[FloatArray], lines: Sequence[tuple[FloatArray, FloatArray]]) -> FloatArray:
    """(n, 2 or 4): readings by offset, then slope, of the line in each direction across it that runs sense.

    directions: (3,), sensed, of each run; lines: motion and way of each, all along one line.
    """
    sensed, motion = np.array(directions), lines[0][0]
    across = sensed - np.outer(sensed @ motion, motion)
    _, size, basis = np.linalg.svd(across, full_matrices=False)
    basis = basis[size > ACROSS]
    return np.vstack(
        [
            np.kron(np.stack([np.ones_like(way), way], axis=1), basis @ direction)
            for direction, (_, way) in zip(sensed, lines, strict=True)
        ]
    )
