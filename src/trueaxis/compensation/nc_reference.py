"""Motions to reference points: G28 and G30."""

import math

from trueaxis.compensation import nc_codes as codes
from trueaxis.compensation.commanded import Commanded
from trueaxis.compensation.fault_log import FaultLog
from trueaxis.compensation.moves import Notes, Start
from trueaxis.compensation.nc_meaning import Meaning
from trueaxis.compensation.nc_state import NcState
from trueaxis.compensation.settings import Settings

AS_IT_IS = (
    "is left as it is: the point that it passes is not compensated, and each axis gets words again only once the "
    "program has commanded it"
)
BLANK = ", and it defines the blank (Heidenhain)"
NO_POINT = "where it leads is not known; the table [reference_points] of the spec can say"
_FIRST_OF_G30 = 2.0  # P of the second reference point, which G30 without P means too


def to_reference(
    number: int, meaning: Meaning, state: NcState, settings: Settings, faults: FaultLog, notes: Notes
) -> list[Start]:
    """Take in a motion to a reference point, whose text stays; returns where the axes then stand."""
    name = f"G{(meaning.data_code or 0) // 10}"
    axes = [axis for axis in state.axes if axis in meaning.data]
    if not axes and settings.dialect == "linuxcnc":
        axes = list(state.axes)
    if not axes:
        blank = BLANK if meaning.data_code == codes.TO_SECOND_REFERENCE else ""
        faults.add(
            number, f"{name} without axis words: which axes move differs by control{blank}", f"{name} Z0 under G91"
        )
        return []
    other = (
        meaning.data_code == codes.TO_SECOND_REFERENCE and meaning.parameters.get("P", _FIRST_OF_G30) != _FIRST_OF_G30
    )
    point = {} if other else settings.reference_points.get(name, {})
    lost = [state.row[axis] for axis in axes if axis not in point]
    notes.add(number, f"{name} {AS_IT_IS}")
    if lost:
        notes.add(number, f"{name} {' '.join(state.axes[row] for row in lost)}: {NO_POINT}")
    stands: list[float | None] = [None] * len(state.axes)
    position = state.position.copy()
    for axis in axes:
        row = state.row[axis]
        position[row] = point.get(axis)
        stands[row] = point.get(axis, math.nan)
    state.position = position
    state.commanded.lose(lost)
    state.commanded.name([state.row[axis] for axis in axes if axis in point], Commanded.BY_INCREMENTS)
    return [Start(tuple(stands))]
