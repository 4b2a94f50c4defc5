"""What it may cost that an axis stands elsewhere than it is taken to stand: before its first word, or after a tool
change.

The words of the other axes take back errors that depend on it too. How much they would change if it stood anywhere
else within its travel is what is left, at most, of the error that they could have taken back.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.held import Held, Places
from trueaxis.compensation.machine import ErrorModel, FloatArray, linear_rows
from trueaxis.compensation.path import Path
from trueaxis.compensation.placed import Placing, of_points
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.statistics import Running, Summary

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

    def __str__(self) -> str:
        named = " ".join(f"{axis}{value:.9g}" for axis, value in self.assumed.items())
        return (
            f"{self.change.count} rapids while {' '.join(self.assumed)} may stand anywhere: their words are for "
            f"{named} (or where the program had the axis before a tool change) and would differ by at most "
            f"{self.change.largest:.4f} mm (line {self.change.line}) elsewhere in the travel; it gets no word"
        )


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

    def __str__(self) -> str:
        axes, at = " ".join(self.places), " ".join(f"{axis}{value:.9g}" for axis, value in self.places.items())
        parts = [f"feed motions before the program commands {axes}, taken to stand at {at}"]
        if self.left is not None:
            parts.append(
                f"it gets no word, and {self.left.largest:.4f} mm of error at most (line {self.left.line}) is left "
                "along it, which counts as no error: the program does not say where it is to be"
            )
        if self.near is not None:
            parts.append(f"{NEAR:g} mm elsewhere changes the other words by at most {self.near.largest:.4f} mm")
        if self.anywhere is not None:
            parts.append(
                f"elsewhere in its travel the other words would differ by at most {self.anywhere.largest:.4f} mm (line "
                f"{self.anywhere.line}), which adds to the errors above"
            )
        return "; ".join(parts)


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
            there, of_points = path.points[:, points], flags[:, points]
            change.add(change_of_words(model, there, of_points, tool_point, within), lines[points])
            rows = self._rows_of_feeds if fed else self._rows_of_rapids
            rows |= set(np.flatnonzero(of_points.any(axis=1)).tolist())
            free = places.uncounted[:, points]
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
    for pattern in np.unique(elsewhere, axis=1).T:
        if pattern.any():
            index = np.flatnonzero((elsewhere == pattern[:, None]).all(axis=0))
            for part in np.array_split(index, -(-index.size // _AT_ONCE)):
                largest[part] = _change(
                    of_points(model, part), points[:, part], np.flatnonzero(pattern), tool_point, within
                )
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
