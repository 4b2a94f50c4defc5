"""FEDRAT of a cutter location file as an F word."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from trueaxis.compensate.settings import MM_PER_INCH

_PER_MINUTE = {"MMPM": False, "PERMIN": None, "IPM": True}
_PER_TURN = {"MMPR": False, "PERREV": None, "IPR": True}


class Feed(NamedTuple):
    """mode: G94 or G95; word: the F word; per_minute: mm/min, NaN where it counts by turns."""

    mode: str
    word: str
    per_minute: float


def split_feed(words: Sequence[str]) -> tuple[list[str], list[str]]:
    """The numbers and the units of a FEDRAT, upper case."""
    numbers = [word for word in words if word[:1] in "+-.0123456789" and word]
    return numbers, [word for word in words if word not in numbers]


def feed_of(values: Sequence[float], units: Sequence[str], inch: bool) -> Feed | None:
    """The feed in a program in inches or mm; None if the words make none."""
    unit = units[0] if len(units) == 1 else "PERMIN" if not units else ""
    table = {**_PER_MINUTE, **_PER_TURN}
    if len(values) != 1 or unit not in table or values[0] <= 0:
        return None
    of_inch, value = table[unit], values[0]
    if of_inch is not None and of_inch != inch:
        value *= MM_PER_INCH if of_inch else 1.0 / MM_PER_INCH
    turns = unit in _PER_TURN
    per_minute = math.nan if turns else value * (MM_PER_INCH if inch else 1.0)
    word = f"F{value:.4f}".rstrip("0").rstrip(".")
    return None if word == "F0" else Feed("G95" if turns else "G94", word, per_minute)
