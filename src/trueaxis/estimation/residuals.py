"""What the exact model with estimated unknowns leaves of the readings."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from trueaxis.estimation.instruments import own_columns, shared_column
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.estimation.set_up import ball_of
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import expected_reading
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel

CENTRE = "ballbar centre"


def residual_of(
    layout: Layout, model: MachineModel, measured: MeasuredRun, unknowns: FloatArray, own: FloatArray
) -> FloatArray:
    """(n,), mm: readings of a run less what `model`, with the estimated errors, and its instrument let expect.

    unknowns: (n_unknowns,), own: (k,), mm, rad or 1. The balls of ball bars stand where they were found.
    """
    rows = measured.rows
    centre, added = np.zeros(3), np.zeros(rows.positions.shape[1])
    for unknown, value in zip(layout.shared, unknowns[layout.of_shared].tolist(), strict=True):
        if rows.index in unknown.runs and unknown.kind == CENTRE:
            centre[unknown.coordinate] += value
        elif rows.index in unknown.runs and value:
            added += value * shared_column(layout.model, rows.run, unknown, rows.positions)
    straight = layout.straightness[rows.index]
    columns = own_columns(layout.model, rows.run, straight, rows.positions, rows.passed)
    linear = own.size
    if rows.run.instrument == "ballbar":
        linear -= 3
        centre += own[linear:]
    added += columns[:, :linear] @ own[:linear]
    ground = layout.effects.ground
    context = None if ground is None else ground.context.of(rows.at)
    return measured.reading - expected_reading(model, _moved(rows.run, centre), rows.positions, context) - added


def residuals_of(
    layout: Layout,
    runs: Sequence[MeasuredRun],
    unknowns: FloatArray,
    own: Sequence[FloatArray],
    given: ErrorValues,
) -> list[FloatArray]:
    """Of every run."""
    model = layout.model.with_values(layout.values(unknowns, given))
    return [residual_of(layout, model, one, unknowns, mine) for one, mine in zip(runs, own, strict=True)]


def _moved(run: Run, centre: FloatArray) -> Run:
    if not centre.any():
        return run
    _, ball = ball_of(run)
    there = PointOn(ball.on, tuple((np.array(ball.point) + centre).tolist()))
    return replace(run, target=there) if ball is run.target else replace(run, reference=there)
