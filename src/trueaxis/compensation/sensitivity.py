"""How much the words of a program depend on where its work offsets are.

The errors are those of machine positions. A work offset that is not where it was taken to be shifts all of them, and
the errors there are a little different: the change of the words is what is left of the error then, to first order.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from trueaxis.compensation.machine import ErrorModel, FloatArray, linear_rows

# Places within a range, by how many axes have one: error curves bend a few times over the travel.
_PLACES = {1: 65, 2: 17, 3: 9}
_FEWEST_PLACES = 5
_MOST_POSITIONS = 2000  # of the program, spread evenly over the cells that it visits, for each place within a range
_STEP = 1.0  # mm, deg: either side, for the slope


@dataclass(frozen=True, slots=True, kw_only=True)
class OffsetUse:
    """One work offset in a program. value, half_range: by axis, mm and deg, as taken. slopes: largest change of the
    words per mm (deg) of each axis' offset, mm, over the places of the program. change: largest over the range; None
    where there is no range. leaves_travel: whether positions leave the travel at an end of the range.
    """

    system: str
    value: dict[str, float]
    half_range: dict[str, float]
    slopes: dict[str, float]
    change: float | None
    leaves_travel: bool

    def __str__(self) -> str:
        parts = [
            f"{axis}{value:.9g}" + (f" +/- {self.half_range[axis]:.9g}" if self.half_range[axis] else "")
            for axis, value in self.value.items()
        ]
        slopes = ", ".join(f"{10e3 * slope:.2f} um in {axis}" for axis, slope in self.slopes.items())
        text = (
            f"{self.system} is taken at {' '.join(parts)} in machine coordinates: 10 mm (deg) elsewhere changes the "
            f"words by at most {slopes}"
        )
        if self.change is not None:
            text += f"; within the range by at most {1e3 * self.change:.2f} um, which adds to the errors above"
        if self.leaves_travel:
            text += "; positions leave the travel at an end of the range"
        return text


def offset_use(
    model: ErrorModel,
    places: Sequence[tuple[FloatArray, FloatArray]],
    system: str,
    value: Mapping[str, float],
    spread: FloatArray,
) -> OffsetUse:
    """What a work offset counts in a program.

    places: positions (n_axes, n), mm and deg, that the program visits under it, with the tool point (3, 1) of each;
    value: by axis; spread: (n_axes,), half of its range.
    """
    slopes = dict.fromkeys(model.axes, 0.0)
    change, leaves = 0.0, False
    low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T[:, :, np.newaxis]
    for positions, tool_point in places:
        for row, axis in enumerate(model.axes):
            before, after = positions.copy(), positions.copy()
            before[row] = np.maximum(before[row] - _STEP, low[row])
            after[row] = np.minimum(after[row] + _STEP, high[row])
            way = np.maximum(after[row] - before[row], 1e-9)
            slope = _apart(model, after, before, tool_point) / way
            slopes[axis] = max(slopes[axis], float(slope.max(initial=0.0)))
        few = positions[:, :: -(-positions.shape[1] // _MOST_POSITIONS) or 1]
        for offset in _within(spread):
            there = few + offset[:, np.newaxis]
            inside = np.clip(there, low, high)
            leaves |= bool((np.abs(there - inside) > 1e-9).any())
            change = max(change, float(_apart(model, inside, few, tool_point).max(initial=0.0)))
    half_range = dict(zip(model.axes, spread.tolist(), strict=True))
    return OffsetUse(
        system=system,
        value=dict(value),
        half_range=half_range,
        slopes=slopes,
        change=change if spread.any() else None,
        leaves_travel=leaves,
    )


def _within(spread: FloatArray) -> Iterator[FloatArray]:
    """Offsets (n_axes,) within the range; none where there is no range."""
    rows = np.flatnonzero(spread)
    if rows.size == 0:
        return
    count = _PLACES.get(rows.size, _FEWEST_PLACES)
    for shares in product(np.linspace(-1.0, 1.0, count), repeat=rows.size):
        offset = np.zeros(spread.size)
        offset[rows] = np.array(shares) * spread[rows]
        yield offset


def _apart(model: ErrorModel, here: FloatArray, there: FloatArray, tool_point: FloatArray) -> FloatArray:
    """Distance of the corrections at two positions, (n,), mm."""
    rows = list(linear_rows(model.axes))
    words = [model.correction(at, -model.deviation(at, tool_point))[rows] for at in (here, there)]
    return np.asarray(np.sqrt(((words[0] - words[1]) ** 2).sum(axis=0)))
