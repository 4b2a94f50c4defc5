"""Whether a formula holds: all sides of it have the same value."""

from itertools import pairwise
from typing import Any

import numpy as np

from tests.page.chain_names import Names
from tests.page.latex_value import NotMathsError, value_of

TOLERANCE = 1e-9


def problem(text: str, names: Names) -> str:
    """Why a formula does not hold; empty where it does."""

    def lookup(name: str, index: int) -> Any:
        found = names.get(name)
        if isinstance(found, np.ndarray) and found.ndim == 1 and name.endswith(("i", "i-1", "i)")):
            return found[index - 1]  # one sample of a sum
        return found

    sides = text.split("=")
    try:
        with np.errstate(all="ignore"):  # a slip may ask for the root of a negative number
            values = [value_of(side, lookup) for side in sides]
    except (
        NotMathsError,
        ValueError,
        TypeError,
        AttributeError,
        ZeroDivisionError,
        IndexError,
        np.linalg.LinAlgError,
    ) as error:
        return f"{type(error).__name__}: {error}"
    if len(values) < 2:
        return "no equality"
    for left, right in pairwise(values):
        zero = isinstance(right, float) and right == 0  # stands for the vector 0, too
        if np.shape(left) != np.shape(right) and not zero:
            return f"shapes {np.shape(left)} and {np.shape(right)}"
        difference = np.abs(np.asarray(left) - np.asarray(right)).max()
        if not difference <= TOLERANCE * (1 + np.abs(np.asarray(left)).max()):
            return f"sides differ by {difference:g}"
    return ""
