"""The META record: what a program must know to call the kernels, and what a reader must know of their symbols."""

from collections.abc import Mapping
from typing import Any

from trueaxis.derivation import symbols
from trueaxis.derivation.effect_terms import emitted_kinds
from trueaxis.derivation.first_order import squarenesses
from trueaxis.derivation.routine import Argument, Routine
from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.placement import context_of
from trueaxis.machine.machine import ROTARY, Machine

ABI = 3  # raised whenever the signature, layout or meaning of a kernel changes


def spec_name(machine: Machine) -> str:
    """How generated files name a spec of which no file is known."""
    return f"machines/{machine.name}.toml"


def meta(machine: Machine, routines: tuple[Routine, ...]) -> dict[str, Any]:
    """Axes, components and parameters in order with units, squareness relations, effects, every routine's arguments."""
    texts = symbols.describe(machine)
    return {
        "machine": machine.name,
        "title": machine.title,
        "axes": list(machine.axes),
        "position_units": ["deg" if axis in ROTARY else "mm" for axis in machine.axes],
        "travel": {axis: list(machine.travel[axis]) for axis in machine.axes},
        "components": list(machine.components),
        "component_units": [texts[name].unit for name in machine.components],
        "component_descriptions": [texts[name].description for name in machine.components],
        "parameters": list(machine.parameters),
        "parameter_units": [texts[name].unit for name in machine.parameters],
        "parameter_descriptions": [texts[name].description for name in machine.parameters],
        "dimensions": list(machine.dimensions),
        "location_errors": list(machine.location_errors),
        "curve_degree": machine.curve_degree,
        "squareness": [_squareness(pair.axes, pair.product) for pair in squarenesses(machine)],
        "effects": {
            "kinds": kinds_record(emitted_kinds(machine)),
            "terms": [_term(effect) for effect in machine.effects],
        },
        "routines": {routine.name: routine_record(routine) for routine in routines},
    }


def kinds_record(kinds: Mapping[str, Kind]) -> dict[str, Any]:
    """Place, context and parameters of kinds of effects, in the order of the arguments of their kernels."""
    return {
        name: {
            "place": kind.place,
            "context": list(context_of(kind)),
            "parameters": [parameter.name for parameter in kind.parameters],
        }
        for name, kind in kinds.items()
    }


def _squareness(axes: tuple[str, str], product: Any) -> dict[str, Any]:
    terms = {symbol.name: float(product.coeff(symbol)) for symbol in sorted(product.free_symbols, key=str)}
    return {"axes": list(axes), "location_errors": terms}


def _term(effect: Effect) -> dict[str, Any]:
    told: dict[str, Any] = {"kind": effect.kind, "component": effect.component, "axis": effect.axis}
    told |= {"runs": list(effect.runs) or None, "end": effect.end}
    return {key: value for key, value in told.items() if value is not None}


def routine_record(routine: Routine) -> dict[str, Any]:
    """Arguments and operations of a routine."""
    return {
        "inputs": [_argument(argument) for argument in routine.inputs],
        "outputs": [_argument(argument) for argument in routine.outputs],
        "operations": routine.operations,
        "operations_per_call": routine.batch_operations,
    }


def _argument(argument: Argument) -> dict[str, Any]:
    return {
        "name": argument.name,
        "shape": list(argument.shape),
        "per_point": argument.per_point,
        "unit": argument.unit,
    }
