"""Where the tool point really is, and how well that is known."""

from dataclasses import dataclass
from typing import Literal

import numpy.typing as npt
import polars as pl

from trueaxis.io.faults import InputError
from trueaxis.jobs.arrays import ORIGIN, Positions, check_among, positions_of, tool_points
from trueaxis.jobs.load import Errors
from trueaxis.jobs.tables import Tabular
from trueaxis.measurement.context_needs import faults_of_points
from trueaxis.measurement.points import DEVIATION_COLUMNS, PRIOR_COLUMNS, TOOL_COLUMNS, UNCERTAINTY_COLUMNS
from trueaxis.measurement.predict import check_predicted, deviations
from trueaxis.model.best_fit import Placement, Placements, placements
from trueaxis.model.context import Context
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import FloatArray
from trueaxis.model.model import MachineModel
from trueaxis.model.uncertainty import home_of, prior_size, tool_uncertainty

Datum = Literal["machine", "home", "best-fit"]


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Prediction(Tabular):
    """Deviations of tool points, in the workpiece frame.

    axes: letters, the rows of positions; positions: (n_axes, n), mm or deg; tool: (3, n), mm; deviation: (3, n), actual
    minus ideal, mm; u: (3, n), its standard uncertainty, u_prior the part of that which rests on [prior], mm, NaN where
    unknown; open: (3, n), by how much what no reading determines could move the point, mm; placement: with datum
    "best-fit".
    """

    axes: tuple[str, ...]
    positions: FloatArray
    tool: FloatArray
    deviation: FloatArray
    u: FloatArray
    u_prior: FloatArray
    open: FloatArray
    placement: Placement | None = None

    def to_polars(self) -> pl.DataFrame:
        """A row for each point, columns as in the table that `trueaxis predict` writes."""
        rows = [
            (self.axes, self.positions),
            (TOOL_COLUMNS, self.tool),
            (DEVIATION_COLUMNS, self.deviation),
            (UNCERTAINTY_COLUMNS, self.u),
            (PRIOR_COLUMNS, self.u_prior),
        ]
        columns = {name: row for names, values in rows for name, row in zip(names, values, strict=True)}
        return pl.DataFrame(columns).fill_nan(None)


def predict(
    model: MachineModel,
    errors: Errors,
    positions: Positions,
    *,
    tool: npt.ArrayLike = ORIGIN,
    datum: Datum = "machine",
    context: Context | None = None,
) -> Prediction:
    """The deviation of the tool point at axis positions, on the exact model (Eq. 4 of the paper), with uncertainty.

    positions: by axis letter, numbers or (n,) each, or (n_axes, n), mm or deg; tool: (3,) or (3, n), the point in the
    tool frame, mm. datum: what deviations and their uncertainties are relative to: the error-free machine; the tool
    point at home; the rigid placement of the workpiece that fits the points best. context: approach directions, times
    and temperatures, for machines with effects. Raises ValueError where an array has another shape, InputError where
    the deviation is none that a machine has or an effect lacks what it depends on.
    """
    check_among(datum=(datum, Datum))
    at = positions_of(model, positions)
    there = tool_points(tool, at.shape[1])
    whole = Context.at_rest(len(model.axes), at.shape[1]) if context is None else context
    return predicted(model.with_values(errors.values), errors.covariance, at, there, whole, datum=datum)


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
        placement=placement,
    )
