"""The curve kernels: against the kernels of component errors at the curves' values, and against forty digits."""

from typing import Any

import numpy as np
import pytest

from tests.derivation.topologies import OTHERS
from tests.exact_chain import DIGITS, ExactChain
from tests.kernels import call, kernels_of, model_of

LABELS = ("dmu60p", "five_axis", "shared", "table B, head A")
COUNT, DEGREE = 50, 7


def drawn(label: str) -> tuple[Any, Any, Any, Any, Any]:
    """Positions (n_axes, n), coefficients that give errors of 20 um and 100 urad, parameters, a point, the errors."""
    meta, rng = kernels_of(OTHERS[label]).META, np.random.default_rng(3)
    positions = rng.uniform(-300, 500, (len(meta["axes"]), COUNT))
    sizes = np.array([2e-2 if unit == "mm" else 1e-4 for unit in meta["component_units"]])[:, None]
    powers = np.arange(1, DEGREE + 1)
    curves = sizes * rng.uniform(-1, 1, (len(sizes), DEGREE)) / 500.0**powers
    parameters = np.array(
        [
            rng.uniform(-1e-4, 1e-4) if n in meta["location_errors"] else rng.uniform(-400, 400)
            for n in meta["parameters"]
        ]
    )
    at = positions[[meta["axes"].index(name[2]) for name in meta["components"]]]
    errors = np.array([[horner(c, x) for x in row] for c, row in zip(curves, at, strict=True)])
    return positions, curves, parameters, rng.uniform(-200, 200, 3), errors


def horner(coefficients: Any, at: float) -> float:
    """In forty digits, rounded once."""
    value = DIGITS.mpf(0)
    for c in reversed(coefficients):
        value = (value + DIGITS.mpf(float(c))) * DIGITS.mpf(float(at))
    return float(value)


@pytest.mark.parametrize("label", LABELS)
@pytest.mark.parametrize("order", ["", "_first_order"])
def test_curves_give_what_their_values_give(label: str, order: str) -> None:
    module = kernels_of(OTHERS[label])
    positions, curves, parameters, point, errors = drawn(label)
    found = getattr(module, f"tool_in_workpiece_deviation{order}_curves")(positions, curves, parameters, point)
    values = getattr(module, f"tool_in_workpiece_deviation{order}")(positions, errors, parameters, point[:, None])
    assert np.abs(values).max(axis=1).min() > 1e-3
    np.testing.assert_allclose(found, values, rtol=0, atol=1e-12 * np.abs(values).max())


@pytest.mark.parametrize("label", LABELS)
def test_exact_curves_are_those_of_the_matrices(label: str) -> None:
    chain, module = ExactChain(OTHERS[label]), kernels_of(OTHERS[label])
    positions, curves, parameters, point, errors = drawn(label)
    found = module.tool_in_workpiece_deviation_curves(positions, curves, parameters, point)
    for at in (0, 17, 49):
        pose = dict(zip(chain.axes, positions[:, at], strict=True))
        values = dict(zip(chain.components, errors[:, at], strict=True))
        values |= dict(zip(chain.dimensions + chain.location_errors, parameters, strict=True))
        wanted = [float(v) for v in chain.deviation("tool_in_workpiece", pose, values, point)]
        np.testing.assert_allclose(found[:, at], wanted, rtol=0, atol=1e-14)


@pytest.mark.parametrize("label", LABELS)
def test_first_order_curves_take_the_form_of_fewer_operations(label: str) -> None:
    # Folding makes one polynomial of all that share a monomial: fewer on linear axes, more on rotary ones. Whichever
    # is emitted must not cost more than the plain form, curves evaluated one by one and put into the first order.
    routines = kernels_of(OTHERS[label]).META["routines"]
    components = len(kernels_of(OTHERS[label]).META["components"])
    plain = routines["tool_in_workpiece_deviation_first_order"]["operations"] + components * (2 * DEGREE - 1)
    assert routines["tool_in_workpiece_deviation_first_order_curves"]["operations"] <= plain


def test_coefficients_are_those_of_the_powers_from_one_upwards() -> None:
    module = kernels_of(OTHERS["dmu60p"])
    curves = np.zeros((18, 7))
    curves[module.META["components"].index("EXX")] = [1e-3, 1e-5, 0, 0, 0, 0, 0]
    for name in ("tool_in_workpiece_deviation_curves", "tool_in_workpiece_deviation_first_order_curves"):
        found = getattr(module, name)(np.array([[10.0], [0.0], [0.0]]), curves, np.zeros(9), np.zeros(3))
        np.testing.assert_allclose(found[:, 0], [1e-2 + 1e-3, 0, 0], rtol=1e-15)


def test_an_axis_that_moves_the_other_way_has_its_errors_at_the_commanded_position() -> None:
    # The C table of the five-axis machine has sense -1: at C = +90 commanded, ECC is that of +90.
    module = kernels_of(OTHERS["five_axis"])
    curves = np.zeros((len(module.META["components"]), 7))
    curves[module.META["components"].index("EZC"), 0] = 1e-4
    positions = np.zeros((5, 1))
    positions[module.META["axes"].index("C")] = 90.0
    found = module.tool_in_workpiece_deviation_curves(
        positions, curves, np.zeros(len(module.META["parameters"])), np.zeros(3)
    )
    np.testing.assert_allclose(found[:, 0], [0, 0, -9e-3], atol=1e-17)
    direct = call(module, "tool_in_workpiece_deviation", {"C": 90.0}, {"EZC": 9e-3}, np.zeros((3, 1)))
    np.testing.assert_allclose(found, direct, atol=1e-17)


def test_a_decimal_position_costs_what_a_whole_one_costs() -> None:
    spec = """schema = 1
name = "mill"
title = "Mill"
structure = "[w Y' b X Z t]"
[axis.X]
travel = [0.0, 500.0]
position = [POSITION]
[axis.Y]
travel = [0.0, 500.0]
[axis.Z]
travel = [0.0, 500.0]
"""
    whole, decimal = (
        {routine.name: routine.operations for routine in model_of(spec.replace("POSITION", position)).routines}
        for position in ("332.0, 212.0, -274.0", "332.22, 212.95, -274.61")
    )
    assert decimal == whole
