"""The saturated base: everything that recalibration could change, so smooth that nothing smooth is left to hunt for.

Every component error is a polynomial of degree 12 of its axis, every location error is free, every run of a laser or
probe has an offset, every straightness run a slope, every ball a centre. With parsimonious polynomials structure of a
tenth of a micrometre that nobody asks for would count as a discovery.
"""

from dataclasses import dataclass

import numpy as np

from trueaxis.diagnose.result import FloatArray
from trueaxis.diagnose.rows import Rows
from trueaxis.estimation.jacobian import RunRows, pieces
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.set_up import ball_columns
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import MachineModel

DEGREE = 12
SLOPE = 2  # its place among the own unknowns of a straightness run
RANK = 1e-9  # singular values below it, of columns of length 1, count as zero


@dataclass(frozen=True, slots=True, eq=False)
class Base:
    """columns: (n, p), mm per scaled unknown, not whitened: those of the machine, then slopes of straightness runs,
    offsets and centres; of_machine: how many are the machine's; first_offset: where offsets begin.
    """

    columns: FloatArray
    of_machine: int
    first_offset: int

    @property
    def of_instruments(self) -> slice:
        """Columns of the instruments alone: what readings of an error-free machine would have, too."""
        return slice(self.of_machine, self.columns.shape[1])


def base_of(model: MachineModel, rows: Rows, degree: int = DEGREE) -> Base:
    """The base of some rows; dimensions keep the values that the model has."""
    dimensions = {name: model.errors.parameters.get(name, 0.0) for name in model.dimensions}
    known = ErrorValues(model.name, dimensions)
    bare = model.with_values(known)
    layout = layout_of(bare, Observations("", rows.runs, rows.run, rows.positions, rows.reading), known, degree=degree)
    machine = np.zeros((rows.size, layout.of_machine))
    slopes, offsets = [], []
    for index in rows.present:
        part = rows.of_run(index)
        count = part.stop - part.start
        one = RunRows(
            index=index,
            run=rows.runs[index],
            at=np.arange(part.start, part.stop),
            positions=np.ascontiguousarray(rows.positions[:, part]),
            passed=np.zeros(count),
            steps=np.zeros(count),
        )
        both = [(own, others[:, : layout.of_machine]) for _, own, others in pieces(layout, one)]
        machine[part] = np.vstack([others for _, others in both])
        own = np.vstack([own for own, _ in both])
        if layout.straightness[index]:
            slopes.append(_in_rows(rows, part, own[:, SLOPE]))
        if rows.runs[index].instrument != "ballbar":
            offsets.append(_in_rows(rows, part, np.ones(count)))
    columns = [machine, *slopes, *offsets, _centres(bare, rows)]
    return Base(np.hstack(columns), layout.of_machine, layout.of_machine + len(slopes))


def _in_rows(rows: Rows, part: slice, values: FloatArray) -> FloatArray:
    """(n, 1): a column that is zero in all other runs."""
    found = np.zeros((rows.size, 1))
    found[part, 0] = values
    return found


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
