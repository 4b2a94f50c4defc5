"""Most blocks: N, G0 or G1, X Y Z and F, in this order, read at once."""

import re

from trueaxis.compensation.moves import Kind, Move
from trueaxis.compensation.nc_lexer import LARGEST, NUMBER
from trueaxis.compensation.nc_state import NcState
from trueaxis.compensation.settings import MM_PER_INCH

# the groups are lead, G, X, Y, Z, tail, F, line end
PLAIN = re.compile(
    rf"((?:N\d{{1,9}}+)?[ \t]*+(?:G0?([01]))?[ \t]*+)"
    rf"(?:X({NUMBER}))?(?:[ \t]*+Y({NUMBER}))?(?:[ \t]*+Z({NUMBER}))?"
    rf"([ \t]*+(?:F[ \t]*+(\d++\.?+\d*+|\.\d++))?[ \t]*+)(\r*+\n?+)"
)
_STRAIGHT = (Kind.RAPID, Kind.LINE)


def goes_on_plainly(state: NcState, motion: int | None) -> bool:
    """Whether a block of axis words alone, under this motion, is a straight move from where all axes are known."""
    return (
        motion in (0, 1)
        and state.commanded.linear_complete
        and None not in state.position
        and state.cycle is None
        and state.feed_mode != "time"
        and not state.ended
    )


def plain_move(number: int, line: str, match: re.Match[str], state: NcState, undotted_mm: bool) -> Move | None:
    """The move of a plain block; None, and nothing changed, if it needs a closer look.

    match: of `PLAIN`. undotted_mm: whether a number without a decimal point counts mm (or inch).
    """
    lead, code, x, y, z, tail, feed, eol = match.groups()
    motion = state.motion if code is None else int(code)
    if (
        motion is None
        or (code is None and state.in_force != motion)
        or not goes_on_plainly(state, motion)
        or (x is None and y is None and z is None)
        or (feed is not None and float(feed) > LARGEST)
    ):
        return None
    position = state.position.copy()
    rows, numbers, scale, absolute = state.row, state.numbers, MM_PER_INCH if state.inch else 1.0, state.absolute
    shift = state.shift
    written = [False] * len(position)
    for axis, text in (("X", x), ("Y", y), ("Z", z)):
        if text is None:
            continue
        row = rows.get(axis)
        distance = float(text) * scale
        if row is None or abs(distance) > LARGEST:
            return None
        if "." not in text and distance and not undotted_mm:
            return None
        if absolute:
            position[row] = distance + shift[row] if shift else distance
        else:
            position[row] += distance  # type: ignore[operator]  # known, as all axes are
        written[row] = True
        numbers[row] = text
    if " " in line:
        state.gap = " "
    elif sum(written) > 1:
        state.gap = ""
    state.motion = state.in_force = motion
    state.position, state.moved = position, True
    if feed is not None:
        state.feed = float(feed) * scale
    return Move(
        number, _STRAIGHT[motion], tuple(position), tuple(written), absolute, state.inch,  # type: ignore[arg-type]
        lead, tail, state.gap, eol, line, feed=state.feed_in_minutes, held=state.commanded.held[absolute], shift=shift,
    )  # fmt: skip
