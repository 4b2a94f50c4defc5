"""How well polynomials of tabulated components predict positions held out, and the order that this asks for.

The positions are held out in parts, every tenth position in turn (each one where there are ten or fewer). For the
paper's procedure every part repeats the whole of it: order, F and t tests, stepwise selection. The other choice, which
does not overfit, is the lowest order whose squared errors exceed those of the best by no more than the standard error
of that difference over the parts.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.machine import IntArray
from trueaxis.identification.polynomial import OptimalFit, PolynomialFit, Samples, fit_optimal, fit_terms
from trueaxis.measurement.machine import FloatArray

MOST_PARTS = 10
Fit = Callable[[Samples], PolynomialFit]


@dataclass(frozen=True, slots=True, eq=False)
class HeldOut:
    """Of one component: the polynomial of all powers up to the order chosen, its held-out rms, and that of the paper's
    procedure, mm or rad.
    """

    fit: PolynomialFit
    rms: float
    rms_optimal: float


def held_out(fits: Mapping[str, OptimalFit], *, max_order: int = 7) -> dict[str, HeldOut]:
    """For each optimal polynomial, its values being those it was fitted to."""
    return {name: _held_out(fit, max_order) for name, fit in fits.items()}


def _held_out(optimal: OptimalFit, max_order: int) -> HeldOut:
    samples = optimal.samples
    highest = min(max_order, _fewest_left(samples) - 1)
    errors = np.array([_errors(samples, _of_order(order)) for order in range(1, highest + 1)])
    order = _lowest(errors) + 1
    of_paper = _errors(samples, lambda part: _optimal(part, max_order, optimal.alpha))
    total = float(samples.weights.sum())
    return HeldOut(
        fit_terms(samples, tuple(range(1, order + 1))),
        float(np.sqrt(errors[order - 1].sum() / total)),
        float(np.sqrt(of_paper.sum() / total)),
    )


def _lowest(errors: FloatArray) -> int:
    """Row of the lowest order that is as good as the best; errors: (n_orders, n_parts)."""
    best = int(errors.sum(axis=1).argmin())
    excess = errors - errors[best]
    spread = excess.std(axis=1, ddof=1) * np.sqrt(errors.shape[1]) if errors.shape[1] > 1 else np.zeros(len(errors))
    good = excess.sum(axis=1) <= spread
    good[best] = True
    return int(np.argmax(good))


def _errors(samples: Samples, fit: Fit) -> FloatArray:
    """(n_parts,): weighted sums of squared errors at positions held out."""
    part = _parts(samples)
    found = []
    for number in range(int(part.max()) + 1):
        out = part == number
        rest = Samples(positions=samples.positions[~out], values=samples.values[~out], weights=samples.weights[~out])
        off = samples.values[out] - fit(rest).at(samples.positions[out])
        found.append(float(samples.weights[out] @ off**2))
    return np.array(found)


def _parts(samples: Samples) -> IntArray:
    _, place = np.unique(samples.positions, return_inverse=True)
    return np.asarray(place).ravel() % MOST_PARTS


def _fewest_left(samples: Samples) -> int:
    """Different positions that are left when a part is held out, at the least."""
    count = np.unique(samples.positions).size
    return count - -(-count // MOST_PARTS)


def _of_order(order: int) -> Fit:
    return lambda samples: fit_terms(samples, tuple(range(1, order + 1)))


def _optimal(samples: Samples, max_order: int, alpha: float) -> PolynomialFit:
    return fit_optimal(
        samples.positions, samples.values, weights=samples.weights, max_order=max_order, alpha=alpha
    ).after
