"""Which curves of an estimate `fit` leaves as they are, in sentences."""

from collections.abc import Sequence


def curve_sentences(without_polynomial: Sequence[str], by_prior: Sequence[str]) -> tuple[str, ...]:
    """without_polynomial: curves of which no polynomial is significant; by_prior: curves that no reading determines."""
    found = []
    if without_polynomial:
        found.append(
            f"{', '.join(without_polynomial)}: no polynomial is significant beside the uncertainty of the curve; the "
            "Legendre curve is kept"
        )
    if by_prior:
        found.append(
            f"{', '.join(by_prior)}: the readings do not determine these errors; their Legendre curves are kept, "
            "and the picture shows them dashed, with a band of 2 u"
        )
    return tuple(found)
