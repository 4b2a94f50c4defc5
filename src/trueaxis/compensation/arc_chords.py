"""By how many chords arcs are looked at: those of the chord tolerance where an arc may become lines; where it may stay
an arc, as few as tell whether it can, since its chords are not written.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import Arcs, arc_radii, chord_counts
from trueaxis.compensation.kept_arcs import FEWEST_CHORDS, LARGEST_SWEEP
from trueaxis.compensation.machine import LINEAR, ErrorModel, FloatArray, PointControlled, rotary_rows
from trueaxis.compensation.path import MoveTable, Path, path_of, xyz_of

SPACING = 2.5  # mm: of the ends of chords; errors are looked at in their middles too, twice as finely as along lines


def few_counts(radius: FloatArray, sweep: FloatArray, most: NDArray[np.int64]) -> NDArray[np.int64]:
    """Chords no longer than `SPACING`, an even number in each piece that is to be an arc, and at most `most`."""
    pieces = np.maximum(np.ceil(sweep / LARGEST_SWEEP - 1e-9), 1.0)
    pairs = np.maximum(np.ceil(radius * sweep / (pieces * 2.0 * SPACING)), 1.0)
    return np.where(most >= FEWEST_CHORDS, np.minimum(2.0 * pieces * pairs, most), most).astype(np.int64)


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class ArcChords:
    """Of the arcs of moves, k of them: arcs; count: (k,), chords; most: (k,), those within the chord tolerance."""

    arcs: Arcs
    count: NDArray[np.int64]
    most: NDArray[np.int64]

    @classmethod
    def of(cls, moves: MoveTable, start: FloatArray, model: ErrorModel, tolerance: float, stay: bool) -> "ArcChords":
        """As few as possible; start: (n_axes,), before the moves; stay: whether arcs that are kept may stay some.

        Arcs with all chords have a rotary axis that turns, or may leave the travel between the ends of few.
        """
        arcs, axes = moves.arcs, model.axes
        if not len(arcs):
            return cls(arcs=arcs, count=arcs.index, most=arcs.index)
        ends = moves.ends
        first, last = np.concatenate([start[:, None], ends[:, :-1]], axis=1)[:, arcs.index], ends[:, arcs.index]
        radius = arc_radii(xyz_of(first, axes), xyz_of(last, axes), arcs).max(axis=0)
        most = chord_counts(radius, arcs.sweep, tolerance)
        if not stay or isinstance(model, PointControlled) or not set(LINEAR) <= set(axes):
            return cls(arcs=arcs, count=most, most=most)
        rotary = list(rotary_rows(axes))
        may = arcs.kept & (first[rotary] == last[rotary]).all(axis=0)
        for row, axis in enumerate(LINEAR):
            low, high = model.travel[axis]
            across = np.abs(arcs.normal[row]) > 0.5
            may &= across | ((arcs.centre[row] - radius >= low) & (arcs.centre[row] + radius <= high))
        return cls(arcs=arcs, count=np.where(may, few_counts(radius, arcs.sweep, most), most), most=most)

    def on(self, moves: MoveTable, start: FloatArray, axes: tuple[str, ...]) -> tuple[Path, "ArcChords"]:
        """The points of the moves, and these; start: as in `of`."""
        return path_of(moves, start, axes, self.arcs, self.count), self

    def few(self, owner: NDArray[np.int64]) -> NDArray[np.bool_]:
        """Whether points are of arcs with few chords; owner: (n,), their moves."""
        found = np.zeros(int(owner[-1]) + 1, dtype=bool)
        found[self.arcs.index] = self.count < self.most
        return found[owner]

    def finer(self, moves: NDArray[np.int64], at_once: bool = False) -> "ArcChords":
        """With twice as many chords for the arcs of some moves, or all at once."""
        some = np.isin(self.arcs.index, moves)
        more = self.most if at_once else np.minimum(2 * self.count, self.most)
        return replace(self, count=np.where(some, more, self.count))
