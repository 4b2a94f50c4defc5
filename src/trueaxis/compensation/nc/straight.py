"""A straight motion that a cycle makes where the program has no block of its own for it."""

from collections.abc import Mapping, Sequence

from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.moves import Kind, Move
from trueaxis.compensation.nc.state import NcState, missing_axes, starts_elsewhere, unknown_position


def straight_to(
    number: int, kind: Kind, ends: Mapping[str, float], state: NcState, assumed: Sequence[float], faults: FaultLog
) -> Move | tuple[str, str]:
    """The motion of some axes to machine positions, mm, its text still empty, taken into the state; or what is wrong
    with it, and the remedy. assumed: where each axis is taken to stand whose position is not known.
    """
    end = list(state.position)
    for axis, value in ends.items():
        end[state.row[axis]] = value
    written = tuple(axis in ends for axis in state.axes)
    state.motion = int(kind)
    missing = missing_axes(state, state.position, end, set(ends)) if kind != Kind.RAPID else []
    elsewhere = not missing and starts_elsewhere(number, state, written, "", faults)
    problem = unknown_position(state, missing) if missing else None
    state.motion = None
    if problem:
        return problem
    state.position, state.moved = end, True
    known = tuple(assumed[row] if value is None else value for row, value in enumerate(end))
    return Move(
        number, kind, known, written, state.absolute, state.inch, "", "", "", "", "", passable=False,
        held=state.commanded.command(written, state.absolute), elsewhere=state.commanded.elsewhere,
        unnamed=state.commanded.unnamed, shift=state.shift, start_stated=elsewhere,
    )  # fmt: skip
