"""Notes on moves whose words are not what one might expect."""

import numpy as np

from trueaxis.compensation.machine import FloatArray, linear_rows, rotary_rows
from trueaxis.compensation.moves import Kind, Notes
from trueaxis.compensation.path import Held, MoveTable, alike

HELD = (
    "gets no word here, and its error is left: the program has not commanded it to a position since its start, "
    "or since the last tool change or stop"
)
TURNS_ALONE = (
    "a feed block of rotary axes alone gets words of linear axes too: some controls then read its F as a feed in mm/min"
)


def note_held(moves: MoveTable, held: Held, axes: tuple[str, ...], notes: Notes) -> None:
    """Note axes that get no word; held: (n_axes, n_moves)."""
    for some in alike(held):
        names = " ".join(axis for axis, stays in zip(axes, held[:, some[0]], strict=True) if stays)
        notes.add(int(moves.lines[some[0]]), f"{names} {HELD}", some.size)


def note_turns(moves: MoveTable, start: FloatArray, axes: tuple[str, ...], notes: Notes) -> None:
    """Note feed blocks whose F may be read differently once they have words of linear axes."""
    linear, rotary = list(linear_rows(axes)), list(rotary_rows(axes))
    if not rotary:
        return
    ends = moves.ends
    way = np.abs(np.diff(np.concatenate([start[:, None], ends], axis=1), axis=1))
    alone = (way[linear] == 0.0).all(axis=0) & (way[rotary] > 0.0).any(axis=0)
    for line in moves.lines[alone & (moves.motion == Kind.LINE)].tolist():
        notes.add(line, TURNS_ALONE)
