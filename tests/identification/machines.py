"""A machine model in plain numpy, to identify with: 4x4 matrices multiplied out in extended precision (a deviation is
a difference of large numbers here), derivatives by complex step.

Written from the contract alone; the readings come from the extended-precision generator, not from here.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from tests.generator.dmu60p import BODIES, TRAVEL
from tests.generator.machine import Body
from trueaxis.error_name import ErrorName
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.curves import evaluate_components
from trueaxis.model.errors import ErrorValues
from trueaxis.view import View

LETTERS = "XYZABC"
STEP = 1e-30


@dataclass(frozen=True)
class PlainMachine:
    """Bodies as in tests.generator; motion errors of every axis."""

    bodies: tuple[Body, ...]
    axes: tuple[str, ...]
    travel: Mapping[str, tuple[float, float]]
    frames: Mapping[str, int]
    dimensions: tuple[str, ...]
    location_errors: tuple[str, ...]
    name: str = "dmu60p"
    values: ErrorValues = field(default_factory=lambda: ErrorValues(machine="dmu60p"))
    differentiated: dict[Any, FloatArray] = field(default_factory=dict)

    @property
    def components(self) -> tuple[ErrorName, ...]:
        return tuple(ErrorName(f"E{direction}{axis}") for axis in self.axes for direction in LETTERS)

    @property
    def parameters(self) -> tuple[str, ...]:
        return self.dimensions + self.location_errors

    def with_values(self, errors: ErrorValues) -> "PlainMachine":
        return replace(self, values=errors)

    def view_ideal(self, view: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        return np.asarray(self._seen_ideal(view, positions, point), dtype=np.float64)

    def view_deviation(self, view: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        rows = [self.axes.index(name[2]) for name in self.components]
        errors = evaluate_components(self.values.motion_errors, self.components, rows, positions)
        actual = self._seen(view, positions, point, errors, self._located(zero=False)).real
        return np.asarray(actual - self._seen_ideal(view, positions, point), dtype=np.float64)

    def view_deviations(self, points: Sequence[tuple[View, FloatArray]], positions: FloatArray) -> list[FloatArray]:
        return [self.view_deviation(view, positions, point) for view, point in points]

    def view_sensitivity(self, view: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        dimensions = tuple(self.values.parameters.get(name, 0.0) for name in self.dimensions)
        key = (view, positions.tobytes(), point.tobytes(), dimensions)
        if key not in self.differentiated:
            self.differentiated[key] = self._differentiated(view, positions, point)
        return self.differentiated[key]

    def _differentiated(self, view: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        found = []
        for index in range(len(self.components)):
            errors = self._no_errors(positions).astype(np.clongdouble)
            errors[index] += 1j * STEP
            found.append(self._seen(view, positions, point, errors, self._located(zero=True)).imag / STEP)
        for name in self.location_errors:
            located = {**self._located(zero=True), name: 1j * STEP}
            found.append(self._seen(view, positions, point, self._no_errors(positions), located).imag / STEP)
        return np.ascontiguousarray(np.array(found, dtype=np.float64).swapaxes(0, 1))

    def _seen_ideal(self, view: View, positions: FloatArray, point: FloatArray) -> Any:
        return self._seen(view, positions, point, self._no_errors(positions), self._located(zero=True)).real

    def _no_errors(self, positions: FloatArray) -> FloatArray:
        return np.zeros((len(self.components), positions.shape[1]))

    def _located(self, zero: bool) -> dict[str, Any]:
        return {name: 0.0 if zero else self.values.parameters.get(name, 0.0) for name in self.location_errors}

    def _seen(
        self, view: str, positions: FloatArray, point: FloatArray, errors: Any, located: Mapping[str, Any]
    ) -> Any:
        body, _, frame = view.partition("_in_")
        n = positions.shape[1]
        points = np.vstack([np.broadcast_to(point, (3, n)), np.ones((1, n))]).T[:, :, np.newaxis]
        to_bed = self._to_bed(self.frames[body], positions, errors, located)
        frame_to_bed = self._to_bed(self.frames[frame], positions, errors, located)
        at_bed = (to_bed @ points)[:, :3] - frame_to_bed[:, :3, 3:]
        return (inverse3(frame_to_bed[:, :3, :3]) @ at_bed)[:, :, 0].T

    def _to_bed(self, number: int, positions: FloatArray, errors: Any, located: Mapping[str, Any]) -> Any:
        total = np.broadcast_to(np.eye(4, dtype=np.clongdouble), (positions.shape[1], 4, 4))
        while number != 1:
            body = self._body[number]
            total = self._joint(body, positions, errors, located) @ total
            number = body.lower
        return total

    def _joint(self, body: Body, positions: FloatArray, errors: Any, located: Mapping[str, Any]) -> Any:
        at = [self.values.parameters.get(p, 0.0) if isinstance(p, str) else p for p in body.position]
        by = {direction: located[name] for direction, name in body.position_errors.items()}
        matrix = shifted(at) @ erring([by.get(f"E{letter}", 0.0) for letter in LETTERS])
        if body.moves is None:
            return matrix
        along = body.sense * positions[self.axes.index(body.moves)]
        start = len(LETTERS) * self.axes.index(body.moves)
        return matrix @ moved(body.moves, along) @ erring(list(errors[start : start + len(LETTERS)]))

    @cached_property
    def _body(self) -> dict[int, Body]:
        return {body.number: body for body in self.bodies}


def inverse3(matrices: Any) -> Any:
    """By cofactors: numpy has no extended-precision solver."""
    a, b, c = (matrices[:, row] for row in range(3))
    columns = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)], axis=2)
    return columns / np.einsum("ni,ni->n", a, columns[:, :, 0])[:, np.newaxis, np.newaxis]


def shifted(by: Any) -> Any:
    matrix = np.eye(4, dtype=np.clongdouble)
    matrix[:3, 3] = by
    return matrix


def moved(axis: str, along: FloatArray) -> Any:
    matrix = np.zeros((along.size, 4, 4), dtype=np.clongdouble)
    matrix[:] = np.eye(4)
    if axis in "XYZ":
        matrix[:, "XYZ".index(axis), 3] = along
        return matrix
    first, second = {"A": (1, 2), "B": (2, 0), "C": (0, 1)}[axis]
    cosine, sine = np.cos(np.deg2rad(along)), np.sin(np.deg2rad(along))
    matrix[:, first, first] = matrix[:, second, second] = cosine
    matrix[:, second, first], matrix[:, first, second] = sine, -sine
    return matrix


def erring(values: list[Any]) -> Any:
    x, y, z, a, b, c = np.broadcast_arrays(
        *(np.atleast_1d(np.asarray(value, dtype=np.clongdouble)) for value in values)
    )
    one, zero = np.ones_like(x), np.zeros_like(x)
    rows = [[one, -c, b, x], [c, one, -a, y], [-b, a, one, z], [zero, zero, zero, one]]
    return np.moveaxis(np.array(rows), 2, 0)


def dmu60p() -> PlainMachine:
    dimensions = ("q_wx", "q_wy", "q_wz", "q_Tx", "q_Ty", "q_Tz")
    frames = {"bed": 1, "workpiece": 4, "tool": 9}
    return PlainMachine(BODIES, ("X", "Y", "Z"), TRAVEL, frames, dimensions, ("eps_xy", "eps_yz", "eps_xz"))
