"""The C kernels for the cycle of a control: one point a call, and from them the kinematics of the machine as it is."""

from typing import Any

from trueaxis.c_prefix import c_prefix
from trueaxis.codegen.c_source import OF_ONE_POINT, declaration, function_text, helpers, legend, shared_context
from trueaxis.codegen.templates import environment
from trueaxis.derivation.routine import Routine
from trueaxis.machine.machine import LINEAR, Machine

_DEVIATION, _CORRECTION = "tool_in_workpiece_deviation", "correction"


def control_sources(machine: Machine, routines: tuple[Routine, ...], spec: str = "") -> dict[str, str]:
    """control.c and control.h by name; none of a machine without three linear axes, whose tool cannot be moved freely.

    spec: how it is named there. Same input, same bytes.
    """
    if _CORRECTION not in {routine.name for routine in routines}:
        return {}
    contexts = {
        "control.c": control_context(machine, routines, spec),
        "control.h": control_header_context(machine, routines, spec),
    }
    return {name: environment().get_template(f"{name}.j2").render(context) for name, context in contexts.items()}


def control_context(machine: Machine, routines: tuple[Routine, ...], spec: str = "") -> dict[str, Any]:
    """The variables of control.c.j2."""
    chosen = _of_one_point(machine, routines)
    return _shared(machine, spec) | {
        "functions": [function_text(_prefix(machine), routine, OF_ONE_POINT) for routine in chosen],
        "helpers": helpers(chosen),
        "linear": [machine.axes.index(axis) for axis in machine.axes if axis in LINEAR],
    }


def control_header_context(machine: Machine, routines: tuple[Routine, ...], spec: str = "") -> dict[str, Any]:
    """The variables of control.h.j2."""
    chosen = _of_one_point(machine, routines)
    return _shared(machine, spec) | {
        "functions": [declaration(_prefix(machine), routine, OF_ONE_POINT) for routine in chosen],
        "legend": legend(machine),
    }


def _shared(machine: Machine, spec: str) -> dict[str, Any]:
    return shared_context(machine, spec) | {"axes": len(machine.axes), "components": len(machine.components)}


def _prefix(machine: Machine) -> str:
    return f"{c_prefix(machine.name)}_point"


def _of_one_point(machine: Machine, routines: tuple[Routine, ...]) -> list[Routine]:
    """The exact deviation, the moves that take it back, and the terms of effects on component errors."""
    effects = {f"effect_{name}" for name, kind in machine.kinds.items() if kind.place == "component"}
    return [routine for routine in routines if routine.name in {_DEVIATION, _CORRECTION} | effects]
