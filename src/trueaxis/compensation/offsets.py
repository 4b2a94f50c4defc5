"""What is known of a control's work offsets before a program runs."""

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field

# of G54 to G59.3 of LinuxCNC in the order of their numbers; G54.1 P1 and on are Fanuc's
NUMBERED = ("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3")
_NAME = re.compile(r"G0*(5[4-9](?:\.[1-3])?)(?:\s*P0*(\d{1,3}))?", re.IGNORECASE)
RIGHT_NAME = "G54 to G59, G59.1 to G59.3, or G54.1P1 and on"
LARGEST = 1e5  # mm, deg: as positions

Range = tuple[float, float]  # lowest and highest value, mm or deg; the same where it is known


@dataclass(frozen=True, slots=True)
class Offsets:
    """systems: for each work offset (`G54`, `G54.1 P3`) the position of its zero in machine coordinates, mm and deg, by
    axis. shift: of G92 and G52 on top of all. active: the work offset that is in force at first, None: not known.
    """

    systems: Mapping[str, Mapping[str, Range]] = field(default_factory=dict)
    shift: Mapping[str, float] = field(default_factory=dict)
    active: str | None = None

    @property
    def first(self) -> str | None:
        """The work offset that a program begins with; None: machine coordinates."""
        return self.active or ("G54" if "G54" in self.systems else None)


def system_name(text: str) -> str | None:
    """The name of a work offset as `G54`, `G59.1` or `G54.1 P3`; None if it is none."""
    match = _NAME.fullmatch(text.strip())
    if match is None:
        return None
    number, place = match.groups()
    if number == "54.1" and place and int(place):
        return f"G54.1 P{int(place)}"
    return f"G{number}" if f"G{number}" in NUMBERED and place is None else None


def middle(values: Range) -> float:
    """What an offset is taken to be."""
    return 0.5 * (values[0] + values[1])


def half_width(values: Range) -> float:
    """By how much it may differ from that."""
    return 0.5 * (values[1] - values[0])


def problem_of(values: Range) -> str:
    """What is wrong with a value or range; empty if nothing is."""
    low, high = values
    if not (math.isfinite(low) and math.isfinite(high)):
        return "is not finite"
    if low > high:
        return f"goes from {low:g} down to {high:g}"
    return "" if max(-low, high) <= LARGEST else f"is beyond {LARGEST:g}"
