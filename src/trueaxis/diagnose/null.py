"""What is there before any cause: readings that count, what recalibration could change, noise of every run."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import minimize_scalar

from trueaxis.diagnose.base import Base, base_of
from trueaxis.diagnose.by_run import ByRun
from trueaxis.diagnose.noise import noise_of_runs
from trueaxis.diagnose.result import BoolArray, FloatArray, NoiseOf, Outlier
from trueaxis.diagnose.rows import Rows
from trueaxis.diagnose.whiten import RANK, Whitening, whitening
from trueaxis.estimation.outliers import ALIKE, excess, spoilt
from trueaxis.runtime.model import MachineModel

ROUNDS = 10  # of looking for outliers: the largest go first, as they pull what is fitted to good readings
UNSETTLED = 1e-3  # of the noise: what settles by less is none


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Null:
    """rows: those that count; values: (n,) mm, readings less what is expected; outliers: those left out."""

    rows: Rows
    values: FloatArray
    base: Base
    whitening: Whitening
    noise: tuple[NoiseOf, ...]
    outliers: tuple[Outlier, ...]

    def only(self, keep: BoolArray) -> "Null":
        """Of some rows, (n,)."""
        return replace(
            self,
            rows=self.rows.only(keep),
            values=self.values[keep],
            base=self.base.only(keep),
            whitening=self.whitening.only(keep),
        )


def null_of(model: MachineModel, rows: Rows, values: FloatArray, noise_um: float | None) -> Null:
    """From the readings, outliers left out. values: (n,) mm, of all rows."""
    off: tuple[Outlier, ...] = ()
    found = _with_noise(rows, base_of(model, rows), values, noise_um)
    for _ in range(ROUNDS):
        left = _left(found, found.values)
        bad = _spoilt(found, left)
        if not bad.any():
            break
        off += _named(found, bad, left)
        found = found.only(~bad)
    if off:
        found = _with_noise(found.rows, found.base, found.values, noise_um)
    return replace(settled(found, found.values), outliers=off)


def again(null: Null, signal: FloatArray, noise_um: float | None) -> Null:
    """With the noise that is left when causes are known. signal: (n,) mm, what they do to the readings."""
    left = null.values - signal
    found = settled(_with_noise(null.rows, null.base, left, noise_um), left)
    return replace(found, values=null.values, outliers=null.outliers)


def _with_noise(rows: Rows, base: Base, values: FloatArray, noise_um: float | None) -> Null:
    runs, noise = noise_of_runs(rows, base, values, noise_um)
    return Null(
        rows=rows, values=values, base=base, whitening=whitening(rows.run, runs, base.own), noise=noise, outliers=()
    )


def fitted(whiten: Whitening, columns: ByRun, values: FloatArray) -> FloatArray:
    """(p,): coefficients of columns (n, p) by weighted least squares, of least norm in units of their lengths."""
    q, r, size = factored(whiten, columns)
    return np.asarray(np.linalg.lstsq(r, q.transposed(whiten(values)), rcond=RANK)[0] / size)


def factored(whiten: Whitening, columns: ByRun) -> tuple[ByRun, FloatArray, FloatArray]:
    """Q (n, p) and R (p, p) of columns (n, p), mm, whitened and divided by their lengths, and these, (p,)."""
    white = columns.whitened(whiten)
    size = np.linalg.norm(white.weights, axis=0)
    size[size == 0.0] = 1.0
    q, r = np.linalg.qr(white.weights / size)
    return replace(white, weights=q), r, size


def less_own(whiten: Whitening, values: FloatArray) -> FloatArray:
    """(n,), mm: values less what the unknowns of each run's instrument make of them."""
    found = values.copy()
    for place, (run, own) in enumerate(zip(whiten.runs, whiten.own, strict=True)):
        here = slice(int(whiten.starts[place]), int(whiten.starts[place + 1]))
        sized = own / np.maximum(np.linalg.norm(own, axis=0), 1e-300)
        both = run.whitened(np.column_stack([sized, values[here]]))
        found[here] -= sized @ np.linalg.lstsq(both[:, :-1], both[:, -1], rcond=RANK)[0]
    return found


def _left(null: Null, values: FloatArray) -> FloatArray:
    """(n,), mm: what the base leaves of values."""
    coefficient = fitted(null.whitening, null.base.columns, values)
    return less_own(null.whitening, values - null.base.columns @ coefficient)


def _spoilt(null: Null, left: FloatArray) -> BoolArray:
    found = np.zeros(null.rows.size, dtype=bool)
    for noise, one in zip(null.whitening.runs, null.base.runs, strict=True):
        at = one.rows.at
        scale = noise.scale * excess(left[at], noise.sigma)
        found[at] = spoilt(noise.noise, scale, one.rows.steps, left[at], null.rows.target[at], null.rows.size)
    size = np.abs(left) / null.whitening.sigma
    return np.asarray(found & (size >= ALIKE * float(size[found].max(initial=0.0))))


def _named(null: Null, bad: BoolArray, left: FloatArray) -> tuple[Outlier, ...]:
    sigma, rows = null.whitening.sigma, null.rows
    return tuple(
        Outlier(rows.runs[rows.run[at]].id, int(rows.seq[at]), float(left[at]), float(left[at] / sigma[at]))
        for at in np.flatnonzero(bad)
    )


def settled(null: Null, values: FloatArray) -> Null:
    """With the standard deviation by which runs of each instrument settle: the likeliest one."""
    left = null.whitening(_left(null, values))
    course = null.whitening(np.concatenate([one.settling for one in null.whitening.runs]))
    runs, noise = list(null.whitening.runs), []
    for of in null.noise:
        members = [place for place, one in enumerate(null.base.runs) if one.instrument == of.instrument]
        told = []
        for place in members:
            here = slice(int(null.whitening.starts[place]), int(null.whitening.starts[place + 1]))
            weight = float(course[here] @ course[here])
            if weight > RANK:
                told.append((float(course[here] @ left[here]) / weight, 1.0 / weight))
        size = _size(told, of.sigma)
        for place in members:
            runs[place] = replace(runs[place], settles=size)
        noise.append(replace(of, settles=size))
    fresh = whitening(null.rows.run, runs, null.base.own)
    return replace(null, whitening=fresh, noise=tuple(noise))


def _size(told: Sequence[tuple[float, float]], sigma: float) -> float:
    """Standard deviation of a normal variable from values with variances of their own; 0 where none is likelier."""
    if not told:
        return 0.0
    value, variance = np.array(told).T

    def cost(log: float) -> float:
        total = variance + np.exp(2.0 * log)
        return float(np.sum(np.log(total) + value**2 / total))

    least, most = np.log(UNSETTLED * sigma), np.log(max(float(np.abs(value).max()), sigma))
    best = minimize_scalar(cost, bounds=(least, most), method="bounded").x
    return float(np.exp(best)) if cost(best) < cost(-100.0) else 0.0
