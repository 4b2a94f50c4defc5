"""From moves to the points of the path: arcs cut into chords, every point with its block."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.arcs import chords
from trueaxis.compensation.machine import LINEAR, FloatArray
from trueaxis.compensation.move_table import MoveTable


@dataclass(frozen=True, slots=True, kw_only=True)
class Path:
    """Points to be reached one after another, each by a straight motion of the axes from `origins`.

    points, origins: (n_axes, n), mm and deg. owner: (n,), index of the move that a point belongs to, ascending.
    rapid: (n,), where only the end counts. halts: (n,), motions of no length in which an axis takes up what its
    reversal changes.
    """

    points: FloatArray
    origins: FloatArray
    owner: NDArray[np.int64]
    rapid: NDArray[np.bool_]
    halts: NDArray[np.bool_]

    @property
    def size(self) -> int:
        """Number of points."""
        return int(self.owner.size)


def path_of(moves: MoveTable, start: FloatArray, axes: tuple[str, ...], chord_tolerance: float) -> Path:
    """Points of the moves; `start` (n_axes,) is the position before them, NaN where it is not known.

    Where a move starts is not known either where its axes stand only where the program has not commanded them to.
    """
    ends = moves.ends
    starts = np.concatenate([start[:, None], ends[:, :-1]], axis=1)
    rapid, stated = moves.rapid, moves.start_stated
    of_index = {index: move.arc for index, move in moves.singles() if move.arc is not None}
    arcs = np.array(list(of_index), dtype=np.int64)
    if arcs.size == 0:
        starts[:, stated] = np.nan
        return Path(points=ends, origins=starts, owner=np.arange(len(moves)), rapid=rapid, halts=np.zeros_like(rapid))

    def xyz(positions: FloatArray) -> FloatArray:
        out = np.zeros((3, positions.shape[1]))
        for row, axis in enumerate(axes):
            if axis in LINEAR:
                out[LINEAR.index(axis)] = positions[row]
        return out

    cut = chords(
        xyz(starts[:, arcs]),
        xyz(ends[:, arcs]),
        list(of_index.values()),
        chord_tolerance,
    )
    of_arc = arcs[cut.arc]
    on_arcs = np.empty((len(axes), of_arc.size))
    for row, axis in enumerate(axes):
        if axis in LINEAR:
            on_arcs[row] = cut.points[LINEAR.index(axis)]
        else:
            on_arcs[row] = starts[row, of_arc] + cut.share * (ends[row, of_arc] - starts[row, of_arc])
    straight = np.setdiff1d(np.arange(len(moves)), arcs, assume_unique=True)
    owner = np.concatenate([straight, of_arc])
    order = np.argsort(owner, kind="stable")
    points = np.concatenate([ends[:, straight], on_arcs], axis=1)[:, order]
    owner = owner[order]
    origins = np.concatenate([start[:, None], points[:, :-1]], axis=1)
    origins[:, stated[owner]] = np.nan  # such a move is no arc in G90: it has one point
    return Path(points=points, origins=origins, owner=owner, rapid=rapid[owner], halts=np.zeros(owner.size, dtype=bool))
