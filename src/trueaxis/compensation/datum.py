"""Work offsets that were touched off without compensation: where the datum of the part truly is, and the machine as a
program sees it from there.

A control without compensation holds for the zero what it displays, the axis positions p0 where a probe touched; the
place that it touched is off by the deviation u(p0) of the probe there. A part is right against its datum where the tool
reaches the ideal place moved by u(p0). In the workpiece frame that is one vector for the whole program: the datum is a
place of the workpiece, which it keeps whichever way a rotary table turns it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from trueaxis.compensation.course import ContextModel
from trueaxis.compensation.machine import ErrorModel, FloatArray, linear_jacobian, linear_rows
from trueaxis.compensation.tools import Tool, tool_point_of
from trueaxis.compensation.touched_off import OPTION, TouchedOff
from trueaxis.model.context import Context


def datum_shift(
    model: ErrorModel, touched: Sequence[TouchedOff], zero: Mapping[str, float], tool_point: FloatArray
) -> FloatArray:
    """By how much the true datum lies off the one that the control holds, workpiece frame, mm, (3, 1).

    touched: of one work offset, all linear axes once; zero: machine position of its zero by axis; tool_point: (3, 1),
    that lengths are measured from. Touched off along an axis, the deviation counts in the direction in which that axis
    moves the tool; directions of axes that the machine does not have count as in the first place.
    """
    ways, amounts = [], []
    for one in touched:
        at = np.array(one.position(model.axes, zero))[:, np.newaxis]
        point = tool_point_of(model, Tool(one.length) if one.length else None, tool_point)
        off = model.deviation(at, point)[:, 0]
        moves = linear_jacobian(model, at, point)[:, :, 0]
        for column, row in enumerate(linear_rows(model.axes)):
            if model.axes[row] in one.directions:
                ways.append(moves[:, column])
                amounts.append(moves[:, column] @ off)
        if one is touched[0] and len(linear_rows(model.axes)) < off.size:
            across = np.linalg.svd(moves.T)[2][moves.shape[1] :]
            ways += list(across)
            amounts += list(across @ off)
    return np.asarray(np.linalg.solve(np.array(ways), np.array(amounts))[:, np.newaxis])


@dataclass(frozen=True, slots=True)
class FromDatum:
    """The machine `base` from a datum that lies off by (3, 1), mm, workpiece frame."""

    base: ErrorModel
    off: FloatArray

    @property
    def axes(self) -> tuple[str, ...]:
        """As ErrorModel has it, and so the rest."""
        return self.base.axes

    @property
    def travel(self) -> Mapping[str, tuple[float, float]]:
        """Lowest and highest position of each axis."""
        return self.base.travel

    def ideal(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Tool point of the error-free machine."""
        return self.base.ideal(positions, point)

    def deviation(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Actual minus ideal tool point, both from the datum."""
        return self.base.deviation(positions, point) - self.off

    def correction(self, positions: FloatArray, deviation: FloatArray) -> FloatArray:
        """Increments of the axes that move the ideal tool point."""
        return self.base.correction(positions, deviation)

    def orientation_ideal(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        """A direction on the error-free machine."""
        return self.base.orientation_ideal(positions, direction)

    def orientation_deviation(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        """Actual minus ideal direction: a datum does not turn."""
        return self.base.orientation_deviation(positions, direction)


@dataclass(frozen=True, slots=True)
class FromDatumOnCourse(FromDatum):
    """The same of a machine whose errors depend on more than positions."""

    base: ContextModel

    def in_context(self, context: Context) -> ErrorModel:
        """The machine at positions that are reached in the context given, one by one."""
        return FromDatum(self.base.in_context(context), self.off)


_STEP = 1.0  # mm, deg: either side, for the slope
_SEEN = 0.0005  # mm: half of what is usually the last digit of a work offset


@dataclass(frozen=True, slots=True, kw_only=True)
class Zero:
    """Where a work offset's zero truly is. off: deviation of the tool point, X Y Z of the workpiece frame, mm, where it
    was touched off, if it was; else at its zero, at the machine position `at` (mm and deg; the place within the travel
    next to it). length: of the tool that stood there, mm; turned: rotary positions there that are not those of its
    zero, deg.
    """

    touched_off: bool
    at: Mapping[str, float]
    off: tuple[float, float, float]
    length: float
    turned: Mapping[str, float]

    def sentence(self, system: str) -> str:
        """What that means for the part."""
        named = " ".join(f"d{axis} {1e3 * part:+.1f}" for axis, part in zip("XYZ", self.off, strict=True))
        back = " ".join(f"{axis} {-1e3 * part:+.1f}" for axis, part in zip("XYZ", self.off, strict=True))
        if self.touched_off:
            return (
                f"{system} was touched off without compensation, and its true zero lies {named} um off: the "
                "corrections count from there, so that the part is right against its datum"
            )
        if max(map(abs, self.off)) < _SEEN:
            return f"at the zero of {system} the error values displace the tool point by less than {_SEEN * 1e3:g} um"
        at = " ".join(f"{axis}{value:.9g}" for axis, value in self.at.items())
        values = [f"{axis}{value:.9g}" for axis, value in self.turned.items()]
        values += [f"L{self.length:g}"] if self.length else []
        given = f"{OPTION} {system.replace(' ', '')}{'=' * bool(values)}{','.join(values)}"
        if self.turned:
            given += f", {' '.join(self.turned)} being where the program first cuts with it: give where it was touched"
        given += (
            ", the length being that of the tool which the program uses first: give that of the probe or tool that "
            "touched it off"
            if self.length
            else ", with L120 where it was a probe or tool of 120 mm from the point of --tool-point on"
        )
        return (
            f"at the zero of {system} ({at}) the error values displace the tool point by {named} um. If {system} was "
            f"touched off there without compensation, the whole part comes to lie {back} um off its datum: say "
            f"{given}. If it was set with compensated positions, it is right as it is"
        )


@dataclass(frozen=True, slots=True)
class Datum:
    """The datum of a work offset. touched: where it was touched off, nothing where it was not; tool_point: (3, 1), that
    lengths are measured from; length: of the tool that the program uses with it first, mm; turned: rotary positions at
    which it first cuts with it, deg.
    """

    touched: Sequence[TouchedOff]
    tool_point: FloatArray
    length: float
    turned: Mapping[str, float] = field(default_factory=dict)

    def moved(self, model: ErrorModel, value: Mapping[str, float], by: FloatArray) -> FloatArray:
        """By how much further off the true zero lies where the zero is moved by (n_axes,), mm and deg; (3, 1), mm."""
        if not self.touched:
            return np.zeros((3, 1))
        there = {axis: value.get(axis, 0.0) + move for axis, move in zip(model.axes, by.tolist(), strict=True)}
        return self._shift(model, there) - self._shift(model, value)

    def slopes(self, model: ErrorModel, value: Mapping[str, float]) -> list[FloatArray]:
        """The same per mm (deg) of each axis."""
        steps = _STEP * np.eye(len(model.axes))
        return [(self.moved(model, value, s) - self.moved(model, value, -s)) / (2.0 * _STEP) for s in steps]

    def zero(self, model: ErrorModel, value: Mapping[str, float]) -> Zero:
        """Where it truly is."""
        turned = {axis: at for axis, at in self.turned.items() if at != value.get(axis, 0.0)}
        one = TouchedOff(system="", length=self.length, place=turned)
        at = np.array(one.position(model.axes, value))
        low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T
        at = np.clip(at, low, high)
        place = dict(zip(model.axes, at.tolist(), strict=True))
        touched = self.touched or [TouchedOff(system="", length=self.length, place=place)]
        x, y, z = datum_shift(model, touched, value, self.tool_point)[:, 0].tolist()
        return Zero(touched_off=bool(self.touched), at=place, off=(x, y, z), length=self.length, turned=turned)

    def _shift(self, model: ErrorModel, zero: Mapping[str, float]) -> FloatArray:
        return datum_shift(model, self.touched, zero, self.tool_point)
