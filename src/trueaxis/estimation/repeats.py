"""Readings of one run repeated at the same place: the pure error of an instrument, whatever the model."""

import numpy as np
import polars as pl

from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.observations import Observations
from trueaxis.measurement.machine import FloatArray

MOSTLY, FEWEST_COPIES = 0.5, 3  # a coarse display makes some repeats equal, hardly ever most of them
DECIMALS = 6  # of mm and deg, within which commanded positions are the same


def places(observed: Observations) -> IntArray:
    """(n,): equal for readings of one run at the same positions that were approached from the same side."""
    columns = {"run": observed.run}
    for axis, positions in enumerate(np.round(observed.positions, DECIMALS) + 0.0):
        columns[f"position {axis}"] = positions
    if observed.directions is not None:
        for axis, directions in enumerate(observed.directions):
            columns[f"direction {axis}"] = directions
    ranks = pl.DataFrame(columns).select(pl.struct(pl.all()).rank("dense").alias("place"))
    return ranks["place"].to_numpy().astype(np.int64) - 1


def copied_runs(observed: Observations) -> IntArray:
    """Runs, by index, most of whose repeats are equal to the last digit: rows that were copied have no noise."""
    place = places(observed)
    count = np.bincount(place)
    _, reading = np.unique(observed.reading, return_inverse=True)
    pairs, times = np.unique(np.stack([place, reading]), axis=1, return_counts=True)
    run_of_place = np.zeros(count.size, dtype=np.int64)
    run_of_place[place] = observed.run
    repeats = np.bincount(run_of_place, weights=count - 1, minlength=len(observed.runs))
    equal = np.bincount(run_of_place[pairs[0]], weights=times - 1, minlength=len(observed.runs))
    return np.flatnonzero((equal >= FEWEST_COPIES) & (equal > MOSTLY * repeats))


def pure_error(observed: Observations, group: IntArray, groups: int) -> tuple[FloatArray, IntArray]:
    """Sum of squares (mm^2) and degrees of freedom of readings about the mean of their place, by group: (groups,) each.

    group: (n,), of each reading; readings at one place are of one group.
    """
    place = places(observed)
    count = np.bincount(place)
    mean = np.bincount(place, weights=observed.reading) / count
    squares = (observed.reading - mean[place]) ** 2
    first = np.zeros(count.size, dtype=np.int64)
    first[place] = group
    freedom = np.bincount(first, weights=count - 1, minlength=groups)
    total = np.bincount(group, weights=squares, minlength=groups).astype(np.float64)
    return total, freedom.astype(np.int64)
