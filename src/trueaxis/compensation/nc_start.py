"""Whether a block starts where the program has commanded its axes to."""

from collections.abc import Sequence
from collections.abc import Set as AbstractSet

from trueaxis.compensation.commanded import Commanded
from trueaxis.compensation.fault_log import FaultLog
from trueaxis.compensation.nc_state import NcState


def starts_elsewhere(number: int, state: NcState, moved: Sequence[bool], otherwise: str, faults: FaultLog) -> bool:
    """Whether a block starts where the program has not commanded its axes to; faults where its way depends on that.

    moved: for each axis whether the block moves it. otherwise: what else would be right after a tool change.
    """
    arc = state.motion in (2, 3)
    known = state.commanded.of(row for row, moves in enumerate(moved) if moves)
    if known <= Commanded.DISPLACED and (arc or not state.absolute):
        faults.add(
            number,
            "this motion counts from where the axes stand, and the tool change before it may have moved them",
            ", ".join(filter(None, ("give their positions by G90 G0 first", otherwise))),
        )
    elif arc and state.absolute and known < Commanded.STOPPED:
        faults.add(
            number,
            "an arc that starts where the program has not commanded the axes to",
            "give the position by G90 G0 or G1 in the program first",
        )
    return known < (Commanded.STOPPED if state.absolute else Commanded.STATED)


def missing_axes(
    state: NcState, start: Sequence[float | None], end: Sequence[float | None], moved: AbstractSet[str]
) -> list[int]:
    """Axes without a position on which a motion depends; start, end: of all axes; moved: those that it moves.

    A rapid depends on the axes that it moves, a feed motion on those too that the program has moved before. Linear axes
    that it has not moved so far stand where they are taken to stand, and get no word. Under tool centre point control
    every axis counts.
    """
    unnamed, found = state.commanded.unnamed, []
    for row, axis in enumerate(state.axes):
        needed = (start[row], end[row]) if state.motion in (2, 3) else (end[row],)
        waits = bool(unnamed) and unnamed[row] and not state.point_control
        if None in needed and (axis in moved or (state.motion and not waits)):
            found.append(row)
    return found


def unknown_position(names: str) -> tuple[str, str]:
    """The fault of a feed motion while axes (letters, parted by spaces) may stand anywhere, and what would be right."""
    given = "".join(f"{axis}0" for axis in names.split())
    return (
        f"the position of {names} is not known here, and the errors depend on it",
        f"give it in the program or by --start {given} (with its value)",
    )
