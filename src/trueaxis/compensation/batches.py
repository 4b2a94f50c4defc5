"""A program in batches of about as many points, so that its length does not matter to memory."""

import math
from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np

from trueaxis.compensation.arcs import MOST_CHORDS, Arc, chord_counts
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import LINEAR
from trueaxis.compensation.moves import Item, Move, Setup, Start, Zero
from trueaxis.compensation.nc_plain import PlainRun
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.subdivide import PROBE_SPACING


class Batch(NamedTuple):
    """following: the move after the batch, if one follows at once; between: what is said after it, if anything."""

    items: list[str | Move | PlainRun]
    following: Move | PlainRun | None = None
    between: Start | Zero | Setup | None = None


def batches(
    items: Iterable[Item | PlainRun], axes: tuple[str, ...], settings: Settings, faults: FaultLog
) -> Iterator[Batch]:
    """The items of a program; faults of arcs of too many chords."""
    batch: list[str | Move | PlainRun] = []
    load = 0  # points: moves may be cut as finely as they are probed
    last: tuple[float, ...] | None = None
    for item in _parts(items, settings.batch_points):
        if load >= settings.batch_points:
            yield Batch(batch, item if isinstance(item, Move | PlainRun) else None)
            batch, load = [], 0
        if isinstance(item, Start | Zero | Setup):
            yield Batch(batch, between=item)
            batch, load = [], 0
        elif isinstance(item, PlainRun):
            batch.append(item)
            load += item.count + int(item.ways(last).sum() / PROBE_SPACING)
            last = tuple(item.ends[:, -1].tolist())
        elif isinstance(item, Move):
            chords = _chords(item, item.arc, axes, settings) if item.arc is not None else 0
            if chords > MOST_CHORDS:
                faults.add(item.line, f"the arc takes {chords} chords", "say a larger --chord-tolerance")
            batch.append(item if chords <= MOST_CHORDS else item.as_line())  # only to read on
            load += 1 + chords
            if item.kind and last is not None:
                load += int(math.dist(last, item.end) / PROBE_SPACING)
            last = item.end
        else:
            batch.append(item)
            load += 1
    yield Batch(batch)


def _parts(items: Iterable[Item | PlainRun], most: int) -> Iterator[Item | PlainRun]:
    """The items, with runs in parts of no more points than a batch may have."""
    for item in items:
        if isinstance(item, PlainRun):
            yield from item.parts(max(1, int(most / (1.0 + item.ways().max() / PROBE_SPACING))))
        else:
            yield item


def _chords(move: Move, arc: Arc, axes: tuple[str, ...], settings: Settings) -> int:
    at = dict(zip(axes, move.end, strict=True))
    radius = math.dist([at.get(axis, 0.0) for axis in LINEAR], arc.centre)  # with its rise; a bound
    return int(chord_counts(np.array(radius), np.array(arc.sweep), settings.chord_tolerance))
