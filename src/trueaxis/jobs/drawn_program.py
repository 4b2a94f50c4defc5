"""What compensation leaves of the error of the tool along a program, by draws."""

from collections.abc import Sequence
from dataclasses import dataclass

import polars as pl

from trueaxis.compensation.drawn_places import drawn_places
from trueaxis.compensation.reliance import Judge, Reliance, Visited
from trueaxis.compensation.settings import Settings
from trueaxis.jobs.draws import MOST_POINTS, Show, drawn
from trueaxis.jobs.tables import Tabular
from trueaxis.measurement.points import TOOL_COLUMNS
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import FloatArray
from trueaxis.model.model import MachineModel
from trueaxis.monte_carlo.drawn import Drawn, drawn_columns
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
