"""Structure codes: the order of the axes between workpiece and tool in one line of text, and a new spec from it.

Read are: ISO 10791-6, `[w C' Y' b X Z B t]` (workpiece, its axes with primes, bed, axes of the tool, tool; or the other
way round); the compact code with F (or b) for the fixed bed, `YFXZ`, from workpiece to tool; and the chain of the tool
with the axes of the workpiece behind a plus, both from the bed outwards, `XZB+YC`.
"""

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

from trueaxis.error_name import DIRECTIONS, Direction, rotation_about
from trueaxis.machine.machine import AXES, LINEAR
from trueaxis.machine.prior import SIZES

_ISO = re.compile(r"\[?\s*(?P<first>[wt])(?P<left>[^b]*)b(?P<right>[^b]*)(?P<last>[wt])\s*\]?")

TURNED = (
    "# Positive commands move what carries the workpiece to {axis}+, and the tool to {axis}- of the workpiece.\n"
    "# Where the control counts the other way (ISO 841 does):\n"
    "# sense = -1\n"
)

# the default, shown so that it is known
PRIOR = "\n# How large errors may be before anything is measured, standard deviations:\n# [prior]\n" + "".join(
    f"# {name} = {size!r}\n" for name, size in SIZES.items()
)


class StructureCodeError(ValueError):
    """A structure code that cannot be read; the message says why."""


@dataclass(frozen=True)
class AxisOrder:
    """Axes of both branches, each from the bed outwards."""

    workpiece: tuple[str, ...]
    tool: tuple[str, ...]


def parse_structure(code: str) -> AxisOrder:
    """The axes of a structure code. Raises StructureCodeError."""
    text = code.strip()
    if iso := _ISO.fullmatch(text):
        order = _iso(iso)
    elif "+" in text:
        chain, _, table = text.partition("+")
        order = AxisOrder(_axes(table.replace("'", "")), _axes(chain))
    elif len(re.findall("[Fb]", text)) == 1:
        before, after = re.split("[Fb]", text)
        order = AxisOrder(_axes(before.replace("'", ""))[::-1], _axes(after))
    else:
        raise StructureCodeError("it names no bed (b or F), or more than one")
    twice = [axis for axis, count in Counter(order.workpiece + order.tool).items() if count > 1]
    if twice:
        raise StructureCodeError(f"axis {' '.join(twice)} stands there more than once")
    if not order.workpiece + order.tool:
        raise StructureCodeError("it names no axis")
    return order


def default_location_errors(axis: str, order: AxisOrder) -> tuple[tuple[Direction, str], ...]:
    """Location errors of an axis by their ISO 230-1 names: the usual set, that places every axis line.

    The linear axis nearest to the bed is the reference of directions; the next outwards is square to it in their plane,
    the third to both. A rotation of an axis turns all that stands on it, so it must not be on the inner of two axes:
    there it would turn both. The line of a rotary axis is placed by two offsets and two tilts.
    """
    linear = _from_bed_outwards(order)
    if axis in linear:
        place = linear.index(axis)
        directions: tuple[Direction, ...] = ()
        if place == 1:
            directions = (_third(linear[0], axis),)
        elif place == 2:
            directions = tuple(rotation_about(letter) for letter in LINEAR if letter != axis)
    else:
        directions = tuple(one for one in DIRECTIONS if one.line != rotation_about(axis).line)
    return tuple((direction, str(direction.location_error(axis))) for direction in directions)


def _from_bed_outwards(order: AxisOrder) -> list[str]:
    """The linear axes, none before one that it stands on; of those that may come next, X before Y before Z."""
    branches = [[axis for axis in branch if axis in LINEAR] for branch in (order.workpiece, order.tool)]
    found: list[str] = []
    while any(branches):
        following = min((branch for branch in branches if branch), key=lambda branch: branch[0])
        found.append(following.pop(0))
    return found


def _iso(found: re.Match[str]) -> AxisOrder:
    if found["first"] == found["last"]:
        raise StructureCodeError("it needs w at one end and t at the other")
    left, right = _axes(found["left"], primes=True), _axes(found["right"], primes=True)
    workpiece, tool = (left[::-1], right) if found["first"] == "w" else (right, left[::-1])
    bare = [axis for axis in workpiece if not axis.endswith("'")]
    primed = [axis for axis in tool if axis.endswith("'")]
    if bare or primed:
        raise StructureCodeError("axes between w and b have a prime, those between b and t have none")
    return AxisOrder(tuple(axis[0] for axis in workpiece), tool)


def _axes(text: str, *, primes: bool = False) -> tuple[str, ...]:
    found = re.findall(r"[A-Z]'?", text) if primes else re.findall(r"[A-Z]", text)
    rest = re.sub(r"[A-Z]'?" if primes else r"[A-Z]", "", text).replace(" ", "").replace("-", "")
    unknown = [part for part in found if part[0] not in AXES]
    if rest or unknown:
        raise StructureCodeError(f"{' '.join([*unknown, *rest])} is no axis; axes are {' '.join(AXES)}")
    return tuple(found)


def _third(first: str, second: str) -> Direction:
    return rotation_about(next(letter for letter in LINEAR if letter not in (first, second)))


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
    return "".join(parts) + PRIOR
