"""FEDRAT of a cutter location file as an F word."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from trueaxis.compensation.apt_statements import number_of
from trueaxis.compensation.settings import MM_PER_INCH

_PER_MINUTE = {"MMPM": False, "PERMIN": None, "IPM": True}
_PER_TURN = {"MMPR": False, "PERREV": None, "IPR": True}


class Feed(NamedTuple):
    """mode: G94 or G95; word: the F word; per_minute: mm/min, NaN where it counts by turns."""

    mode: str
    word: str
    per_minute: float


def feed_of(words: Sequence[str], inch: bool) -> Feed | None:
    """The feed of FEDRAT's words (upper case) in a program in inches or mm; None if they make none."""
    numbers = [word for word in words if word[:1] in "+-.0123456789" and word]
    units = [word for word in words if word not in numbers]
    unit = units[0] if len(units) == 1 else "PERMIN" if not units else ""
    table = {**_PER_MINUTE, **_PER_TURN}
    value = number_of(numbers[0]) if len(numbers) == 1 else None
    if value is None or unit not in table or value <= 0:
        return None
    of_inch = table[unit]
    if of_inch is not None and of_inch != inch:
        value *= MM_PER_INCH if of_inch else 1.0 / MM_PER_INCH
    turns = unit in _PER_TURN
    per_minute = math.nan if turns else value * (MM_PER_INCH if inch else 1.0)
    word = f"F{value:.4f}".rstrip("0").rstrip(".")
    return None if word == "F0" else Feed("G95" if turns else "G94", word, per_minute)
