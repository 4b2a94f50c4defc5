"""Divides a program: into batches of about as many points, so that its length does not matter to memory, and straight
motions where the errors along them are not straight enough.
"""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.arc_chords import few_counts
from trueaxis.compensation.columns import MOST_CHORDS, PlainRun, chord_counts, columns_of
from trueaxis.compensation.course import Placing
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import LINEAR, ErrorModel, FloatArray, linear_rows
from trueaxis.compensation.moves import Between, Item, Move
from trueaxis.compensation.path import Path
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.solve import ToolAxis, angle


class Along(Protocol):
    """What subdivision asks of positions (n_axes, n) along motions."""

    def correction(self, model: ErrorModel, positions: FloatArray) -> FloatArray:
        """First correction of the axes, (n_axes, n), mm and deg; model: the machine at those positions."""

    def apart(self, positions: FloatArray, correction: FloatArray, straight: FloatArray) -> FloatArray:
        """How far two corrections lie apart, (n,), in shares of what is allowed between words."""


@dataclass(frozen=True, slots=True)
class PointAlong:
    """The tool point alone, by the linear axes; tolerance mm."""

    axes: tuple[str, ...]
    tool_point: FloatArray
    tolerance: float

    def correction(self, model: ErrorModel, positions: FloatArray) -> FloatArray:
        """Eq. (55) once."""
        return model.correction(positions, -model.deviation(positions, self.tool_point))

    def apart(self, positions: FloatArray, correction: FloatArray, straight: FloatArray) -> FloatArray:  # noqa: ARG002
        """By the linear axes."""
        rows = list(linear_rows(self.axes))
        return np.asarray(np.sqrt(((correction[rows] - straight[rows]) ** 2).sum(axis=0)) / self.tolerance)


@dataclass(frozen=True, slots=True, kw_only=True)
class PoseAlong:
    """Tool point and tool axis, by all axes; tolerance mm, orientation_tolerance rad."""

    model: ErrorModel
    tool_point: FloatArray
    tool_axis: ToolAxis
    tolerance: float
    orientation_tolerance: float

    def correction(self, model: ErrorModel, positions: FloatArray) -> FloatArray:
        """The turns of the rotary axes, then Eq. (55), once."""
        error = self.tool_axis.wanted(positions) - self.tool_axis.on(model).actual(positions)
        turned = positions + self.tool_axis.turning(positions).step(positions, error)[0]
        off = self._ideal(positions) - self._ideal(turned) - model.deviation(turned, self.tool_point)
        return np.asarray(turned - positions + model.correction(turned, off))

    def apart(self, positions: FloatArray, correction: FloatArray, straight: FloatArray) -> FloatArray:
        """By tool point and tool axis, whichever is the larger share."""
        here, there = positions + correction, positions + straight
        point = np.sqrt(((self._ideal(here) - self._ideal(there)) ** 2).sum(axis=0))
        axis = angle(self.tool_axis.wanted(here), self.tool_axis.wanted(there))
        return np.asarray(np.maximum(point / self.tolerance, axis / self.orientation_tolerance))

    def _ideal(self, positions: FloatArray) -> FloatArray:
        return self.model.ideal(positions, self.tool_point)


PROBE_SPACING = 2.5  # mm (deg); finer than the pitch of ball screws and scales, whose errors are the shortest waves
SHARE = 0.25  # of the tolerance, allowed between the errors of a motion and the straight line between its ends
ARC_SHARE = 0.1  # the same along a chord of an arc that is to stay one: the points have the rest, see kept_arcs.py
SHORTEST = 0.05  # mm (deg); what is shorter is not cut: a jump in the errors cannot be followed by cutting
PROBES_AT_ONCE = 65536
# of the chords of an arc that may stay one, how many count as points: a batch has no more than four times as many
OF_ALL_CHORDS = 0.25


def subdivide(
    path: Path, along: Along, placing: Placing, of_arcs: NDArray[np.bool_]
) -> tuple[Path, Placing, NDArray[np.int64]]:
    """Bisect feed motions until, at every probe, the correction of the axes differs from the one interpolated
    between the ends by at most `SHARE` of the tolerance.

    A motion is probed at an odd number of places no more than `PROBE_SPACING` apart, its middle always among them. The
    correction is the first step of Eq. (55); interpolation is what the control does with the words of both ends.
    Rapid motions and those from an unknown start are left whole, and so are chords of arcs that are to stay some,
    of_arcs: (n,). Returns the pieces, the machine along them, and the moves whose arcs have too few chords: the
    correction differs by more than `ARC_SHARE` along one.
    """
    whole = path.rapid | ~np.isfinite(path.origins).all(axis=0)
    length = np.where(whole, 0.0, np.sqrt(((path.points - path.origins) ** 2).sum(axis=0)))
    owner = np.flatnonzero(length > SHORTEST)
    if owner.size == 0:
        return path, placing, owner
    low = np.zeros(owner.size)
    high = np.ones(owner.size)
    of_arc = of_arcs[owner]
    too_few = np.zeros(0, dtype=np.int64)
    cut_owner: list[NDArray[np.int64]] = []
    cut_share: list[FloatArray] = []
    while owner.size:
        bends = np.concatenate(
            [
                _bends(path, along, placing, owner[part], low[part], high[part])
                for part in _parts(length[owner] * (high - low))
            ]
        )
        if of_arc.any():
            too_few = np.unique(path.owner[owner[of_arc & (bends > ARC_SHARE)]])
            if too_few.size:
                return path, placing, too_few
        bent = (bends > SHARE) & ~of_arc & (length[owner] * (high - low) > 2.0 * SHORTEST)
        of_arc = np.zeros(2 * int(bent.sum()), dtype=bool)
        owner, low, high = owner[bent], low[bent], high[bent]
        middle = 0.5 * (low + high)
        cut_owner.append(owner)
        cut_share.append(middle)
        owner = np.concatenate([owner, owner])
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
    return *_cut(path, placing, np.concatenate(cut_owner), np.concatenate(cut_share)), too_few


def probe_count(length: FloatArray) -> NDArray[np.int64]:
    """Probes along motions of that length, mm or deg, (n,): odd, so that the middle is one."""
    return np.maximum(np.ceil(length / PROBE_SPACING), 1.0).astype(np.int64) | 1


def _parts(length: FloatArray) -> list[slice]:
    """Runs of motions that need about `PROBES_AT_ONCE` probes each."""
    total = np.cumsum(probe_count(length) + 2)
    edges = [0]
    while edges[-1] < length.size:
        before = total[edges[-1] - 1] if edges[-1] else 0
        edges.append(max(edges[-1] + 1, int(np.searchsorted(total, before + PROBES_AT_ONCE))))
    return [slice(a, b) for a, b in pairwise(edges)]


def _bends(
    path: Path,
    along: Along,
    placing: Placing,
    owner: NDArray[np.int64],
    low: FloatArray,
    high: FloatArray,
) -> FloatArray:
    """By how much of what is allowed the correction along path[owner] between the shares low and high leaves the
    straight line.
    """
    origin, point = columns_of(path.origins, owner), columns_of(path.points, owner)
    span = point - origin
    at_low, at_high = (
        along.correction(placing.at(owner, share), origin + share * span) for share in (low, high)
    )  # fmt: skip
    count = probe_count(np.sqrt((span**2).sum(axis=0)) * (high - low))
    first = np.cumsum(count) - count
    # which motion each probe belongs to: most have but one, and need no copies
    of = slice(None) if count.max() == 1 else np.repeat(np.arange(owner.size), count)
    share = (np.arange(1, count.sum() + 1) - first[of]) / (count + 1)[of]
    place = low[of] + share * (high - low)[of]
    positions = columns_of(origin, of) + place * columns_of(span, of)
    correction = along.correction(placing.at(owner[of], place), positions)
    straight = columns_of(at_low, of) + share * columns_of(at_high - at_low, of)
    return np.asarray(np.maximum.reduceat(along.apart(positions, correction, straight), first))


def _cut(path: Path, placing: Placing, owner: NDArray[np.int64], share: FloatArray) -> tuple[Path, Placing]:
    """The path with further points at the shares of the motions given."""
    if owner.size == 0:
        return path, placing
    origins = columns_of(path.origins, owner)
    inserted = origins + share * (columns_of(path.points, owner) - origins)
    motion = np.concatenate([owner, np.arange(path.size)])
    high = np.concatenate([share, np.ones(path.size)])
    order = np.lexsort((high, motion))
    points = columns_of(np.concatenate([inserted, path.points], axis=1), order)
    motion, high = motion[order], high[order]
    low = np.where(np.diff(motion, prepend=-1) > 0, 0.0, np.roll(high, 1))
    origins = np.concatenate([path.origins[:, :1], points[:, :-1]], axis=1)
    return Path(
        points=points, origins=origins, owner=path.owner[motion], rapid=path.rapid[motion], halts=path.halts[motion]
    ), placing.cut(motion, low, high)


class Batch(NamedTuple):
    """following: the move after the batch, if one follows at once; between: what is said after it, if anything."""

    items: list[str | Move | PlainRun]
    following: Move | PlainRun | None = None
    between: Between | None = None


def batches(
    items: Iterable[Item | PlainRun], axes: tuple[str, ...], settings: Settings, faults: FaultLog, arcs_stay: bool
) -> Iterator[Batch]:
    """The items of a program; faults of arcs of too many chords. arcs_stay: whether arcs may stay some."""
    batch: list[str | Move | PlainRun] = []
    load = 0.0  # points: moves may be cut as finely as they are probed
    last: tuple[float, ...] | None = None
    most = settings.batch_points
    for whole in items:
        for item, points in _parts_of(whole, max(most - load, 1.0), axes, (settings, arcs_stay), faults):
            if load >= most:
                yield Batch(batch, item if isinstance(item, Move | PlainRun) else None)
                batch, load = [], 0.0
            if isinstance(item, Between):
                yield Batch(batch, between=item)
                batch, load = [], 0.0
                continue
            batch.append(item)
            load += points
            if isinstance(item, Move):
                if item.kind and last is not None:
                    load += math.dist(last, item.end) / PROBE_SPACING
                last = item.end
            elif isinstance(item, PlainRun):
                last = tuple(item.ends[:, -1].tolist())
    yield Batch(batch)


def _parts_of(
    item: Item | PlainRun, room: float, axes: tuple[str, ...], of_arcs: tuple[Settings, bool], faults: FaultLog
) -> Iterator[tuple[Item | PlainRun, float]]:
    """An item, a run in parts of as many points as a batch has, and about how many points each takes; room: points
    until the batch has as many; of_arcs: settings, and whether arcs may stay some.
    """
    settings, arcs_stay = of_arcs
    if isinstance(item, PlainRun):
        rows = [axes.index(axis) for axis in LINEAR if axis in axes]
        radii = item.radii(rows)
        chords = chord_counts(radii, item.arcs.sweep, settings.chord_tolerance)
        few = chords <= MOST_CHORDS
        for line, count in zip(item.line[item.arcs.index[~few]].tolist(), chords[~few].tolist(), strict=True):
            faults.add(line, *_too_many(count))
        run = item if few.all() else replace(item, arcs=item.arcs.some(few))  # only to read on
        loads = run.loads(None, PROBE_SPACING, _loads_of_arcs(radii, item.arcs.sweep, chords, arcs_stay)[few])
        yield from run.parts(loads, settings.batch_points, room)
    elif isinstance(item, Move) and item.arc is not None:
        at = dict(zip(axes, item.end, strict=True))
        radius = math.dist([at.get(axis, 0.0) for axis in LINEAR], item.arc.centre)  # with its rise; a bound
        size = np.array(radius), np.array(item.arc.sweep)
        count = chord_counts(*size, settings.chord_tolerance)
        if count > MOST_CHORDS:
            faults.add(item.line, *_too_many(int(count)))
        yield (item if count <= MOST_CHORDS else item.as_line()), 1.0 + float(_loads_of_arcs(*size, count, arcs_stay))
    else:
        yield item, 1.0


def _loads_of_arcs(radius: FloatArray, sweep: FloatArray, most: NDArray[np.int64], stay: bool) -> FloatArray:
    """About how many points arcs take, each (n,): few where they may stay arcs; all where they prove to be none,
    `most`, for which memory is to be bounded too.
    """
    if not stay:
        return most.astype(np.float64)
    return np.asarray(np.maximum(few_counts(radius, sweep, most) - 1.0, OF_ALL_CHORDS * most))  # the block is one


def _too_many(chords: int) -> tuple[str, str]:
    return f"the arc takes {chords} chords", "say a larger --chord-tolerance"
