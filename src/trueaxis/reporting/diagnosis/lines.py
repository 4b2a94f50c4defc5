"""Which readings belong together in a figure: runs along lines, circles, and what is thinned out."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from trueaxis.diagnosis.result import FloatArray, IntArray, Residuals

BALLBAR = "ballbar"
GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)
PLANES = {frozenset("XY"): "XY", frozenset("YZ"): "YZ", frozenset("XZ"): "ZX"}


@dataclass(frozen=True, slots=True, eq=False)
class Line:
    """A run with a laser or probe. axis: index of the axis that moves farthest; rows: its readings in their order."""

    run: str
    axis: int
    rows: IntArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Round:
    """A run with a ball bar. turn: +1 counter-clockwise, -1 clockwise; feed in mm/min, NaN where unknown."""

    run: str
    plane: str
    turn: int
    feed: float
    rows: IntArray


def lines_of(residuals: Residuals) -> tuple[Line, ...]:
    """All runs of lasers and probes."""
    return tuple(
        Line(residuals.runs[run], int(np.argmax(np.ptp(residuals.positions[:, rows], axis=1))), rows)
        for run, rows in _by_run(residuals)
        if residuals.instruments[run] != BALLBAR
    )


def rounds_of(residuals: Residuals) -> tuple[Round, ...]:
    """All runs of ball bars."""
    return tuple(
        Round(
            run=residuals.runs[run],
            plane=_plane(residuals, rows),
            turn=1 if np.sum(np.angle(np.exp(1j * np.diff(residuals.theta[rows])))) >= 0.0 else -1,
            feed=_feed(residuals, rows),
            rows=rows,
        )
        for run, rows in _by_run(residuals)
        if residuals.instruments[run] == BALLBAR and np.isfinite(residuals.theta[rows]).all()
    )


def envelope(values: FloatArray, limit: int) -> IntArray:
    """Indices of `limit` points of a curve at most, in order: the largest and the smallest of each stretch, so that
    no peak is lost.
    """
    if values.size <= limit:
        return np.arange(values.size)
    edges = np.linspace(0, values.size, max(1, limit // 2) + 1).astype(int)
    kept: set[int] = set()
    for low, high in pairwise(edges):
        stretch = values[low:high]
        kept |= {low + int(stretch.argmin()), low + int(stretch.argmax())}
    return np.array(sorted(kept), dtype=np.int64)


THINNED = "Too many readings to draw all: a sample, and those farthest out."


def sample(values: FloatArray, limit: int) -> IntArray:
    """Indices of `limit` values at most, in order: spread evenly over the rows, so that a cloud keeps its shape (the
    golden ratio falls into step with no number of targets or repeats), and a few for those farthest out.
    """
    if values.size <= limit:
        return np.arange(values.size)
    far = np.argsort(-np.abs(values - np.median(values)), kind="stable")[: limit // 30]
    spread = (GOLDEN * np.arange(limit - far.size) % 1.0 * values.size).astype(np.int64)
    return np.union1d(far, spread)


def _by_run(residuals: Residuals) -> Iterator[tuple[int, IntArray]]:
    for run in range(len(residuals.runs)):
        rows = np.flatnonzero(residuals.run == run)
        if rows.size:
            yield run, rows[np.argsort(residuals.seq[rows], kind="stable")]


def _plane(residuals: Residuals, rows: IntArray) -> str:
    extents = np.ptp(residuals.positions[:, rows], axis=1)
    two = sorted(residuals.axes[k] for k in np.argsort(-extents, kind="stable")[:2])
    return PLANES.get(frozenset(two), "".join(two))


def _feed(residuals: Residuals, rows: IntArray) -> float:
    if residuals.feed is None:
        return float("nan")
    known = residuals.feed[rows][np.isfinite(residuals.feed[rows])]
    return float(np.median(known)) if known.size else float("nan")
