"""From moves to the points of the path: arcs cut into chords, every point with its block."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.arcs import chords
from trueaxis.compensation.machine import LINEAR, FloatArray
from trueaxis.compensation.moves import Kind, Move


@dataclass(frozen=True, slots=True)
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


def path_of(moves: Sequence[Move], start: FloatArray, axes: tuple[str, ...], chord_tolerance: float) -> Path:
    """Points of the moves; `start` (n_axes,) is the position before them, NaN where it is not known.

    Where a move starts is not known either where its axes stand only where the program has not commanded them to.
    """
    ends = np.array([move.end for move in moves], dtype=np.float64).T
    starts = np.concatenate([start[:, None], ends[:, :-1]], axis=1)
    rapid = np.array([move.kind == Kind.RAPID for move in moves])
    stated = np.array([move.start_stated for move in moves])
    arcs = np.array([index for index, move in enumerate(moves) if move.arc is not None], dtype=np.int64)
    if arcs.size == 0:
        starts[:, stated] = np.nan
        return Path(ends, starts, np.arange(len(moves)), rapid, np.zeros_like(rapid))

    def xyz(positions: FloatArray) -> FloatArray:
        out = np.zeros((3, positions.shape[1]))
        for row, axis in enumerate(axes):
            if axis in LINEAR:
                out[LINEAR.index(axis)] = positions[row]
        return out

    cut = chords(
        xyz(starts[:, arcs]),
        xyz(ends[:, arcs]),
        [arc for index in arcs if (arc := moves[index].arc) is not None],
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
    return Path(points, origins, owner, rapid[owner], np.zeros(owner.size, dtype=bool))


def follows_at_once(batch: list[str | Move], following: Move | None) -> NDArray[np.bool_]:
    """For each move of a batch whether another follows at once and the tool may run through the end between them."""
    return np.array(
        [
            not isinstance(after, str) and after is not None and item.passable and after.passable
            for item, after in zip(batch, [*batch[1:], following], strict=True)
            if not isinstance(item, str)
        ]
    )
