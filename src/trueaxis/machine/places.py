"""Positions that programs rely on and do not state: the tables [start] and [reference_points] of a machine spec."""

from collections.abc import Mapping, Sequence

from trueaxis.machine.fields import Fields

REFERENCE_CODES = ("G28", "G30")
Position = tuple[tuple[str, float], ...]  # (axis, mm or deg) pairs, in the order of the machine's axes


def read_start(top: Fields, travel: Mapping[str, tuple[float, float]]) -> Position:
    """[start]: axis positions before a program, mm and deg; axes that it does not name are taken at home."""
    return _position(top.table("start"), travel)


def read_reference_points(top: Fields, travel: Mapping[str, tuple[float, float]]) -> tuple[tuple[str, Position], ...]:
    """[reference_points]: machine positions to which G28 and G30 go, for the axes that are named."""
    fields = top.table("reference_points")
    points = tuple((code, _position(fields.table(code), travel)) for code in REFERENCE_CODES if code in fields.raw)
    fields.refuse_others(", ".join(REFERENCE_CODES))
    return points


def _position(fields: Fields, travel: Mapping[str, tuple[float, float]]) -> Position:
    values = [(axis, _within(fields, axis, travel[axis])) for axis in travel if axis in fields.raw]
    fields.refuse_others(_names(tuple(travel)))
    return tuple((axis, value) for axis, value in values if value is not None)


def _within(fields: Fields, axis: str, travel: tuple[float, float]) -> float | None:
    low, high = travel
    right = f"a position within the travel, from {low:g} to {high:g}"
    value = fields.number(axis, right)
    if value is not None and not low <= value <= high:
        fields.fault(axis, f"is {value:g}", right)
        return None
    return value


def _names(axes: Sequence[str]) -> str:
    return f"the axes of the machine: {' '.join(axes)}"
