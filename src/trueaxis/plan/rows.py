"""The equations of a few runs by themselves, the unknowns of their instruments eliminated; plans with runs changed."""

from dataclasses import replace

import numpy as np

from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.observations import Observations
from trueaxis.identify.global_fit.design import Design
from trueaxis.identify.global_fit.layout import Layout
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.setup import Run
from trueaxis.plan.instruments import Assumptions, Unknowns, instrument_unknowns
from trueaxis.plan.system import eliminated


def rows_of(layout: Layout, observed: Observations, assumed: Assumptions) -> FloatArray:
    """(n, n_unknowns): the design matrix of all readings in scaled unknowns; for runs few enough to hold it."""
    matrix = np.zeros((observed.reading.size, layout.count))
    for rows, piece in Design(layout, observed).pieces():
        matrix[rows] = piece
    for one in instrument_unknowns(layout.machine, observed, assumed):
        matrix[one.rows] = eliminated(matrix[one.rows], one.columns)
    return matrix


def of_runs(observed: Observations, runs: tuple[int, ...]) -> Observations:
    """The readings of some runs, which become the only ones."""
    keep = np.flatnonzero(np.isin(observed.run, runs))
    index = np.searchsorted(np.array(runs), observed.run[keep])
    return replace(observed.of(keep), runs=tuple(observed.runs[run] for run in runs), run=index.astype(np.int64))


def with_run(observed: Observations, index: int, run: Run) -> Observations:
    """The same readings with one run set up otherwise."""
    return replace(observed, runs=(*observed.runs[:index], run, *observed.runs[index + 1 :]))


def with_added(observed: Observations, run: Run, positions: FloatArray) -> Observations:
    """One run more. positions: (n_axes, n)."""
    count = positions.shape[1]
    index: IntArray = np.full(count, len(observed.runs), dtype=np.int64)
    return Observations(
        observed.source,
        (*observed.runs, run),
        np.concatenate([observed.run, index]),
        np.hstack([observed.positions, positions]),
        np.concatenate([observed.reading, np.zeros(count)]),
    )


def companions(unknowns: tuple[Unknowns, ...], run: int) -> tuple[int, ...]:
    """The runs that share unknowns of instruments with a run, itself among them."""
    return next((one.runs for one in unknowns if run in one.runs), (run,))
