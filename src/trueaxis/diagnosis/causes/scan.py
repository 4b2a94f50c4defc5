"""The scan: how much better every candidate explains what the base leaves, searched parameters at their best."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from trueaxis.diagnosis.causes.prepared import Prepared
from trueaxis.diagnosis.causes.signature import Signature
from trueaxis.diagnosis.null_model.freedom import Freedom
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.null_model.whiten import Whitening
from trueaxis.diagnosis.result import FloatArray
from trueaxis.effects.kind import Effect
from trueaxis.estimation.effects.amplitudes import explained
from trueaxis.estimation.tails import LN10, log_chi2_tail, log_f_tail

# Share of a peak that a grid holds at least: of a period, (sin(pi/4) / (pi/4))^2 half a step of frequency beside it. A
# point with less than this share of the best one is beside no higher peak.
HELD = 0.81
FAR = 100.0  # a statistic from which the number of tries does not matter


@dataclass(frozen=True, slots=True, eq=False)
class Residual:
    """What is left to be explained. freedom: of the noise.

    back: (n, 1 + causes), values and causes taken back through the whitening: their product with a signature is that of
    the whitened ones, for a fraction of the cost.
    """

    freedom: Freedom
    back: FloatArray

    def freedom_of(self, signature: Signature, point: int) -> float:
        """Of the noise, for a test of the signature at this point."""
        return self.freedom.of_cause(signature.support, signature.columns(slice(point, point + 1))[:, 0])


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Scanned:
    """One candidate: the best point of its grid.

    statistic: whitened sum of squares that it explains there (chi^2 of `freedom` under noise alone); tries: effective
    number of independent places that were tried; amplitudes: (freedom,); evidence: -log10(p tries); preference: the
    same as if the noise were known, by which candidates are compared: they share its uncertainty. peaks: places on the
    grid of the point and of all others beside which a higher peak may be, such as an alias of a period.
    """

    effect: Effect
    point: Mapping[str, float]
    peaks: tuple[int, ...]
    amplitudes: FloatArray
    statistic: float
    freedom: int
    tries: float
    p_value: float
    evidence: float
    preference: float
    missing: str = ""


def residual_of(whitening: Whitening, base: Projection, values: FloatArray, freedom: Freedom) -> Residual:
    """values: (n,), whitened; base: with the causes found; freedom: of the noise estimate."""
    back = whitening.back(np.column_stack([base.rest_transposed(base.rest(values)), base.inner_causes]))
    return Residual(freedom, back)


def scanned(signature: Signature, known: Prepared, residual: Residual) -> Scanned:
    """Scan one candidate. The cost grows with the readings that it reaches times causes times points of the grid."""
    k = signature.terms.shape[2]
    statistic, amplitudes = statistics(signature, known, residual)
    if signature.missing:  # nobody knows what it does to these readings: they say nothing for it
        statistic = np.zeros_like(statistic)
    peaks = peaks_of(statistic, HELD * float(statistic.max()))
    best = peaks[0]
    most = float(statistic[best])
    # Hotelling's tube to first order: a largest statistic u is so many times as likely as one at a given place
    tries = 1.0 + known.length * float(np.sqrt(min(most, FAR) / (2.0 * np.pi)))
    log_p = log_f_tail(most / k, k, residual.freedom_of(signature, best))
    lower = float(np.log10(tries))
    return Scanned(
        effect=signature.effect,
        point=signature.points[best],
        peaks=peaks,
        amplitudes=amplitudes[best],
        statistic=most,
        freedom=k,
        tries=tries,
        p_value=min(1.0, float(np.exp(log_p)) * tries),
        evidence=-log_p / LN10 - lower if most > 0.0 else 0.0,
        preference=-log_chi2_tail(most, k) / LN10 - lower,
        missing=signature.missing,
    )


def statistics(signature: Signature, known: Prepared, residual: Residual) -> tuple[FloatArray, FloatArray]:
    """(points,) what a candidate explains at each point of its grid, and (points, k) with which amplitudes."""
    inside = signature.products(residual.back)
    gram = known.gram - _gram(inside[1:], inside[1:]) + np.eye(known.gram.shape[1]) / signature.most**2
    squares, amplitudes = explained(gram, inside[0], known.whole, one_sided=_one_sided(signature))
    if gram.shape[1] > 1:
        return squares, amplitudes
    possible = np.clip(amplitudes, -signature.most, signature.most)  # no machine has more, whatever that explains
    return squares - ((amplitudes - possible) ** 2 * gram[:, 0])[:, 0], possible


def peaks_of(statistic: FloatArray, least: float) -> tuple[int, ...]:
    """Places of local maxima that are no lower, the highest first."""
    beside = np.concatenate([[-np.inf], statistic, [-np.inf]])
    highest = (statistic >= beside[:-2]) & (statistic > beside[2:]) & (statistic >= least)
    places = np.flatnonzero(highest)
    return tuple(places[np.argsort(-statistic[places], kind="stable")].tolist())


def _gram(columns: FloatArray, others: FloatArray) -> FloatArray:
    """(points, k, k) from (n, points, k) each: products at every point."""
    _, points, k = columns.shape
    found = np.empty((points, k, k))
    for i in range(k):
        for j in range(k):
            found[:, i, j] = np.einsum("np,np->p", columns[:, :, i], others[:, :, j])
    return found


def _one_sided(signature: Signature) -> bool:
    return any(one.role == "root" for one in signature.kind.parameters)
