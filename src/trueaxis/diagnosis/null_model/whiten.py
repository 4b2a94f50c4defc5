"""Readings made independent, run by run, and what nobody knows of each run's instrument taken away.

Within a run the noise is white and slow (estimation.noise). The unknowns of the run's instrument (its zero, the slope
of a straightness line) are free: what is whitened has them projected out. By chance it also drifts over the run, as far
as its class is known to, has its ball elsewhere, and wanders, and settles after the start of the run, as runs of its
instrument do.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from trueaxis.diagnosis.null_model.rows import as_slice, runs_among
from trueaxis.diagnosis.result import BoolArray, FloatArray, IntArray
from trueaxis.estimation.factors import decomposed
from trueaxis.estimation.noise import BLOCK, Noise
from trueaxis.estimation.noise import Whitening as OfOneRun

SETTLED = 0.2  # of the duration of a run: its time constant of settling
MODES = 12  # of a random walk: the further ones are a hundredth of its variance, and much like white noise
AS_FREE = 1e4  # standard deviations of the noise: a drift as large is free, and a covariance still has its inverse
SLIGHT = 1e-3  # standard deviations of the noise that matter to nobody
# Entries of a run's columns, below which all runs are whitened at once: the calls for each take longer than the work.
# Of 48 runs of 105 readings one column took 0.4 of the time, four 0.7, and eight the same.
SMALL = 500
RANK = 1e-9  # singular values below it, of columns of length 1, count as zero


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class RunNoise:
    """Of one run: noise: its white and slow noise; steps: (n,), time since the reading before in typical steps; passed:
    (n,), share of its duration; wanders, settles, drifts: standard deviations of its random walk, at its end, of its
    settling, and of its drift over the run, mm; ball: (n, 3), readings by the place of the ball of a run by ball bar,
    mm per mm, else (n, 0); places: standard deviation of this, mm; freedom: degrees of freedom that tell its noise
    among that of all runs of its instrument, infinite where it is known.
    """

    noise: Noise
    steps: FloatArray
    passed: FloatArray
    wanders: float
    settles: float
    drifts: float
    ball: FloatArray
    places: float
    freedom: float = np.inf

    @property
    def sigma(self) -> float:
        """Standard deviation of a reading, mm."""
        return self.noise.sigma

    def only(self, keep: BoolArray) -> "RunNoise":
        """Of some readings, (n,)."""
        steps = np.diff(np.cumsum(self.steps)[keep], prepend=0.0)
        return replace(self, steps=steps, passed=self.passed[keep], ball=self.ball[keep])

    @property
    def chance(self) -> FloatArray:
        """(n, k), mm: how it drifts, where its ball stands, how it settles and wanders, one standard deviation each;
        its zero is free.
        """
        settled = self.settles * settling(self.passed)
        return np.column_stack([self.of_set_up, settled, self.wanders * wandering(self.passed)])

    @property
    def of_set_up(self) -> FloatArray:
        """(n, 1 or 4), mm: one standard deviation of its drift, and of the place of its ball."""
        drift, places = np.minimum([self.drifts, self.places], AS_FREE * self.sigma)
        return np.column_stack([drift * (self.passed - 0.5), places * self.ball])

    def whitened(self, columns: FloatArray) -> FloatArray:
        """(n, k) columns by the white and the slow noise alone."""
        return self.alone()(columns)

    def alone(self) -> OfOneRun:
        """The white and the slow noise alone."""
        return OfOneRun(self.noise, self.steps)


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _OfRun:
    """alone: by white and slow noise; aside: (n, k), orthonormal, what is taken away after that, and its share: all of
    the run's own unknowns, so many; of directions in which it varies by chance 1 - 1/sqrt(1 + d^2) of its standard
    deviation d.
    """

    alone: OfOneRun
    own: int
    aside: FloatArray
    share: FloatArray
    sigma: float

    def less_aside(self, columns: FloatArray) -> FloatArray:
        """In place: columns (n, k) are overwritten."""
        columns -= self.aside @ (self.share[:, np.newaxis] * (self.aside.T @ columns))
        return columns


@dataclass(frozen=True, eq=False, kw_only=True)
class Whitening:
    """Inverse root of the covariance, one block per run. starts: (n_runs + 1,), first row of each run; runs: noise of
    each, in their order; own: (n_r, k) of each, columns of its own unknowns, mm.
    """

    starts: IntArray
    runs: tuple[RunNoise, ...]
    own: tuple[FloatArray, ...]
    _each: dict[int, _OfRun] = field(default_factory=dict, repr=False)
    _several: dict[tuple[int, ...], OfOneRun] = field(default_factory=dict, repr=False)

    @property
    def sigma(self) -> FloatArray:
        """(n,): standard deviation of each reading, mm."""
        return np.repeat([one.sigma for one in self.runs], np.diff(self.starts))

    @property
    def own_count(self) -> IntArray:
        """(n_runs,): how many unknowns of its own each run has."""
        return np.array([self._of(place).own for place in range(len(self.runs))], dtype=np.int64)

    def __call__(self, columns: FloatArray) -> FloatArray:
        """(n, k) whitened; columns: (n, k) or (n,)."""
        return self.part(np.arange(int(self.starts[-1])), columns)

    def part(self, rows: IntArray, columns: FloatArray) -> FloatArray:
        """Columns (n_rows, k) or (n_rows,) of some rows whitened; rows: ascending, those of whole runs, or none."""
        flat = columns if columns.ndim == 2 else columns[:, np.newaxis]
        runs = list(runs_among(self.starts, rows))
        if len(runs) > 1 and flat.size <= SMALL * len(runs):
            return self._at_once(rows, runs, flat).reshape(columns.shape)
        found = np.empty(flat.shape, order="F")
        for place, here in runs:
            found[here] = self.of_run(place, flat[here])
        return found.reshape(columns.shape)

    def back(self, columns: FloatArray) -> FloatArray:
        """(n, k) times the transpose: b such that b'a is the product of columns and a whitened, for any a."""
        found = np.empty(columns.shape, order="F")
        for place, here in runs_among(self.starts, np.arange(int(self.starts[-1]))):
            found[here] = self.back_of_run(place, columns[here])
        return found

    def back_of_run(self, place: int, columns: FloatArray) -> FloatArray:
        """(m, k): the same of one run."""
        run = self._of(place)
        return run.alone.transposed(run.less_aside(columns.copy()))

    def only(self, keep: BoolArray) -> "Whitening":
        """Of some rows, (n,): a run of which none is kept is none."""
        runs, own, starts = [], [], [0]
        for place, (run, columns) in enumerate(zip(self.runs, self.own, strict=True)):
            mine = keep[self.starts[place] : self.starts[place + 1]]
            if mine.any():
                runs.append(run.only(mine))
                own.append(columns[mine])
                starts.append(starts[-1] + int(mine.sum()))
        return Whitening(starts=np.array(starts, dtype=np.int64), runs=tuple(runs), own=tuple(own))

    def of_run(self, place: int, columns: FloatArray) -> FloatArray:
        """(m, k): columns of one run whitened."""
        run = self._of(place)
        found = run.less_aside(run.alone.every(columns))
        # rounding of what the run's own unknowns hold is no direction of its own
        squares, left = np.einsum("ij,ij->j", columns, columns), np.einsum("ij,ij->j", found, found)
        held = left <= (RANK / run.sigma) ** 2 * squares
        if held.any():
            found[:, held] = 0.0
        return found

    def _at_once(self, rows: IntArray, runs: Sequence[tuple[int, slice]], columns: FloatArray) -> FloatArray:
        """(n_rows, k): columns of several runs whitened. runs: places and rows among these."""
        places, first = [place for place, _ in runs], [here.start for _, here in runs]
        found = self.alone(places, columns)
        aside, share, sigma = self._padded
        aside, share, sizes = aside[as_slice(rows)], share[places], np.diff([*first, rows.size])
        squares = np.add.reduceat(columns**2, first)
        for k, column in enumerate(found.T):
            inside = share * np.add.reduceat(aside * column[:, np.newaxis], first)
            found[:, k] -= np.einsum("ij,ij->i", aside, np.repeat(inside, sizes, axis=0))
        held = np.add.reduceat(found**2, first) <= (RANK / sigma[places, np.newaxis]) ** 2 * squares
        if held.any():
            found[np.repeat(held, sizes, axis=0)] = 0.0
        return found

    @cached_property
    def _padded(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """(n, k), what is taken away of each run, as many columns as it takes in any; (n_runs, k), its share; (n_runs,)
        standard deviations.
        """
        each = [self._of(place) for place in range(len(self.runs))]
        most = max(one.share.size for one in each)
        aside = np.vstack([np.pad(one.aside, ((0, 0), (0, most - one.share.size))) for one in each])
        share = np.array([np.pad(one.share, (0, most - one.share.size)) for one in each])
        return aside, share, np.array([one.sigma for one in each])

    def aside(self, place: int) -> tuple[FloatArray, FloatArray]:
        """(m, k): orthonormal, what is taken away of one run after white and slow noise; (k,): its share."""
        run = self._of(place)
        return run.aside, run.share

    def alone(self, places: Sequence[int], columns: FloatArray) -> FloatArray:
        """(m, k): columns of some runs, one after the other, by white and slow noise alone; they are overwritten."""
        if len(places) == 1:
            run = self._of(places[0]).alone
            return run.by_rows(columns) if columns.shape[1] >= BLOCK else run.every(columns)
        key = tuple(places)
        if key not in self._several:
            self._several[key] = OfOneRun.joined([self._of(place).alone for place in places])
        return self._several[key].every(columns)

    def _of(self, place: int) -> _OfRun:
        if place not in self._each:
            self._each[place] = _of_run(self.runs[place], self.own[place])
        return self._each[place]


def _of_run(run: RunNoise, own: FloatArray) -> _OfRun:
    alone = run.alone()
    white = alone.every(own / np.maximum(np.linalg.norm(own, axis=0), 1e-300))
    left, singular, _ = decomposed(white)
    basis = left[:, singular > RANK * singular.max(initial=0.0)]
    own_count = basis.shape[1]
    chance = alone.every(run.chance)
    chance -= basis @ (basis.T @ chance)
    turned, deviation, _ = decomposed(chance)
    told = deviation > SLIGHT
    share = np.concatenate([np.ones(own_count), 1.0 - 1.0 / np.hypot(1.0, deviation[told])])
    return _OfRun(alone=alone, own=own_count, aside=np.hstack([basis, turned[:, told]]), share=share, sigma=run.sigma)


def settling(passed: FloatArray) -> FloatArray:
    """(n,): the course by which a run settles, from 1 on; passed: (n,), share of its duration."""
    return np.asarray(np.exp(-passed / SETTLED))


def wandering(passed: FloatArray) -> FloatArray:
    """(n, MODES): a random walk over a run, of standard deviation 1 at its end, less its zero and its drift: what is
    left is a Brownian bridge (its expansion by Karhunen and Loeve).
    """
    modes = np.pi * np.arange(1, MODES + 1)
    return np.asarray(np.sqrt(2.0) * np.sin(passed[:, np.newaxis] * modes) / modes)


def whitening(run: IntArray, runs: Sequence[RunNoise], own: Sequence[FloatArray]) -> Whitening:
    """For rows sorted by run, (n,); runs, own: of the runs present, in order."""
    starts = np.append(np.flatnonzero(np.diff(run, prepend=-1)), run.size)
    return Whitening(starts=starts.astype(np.int64), runs=tuple(runs), own=tuple(own))
