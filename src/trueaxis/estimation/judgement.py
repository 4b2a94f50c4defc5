"""What of an estimate is told by the readings, and what rests on the prior."""

from dataclasses import dataclass

import numpy as np

from trueaxis.error_name import ErrorName
from trueaxis.estimation.result import Estimate
from trueaxis.measurement.columns import BoolArray
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.errors import Determined

SAMPLES = 33  # positions of a travel at which a curve is judged, at least
TENTH, NINE_TENTHS = 0.1, 0.9  # of the prior: below the one the prior hardly matters, above the other nothing else does


@dataclass(frozen=True, slots=True, kw_only=True)
class Judged:
    """A curve over the travel, or one value, mm or rad.

    largest: largest absolute value, at position `at`, mm or deg (None: one value), u_there: its standard uncertainty;
    u: the largest one; both NaN where open combinations take part in the value. Root mean squares over the travel:
    u_rms of u, u_readings_rms and u_prior_rms of its two parts, by the noise of the readings and by the prior,
    prior_rms of what the prior lets expect; determined: by what, see `determined_by`, which goes by these.
    """

    largest: float
    at: float | None
    u_there: float
    u: float
    u_rms: float
    u_readings_rms: float
    u_prior_rms: float
    prior_rms: float
    determined: Determined


def judged_component(found: Estimate, component: ErrorName) -> Judged:
    """Of a component that was estimated."""
    layout = found.layout
    place = layout.components.index(component)
    basis = layout.bases[place]
    first = int(layout.offsets[place])
    rows = slice(first, first + basis.count)
    positions = basis.evenly(SAMPLES)
    change = np.zeros((positions.size, layout.count))
    change[:, rows] = basis(positions).T
    return _judged(found, change, positions)


def judged_location(found: Estimate, name: str) -> Judged:
    """Of a location error that was estimated."""
    change = np.zeros((1, found.layout.count))
    change[0, int(found.layout.offsets[-1]) + found.layout.locations.index(name)] = 1.0
    return _judged(found, change)


def _judged(found: Estimate, change: FloatArray, positions: FloatArray | None = None) -> Judged:
    """change: (m, n), the values to judge by the unknowns, at positions (m,); None: one value."""
    values = np.abs(change @ found.unknowns)
    spread = change @ found.spread
    readings, by_prior = np.split(spread, [spread.shape[1] - found.of_prior], axis=1)
    u, u_readings, u_prior = (np.linalg.norm(part, axis=1) for part in (spread, readings, by_prior))
    prior = np.linalg.norm(change * found.scale, axis=1)
    rms = [float(np.sqrt(np.mean(one**2))) for one in (u, u_readings, u_prior, prior)]
    at = int(np.argmax(values))
    opened = np.linalg.norm(change @ found.open, axis=1)
    hidden = bool(open_counts(opened, u).any())
    return Judged(
        largest=float(values[at]),
        at=None if positions is None else float(positions[at]),
        u_there=np.nan if hidden else float(u[at]),
        u=np.nan if hidden else float(u.max()),
        u_rms=rms[0],
        u_readings_rms=rms[1],
        u_prior_rms=rms[2],
        prior_rms=rms[3],
        determined=_left_open(float(np.sqrt(np.mean(opened**2))), rms[-1]) if hidden else determined_by(*rms),
    )


def open_counts(opened: FloatArray, u: FloatArray) -> BoolArray:
    """Whether u, which holds nothing of open combinations, is too small; opened: what they let the value be.

    Below a tenth of u they would add less than half a percent to it.
    """
    return np.asarray(opened > TENTH * u)


def _left_open(opened: float, prior: float) -> Determined:
    """By what a value is determined that open combinations let be so large."""
    return "prior" if opened > NINE_TENTHS * prior else "partly"


def determined_by(u: float, u_readings: float, u_prior: float, prior: float) -> Determined:
    """By what a value is determined; prior: its prior standard deviation, of the unit of the others."""
    if u_prior < u_readings or u_prior < TENTH * prior:
        return "data"
    return "prior" if u > NINE_TENTHS * prior else "partly"
