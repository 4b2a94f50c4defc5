"""Readings that tell of the noise: what the saturated base leaves of them, run by run, repeats together.

The unknowns of each run's instrument are free, and so is the base. What the base gets wrong is the same in all readings
of a target, from one side, with one set-up; what differs between them is noise, whatever the model.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise, zip_longest

import numpy as np
from scipy.linalg import block_diag
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components

from trueaxis.diagnosis.null_model.base import Base
from trueaxis.diagnosis.null_model.projection import orthonormal
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.null_model.whiten import RANK, settling, wandering
from trueaxis.diagnosis.result import BoolArray, FloatArray, IntArray
from trueaxis.estimation.factors import decomposed
from trueaxis.estimation.instruments import BALL_OF_RUN
from trueaxis.estimation.noise_of_residuals import SMALLEST

MOST = 400  # readings that are looked at together; the cost grows with their cube
ENOUGH = 1500  # contrasts: they tell the noise to 2 %
GOLDEN = 0.6180339887498949  # its multiples, less whole numbers, are spread evenly
FAR = 5.0  # robust standard deviations: such readings tell nothing of the noise
HELD = 0.05  # of a reading's variance: where the free columns leave less, it says nothing of the noise
ALTERNATIONS = 5  # of two projections: a first guess needs no more
NORMAL_MEDIAN = 0.6744897501960817  # of the absolute value of a standard normal variable


@dataclass(frozen=True, slots=True, eq=False)
class Shapes:
    """Of a run of m readings, (m, m) of any two: gaps: typical steps between them; wander, settle, ball: their
    covariance of unit size.
    """

    gaps: FloatArray
    wander: FloatArray
    settle: FloatArray
    ball: FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Part:
    """Runs that read the same targets, or one run; of one instrument. rows: of its block; runs: of it, readings of each
    run, which are neighbours; of each of n readings: place: of its run among those of the base; target: of those of the
    part; passed: share of the duration of its run; when: typical steps since its start; own: (n, k), orthonormal, what
    is unknown of the instrument, the place of its ball aside; balls: (n_r, 3 or 0) of each run, by this; repeated: (n,
    targets), 1 where it is of a target that is read more than once; alone: (n,), whether it is of one that is read
    once.
    """

    rows: slice
    place: IntArray
    target: IntArray
    passed: FloatArray
    when: FloatArray
    own: FloatArray
    balls: tuple[FloatArray, ...]
    runs: tuple[slice, ...]
    repeated: FloatArray
    alone: BoolArray

    @property
    def alike(self) -> FloatArray:
        """(n, n): 1 where two readings are of one target."""
        return np.asarray(self.target[:, np.newaxis] == self.target, dtype=np.float64)

    def shapes(self) -> list[Shapes]:
        """Of each run. To be asked for once."""
        found = []
        for here, ball in zip(self.runs, self.balls, strict=True):
            course, walk, when = settling(self.passed[here]), wandering(self.passed[here]), self.when[here]
            gaps = np.abs(when[:, np.newaxis] - when)
            settle = np.outer(course, course)
            found.append(Shapes(gaps=gaps, wander=walk @ walk.T, settle=settle, ball=ball @ ball.T))
        return found


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Block:
    """Parts whose noise is told together. at: (n,), rows of the data; free: (n, k), the base beside what is unknown of
    each run: orthonormal, or by chance, one standard deviation each; values: (n,), mm.
    """

    parts: tuple[Part, ...]
    at: IntArray
    free: FloatArray
    values: FloatArray
    by_chance: bool = False

    def expecting(self, base: Base, times: float) -> "Block":
        """With errors of the machine by chance, so many times as large as expected."""
        columns = np.hstack([base.columns.at(self.at) * base.wide(times), base.by_chance[self.at]])
        directions, sizes, _ = decomposed(_less_own(self.parts, columns))
        seen = sizes > SMALLEST  # most curves are too small, or too much like others, to be seen at all
        return replace(self, free=directions[:, seen] * sizes[seen], by_chance=True)


@dataclass(frozen=True, slots=True, eq=False)
class Blocks:
    """Of some rows and their base, which is free. made: those that were asked for before: only the values change where
    the noise is told again beside causes.
    """

    rows: Rows
    base: Base
    made: dict[bytes, Block] = field(default_factory=dict)

    def of(self, values: FloatArray) -> Iterator[Block]:
        """Of about as many readings as tell the noise well enough, runs that are far apart first, repeated ones in turn
        with the others; a run is in one block alone. The first has readings of every instrument, whose noise is told by
        it. Readings that are far off are left out. values: (n,), mm.
        """
        place = np.empty(self.rows.size, dtype=np.int64)
        for number, run in enumerate(self.base.runs):
            place[run.rows.at] = number
        most = ENOUGH + self.base.columns.weights.shape[1]
        whose = [run.noise_group for run in self.base.runs]
        for together in _together(_in_turn(_groups(self.rows, place), place), most, lambda at: whose[place[at[0]]]):
            yield self._without_far(values, place, together)

    def _without_far(self, values: FloatArray, place: IntArray, groups: Sequence[IntArray]) -> Block:
        found = self._block(values, place, groups)
        left, share = left_of(found)
        kept = []
        for one, at in zip(found.parts, groups, strict=True):
            telling = share[one.rows] > HELD
            size = np.abs(left[one.rows])
            spread = float(np.median(size[telling])) / NORMAL_MEDIAN if telling.any() else 0.0
            kept.append(at[(size <= FAR * spread) | ~telling] if spread > 0.0 else at)
        return self._block(values, place, kept)

    def _block(self, values: FloatArray, place: IntArray, groups: Sequence[IntArray]) -> Block:
        every = np.concatenate(groups)
        key = every.tobytes()
        if key not in self.made:
            self.made[key] = _block(self.rows, self.base, place, groups)
        return replace(self.made[key], values=values[every])


def _groups(rows: Rows, place: IntArray) -> list[IntArray]:
    """Rows of runs that read the same targets; where they are many, some of their targets, spread over the runs."""
    reads = csr_array((np.ones(rows.size), (place, rows.target)))
    count, of_run = connected_components(reads @ reads.T, directed=False)
    found = []
    for group in range(count):
        at = np.flatnonzero(of_run[place] == group)
        _, first, which = np.unique(rows.target[at], return_index=True, return_inverse=True)
        order = np.argsort(np.argsort(first))[which.reshape(-1)]
        found.append(at[order % -(-at.size // MOST) == 0])
    return found


def _together(groups: Iterable[IntArray], most: int, instrument: Callable[[IntArray], str]) -> list[list[IntArray]]:
    """In their order, up to `most` readings together; with the first ones a group of every instrument."""
    found: list[list[IntArray]] = [[]]
    for at in groups:
        if found[-1] and sum(one.size for one in found[-1]) + at.size > most:
            found.append([])
        found[-1].append(at)
    first, *others = found
    seen = {instrument(at) for at in first}
    for members in others:
        missing = {instrument(at): k for k, at in reversed(list(enumerate(members))) if instrument(at) not in seen}
        seen |= missing.keys()
        first += [members[k] for k in missing.values()]
        members[:] = [at for k, at in enumerate(members) if k not in missing.values()]
    return [members for members in found if members]


def _in_turn(groups: Sequence[IntArray], place: IntArray) -> Iterator[IntArray]:
    spread = [groups[k] for k in np.argsort(np.arange(len(groups)) * GOLDEN % 1.0).tolist()]
    several = [one for one in spread if np.ptp(place[one]) > 0]
    alone = [one for one in spread if np.ptp(place[one]) == 0]
    for pair in zip_longest(several, alone):
        yield from (one for one in pair if one is not None)


def _block(rows: Rows, base: Base, place: IntArray, groups: Sequence[IntArray]) -> Block:
    """Without values."""
    parts: list[Part] = []
    start = 0
    for at in groups:
        parts.append(_part(rows, base, place, at, start))
        start += at.size
    every = np.concatenate(groups)
    free = np.hstack([base.columns.at(every), base.by_chance[every]])
    size = np.linalg.norm(free, axis=0)
    free = _less_own(parts, free)
    free = orthonormal(free[:, np.linalg.norm(free, axis=0) > RANK * size])
    return Block(parts=tuple(parts), at=every, free=free, values=np.zeros(every.size))


def _less_own(parts: Sequence[Part], columns: FloatArray) -> FloatArray:
    """(n, k): what is left of columns beside what is unknown of each run."""
    return np.concatenate([columns[one.rows] - one.own @ (one.own.T @ columns[one.rows]) for one in parts])


def _part(rows: Rows, base: Base, place: IntArray, at: IntArray, start: int) -> Part:
    own, balls, passed, when = [], [], [], []
    kept = [~np.isin(kinds, BALL_OF_RUN) for kinds in base.own_kinds]
    first = np.flatnonzero(np.diff(place[at], prepend=-1)).tolist()
    runs = tuple(slice(one, end) for one, end in pairwise([*first, at.size]))
    for mine in runs:
        number = int(place[at[mine.start]])
        run = base.runs[number].rows
        here = at[mine] - int(run.at[0])
        own.append(orthonormal(base.own[number][here][:, kept[number]]))
        balls.append(base.own[number][here][:, ~kept[number]])
        passed.append(run.passed[here])
        when.append(np.cumsum(run.steps)[here])
    _, target, times = np.unique(rows.target[at], return_inverse=True, return_counts=True)
    return Part(
        rows=slice(start, start + at.size),
        place=place[at],
        target=target,
        passed=np.concatenate(passed),
        when=np.concatenate(when),
        own=np.asarray(block_diag(*own)),
        balls=tuple(balls),
        runs=runs,
        repeated=np.asarray(target[:, np.newaxis] == np.flatnonzero(times > 1), dtype=np.float64),
        alone=times[target] == 1,
    )


def left_of(block: Block) -> tuple[FloatArray, FloatArray]:
    """(n,), mm: what the free columns leave of each reading, over the root of the share of it that they leave; (n,),
    this share.
    """
    left, share = block.values.copy(), np.ones(block.values.size)
    for one in block.parts:
        left[one.rows] -= one.own @ (one.own.T @ left[one.rows])
        share[one.rows] -= np.sum(one.own**2, axis=1)
    left -= block.free @ (block.free.T @ left)
    share -= np.sum(block.free**2, axis=1)
    return np.asarray(left / np.sqrt(np.maximum(share, HELD))), np.asarray(share)


def of_repeats(part: Part, values: FloatArray) -> FloatArray:
    """(k,), mm: by what readings that are repeated differ from the mean of their target, what is unknown of the runs
    taken away; nearly, and of the size of their noise. values: (n,), mm, of the part.
    """
    alike = part.alike
    count = alike.sum(axis=1)
    left = values.copy()
    for _ in range(ALTERNATIONS):
        left -= part.own @ (part.own.T @ left)
        left -= alike @ left / count
    several = count > 1.0
    return np.asarray(left[several] / np.sqrt(1.0 - 1.0 / count[several]))
