"""Where the tool point really is, and how well that is known."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
import numpy.typing as npt
import polars as pl

from trueaxis.io.faults import InputError, RefusedError
from trueaxis.jobs.draws import Show, checked, drawn, faults_of_draws
from trueaxis.jobs.given import name_of, with_errors
from trueaxis.jobs.load import Errors
from trueaxis.jobs.printed import Printed
from trueaxis.jobs.tables import (
    ORIGIN,
    Positions,
    Tabular,
    at_least_zero,
    check_among,
    check_travel,
    positions_of,
    tool_points,
)
from trueaxis.jobs.typed import typed
from trueaxis.measurement.context import faults_of_points
from trueaxis.measurement.points import (
    DEVIATION_COLUMNS,
    PRIOR_COLUMNS,
    TOOL_COLUMNS,
    UNCERTAINTY_COLUMNS,
    check_predicted,
    deviations,
)
from trueaxis.model.best_fit import Placement, Placements, placements
from trueaxis.model.context import Context
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import FloatArray
from trueaxis.model.extent import MOST_NAMED, open_names
from trueaxis.model.grid import Grid
from trueaxis.model.measured_range import beyond_measured
from trueaxis.model.model import MachineModel, home_of
from trueaxis.model.uncertainty import ToolUncertainty, prior_size, tool_uncertainty
from trueaxis.monte_carlo.drawn import Drawn, drawn_columns
from trueaxis.monte_carlo.points import DrawnPoints
from trueaxis.monte_carlo.settings import Draws
from trueaxis.reporting.reliance import (
    above_sentence,
    draw_sentences,
    misfit_sentence,
    open_sentence,
    placement_sentence,
    range_sentences,
    usual_sentence,
)

Datum = Literal["machine", "home", "best-fit"]


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Prediction(Printed, Tabular):
    """Deviations of tool points, in the workpiece frame.

    axes: letters, the rows of positions; positions: (n_axes, n), mm or deg; tool: (3, n), mm; deviation: (3, n), actual
    minus ideal, mm; u: (3, n), its standard uncertainty, u_prior the part of that which rests on [prior], mm, NaN where
    unknown; open: (3, n), by how much what no reading determines could move the point, mm; notes: how far they may be
    relied on; placement: with datum "best-fit"; drawn: with draws; grid: of the positions, if they are
    of one. Printed, it is the report of `trueaxis predict`.
    """

    axes: tuple[str, ...]
    positions: FloatArray
    tool: FloatArray
    deviation: FloatArray
    u: FloatArray
    u_prior: FloatArray
    open: FloatArray
    notes: tuple[str, ...] = ()
    placement: Placement | None = None
    drawn: Drawn | None = None
    grid: Grid | None = None

    @property
    def has_picture(self) -> bool:
        """Whether the positions are a grid of two axes or more."""
        return self.grid is not None and self.grid.has_slices

    def picture(self) -> bytes:
        """Slices through the middle of the grid, as PNG: error, uncertainty, where draws and u differ.

        Raises ValueError without `has_picture`.
        """
        if self.grid is None or not self.has_picture:
            raise ValueError("picture: positions are no grid of two axes or more")
        from trueaxis.reporting.pictures.tool_point import maps_picture  # noqa: PLC0415  matplotlib takes long to import

        u = self.u if self.drawn is None else self.drawn.sd[:3]
        maps = {
            "error of the tool point": np.linalg.norm(self.deviation, axis=0),
            "its standard uncertainty: root sum of squares of x, y, z": np.linalg.norm(u, axis=0),
        }
        if self.drawn is not None and self.drawn.differing.any():
            title = "where draws and u differ: distance between the ends of their 95 % intervals"
            maps[title] = self.drawn.apart.max(axis=0)
        sliced = {title: self.grid.slices(self.axes, self.positions, values) for title, values in maps.items()}
        known = {
            title: slices for title, slices in sliced.items() if not all(np.isnan(one.values).all() for one in slices)
        }
        return maps_picture(known)

    def __str__(self) -> str:
        return "".join(f"note: {one}\n" for one in self.notes) + f"{self.positions.shape[1]} points\n"

    def to_polars(self) -> pl.DataFrame:
        """A row for each point, columns as in the table that `trueaxis predict` writes."""
        rows = [
            (self.axes, self.positions),
            (TOOL_COLUMNS, self.tool),
            (DEVIATION_COLUMNS, self.deviation),
            (UNCERTAINTY_COLUMNS, self.u),
            (PRIOR_COLUMNS, self.u_prior),
        ]
        rows += [] if self.drawn is None else drawn_columns(self.drawn)
        columns = {name: row for names, values in rows for name, row in zip(names, values, strict=True)}
        return pl.DataFrame(columns).fill_nan(None)


@typed
def predict(
    model: MachineModel,
    errors: Errors,
    positions: Positions,
    *,
    tool: npt.ArrayLike = ORIGIN,
    datum: Datum = "machine",
    context: Context | None = None,
    max_u: float | None = None,
    draws: Draws | int | None = None,
) -> Prediction:
    """The deviation of the tool point at axis positions, on the exact model (Eq. 4 of the paper), with uncertainty.

    positions: by axis letter, numbers or (n,) each, a table with such columns, or (n_axes, n), mm or deg; tool: (3,) or
    (3, n), the point in the tool frame, mm. datum: reference of deviations and uncertainties: the error-free machine;
    the tool point at home; the rigid placement of the workpiece that fits the points best. context: approach
    directions, times and temperatures, for machines with effects. max_u: largest standard uncertainty allowed, mm.
    draws: number of draws of the error values, the repeatability and the context (GUM Supplement 1), in addition to u;
    with workers of a `Draws` the calling module must be importable (`if __name__ == "__main__":`).

    Raises ValueError if an array has another shape or a position is outside the travel, InputError if no machine has
    such a deviation or an effect lacks a variable, RefusedError if max_u is exceeded.
    """
    asked = checked(draws)
    check_among(datum=(datum, Datum))
    at = positions_of(model, positions)
    check_travel(model, at)
    there = tool_points(tool, at.shape[1])
    whole = Context.at_rest(len(model.axes), at.shape[1]) if context is None else context
    at_least_zero(max_u=max_u)
    model = with_errors(model, errors)
    at_once = datum == "best-fit"
    if asked is not None and (
        wrong := faults_of_draws(errors.covariance, at.shape[1], name_of(errors), at_once=at_once)
    ):
        raise InputError(wrong)
    done = predicted(model, errors.covariance, at, there, whole, datum=datum)
    done = replace(done, grid=positions if isinstance(positions, Grid) else None)
    if refused := refusal(done, max_u):
        raise RefusedError((refused,), done)
    return done if asked is None else with_draws(done, model, errors.covariance, whole, datum, asked)


def refusal(done: Prediction, max_u: float | None) -> str:
    """Why the deviations may not be relied on; empty where they may. What is not known counts as infinite."""
    largest = float(np.max(np.where(np.isnan(done.u), np.inf, done.u), initial=0.0))
    return above_sentence(largest, max_u) if max_u is not None and largest > max_u else ""


def predicted(
    model: MachineModel,
    covariance: Covariance,
    positions: FloatArray,
    tool: FloatArray,
    context: Context,
    *,
    datum: Datum,
    source: tuple[str, str] = ("the positions", "the error values"),
) -> Prediction:
    """As `predict`; model: with error values; positions: (n_axes, n); tool: (3, n); source: names of both in faults."""
    if model.effect_values:
        if lacking := faults_of_points(model, context, source[0]):
            raise InputError(lacking)
        model = model.in_context(context)
    home = home_of(model) if datum == "home" else None
    deviation = deviations(model, positions, tool, home)
    check_predicted(deviation, prior_size(model, positions, tool), source[1])
    relative: FloatArray | Placements | None = home
    placement = None
    if datum == "best-fit":
        relative = placements(model.ideal(positions, tool))
        deviation, taken = relative.fit(deviation)
        placement = Placement(centre=relative.centre, shift=taken[:3], rotation=taken[3:])
    uncertainty = tool_uncertainty(model, covariance, positions, tool, datum=relative, context=context)
    return Prediction(
        axes=model.axes,
        positions=positions,
        tool=tool,
        deviation=deviation,
        u=uncertainty.u,
        u_prior=uncertainty.u_prior,
        open=uncertainty.open,
        notes=_notes(model, covariance, positions, tool, uncertainty, placement),
        placement=placement,
    )


def with_draws(
    done: Prediction,
    model: MachineModel,
    covariance: Covariance,
    context: Context,
    datum: Datum,
    draws: Draws,
    show: Show = lambda _: None,
) -> Prediction:
    """The prediction with the distribution of its deviations; model: with error values; show: told how far it is."""
    count = done.positions.shape[1]
    points = DrawnPoints(
        positions=done.positions, tool=done.tool, context=context.filled(), covariance=covariance,
        home=home_of(model) if datum == "home" else None,
        placements=placements(model.ideal(done.positions, done.tool)) if datum == "best-fit" else None,
        offset=np.zeros((3, count)), steps=np.zeros((3, 0, count)), draws=draws,
    )  # fmt: skip
    found = drawn(model, points, done.deviation, np.hypot(done.u, 1e-3 * draws.noise_um), show)
    sentences = draw_sentences(found, done.axes, done.positions, with_noise=draws.noise_um > 0.0)
    return replace(done, drawn=found, notes=(*done.notes, *sentences))


def _notes(
    model: MachineModel,
    covariance: Covariance,
    positions: FloatArray,
    tool: FloatArray,
    uncertainty: ToolUncertainty,
    placement: Placement | None,
) -> tuple[str, ...]:
    """What a user must know of these deviations besides their values."""
    count, opened = positions.shape[1], uncertainty.open
    fit, rests = model.errors.fit, (opened > 0.0).any(axis=0)
    found = [] if placement is None else [placement_sentence(placement)]
    found += [misfit_sentence(fit)] if fit is not None and fit.state == "misfit" else []
    found += range_sentences(beyond_measured(model.errors, model.axes, positions), count)
    usual, known = uncertainty.u_usual, ~np.isnan(uncertainty.u)
    if usual is not None and known.any():
        by_both = (float(np.sqrt(np.mean(u[known] ** 2))) for u in (uncertainty.u, usual))
        found.append(usual_sentence(*by_both))
    if rests.any():
        names = open_names(model, covariance, positions[:, rests][:, :MOST_NAMED], tool[:, rests][:, :1])
        found.append(open_sentence(int(rests.sum()), count, float(opened.max()), names))
    return tuple(found)
