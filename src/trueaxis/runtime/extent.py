"""The uncertainty of the tool point over many positions at once: over the travel, or along a program."""

from dataclasses import dataclass
from itertools import product

import numpy as np

from trueaxis.runtime.covariance import Covariance
from trueaxis.runtime.curves import FloatArray
from trueaxis.runtime.model import MachineModel
from trueaxis.runtime.uncertainty import OPEN_MOVES, derivative, home_of, open_steps, tool_uncertainty

_MOST_POSITIONS = 2000  # of a grid over the travel: 12 in each of three axes, 4 in each of five
_TAKES_PART = 1e-6  # share of an open combination from which a component belongs to it


@dataclass(frozen=True, slots=True, kw_only=True)
class UncertaintyExtent:
    """Of the tool point at a number of positions, relative to home.

    points: how many; largest_u: largest standard uncertainty of a coordinate, mm, of those that are known (0: none);
    unknown: positions at which an uncertainty is not known; open: those of them that rest on what nothing determines;
    largest_open: by how much that moves the tool at the size of the prior, mm; components: those that are open there.
    shift: by how much what nothing determines may displace this tool point against the origin of the tool frame, the
    same everywhere, at the size of the prior, mm.
    """

    points: int
    largest_u: float
    unknown: int
    open: int
    largest_open: float
    components: tuple[str, ...]
    shift: float = 0.0

    @property
    def counted(self) -> float:
        """The largest standard uncertainty, mm; infinite where one is not known or not determined."""
        return float("inf") if self.unknown else self.largest_u


def uncertainty_extent(
    model: MachineModel, covariance: Covariance, positions: FloatArray, tool: FloatArray
) -> UncertaintyExtent:
    """The largest uncertainty over positions (n_axes, n), mm or deg, of the point `tool` (3, 1), mm, datum home."""
    uncertainty = tool_uncertainty(model, covariance, positions, tool, datum=home_of(model))
    at_home = tool_uncertainty(model, covariance, home_of(model), tool, datum=None)
    known = np.where(np.isnan(uncertainty.u), 0.0, uncertainty.u)
    rests = (uncertainty.open > 0.0).any(axis=0)
    return UncertaintyExtent(
        points=positions.shape[1],
        largest_u=float(known.max(initial=0.0)),
        unknown=int(np.isnan(uncertainty.u).any(axis=0).sum()),
        open=int(rests.sum()),
        largest_open=float(uncertainty.open.max(initial=0.0)),
        components=_open_components(model, covariance, positions[:, rests][:, :_MOST_POSITIONS], tool),
        shift=float(at_home.open.max()),
    )


def volume_grid(model: MachineModel) -> FloatArray:
    """(n_axes, n): a regular grid over the travel of all axes, its ends included, mm or deg."""
    each = max(2, int(_MOST_POSITIONS ** (1.0 / len(model.axes))))
    ends = [np.linspace(*model.travel[axis], each) for axis in model.axes]
    return np.array(list(product(*ends))).T


def _open_components(
    model: MachineModel, covariance: Covariance, positions: FloatArray, tool: FloatArray
) -> tuple[str, ...]:
    """The components that take part in open combinations that move the tool at these positions."""
    if positions.shape[1] == 0:
        return ()
    steps = open_steps(model.machine, covariance)
    at_home = derivative(model, covariance, home_of(model), tool)
    by_value = derivative(model, covariance, positions, tool) - at_home
    moves = np.abs(np.einsum("ikn,kd->ind", by_value, steps, optimize=True)).max(axis=(0, 1), initial=0.0)
    moving = covariance.open[:, moves > OPEN_MOVES]
    largest = np.abs(moving).max(axis=0, initial=0.0)
    return tuple(
        name
        for name in covariance.components
        if (np.abs(moving[covariance.rows_of(name)]) > _TAKES_PART * largest).any()
    )
