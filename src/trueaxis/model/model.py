"""A machine with its error values: the numeric model that everything right of the kernels runs on."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from trueaxis.effects.kind import Effect, Kind, Place
from trueaxis.error_name import ErrorName
from trueaxis.io.faults import Faults
from trueaxis.machine import Machine, read_machine
from trueaxis.machine.machine import LINEAR
from trueaxis.machine.prior import Prior
from trueaxis.model.believable import check_believable
from trueaxis.model.context import Context, ReadingContext
from trueaxis.model.curves import FloatArray, TableCurve, evaluate_components, pack_polynomials
from trueaxis.model.effect_terms import component_term, reading_term
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues, read_errors
from trueaxis.model.kernels import Kernels, load_kernels
from trueaxis.view import View


@dataclass(frozen=True)
class MachineModel:
    """Kernels and error values of a machine.

    Arrays: positions (n_axes, n) commanded, mm or deg; point (3, 1) or (3, n) in the frame of its body, mm; results
    (3, n), mm. A view is of a point of one body, seen from another.

    context: of the positions that the model will be asked for, where effects depend on more than positions (see
    `in_context`). Without one all axes stand and have not moved yet (direction 0, velocity 0, no reversal), at time 0
    and 20 degC.
    """

    machine: Machine
    kernels: Kernels
    errors: ErrorValues
    context: Context | None = None

    @property
    def name(self) -> str:
        """The machine's name."""
        return self.machine.name

    @property
    def axes(self) -> tuple[str, ...]:
        """Axis letters in the order X Y Z A B C."""
        return self.machine.axes

    @property
    def components(self) -> tuple[ErrorName, ...]:
        """Motion-error components in the order of the kernels."""
        return self.machine.components

    @property
    def dimensions(self) -> tuple[str, ...]:
        """Named home positions."""
        return self.machine.dimensions

    @property
    def location_errors(self) -> tuple[str, ...]:
        """Named position errors."""
        return self.machine.location_errors

    @property
    def parameters(self) -> tuple[str, ...]:
        """Dimensions, then location errors."""
        return self.machine.parameters

    @property
    def travel(self) -> Mapping[str, tuple[float, float]]:
        """Axis -> lowest and highest commanded position, mm or deg."""
        return self.machine.travel

    @property
    def prior(self) -> Prior:
        """Sizes of errors to expect before measuring."""
        return self.machine.prior

    @property
    def effects(self) -> tuple[Effect, ...]:
        """The machine's effects, whether the error values name them or not."""
        return self.machine.effects

    @property
    def kinds(self) -> Mapping[str, Kind]:
        """Every kind of effect by its name."""
        return self.machine.kinds

    @property
    def effect_values(self) -> tuple[EffectValues, ...]:
        """The effects that the error values name; the others are zero."""
        return self.errors.effects

    def with_values(self, errors: ErrorValues) -> "MachineModel":
        """The same kernels with other error values."""
        return replace(self, errors=errors)

    def in_context(self, context: Context) -> "MachineModel":
        """The same model at positions of that context: it is to be called with as many, in that order."""
        return replace(self, context=context)

    @cached_property
    def parameter_values(self) -> FloatArray:
        """(n_parameters,): what the error values say, zero where they are silent; a squareness is told as an effect."""
        found = np.array([self.errors.parameters.get(name, 0.0) for name in self.parameters])
        for values in self._effects_on("location"):
            angle = float(values.vector(self.kinds[values.effect.kind])[0])
            found[self.parameters.index(values.effect.component or "")] += angle
        return found

    @property
    def error_free(self) -> bool:
        """Whether every error value is zero, or none is there."""
        values = self.errors
        numbers = [one for name in self.location_errors if (one := values.parameters.get(name, 0.0))]
        for curve in values.motion_errors.values():
            numbers += curve.values if isinstance(curve, TableCurve) else curve.coefficients
        for effect in values.effects:
            numbers += effect.parameters.values()
        return not any(numbers)

    @cached_property
    def _curves(self) -> FloatArray | None:
        if self._effects_on("component"):
            return None
        return pack_polynomials(self.errors.motion_errors, self.components, self.machine.curve_degree)

    def component_errors(self, positions: FloatArray) -> FloatArray:
        """(n_components, n): every motion error at the commanded positions, mm or rad: its curve and its effects.

        NaN where the context lacks what an effect depends on. Raises ValueError for a context of another number of
        positions.
        """
        axes = [self.axes.index(name.axis) for name in self.components]
        found = evaluate_components(self.errors.motion_errors, self.components, axes, positions)
        terms = self._effects_on("component")
        if not terms:
            return found
        context = self.context or Context.at_rest(len(self.axes), positions.shape[1])
        if context.count != positions.shape[1]:
            raise ValueError(f"the context is of {context.count} positions, not {positions.shape[1]}")
        for values in terms:
            effect = values.effect
            vector = values.vector(self.kinds[effect.kind])
            term = component_term(self.kernels, self.machine, effect, vector, positions, context)
            found[self.components.index(effect.component or "")] += term[0]
        return found

    def reading_effect(self, values: EffectValues, context: ReadingContext) -> FloatArray:
        """(n,): what an effect adds to readings of its instrument, mm; NaN where the context lacks what it needs."""
        vector = values.vector(self.kinds[values.effect.kind])
        term = reading_term(self.kernels, self.machine, values.effect, vector, context)
        return np.ascontiguousarray(term[0])

    def _effects_on(self, place: Place) -> tuple[EffectValues, ...]:
        return tuple(one for one in self.errors.effects if self.kinds[one.effect.kind].place == place)

    def _call(self, name: str, *arrays: FloatArray) -> FloatArray:
        result: FloatArray = self.kernels[name](*arrays)
        return result

    def view_ideal(self, view: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Coordinates of the point on the error-free machine."""
        return self._call(f"{view}_ideal", positions, self.parameter_values, point)

    def view_deviation(self, view: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Actual minus ideal coordinates, on the exact model."""
        (found,) = self.view_deviations([(view, point)], positions)
        return found

    def view_deviations(self, points: Sequence[tuple[View, FloatArray]], positions: FloatArray) -> list[FloatArray]:
        """Actual minus ideal coordinates of points, each in its view, on the exact model; errors are found but once."""
        found, errors = [], None
        for view, point in points:
            if view == "tool_in_workpiece" and self._curves is not None and point.shape[1] == 1:
                name = "tool_in_workpiece_deviation_curves"
                found.append(self._call(name, positions, self._curves, self.parameter_values, point[:, 0]))
                continue
            errors = self.component_errors(positions) if errors is None else errors
            found.append(self.view_deviation_of(view, positions, errors, self.parameter_values, point))
        return found

    def view_deviation_of(
        self, view: View, positions: FloatArray, errors: FloatArray, parameters: FloatArray, point: FloatArray
    ) -> FloatArray:
        """Actual minus ideal coordinates with component errors (n_components, n) and parameters given."""
        return self._call(f"{view}_deviation", positions, errors, parameters, point)

    def view_sensitivity(self, view: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        """(3, n_components + n_location_errors, n): derivative of the deviation by each error, error-free."""
        return self._call(f"{view}_sensitivity", positions, self.parameter_values, point)

    def ideal(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Tool point in the workpiece frame without errors."""
        return self.view_ideal("tool_in_workpiece", positions, point)

    def deviation(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Deviation of the tool point in the workpiece frame, exact."""
        return self.view_deviation("tool_in_workpiece", positions, point)

    def orientation_ideal(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        """(3, n): a unit vector of the tool frame, (3, 1) or (3, n), in the workpiece frame, without errors."""
        return self._call("tool_orientation_ideal", positions, direction)

    def orientation_deviation(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        """(3, n): the same, actual minus ideal, on the exact model; a small rotation changes the length a little."""
        errors = self.component_errors(positions)
        return self._call("tool_orientation_deviation", positions, errors, self.parameter_values, direction)

    def correction(self, positions: FloatArray, deviation: FloatArray) -> FloatArray:
        """(n_axes, n): moves of the linear axes that displace the ideal tool point by `deviation`; rotary rows 0."""
        moves = self._call("correction", positions, deviation)
        rows = [index for index, axis in enumerate(self.axes) if axis in LINEAR]
        result = np.zeros((len(self.axes), moves.shape[1]))
        result[rows] = moves
        return result

    def __str__(self) -> str:
        return str(self.machine)

    def _repr_html_(self) -> str:
        return self.machine._repr_html_()


def load_model(
    machine_path: Path, errors_path: Path | None, kernels_dir: Path, *, backend: str | None = None
) -> MachineModel:
    """Read a machine, its kernels and (if given) its error values.

    Raises InputError for whatever is wrong with them: the spec's and the errors' faults are told together.
    """
    machine = read_machine(machine_path)
    errors = ErrorValues(machine=machine.name) if errors_path is None else load_errors(errors_path, machine)
    return MachineModel(machine, load_kernels(machine, machine_path, kernels_dir, backend=backend), errors)


def load_errors(path: Path, machine: Machine) -> ErrorValues:
    """Read the error values of a machine. Raises InputError with every fault, values that no machine has included."""
    errors = read_errors(
        path,
        machine=machine.name,
        components=machine.components,
        parameters=machine.parameters,
        effects=machine.effects,
        kinds=machine.kinds,
    )
    faults = Faults(str(path))
    if errors.chain and errors.chain != machine.chain:
        problem = f'the values were identified with the axes "{errors.chain}", and the spec now has "{machine.chain}"'
        faults.add(
            "chain", problem, "identify again, with this spec: values of other senses or another order are wrong"
        )
    check_believable(machine, errors, faults)
    faults.raise_if_any()
    return errors


def home_of(model: MachineModel | Machine) -> FloatArray:
    """(n_axes, 1): every axis at 0, or at the end of its travel next to it, mm or deg."""
    return np.array([[min(max(0.0, low), high)] for low, high in (model.travel[axis] for axis in model.axes)])
