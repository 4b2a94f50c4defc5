"""Use of error curves beyond the positions that were measured."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.error_name import ErrorName
from trueaxis.model.bases import TURN
from trueaxis.model.curves import Curve, FloatArray, LegendreCurve, TableCurve
from trueaxis.model.errors import ErrorValues

ROUND = 0.9  # of a turn: targets every 30 deg end 30 deg before it closes
ROUNDING = 1e-6  # mm or deg: positions that agree so far are the same position


@dataclass(frozen=True, slots=True, kw_only=True)
class BeyondMeasured:
    """Positions of an axis beyond what was measured of some of its components.

    low, high: what was measured, mm or deg; lowest, highest: of the positions beyond; count: how many these are;
    by_prior: whether the curves rest on the prior there, whose uncertainty is in that of the values.
    """

    axis: str
    components: tuple[str, ...]
    low: float
    high: float
    lowest: float
    highest: float
    count: int
    by_prior: bool = False


def _measured_round(curve: Curve, low: float, high: float) -> bool:
    """Whether a curve repeats with the turn, and all of one was measured."""
    return isinstance(curve, LegendreCurve) and curve.basis.harmonics > 0 and high - low >= ROUND * TURN


def beyond_measured(errors: ErrorValues, axes: Sequence[str], positions: FloatArray) -> tuple[BeyondMeasured, ...]:
    """Where curves are used beyond their measured range; components of one axis and one range together.

    axes: letters of the rows of positions, (n_axes, n), mm or deg. Curves that do not say what was measured count as
    measured everywhere, and so do those that repeat with a turn that was.
    """
    ranges: dict[tuple[str, float, float, bool], list[str]] = {}
    for name, curve in errors.motion_errors.items():
        if curve.measured is not None and not _measured_round(curve, *curve.measured):
            by_prior = not isinstance(curve, TableCurve) and any(curve.u_prior or ())
            ranges.setdefault((ErrorName(name).axis, *curve.measured, by_prior), []).append(name)
    found = []
    for (axis, low, high, by_prior), names in ranges.items():
        at = positions[list(axes).index(axis)]
        beyond = at[(at < low - ROUNDING) | (at > high + ROUNDING)]
        if beyond.size:
            ends = {"lowest": float(np.min(beyond)), "highest": float(np.max(beyond))}
            found.append(
                BeyondMeasured(
                    axis=axis,
                    components=tuple(names),
                    low=low,
                    high=high,
                    count=beyond.size,
                    by_prior=by_prior,
                    **ends,
                )
            )
    return tuple(found)
