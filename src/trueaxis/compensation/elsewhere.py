"""What it costs that something stands elsewhere than it is taken to stand: an axis before its first word or after a
tool change, and work offsets.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import columns_of
from trueaxis.compensation.course import Placing, of_points
from trueaxis.compensation.datum import Datum, Zero
from trueaxis.compensation.logs import Running, Summary
from trueaxis.compensation.machine import ErrorModel, FloatArray, linear_rows
from trueaxis.compensation.path import Held, Path, Places, alike
from trueaxis.compensation.settings import Settings

# Places along the travel of each such axis, by how many there are: error curves bend a few times over the travel, and
# all combinations are looked at.
_PLACES = {1: 33, 2: 9, 3: 5}
_FEWEST_PLACES = 3
_AT_ONCE = 16384
NEAR = 10.0  # mm: how well a hand sets an axis without measuring


@dataclass(frozen=True, slots=True)
class UnknownPlaces:
    """Rapids while axes may stand anywhere. assumed: where these are taken to stand until a program first commands
    them, mm and deg. change: of the words of the other axes over the travel of these, mm.
    """

    assumed: dict[str, float]
    change: Summary


@dataclass(frozen=True, slots=True)
class UnnamedFeeds:
    """Points of feed motions while axes may stand anywhere, or the program has not moved them so far.

    places: where the axes are taken to stand, mm. left: error that their words would take back, mm; None where they
    are all counted. anywhere, near: change of the words of the other axes, mm, over the travel of those that may stand
    anywhere, and within NEAR of where the user says that they stand; None where there are none.
    """

    places: dict[str, float]
    left: Summary | None
    anywhere: Summary | None
    near: Summary | None


class Elsewhere:
    """Gathers, batch by batch, what it may cost that axes stand elsewhere."""

    def __init__(self, axes: tuple[str, ...], settings: Settings) -> None:
        self._axes = axes
        self._stated, self._assumed = settings.start, settings.assumed
        self._of_rapids, self._anywhere, self._near, self._left = Running(), Running(), Running(), Running()
        self._rows_of_rapids, self._rows_of_feeds = set[int](), set[int]()

    def add(
        self, placing: Placing, path: Path, places: Places, lines: NDArray[np.int64], tool_point: FloatArray
    ) -> None:
        """Take in the points of a path; lines: (n,), of the program; tool_point: (3, 1)."""
        stated = places.uncounted & ~places.elsewhere
        for flags, fed, change, within in (
            (places.elsewhere, False, self._of_rapids, math.inf),
            (places.elsewhere, True, self._anywhere, math.inf),
            (stated, True, self._near, NEAR),
        ):
            points = np.flatnonzero(flags.any(axis=0) & (path.rapid != fed))
            if points.size == 0:
                continue
            model = placing.at(points, np.ones(points.size))
            there, of_points = columns_of(path.points, points), columns_of(flags, points)
            change.add(change_of_words(model, there, of_points, tool_point, within), lines[points])
            rows = self._rows_of_feeds if fed else self._rows_of_rapids
            rows |= set(np.flatnonzero(of_points.any(axis=1)).tolist())
            free = columns_of(places.uncounted, points)
            if fed and free.any():
                error = model.deviation(there, tool_point)
                left = taken_back(model, there, error, free, tool_point)
                self._left.add(np.sqrt((left**2).sum(axis=0)), lines[points])

    def rapids(self) -> UnknownPlaces | None:
        """What is said of rapids."""
        change = self._of_rapids.summary()
        return None if change is None else UnknownPlaces(self._places(self._rows_of_rapids), change)

    def feeds(self) -> UnnamedFeeds | None:
        """What is said of feed motions."""
        if not self._rows_of_feeds:
            return None
        places = self._places(self._rows_of_feeds)
        return UnnamedFeeds(places, self._left.summary(), self._anywhere.summary(), self._near.summary())

    def _places(self, rows: set[int]) -> dict[str, float]:
        names = [self._axes[row] for row in sorted(rows)]
        return {axis: self._stated.get(axis, self._assumed.get(axis, 0.0)) for axis in names}


def taken_back(
    model: ErrorModel, positions: FloatArray, error: FloatArray, free: Held, tool_point: FloatArray
) -> FloatArray:
    """What the motion of some axes adds to an error where all together would take it back, (3, n), mm.

    positions: (n_axes, n), mm and deg; error: (3, n), mm, of the tool point; free: (n_axes, n), these axes.
    """
    moved = positions + np.where(free, model.correction(positions, -error), 0.0)
    return model.ideal(moved, tool_point) - model.ideal(positions, tool_point)


def change_of_words(
    model: ErrorModel,
    points: FloatArray,
    elsewhere: NDArray[np.bool_],
    tool_point: FloatArray,
    within: float = math.inf,
) -> FloatArray:
    """Largest change of the words of the linear axes that are known, (n,), mm, over the travel of the others.

    points: (n_axes, n), mm and deg, for which the words are; elsewhere: (n_axes, n), axes that may stand anywhere, or
    no further than `within` (mm, deg) from the points; model: the machine at those points.
    """
    largest = np.zeros(points.shape[1])
    for index in alike(elsewhere):
        pattern = np.flatnonzero(elsewhere[:, index[0]])
        for part in np.array_split(index, -(-index.size // _AT_ONCE)):
            there = columns_of(points, part)
            largest[part] = _change(of_points(model, part), there, pattern, tool_point, within)
    return largest


def _change(
    model: ErrorModel, points: FloatArray, rows: NDArray[np.int64], tool_point: FloatArray, within: float
) -> FloatArray:
    known = [row for row in linear_rows(model.axes) if row not in rows]
    taken = _words(model, points, tool_point)[known]
    largest = np.zeros(points.shape[1])
    for places in _places(model, rows):
        there = points.copy()
        there[rows] = np.clip(np.array(places)[:, None], points[rows] - within, points[rows] + within)
        change = _words(model, there, tool_point)[known] - taken
        largest = np.maximum(largest, np.sqrt((change**2).sum(axis=0)))
    return largest


def _places(model: ErrorModel, rows: NDArray[np.int64]) -> Iterator[tuple[float, ...]]:
    count = _PLACES.get(rows.size, _FEWEST_PLACES)
    yield from product(*(np.linspace(*model.travel[model.axes[row]], count).tolist() for row in rows))


def _words(model: ErrorModel, points: FloatArray, tool_point: FloatArray) -> FloatArray:
    """First correction of the axes, Eq. (55)."""
    return model.correction(points, -model.deviation(points, tool_point))


# Places within a range, by how many axes have one: error curves bend a few times over the travel.
_OFFSET_PLACES = {1: 65, 2: 17, 3: 9}
_FEWEST_OFFSETS = 5
_MOST_POSITIONS = 2000  # of the program, spread evenly over the cells that it visits, for each place within a range
_STEP = 1.0  # mm, deg: either side, for the slope


@dataclass(frozen=True, slots=True, kw_only=True)
class OffsetUse:
    """One work offset in a program. value, half_range: by axis, mm and deg, as taken. slopes: largest change of the
    words per mm (deg) of each axis' offset, mm, over the places of the program. change: largest over the range; None
    where there is no range. leaves_travel: whether positions leave the travel at an end of the range. zero: its datum.
    """

    system: str
    value: dict[str, float]
    half_range: dict[str, float]
    slopes: dict[str, float]
    change: float | None
    leaves_travel: bool
    zero: Zero


def offset_use(
    model: ErrorModel,
    places: Sequence[tuple[FloatArray, FloatArray]],
    system: str,
    value: Mapping[str, float],
    spread: FloatArray,
    datum: Datum,
) -> OffsetUse:
    """What a work offset counts in a program.

    places: positions (n_axes, n), mm and deg, that the program visits under it, with the tool point (3, 1) of each;
    value: by axis; spread: (n_axes,), half of its range.
    """
    moves = datum.slopes(model, value)  # of the true zero, where it was touched off: it takes the words along
    slopes = dict.fromkeys(model.axes, 0.0)
    change, leaves = 0.0, False
    low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T[:, :, np.newaxis]
    for positions, tool_point in places:
        for row, axis in enumerate(model.axes):
            before, after = positions.copy(), positions.copy()
            before[row] = np.maximum(before[row] - _STEP, low[row])
            after[row] = np.minimum(after[row] + _STEP, high[row])
            way = np.maximum(after[row] - before[row], 1e-9)
            slope = _apart(model, after, before, tool_point, moves[row] * way) / way
            slopes[axis] = max(slopes[axis], float(slope.max(initial=0.0)))
        few = positions[:, :: -(-positions.shape[1] // _MOST_POSITIONS) or 1]
        for offset in _within(spread):
            there = few + offset[:, np.newaxis]
            inside = np.clip(there, low, high)
            leaves |= bool((np.abs(there - inside) > 1e-9).any())
            shifted = datum.moved(model, value, offset)
            change = max(change, float(_apart(model, inside, few, tool_point, shifted).max(initial=0.0)))
    half_range = dict(zip(model.axes, spread.tolist(), strict=True))
    return OffsetUse(
        system=system,
        value=dict(value),
        half_range=half_range,
        slopes=slopes,
        change=change if spread.any() else None,
        leaves_travel=leaves,
        zero=datum.zero(model, value),
    )


_ZEROS = 5  # places of an unknown zero along each linear axis: with three axes all combinations are 125
_POSITIONS = 200  # of the program, at each of them


def unplaced_change(model: ErrorModel, places: Sequence[tuple[FloatArray, FloatArray]]) -> float:
    """Largest change of the corrections, mm, if the zero of a program lies anywhere that keeps it within the travel.

    places: positions (n_axes, n), mm and deg, as they are taken to be, with the tool point (3, 1) of each.
    """
    rows = list(linear_rows(model.axes))
    low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T
    lowest = np.min([positions.min(axis=1) for positions, _ in places], axis=0)
    highest = np.max([positions.max(axis=1) for positions, _ in places], axis=0)
    shares = np.array(list(product(np.linspace(0.0, 1.0, _ZEROS), repeat=len(rows)))).T
    zeros = np.zeros((low.size, shares.shape[1], 1))
    zeros[rows, :, 0] = (low - lowest)[rows, None] + shares * ((high - low) - (highest - lowest))[rows, None]
    change = 0.0
    for positions, tool_point in places:
        few = positions[:, :: -(-positions.shape[1] // _POSITIONS)]
        elsewhere = (few[:, np.newaxis] + zeros).reshape(low.size, -1)
        taken = np.tile(_words(model, few, tool_point)[rows], shares.shape[1])
        apart = np.sqrt(((_words(model, elsewhere, tool_point)[rows] - taken) ** 2).sum(axis=0))
        change = max(change, float(apart.max()))
    return change


def _within(spread: FloatArray) -> Iterator[FloatArray]:
    """Offsets (n_axes,) within the range; none where there is no range."""
    rows = np.flatnonzero(spread)
    if rows.size == 0:
        return
    count = _OFFSET_PLACES.get(rows.size, _FEWEST_OFFSETS)
    for shares in product(np.linspace(-1.0, 1.0, count), repeat=rows.size):
        offset = np.zeros(spread.size)
        offset[rows] = np.array(shares) * spread[rows]
        yield offset


def _apart(
    model: ErrorModel, here: FloatArray, there: FloatArray, tool_point: FloatArray, datum: FloatArray
) -> FloatArray:
    """Distance of the corrections at two positions, (n,), mm; datum: (3, 1) or (3, n), by how much further the true
    zero lies off for the first.
    """
    rows = list(linear_rows(model.axes))
    off_here, off_there = (model.deviation(at, tool_point) for at in (here, there))
    words = [model.correction(at, -off)[rows] for at, off in ((here, off_here - datum), (there, off_there))]
    return np.asarray(np.sqrt(((words[0] - words[1]) ** 2).sum(axis=0)))
