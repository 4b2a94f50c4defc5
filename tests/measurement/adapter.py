"""The independent generator as a machine model to measure, and the facts of its machine."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from tests.generator.dmu60p import TRAVEL
from tests.generator.machine import Exact, Generator
from trueaxis.measurement.machine import FloatArray
from trueaxis.view import View


@dataclass(frozen=True)
class Dmu60pAxes:
    name: str = "dmu60p"
    axes: tuple[str, ...] = ("X", "Y", "Z")

    @property
    def travel(self) -> Mapping[str, tuple[float, float]]:
        return TRAVEL


@dataclass(frozen=True)
class GeneratorModel:
    generator: Generator

    @property
    def axes(self) -> tuple[str, ...]:
        return self.generator.axes

    def view_ideal(self, view: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        return self._each(view, positions, point, deviation=False)

    def view_deviation(self, view: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        return self._each(view, positions, point, deviation=True)

    def view_deviations(self, points: Sequence[tuple[View, FloatArray]], positions: FloatArray) -> list[FloatArray]:
        return [self.view_deviation(view, positions, point) for view, point in points]

    def _each(self, view: View, positions: FloatArray, point: FloatArray, deviation: bool) -> FloatArray:
        body, _, frame = view.partition("_in_")
        points = np.broadcast_to(point, (3, positions.shape[1]))
        found = np.zeros((3, positions.shape[1]))
        for n in range(positions.shape[1]):
            pose = dict(zip(self.axes, positions[:, n], strict=True))
            value: Exact = (
                self.generator.deviation(body, frame, pose, points[:, n])
                if deviation
                else self.generator.coordinates(body, frame, pose, points[:, n], actual=False)
            )
            found[:, n] = value.astype(np.float64)
        return found
