"""A LinuxCNC kinematics module made of the emitted kernels of a machine and its error values.

trueaxiskins.c, joints.h and curves.h are the same for every machine; control.c and control.h are the kernels that were
derived of it; machine.h holds its axes, error values and tool, as data of C. `taken_by_module` is the module as a
model: what it takes off, to be judged by the model of the machine.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from trueaxis.c_prefix import c_prefix
from trueaxis.controllers.axis_tables import approached
from trueaxis.controllers.remaining import TakenOff, held_effects
from trueaxis.machine.machine import AXES, LINEAR
from trueaxis.model.curves import Curve, FloatArray, LegendreCurve, PolynomialCurve, TableCurve
from trueaxis.model.effect_terms import context_variables
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.manifest import CONTROL_FILES
from trueaxis.model.model import MachineModel

SOURCE = "trueaxiskins.c"  # what halcompile is given
_SAME_FOR_ALL = (SOURCE, "joints.h", "curves.h", "trueaxiskins.hal")
# mm or deg. The positions that a pose asks for lie beyond the travel by as much as the machine is off there: curves go
# on so far and hold their values beyond. A machine that is off by more is to be mended first.
BEYOND = 5.0
_STEPS = 20  # MOST_STEPS of trueaxiskins.c
_TOLERANCE = 1e-11  # mm: TOLERANCE there
_A_LINE = 4  # numbers


def module_files(model: MachineModel, tool: FloatArray, kernels: Mapping[str, bytes]) -> dict[str, str]:
    """Name -> text of the sources of the module.

    tool: (3, 1), the point in the tool frame from which tool lengths are measured, mm; kernels: the content of each of
    CONTROL_FILES.
    """
    folder = Path(__file__).parent
    files = {name: (folder / name).read_text(encoding="utf-8") for name in _SAME_FOR_ALL}
    files |= {name: kernels[name].decode() for name in CONTROL_FILES}
    return files | {"machine.h": machine_header(model, tool)}


def taken_by_module(model: MachineModel, tool: FloatArray) -> TakenOff:
    """By how much the module moves the axes; tool: (3, 1), mm. The direction of approach it cannot know."""

    def taken(positions: FloatArray, _: FloatArray) -> FloatArray:
        total = np.zeros_like(positions)
        for _step in range(_STEPS):
            moved = positions - total
            off = model.view_deviation_of(
                "tool_in_workpiece", moved, errors_known(model, moved), model.parameter_values, tool
            )
            before, total = total, model.correction(moved, off)
            if float(np.abs(total - before).max(initial=0.0)) <= _TOLERANCE:
                break
        return total

    return taken


def errors_known(model: MachineModel, positions: FloatArray) -> FloatArray:
    """(n_components, n): the error components that positions (n_axes, n) tell, mm and rad: curves, and effects of
    positions; those of the direction of approach as the mean of both.
    """
    low = np.array([model.travel[axis][0] - BEYOND for axis in model.axes])[:, np.newaxis]
    high = np.array([model.travel[axis][1] + BEYOND for axis in model.axes])[:, np.newaxis]
    at = np.clip(positions, low, high)
    model = model.with_values(replace(model.errors, effects=held_effects(model)))
    if not model.effect_values:
        return model.component_errors(at)
    found = np.zeros((len(model.components), at.shape[1]))
    for row, axis in enumerate(model.axes):
        own = [index for index, name in enumerate(model.components) if name.axis == axis]
        for sign in (1.0, -1.0):
            directions = np.zeros(len(model.axes))
            directions[row] = sign
            there = model.in_context(approached(model, at.shape[1], directions))
            found[own] += 0.5 * there.component_errors(at)[own]
    return found


def machine_header(model: MachineModel, tool: FloatArray) -> str:
    """The text of machine.h; tool: (3, 1), the point from which tool lengths are measured, tool frame, mm."""
    axes, travel = model.axes, model.travel
    lines = [
        f"/* Error values of {model.name}: written by trueaxis, see README.md beside it. mm, rad; rotary axes deg. */",
        "#ifndef TRUEAXIS_MACHINE_H",
        "#define TRUEAXIS_MACHINE_H",
        "",
        f'#define MACHINE_NAME "{model.name}"',
        f"#define MACHINE(name) {c_prefix(model.name)}_##name",
        f'#define AXIS_LETTERS "{"".join(axes)}"',
        f"#define AXES {len(axes)}",
        f"#define COMPONENTS {len(model.components)}",
        f"#define BEYOND {BEYOND!r} /* mm or deg: of travel, to which curves go on; no correction may be larger */",
        "",
        "/* rows of the axes in XYZABCUVW, of X Y Z among the axes */",
        f"static const int AXIS_ROWS[AXES] = {{ {_listed(AXES.index(axis) for axis in axes)} }};",
        f"static const int LINEAR_ROWS[3] = {{ {_listed(axes.index(axis) for axis in LINEAR)} }};",
        "",
        "/* positions beyond these count as these: mm, deg */",
        *_array("LOWEST", [travel[axis][0] - BEYOND for axis in axes]),
        *_array("HIGHEST", [travel[axis][1] + BEYOND for axis in axes]),
        "",
        f"/* {' '.join(model.parameters)} */",
        *_array("PARAMETERS", model.parameter_values.tolist()),
        "",
        "/* the point from which tool lengths are measured, tool frame; it lies back by TOOL_SHIFT times G43 */",
        *_array("TOOL_POINT", tool[:, 0].tolist()),
        *_matrix("TOOL_SHIFT", tool_shift(model)),
        "",
        *_curves(model),
        "",
        *_effects(model, held_effects(model)),
        "",
        "#endif",
    ]
    return "\n".join(lines) + "\n"


def tool_shift(model: MachineModel) -> FloatArray:
    """(3, 3): how the ideal tool point moves in the workpiece frame by one mm of X, of Y, of Z, from home."""
    home = np.zeros((len(model.axes), 4))
    for column, axis in enumerate(LINEAR):
        home[model.axes.index(axis), column] = 1.0
    at = model.ideal(home, np.zeros((3, 1)))
    return np.asarray(at[:, :3] - at[:, 3:])


def _curves(model: MachineModel) -> Iterator[str]:
    rows = []
    for component in model.components:
        axis = model.axes.index(component.axis)
        curve = model.errors.motion_errors.get(component)
        if curve is None:
            rows.append(f"    {{ NO_CURVE, {axis}, 0, 0, 0.0, 0.0, 0.0, 0 }}, /* {component} */")
            continue
        form, count, numbers, ends = _numbers(curve)
        yield from _array(f"{component}_NUMBERS", numbers)
        listed = ", ".join(map(repr, ends))
        harmonics = curve.basis.harmonics if isinstance(curve, LegendreCurve) else 0
        row = f"{form}, {axis}, {count}, {component}_NUMBERS, {listed}, {harmonics}"
        rows.append(f"    {{ {row} }}, /* {component} */")
    yield "static const curve CURVES[COMPONENTS + 1] = {"  # of a machine without components, too
    yield from rows
    yield "    { NO_CURVE, 0, 0, 0, 0.0, 0.0, 0.0, 0 }"
    yield "};"


def _numbers(curve: Curve) -> tuple[str, int, list[float], tuple[float, float, float]]:
    """Form, count, numbers, and low, high, at_home of curves.h."""
    match curve:
        case PolynomialCurve():
            falling = [0.0] * (max(curve.powers, default=0) + 1)
            for power, coefficient in zip(curve.powers, curve.coefficients, strict=True):
                falling[-1 - power] = coefficient
            return "POLYNOMIAL", len(falling), falling, (0.0, 0.0, 0.0)
        case TableCurve():
            return "TABLE", len(curve.positions), [*curve.positions, *curve.values], (0.0, 0.0, 0.0)
        case LegendreCurve(basis=basis):
            # the sum of the functions themselves, of which the basis has taken the values at home
            at_home = float(np.array(curve.coefficients) @ basis.at_home)
            return "LEGENDRE", basis.degree, list(curve.coefficients), (basis.low, basis.high, at_home)


def _effects(model: MachineModel, terms: Sequence[EffectValues]) -> Iterator[str]:
    """The function that adds the terms of effects, as they are on the mean of both directions of approach."""
    for number, values in enumerate(terms):
        vector = values.vector(model.kinds[values.effect.kind])
        yield from _array(f"EFFECT_{number}", [float(one) for one in vector])
    yield "static void add_effects(const double *at, double *errors)"
    yield "{"
    if not terms:
        yield "    (void)at;"
        yield "    (void)errors;"
    for number, values in enumerate(terms):
        yield from _effect(model, number, values)
    yield "}"


def _effect(model: MachineModel, number: int, values: EffectValues) -> Iterator[str]:
    effect = values.effect
    row = model.components.index(effect.error)
    names = context_variables(model.kernels, effect.kind)
    context = ", ".join(_variable(model, values, name) for name in names)
    rows = 1 + len(model.kinds[effect.kind].parameters)
    yield "    for (int side = -1; side <= 1; side += 2) {"
    yield f"        const double context[] = {{ {context} }}; /* {' '.join(names)}: {effect.label} */"
    yield f"        double term[{rows}];"
    yield f"        MACHINE(point_effect_{effect.kind})(context, EFFECT_{number}, term);"
    yield f"        errors[{row}] += 0.5 * term[0];"
    yield "    }"


def _variable(model: MachineModel, values: EffectValues, name: str) -> str:
    """A context variable of an effect in C; the other axis has not moved yet."""
    other = name.endswith("_b")
    axis = values.effect.axis if other else values.effect.own_axis
    bare = name.removesuffix("_b")
    if bare == "direction":
        return "0.0" if other else "(double)side"
    row = model.axes.index(axis or "")
    low, high = model.travel[axis or ""]
    return {"q": f"at[{row}]", "s": f"(at[{row}] - {low!r}) / ({high!r} - {low!r})"}[bare]


def _array(name: str, values: Sequence[float]) -> Iterator[str]:
    """A constant array; where there is nothing in it, of one zero, for C has none without elements."""
    numbers = [repr(float(value)) for value in values] or ["0.0"]
    if len(numbers) <= _A_LINE:
        yield f"static const double {name}[] = {{ {', '.join(numbers)} }};"
        return
    yield f"static const double {name}[] = {{"
    for start in range(0, len(numbers), _A_LINE):
        yield f"    {', '.join(numbers[start : start + _A_LINE])},"
    yield "};"


def _matrix(name: str, values: FloatArray) -> Iterator[str]:
    rows = ", ".join(f"{{ {', '.join(map(repr, row))} }}" for row in values.tolist())
    yield f"static const double {name}[3][3] = {{ {rows} }};"


def _listed(numbers: Iterable[int]) -> str:
    return ", ".join(map(str, numbers))
