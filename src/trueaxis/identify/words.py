"""What data leave open, in words."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.identify.machine import LINEAR
from trueaxis.measure.machine import FloatArray


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


def reduced(null: FloatArray, first: Sequence[int] = ()) -> FloatArray:
    """The same null space (n, d) with a basis of few entries each: reduced echelon form of its transpose.

    first: rows that are to lead a basis vector each where they can; then the largest entry left leads the next.
    Rounding is set to zero.
    """
    rows = null.T.copy()
    used: list[int] = []
    for column in [*first, None]:
        while len(used) < rows.shape[0]:
            left = np.abs(rows[len(used) :])
            if column is None:
                row, pivot = np.unravel_index(int(left.argmax()), left.shape)
            else:
                row, pivot = int(left[:, column].argmax()), column
            if left[row, pivot] < 1e-6:
                break
            place = len(used)
            rows[[place, place + int(row)]] = rows[[place + int(row), place]]
            rows[place] /= rows[place, pivot]
            others = np.delete(np.arange(rows.shape[0]), place)
            rows[others] -= np.outer(rows[others, pivot], rows[place])
            used.append(int(pivot))
            if column is not None:
                break
    rows[np.abs(rows) < 1e-9] = 0.0
    return rows.T
