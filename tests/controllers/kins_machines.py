"""Machines with curves of every form, and the exact position of their tool by a chain of matrices of the tests' own."""

from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import mpmath
import numpy as np

from tests.controllers.kins_module import KinsModule, bodies_text, compiled, write_module
from tests.exact_chain import DIGITS, ExactChain
from tests.kept import derived
from tests.machines import ROOT
from trueaxis.machine import Machine
from trueaxis.model.bases import travel_basis
from trueaxis.model.curves import Curve, LegendreCurve, PolynomialCurve, TableCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, load_model

LINEAR = "XYZ"
EXACT = 1e-11  # mm
OFFSET = (0.5, -0.75, 120.25)  # of G43, mm


@cache
def machine_model(name: str) -> MachineModel:
    return load_model(_spec(name), None, kernels_folder(name).parent, backend="numpy")


def kernels_folder(name: str) -> Path:
    """What is derived of one of the machines that are checked in."""
    return derived(_spec(name)) / name


def _spec(name: str) -> Path:
    return ROOT / "machines" / f"{name}.toml"


def with_random_errors(model: MachineModel, seed: int) -> MachineModel:
    """Errors of about 20 um, 20 urad over the travel; the forms of curves take turns. Dimensions of some 100 mm."""
    draw = np.random.default_rng(seed)
    curves: dict[str, Curve] = {}
    for number, name in enumerate(model.components):
        size = 2e-5 if name.is_rotation else 2e-2
        curves[name] = _curve(number % 4, model.travel[name.axis], size, name.axis in "ABC", draw)
    curves.pop(model.components[0])  # one that is silent
    parameters = {name: float(draw.normal() * 100.0) for name in model.dimensions}
    for parameter in model.location_errors:
        parameters[parameter] = float(
            draw.normal() * (5e-5 if model.machine.parameter_unit(parameter) == "rad" else 0.02)
        )
    return model.with_values(ErrorValues(machine=model.name, parameters=parameters, motion_errors=curves))


def _curve(form: int, travel: tuple[float, float], size: float, turns: bool, draw: np.random.Generator) -> Curve:
    low, high = travel
    longest = max(abs(low), abs(high))
    if form == 0:
        return PolynomialCurve(
            powers=(3, 1), coefficients=tuple(float(size * draw.normal() / longest**power) for power in (3, 1))
        )
    if form == 1:
        inside = np.sort(draw.uniform(low, high, 9))
        return TableCurve(tuple(inside.tolist()), tuple((size * draw.normal(size=9)).tolist()))
    if form == 2:
        basis = travel_basis(travel, 6, harmonics=3 if turns else 0)
        coefficients = size * draw.normal(size=basis.count)
        return LegendreCurve(basis=basis, coefficients=tuple(coefficients.tolist()))
    powers = tuple(range(8))
    return PolynomialCurve(
        powers=powers, coefficients=tuple(float(size * draw.normal() / longest**power) for power in powers)
    )


class ExactMachine:
    """The tool point of a machine in 40 digits, from the text of its spec and the definitions of docs/files.md."""

    def __init__(self, model: MachineModel) -> None:
        self.machine: Machine = model.machine
        self.chain = ExactChain(bodies_text(model.machine))
        self.curves = model.errors.motion_errors
        self.parameters = {name: DIGITS.mpf(value) for name, value in model.errors.parameters.items()}

    def errors_at(self, pose: Mapping[str, float]) -> dict[str, Any]:
        return {name: exact_curve(curve, pose[name[2]]) for name, curve in self.curves.items()}

    def actual(self, pose: Mapping[str, float], point: Sequence[Any], more: Mapping[str, float] | None = None) -> Any:
        """more: what effects add to components, mm or rad."""
        values = self.parameters | self.errors_at(pose)
        for name, value in (more or {}).items():
            values[name] = values.get(name, DIGITS.mpf(0)) + DIGITS.mpf(value)
        return self.chain.place("tool_in_workpiece", pose, values, point)

    def ideal(self, pose: Mapping[str, float], point: Sequence[Any]) -> Any:
        dimensions = {name: self.parameters[name] for name in self.machine.dimensions if name in self.parameters}
        return self.chain.place("tool_in_workpiece", pose, dimensions, point)

    def tip(self, offset: Sequence[float], point: Sequence[float] = (0.0, 0.0, 0.0)) -> list[Any]:
        """The tool point with an offset of G43: it lies back by as much as the axes then move the tool."""
        home = dict.fromkeys(self.machine.axes, 0.0)
        moved = home | dict(zip(LINEAR, offset, strict=True))
        way = self.ideal(moved, [0, 0, 0]) - self.ideal(home, [0, 0, 0])
        return [DIGITS.mpf(point[row]) - way[row] for row in range(3)]


def exact_curve(curve: Curve, position: float) -> Any:
    """A curve as docs/files.md defines it."""
    at = DIGITS.mpf(position)
    match curve:
        case PolynomialCurve():
            return DIGITS.fsum(
                DIGITS.mpf(c) * at**power for power, c in zip(curve.powers, curve.coefficients, strict=True)
            )
        case TableCurve():
            return _exact_table(curve, at)
        case LegendreCurve(basis=basis):
            home = min(max(0.0, basis.low), basis.high)
            return _legendre_sum(curve, at) - _legendre_sum(curve, home)


def _exact_table(curve: TableCurve, at: Any) -> Any:
    positions, values = (list(map(DIGITS.mpf, each)) for each in (curve.positions, curve.values))
    if at <= positions[0] or at >= positions[-1]:
        return values[0] if at <= positions[0] else values[-1]
    above = next(index for index, position in enumerate(positions) if position > at)
    share = (at - positions[above - 1]) / (positions[above] - positions[above - 1])
    return values[above - 1] + share * (values[above] - values[above - 1])


def _legendre_sum(curve: LegendreCurve, at: Any) -> Any:
    low, high = DIGITS.mpf(curve.basis.low), DIGITS.mpf(curve.basis.high)
    scaled = (2 * min(max(DIGITS.mpf(at), low), high) - low - high) / (high - low)
    each, degree = list(map(DIGITS.mpf, curve.coefficients)), curve.basis.degree
    polynomials = DIGITS.fsum(c * mpmath.legendre(k, scaled) for k, c in enumerate(each[:degree], 1))
    angle, waves = DIGITS.radians(DIGITS.mpf(at)), each[degree:]
    pairs = enumerate(zip(waves[::2], waves[1::2], strict=True), 1)
    return polynomials + DIGITS.fsum(c * DIGITS.cos(k * angle) + s * DIGITS.sin(k * angle) for k, (c, s) in pairs)


def length(vector: Any) -> float:
    return float(DIGITS.sqrt(DIGITS.fsum(part**2 for part in vector)))


def poses(model: MachineModel, count: int, seed: int) -> list[dict[str, float]]:
    """Random ones within the travel, and two corners."""
    draw = np.random.default_rng(seed)
    corners = [{axis: model.travel[axis][end] for axis in model.axes} for end in (0, 1)]
    return corners + [{axis: float(draw.uniform(*model.travel[axis])) for axis in model.axes} for _ in range(count)]


def built(folder: Path, model: MachineModel, *flags: str, kernels: Path | None = None) -> Path:
    return compiled(write_module(folder / "module", model, kernels or kernels_folder(model.name)), *flags)


def joints_of(module: KinsModule, pose: Mapping[str, float], axes: tuple[str, ...]) -> dict[str, float]:
    code, joints = module.inverse(pose, len(axes))
    assert code == 0
    return dict(zip(axes, joints, strict=True))
