"""Which pass over the targets each row of a table belongs to, where its columns do not say it."""

import numpy as np
import numpy.typing as npt

from trueaxis.measurement.instrument_run import FloatArray

ONE_WAY = "passes that begin where the one before began come from beyond their first target, as a test from one side"
FEWEST_OF_PASS = 3  # rows, to tell a pass that is repeated from targets in no order


def passes_of(targets: FloatArray) -> tuple[npt.NDArray[np.int64], bool]:
    """(n,): the number of the pass that each row belongs to: a new one where the way turns round; and whether some
    begin where the one before began.

    A row at the position of the one before begins the next pass: there the axis went beyond and came back. So does one
    at the first target of a pass of several: a test from one side goes back to where it began, and beyond.
    """
    passes = np.zeros(targets.size, dtype=np.int64)
    way, begin, one_way = 0.0, 0, False
    for row in range(1, targets.size):
        step = float(np.sign(targets[row] - targets[row - 1]))
        turned = step == 0.0 or way not in (0.0, step)
        again = turned and row - begin >= FEWEST_OF_PASS and bool(targets[row] == targets[begin])
        passes[row] = passes[row - 1] + turned
        begin = row if turned else begin
        way = 0.0 if again or (turned and step == 0.0) else step
        one_way |= again and step != 0.0
    return passes, one_way
