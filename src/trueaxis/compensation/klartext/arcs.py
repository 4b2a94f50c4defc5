"""CC, C, CR, CP and LP of Heidenhain Klartext programs, in the XY plane of the tool axis Z."""

import math
from collections.abc import Mapping

from trueaxis.compensation.arcs import (
    Arc,
    ArcError,
    Vector,
    allowed_about,
    allowed_beyond_radius,
    arc_about,
    arc_of_radius,
    rounding_of,
)
from trueaxis.compensation.klartext.blocks import KlartextBlock
from trueaxis.compensation.machine import LINEAR
from trueaxis.compensation.moves import Round
from trueaxis.compensation.nc.modes import half_unit_of
from trueaxis.compensation.nc.state import Commanded, NcState

_PLANE = ("X", "Y")


def pole_of(block: KlartextBlock, state: NcState) -> dict[str, float]:
    """The pole that CC sets, X and Y, mm in machine coordinates.

    Raises ArcError when it is in another plane, or counts from where axes stand that is not known.
    """
    if set(block.coordinates) - set(_PLANE):
        raise ArcError("a pole outside the plane XY of the tool axis Z")
    pole = {}
    for axis in _PLANE:
        word = block.coordinates.get(axis)
        row = state.row.get(axis)
        if row is None:
            raise ArcError(f"this machine has no axis {axis}")
        if word is not None and not word.incremental:
            pole[axis] = word.value * state.scale(axis) + (state.shift[row] if state.shift else 0.0)
            continue
        at = state.position[row]
        if at is None or state.commanded.of([row]) < Commanded.ABSOLUTE:
            raise ArcError(f"the pole counts from where {axis} stands, which is not certain here")
        pole[axis] = at + (word.value * state.scale(axis) if word is not None else 0.0)
    return pole


def _polar_start(pole: Mapping[str, float], state: NcState) -> tuple[float, float]:
    """Radius and angle (rad) of the position about the pole."""
    x, y = (state.position[state.row[axis]] for axis in _PLANE)
    if x is None or y is None or state.commanded.of([state.row[axis] for axis in _PLANE]) < Commanded.ABSOLUTE:
        raise ArcError("polar coordinates from where X and Y stand, which is not certain here")
    return math.hypot(x - pole["X"], y - pole["Y"]), math.atan2(y - pole["Y"], x - pole["X"])


def polar_end(block: KlartextBlock, pole: Mapping[str, float], state: NcState) -> dict[str, float]:
    """X and Y at the end of LP or CP, mm in machine coordinates."""
    if not pole:
        raise ArcError("polar coordinates without a pole (CC) in this frame")
    size, angle = block.coordinates.get("PR"), block.coordinates.get("PA")
    if block.verb == "CP" and size is not None:
        raise ArcError("CP with PR")
    if {"X", "Y"} & set(block.coordinates):
        raise ArcError(f"X or Y in a block of {block.verb}")
    known = (size is None or not size.incremental) and angle is not None and not angle.incremental
    radius, turned = (0.0, 0.0) if known and size is not None else _polar_start(pole, state)
    if size is not None:
        radius = size.value * state.scale("X") + (radius if size.incremental else 0.0)
    if angle is not None:
        turned = math.radians(angle.value) + (turned if angle.incremental else 0.0)
    return {"X": pole["X"] + radius * math.cos(turned), "Y": pole["Y"] + radius * math.sin(turned)}


def arc_of(
    block: KlartextBlock, pole: Mapping[str, float], state: NcState, start: tuple[float, ...], end: tuple[float, ...]
) -> Arc:
    """The arc of C, CR or CP from start to end (axis positions, mm and deg).

    Raises ArcError when the words make none.
    """
    if not block.direction:
        raise ArcError(f"{block.verb} without DR+ or DR-")
    if not pole and block.verb != "CR":
        raise ArcError(f"{block.verb} without a pole (CC) in this frame")
    if block.verb != "CP" and "Z" in block.coordinates:
        raise ArcError(f"Z in a block of {block.verb}")
    normal: Vector = (0.0, 0.0, float(block.direction))
    a, b = _xyz(state, start), _xyz(state, end)
    if block.verb == "CP":
        return _turned(block, pole, a, normal)
    flat: Vector = (b[0], b[1], a[2])
    decimals = max((word.decimals for word in block.coordinates.values()), default=0)
    before = half_unit_of([state.numbers[state.row[axis]] for axis in _PLANE], state.inch, None)
    rounding = rounding_of([axis in _PLANE for axis in LINEAR], decimals, before, True, state.inch)
    if block.verb == "CR":
        if block.radius is None:
            raise ArcError("CR without R+ or R-")
        radius = block.radius * state.scale("X")
        return arc_of_radius(a, b, radius, normal, allowed_beyond_radius(a, flat, rounding))
    centre: Vector = (pole["X"], pole["Y"], a[2])
    return arc_about(a, b, centre, normal, allowed_about(a, flat, centre, rounding))


def _turned(block: KlartextBlock, pole: Mapping[str, float], start: Vector, normal: Vector) -> Arc:
    """CP: by an angle, several turns where it is incremental."""
    angle = block.coordinates.get("PA")
    if angle is None:
        raise ArcError("CP without PA or IPA")
    if math.hypot(start[0] - pole["X"], start[1] - pole["Y"]) <= 1e-7:
        raise ArcError("an arc of radius 0")
    if angle.incremental:
        if angle.value * block.direction <= 0.0:
            raise ArcError("IPA and DR of CP differ in sign")
        sweep = math.radians(abs(angle.value))
    else:
        begin = math.atan2(start[1] - pole["Y"], start[0] - pole["X"])
        sweep = (block.direction * (math.radians(angle.value) - begin)) % (2.0 * math.pi) or 2.0 * math.pi
    return Arc((pole["X"], pole["Y"], start[2]), normal, sweep)


def _xyz(state: NcState, position: tuple[float, ...]) -> Vector:
    x, y, z = (position[state.row[axis]] if axis in state.row else 0.0 for axis in LINEAR)
    return (x, y, z)


def as_arc(block: KlartextBlock) -> Round:
    """How an arc that stays one is written: as CR, because C would need a CC before it."""
    lead = f"{block.head}{block.optional}"
    sign = "+" if block.direction > 0 else "-"
    return Round(f"{lead}CR ", f"{lead}CR ", "CR ", "L ", "radius", "R+", f" DR{sign}")
