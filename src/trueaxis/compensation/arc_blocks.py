"""Which of the points that a batch reaches are ends of blocks, where arcs stay arcs."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.kept_arcs import FEWEST_CHORDS, SHARE, Piece, pieces_of
from trueaxis.compensation.machine import LINEAR, FloatArray, rotary_rows
from trueaxis.compensation.moves import Move
from trueaxis.compensation.settings import Settings


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
