"""The uncertainty of the tool point over many positions at once: over the travel, or along a program."""

from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from trueaxis.model.bases import HatBasis
from trueaxis.model.context import Context
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import FloatArray
from trueaxis.model.model import MachineModel, home_of
from trueaxis.model.uncertainty import OPEN_MOVES, derivative, open_steps, tool_uncertainty
from trueaxis.model.volume import corners, volume_points

_POSITIONS = 2000  # over the travel
MOST_NAMED = 500  # positions from which the names of what is open are taken
_TAKES_PART = 1e-6  # share of an open combination from which a component belongs to it


@dataclass(frozen=True, slots=True, kw_only=True)
class UncertaintyExtent:
    """Of the tool point at a number of positions, relative to `datum`: home, or what else is named.

    points: how many; largest_u: largest standard uncertainty of a coordinate, mm, of those that are known (0: none),
    at the position largest_at (n_axes,), mm or deg;
    largest_u_prior: largest part of one that rests on the prior, mm, None where the parts are not known;
    unknown: positions at which an uncertainty is not known; open: those of them that rest on what nothing determines;
    largest_open: by how much that moves the tool at the size of the prior, mm; components: those that are open there,
    and location errors.
    u_readings_rms, correction_rms: root mean squares of the length of the uncertainty that the readings bring in (all
    of it where the prior's part is not known) and of the deviation from home, which a compensation takes away, over
    the positions where the first is known, mm; both 0 where it is nowhere.
    largest_u_usual: the largest u by the usual sizes of instrument unknowns, mm, see `ToolUncertainty`; None where
    there is one u alone. undetermined: whether `open` counts what the values themselves name as not determined, and
    not only values that somebody gave without a u.
    shift: by how much what nothing determines may displace this tool point against the origin of the tool frame, the
    same everywhere, at the size of the prior, mm.
    """

    points: int
    largest_u: float
    largest_u_prior: float | None
    unknown: int
    open: int
    largest_open: float
    components: tuple[str, ...]
    u_readings_rms: float = 0.0
    correction_rms: float = 0.0
    shift: float = 0.0
    largest_at: tuple[float, ...] = ()
    largest_u_usual: float | None = None
    undetermined: bool = False
    datum: str = "home"

    @property
    def counted(self) -> float:
        """The largest standard uncertainty, mm; infinite where one is not known or not determined."""
        return float("inf") if self.unknown else self.largest_u

    @property
    def worth_nothing(self) -> bool:
        """Whether what a compensation would take away is less than the noise of the readings brings in. What rests on
        the prior does not count: it is as large without a compensation.
        """
        return self.u_readings_rms > self.correction_rms

    def refused(self, max_u: float | None, accepted: bool) -> bool:
        """Whether nothing may be written: an uncertainty is above max_u, mm; without one, where the values are worth
        nothing, or rest on what neither readings nor a prior determine, and that is not accepted.
        """
        return self.counted > max_u if max_u is not None else (self.worth_nothing or self.undetermined) and not accepted


def uncertainty_extent(
    model: MachineModel,
    covariance: Covariance,
    positions: FloatArray,
    tool: FloatArray,
    datum: tuple[str, FloatArray] | None = None,
) -> UncertaintyExtent:
    """The largest uncertainty over positions (n_axes, n), mm or deg, of the point `tool` (3, 1), mm; datum: name and
    axis positions (n_axes, 1) of the place that it is relative to; None: home.
    """
    name, place = datum or ("home", home_of(model))
    context = after_reversals(model, positions)
    uncertainty = tool_uncertainty(model, covariance, positions, tool, datum=place, context=context)
    at_home = tool_uncertainty(model, covariance, home_of(model), tool, datum=None)
    known = np.where(np.isnan(uncertainty.u), 0.0, uncertainty.u)
    rests = (uncertainty.open > 0.0).any(axis=0)
    moved = model.deviation(positions, tool) - model.deviation(place, tool)
    told = ~np.isnan(uncertainty.u).any(axis=0)
    of_readings = np.sqrt(np.clip(known**2 - np.nan_to_num(uncertainty.u_prior) ** 2, 0.0, None))
    return UncertaintyExtent(
        points=positions.shape[1],
        largest_u=float(known.max(initial=0.0)),
        largest_u_prior=None
        if covariance.of_prior is None
        else float(np.nan_to_num(uncertainty.u_prior).max(initial=0.0)),
        unknown=int(np.isnan(uncertainty.u).any(axis=0).sum()),
        open=int(rests.sum()),
        largest_open=float(uncertainty.open.max(initial=0.0)),
        components=open_names(model, covariance, positions[:, rests][:, :MOST_NAMED], tool),
        u_readings_rms=_length_rms(of_readings[:, told]),
        correction_rms=_length_rms(moved[:, told]),
        shift=float(at_home.open.max()),
        undetermined=bool(rests.any() and model.errors.undetermined),
        largest_u_usual=None
        if uncertainty.u_usual is None
        else float(np.nan_to_num(uncertainty.u_usual).max(initial=0.0)),
        largest_at=tuple(positions[:, int(known.max(axis=0, initial=0.0).argmax())].tolist()) if known.size else (),
        datum=name,
    )


def _length_rms(vectors: FloatArray) -> float:
    """Of vectors (3, n); 0 of none."""
    return float(np.sqrt((vectors**2).sum(axis=0).mean())) if vectors.size else 0.0


def travel_positions(model: MachineModel, covariance: Covariance) -> FloatArray:
    """(n_axes, n): positions spread over the travel of all axes, its corners, mm or deg; and every position of a table,
    the other axes in the middle and at the corners of their travel.
    """
    points: list[tuple[float, ...]] = []
    for row, axis in enumerate(model.axes):
        others = [model.travel[other] if other != axis else (0.0,) for other in model.axes]
        middle = tuple(0.5 * (model.travel[other][0] + model.travel[other][1]) for other in model.axes)
        for node in table_positions(covariance, axis):
            points += [(*at[:row], node, *at[row + 1 :]) for at in (*product(*others), middle)]
    nodes = np.array(points).reshape(-1, len(model.axes)).T
    spread = volume_points(model.travel, model.axes, _POSITIONS)
    return np.hstack([spread, corners(model.travel, model.axes), nodes])


def table_positions(covariance: Covariance, axis: str) -> list[float]:
    """The positions of an axis at which components are told by tables: what is open there may be open nowhere else."""
    return sorted(
        {
            position
            for name, basis in zip(covariance.components, covariance.bases, strict=True)
            if name.axis == axis and isinstance(basis, HatBasis)
            for position in basis.positions
        }
    )


def after_reversals(model: MachineModel, positions: FloatArray) -> Context:
    """All axes have just turned back: where effects of direction and of reversals are largest."""
    still = Context.at_rest(len(model.axes), positions.shape[1])
    just = np.zeros_like(positions)
    return replace(still, directions=np.ones_like(positions), since_reversal=just, time_since=just, path_since=just)


def open_names(model: MachineModel, covariance: Covariance, positions: FloatArray, tool: FloatArray) -> tuple[str, ...]:
    """The components and location errors that take part in open combinations that move the tool at these positions.

    positions: (n_axes, n), mm or deg; tool: (3, 1), mm.
    """
    if positions.shape[1] == 0:
        return ()
    steps = open_steps(model.machine, covariance)
    at_home = derivative(model, covariance, home_of(model), tool)
    by_value = derivative(model, covariance, positions, tool, after_reversals(model, positions)) - at_home
    moves = np.abs(np.einsum("ikn,kd->ind", by_value, steps, optimize=True)).max(axis=(0, 1), initial=0.0)
    moving = covariance.open[:, moves > OPEN_MOVES]
    largest = np.abs(moving).max(axis=0, initial=0.0)
    start = sum(basis.count for basis in covariance.bases)
    located = [name for row, name in enumerate(covariance.locations, start) if (moving[row] != 0.0).any()]
    components = [
        name
        for name in covariance.components
        if (np.abs(moving[covariance.rows_of(name)]) > _TAKES_PART * largest).any()
    ]
    return (*components, *located)
