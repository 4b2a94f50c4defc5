"""Numbers as instrument programs write them, with a point or a comma before the decimals."""

import math
import re

_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]{1,3})?")


def decimal(text: str) -> float | None:
    """The number, None where the text is none or too large: no thousands separators, no second comma."""
    if not _NUMBER.fullmatch(text):
        return None
    value = float(text.replace(",", "."))
    return value if math.isfinite(value) else None
