"""What data leave open, in words."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.combinations import Combination
from trueaxis.estimation.machine import LINEAR
from trueaxis.estimation.tool_point import ToolSummary
from trueaxis.measure.machine import FloatArray

NEARLY = 0.01  # of 1: what a factor may be off by and count as 1


@dataclass(frozen=True, slots=True)
class Share:
    """One part of a combination that changes no reading: so much of `what`."""

    what: str
    value: float
    unit: str

    def __str__(self) -> str:
        return f"{self.value:+.4g} {self.unit} of {self.what}"


def together(shares: Sequence[Share]) -> str:
    """`+1 rad of eps_xy with -1 mm/mm of EYX`."""
    first, *others = (str(share) for share in shares)
    return f"{first} with {enumerated(others)}" if others else first


def enumerated(words: Sequence[str]) -> str:
    """`a`, `a and b`, `a, b and c`."""
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}" if words else ""


def split_apart(names: Sequence[str], partners: Sequence[str], shares: Sequence[Share]) -> str:
    """Location errors and slopes that can take each other's place: `eps_xy and the slope of EYX: only their sum`."""
    last = shares[-1].value
    alone = len(shares) == 2 and abs(abs(last) - 1.0) < 1e-6
    kind = "combination" if not alone else "sum" if last < 0.0 else "difference"
    what = enumerated([*names, *(f"the slope of {partner}" for partner in partners)])
    return f"{what}: only their {kind} is determined ({together(shares)} changes no reading)"


def combination_text(one: Combination) -> str:
    """`eps_xy and the slope of EYX: only their sum, to 0.8 urad (by themselves to 41 and 39 urad)`."""
    names = [f"the slope of {part.name}" if part.what == "slope" else part.name for part in one.parts]
    units = {part.unit.replace("mm/mm", "rad") for part in one.parts}
    last = one.parts[-1].factor
    if len(one.parts) == 2 and len(units) == 1 and abs(abs(last) - 1.0) < NEARLY:
        kind = "only their sum" if last > 0.0 else "only their difference"
    else:
        kind = "only " + "".join(
            f"{_sign(part.factor, first=index == 0)}{_times(part.factor)}{name}"
            for index, (name, part) in enumerate(zip(names, one.parts, strict=True))
        )
    alone = [small(u, part.unit) for u, part in zip(one.alone, one.parts, strict=True)]
    return f"{enumerated(names)}: {kind}, to {small(one.u, one.parts[0].unit)} (by themselves to {enumerated(alone)})"


def _sign(factor: float, *, first: bool) -> str:
    return "" if first else " + " if factor > 0.0 else " - "


def _times(factor: float) -> str:
    """A factor of values in mm and rad, where it is not 1."""
    return "" if abs(abs(factor) - 1.0) < NEARLY else f"{abs(factor):.3g} x "


def small(value: float, unit: str) -> str:
    """A value in mm or rad, or per mm or deg, in micrometres or microradians: `0.8 urad`."""
    of, _, per = unit.partition("/")
    if unit == "mm/mm":
        return f"{value * 1e6:.3g} urad"
    return f"{value * (1e3 if of == 'mm' else 1e6):.3g} {'um' if of == 'mm' else 'urad'}{'/' + per if per else ''}"


def slope_unit(component: str) -> str:
    """`mm/mm`, `rad/deg` and the like."""
    return f"{'mm' if component[1] in LINEAR else 'rad'}/{'mm' if component[2] in LINEAR else 'deg'}"


def unit_of(component: str) -> str:
    """`mm` or `rad`."""
    return "mm" if component[1] in LINEAR else "rad"


def only_slope(positions: FloatArray, values: FloatArray, origin: float) -> float | None:
    """The slope of values that lie on a line through zero at `origin`; None where they do not."""
    away = positions - origin
    total = float(away @ away)
    if total == 0.0:
        return None
    slope = float(away @ values) / total
    fits = np.abs(values - slope * away).max() <= 1e-9 * np.abs(values).max()
    return slope if fits else None


def tool_sentence(tool: ToolSummary) -> str:
    """Seen from home and on a workpiece placed where it fits best; beside what is known without readings."""
    at = " ".join(f"{axis}{position:g}" for axis, position in tool.worst.items())
    points = enumerated([f"({', '.join(f'{part:g}' for part in point)})" for point in tool.tools])
    return (
        f"u of {points} over the volume, seen from home: {small(tool.u_rms, 'mm')} RMS, "
        f"{small(tool.u_worst, 'mm')} at worst ({at}); {small(tool.u_prior_rms, 'mm')} of the RMS rest on [prior]; "
        f"without readings {small(tool.prior_rms, 'mm')}. On a workpiece placed where it fits best: "
        f"{small(tool.u_placed_rms, 'mm')} RMS, without readings {small(tool.prior_placed_rms, 'mm')}"
    )
