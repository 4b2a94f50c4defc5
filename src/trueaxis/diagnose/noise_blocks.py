"""Readings that tell of the noise: targets that are read more than once, or the course of a run by itself."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre

from trueaxis.diagnose.base import Base
from trueaxis.diagnose.result import BoolArray, FloatArray, IntArray
from trueaxis.diagnose.rows import Rows
from trueaxis.estimation.runs import MeasuredRun

TARGETS = 40  # of a block: neighbours in the order of reading; the cost grows with their cube
COURSE = 12  # degree of a run's own course, where nothing is repeated
PER_DEGREE = 6  # readings of a run for each of them
STRAIGHT = 1e-3  # of the length of a line: what targets may lie beside it


@dataclass(frozen=True, slots=True, eq=False)
class Block:
    """Readings that tell of the noise. parts: of each run its place among the runs, its rows in the block and the time
    steps between these; free: (n, k), columns that may be anything; values: (n,), mm; lasting: in typical steps, the
    longest that its noise may last: what lasts longer the free columns hold.
    """

    parts: tuple[tuple[int, slice, FloatArray], ...]
    free: FloatArray
    values: FloatArray
    lasting: float

    @property
    def freedom(self) -> int:
        """At least so many degrees of freedom."""
        return int(self.values.size - self.free.shape[1])


def repeated(rows: Rows, base: Base, values: FloatArray, members: Sequence[int]) -> Iterator[Block]:
    """Blocks of neighbouring targets that were read more than once with one set-up; first ones of all set-ups first."""
    of_setup: dict[int, list[int]] = {}
    for place in members:
        of_setup.setdefault(int(rows.setup[base.runs[place].rows.at[0]]), []).append(place)
    waiting = [_targets(rows, base, places) for places in of_setup.values()]
    for turn in range(max(map(len, waiting), default=0)):
        for places, targets in zip(of_setup.values(), waiting, strict=True):
            if turn < len(targets):
                yield _of_targets(rows, base, values, places, targets[turn])


def _targets(rows: Rows, base: Base, places: Sequence[int]) -> list[IntArray]:
    """Targets that are read more than once, in the order of the first reading, TARGETS at a time."""
    numbers = np.concatenate([rows.target[base.runs[place].rows.at] for place in places])
    unique, first, count = np.unique(numbers, return_index=True, return_counts=True)
    repeated = count > 1
    order = unique[repeated][np.argsort(first[repeated])]
    return [order[start : start + TARGETS] for start in range(0, order.size, TARGETS)]


def _of_targets(rows: Rows, base: Base, values: FloatArray, places: Sequence[int], targets: IntArray) -> Block:
    parts, at, own = [], [], []
    start = 0
    for place in places:
        chosen = np.isin(rows.target[base.runs[place].rows.at], targets)
        if chosen.any():
            part = slice(start, start + int(chosen.sum()))
            parts.append((place, part, _steps(base.runs[place], chosen)))
            at.append(base.runs[place].rows.at[chosen])
            own.append((part, base.own[place][chosen]))
            start = part.stop
    mine = np.concatenate(at)
    means = (rows.target[mine][:, np.newaxis] == targets).astype(np.float64)
    columns = [means[:, means.any(axis=0)]]
    for part, one in own:
        block = np.zeros((mine.size, one.shape[1]))
        block[part] = one
        columns.append(block)
    longest = max(float(np.sum(steps)) for _, _, steps in parts)
    return Block(tuple(parts), _independent(np.hstack(columns)), values[mine], longest)


def _steps(run: MeasuredRun, chosen: BoolArray) -> FloatArray:
    return np.diff(np.cumsum(run.rows.steps)[chosen], prepend=0.0)


def courses(rows: Rows, base: Base, values: FloatArray, members: Sequence[int]) -> Iterator[Block]:
    """Each run by itself, less a smooth course by direction."""
    for place in members:
        run = base.runs[place]
        count = run.rows.at.size
        degree = min(COURSE, count // PER_DEGREE)
        if degree < 1:
            continue
        if run.instrument != "ballbar" and not _on_a_line(run.rows.positions):
            continue
        leading = int(np.argmax(np.ptp(run.rows.positions, axis=1)))
        at, way = run.rows.positions[leading], rows.directions[leading, run.rows.at]
        turning = np.ptp(np.sign(np.gradient(at))) > 1.0 and run.instrument == "ballbar"
        along = run.rows.passed if turning or np.ptp(at) == 0.0 else (at - at.min()) / np.ptp(at)
        curve = legendre.legvander(2.0 * along - 1.0, (2 if turning else 1) * degree)
        sides = curve * way[:, np.newaxis] if np.unique(way).size > 1 and not turning else curve[:, :0]
        free = _independent(np.hstack([curve, sides, base.own[place]]))
        bend = float(np.sum(run.rows.steps)) / free.shape[1]
        yield Block(((place, slice(0, count), run.rows.steps),), free, values[run.rows.at], bend)


def _on_a_line(positions: FloatArray) -> bool:
    """Whether positions (n_axes, n) lie on one line: poses of several axes follow no course of their order."""
    singular = np.linalg.svd(positions - positions.mean(axis=1, keepdims=True), compute_uv=False)
    return bool((singular[1:] <= STRAIGHT * singular[0]).all())


def _independent(columns: FloatArray) -> FloatArray:
    """(n, rank): an orthonormal basis of columns."""
    sized = columns / np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
    left, singular, _ = np.linalg.svd(sized, full_matrices=False)
    return np.asarray(left[:, singular > 1e-9 * singular.max(initial=0.0)])
