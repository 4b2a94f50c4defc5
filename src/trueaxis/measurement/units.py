"""Units as the headers of instrument files name them, and the columns they may stand at."""

import math
import re
from dataclasses import dataclass
from typing import Literal

Dimension = Literal["length", "angle", "time", "feed", "temperature"]

# name -> dimension and what one of it is in mm, deg, s, mm/min, degC
UNITS: dict[str, tuple[Dimension, float]] = {
    "mm": ("length", 1.0), "um": ("length", 1e-3), "µm": ("length", 1e-3), "μm": ("length", 1e-3),
    "micron": ("length", 1e-3), "microns": ("length", 1e-3), "nm": ("length", 1e-6), "m": ("length", 1e3),
    "in": ("length", 25.4), "inch": ("length", 25.4),
    "deg": ("angle", 1.0), "°": ("angle", 1.0), "rad": ("angle", math.degrees(1.0)),
    "arcsec": ("angle", 1.0 / 3600.0),
    "s": ("time", 1.0), "ms": ("time", 1e-3), "min": ("time", 60.0), "h": ("time", 3600.0),
    "mm/min": ("feed", 1.0), "m/min": ("feed", 1e3), "mm/s": ("feed", 60.0),
    "degc": ("temperature", 1.0), "°c": ("temperature", 1.0), "c": ("temperature", 1.0),
}  # fmt: skip
_WITH_UNIT = re.compile(r"(.*?)\s*(?:\[(?P<square>[^\[\]]*)\]|\((?P<round>[^()]*)\)|\s*/\s*(?P<slash>\S+))")
_SUFFIX = re.compile(r"(.+)_(mm|um|nm|deg|rad|arcsec|s|c|mm_min)", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Heading:
    """The head of a column: its name in small letters without the unit, and the unit, empty where there is none."""

    text: str
    name: str
    unit: str


def heading(text: str) -> Heading:
    """`Error [um]`, `Error (um)`, `Error / um` and `error_um` as name and unit."""
    text = text.strip()
    if parts := _WITH_UNIT.fullmatch(text):
        unit = parts["square"] or parts["round"] or parts["slash"] or ""
        return Heading(text, parts[1].strip().lower(), unit.strip().lower())
    if parts := _SUFFIX.fullmatch(text):
        return Heading(text, parts[1].lower(), parts[2].lower().replace("mm_min", "mm/min"))
    return Heading(text, text.lower(), "")


def factor(unit: str, dimension: Dimension) -> float | None:
    """What one of the unit is in mm, deg, s, mm/min or degC; None where it is no unit of that dimension."""
    found = UNITS.get(unit.strip().lower())
    return found[1] if found is not None and found[0] == dimension else None


def units_of(dimension: Dimension) -> str:
    """The units of a dimension as a message lists them."""
    return ", ".join(name for name, (of, _) in UNITS.items() if of == dimension and name.isascii())
