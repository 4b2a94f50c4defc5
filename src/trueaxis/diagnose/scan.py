"""The scan: how much better every candidate explains what the base leaves, searched parameters at their best."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.stats import f as f_distribution

from trueaxis.diagnose.freedom import Freedom
from trueaxis.diagnose.projection import Projection, orthonormal
from trueaxis.diagnose.result import FloatArray
from trueaxis.diagnose.signatures import Signature
from trueaxis.diagnose.tails import log_chi2_tail, log_f_tail
from trueaxis.diagnose.whiten import Whitening
from trueaxis.effects.kind import Effect

WORTH_A_LOOK = 14.0  # of a statistic, below which nobody asks how sure the noise is
FAR = 100.0  # a statistic from which the number of tries does not matter
UNOBSERVABLE = 1e-9  # share of the squared signature that the base leaves


@dataclass(frozen=True, slots=True, eq=False)
class Scanned:
    """One candidate: the best point of its grid.

    statistic: whitened sum of squares that it explains there (chi^2 of `freedom` under noise alone); tries: effective
    number of independent places that were tried; amplitudes: (freedom,); evidence: -log10(p tries); preference: the
    same as if the noise were known, by which candidates are compared: they share its uncertainty.
    share: of its squared whitened signature that the base leaves, the most over the grid; strength: the same sum
    itself per unit of amplitude squared; length: of the curve along the grid; middle:
    (n_support, k), the whitened signature in the middle of the grid.
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
    share: float
    strength: float
    length: float
    middle: FloatArray
    support: slice
    missing: str = ""


def scanned(
    signature: Signature,
    whitening: Whitening,
    projection: Projection,
    residual: FloatArray,
    freedom: Freedom,
    length: float | None = None,
) -> Scanned:
    """Scan one candidate. residual: (n,), whitened, as the projection tells it; freedom: of the noise estimate.

    The cost grows with readings times rank of the base times points of the grid.
    """
    size, points, k = signature.columns.shape
    support = signature.support
    white = whitening.part(support, signature.columns.reshape(size, -1))
    inside = projection.inner[support].T @ white
    full = white.reshape(size, points, k)
    held = inside.reshape(-1, points, k)
    total = _gram(full)
    gram = total - _gram(held)
    right = (residual[support] @ white).reshape(points, k)
    whole = np.trace(total, axis1=1, axis2=2)
    left = np.trace(gram, axis1=1, axis2=2)
    share = np.divide(left, whole, out=np.zeros(points), where=whole > 0.0)
    statistic, amplitudes = _explained(gram, right, whole, one_sided=_one_sided(signature))
    best = int(np.argmax(statistic))
    if length is None:
        length = _length(full, held, gram)
    # Hotelling's tube to first order: a largest statistic u is so many times as likely as one at a given place
    tries = 1.0 + length * float(np.sqrt(min(float(statistic[best]), FAR) / (2.0 * np.pi)))
    within = freedom.of_readings
    if statistic[best] > WORTH_A_LOOK:
        whole = np.zeros((residual.size, k))
        whole[support] = full[:, best]
        within = freedom.of(orthonormal(projection.rest(whole)))
    p_value = float(f_distribution.sf(statistic[best] / k, k, within))
    evidence = -log_f_tail(statistic[best] / k, k, within) / float(np.log(10.0)) - float(np.log10(tries))
    return Scanned(
        effect=signature.effect,
        point=signature.points[best],
        place=best,
        amplitudes=amplitudes[best],
        statistic=float(statistic[best]),
        freedom=k,
        tries=tries,
        p_value=min(1.0, p_value * tries),
        evidence=evidence if statistic[best] > 0.0 else 0.0,
        preference=-log_chi2_tail(float(statistic[best]), k) / float(np.log(10.0)) - float(np.log10(tries)),
        share=float(share.max()),
        strength=float(np.median(left / k)),
        length=length,
        middle=full[:, points // 2].copy(),
        support=support,
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


def _explained(
    gram: FloatArray, right: FloatArray, whole: FloatArray, *, one_sided: bool
) -> tuple[FloatArray, FloatArray]:
    """(points,) sums of squares explained and (points, k) amplitudes, by the Gram matrices (points, k, k)."""
    values, vectors = np.linalg.eigh(gram)
    kept = values > UNOBSERVABLE * whole[:, np.newaxis]
    turned = np.einsum("pij,pi->pj", vectors, right)
    scaled = np.divide(turned, values, out=np.zeros_like(turned), where=kept)
    amplitudes = np.einsum("pij,pj->pi", vectors, scaled)
    statistic = np.sum(np.where(kept, turned * scaled, 0.0), axis=1)
    if one_sided:
        statistic = np.where(amplitudes[:, 0] > 0.0, statistic, 0.0)
    return statistic, amplitudes


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
