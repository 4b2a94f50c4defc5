"""machine.h of the kinematics module: the axes of a machine, its error values and its tool, as data of C."""

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from trueaxis.c_prefix import c_prefix
from trueaxis.controllers.linuxcnc_kins.as_loaded import BEYOND
from trueaxis.controllers.remaining import held_effects
from trueaxis.machine.machine import AXES, LINEAR
from trueaxis.model.curves import Curve, FloatArray, LegendreCurve, PolynomialCurve, TableCurve
from trueaxis.model.effect_terms import context_variables
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.model import MachineModel

_A_LINE = 4  # numbers


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
            rows.append(f"    {{ NO_CURVE, {axis}, 0, 0, 0.0, 0.0, 0.0 }}, /* {component} */")
            continue
        form, count, numbers, ends = _numbers(curve)
        yield from _array(f"{component}_NUMBERS", numbers)
        listed = ", ".join(map(repr, ends))
        rows.append(f"    {{ {form}, {axis}, {count}, {component}_NUMBERS, {listed} }}, /* {component} */")
    yield "static const curve CURVES[COMPONENTS + 1] = {"  # of a machine without components, too
    yield from rows
    yield "    { NO_CURVE, 0, 0, 0, 0.0, 0.0, 0.0 }"
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
            # the sum of P1 .. Pn themselves, of which the basis has taken the values at home
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
