"""The exact machine, its readings and its linear map, against another exact machine, differences and closed forms."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest

from tests.generator import machine as other
from tests.worlds.curves import BASES, draw_curve
from tests.worlds.design import draw_design
from tests.worlds.kinematics import coordinates
from tests.worlds.machine import Array, Machine
from tests.worlds.readings import exact_readings
from tests.worlds.truth import Truth, draw_machine, random_points, span_of

POINT = np.array([12.0, -34.0, 56.0])


def in_extended_precision(
    machine: Machine, errors: Mapping[str, float], located: Mapping[str, float]
) -> other.Generator:
    bodies = tuple(
        other.Body(b.number, b.lower, b.moves or None, b.sense, b.offset, dict(b.located)) for b in machine.bodies
    )
    frames = {"bed": 1, "workpiece": machine.workpiece, "tool": machine.tool}
    values = {name: (lambda _, value=value: other.exact(value)) for name, value in errors.items()}
    rotations: other.Rotations = "true" if machine.true_rotations else "small"
    return other.Generator(bodies, machine.axes, frames, located, values, rotations)


@pytest.mark.parametrize("seed", range(1, 13))
@pytest.mark.parametrize("true_rotations", [False, True])
def test_points_are_where_the_machine_of_extended_precision_has_them(seed: int, true_rotations: bool) -> None:
    machine = replace(draw_design(seed).machine, true_rotations=true_rotations)
    source = np.random.default_rng(seed)
    errors = {name: float(1e-3 * source.normal()) for name in machine.components}
    located = {name: float(1e-3 * source.normal()) for name in machine.locations}
    exact = in_extended_precision(machine, errors, located)
    positions = random_points(machine, seed, 2)
    arrays = {name: np.array([value]) for name, value in errors.items()}
    fixed = {name: np.array(value) for name, value in located.items()}
    for end, frame in (("tool", "workpiece"), ("tool", "bed"), ("workpiece", "bed"), ("bed", "workpiece")):
        found = coordinates(machine, end, frame, positions, POINT, arrays, fixed)
        for k in range(2):
            pose = {axis: float(values[k]) for axis, values in positions.items()}
            expected = exact.coordinates(end, frame, pose, POINT)
            assert found[k] == pytest.approx(expected.astype(float), abs=1e-10)


@pytest.mark.parametrize("seed", [1, 3, 8, 10])
def test_the_linear_map_is_the_derivative_of_exact_readings(seed: int) -> None:
    """Symmetric differences; errors of 1e-5 leave a third order below 1e-9."""
    design = draw_design(seed)
    machine, jac = design.machine, design.jacobian
    truth = draw_machine(machine, seed)
    scaled = [small(truth, factor) for factor in (1e-2, -1e-2)]
    plus, minus = exact_readings(design, scaled)
    linear = np.zeros(design.plan.count)
    for name, curve in truth.curves.items():
        axis = name[2]
        linear += jac.here[name] * curve(jac.at[axis]) - jac.home[name] * curve(jac.at_home[axis])
    for name, value in truth.located.items():
        linear += jac.located[name] * value
    assert (plus - minus) / 2e-2 == pytest.approx(linear, abs=1e-7 * np.max(np.abs(linear)))
    assert (plus + minus) / 2 == pytest.approx(jac.ideal, abs=1e-6)


def small(truth: Truth, factor: float) -> Truth:
    curves = {name: replace(curve, coefficients=factor * curve.coefficients) for name, curve in truth.curves.items()}
    return replace(truth, curves=curves, located={name: factor * value for name, value in truth.located.items()})


def test_many_machines_at_once_read_as_each_alone() -> None:
    design = draw_design(12)
    truths = [draw_machine(design.machine, seed) for seed in range(20)]
    together = exact_readings(design, truths)
    for k in (0, 17):
        assert together[k] == pytest.approx(exact_readings(design, [truths[k]])[0], abs=1e-12)


@pytest.mark.parametrize("family", BASES)
def test_curves_are_zero_at_home_and_of_the_size_they_are_said_to_have(family: str) -> None:
    source = np.random.default_rng(5)
    for seed in (1, 3, 4):
        machine = draw_design(seed).machine
        for axis in machine.axes:
            span = span_of(machine, axis)
            q = np.linspace(span.low, span.high, 101)
            drawn = [draw_curve(source, family, span, 2e-3) for _ in range(150)]
            assert max(abs(float(curve(np.array([span.home]))[0])) for curve in drawn) < 1e-15
            size = np.sqrt(np.mean([curve(q) ** 2 for curve in drawn]))
            assert size == pytest.approx(2e-3, rel=0.2)


def test_smooth_curves_are_no_polynomials_of_low_degree_and_their_modes_hold_them() -> None:
    machine = draw_design(1).machine
    span = span_of(machine, "X")
    q: Array = np.linspace(span.low, span.high, 201)
    source = np.random.default_rng(6)
    drawn = np.array([draw_curve(source, "smooth", span, 8e-3)(q) for _ in range(40)]).T
    cubic = np.polynomial.chebyshev.chebvander(span.scaled(q), 3)
    modes = BASES["smooth"](span)(q)
    left = [
        values - basis @ np.linalg.lstsq(basis, values, rcond=None)[0] for basis in (cubic, modes) for values in [drawn]
    ]
    assert np.median(np.sqrt(np.mean(left[0] ** 2, axis=0))) > 2e-4
    assert np.sqrt(np.mean(left[1] ** 2)) < 3e-5


def test_a_deviation_from_home_is_zero_at_home() -> None:
    for seed in (4, 8):
        truth = draw_machine(draw_design(seed).machine, 3)
        home = {axis: np.array([truth.machine.home(axis)]) for axis in truth.machine.axes}
        assert truth.deviation(home, POINT, "home") == pytest.approx(0.0, abs=1e-15)
        assert np.any(np.abs(truth.deviation(random_points(truth.machine, 1, 5), POINT, "home")) > 1e-4)
