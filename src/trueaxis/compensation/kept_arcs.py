"""Arcs that stay arcs: the chords of compensated arcs, joined to arcs wherever the shifted points lie on one."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import Arcs, columns_of
from trueaxis.compensation.machine import LINEAR, FloatArray, rotary_rows

LARGEST_SWEEP = math.pi / 2.0  # rad of a piece: its ends determine it well, by I J K and by R, and it is no full circle
FEWEST_CHORDS = 3  # fewer are as short as lines
FEWEST_OF_FEW = 2  # the middle tells whether the words make the arc, the chords' middles whether errors bend more
SHARE = 0.98  # of the tolerance: the rest is what the points themselves are off
SHARE_OF_FEW = 0.9  # the rest is what errors may bend between points that lie apart
_PLANE_OF = ((1, 2), (2, 0), (0, 1))  # rows in the plane across an axis, so that G3 turns from first to second
_BESIDE = 1e-6  # rad: what rounding puts a point of an arc before its start or behind its end


def plane_rows(normal: FloatArray) -> NDArray[np.int64]:
    """Rows of X Y Z, (3, k): the two of the plane of each arc and the one across; normal: (3, k)."""
    across = np.argmax(np.abs(normal), axis=0)
    return np.vstack([np.array(_PLANE_OF)[across].T, across])


class Pieces(NamedTuple):
    """Blocks that are arcs, k of them. at: (k,), the point or block that each ends. centre: (2, k), mm from its start,
    in the plane whose rows of X Y Z are rows: (2, k). radius: (k,), as it is written.
    """

    at: NDArray[np.int64]
    centre: FloatArray
    rows: NDArray[np.int64]
    radius: FloatArray

    def some(self, which: NDArray[np.int64]) -> "Pieces":
        """Some of them."""
        return Pieces(self.at[which], self.centre[:, which], self.rows[:, which], self.radius[which])


NO_PIECES = Pieces(np.zeros(0, np.int64), np.zeros((2, 0)), np.zeros((2, 0), np.int64), np.zeros(0))


class ArcBlocks(NamedTuple):
    """positions: (n_axes, n), where the points are reached, those in the midst of a block on its arc. ends: (n,),
    whether each is the end of a block. arcs: by the points that end them. apart: moves that are no arcs all along, and
    have too few chords to be lines.
    """

    positions: FloatArray
    ends: NDArray[np.bool_]
    arcs: Pieces
    apart: NDArray[np.int64]

    def blocks(self, shares: FloatArray) -> tuple[NDArray[np.int64], FloatArray, Pieces]:
        """Indices of the points that end blocks, the share of time of each block, and the arcs by number of the block;
        shares: of each point.
        """
        at = np.flatnonzero(self.ends)
        if at.size == shares.size:
            return at, shares, self.arcs
        summed = np.add.reduceat(shares, np.concatenate([[0], at[:-1] + 1]))
        return at, summed, self.arcs._replace(at=np.searchsorted(at, self.arcs.at))


class _Open(NamedTuple):
    """Pieces of arcs, k of them, that may become arcs: from point `first` to point `last` of a table that begins with
    where the words before have led. of: number of the arc.
    """

    of: NDArray[np.int64]
    first: NDArray[np.int64]
    last: NDArray[np.int64]

    def some(self, which: NDArray[np.bool_]) -> "_Open":
        return _Open(self.of[which], self.first[which], self.last[which])


def arc_blocks(
    arcs: Arcs,
    few: NDArray[np.bool_],
    owner: NDArray[np.int64],
    written: FloatArray,
    wanted: FloatArray,
    previous: FloatArray | None,
    steps: FloatArray,
    axes: tuple[str, ...],
    allowed: FloatArray,
) -> ArcBlocks:
    """Join points of arcs to arcs where they lie on some.

    few: (k,), which arcs, all of them kept, have fewer chords than lines would have to be. owner: (n,), move of each
    point, ascending. written, wanted: (n_axes, n), as the words name them and before rounding, mm and deg. previous:
    (n_axes,), position named by the words before; None: it is not certain. steps: (n_axes, n), of words. allowed: (n,),
    largest distance of each point from where it is wanted, mm.
    """
    ends = np.ones(owner.size, dtype=bool)
    if not set(LINEAR) <= set(axes) or not arcs.kept.any():
        return ArcBlocks(written, ends, NO_PIECES, np.zeros(0, np.int64))
    rows = [axes.index(axis) for axis in LINEAR]
    start = np.full(written.shape[0], np.nan) if previous is None else previous
    table = np.concatenate([start[:, None], written], axis=1)
    may, first, last = _joinable(arcs, few, owner, table, previous is not None, list(rotary_rows(axes)))
    share = np.where(few[may], SHARE_OF_FEW, SHARE)
    joiner = _Joiner(
        arcs.some(may), table[rows], np.concatenate([start[rows, None], wanted[rows]], axis=1), steps[rows[0], first],
        share * allowed[first], np.where(few[may], FEWEST_OF_FEW, FEWEST_CHORDS),
    )  # fmt: skip
    pieces = joiner.joined(_quarters(arcs.sweep[may], first, last))
    apart = few.copy()
    apart[may] &= joiner.chords < last - first
    found = pieces.some(np.argsort(pieces.at))
    positions = written.copy()
    positions[rows] = joiner.placed[:, 1:]
    ends[joiner.inner - 1] = False
    return ArcBlocks(positions, ends, found._replace(at=found.at - 1), arcs.index[apart])


def _joinable(
    arcs: Arcs,
    few: NDArray[np.bool_],
    owner: NDArray[np.int64],
    table: FloatArray,
    certain: bool,
    rotary: list[int],
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Which arcs may stay arcs, and from where to where in the table their points are; certain: whether the first of
    the table is. Rotary axes must not turn.
    """
    first, last = np.searchsorted(owner, arcs.index), np.searchsorted(owner, arcs.index + 1)
    may = arcs.kept & ((last - first >= FEWEST_CHORDS) | few) & ((first > 0) | certain)
    if rotary:
        turned = np.concatenate([[0], np.cumsum((np.diff(table[rotary], axis=1) != 0.0).any(axis=0))])
        may &= turned[first] == turned[last]
    return np.flatnonzero(may), first[may], last[may]


def _quarters(sweep: FloatArray, first: NDArray[np.int64], last: NDArray[np.int64]) -> _Open:
    """Arcs in pieces of at most `LARGEST_SWEEP`."""
    count = last - first
    parts = np.minimum(np.maximum(np.ceil(sweep / LARGEST_SWEEP - 1e-9), 1.0).astype(np.int64), count)
    of = np.repeat(np.arange(parts.size), parts)
    number = np.arange(of.size) - np.repeat(np.cumsum(parts) - parts, parts)
    each = (count / parts)[of]
    edges = [first[of] + np.rint((number + step) * each).astype(np.int64) for step in (0, 1)]
    return _Open(of, *edges)


class _Joiner:
    """Joins points of some arcs. placed: (3, m), the points, on the arcs that were made of them; inner: which are in
    the midst of one; chords: (k,), how many of each arc have been joined.
    """

    def __init__(
        self,
        arcs: Arcs,
        written: FloatArray,
        wanted: FloatArray,
        step: FloatArray,
        limit: FloatArray,
        fewest: NDArray[np.int64],
    ) -> None:
        """written, wanted: (3, m); step: (k,), of the words of the centre, mm; limit: (k,), largest distance allowed,
        mm; fewest: (k,), chords of an arc that is made.
        """
        self._arcs, self._written, self._wanted, self._step, self._limit = arcs, written, wanted, step, limit
        self._fewest, self.chords = fewest, np.zeros(len(arcs), np.int64)
        self._rows = plane_rows(arcs.normal)
        self._sense = np.where(np.take_along_axis(arcs.normal, self._rows[2:], axis=0)[0] > 0.0, 1.0, -1.0)
        self.placed = written.copy()
        self.inner = np.zeros(0, np.int64)

    def joined(self, pieces: _Open) -> Pieces:
        """The arcs that pieces make, halved until they make some or are few chords."""
        found = [NO_PIECES]
        while (pieces := pieces.some(pieces.last - pieces.first >= self._fewest[pieces.of])).of.size:
            good, made = self._made(pieces)
            found.append(made)
            np.add.at(self.chords, pieces.of[good], (pieces.last - pieces.first)[good])
            pieces = pieces.some(~good)
            middle = (pieces.first + pieces.last) // 2
            pieces = _Open(
                np.concatenate([pieces.of, pieces.of]),
                np.concatenate([pieces.first, middle]),
                np.concatenate([middle, pieces.last]),
            )
        return Pieces(*(np.concatenate(parts, axis=-1) for parts in zip(*found, strict=True)))

    def _made(self, pieces: _Open) -> tuple[NDArray[np.bool_], Pieces]:
        """Which pieces pass all their points as one arc, and these."""
        rows = columns_of(self._rows, pieces.of)
        start, end = self._written[rows, pieces.first], self._written[rows, pieces.last]
        count = pieces.last - pieces.first - 1
        of = np.repeat(np.arange(count.size), count)  # the piece of each point between
        begin = np.cumsum(count) - count
        point = np.arange(of.size) - begin[of] + pieces.first[of] + 1
        aims = self._wanted[columns_of(rows, of), point]
        sense, step = self._sense[pieces.of], self._step[pieces.of]
        with np.errstate(invalid="ignore", divide="ignore"):  # what is no arc is not taken
            centre = _centre(start, end, aims[:, begin + count // 2])
            radius = np.hypot(*(centre - start[:2]))
            rounded = np.rint(radius / step) * step
            by_radius = self._arcs.by_radius[pieces.of]
            radius = np.where(by_radius, rounded, radius)
            centre = np.where(
                by_radius,
                _centre_of_radius(start, end, rounded, sense),
                start[:2] + np.rint((centre - start[:2]) / step) * step,
            )
            places, inside = _on_arc(start, end, centre, sense, aims, of)
            distance = np.sqrt(((places - aims) ** 2).sum(axis=0))
            good = np.logical_and.reduceat(inside & (distance <= self._limit[pieces.of[of]]), begin)
        kept = good[of]
        self.placed[columns_of(rows, of[kept]), point[kept]] = columns_of(places, kept)
        self.inner = np.concatenate([self.inner, point[kept]])
        return good, Pieces(pieces.last[good], (centre - start[:2])[:, good], rows[:2, good], radius[good])


def _on_arc(
    start: FloatArray, end: FloatArray, centre: FloatArray, sense: FloatArray, aims: FloatArray, of: NDArray[np.int64]
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """Places (3, m) of points on the arcs that they are to lie on, and whether these are arcs that pass there.

    start, end: (3, k) and centre: (2, k), in the planes of the arcs; aims: (3, m); of: (m,), arc of each.
    """
    first, last = start[:2] - centre, end[:2] - centre
    radii = np.hypot(*first), np.hypot(*last)
    begin = np.arctan2(first[1], first[0])
    sweep = (sense * (np.arctan2(last[1], last[0]) - begin)) % (2.0 * math.pi)
    about = columns_of(centre, of)
    off = aims[:2] - about
    turned = (sense[of] * (np.arctan2(off[1], off[0]) - begin[of]) + math.pi) % (2.0 * math.pi) - math.pi
    right = (radii[0] > 0.0) & (sweep > 0.0) & (sweep < math.pi)
    inside = right[of] & (turned >= -_BESIDE) & (turned <= sweep[of] + _BESIDE)
    share = turned / sweep[of]
    size = radii[0][of] + share * (radii[1] - radii[0])[of]
    places = np.vstack([about + off * (size / np.hypot(*off)), start[2][of] + share * (end[2] - start[2])[of]])
    return places, inside


def _centre(start: FloatArray, end: FloatArray, middle: FloatArray) -> FloatArray:
    """Centres (2, k) of the circles through start, end and a point between them; NaN or infinite where they lie on a
    line.
    """
    chord = end[:2] - start[:2]
    length = np.hypot(*chord)
    along = chord / length
    across = np.array([-along[1], along[0]])
    half = 0.5 * (start[:2] + end[:2])
    off = middle[:2] - half
    u, v = along[0] * off[0] + along[1] * off[1], across[0] * off[0] + across[1] * off[1]
    return np.asarray(half + across * (u * u + v * v - 0.25 * length * length) / (2.0 * v))


def _centre_of_radius(start: FloatArray, end: FloatArray, radius: FloatArray, sense: FloatArray) -> FloatArray:
    """Centres (2, k) of the arcs of less than half a turn that a control makes of R; NaN where R is too small."""
    chord = end[:2] - start[:2]
    length = np.hypot(*chord)
    rise = sense * np.sqrt(radius * radius - 0.25 * length * length) / length
    return np.asarray(0.5 * (start[:2] + end[:2]) + rise * np.array([-chord[1], chord[0]]))
