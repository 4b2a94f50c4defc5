"""Readings made independent, run by run, and what nobody knows of each run's instrument taken away.

Within a run the noise is white and slow (estimation.noise). The unknowns of the run's instrument (its zero, its creep
in time, the slope of a straightness line, the place of a ball) are free: what is whitened has them projected out. By
chance it also settles after the start of the run, with a standard deviation that is the same for runs of an instrument.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from trueaxis.diagnose.result import BoolArray, FloatArray, IntArray
from trueaxis.estimation.noise import Noise
from trueaxis.estimation.noise import Whitening as OfOneRun

SHORT = 400  # readings of a run, up to which one matrix is quicker than the recursion
SETTLED = 0.2  # of the duration of a run: its time constant of settling
MODES = 12  # of a random walk: the further ones are a hundredth of its variance, and much like white noise
SLIGHT = 1e-3  # standard deviations of the noise that matter to nobody
RANK = 1e-9  # singular values below it, of columns of length 1, count as zero


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class RunNoise:
    """Of one run: noise: its white and slow noise; steps: (n,), time since the reading before in typical steps; passed:
    (n,), share of its duration; wanders, settles: standard deviations of its random walk, at its end, and of its
    settling, mm.
    """

    noise: Noise
    steps: FloatArray
    passed: FloatArray
    wanders: float
    settles: float

    @property
    def sigma(self) -> float:
        """Standard deviation of a reading, mm."""
        return self.noise.sigma

    def only(self, keep: BoolArray) -> "RunNoise":
        """Of some readings, (n,)."""
        steps = np.diff(np.cumsum(self.steps)[keep], prepend=0.0)
        return replace(self, steps=steps, passed=self.passed[keep])

    @property
    def chance(self) -> FloatArray:
        """(n, k), mm: how it wanders and settles, one standard deviation each; its zero and its drift are free."""
        settled = self.settles * settling(self.passed)
        return np.hstack([self.wanders * wandering(self.passed), settled[:, np.newaxis]])

    def whitened(self, columns: FloatArray) -> FloatArray:
        """(n, k) columns by the white and the slow noise alone."""
        return OfOneRun(self.noise, self.steps)(columns)


@dataclass(frozen=True, slots=True, eq=False)
class _Aside:
    """What is taken away after whitening: own: (n, k), orthonormal; turned: (n, j), orthonormal directions in which
    the run varies by chance, and of each 1 - 1/sqrt(1 + d^2) of its standard deviation d.
    """

    own: FloatArray
    turned: FloatArray
    shrink: FloatArray

    def __call__(self, columns: FloatArray) -> FloatArray:
        left = columns - self.own @ (self.own.T @ columns)
        return left - self.turned @ (self.shrink[:, np.newaxis] * (self.turned.T @ left))


@dataclass(frozen=True, slots=True, eq=False)
class Whitening:
    """Inverse root of the covariance, one block per run. starts: (n_runs + 1,), first row of each run; runs: noise of
    each, in their order; own: (n_r, k) of each, columns of its own unknowns, mm.
    """

    starts: IntArray
    runs: tuple[RunNoise, ...]
    own: tuple[FloatArray, ...]
    _asides: dict[int, _Aside] = field(default_factory=dict, repr=False)
    _operators: dict[int, FloatArray] = field(default_factory=dict, repr=False)

    @property
    def sigma(self) -> FloatArray:
        """(n,): standard deviation of each reading, mm."""
        return np.repeat([one.sigma for one in self.runs], np.diff(self.starts))

    @property
    def own_count(self) -> IntArray:
        """(n_runs,): how many unknowns of its own each run has."""
        return np.array([self._aside(place).own.shape[1] for place in range(len(self.runs))], dtype=np.int64)

    def __call__(self, columns: FloatArray) -> FloatArray:
        """(n, k) whitened; columns: (n, k) or (n,)."""
        return self.part(np.arange(int(self.starts[-1])), columns)

    def part(self, rows: IntArray, columns: FloatArray) -> FloatArray:
        """Columns (n_rows, k) or (n_rows,) of some rows whitened; rows: ascending, those of whole runs, or none."""
        flat = columns if columns.ndim == 2 else columns[:, np.newaxis]
        found = np.empty_like(flat, dtype=np.float64)
        for place, here in self._members(rows):
            found[here] = self._whitened(place, flat[here])
        return found.reshape(columns.shape)

    def back(self, columns: FloatArray) -> FloatArray:
        """(n, k) times the transpose: b such that b'a is the product of columns and a whitened, for any a."""
        found = np.empty_like(columns, dtype=np.float64)
        for place, here in self._members(np.arange(int(self.starts[-1]))):
            found[here] = self._back(place, columns[here])
        return found

    def only(self, keep: BoolArray) -> "Whitening":
        """Of some rows, (n,): a run of which none is kept is none."""
        runs, own, starts = [], [], [0]
        for place, (run, columns) in enumerate(zip(self.runs, self.own, strict=True)):
            mine = keep[self.starts[place] : self.starts[place + 1]]
            if mine.any():
                runs.append(run.only(mine))
                own.append(columns[mine])
                starts.append(starts[-1] + int(mine.sum()))
        return Whitening(np.array(starts, dtype=np.int64), tuple(runs), tuple(own))

    def _members(self, rows: IntArray) -> Iterator[tuple[int, slice]]:
        begins = np.searchsorted(rows, self.starts)
        for place in np.flatnonzero(np.diff(begins)).tolist():
            yield place, slice(int(begins[place]), int(begins[place + 1]))

    def _whitened(self, place: int, columns: FloatArray) -> FloatArray:
        run = self.runs[place]
        if columns.shape[0] <= SHORT:
            found = np.asarray(self._operator(place) @ columns)
        else:
            found = self._aside(place)(run.whitened(columns))
        # rounding of what the run's own unknowns hold is no direction of its own
        found[:, np.linalg.norm(found, axis=0) <= RANK * np.linalg.norm(columns, axis=0) / run.sigma] = 0.0
        return found

    def _back(self, place: int, columns: FloatArray) -> FloatArray:
        if columns.shape[0] <= SHORT:
            return np.asarray(self._operator(place).T @ columns)
        run = self.runs[place]
        return OfOneRun(run.noise, run.steps).transposed(self._aside(place)(columns))

    def _operator(self, place: int) -> FloatArray:
        """(n_r, n_r): the matrix that whitens a run; kept."""
        if place not in self._operators:
            size = int(self.starts[place + 1] - self.starts[place])
            self._operators[place] = self._aside(place)(self.runs[place].whitened(np.eye(size)))
        return self._operators[place]

    def _aside(self, place: int) -> _Aside:
        if place not in self._asides:
            self._asides[place] = _aside(self.runs[place], self.own[place])
        return self._asides[place]


def _aside(run: RunNoise, own: FloatArray) -> _Aside:
    white = run.whitened(own / np.maximum(np.linalg.norm(own, axis=0), 1e-300))
    left, singular, _ = np.linalg.svd(white, full_matrices=False)
    basis = left[:, singular > RANK * singular.max(initial=0.0)]
    chance = run.whitened(run.chance)
    chance -= basis @ (basis.T @ chance)
    turned, deviation, _ = np.linalg.svd(chance, full_matrices=False)
    told = deviation > SLIGHT
    return _Aside(basis, turned[:, told], 1.0 - 1.0 / np.hypot(1.0, deviation[told]))


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
    return Whitening(starts.astype(np.int64), tuple(runs), tuple(own))
