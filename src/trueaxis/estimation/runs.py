"""The readings of each run in the order in which they were taken, and which of them count."""

from collections import Counter
from collections.abc import Hashable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.estimation.jacobian import RunRows
from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.observations import Observations, places
from trueaxis.measurement.columns import BoolArray
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import Run


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class MeasuredRun:
    """rows: of all readings; noise_group: see `noise_groups`; reading: (n,), mm; repeats: (n,), the same number where
    the same place was read; good: (n,), which count; frames: in how many frames the same measurement is written.
    """

    rows: RunRows
    noise_group: str
    reading: FloatArray
    repeats: IntArray
    good: BoolArray
    frames: int = 1

    @property
    def instrument(self) -> str:
        """Kind of the instrument."""
        return self.rows.run.instrument

    def kept(self) -> RunRows:
        """The rows that count."""
        return self.rows if self.good.all() else self.of(self.good).rows

    def of(self, keep: BoolArray) -> "MeasuredRun":
        """Some of the readings, (n,)."""
        rows = replace(
            self.rows,
            at=self.rows.at[keep],
            positions=np.ascontiguousarray(self.rows.positions[:, keep]),
            passed=self.rows.passed[keep],
            steps=np.diff(np.cumsum(self.rows.steps)[keep], prepend=0.0),
        )
        return replace(self, rows=rows, reading=self.reading[keep], repeats=self.repeats[keep], good=self.good[keep])


def noise_groups(runs: Sequence[Run]) -> tuple[str, ...]:
    """(n_runs,): which noise each run of a setup has: that of its kind of instrument or, where runs of the kind name
    several devices, of its device.
    """
    devices = [(run.instrument, run.device.id if run.device else "") for run in runs]
    several = Counter(kind for kind, _ in set(devices))
    return tuple(f"{kind} {device or 'without a device'}" if several[kind] > 1 else kind for kind, device in devices)


def measured_runs(observed: Observations) -> list[MeasuredRun]:
    """Every run that has readings. By time where all of a run's rows have one that rises, else by their order."""
    found = []
    same, groups, frames = places(observed), noise_groups(observed.runs), _frames(observed)
    time = None if observed.context is None else observed.context.time
    for index in np.unique(observed.run).tolist():
        rows = np.flatnonzero(observed.run == index)
        if observed.seq is not None:
            rows = rows[np.argsort(observed.seq[rows], kind="stable")]
        at = np.arange(rows.size, dtype=np.float64)
        if time is not None and np.isfinite(time[rows]).all() and (np.diff(time[rows]) > 0.0).all():
            at = time[rows] - time[rows[0]]
        steps = np.diff(at, prepend=0.0)
        typical = float(np.median(steps[1:])) if rows.size > 1 else 1.0
        found.append(
            MeasuredRun(
                rows=RunRows(
                    index=index,
                    run=observed.runs[index],
                    at=rows,
                    positions=np.ascontiguousarray(observed.positions[:, rows]),
                    passed=at / (at[-1] or 1.0),
                    steps=steps / typical,
                ),
                noise_group=groups[index],
                reading=observed.reading[rows],
                repeats=same[rows],
                good=np.ones(rows.size, dtype=bool),
                frames=frames[index],
            )
        )
    return found


def measurements(runs: Sequence[Run], run: IntArray, positions: FloatArray, time: FloatArray | None) -> list[Hashable]:
    """Of every run, a key that runs share in which one measurement is written along different directions and frames: a
    probe touches a sphere, and its centre is written along the bed and along the workpiece. They are at the same
    positions, at the same time where there is one.

    run: (n,), index of the run of each reading; positions: (n_axes, n), mm or deg; time: (n,), s, or None.
    """
    keys: list[Hashable] = []
    for index, one in enumerate(runs):
        key: Hashable = index
        if one.instrument == "probe" and (rows := run == index).any():
            at = positions[:, rows].tobytes(), None if time is None else time[rows].tobytes()
            key = one.device, one.session, one.target, one.reference, *at
        keys.append(key)
    return keys


def _frames(observed: Observations) -> list[int]:
    """Of every run, in how many frames its measurement is written: both hold the same noise."""
    time = None if observed.context is None else observed.context.time
    keys = measurements(observed.runs, observed.run, observed.positions, time)
    of_key: dict[Hashable, set[str]] = {}
    for key, run in zip(keys, observed.runs, strict=True):
        of_key.setdefault(key, set()).add(run.frame)
    return [len(of_key[key]) for key in keys]
