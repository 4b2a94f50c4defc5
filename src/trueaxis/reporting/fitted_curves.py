"""Which curves of an estimate `fit` leaves as they are, in sentences."""

from collections.abc import Sequence


def curve_sentences(without_polynomial: Sequence[str], by_prior: Sequence[str]) -> tuple[str, ...]:
    """without_polynomial: curves of which no polynomial is significant and near; by_prior: those that no reading
    determines.
    """
    found = []
    if without_polynomial:
        found.append(
            f"{', '.join(without_polynomial)}: no polynomial is both significant and near to the curve, by its u; "
            "the Legendre curve is kept"
        )
    if by_prior:
        found.append(
            f"{', '.join(by_prior)}: the readings do not determine these errors; their Legendre curves are kept, "
            "and the picture shows them dashed, with a band of 2 u"
        )
    return tuple(found)
