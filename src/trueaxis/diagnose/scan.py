"""The scan: how much better every candidate explains what the base leaves, searched parameters at their best."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from trueaxis.diagnose.freedom import Freedom
from trueaxis.diagnose.projection import Projection, orthonormal
from trueaxis.diagnose.result import FloatArray
from trueaxis.diagnose.signatures import Signature
from trueaxis.diagnose.tails import log_chi2_tail, log_f_tail
from trueaxis.diagnose.whiten import Whitening
from trueaxis.effects.kind import Effect
from trueaxis.identify.effects.variable_projection import UNOBSERVABLE, explained

WORTH_A_LOOK = 14.0  # of a statistic, below which nobody asks how sure the noise is
SMALL = 16  # points of a grid
FAR = 100.0  # a statistic from which the number of tries does not matter
LN10 = float(np.log(10.0))


@dataclass(frozen=True, slots=True, eq=False)
class Prepared:
    """What of a candidate stays the same whatever the readings are and whichever causes are found.

    total, gram: (points, k, k), the whitened signature times itself, before and after the base is taken away; length:
    of the curve along the grid; shown: (n_support, points shown, k), the whitened signature at all points of a small
    grid, in the middle of a large one, whose points are not alike.
    """

    total: FloatArray
    gram: FloatArray
    length: float
    shown: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Residual:
    """What is left to be explained. base: with the causes found.

    back: (n, 1 + causes), values and causes taken back through the whitening: their product with a signature is that of
    the whitened ones, for a fraction of the cost.
    """

    whitening: Whitening
    base: Projection
    freedom: Freedom
    back: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Scanned:
    """One candidate: the best point of its grid.

    statistic: whitened sum of squares that it explains there (chi^2 of `freedom` under noise alone); tries: effective
    number of independent places that were tried; amplitudes: (freedom,); evidence: -log10(p tries); preference: the
    same as if the noise were known, by which candidates are compared: they share its uncertainty.
    """

    effect: Effect
    point: Mapping[str, float]
    place: int
    amplitudes: FloatArray
    statistic: float
    freedom: int
    tries: float
    p_value: float
    evidence: float
    preference: float
    missing: str = ""


def prepared(signature: Signature, whitening: Whitening, base: Projection) -> Prepared:
    """The candidate's signature whitened and the base taken away; base: without causes.

    The cost grows with the readings that it reaches times rank of the base times points of the grid.
    """
    size, points, k = signature.columns.shape
    white = whitening.part(signature.support, signature.columns.reshape(size, points * k))
    held = (base.of(signature.support).T @ white).reshape(-1, points, k)
    full = white.reshape(size, points, k)
    total = _gram(full)
    gram = total - _gram(held)
    shown = slice(None) if points <= SMALL else slice(points // 2, points // 2 + 1)
    return Prepared(total, gram, _length(full, held, gram), full[:, shown].copy())


def residual_of(whitening: Whitening, base: Projection, values: FloatArray, freedom: Freedom) -> Residual:
    """values: (n,), whitened; base: with the causes found; freedom: of the noise estimate."""
    back = whitening.back(np.column_stack([base.told(values), base.inner_causes]))
    return Residual(whitening, base, freedom, back)


def scanned(signature: Signature, known: Prepared, residual: Residual) -> Scanned:
    """Scan one candidate. The cost grows with the readings that it reaches times causes times points of the grid."""
    _, points, k = signature.columns.shape
    inside = residual.back[signature.support].T @ signature.columns.reshape(-1, points * k)
    gram = known.gram - _gram(inside[1:].reshape(-1, points, k))
    whole = np.trace(known.total, axis1=1, axis2=2)
    statistic, amplitudes = explained(gram, inside[0].reshape(points, k), whole, one_sided=_one_sided(signature))
    best = int(np.argmax(statistic))
    most = float(statistic[best])
    # Hotelling's tube to first order: a largest statistic u is so many times as likely as one at a given place
    tries = 1.0 + known.length * float(np.sqrt(min(most, FAR) / (2.0 * np.pi)))
    within = residual.freedom.of_readings
    if most > WORTH_A_LOOK:
        column = residual.whitening(signature.over_all(best))
        within = residual.freedom.of(orthonormal(residual.base.rest(column)))
    log_p = log_f_tail(most / k, k, within)
    lower = float(np.log10(tries))
    return Scanned(
        effect=signature.effect,
        point=signature.points[best],
        place=best,
        amplitudes=amplitudes[best],
        statistic=most,
        freedom=k,
        tries=tries,
        p_value=min(1.0, float(np.exp(log_p)) * tries),
        evidence=-log_p / LN10 - lower if most > 0.0 else 0.0,
        preference=-log_chi2_tail(most, k) / LN10 - lower,
        missing=signature.missing,
    )


def _gram(columns: FloatArray) -> FloatArray:
    """(points, k, k) from (n, points, k)."""
    _, points, k = columns.shape
    found = np.empty((points, k, k))
    for i in range(k):
        for j in range(i, k):
            found[:, i, j] = found[:, j, i] = np.einsum("np,np->p", columns[:, :, i], columns[:, :, j])
    return found


def _one_sided(signature: Signature) -> bool:
    return any(one.role == "root" for one in signature.kind.parameters)


def _length(full: FloatArray, held: FloatArray, gram: FloatArray) -> float:
    """Length of the curve that the signature, base projected out, draws on the unit sphere along the grid."""
    if full.shape[1] == 1:
        return 0.0
    k = full.shape[2]
    cross = np.empty((full.shape[1] - 1, k, k))
    for i in range(k):
        for j in range(k):
            cross[:, i, j] = np.einsum("np,np->p", full[:, :-1, i], full[:, 1:, j])
            cross[:, i, j] -= np.einsum("np,np->p", held[:, :-1, i], held[:, 1:, j])
    inverse = np.linalg.pinv(gram, rcond=UNOBSERVABLE, hermitian=True)
    shared = np.einsum("pij,pjk,plk,pli->p", inverse[:-1], cross, inverse[1:], cross)
    angle = np.arccos(np.sqrt(np.clip(shared / k, 0.0, 1.0)))
    return float(np.sum(angle))
