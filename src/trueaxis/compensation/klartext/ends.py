"""Where a block of Heidenhain Klartext leads."""

from collections.abc import Mapping

from trueaxis.compensation.arcs import ArcError
from trueaxis.compensation.klartext.arcs import polar_end
from trueaxis.compensation.klartext.blocks import KlartextBlock
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.nc.state import Commanded, NcState

POLAR = frozenset({"LP", "CP"})


def ends_of(
    number: int, block: KlartextBlock, pole: Mapping[str, float], state: NcState, faults: FaultLog
) -> tuple[list[float | None], set[str]]:
    """Positions after a block, mm and deg, and the axes that it names; pole: X and Y, mm, machine coordinates.

    Raises ArcError when they count from where axes stand that is not certain.
    """
    end, named = state.position.copy(), set()
    if block.verb in POLAR:
        for axis, value in polar_end(block, pole, state).items():
            end[state.row[axis]] = value
            named.add(axis)
    for axis, word in block.coordinates.items():
        if axis in ("PR", "PA"):
            continue
        if axis not in state.row:
            faults.add(number, f"{axis}: this machine has no axis {axis}", f"its axes are {' '.join(state.axes)}")
            continue
        row, value, before = state.row[axis], word.value * state.scale(axis), state.position[state.row[axis]]
        if word.incremental:
            if before is None or state.commanded.of([row]) < Commanded.ABSOLUTE:
                raise ArcError(f"I{axis} counts from where {axis} stands, which is not certain here")
            end[row] = before + value
        else:
            end[row] = value + (state.shift[row] if state.shift else 0.0)
        named.add(axis)
    return end, named
