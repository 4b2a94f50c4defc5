"""Where work offsets were touched off on a control without compensation, as the option --touched-off states it."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from itertools import groupby

from trueaxis.compensation.machine import LINEAR, ErrorModel, linear_rows
from trueaxis.compensation.offsets import LARGEST, NOT_KNOWN, RIGHT_NAME, Offsets, middle, system_name
from trueaxis.io.faults import Fault

OPTION = "--touched-off"
LENGTH = "L"
_RIGHT = "like G54, G54=L120, G54=X-310,Y-205,Z-390,L120, or for one direction G54:Z=X-300,Y-200,L120"
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)"
_PART = re.compile(rf"([XYZABCL])({_NUMBER})", re.IGNORECASE)


@dataclass(frozen=True, slots=True, kw_only=True)
class TouchedOff:
    """One work offset that was touched off. directions: the linear axes along which this was done here. place: machine
    positions of the axes then, mm and deg; those left out: at the zero of the offset, the drilling axis Z with the
    length on top. length: of the probe or tool, from the point that --tool-point names to its tip, mm.
    """

    system: str
    directions: str = LINEAR
    place: Mapping[str, float] = field(default_factory=dict)
    length: float = 0.0

    def position(self, axes: tuple[str, ...], zero: Mapping[str, float]) -> list[float]:
        """Where the axes stood, mm and deg; zero: of the offset, machine coordinates, by axis."""
        above = {"Z": self.length}
        return [self.place.get(axis, zero.get(axis, 0.0) + above.get(axis, 0.0)) for axis in axes]


def touched_off_of_option(text: str) -> TouchedOff:
    """`G54`, `G54=X-310,Y-205,L120`, `G54:Z=L120` as what it states.

    Raises ValueError where it is something else.
    """
    name, equals, values = text.partition("=")
    name, colon, directions = name.partition(":")
    system, directions = system_name(name), directions.strip().upper() if colon else LINEAR
    if system is None:
        raise ValueError(f"{text!r} is not {_RIGHT}; the name is one of {RIGHT_NAME}")
    if not directions or set(directions) - set(LINEAR) or len(set(directions)) < len(directions):
        raise ValueError(f"{text!r}: the directions are some of X, Y and Z, {_RIGHT}")
    found: dict[str, float] = {}
    for part in re.split(r"[,\s]+", values.strip()) if equals else ():
        match = _PART.fullmatch(part)
        if match is None or match[1].upper() in found or abs(float(match[2])) > LARGEST:
            raise ValueError(f"{text!r} is not {_RIGHT}")
        found[match[1].upper()] = float(match[2])
    return TouchedOff(system=system, directions=directions, length=found.pop(LENGTH, 0.0), place=found)


def faults_of(touched: Iterable[TouchedOff], model: ErrorModel, offsets: Offsets) -> list[Fault]:
    """What does not go with the machine or its work offsets."""
    linear = {model.axes[row] for row in linear_rows(model.axes)}
    found = []
    for system, group in groupby(sorted(touched, key=lambda one: one.system), key=lambda one: one.system):
        of_system = list(group)
        named = [axis for one in of_system for axis in one.directions if axis in linear]
        if system not in offsets.systems:
            given = system.replace(" ", "")
            found.append(Fault(OPTION, system, NOT_KNOWN, f"--offset {given}=X..,Y..,Z.."))
            continue
        if twice := sorted({axis for axis in named if named.count(axis) > 1}):
            found.append(Fault(OPTION, system, f"{' '.join(twice)} is touched off twice", "each direction once"))
        if missing := sorted(linear - set(named)):
            found.append(
                Fault(OPTION, system, f"nothing says where {' '.join(missing)} was touched off",
                      f"{system}:{''.join(missing)}=.. too")
            )  # fmt: skip
        zero = {axis: middle(values) for axis, values in offsets.systems[system].items()}
        for one in of_system:
            found += _place_faults(one, model, zero)
    return found


def _place_faults(one: TouchedOff, model: ErrorModel, zero: Mapping[str, float]) -> list[Fault]:
    foreign = sorted(set(one.place) - set(model.axes))
    found = [Fault(OPTION, one.system, f"this machine has no axis {axis}") for axis in foreign]
    for axis, at in zip(model.axes, one.position(model.axes, zero), strict=True):
        low, high = model.travel[axis]
        if not low <= at <= high:
            found.append(
                Fault(
                    OPTION,
                    one.system,
                    f"{axis} = {at:g} is outside its travel, from {low:g} to {high:g}: it cannot have stood there",
                    f"the machine position when it was touched off, {_RIGHT}",
                )
            )
    return found
