"""The machine model: error values put through the kernels, against forty digits."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.exact_chain import DIGITS, ExactChain
from tests.kernels import model_of
from tests.machines import FIVE_AXIS
from trueaxis.codegen.render import render
from trueaxis.io.faults import InputError
from trueaxis.io.files import write_files
from trueaxis.model.curves import Curve, PolynomialCurve, TableCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, load_model
from trueaxis.view import VIEWS, View

CHAIN = ExactChain(FIVE_AXIS.read_text())
POLYNOMIALS = {
    "EXX": PolynomialCurve(powers=(1, 3), coefficients=(1e-5, 2e-11)),
    "ECY": PolynomialCurve(powers=(2,), coefficients=(1e-10,)),
    "EBZ": PolynomialCurve(powers=(1, 2), coefficients=(1e-7, -1e-10)),
    "EZC": PolynomialCurve(powers=(1,), coefficients=(1e-4,)),
    "EAB": PolynomialCurve(powers=(1, 7), coefficients=(1e-6, 1e-18)),
}
PARAMETERS = {"q_Tz": 150.0, "q_Hz": -80.0, "q_wx": 100.0, "eps_xz": 2e-5, "eps_Cx": 3e-3, "eps_BA": -4e-5}
AT = [10.0, 20.0, -30.0]
POINT = np.array(AT)[:, None]


@pytest.fixture(scope="module")
def kernels(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("generated")
    files = render(model_of(FIVE_AXIS.read_text()))
    write_files({folder / "five_axis" / name: content for name, content in files.items()})
    return folder


@pytest.fixture(scope="module")
def model(kernels: Path) -> MachineModel:
    empty = load_model(FIVE_AXIS, None, kernels, backend="numpy")
    return empty.with_values(ErrorValues(machine="five_axis", parameters=PARAMETERS, motion_errors=POLYNOMIALS))


def positions(count: int = 4) -> Any:
    rng = np.random.default_rng(8)
    low, high = np.array([(0, 540), (0, 700), (0, 600), (-30, 120), (-180, 180)]).T[:, :, None]
    return rng.uniform(low, high, (5, count))


def exact(view: str, at: Any, what: str = "deviation", curves: Any = POLYNOMIALS) -> Any:
    found = []
    for column in at.T:
        pose = dict(zip(CHAIN.axes, column, strict=True))
        values = dict(PARAMETERS)
        for name, curve in curves.items():
            x = DIGITS.mpf(float(pose[name[2]]))
            values[name] = sum(DIGITS.mpf(c) * x**p for p, c in zip(curve.powers, curve.coefficients, strict=True))
        if what == "ideal":
            values = {name: v for name, v in PARAMETERS.items() if name in CHAIN.dimensions}
        method = CHAIN.deviation if what == "deviation" else CHAIN.place
        found.append([float(v) for v in method(view, pose, values, AT)])
    return np.array(found).T


@pytest.mark.parametrize("view", VIEWS)
def test_every_view_is_that_of_the_matrices(model: MachineModel, view: View) -> None:
    at = positions()
    np.testing.assert_allclose(model.view_deviation(view, at, POINT), exact(view, at), rtol=0, atol=1e-14)
    np.testing.assert_allclose(model.view_ideal(view, at, POINT), exact(view, at, "ideal"), rtol=0, atol=1e-12)


def test_the_deviation_is_the_same_by_curve_kernel_and_by_component_kernel(model: MachineModel) -> None:
    # A point per position, and a curve that no polynomial kernel takes, lead past the curve kernel.
    at = positions(6)
    plain = model.deviation(at, POINT)
    np.testing.assert_allclose(model.deviation(at, np.repeat(POINT, 6, axis=1)), plain, rtol=0, atol=1e-15)
    table: dict[str, Curve] = {**POLYNOMIALS, "EXX": TableCurve((0.0, 540.0), (0.0, 0.0))}
    without = {name: curve for name, curve in POLYNOMIALS.items() if name != "EXX"}
    by_table = model.with_values(
        ErrorValues(machine="five_axis", parameters=PARAMETERS, motion_errors=table)
    ).deviation(at, POINT)
    by_curve = model.with_values(
        ErrorValues(machine="five_axis", parameters=PARAMETERS, motion_errors=without)
    ).deviation(at, POINT)
    np.testing.assert_allclose(by_table, by_curve, rtol=0, atol=1e-15)
    assert np.abs(by_table - plain).max() > 1e-4


def test_powers_beyond_the_curve_kernels_are_not_lost(model: MachineModel) -> None:
    at = positions()
    curves = {"EYY": PolynomialCurve(powers=(0, 9), coefficients=(1e-3, 1e-26))}
    found = model.with_values(ErrorValues(machine="five_axis", parameters=PARAMETERS, motion_errors=curves)).deviation(
        at, POINT
    )
    np.testing.assert_allclose(found, exact("tool_in_workpiece", at, curves=curves), rtol=0, atol=1e-14)


def test_a_machine_without_error_values_has_no_deviation(kernels: Path) -> None:
    model = load_model(FIVE_AXIS, None, kernels, backend="numpy")
    np.testing.assert_array_equal(model.deviation(positions(), POINT), np.zeros((3, 4)))


def test_the_correction_moves_the_tool_point_as_asked(model: MachineModel) -> None:
    at, asked = positions(), np.array([[1e-3], [-2e-3], [3e-3]]) * np.ones(4)
    moves = model.correction(at, asked)
    assert moves.shape == (5, 4)
    np.testing.assert_array_equal(moves[3:], 0)
    np.testing.assert_allclose(model.ideal(at + moves, POINT) - model.ideal(at, POINT), asked, rtol=0, atol=1e-12)


def test_sensitivities_are_in_the_order_of_components_and_location_errors(model: MachineModel) -> None:
    at = positions(1)
    columns = model.view_sensitivity("tool_in_workpiece", at, POINT)
    assert columns.shape == (3, len(model.components) + len(model.location_errors), 1)
    pose = dict(zip(CHAIN.axes, at[:, 0], strict=True))
    step = DIGITS.mpf("1e-15")
    dimensions = {name: value for name, value in PARAMETERS.items() if name in CHAIN.dimensions}
    for name, column in zip(model.components + model.location_errors, columns[:, :, 0].T, strict=True):
        wanted = CHAIN.deviation("tool_in_workpiece", pose, dimensions | {name: step}, AT) / step
        np.testing.assert_allclose(column, [float(v) for v in wanted], rtol=0, atol=1e-11, err_msg=name)


def test_what_is_wrong_with_the_spec_comes_before_kernels_are_asked_for(tmp_path: Path) -> None:
    spec = tmp_path / "bad.toml"
    spec.write_text(FIVE_AXIS.read_text().replace("lower = 8", "lower = 88"))
    with pytest.raises(InputError) as caught:
        load_model(spec, None, tmp_path)
    assert "there is no body 88" in str(caught.value)
