"""What given values are uncertain by is no change of the machine."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from tests.diagnosis.prepared import SIGMA, FloatArray, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.judging.stale import Changes, stale_values
from trueaxis.diagnosis.null_model.base import given_by_chance
from trueaxis.diagnosis.null_model.freedom import freedom_of
from trueaxis.diagnosis.null_model.null import Null
from trueaxis.diagnosis.null_model.outliers import null_of
from trueaxis.diagnosis.procedure import diagnose
from trueaxis.measurement.reading_model import expected_readings
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.errors import CovarianceLink, ErrorValues
from trueaxis.model.own_uncertainty import own_uncertainty

FEW = Design(lines=2, repeats=2, targets=11, samples=36)
SHARE = 0.05  # of what is expected of the machine, by which its values are uncertain


@cache
def null() -> Null:
    case = prepared(Case(seed=1, design=FEW, noise="none", given="exact"))
    noise = SIGMA * np.random.default_rng(1).standard_normal(case.rows.size)
    return null_of(case.model, case.rows, noise, 1e3 * SIGMA)


def changes(null: Null, change: FloatArray, given: FloatArray) -> Changes:
    """change: (of_machine,), of the values, in units of what is expected."""
    values = null.values + null.base.machine @ (null.base.expected[: null.base.of_machine] * change)
    freedom = freedom_of(null.rows, null.whitening, null.noise)
    return stale_values(replace(null, values=values, given=given), (), (), freedom)


def test_a_change_within_the_uncertainty_of_the_values_is_none() -> None:
    ground = null()
    exact = np.zeros((ground.base.of_machine, 0))
    uncertain = SHARE * np.eye(ground.base.of_machine)
    off = SHARE * np.random.default_rng(2).standard_normal(ground.base.of_machine)
    assert changes(ground, off, exact).p_value < 1e-9
    found = changes(ground, off, uncertain)
    assert found.stale == ()
    assert found.p_value > 1e-2


def test_a_change_beyond_it_is_still_found() -> None:
    ground = null()
    worn = np.where(np.array(ground.base.components) == "EYY", 1.0, 0.0)
    (one, *_) = changes(ground, worn, SHARE * np.eye(ground.base.of_machine)).stale
    assert one.component == "EYY"


def test_what_values_are_uncertain_by_is_what_readings_are() -> None:
    case = prepared(Case(seed=1, design=FEW, noise="none", given="exact"))
    curve = PolynomialCurve(powers=(1, 3), coefficients=(0.0, 0.0), u=(2e-6, 3e-12))
    dimensions = {name: case.model.errors.parameters[name] for name in case.model.dimensions}
    errors = ErrorValues(
        machine=case.model.name,
        parameters={**dimensions, "eps_xy": 0.0},
        motion_errors={"EXX": curve},
        u={"eps_xy": 1e-6},
    )
    ground, rows = null(), case.rows
    given = given_by_chance(case.model, ground.base, own_uncertainty(case.model.machine, errors))
    columns = ground.base.machine @ (ground.base.expected[: ground.base.of_machine, np.newaxis] * given)

    def read(values: ErrorValues) -> FloatArray:
        model = case.model.with_values(values)
        return expected_readings(model, rows.runs, rows.run, rows.positions, rows.context)

    steps = [
        replace(errors, motion_errors={"EXX": PolynomialCurve(powers=(1, 3), coefficients=(2e-6, 0.0))}),
        replace(errors, motion_errors={"EXX": PolynomialCurve(powers=(1, 3), coefficients=(0.0, 3e-12))}),
        replace(errors, parameters={**dimensions, "eps_xy": 1e-6}),
    ]
    wanted = np.array([read(one) - read(errors) for one in steps]).T
    assert columns @ columns.T == pytest.approx(wanted @ wanted.T, abs=1e-5 * float(np.max(wanted**2)))


def test_values_whose_covariance_is_elsewhere_are_not_taken_as_exact() -> None:
    case = prepared(Case(seed=1, design=FEW, noise="none", given="exact"))
    linked = replace(case.model.errors, covariance=CovarianceLink("E.npz", "0"))
    with pytest.raises(ValueError, match=r"E\.npz.*load_uncertainty"):
        diagnose(case.model.with_values(linked), case.data)
