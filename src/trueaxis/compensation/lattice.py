"""The positions that NC words can name; words that would lead out of the travel stop at its end, programmed positions
outside it are faults.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import columns_of
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import LINEAR, ErrorModel, FloatArray, PointControlled, linear_rows, rotary_rows
from trueaxis.compensation.moves import Notes
from trueaxis.compensation.path import Held, MoveTable, Path, alike
from trueaxis.compensation.settings import MM_PER_INCH, Settings
from trueaxis.compensation.subdivide import probe_count

_SAME = 1e-6  # of a step: what doubles lose in positions of the lattice


@dataclass(frozen=True, slots=True)
class Lattice:
    """Positions base + k step, k whole, of every axis; base and step are (n_axes, 1), mm or deg."""

    base: FloatArray
    step: FloatArray

    def nearest(self, positions: FloatArray, parts: int = 1) -> FloatArray:
        """Nearest position of the lattice, or of the one with steps divided by `parts`."""
        fine = self.step / parts
        return np.asarray(self.base + fine * np.rint((positions - self.base) / fine))

    def within(self, positions: FloatArray, low: FloatArray, high: FloatArray) -> FloatArray:
        """Positions of the lattice, those outside low to high (n_axes, 1) moved to the last one inside."""
        out = (positions < low - _SAME * self.step) | (positions > high + _SAME * self.step)
        if not out.any():
            return positions
        first = np.ceil((low - self.base) / self.step - _SAME)
        last = np.floor((high - self.base) / self.step + _SAME)
        return np.asarray(
            np.where(out, np.clip(positions, *(self.base + self.step * k for k in (first, last))), positions)
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Stretch:
    """Points first to last - 1, whose words are of one kind; step as in Lattice. shift: (n_axes,), position minus word
    of absolute words.
    """

    first: int
    last: int
    absolute: bool
    step: FloatArray
    shift: FloatArray

    def base(self, previous: FloatArray) -> FloatArray:
        """What words count from, (n_axes,); previous: position named by the words before."""
        return self.shift if self.absolute else previous


def word_steps(axes: tuple[str, ...], settings: Settings, inch: bool) -> FloatArray:
    """Step of each axis' words in mm or deg, (n_axes, 1)."""
    linear = settings.inch_step * MM_PER_INCH if inch else settings.resolution
    return np.array([[linear if axis in LINEAR else settings.rotary_resolution] for axis in axes])


def stretches(
    absolute: NDArray[np.bool_],
    inch: NDArray[np.bool_],
    shift: FloatArray,
    axes: tuple[str, ...],
    settings: Settings,
) -> Iterator[Stretch]:
    """Runs of points between switches of G90/G91, G20/G21 and offsets; shift: (n_axes, n), of absolute words."""
    kind = absolute * 2 + inch
    switched = (np.diff(kind) != 0) | (np.diff(shift, axis=1) != 0.0).any(axis=0)
    edges = [0, *(np.flatnonzero(switched) + 1).tolist(), kind.size]
    steps = {flag: word_steps(axes, settings, flag) for flag in (False, True)}
    for first, last in pairwise(edges):
        yield Stretch(
            first=first, last=last, absolute=bool(absolute[first]), step=steps[bool(inch[first])], shift=shift[:, first]
        )


def rotary_on_words(
    positions: FloatArray, kinds: Iterable[Stretch], previous: FloatArray, axes: tuple[str, ...]
) -> FloatArray:
    """The positions (n_axes, n) with those of rotary axes as their words name them.

    previous: (n_axes,), what the words before name; increments are counted from there.
    """
    rows = list(rotary_rows(axes))
    out = positions.copy()
    last = previous[rows]
    for kind in kinds:
        part = slice(kind.first, kind.last)
        base = kind.shift[rows] if kind.absolute else last
        out[rows, part] = Lattice(base[:, None], kind.step[rows]).nearest(positions[rows, part])
        last = out[rows, kind.last - 1]
    return out


def unplaced_tips(path: Path, elsewhere: Held, axes: tuple[str, ...]) -> NDArray[np.bool_]:
    """Points (n,) of the tip, under tool centre point control, from which it is not known where the linear axes stand:
    an axis may stand anywhere, and rotary axes are turned. elsewhere: (n_axes, n).
    """
    rows = [row for row, axis in enumerate(axes) if axis not in LINEAR]
    turned = (path.points[rows] != 0.0).any(axis=0) | (path.origins[rows] != 0.0).any(axis=0)
    return np.asarray(elsewhere.any(axis=0) & turned)


UNPLACED_TIP = (
    "where {} stands is not known, and with rotary axes turned the linear axes stand by it under tool centre point "
    "control: whether they stay within their travel on this rapid is not checked. X Y Z in one block behind the switch"
)
_ROUNDING = 1e-9  # mm, deg: what doubles lose


def note_outside(
    moves: MoveTable, path: Path, model: ErrorModel, tool_point: FloatArray, faults: FaultLog, notes: Notes
) -> None:
    """Faults of programmed positions, those along arcs too, that are outside the travel; once a block, and where an
    axis comes to such a position, not where it stays there. None where it is not known where positions are.

    tool_point: (3, 1), which says where the axes are under tool centre point control. Their way is no straight line
    then, and is looked at all along; where it is not known, that is noted.
    """
    positions, owner = path.points, path.owner
    unknown = np.zeros(len(moves), dtype=bool)  # where the linear axes stand
    if isinstance(model, PointControlled):
        faults.by_tip = True
        elsewhere = columns_of(moves.elsewhere, owner)
        unplaced = unplaced_tips(path, elsewhere, model.axes)
        for index in alike(elsewhere & unplaced):
            names = " ".join(axis for axis, free in zip(model.axes, elsewhere[:, index[0]], strict=True) if free)
            notes.warn(int(moves.lines[owner[index[0]]]), UNPLACED_TIP.format(names), np.unique(owner[index]).size)
        unknown[owner[unplaced]] = True
        positions, owner = _passed(path, model, tool_point)
        model = model.base
    low, high = _limits(model)
    _note_reach(positions[:, ~(moves.in_machine | unknown)[owner]], model.axes, faults)
    outside = (positions < low - _ROUNDING) | (positions > high + _ROUNDING)
    outside[list(linear_rows(model.axes))] &= ~unknown[owner]
    if positions is path.points:
        outside &= path.points != path.origins
    points, lines = np.flatnonzero(outside.any(axis=0)), moves.lines
    shift = moves.shift if points.size else np.zeros((0, 0))
    for point in points[np.unique(owner[points], return_index=True)[1]]:
        row = int(np.argmax(outside[:, point]))
        axis, line = model.axes[row], int(lines[owner[point]])
        if faults.unplaced is not None and line >= faults.unplaced:
            return
        faults.outside[axis] += 1
        offset = float(shift[row, owner[point]])
        faults.add(
            line,
            f"{axis} = {positions[row, point]:g} is outside its travel",
            f"from {low[row, 0]:g} to {high[row, 0]:g}"
            + (f"; {offset:.9g} of it are the work offset, shifts and the length of the tool" if offset else ""),
        )


def _note_reach(positions: FloatArray, axes: tuple[str, ...], faults: FaultLog) -> None:
    """Take in how far each axis goes; positions: (n_axes, n), mm and deg."""
    for axis, of_axis in zip(axes, positions, strict=True):
        before = faults.reach.get(axis, (np.inf, -np.inf))
        low, high = float(of_axis.min(initial=np.inf)), float(of_axis.max(initial=-np.inf))
        faults.reach[axis] = (min(before[0], low), max(before[1], high))


def inside_travel(
    positions: FloatArray, lattice: Lattice, model: ErrorModel, tool_point: FloatArray, unplaced: NDArray[np.bool_]
) -> FloatArray:
    """Positions of words, (n_axes, n), those that lead out of the travel moved to where all axes are inside; unplaced:
    (n,), those of which that is not known.

    Under tool centre point control the tip goes to where the control puts the axes at the end of their travel.
    """
    low, high = _limits(model)
    positions = lattice.within(positions, low, high)
    if not isinstance(model, PointControlled):
        return positions
    low, high = _limits(model.base)
    at = model.axis_positions(positions, tool_point)
    out = ((at < low - _ROUNDING) | (at > high + _ROUNDING)).any(axis=0)
    out &= ~unplaced
    if not out.any():
        return positions
    rows = list(linear_rows(model.axes))
    room = np.zeros_like(low)
    room[rows] = 0.5 * np.sqrt((lattice.step[rows] ** 2).sum())  # what rounding of words moves an axis by at most
    tips = lattice.nearest(model.tip_positions(np.clip(at, low + room, high - room), tool_point))
    inside = positions.copy()
    inside[rows] = np.where(out, tips[rows], positions[rows])
    return inside


def _limits(model: ErrorModel) -> tuple[FloatArray, FloatArray]:
    """Lowest and highest positions, each (n_axes, 1)."""
    limits = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64)
    return limits[:, :1], limits[:, 1:]


def _passed(path: Path, model: PointControlled, tool_point: FloatArray) -> tuple[FloatArray, NDArray[np.int64]]:
    """Axis positions along the motions and where an axis turns on its way, (n_axes, m), and the move of each."""
    origins = np.where(np.isfinite(path.origins).all(axis=0), path.origins, path.points)
    span = path.points - origins
    count = probe_count(np.sqrt((span**2).sum(axis=0))) + 1
    motion = np.repeat(np.arange(path.size), count)
    share = (np.arange(motion.size) - (np.cumsum(count) - count)[motion] + 1) / count[motion]
    at = model.axis_positions(origins[:, motion] + share * span[:, motion], tool_point)
    inner = np.flatnonzero((motion[:-2] == motion[1:-1]) & (motion[1:-1] == motion[2:])) + 1
    before, here, after = (at[:, inner + step] for step in (-1, 0, 1))
    # the vertex of the parabola through three samples, where the middle one is the farthest of them
    turns = (here - before) * (here - after) > 0.0
    bend = np.where(turns, 2.0 * here - before - after, 1.0)
    vertex = np.where(turns, here + (after - before) ** 2 / (8.0 * bend), here)
    return np.concatenate([at, vertex], axis=1), path.owner[np.concatenate([motion, motion[inner]])]
