"""The uncertainty of the tool point on slices through the middle of the volume."""

from collections.abc import Sequence
from dataclasses import dataclass

from trueaxis.estimation.result import Estimate
from trueaxis.estimation.tool_point import tool_point
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import Vector
from trueaxis.model.volume import middle_planes

STEPS = 25  # along either side of a slice


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Slice:
    """Two axes that move to (n,) and (m,), mm; u: (m, n), mm, of the tool point; at: where the other axes stand."""

    axes: tuple[str, str]
    first: FloatArray
    second: FloatArray
    u: FloatArray
    at: dict[str, float]


def slices(found: Estimate, tools: Sequence[Vector]) -> tuple[Slice, ...]:
    """One for each pair of linear axes, other linear axes in the middle, rotary axes at home."""
    return tuple(
        Slice(
            axes=one.axes,
            first=one.first,
            second=one.second,
            u=tool_point(found, one.positions, tools).u.reshape(STEPS, STEPS),
            at=one.at,
        )
        for one in middle_planes(found.layout.model, STEPS)
    )
