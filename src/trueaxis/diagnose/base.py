"""The saturated base: everything that recalibration could change, so smooth that nothing smooth is left to hunt for.

Every component error is a polynomial of degree 12 of its axis, every location error is free, every run of a laser or
probe has an offset, every straightness run a slope, every ball a centre. With parsimonious polynomials structure of a
tenth of a micrometre that nobody asks for would count as a discovery.
"""

from dataclasses import dataclass

import numpy as np

from trueaxis.diagnose.result import FloatArray
from trueaxis.diagnose.rows import Rows
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.set_up import ball_columns
from trueaxis.identify.global_fit.design import Design
from trueaxis.identify.global_fit.instruments import instruments
from trueaxis.identify.global_fit.layout import Layout, layout
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import MachineModel

DEGREE = 12
RANK = 1e-9  # singular values below it, of columns of length 1, count as zero


@dataclass(frozen=True, slots=True, eq=False)
class Base:
    """columns: (n, p), mm per scaled unknown, not whitened; plan: of those before offsets and centres."""

    plan: Layout
    columns: FloatArray

    @property
    def of_instruments(self) -> slice:
        """Columns of the instruments alone: what readings of an error-free machine would have, too."""
        return slice(self.plan.of_machine, self.columns.shape[1])


def base_of(model: MachineModel, rows: Rows, degree: int = DEGREE) -> Base:
    """The base of some rows; dimensions keep the values that the model has."""
    dimensions = {name: model.errors.parameters.get(name, 0.0) for name in model.dimensions}
    known = ErrorValues(model.name, dimensions)
    bare = model.with_values(known)
    observed = Observations("", rows.runs, rows.run, rows.positions, rows.reading)
    plan = layout(bare, observed, known, degree, instruments(bare, observed, ("slope",)))
    columns = np.zeros((rows.size, plan.count))
    for at, piece in Design(plan, observed).pieces():
        columns[at] = piece
    zeroed = [index for index in rows.present if rows.runs[index].instrument != "ballbar"]
    offsets = np.zeros((rows.size, len(zeroed)))
    for place, index in enumerate(zeroed):
        offsets[rows.of_run(index), place] = 1.0
    return Base(plan, np.hstack([columns, offsets, _centres(bare, rows)]))


def _centres(model: MachineModel, rows: Rows) -> FloatArray:
    """The place of the workpiece ball, anew for each plane: three columns for each set-up of a ball bar."""
    found = []
    for number in np.unique(rows.setup):
        mine = np.flatnonzero(rows.setup == number)
        if rows.runs[rows.run[mine[0]]].instrument != "ballbar":
            continue
        columns = np.zeros((rows.size, 3))
        for index in np.unique(rows.run[mine]):
            part = rows.of_run(int(index))
            positions = np.ascontiguousarray(rows.positions[:, part])
            columns[part] = ball_columns(model, rows.runs[int(index)], positions)
        found.append(columns)
    return np.hstack(found) if found else np.zeros((rows.size, 0))
