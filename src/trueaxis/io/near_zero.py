"""Numbers of a report that are zero but for rounding."""

# um, urad, ppm, and these per mm or deg: a hundredth of what any instrument resolves; solving leaves 1e-22 of a zero
NEAR_ZERO = 1e-6


def plain_zero(value: float) -> float:
    """The value in um, urad or ppm, 0 where it is so small that only rounding made it other than zero."""
    return 0.0 if abs(value) < NEAR_ZERO else value
