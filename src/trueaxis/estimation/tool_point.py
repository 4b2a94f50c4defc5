"""How well an estimate knows the tool point over the volume, and how much of that is the prior."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from trueaxis.estimation.gauge import covariance_of
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.result import Estimate
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import Vector
from trueaxis.model.best_fit import placements
from trueaxis.model.covariance import Covariance
from trueaxis.model.extent import travel_positions, uncertainty_extent
from trueaxis.model.model import MachineModel, home_of
from trueaxis.model.uncertainty import derivative
from trueaxis.model.volume import volume_points

Datum = Literal["home", "best-fit"]
ORIGIN = (0.0, 0.0, 0.0)  # of the tool frame: the tool point that reports are about
POINTS = 200  # of the volume; a mean over them is good to some percent


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class ToolPoint:
    """Lengths of vectors at n positions (n_axes, n), mm: standard uncertainty of the tool point, the part of it that
    rests on the prior, and what the prior lets expect without readings. RMS over the tool points.
    """

    positions: FloatArray
    u: FloatArray
    u_prior: FloatArray
    prior: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class ToolSummary:
    """The tool point over the volume, seen from home, mm. u_rms, u_prior_rms, prior_rms: root mean squares of the
    standard uncertainty, of its part that rests on the prior, and of what is expected without readings; u_placed_rms,
    prior_placed_rms: the first and the last of a workpiece placed where it fits best; all of lengths of vectors over
    POINTS positions. largest_u: the largest u of a coordinate over the travel, at `largest_at` (axis -> mm or deg), as
    `uncertainty_extent` has it for commands that use the values. estimated: whether sizes of errors were estimated, by
    which prior_rms is, or are those of [prior]. u_usual_rms: u_rms by the usual sizes of instrument unknowns, where the
    covariance holds these as well; largest_u_usual: largest_u by these.
    """

    tools: tuple[Vector, ...]
    u_rms: float
    u_prior_rms: float
    prior_rms: float
    u_placed_rms: float
    prior_placed_rms: float
    largest_u: float
    largest_at: dict[str, float]
    estimated: bool
    u_usual_rms: float | None = None
    largest_u_usual: float | None = None


def volume(model: MachineModel) -> FloatArray:
    """(n_axes, POINTS): positions spread evenly over the travels."""
    return volume_points(model.travel, model.axes, POINTS)


def tool_point(found: Estimate, positions: FloatArray, tools: Sequence[Vector], datum: Datum = "home") -> ToolPoint:
    """At positions (n_axes, n), of points in the tool frame, mm.

    Before the convention for straightness and squareness, which moves none of them.
    """
    machine = slice(found.layout.of_machine)
    moved = moved_by(found.layout, positions, tools, datum)
    spread = moved @ found.spread[machine]
    by_prior = spread[:, spread.shape[1] - found.of_prior :]
    u, u_prior, prior = (_length(part, positions.shape[1]) for part in (spread, by_prior, moved * found.scale[machine]))
    return ToolPoint(positions=positions, u=u, u_prior=u_prior, prior=prior)


def moved_by(layout: Layout, positions: FloatArray, tools: Sequence[Vector], datum: Datum) -> FloatArray:
    """(n_tools * 3 * n, of_machine): by how much unknowns in mm and rad move the tool points against a datum.

    Divided by the root of the number of tools, so that squares add up to their mean. home: the tool point at home;
    best-fit: a workpiece placed where it fits best at all of the positions.
    """
    model, known = layout.model, covariance_of(layout, np.zeros((layout.count, 0)))
    ends = [np.array(point)[:, np.newaxis] for point in tools]
    each = [derivative(model, known, positions, tool) - derivative(model, known, home_of(model), tool) for tool in ends]
    moved = np.concatenate(each, axis=2)
    if datum == "best-fit":
        rigid = placements(np.hstack([model.ideal(positions, tool) for tool in ends])).directions
        moved = moved - np.einsum("inr,rk->ikn", rigid, np.einsum("inr,ikn->rk", rigid, moved))
    parts = np.split(moved, len(tools), axis=2)
    rows = [part.transpose(0, 2, 1).reshape(-1, layout.of_machine) for part in parts]
    return np.asarray(np.vstack(rows) / np.sqrt(len(tools)))


def _length(rows: FloatArray, count: int) -> FloatArray:
    """(count,): of vectors whose coordinates are rows, in the order of `moved_by`."""
    return np.asarray(np.sqrt(np.sum((rows**2).sum(axis=1).reshape(-1, count), axis=0)))


def moved_without(found: Estimate, tools: Sequence[Vector]) -> tuple[float, float]:
    """RMS over the volume, from home, mm: by how much the tool point moves when runs that contradict the others are
    left out, and its u by the others alone; zero and u where none does.
    """
    positions = volume(found.layout.model)
    if not found.readings.contradicting:
        return 0.0, _rms(tool_point(found, positions, tools).u)
    machine, last = slice(found.layout.of_machine), found.readings.contradicting[-1]
    by_unknown = moved_by(found.layout, positions, tools, "home")
    moved = by_unknown @ (found.unknowns - last.without)[machine, np.newaxis]
    u = by_unknown @ last.spread[machine]
    return _rms(_length(moved, positions.shape[1])), _rms(_length(u, positions.shape[1]))


def tool_summary(found: Estimate, tools: Sequence[Vector], covariance: Covariance | None = None) -> ToolSummary:
    """Over the volume. found: before the convention for straightness and squareness, which moves no tool point;
    covariance: of its values, with effects; None: without.
    """
    positions = volume(found.layout.model)
    seen, placed = tool_point(found, positions, tools), tool_point(found, positions, tools, "best-fit")
    model, known = found.layout.model.with_values(found.values), covariance or covariance_of(found.layout, found.spread)
    expected = None if known.usual is None else found.as_expected
    usual = None if expected is None else replace(found, spread=expected.spread, of_prior=expected.of_prior)
    positions = travel_positions(model, known)
    extents = [uncertainty_extent(model, known, positions, np.array(tool)[:, np.newaxis]) for tool in tools]
    largest = max(extents, key=lambda one: one.largest_u)
    return ToolSummary(
        tools=tuple(tools),
        u_rms=_rms(seen.u),
        u_prior_rms=_rms(seen.u_prior),
        prior_rms=_rms(seen.prior),
        u_placed_rms=_rms(placed.u),
        prior_placed_rms=_rms(placed.prior),
        largest_u=largest.largest_u,
        largest_at=dict(zip(model.axes, np.round(largest.largest_at, 1).tolist(), strict=True)),
        estimated=found.iteration.rounds > 0,
        u_usual_rms=None if usual is None else _rms(tool_point(usual, volume(found.layout.model), tools).u),
        largest_u_usual=max(one.largest_u_usual or 0.0 for one in extents) if usual is not None else None,
    )


def _rms(values: FloatArray) -> float:
    return float(np.sqrt(np.mean(values**2)))
