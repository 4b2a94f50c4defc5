"""What is there before any cause: readings that count, what recalibration could change, noise of every run."""

from dataclasses import dataclass, replace

import numpy as np

from trueaxis.diagnosis.null_model.base import Base, base_of
from trueaxis.diagnosis.null_model.by_run import ByRun
from trueaxis.diagnosis.null_model.noise import noise_of_runs
from trueaxis.diagnosis.null_model.noise_law import Found
from trueaxis.diagnosis.null_model.projection import Projection, spanned
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.null_model.whiten import RANK, RunNoise, Whitening, whitening
from trueaxis.diagnosis.result import BoolArray, FloatArray, NoiseOf, Outlier
from trueaxis.model.model import MachineModel


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Null:
    """rows: those that count; values: (n,) mm, readings less what is expected; outliers: those left out; found: of the
    noise, where it was estimated; given: (of_machine, k), by how much given values may be off, see `given_by_chance`.
    """

    rows: Rows
    values: FloatArray
    base: Base
    whitening: Whitening
    noise: tuple[NoiseOf, ...]
    outliers: tuple[Outlier, ...]
    found: Found | None
    given: FloatArray

    def only(self, keep: BoolArray) -> "Null":
        """Of some rows, (n,)."""
        return replace(
            self,
            rows=self.rows.only(keep),
            values=self.values[keep],
            base=self.base.only(keep),
            whitening=self.whitening.only(keep),
        )


def lent(null: Null, other: Null) -> Null:
    """With the noise that another has of the same runs, or of one with the same noise (`noise_groups`)."""
    runs = zip(other.base.runs, other.whitening.runs, strict=True)
    told: dict[object, RunNoise] = {}
    for run, noise in runs:
        told |= {run.noise_group: noise, run.rows.index: noise}
    noises = []
    for run, before in zip(null.base.runs, null.whitening.runs, strict=True):
        noise = told.get(run.rows.index) or told.get(run.noise_group) or before
        known = replace(noise, steps=before.steps, passed=before.passed, drifts=before.drifts, ball=before.ball)
        noises.append(replace(known, freedom=before.freedom))
    return replace(null, whitening=whitening(null.rows.run, noises, null.base.free))


def balls_anywhere(null: Null) -> Null:
    """With the ball of each run free: where it may be the fault of an instrument, other balls do not tell its place."""
    runs = [replace(one, places=0.0) for one in null.whitening.runs]
    return replace(null, whitening=whitening(null.rows.run, runs, null.base.anywhere))


def again(null: Null, signal: FloatArray, noise_um: float | None) -> Null:
    """With the noise that is left when causes are known. signal: (n,) mm, what they do to the readings."""
    left = null.values - signal
    found = with_noise(null.rows, null.base, left, noise_um, null.found)
    return replace(found, values=null.values, outliers=null.outliers, given=null.given)


def rougher(model: MachineModel, null: Null, component: str, noise_um: float | None) -> Null:
    """With a rougher curve of one more component; `given` is that of no value."""
    base = base_of(model, null.rows, (*null.base.rough, component))
    found = with_noise(null.rows, base, null.values, noise_um, null.found)
    return replace(found, outliers=null.outliers)


def with_noise(rows: Rows, base: Base, values: FloatArray, noise_um: float | None, before: Found | None = None) -> Null:
    """Of all these rows, with the noise that they tell. values: (n,) mm; noise_um, before: see `noise_of_runs`."""
    runs, noise, found = noise_of_runs(rows, base, values, noise_um, before)
    white = whitening(rows.run, runs, base.free)
    given = np.zeros((base.of_machine, 0))
    return Null(
        rows=rows, values=values, base=base, whitening=white, noise=noise, outliers=(), found=found, given=given
    )


def what_is_free(null: Null, free: FloatArray) -> Projection:
    """What is no news before any cause is known. free: (n, k), mm, columns that are free besides."""
    columns = null.base.columns.beside(free) if free.size else null.base.columns
    basis = Projection(spanned(columns.whitened(null.whitening)))
    return basis.softened(null.whitening(null.base.by_chance))


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
    """(n,), mm: values less what the unknowns of each run's instrument make of them, its drift and the place of its
    ball as they are expected.
    """
    found = values.copy()
    for place, (run, own) in enumerate(zip(whiten.runs, whiten.own, strict=True)):
        here = slice(int(whiten.starts[place]), int(whiten.starts[place + 1]))
        by_chance = run.of_set_up
        sized = np.column_stack([by_chance, own / np.maximum(np.linalg.norm(own, axis=0), 1e-300)])
        both = run.whitened(np.column_stack([sized, values[here]]))
        both = np.vstack([both, np.eye(by_chance.shape[1], both.shape[1])])  # what is expected of these
        found[here] -= sized @ np.linalg.lstsq(both[:, :-1], both[:, -1], rcond=RANK)[0]
    return found


def coefficients_expected(null: Null) -> FloatArray:
    """(p,): coefficients of the base with what is expected of them: what nothing else tells of is not any number."""
    q, r, size = factored(null.whitening, null.base.columns)
    wide, inside = null.base.wide(), q.transposed(null.whitening(null.values))
    return np.asarray(wide * (expected_root(r * (size * wide))[:, : inside.size] @ inside))


def expected_root(sized: FloatArray) -> FloatArray:
    """(p, 2 p): a root of the covariance of unknowns in units of what is expected of each, once the readings have had
    their say; its first p columns times what these ask for are the unknowns. sized: (p, p), `factored` columns times
    what is expected. In these units nothing has to be cut off for rounding.
    """
    return np.linalg.pinv(np.vstack([sized, np.eye(sized.shape[1])]))


def left_by_base(null: Null, values: FloatArray) -> FloatArray:
    """(n,), mm: what the base leaves of values."""
    coefficient = fitted(null.whitening, null.base.columns, values)
    return less_own(null.whitening, values - null.base.columns @ coefficient)


def log_likelihood(q: ByRun, sized: FloatArray, white: FloatArray) -> float:
    """Of whitened readings (n,), but for a constant: noise, and columns q times `sized` (p, p), each of variance 1."""
    inside = q.transposed(white)
    factor = np.linalg.cholesky(np.eye(inside.size) + sized @ sized.T)
    within = np.linalg.solve(factor, inside)
    outside = float(white @ white - inside @ inside)
    return -0.5 * (outside + float(within @ within)) - float(np.log(np.diag(factor)).sum())
