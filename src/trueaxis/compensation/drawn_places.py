"""The places of a compensated program as points of draws: what compensation leaves of the error of the tool there."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.compensation.course import Placed
from trueaxis.compensation.machine import FloatArray, linear_jacobian
from trueaxis.compensation.reliance import Visited
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.solve import solve
from trueaxis.model.context import Context
from trueaxis.model.covariance import Covariance
from trueaxis.model.extent import after_reversals
from trueaxis.model.model import MachineModel
from trueaxis.model.uncertainty import home_of, tool_uncertainty
from trueaxis.monte_carlo.points import DrawnPoints
from trueaxis.monte_carlo.settings import Draws


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
        positions=commanded, tool=tool, context=context, covariance=covariance, home=home, placements=None, offset=left,
        steps=steps, draws=draws,
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
    commanded = solve(positions, positions, placed, tool, settings.tolerance).commands
    return commanded, placed.ideal(commanded, tool) - placed.ideal(positions, tool)


def _at(context: Context, settings: Settings) -> Context:
    """At the time and the temperature that the program is compensated for, where they are given."""
    if settings.time is not None:
        context = replace(context, time=np.full(context.count, settings.time))
    if settings.temperature is not None:
        context = replace(context, temperature=np.full(context.count, settings.temperature))
    return context
