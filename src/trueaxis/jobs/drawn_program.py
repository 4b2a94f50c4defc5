"""What compensation leaves of the error of the tool along a program, by draws."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import polars as pl

from trueaxis.compensation.course import Placed
from trueaxis.compensation.machine import FloatArray, linear_jacobian
from trueaxis.compensation.reliance import Judge, Reliance
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.solve import solve
from trueaxis.compensation.visited import Visited
from trueaxis.jobs.draws import MOST_POINTS, Show, drawn
from trueaxis.jobs.tables import Tabular
from trueaxis.measurement.points import TOOL_COLUMNS
from trueaxis.model.context import Context
from trueaxis.model.covariance import Covariance
from trueaxis.model.extent import after_reversals
from trueaxis.model.model import MachineModel, home_of
from trueaxis.model.uncertainty import tool_uncertainty
from trueaxis.monte_carlo.drawn import Drawn, drawn_columns
from trueaxis.monte_carlo.points import DrawnPoints
from trueaxis.monte_carlo.settings import Draws


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class DrawnProgram(Tabular):
    """The error of the tool from home that is left at places of a compensated program. axes: letters, the rows of
    positions; positions: (n_axes, n), programmed, mm or deg; tool: (3, n), the point in the tool frame, mm; u: (3, n),
    mm, by linear propagation, NaN where unknown; drawn: the distribution; places: of the program, of which these are
    spread evenly.
    """

    axes: tuple[str, ...]
    positions: FloatArray
    tool: FloatArray
    u: FloatArray
    drawn: Drawn
    places: int

    def to_polars(self) -> pl.DataFrame:
        """A row for each place, mm and deg."""
        rows = [(self.axes, self.positions), (TOOL_COLUMNS, self.tool), (("u_dx", "u_dy", "u_dz"), self.u)]
        rows += drawn_columns(self.drawn)
        columns = {name: row for names, values in rows for name, row in zip(names, values, strict=True)}
        return pl.DataFrame(columns).fill_nan(None)


class Remembering:
    """A judge that remembers the places of the program that it judged."""

    def __init__(self, judge: Judge) -> None:
        self._judge = judge
        self.visited: tuple[Visited, ...] = ()

    def __call__(self, visited: Sequence[Visited]) -> Reliance:
        """See `Judge`."""
        self.visited = tuple(one for one in visited if one.positions.size)
        return self._judge(visited)


def drawn_program(
    model: MachineModel,
    covariance: Covariance,
    visited: Sequence[Visited],
    settings: Settings,
    draws: Draws,
    show: Show = lambda _: None,
) -> DrawnProgram | None:
    """Draw what is left; None where the program has no places. model: with error values; show: told how far it is."""
    if not visited:
        return None
    places = drawn_places(model, covariance, visited, settings, draws, MOST_POINTS)
    found = drawn(model, places.points, places.value, places.u, show)
    return DrawnProgram(
        axes=model.axes, positions=places.programmed, tool=places.points.tool, u=places.u, drawn=found,
        places=places.of,
    )  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class DrawnPlaces:
    """points: commanded as the compensation has it; programmed: (n_axes, n), mm or deg; value, u: (3, n), mm, what is
    left of the error from home by the error values, and its standard uncertainty by linear propagation, words and noise
    included; of: how many places there are, of which these are spread evenly.
    """

    points: DrawnPoints
    programmed: FloatArray
    value: FloatArray
    u: FloatArray
    of: int


def drawn_places(
    model: MachineModel,
    covariance: Covariance,
    visited: Sequence[Visited],
    settings: Settings,
    draws: Draws,
    most: int,
) -> DrawnPlaces:
    """Of the places that a program came to, `most` at most. model: with error values.

    Axes have just turned back there, as where the uncertainty of a program is judged. Words are rounded to the
    resolution of mm.
    """
    positions = np.hstack([one.positions for one in visited])
    tool = np.hstack([np.repeat(one.tool_point, one.positions.shape[1], axis=1) for one in visited])
    places = positions.shape[1]
    kept = np.unique(np.linspace(0, places - 1, min(places, most)).astype(np.int64)) if places else np.arange(0)
    positions, tool = np.ascontiguousarray(positions[:, kept]), np.ascontiguousarray(tool[:, kept])
    context = _at(after_reversals(model, positions), settings)
    home = home_of(model)
    commanded, offset = _compensated(Placed.of_context(model, context), positions, tool, settings)
    homes = np.repeat(home, kept.size, axis=1)
    at_home = Placed.of_context(model, _at(after_reversals(model, homes), settings))
    _, offset_of_home = _compensated(at_home, homes, tool, settings)
    steps = settings.resolution * linear_jacobian(model, commanded, tool)
    left = offset - offset_of_home
    points = DrawnPoints(
        positions=commanded, tool=tool, context=context, covariance=covariance, home=home, placements=None,
        offset=left, steps=steps, draws=draws,
    )  # fmt: skip
    u = tool_uncertainty(model, covariance, commanded, tool, datum=home, context=context).u
    words = (steps**2).sum(axis=1) / 12.0  # variance of what is alike from -1/2 to 1/2
    value = left + model.in_context(context).deviation(commanded, tool) - model.deviation(homes, tool)
    whole = np.sqrt(u**2 + words + (1e-3 * draws.noise_um) ** 2)
    return DrawnPlaces(points=points, programmed=positions, value=value, u=whole, of=places)


def _compensated(
    placed: Placed, positions: FloatArray, tool: FloatArray, settings: Settings
) -> tuple[FloatArray, FloatArray]:
    """Commands, (n_axes, n), and by how much an error-free machine misses the programmed point with them, (3, n)."""
    commanded = solve(positions, positions, placed, tool, settings.aim).commands
    return commanded, placed.ideal(commanded, tool) - placed.ideal(positions, tool)


def _at(context: Context, settings: Settings) -> Context:
    """At the time and the temperature that the program is compensated for, where they are given."""
    if settings.time is not None:
        context = replace(context, time=np.full(context.count, settings.time))
    if settings.temperature is not None:
        context = replace(context, temperature=np.full(context.count, settings.temperature))
    return context
