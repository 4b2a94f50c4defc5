"""The noise of every instrument from residuals, by the EM algorithm of restricted maximum likelihood.

Residuals of the estimate alone are too small: the fit has taken a part of the noise. Residuals of draws from the
posterior have the noise in full on average; the noise that makes them likeliest is that of the next round.
"""

from collections.abc import Sequence
from itertools import product

import numpy as np

from trueaxis.estimation.noise import Noise, Whitening
from trueaxis.measurement.machine import FloatArray

SHARES = (0.0, 0.03, 0.07, 0.15, 0.3, 0.5, 0.7, 0.85, 0.95)  # of the variance that is slow
LASTING = (1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0)  # typical steps
WHITE = (0, 0)
# mm: no instrument resolves less, and the derivative, that of the error-free machine, is wrong by a share of 1e-4: what
# only smaller readings told of an error of 0.01 mm would be told by that
SMALLEST = 1e-6
AS_MANY = 20.0  # readings that say that a run has the noise of its instrument
NEIGHBOURS = 0.6745 * np.sqrt(6.0)  # median of |second difference| of white noise of standard deviation 1

_Shape = tuple[int, int]  # places in SHARES and LASTING


def noise_of_draws(
    draws: Sequence[FloatArray], steps: Sequence[FloatArray], before: Noise | None = None
) -> tuple[Noise, FloatArray]:
    """Noise of one instrument, and the scale of each of its runs.

    draws: of each run (n, q), mm, residuals of q draws; steps: of each run (n,), see `Whitening`; before: of the round
    before, near whose shape the likeliest is looked for; None: of all shapes.
    """
    everything = np.vstack(draws)
    if not everything.size:
        return Noise(SMALLEST), np.ones(len(draws))
    apart = [np.concatenate([[np.inf], one[1:]]) if one.size else one for one in steps]
    every = np.concatenate(apart)
    found: dict[_Shape, tuple[float, Noise]] = {}

    def likelihood(shape: _Shape) -> float:
        if shape not in found:
            share, lasts = SHARES[shape[0]], LASTING[shape[1]]
            unit = Noise(float(np.sqrt(1.0 - share)), float(np.sqrt(share)), lasts)
            whiten = Whitening(unit, every)
            variance = float(np.mean(whiten(everything) ** 2))
            sigma = max(float(np.sqrt(variance)), SMALLEST)
            found[shape] = (
                -every.size * np.log(sigma) - whiten.log_root,
                Noise(sigma * unit.white, sigma * unit.slow, lasts),
            )
        return found[shape][0]

    tried = _all_shapes() if before is None else _beside(_shape_of(before))
    best = max(tried, key=likelihood)
    while (better := max(_beside(best), key=likelihood)) != best:
        best = better
    noise = found[best][1]
    ratio = [
        np.mean(Whitening(noise, one)(own) ** 2) if one.size else 1.0 for own, one in zip(draws, steps, strict=True)
    ]
    count = np.array([one.size for one in steps])
    return noise, np.sqrt((AS_MANY + count * np.array(ratio)) / (AS_MANY + count))


def _all_shapes() -> list[_Shape]:
    return [WHITE, *product(range(1, len(SHARES)), range(len(LASTING)))]


def _shape_of(noise: Noise) -> _Shape:
    """The nearest."""
    share = (noise.slow / noise.sigma) ** 2
    place = int(np.argmin(np.abs(np.array(SHARES) - share)))
    return (place, LASTING.index(noise.lasts)) if place else WHITE


def _beside(shape: _Shape) -> list[_Shape]:
    """It and its neighbours; white noise lasts no time: it is beside all that are next to white."""
    share, lasts = shape
    shares = range(max(share - 1, 1), min(share + 2, len(SHARES)))
    times = range(len(LASTING)) if shape == WHITE else range(max(lasts - 1, 0), min(lasts + 2, len(LASTING)))
    return [shape, *([WHITE] if share == 1 else []), *(one for one in product(shares, times) if one != shape)]


def first_noise(values: Sequence[FloatArray]) -> Noise:
    """White noise of one instrument from how readings differ from their neighbours; values: of each run (n,), mm.

    Too large where readings are far apart: the rounds that follow lower it.
    """
    second = [np.abs(np.diff(one, 2)) for one in values if one.size > 2]
    if not second:
        return Noise(max(float(np.sqrt(np.mean(np.concatenate(values) ** 2))), SMALLEST))
    together = np.concatenate(second)
    middle = float(np.median(together)) or float(np.mean(together))
    return Noise(max(middle / NEIGHBOURS, SMALLEST))
