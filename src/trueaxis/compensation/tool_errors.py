"""Where positions put the tool instead of where it is wanted."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import columns_of
from trueaxis.compensation.elsewhere import taken_back
from trueaxis.compensation.machine import ErrorModel, FloatArray
from trueaxis.compensation.path import Held
from trueaxis.compensation.solve import ToolAxis, angle


class ToolErrors(NamedTuple):
    """Of n positions. target: (3, n), the tool points wanted; vectors: (3, n), the actual ones minus these, mm; turned:
    (n,), the orientation errors, rad, None without rotary axes.
    """

    target: FloatArray
    vectors: FloatArray
    turned: FloatArray | None

    def some(self, of: NDArray[np.int64] | slice) -> "ToolErrors":
        """Of some of them."""
        turned = None if self.turned is None else self.turned[of]
        return ToolErrors(columns_of(self.target, of), columns_of(self.vectors, of), turned)


class Known(NamedTuple):
    """What is known of positions beforehand. free: (n_axes, n), linear axes of which nothing says where they are to be.
    target, error: (3, n), mm, the tool points wanted, and the actual ones minus these.
    """

    free: Held | None = None
    target: FloatArray | None = None
    error: FloatArray | None = None


NOTHING_KNOWN = Known()


def tool_errors(
    model: ErrorModel,
    axis: ToolAxis,
    tool_point: FloatArray,
    positions: FloatArray,
    wanted: FloatArray,
    known: Known = NOTHING_KNOWN,
) -> ToolErrors:
    """Errors at positions (n_axes, n) where the error-free machine is to be at `wanted`; tool_point: (3, 1), mm.

    What the motion of free axes would take back of the error is left out.
    """
    target = model.ideal(wanted, tool_point) if known.target is None else known.target
    error = known.error
    if error is None:
        ideal = target if positions is wanted else model.ideal(positions, tool_point)
        error = ideal + model.deviation(positions, tool_point) - target
    if known.free is not None and known.free.any():
        error = error + taken_back(model, positions, error, known.free, tool_point)
    turned = angle(axis.on(model).actual(positions), axis.wanted(wanted)) if axis.turns else None
    return ToolErrors(target, error, turned)


class CuttingPoses:
    """Tells, batch by batch, at which points an error of the tool axis matters: at a singular pose between rapids
    nothing is cut.
    """

    def __init__(self) -> None:
        self._waits: int | None = None  # the line of a rapid to a singular pose, before it is known what follows

    def lines(self, lines: NDArray[np.int64], over: Held, singular: Held, rapid: Held) -> NDArray[np.int64]:
        """Lines of the points with too large an error, `over`, that matter; a feed motion that begins at a pose cuts
        there, too. All (n,).
        """
        between, begins_cut = singular & rapid, ~np.append(rapid[1:], True)
        if self._waits is not None and not rapid[0]:
            lines, over = np.append(self._waits, lines), np.append(True, over)
            between, begins_cut = np.append(False, between), np.append(True, begins_cut)
        self._waits = int(lines[-1]) if over[-1] and between[-1] else None
        return np.asarray(lines[over & (begins_cut | ~between)])
