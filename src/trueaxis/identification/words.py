"""What data leave open, in words."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.combinations import Combination
from trueaxis.estimation.tool_point import ToolSummary
from trueaxis.estimation.undone import How
from trueaxis.io.safe_text import plain_zero
from trueaxis.machine.machine import ROTARY
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.errors import Determined

DETERMINED_BY: dict[Determined, str] = {
    "data": "determined by readings",
    "partly": "partly by the prior",
    "prior": "by the prior alone",
}
RULE = (
    "determined by readings: the prior's part of u is below that of the readings, or below a tenth of what is expected "
    "without them (of ...); by the prior alone: u exceeds nine tenths of that; of curves the root mean squares count"
)
LEVEL = "least-squares lines of the straightness are level (ISO 230-1)"
IN_COMBINATION = "known only in combination (before the convention separates straightness and squareness)"
READS: Mapping[How, str] = {
    "reversed": "as if the sign were reversed (reading, direction in setup.toml, or sense of an axis)",
    "small": "as if the values were 1000 times too small (m written for mm? of an angle, a file not in rad?)",
    "large": "as if the values were 1000 times too large (um written for mm? mrad for rad?)",
    "inch": "as if inches were written for mm",
    "arcsec": "as if arcseconds were written for microradians",
    "urad": "as if microradians were written for arcseconds",
    "mirrored": "as if the targets were labelled from the other end (positions in readings.csv)",
    "swapped": "as if the readings were those of another run",
}
MOST_RUNS = 5  # named
NOTHING = 1e-6  # of the other part of u: rounding
NEARLY = 0.01  # of 1: what a factor may be off by and count as 1


@dataclass(frozen=True, slots=True)
class Share:
    """One part of a combination that changes no reading: so much of `what`."""

    what: str
    value: float
    unit: str

    def __str__(self) -> str:
        return f"{self.value:+.4g} {self.unit} of {self.what}"


def level_rule(axes: Iterable[str]) -> str:
    """What parts squareness from straightness on a machine of these axes."""
    return (
        f"{LEVEL}, but for those whose slope a rotary axis tells from squareness" if set(axes) & set(ROTARY) else LEVEL
    )


def together(shares: Sequence[Share]) -> str:
    """`+1 rad of eps_xy with -1 mm/mm of EYX`."""
    first, *others = (str(share) for share in shares)
    return f"{first} with {enumerated(others)}" if others else first


def enumerated(words: Sequence[str], last: str = "and") -> str:
    """`a`, `a and b`, `a, b and c`."""
    return f"{', '.join(words[:-1])} {last} {words[-1]}" if len(words) > 1 else "".join(words)


def split_apart(names: Sequence[str], partners: Sequence[str], shares: Sequence[Share]) -> str:
    """Location errors and slopes that can take each other's place: `eps_xy and the slope of EYX: only their sum`."""
    last = shares[-1].value
    alone = len(shares) == 2 and abs(abs(last) - 1.0) < 1e-6
    kind = "combination" if not alone else "sum" if last < 0.0 else "difference"
    what = enumerated([*names, *(f"the slope of {partner}" for partner in partners)])
    return f"{what}: only their {kind} is determined ({together(shares)} changes no reading)"


def combination_text(one: Combination) -> str:
    """`eps_xy and the slope of EYX: only their sum, to 0.8 urad (by themselves to 41 and 39 urad)`; of more parts
    `eps_xy + the slope of EYX - 754 x the slope of EBX: to 0.8 urad (by themselves: eps_xy to 41 urad, ...)`.
    """
    names = [f"the slope of {part.name}" if part.what == "slope" else part.name for part in one.parts]
    units = {part.unit.replace("mm/mm", "rad") for part in one.parts}
    alone = [small(u, part.unit) for u, part in zip(one.alone, one.parts, strict=True)]
    u = small(one.u, one.parts[0].unit)
    last = one.parts[-1].factor
    if len(one.parts) == 2 and len(units) == 1 and abs(abs(last) - 1.0) < NEARLY:
        kind = "sum" if last > 0.0 else "difference"
        return f"{enumerated(names)}: only their {kind}, to {u} (by themselves to {enumerated(alone)})"
    terms = "".join(
        f"{_sign(part.factor, first=index == 0)}{_times(part.factor)}{name}"
        for index, (name, part) in enumerate(zip(names, one.parts, strict=True))
    )
    each = [f"{name} to {of}" for name, of in zip(names, alone, strict=True)]
    return f"{terms}: to {u} (by themselves: {enumerated(each)})"


def _sign(factor: float, *, first: bool) -> str:
    return "" if first else " + " if factor > 0.0 else " - "


def _times(factor: float) -> str:
    """A factor of values in mm and rad, where it is not 1."""
    return "" if abs(abs(factor) - 1.0) < NEARLY else f"{abs(factor):.3g} x "


def small(value: float, unit: str) -> str:
    """A value in mm or rad, or per mm or deg, in micrometres or microradians: `0.8 urad`; of a scale `1 ppm`."""
    of, _, per = unit.partition("/")
    if unit in ("mm/mm", "1"):
        return f"{plain_zero(value * 1e6):.3g} {'ppm' if unit == '1' else 'urad'}"
    size = plain_zero(value * (1e3 if of == "mm" else 1e6))
    return f"{size:.3g} {'um' if of == 'mm' else 'urad'}{'/' + per if per else ''}"


def parts_of_u(u_readings: float, u_prior: float, prior: float, unit: str) -> str:
    """The three figures that say by what a value is determined: `readings 10.3, prior 10.7, of 100 urad`."""
    least = NOTHING * max(u_readings, u_prior)
    readings, by_prior = (small(one if one > least else 0.0, unit).split()[0] for one in (u_readings, u_prior))
    return f"readings {readings}, prior {by_prior}, of {small(prior, unit)}"


def in_small(unit: str) -> tuple[float, str]:
    """The factor and the unit by which sizes of effects are written: micrometres and microradians."""
    for plain, small_unit, by in (("mm", "um", 1e3), ("rad", "urad", 1e6)):
        if unit.split("/", maxsplit=1)[0] == plain:
            return by, small_unit + unit.removeprefix(plain)
    return 1.0, unit


def some_of(each: Sequence[str]) -> str:
    """`X1, X2, X3, X4, X5 and 7 more`."""
    rest = f" and {len(each) - MOST_RUNS} more" if len(each) > MOST_RUNS else ""
    return f"{', '.join(each[:MOST_RUNS])}{rest}"


def in_digits(value: float, digits: int = 2) -> str:
    """`0.012`, `130`, `480 000`: so many digits, no powers of ten."""
    shown = np.format_float_positional(float(f"{value:.{digits}g}"), trim="-")
    return f"{float(shown):,.0f}".replace(",", " ") if abs(value) >= 1e4 else shown


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
    at = " ".join(f"{axis}{position:g}" for axis, position in tool.largest_at.items())
    points = enumerated([f"({', '.join(f'{part:g}' for part in point)})" for point in tool.tools])
    sizes = "errors of the sizes that are estimated" if tool.estimated else "[prior]"
    usual = most = ""
    if tool.u_usual_rms is not None and tool.largest_u_usual is not None:
        usual = f"; u by the usual sizes of instrument unknowns {small(tool.u_usual_rms, 'mm')}"
        most = f"; by the usual sizes {small(tool.largest_u_usual, 'mm')}"
    return (
        f"u of {points}, seen from home: {small(tool.u_rms, 'mm')} RMS over the volume, of which "
        f"{small(tool.u_prior_rms, 'mm')} rest on the prior ({small(tool.prior_rms, 'mm')} without readings, by "
        f"{sizes}{usual}); at most {small(tool.largest_u, 'mm')} in one coordinate, over the travel (at {at}{most}). "
        f"On a workpiece placed where it fits best: {small(tool.u_placed_rms, 'mm')} RMS "
        f"({small(tool.prior_placed_rms, 'mm')} without readings)"
    )
