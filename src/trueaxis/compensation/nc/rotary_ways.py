"""Ways on which rotary axes turn to a position: DC, ACP and ACN of SINUMERIK, M126 of Heidenhain.

The place is the same on every way. The motion is followed where it runs through the positions from start to end; where
it passes the zero of the axis instead, only a rapid is, of which nothing but the end counts.
"""

import math
from collections.abc import Collection, Mapping, Sequence

from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import ROTARY
from trueaxis.compensation.moves import Start
from trueaxis.compensation.nc.state import NcState

SHORTER, POSITIVE, NEGATIVE = "DC", "ACP", "ACN"
WAYS = frozenset({SHORTER, POSITIVE, NEGATIVE})
TURN = 360.0
_HALF_TURN = 179.9  # deg: nearer to half a turn the rounding of words could make the other way the shorter one
SHORTER_ON, SHORTER_OFF = 126, 127


def problems_of(axis: str, way: str, value: float) -> tuple[str, str] | None:
    """What is wrong with a word of SINUMERIK such as C=DC(10), and what would be right."""
    if axis not in ROTARY:
        return f"{axis}={way}(..): {axis} is no rotary axis", f"{axis}=AC(..)"
    if not 0.0 <= value < TURN:
        return f"{axis}={way}({value:g}): it takes 0 to below 360", "the same position in that range"
    return None


def take_codes(number: int, codes: Collection[int], moves: bool, state: NcState, faults: FaultLog) -> None:
    """Take in M126 and M127 of a Heidenhain block; moves: whether it gives positions."""
    if SHORTER_ON in codes:
        state.shorter_way = True
    if SHORTER_OFF in codes:
        if moves and state.shorter_way:
            faults.add(number, "M127 beside positions: whether it acts before them is not known", "a block of its own")
        state.shorter_way = False


def goes_round(turn: float, way: str) -> bool:
    """Whether an axis that goes this way may do else than run through the positions from start to end; turn: end minus
    start, deg.
    """
    return {SHORTER: abs(turn) > _HALF_TURN, POSITIVE: turn < 0.0, NEGATIVE: turn > 0.0}[way]


def turned_round(
    number: int, start: Sequence[float | None], state: NcState, said: Mapping[str, str], faults: FaultLog
) -> list[Start]:
    """Faults of a block that began at start, and has its end in state; and that nobody knows from where axes turned
    that passed their zero. said: ways of axes by letter.
    """
    if said and not state.absolute:
        faults.add(number, f"{' '.join(said.values())} under G91", "G90")
    ways = said or dict.fromkeys((axis for axis in state.axes if axis in ROTARY and state.shorter_way), SHORTER)
    names = {axis: f"{axis}={way}(..)" for axis, way in said.items()}
    round_ = []
    for axis, way in ways.items():
        row = state.row.get(axis)
        begin, end = (None, None) if row is None else (start[row], state.position[row])
        if begin is None or end is None or not goes_round(end - begin, way):
            continue
        round_.append(row)
        if state.motion or state.point_control:
            faults.add(
                number,
                f"{names.get(axis, f'M{SHORTER_ON}')}: {axis} may pass its zero on the way from {begin:g} to {end:g}, "
                "and errors along that way are not followed",
                "a rapid, without tool centre point control; or positions that do not pass it",
            )
    if not round_:
        return []
    return [Start(tuple(math.nan if row in round_ else None for row in range(len(state.axes))))]
