"""Table 7 as printed: the conditions of the test."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Conditions:
    """Arc (deg), radius and bar (mm), feed (mm/min), sample rate (Hz), temperature (degrees Celsius)."""

    plane: str
    arc: float
    radius: float
    bar: float
    feed: float
    sample_rate: float
    directions: tuple[str, str]
    temperature: float


TEST_CONDITIONS = Conditions("XY", 360.0, 300.0, 300.0, 1000.0, 13.333, ("Clockwise", "Counterclockwise"), 20.0)
