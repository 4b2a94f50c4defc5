"""Numbers as control files take them."""


def plain(value: float, digits: int) -> str:
    """Decimal digits without an exponent, without zeros at the end, never -0."""
    text = f"{value:.{digits}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
