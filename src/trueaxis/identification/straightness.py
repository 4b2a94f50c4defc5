"""The convention that splits straightness from squareness: least-squares lines of the straightness are level.

ISO 230-1 reads the squareness off the least-squares reference lines of two axes, and the straightness from those
lines. A slope common to both is then part of the squareness alone.
"""

import numpy as np

from trueaxis.measurement.machine import FloatArray


def slope_weights(positions: FloatArray) -> FloatArray:
    """(n,): weights whose scalar product with values at the positions is the slope of their least-squares line."""
    centred = positions - positions.mean()
    total = float(centred @ centred)
    return centred / total if total > 0.0 else np.zeros_like(centred)
