"""Powers of the position on a scale where they are all of size one.

700^7 beside 700 spans 17 decades. The position is divided by the power of two next above max |x|, so that
every scaled position lies in [-1, 1]; multiplying a coefficient by a power of two is exact in binary floating
point, so that the change back to powers of mm or deg costs nothing.
"""

import numpy as np

from trueaxis.identification.polynomial.samples import FloatArray, Samples


def scale_exponent(positions: FloatArray) -> int:
    """Smallest integer e with max |x| <= 2^e."""
    mantissa, exponent = np.frexp(np.abs(positions).max())
    return int(exponent) - int(mantissa == 0.5)


def scaled_powers(positions: FloatArray, powers: tuple[int, ...], exponent: int, home: float = 0.0) -> FloatArray:
    """Columns (x / 2^exponent)^k less their value at home, shape (n, terms)."""
    orders = np.array(powers, dtype=np.float64)
    columns = np.power(np.ldexp(positions, -exponent)[:, np.newaxis], orders)
    return columns - np.power(np.ldexp(home, -exponent), orders) if home else columns


def to_position_powers(scaled: FloatArray, powers: tuple[int, ...], exponent: int) -> FloatArray:
    """Coefficients of x^k from coefficients of (x / 2^exponent)^k along the last axis of `scaled`; exact."""
    return np.ldexp(scaled, -exponent * np.array(powers, dtype=np.int64))


def weighted_system(samples: Samples, powers: tuple[int, ...]) -> tuple[FloatArray, FloatArray, int]:
    """Design (n, terms) and right-hand side (n,), rows as they count, and the exponent of the scale."""
    exponent = scale_exponent(samples.positions)
    design = samples.weighed(scaled_powers(samples.positions, powers, exponent, samples.home))
    return design, samples.weighed(samples.values), exponent


def rounding_floor(right_hand_side: FloatArray) -> float:
    """Residual sum of squares at and below which a fit is exact as far as double precision can tell."""
    size = right_hand_side.size
    return float(right_hand_side @ right_hand_side) * size * (8 * float(np.finfo(np.float64).eps)) ** 2
