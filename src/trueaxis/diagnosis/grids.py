"""Where a diagnosis searches the parameters that a term is not linear in: the grids of `estimation.effects.grids`."""

from collections.abc import Mapping

import numpy as np

from trueaxis.diagnosis.rows import Rows
from trueaxis.effects.kind import Effect, Kind
from trueaxis.estimation.effects.grids import OF_DIAGNOSIS, Fineness, covered_by, moments
from trueaxis.estimation.effects.grids import grid_of as grid_of_covered


def grid_of(
    kind: Kind, effect: Effect, rows: Rows, fineness: Fineness = OF_DIAGNOSIS
) -> tuple[Mapping[str, float], ...]:
    """The points of the grid: values of the parameters with the role `grid`; one empty point where there is none.

    NaN is the moment of a jump where a run is too short for one, or where its times are not known: no search then.
    """
    if not any(one.role == "grid" for one in kind.parameters):
        return ({},)
    if not effect.runs:
        return grid_of_covered(kind, covered_by(effect, rows.axes, rows.positions, rows.context), fineness)
    mine = np.isin(rows.run, [index for index, run in enumerate(rows.runs) if run.id in effect.runs])
    covered = covered_by(effect, rows.axes, rows.positions[:, mine], rows.context.of(mine))
    points = grid_of_covered(kind, covered, fineness)
    found = moments(covered.time[np.isfinite(covered.time)], fineness)
    jumps = {one.name for one in kind.parameters if one.grid == "moment"}
    if found or not jumps:
        return points
    return tuple({name: np.nan if name in jumps else value for name, value in point.items()} for point in points)
