"""The arc that the words of a G2 or G3 block make."""

import math

from trueaxis.compensation import nc_codes as codes
from trueaxis.compensation.arc_rounding import allowed_about, allowed_beyond_radius, rounding_of
from trueaxis.compensation.arcs import Arc, ArcError, Vector, arc_about, arc_of_radius
from trueaxis.compensation.machine import LINEAR
from trueaxis.compensation.nc_meaning import Meaning
from trueaxis.compensation.nc_modes import half_unit_of
from trueaxis.compensation.nc_state import NcState
from trueaxis.compensation.settings import MM_PER_INCH, Settings

_CENTRE_OF = dict(zip("XYZ", "IJK", strict=True))


def arc_of_block(
    state: NcState, start: tuple[float, ...], end: tuple[float, ...], meaning: Meaning, settings: Settings
) -> Arc:
    """The arc from start to end (axis positions, mm and deg) in the plane in force.

    state: before the block but for its modes. settings: what numbers without a decimal point count, and
    whether an interpreter has judged the arc.
    Raises ArcError when the words make none.
    """
    integers, judged = settings.undotted, settings.judged
    first, second, across = codes.PLANES[state.plane]
    if not {first, second} <= set(state.axes):
        raise ArcError(f"the plane {first}{second} of the arc is not one of this machine's")
    turns = meaning.parameters.get("P", 1.0)
    if set(meaning.parameters) - ({"P"} if meaning.turns else set()) or turns < 1.0 or turns != int(turns):
        raise ArcError(f"{' '.join(sorted(meaning.parameters))} in the block of an arc: turns of it are not followed")
    sense = 1.0 if state.motion == 3 else -1.0
    normal = (sense * (across == "X"), sense * (across == "Y"), sense * (across == "Z"))
    a, b = _linear(state, start), _linear(state, end)
    x, y, z = (p if axis == across else q for p, q, axis in zip(a, b, LINEAR, strict=True))
    flat: Vector = (x, y, z)
    given = [state.numbers[state.row[axis]] for axis in (first, second)]
    before = half_unit_of(given, state.inch, integers)
    in_plane = [axis != across for axis in LINEAR]
    rounding = rounding_of(in_plane, meaning.decimals, before, state.absolute, state.inch)
    scale = MM_PER_INCH if state.inch else 1.0
    if meaning.radius is not None:
        if meaning.centre:
            raise ArcError("an arc has either R or I J K")
        return arc_of_radius(a, b, meaning.radius * scale, normal, allowed_beyond_radius(a, flat, rounding))
    if meaning.centre.get(_CENTRE_OF[across]) or meaning.ways.get(_CENTRE_OF[across]):
        raise ArcError(f"{_CENTRE_OF[across]} points out of the plane {first}{second} in force")
    if not meaning.centre:
        raise ArcError("an arc without I J K or R")
    if turns > 1.0 and meaning.radius is not None:
        raise ArcError("turns of an arc by R")
    x, y, z = (_centre(state, meaning, axis, p, scale) for p, axis in zip(a, LINEAR, strict=True))
    allowed = math.inf if judged else allowed_about(a, flat, (x, y, z), rounding)
    arc = arc_about(a, b, (x, y, z), normal, allowed)
    return arc._replace(sweep=arc.sweep + 2.0 * math.pi * (turns - 1.0))


def _centre(state: NcState, meaning: Meaning, axis: str, start: float, scale: float) -> float:
    """Position of the centre along an axis, mm; start: that of the start."""
    letter = _CENTRE_OF[axis]
    if not meaning.ways.get(letter):
        return start + scale * meaning.centre.get(letter, 0.0)
    shift = state.shift[state.row[axis]] if state.shift and axis in state.row else 0.0
    return scale * meaning.centre[letter] + shift


def _linear(state: NcState, position: tuple[float, ...]) -> Vector:
    x, y, z = (position[state.row[axis]] if axis in state.row else 0.0 for axis in LINEAR)
    return (x, y, z)
