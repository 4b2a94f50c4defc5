"""What was gained: residuals over all readings and over held-out ones, as given, refitted and extended."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.diagnose.base import Base
from trueaxis.diagnose.refit import Fitted
from trueaxis.diagnose.result import BoolArray, FloatArray, Gain, IntArray, Stage
from trueaxis.diagnose.rows import Rows
from trueaxis.diagnose.whiten import Whitening

HELD = 0.4  # share of the repeats that is held back, one at least
EVERY = 4  # without repeats, every fourth reading
RANK = 1e-8


@dataclass(frozen=True, slots=True, eq=False)
class Left:
    """(n,) mm: what is left of each reading."""

    given: FloatArray
    refitted: FloatArray
    extended: FloatArray


def held_out(rows: Rows) -> tuple[BoolArray, str]:
    """(n,) which rows are held back, and how they were chosen: whole runs or passes where there are repeats."""
    held = np.zeros(rows.size, dtype=bool)
    whole = passes = 0
    for number in np.unique(rows.setup):
        mine = rows.setup == number
        blocks = _repeats(rows, np.flatnonzero(mine))
        for repeats in blocks:
            if len(repeats) < 2:
                continue
            last = repeats[-max(1, round(HELD * len(repeats))) :]
            for one in last:
                held[one] = True
                if (rows.run == rows.run[one[0]]).sum() == one.size:
                    whole += 1
                else:
                    passes += 1
    if held.any():
        what = [f"{count} {name}" for count, name in ((whole, "whole runs"), (passes, "passes of runs")) if count]
        return held, f"the last repeats held back: {' and '.join(what)}"
    held = np.arange(rows.size) % EVERY == EVERY // 2
    return held, f"nothing is repeated: every {EVERY}th reading held back"


def _repeats(rows: Rows, mine: IntArray) -> list[list[IntArray]]:
    """Passes over (nearly) the same targets, together, in order of time."""
    found: list[tuple[set[int], list[IntArray]]] = []
    key = rows.run[mine] * 10**6 + rows.passing[mine]
    for number in dict.fromkeys(key.tolist()):
        one = mine[key == number]
        targets = set(rows.target[one].tolist())
        for theirs, passes in found:
            if len(theirs & targets) >= 0.8 * max(len(theirs), len(targets)):
                passes.append(one)
                break
        else:
            found.append((targets, [one]))
    return [passes for _, passes in found]


def fitted_left(
    base: Base, whitening: Whitening, values: FloatArray, causes: Sequence[Fitted], train: BoolArray
) -> Left:
    """Residuals of all rows, fitted on those of `train`; runs wholly held back have their own offset.

    Whitened columns keep rows of one run together, so the weights of a run of which a part is held back are those of
    white noise of its size.
    """
    columns, ends = _stages(base, causes)
    own = base.columns[:, base.first_offset :]
    left = []
    for coefficient in _fitted(values, columns, ends, 1.0 / _sizes(whitening), train):
        rest = values - columns[:, : coefficient.size] @ coefficient
        for column in own.T if not train.all() else ():
            mine = column != 0.0
            # a run of which a part is fitted has its offset from there: what drifts within the run must show
            if mine.any() and not (mine & train).any():
                rest[mine] -= np.mean(rest[mine])
        left.append(rest)
    return Left(*left)


def of_instruments(base: Base, whitening: Whitening, values: FloatArray, causes: Sequence[Fitted]) -> FloatArray:
    """(n,), mm: what offsets, slopes and centres of the instruments account for beside this base and the causes."""
    columns, ends = _stages(base, causes)
    everything = np.ones(values.size, dtype=bool)
    *_, fitted = _fitted(values, columns, ends[-1:], 1.0 / _sizes(whitening), everything)
    return np.asarray(columns[:, : ends[0]] @ fitted[: ends[0]])


def _stages(base: Base, causes: Sequence[Fitted]) -> tuple[FloatArray, tuple[int, int, int]]:
    """Columns of the instruments, of the machine and of the causes, in this order, and where each part ends."""
    of_instruments, of_machine = base.columns[:, base.of_instruments], base.columns[:, : base.of_machine]
    columns = np.hstack([of_instruments, of_machine, *(one.signal[:, np.newaxis] for one in causes)])
    return columns, (of_instruments.shape[1], base.columns.shape[1], columns.shape[1])


def _sizes(whitening: Whitening) -> FloatArray:
    counts = np.diff(whitening.starts)
    return np.repeat([one.sigma for one in whitening.noise], counts)


def _fitted(
    values: FloatArray, columns: FloatArray, ends: Sequence[int], weights: FloatArray, train: BoolArray
) -> list[FloatArray]:
    """(end,) each: coefficients of so many of the first columns, from one factorisation of all."""
    weighted = np.column_stack([columns, values])[train]
    weighted *= weights[train, np.newaxis]
    size = np.sqrt(np.einsum("ij,ij->j", weighted, weighted))
    size[size == 0.0] = 1.0
    weighted /= size
    # the last column of the factor is what the orthonormal ones have in common with the values: they are not needed
    r = np.asarray(np.linalg.qr(weighted, mode="r"))
    return [np.linalg.lstsq(r[:end, :end], r[:end, -1], rcond=RANK)[0] * size[-1] / size[:end] for end in ends]


def gain_of(everything: Left, held: Left, rows_held: BoolArray, split: str, floor: float) -> Gain:
    """RMS of all rows (fitted on all) and of those held back (fitted on the others)."""
    return Gain(_stage(everything, np.ones_like(rows_held)), _stage(held, rows_held), split, floor)


def _stage(left: Left, rows: BoolArray) -> Stage:
    """NaN of no rows at all."""
    if not rows.any():
        return Stage(np.nan, np.nan, np.nan)
    return Stage(*(float(np.sqrt(np.mean(part[rows] ** 2))) for part in (left.given, left.refitted, left.extended)))
