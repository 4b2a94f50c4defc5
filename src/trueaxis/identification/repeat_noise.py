"""The noise that repeated readings show, and how well they tell it."""

import numpy as np

from trueaxis.estimation.observations import Observations, pure_error
from trueaxis.estimation.runs import noise_groups
from trueaxis.identification.weighting import LEAST_FREEDOM
from trueaxis.measurement.machine import FloatArray


def noise_of_repeats(observed: Observations) -> tuple[FloatArray, FloatArray]:
    """(n,) each: standard deviation of each reading from repeats of its group of runs, mm, NaN where it has too few;
    their degrees of freedom.
    """
    names, of_run = np.unique(noise_groups(observed.runs), return_inverse=True)
    group = of_run[observed.run]
    squares, freedom = pure_error(observed, group, names.size)
    enough = freedom >= LEAST_FREEDOM
    of_group = np.where(enough, np.sqrt(squares / np.maximum(freedom, 1)), np.nan)
    return of_group[group], np.asarray(freedom, dtype=np.float64)[group]
