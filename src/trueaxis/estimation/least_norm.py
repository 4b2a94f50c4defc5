"""Errors without a prior: what the readings do not determine is left at zero, and said.

A combination of errors whose standard uncertainty exceeds what is expected of it, the sizes of [prior], tells less of
the machine than nothing does. Such combinations are open: of all values that agree with the readings those are taken
that are least in units of the sizes. It is the noise that decides, never rounding.
"""

from dataclasses import replace

import numpy as np

from trueaxis.estimation.posterior import OwnPosterior, Posterior
from trueaxis.estimation.sizes import FLAT
from trueaxis.measurement.machine import FloatArray

OPEN = 1.0  # uncertainty of a combination, in sizes of [prior], from which on it is open


def least_norm(flat: Posterior, of_machine: int) -> tuple[Posterior, FloatArray]:
    """The posterior given that the open combinations are zero, and those combinations, (n, d), in scaled unknowns: the
    errors in them and, as the readings then ask, instruments and effects.

    flat: of sizes without a prior to speak of; of_machine: how many unknowns, the first ones, are the machine's.
    """
    size = flat.scale.copy()
    size[:of_machine] /= FLAT
    directions, u, combined = np.linalg.svd(
        flat.spread[:of_machine] / size[:of_machine, np.newaxis], full_matrices=False
    )
    kept = u > OPEN
    # in the coordinates of the root's columns the open combinations are `at`: conditioning takes these out
    at = (directions[:, kept].T @ (flat.mean[:of_machine] / size[:of_machine])) / u[kept]
    columns = combined[kept].T
    opened = flat.spread @ (columns / u[kept])  # each as large as expected, with what instruments and effects then are
    own = tuple(
        OwnPosterior(one.mean - one.by_others @ columns @ at, _without(one.by_others, columns), one.alone)
        for one in flat.own
    )
    mean = flat.mean - flat.spread @ columns @ at
    return replace(flat, mean=mean, spread=_without(flat.spread, columns), scale=size, own=own), opened


def _without(root: FloatArray, columns: FloatArray) -> FloatArray:
    return np.asarray(root - (root @ columns) @ columns.T)
