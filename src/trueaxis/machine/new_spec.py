"""The text of a new machine spec, from its structure code and the travels of its axes."""

from collections.abc import Mapping

from trueaxis.machine.machine import AXES
from trueaxis.machine.structure_code import AxisOrder

TURNED = (
    "# Positive commands move what carries the workpiece to {axis}+, and the tool to {axis}- of the workpiece.\n"
    "# Where the control counts the other way (ISO 841 does):\n"
    "# sense = -1\n"
)


def new_spec(
    name: str, structure: str, order: AxisOrder, travel: Mapping[str, tuple[float, float]], sense: Mapping[str, int]
) -> str:
    """The text. structure: a code that reads as `order`, without quotes; travel: axis -> ends, mm or deg, rotary axes
    may be left out; sense: axis -> 1 or -1, 1 where nothing is said.
    """
    parts = [f'schema = 1\nname = "{name}"\nstructure = "{structure}"\n']
    for axis in AXES:
        if axis not in order.workpiece + order.tool:
            continue
        parts.append(f"\n[axis.{axis}]\n")
        if axis in travel:
            low, high = travel[axis]
            parts.append(f"travel = [{low!r}, {high!r}]\n")
        if axis in sense:
            parts.append(f"sense = {sense[axis]}\n")
        elif axis in order.workpiece:
            parts.append(TURNED.format(axis=axis))
        if axis in "ABC":
            parts.append("# position = [0.0, 0.0, 0.0]  # where its axis lies, from the axis that it stands on, mm\n")
    return "".join(parts)
