"""Arcs that stay arcs: the chords of a compensated arc, joined to arcs wherever the shifted points lie on one."""

import math
from collections.abc import Iterable
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.arcs import Arc
from trueaxis.compensation.machine import LINEAR, FloatArray, rotary_rows
from trueaxis.compensation.moves import CentreWords, Move
from trueaxis.compensation.settings import Settings

LARGEST_SWEEP = math.pi / 2.0  # rad of a piece: its ends determine it well, by I J K and by R, and it is no full circle
FEWEST_CHORDS = 3  # fewer are as short as lines
SHARE = 0.98  # of the tolerance: the rest is what the points themselves are off
_PLANE_OF = {0: (1, 2), 1: (2, 0), 2: (0, 1)}  # rows in the plane across an axis, so that G3 turns from first to second


class Piece(NamedTuple):
    """The chords first to last - 1 of an arc. centre: of the arc that they make as written, mm from its start in the
    plane, or None where each point is the end of a line; radius: as it is written.
    """

    first: int
    last: int
    centre: tuple[float, float] | None
    radius: float


def plane_of(arc: Arc) -> tuple[int, int, int]:
    """Rows of X Y Z: the two of the arc's plane and the one across."""
    across = int(np.argmax(np.abs(arc.normal)))
    return (*_PLANE_OF[across], across)


def pieces_of(
    arc: Arc, start: FloatArray, written: FloatArray, wanted: FloatArray, words: CentreWords, step: float, limit: float
) -> tuple[list[Piece], FloatArray]:
    """Pieces of an arc, and (3, n) where its points lie on them.

    start: (3,), as written. written: (3, n), ends of the chords as their words name them; wanted: the same before
    rounding; mm. step: of the words of the centre, mm; limit: largest distance allowed, mm.
    """
    rows = plane_of(arc)
    sense = 1.0 if arc.normal[rows[2]] > 0.0 else -1.0
    ends = np.concatenate([start[:, None], written], axis=1)[list(rows)]
    aims = np.concatenate([start[:, None], wanted], axis=1)[list(rows)]
    count = written.shape[1]
    parts = min(max(math.ceil(arc.sweep / LARGEST_SWEEP - 1e-9), 1), count)
    edges = np.unique(np.rint(np.linspace(0, count, parts + 1)).astype(int)).tolist()
    placed = ends.copy()
    found: list[Piece] = []
    open_parts = list(pairwise(edges))[::-1]
    while open_parts:
        first, last = open_parts.pop()
        if last - first < FEWEST_CHORDS:
            found.append(Piece(first, last, None, 0.0))
            continue
        made = _arc(ends[:, first], ends[:, last], aims[:, first + 1 : last], sense, words, step)
        if made is not None and made[2] <= limit:
            placed[:, first + 1 : last] = made[1]
            found.append(Piece(first, last, made[0], made[3]))
            continue
        middle = (first + last) // 2
        open_parts += [(middle, last), (first, middle)]
    out = np.empty_like(written)
    out[list(rows)] = placed[:, 1:]
    return found, out


def _arc(
    start: FloatArray, end: FloatArray, aims: FloatArray, sense: float, words: CentreWords, step: float
) -> tuple[tuple[float, float], FloatArray, float, float] | None:
    """Centre from the start, places of the points on the arc, largest distance of the aims, radius; None: no arc."""
    centre = _centre(start, end, aims[:, aims.shape[1] // 2])
    if centre is None:
        return None
    radius = math.hypot(*(centre - start[:2]))
    if words == "radius":
        radius = round(radius / step) * step
        centre = _centre_of_radius(start, end, radius, sense)
        if centre is None:
            return None
    else:
        centre = start[:2] + np.rint((centre - start[:2]) / step) * step
    from_centre = np.stack([start[:2], end[:2]], axis=1) - centre[:, None]
    if not math.hypot(*from_centre[:, 0]) > 0.0:
        return None
    radii = np.hypot(*from_centre)
    begin, finish = np.arctan2(from_centre[1], from_centre[0])
    sweep = (sense * (finish - begin)) % (2.0 * math.pi)
    off = aims[:2] - centre[:, None]
    turned = (sense * (np.arctan2(off[1], off[0]) - begin) + math.pi) % (2.0 * math.pi) - math.pi
    if not 0.0 < sweep < math.pi or (turned < -1e-6).any() or (turned > sweep + 1e-6).any():
        return None
    share = turned / sweep
    size = radii[0] + share * (radii[1] - radii[0])
    length = np.hypot(*off)
    places = np.vstack([centre[:, None] + off * (size / length), start[2] + share * (end[2] - start[2])])
    distance = float(np.sqrt(((places - aims) ** 2).sum(axis=0)).max())
    return (float(centre[0] - start[0]), float(centre[1] - start[1])), places, distance, radius


def _centre(start: FloatArray, end: FloatArray, middle: FloatArray) -> NDArray[np.float64] | None:
    """Centre of the circle through start, end and a point between them; None where they lie on a line."""
    chord = end[:2] - start[:2]
    length = math.hypot(*chord)
    if length == 0.0:
        return None
    along = chord / length
    across = np.array([-along[1], along[0]])
    half = 0.5 * (start[:2] + end[:2])
    u, v = float(along @ (middle[:2] - half)), float(across @ (middle[:2] - half))
    if v == 0.0:
        return None
    return np.asarray(half + across * (u * u + v * v - 0.25 * length * length) / (2.0 * v))


def _centre_of_radius(start: FloatArray, end: FloatArray, radius: float, sense: float) -> NDArray[np.float64] | None:
    """Centre of the arc of less than half a turn that a control makes of R; None where R is too small."""
    chord = end[:2] - start[:2]
    length = math.hypot(*chord)
    if length == 0.0 or radius < 0.5 * length:
        return None
    rise = sense * math.sqrt(radius * radius - 0.25 * length * length) / length
    return np.asarray(0.5 * (start[:2] + end[:2]) + rise * np.array([-chord[1], chord[0]]))


class ArcBlocks(NamedTuple):
    """positions: (n_axes, n), where the points are reached, those in the midst of a block on its arc. ends: (n,),
    whether each is the end of a block. arcs: for the indices of points that end an arc, the arc.
    """

    positions: FloatArray
    ends: NDArray[np.bool_]
    arcs: dict[int, Piece]

    def blocks(self, shares: FloatArray) -> tuple[NDArray[np.int64], FloatArray, dict[int, Piece]]:
        """Indices of the points that end blocks, the share of time of each block, and the arcs by number of the block;
        shares: of each point.
        """
        at = np.flatnonzero(self.ends)
        if at.size == shares.size:
            return at, shares, self.arcs
        summed = np.add.reduceat(shares, np.concatenate([[0], at[:-1] + 1]))
        return at, summed, {int(np.searchsorted(at, point)): piece for point, piece in self.arcs.items()}


def arc_blocks(
    moves: Iterable[tuple[int, Move]],
    owner: NDArray[np.int64],
    written: FloatArray,
    wanted: FloatArray,
    previous: FloatArray | None,
    steps: FloatArray,
    axes: tuple[str, ...],
    settings: Settings,
) -> ArcBlocks:
    """Join points of arcs to arcs where they lie on some.

    moves: with their indices. owner: (n,), move of each point, ascending. written, wanted: (n_axes, n), as the words
    name them and before rounding, mm and deg. previous: (n_axes,), position named by the words before; None: it is not
    certain. steps: (n_axes, n), of words.
    """
    ends = np.ones(owner.size, dtype=bool)
    arcs: dict[int, Piece] = {}
    positions = written
    if not set(LINEAR) <= set(axes):
        return ArcBlocks(positions, ends, arcs)
    rows = [axes.index(axis) for axis in LINEAR]
    rotary = list(rotary_rows(axes))
    for index, move in moves:
        if move.round is None or move.arc is None or any(move.held):
            continue
        first, last = np.searchsorted(owner, [index, index + 1])
        start = previous if first == 0 else written[:, first - 1]
        if start is None or last - first < FEWEST_CHORDS:
            continue
        if rotary and (written[rotary, first:last] != start[rotary, None]).any():
            continue
        found, places = pieces_of(
            move.arc, start[rows], written[rows, first:last], wanted[rows, first:last], move.round.centre,
            float(steps[rows[0], first]), SHARE * settings.tolerance,
        )  # fmt: skip
        if positions is written:
            positions = written.copy()
        positions[rows, first:last] = places
        for piece in found:
            if piece.centre is not None:
                ends[first + piece.first : first + piece.last - 1] = False
                arcs[int(first + piece.last - 1)] = piece
    return ArcBlocks(positions, ends, arcs)
