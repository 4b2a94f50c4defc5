"""A machine at places of a path, where effects depend on how its axes come and go there."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.course import Course
from trueaxis.compensation.machine import ErrorModel, FloatArray
from trueaxis.model.context import Context

Rows = NDArray[np.int64] | NDArray[np.bool_] | slice


class ContextModel(ErrorModel, Protocol):
    """A machine whose errors depend on more than positions."""

    def in_context(self, context: Context) -> ErrorModel:
        """The machine at positions that are reached in the context given, one by one."""


@dataclass(frozen=True, slots=True)
class Placed:
    """A machine at n places, each with its own context; positions that are asked for belong to those places."""

    model: ContextModel
    context: Context
    actual: ErrorModel

    @classmethod
    def of_context(cls, model: ContextModel, context: Context) -> "Placed":
        """At the places of a context."""
        return cls(model, context, model.in_context(context))

    def of(self, rows: Rows) -> "Placed":
        """At some of the places."""
        return Placed.of_context(self.model, self.context.of(rows))

    @property
    def axes(self) -> tuple[str, ...]:
        """As ErrorModel has it, and so the rest."""
        return self.model.axes

    @property
    def travel(self) -> Mapping[str, tuple[float, float]]:
        """Lowest and highest position of each axis."""
        return self.model.travel

    def ideal(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Tool point of the error-free machine."""
        return self.model.ideal(positions, point)

    def deviation(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Actual minus ideal tool point, in the context."""
        return self.actual.deviation(positions, point)

    def correction(self, positions: FloatArray, deviation: FloatArray) -> FloatArray:
        """Increments of the axes that move the ideal tool point."""
        return self.model.correction(positions, deviation)

    def orientation_ideal(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        """A direction on the error-free machine."""
        return self.model.orientation_ideal(positions, direction)

    def orientation_deviation(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        """Actual minus ideal direction, in the context."""
        return self.actual.orientation_deviation(positions, direction)


def of_points(model: ErrorModel, rows: Rows) -> ErrorModel:
    """The machine for some of the points that it was to be asked about."""
    return model.of(rows) if isinstance(model, Placed) else model


class Placing(Protocol):
    """Gives the machine at places of the motions of a path."""

    def at(self, motion: NDArray[np.int64], place: FloatArray) -> ErrorModel:
        """At shares `place` (n,) of the motions with the indices `motion` (n,)."""

    def cut(self, motion: NDArray[np.int64], low: FloatArray, high: FloatArray) -> "Placing":
        """The same for a path of pieces, from share `low` to `high` of the motions given."""


@dataclass(frozen=True, slots=True)
class Everywhere:
    """A machine whose errors depend on positions alone."""

    model: ErrorModel

    def at(self, motion: NDArray[np.int64], place: FloatArray) -> ErrorModel:  # noqa: ARG002
        """The machine."""
        return self.model

    def cut(self, motion: NDArray[np.int64], low: FloatArray, high: FloatArray) -> Placing:  # noqa: ARG002
        """The machine."""
        return self


@dataclass(frozen=True, slots=True)
class OnCourse:
    """A machine along the course of its axes; time s, temperature degC."""

    model: ContextModel
    course: Course
    time: float
    temperature: float

    def at(self, motion: NDArray[np.int64], place: FloatArray) -> ErrorModel:
        """The machine in the contexts of those places."""
        return Placed.of_context(self.model, self.course.context(motion, place, self.time, self.temperature))

    def cut(self, motion: NDArray[np.int64], low: FloatArray, high: FloatArray) -> Placing:
        """Along the course of the pieces."""
        return OnCourse(self.model, self.course.cut(motion, low, high), self.time, self.temperature)
