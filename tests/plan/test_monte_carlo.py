"""Predicted uncertainties against estimates of `identify --method global` from simulated readings."""

from dataclasses import replace

import numpy as np
import pytest

from tests.identify.data import P9_REGULAR, line, moving, paper_runs
from tests.plan.data import IDEAL, model, observations, plan
from tests.plan.explicit import design, readings, unit_columns
from trueaxis.identify.global_fit.method import identify_global
from trueaxis.identify.global_fit.result import GlobalOptions
from trueaxis.plan.method import PlanOptions, judge
from trueaxis.runtime.errors import ErrorValues

NOISE_UM = 0.4
RUNS = paper_runs(P9_REGULAR)
OBSERVED = observations(RUNS, [line(moving(run), 8) for run in RUNS])


def test_scatter_of_least_squares_is_as_predicted() -> None:
    """4000 draws, squareness known, the equations by finite differences of exact readings."""
    located = dict.fromkeys(model().location_errors, 0.0)
    options = PlanOptions(NOISE_UM, 2, IDEAL, ErrorValues("dmu60p", located))
    predicted = judge(plan(OBSERVED, options)).curves
    matrix = design(model(), OBSERVED, 2)[:, :36]
    noise = np.random.default_rng(2).normal(0.0, NOISE_UM * 1e-3, (OBSERVED.reading.size, 4000))
    estimates = np.linalg.lstsq(unit_columns(matrix), noise, rcond=None)[0]
    estimates /= np.linalg.norm(matrix, axis=0)[:, np.newaxis]
    for index, one in enumerate(predicted):
        knots = np.unique(OBSERVED.positions["XYZ".index(one.name[2])]) / 100.0
        values = np.stack([knots, knots**2]).T @ estimates[2 * index : 2 * index + 2]
        assert values.std(axis=1).max() == pytest.approx(one.u_measured, rel=0.05), one.name


@pytest.mark.slow
def test_scatter_of_identified_errors_is_as_predicted() -> None:
    """80 draws through the exact model, squareness by convention: standard deviations are good to 8 %."""
    report = judge(plan(OBSERVED, PlanOptions(NOISE_UM, 3, IDEAL)))
    exact = readings(model(), OBSERVED, ErrorValues("dmu60p"))
    draw = np.random.default_rng(11)
    curves: dict[str, list[np.ndarray]] = {}
    squareness: dict[str, list[float]] = {}
    for _ in range(80):
        data = replace(OBSERVED, reading=exact + draw.normal(0.0, NOISE_UM * 1e-3, exact.size))
        found = identify_global(model(), data, GlobalOptions(noise_um=NOISE_UM, degree=3, instruments=())).values
        for name in model().components:
            knots = np.unique(OBSERVED.positions["XYZ".index(name[2])])
            curves.setdefault(name, []).append(found.motion_errors[name](knots))
        for name in model().location_errors:
            squareness.setdefault(name, []).append(found.parameters[name])
    ratios = [np.std(curves[one.name], axis=0).max() / one.u_measured for one in report.curves if one.u_measured]
    ratios += [np.std(squareness[one.name]) / one.u for one in report.locations if one.u]
    assert len(ratios) == 21
    assert max(ratios) < 1.3
    assert min(ratios) > 0.75
    assert np.mean(ratios) == pytest.approx(1.0, abs=0.06)
