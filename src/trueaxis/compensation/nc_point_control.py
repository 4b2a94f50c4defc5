"""Switching tool centre point control on and off in a program that is read."""

import math

from trueaxis.compensation.fault_log import FaultLog
from trueaxis.compensation.machine import LINEAR
from trueaxis.compensation.moves import Item, Notes, Start
from trueaxis.compensation.nc_state import NcState
from trueaxis.compensation.settings import Settings

NOTE = (
    "tool centre point control: X Y Z are those of the tip, in the workpiece frame that turns with the table, and the "
    "control's kinematics are taken to be the ideal ones of the spec"
)


def switch(
    number: int, wanted: bool | None, state: NcState, settings: Settings, faults: FaultLog, notes: Notes
) -> list[Item]:
    """Take in what a block says of point control; None: nothing. Returns what is not known any more.

    Positions before and after name the same place only where all rotary axes stand at 0.
    """
    if wanted is None or wanted == state.point_control:
        return []
    rotary = [row for row, axis in enumerate(state.axes) if axis not in LINEAR]
    if not rotary:
        faults.add(number, "tool centre point control, but this machine has no rotary axis")
    if settings.orientation == "correct":
        faults.add(
            number, "tool centre point control with --orientation correct is not followed", "say --orientation keep"
        )
    state.point_control = wanted
    notes.add(number, NOTE)
    if all(state.position[row] == 0.0 for row in rotary):
        return []
    linear = [row for row, axis in enumerate(state.axes) if axis in LINEAR]
    for row in linear:
        state.position[row] = None
    state.commanded.lose(linear)
    return [Start(tuple(math.nan if row in linear else None for row in range(len(state.axes))))]
