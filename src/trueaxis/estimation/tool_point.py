"""How well an estimate knows the tool point over the volume, relative to home, and how much of that is the prior."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.estimate import Estimate
from trueaxis.estimation.gauge import covariance_of
from trueaxis.estimation.layout import Layout
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.setup import Vector
from trueaxis.runtime.model import MachineModel
from trueaxis.runtime.uncertainty import derivative, home_of

POINTS, SEED = 200, 11  # of the volume; a mean over them is good to some percent


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class ToolPoint:
    """Lengths of vectors at n positions (n_axes, n), mm: standard uncertainty of the tool point seen from home, the
    part of it that rests on the prior, and what the prior lets expect without readings. RMS over the tool points.
    """

    positions: FloatArray
    u: FloatArray
    u_prior: FloatArray
    prior: FloatArray


def volume(model: MachineModel) -> FloatArray:
    """(n_axes, POINTS): positions drawn evenly from the travels, always the same."""
    draw = np.random.default_rng(SEED)
    return np.array([draw.uniform(*model.travel[axis], POINTS) for axis in model.axes])


def tool_point(found: Estimate, positions: FloatArray, tools: Sequence[Vector]) -> ToolPoint:
    """At positions (n_axes, n), of points in the tool frame, mm. Before the convention: it moves none of them."""
    moved = derivative_from_home(found.layout, positions, tools)
    spread = moved @ found.spread[: found.layout.of_machine]
    by_prior = (spread @ found.spread.T) / found.scale
    prior = moved * found.scale[: found.layout.of_machine]
    u, u_prior, expected = (_length(part, positions.shape[1]) for part in (spread, by_prior, prior))
    return ToolPoint(positions=positions, u=u, u_prior=np.minimum(u_prior, u), prior=expected)


def derivative_from_home(layout: Layout, positions: FloatArray, tools: Sequence[Vector]) -> FloatArray:
    """(n_tools * n * 3, of_machine): of the tool points, less those at home, by the unknowns in mm and rad.

    Divided by the root of the number of tools, so that squares add up to their mean.
    """
    model, known = layout.model, covariance_of(layout, np.zeros((layout.count, 0)))
    parts = []
    for point in tools:
        tool = np.array(point)[:, np.newaxis]
        moved = derivative(model, known, positions, tool) - derivative(model, known, home_of(model), tool)
        parts.append(moved.transpose(2, 0, 1).reshape(-1, layout.of_machine))
    return np.vstack(parts) / np.sqrt(len(tools))


def _length(rows: FloatArray, count: int) -> FloatArray:
    """(n,): of vectors whose coordinates are rows, in the order of `derivative_from_home`."""
    squares = np.sum(rows**2, axis=1).reshape(-1, count, 3)
    return np.asarray(np.sqrt(squares.sum(axis=(0, 2))))
