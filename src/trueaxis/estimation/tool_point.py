"""How well an estimate knows the tool point over the volume, and how much of that is the prior."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from trueaxis.estimation.estimate import Estimate
from trueaxis.estimation.gauge import covariance_of
from trueaxis.estimation.layout import Layout
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.setup import Vector
from trueaxis.runtime.model import MachineModel
from trueaxis.runtime.uncertainty import derivative, home_of

Datum = Literal["home", "best-fit"]
NOTHING = 1e-9  # of the largest singular value: a turn that moves no point
POINTS, SEED = 200, 11  # of the volume; a mean over them is good to some percent


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class ToolPoint:
    """Lengths of vectors at n positions (n_axes, n), mm: standard uncertainty of the tool point, the part of it that
    rests on the prior, and what the prior lets expect without readings. RMS over the tool points.
    """

    positions: FloatArray
    u: FloatArray
    u_prior: FloatArray
    prior: FloatArray


def volume(model: MachineModel) -> FloatArray:
    """(n_axes, POINTS): positions drawn evenly from the travels, always the same."""
    draw = np.random.default_rng(SEED)
    return np.array([draw.uniform(*model.travel[axis], POINTS) for axis in model.axes])


def tool_point(found: Estimate, positions: FloatArray, tools: Sequence[Vector], datum: Datum = "home") -> ToolPoint:
    """At positions (n_axes, n), of points in the tool frame, mm. Before the convention: it moves none of them."""
    moved = moved_by(found.layout, positions, tools, datum)
    spread = moved @ found.spread[: found.layout.of_machine]
    by_prior = (spread @ found.spread.T) / found.scale
    prior = moved * found.scale[: found.layout.of_machine]
    u, u_prior, expected = (_length(part, positions.shape[1]) for part in (spread, by_prior, prior))
    return ToolPoint(positions=positions, u=u, u_prior=np.minimum(u_prior, u), prior=expected)


def moved_by(layout: Layout, positions: FloatArray, tools: Sequence[Vector], datum: Datum) -> FloatArray:
    """(n_tools * n * 3, of_machine): by how much unknowns in mm and rad move the tool points against a datum.

    Divided by the root of the number of tools, so that squares add up to their mean. home: the tool point at home;
    best-fit: the workpiece where it fits best at all of the positions.
    """
    model, known = layout.model, covariance_of(layout, np.zeros((layout.count, 0)))
    parts = []
    for point in tools:
        tool = np.array(point)[:, np.newaxis]
        moved = derivative(model, known, positions, tool) - derivative(model, known, home_of(model), tool)
        parts.append(moved.transpose(2, 0, 1).reshape(-1, layout.of_machine))
    found = np.vstack(parts) / np.sqrt(len(tools))
    return found if datum == "home" else _placed(layout, found, positions, tools)


def _placed(layout: Layout, moved: FloatArray, positions: FloatArray, tools: Sequence[Vector]) -> FloatArray:
    """Less the best rigid displacement and rotation of the workpiece.

    A turn of the whole volume against the workpiece is taken up where the workpiece is aligned; balls and beams, which
    are aligned by the machine, do not see it.
    """
    axes = []
    for point in tools:
        seen = layout.model.view_ideal("tool_in_workpiece", positions, np.array(point)[:, np.newaxis])
        seen = (seen - seen.mean(axis=1, keepdims=True)) / (float(np.ptp(seen)) or 1.0)
        turned = [np.cross(unit, seen.T) for unit in np.eye(3)]
        shifted = [np.tile(unit, (seen.shape[1], 1)) for unit in np.eye(3)]
        axes.append(np.stack([*turned, *shifted], axis=-1).reshape(-1, 6))
    left, size, _ = np.linalg.svd(np.vstack(axes), full_matrices=False)
    rigid = left[:, size > NOTHING * size[0]]
    return np.asarray(moved - rigid @ (rigid.T @ moved))


def _length(rows: FloatArray, count: int) -> FloatArray:
    """(n,): of vectors whose coordinates are rows, in the order of `moved_by`."""
    squares = np.sum(rows**2, axis=1).reshape(-1, count, 3)
    return np.asarray(np.sqrt(squares.sum(axis=(0, 2))))
