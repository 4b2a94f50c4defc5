"""Every routine of a machine: what its kernels compute, from its spec alone."""

from collections.abc import Iterator

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.chain import Vector
from trueaxis.derivation.first_order import first_order
from trueaxis.derivation.folded import coefficient, curve, folded_deviation
from trueaxis.derivation.propagate import walk
from trueaxis.derivation.routine import Argument, Assignment, Binder, Routine, build
from trueaxis.derivation.views import ViewWalk, view, views
from trueaxis.machine.machine import LINEAR, ROTARY, Machine

_XYZ = ("x", "y", "z")


def derive_routines(machine: Machine) -> tuple[Routine, ...]:
    """All routines that depend on the machine alone, in the order in which they are emitted."""
    routines: list[Routine] = []
    for each in views(machine):
        routines += _view_routines(machine, each)
    main = view(machine, "tool_in_workpiece")
    routines += _position_routines(machine, main)
    if any(axis in ROTARY for axis in machine.axes):
        routines += _orientation_routines(machine, main)
    routines += _curve_routines(machine, main)
    routines.append(_ballbar(machine, main))
    routines += _correction(machine, main)
    return tuple(routines)


def positions_argument(machine: Machine) -> Argument:
    """`positions` (n_axes, n): commanded axis positions."""
    unit = "mm, rotary axes deg" if any(axis in ROTARY for axis in machine.axes) else "mm"
    rows = tuple(axis.lower() for axis in machine.axes)
    return Argument("positions", rows, (len(rows),), True, unit, f"commanded positions of {' '.join(machine.axes)}")


def errors_argument(machine: Machine) -> Argument:
    """`errors` (n_components, n): component errors at the points."""
    return Argument(
        "errors", machine.components, (len(machine.components),), True, "mm, rad", "component errors at the point"
    )


def parameters_argument(machine: Machine) -> Argument:
    """`parameters` (n_parameters,): dimensions and location errors."""
    count = (len(machine.parameters),)
    return Argument("parameters", machine.parameters, count, False, "mm, rad", "home positions and location errors")


def point_argument(seen: str, *, per_point: bool = True, name: str = "point", prefix: str = "r") -> Argument:
    """`point` (3, n) or (3,): a point in the frame of its body."""
    return vector_argument(
        name, tuple(prefix + axis for axis in _XYZ), f"point in the {seen} frame", per_point=per_point
    )


def vector_argument(name: str, rows: tuple[str, ...], description: str, *, per_point: bool = True) -> Argument:
    """A vector of three lengths, mm."""
    return Argument(name, rows, (len(rows),), per_point, "mm", description)


def _rows(rows: tuple[str, ...], values: Vector) -> dict[str, sp.Expr]:
    return dict(zip(rows, values, strict=True))


def _view_routines(machine: Machine, seen: ViewWalk) -> Iterator[Routine]:
    text = f"{seen.seen} point in the {seen.frame} frame"
    positions, errors, parameters = positions_argument(machine), errors_argument(machine), parameters_argument(machine)
    point = point_argument(seen.seen)
    deviation = vector_argument("deviation", ("dx", "dy", "dz"), f"{text}, actual minus ideal")
    linear = first_order(seen, symbols.point())
    ideal = vector_argument("ideal", ("px", "py", "pz"), f"{text}, without errors")
    yield build(
        f"{seen.name}_ideal",
        f"Ideal position of a {text}.",
        "Eqs. (1)-(4) without errors",
        (positions, parameters, point),
        (ideal,),
        _rows(ideal.rows, linear.ideal),
    )
    for exact in (True, False):
        binder = Binder()
        walked = walk(seen, symbols.point(), binder, exact=exact, true_rotation=machine.true_rotation)
        yield build(
            f"{seen.name}_deviation" + ("" if exact else "_first_order"),
            f"Deviation of a {text}, " + ("exact." if exact else "to first order in the errors."),
            "Eqs. (1)-(4)",
            (positions, errors, parameters, point),
            (deviation,),
            _rows(deviation.rows, walked.deviation),
            binder.assignments,
        )
    names = machine.components + machine.location_errors
    sensitivity = Argument(
        "sensitivity",
        tuple(f"d{axis}_{name}" for axis in _XYZ for name in names),
        (3, len(names)),
        True,
        "mm/mm, mm/rad",
        "derivative of the deviation by each component error, then by each location error",
    )
    zero = (sp.S.Zero,) * 3
    values = {f"d{axis}_{name}": linear.columns.get(name, zero)[row] for row, axis in enumerate(_XYZ) for name in names}
    yield build(
        f"{seen.name}_sensitivity",
        f"Sensitivity of a {text} to every error, at the error-free machine.",
        "Eqs. (1)-(4), first order",
        (positions, parameters, point),
        (sensitivity,),
        values,
    )


def _position_routines(machine: Machine, main: ViewWalk) -> Iterator[Routine]:
    actual = vector_argument(
        "position", ("px", "py", "pz"), "actual position P_T^W of the tool point in the workpiece frame"
    )
    inputs = (
        positions_argument(machine),
        errors_argument(machine),
        parameters_argument(machine),
        point_argument("tool"),
    )
    for exact in (True, False):
        binder = Binder()
        walked = walk(main, symbols.point(), binder, exact=exact, true_rotation=machine.true_rotation)
        value = tuple(p + d for p, d in zip(walked.ideal, walked.deviation, strict=True))
        yield build(
            f"{main.name}_position" + ("" if exact else "_first_order"),
            "Actual position of the tool point in the workpiece frame, " + ("exact." if exact else "to first order."),
            "Eq. (4)",
            inputs,
            (actual,),
            dict(zip(actual.rows, value, strict=True)),
            binder.assignments,
        )


def _orientation_routines(machine: Machine, main: ViewWalk) -> Iterator[Routine]:
    """Ideal direction of a vector of the tool frame, such as the tool axis, and its deviation (five-axis machines)."""
    axis = Argument(
        "direction", ("tx", "ty", "tz"), (3,), True, "1", "unit vector in the tool frame, (0, 0, 1) for the tool axis"
    )
    start = tuple(symbols.named(row) for row in axis.rows)
    ideal = Argument("ideal", ("ix", "iy", "iz"), (3,), True, "1", "the vector in the workpiece frame, without errors")
    deviation = Argument(
        "deviation", ("dx", "dy", "dz"), (3,), True, "1", "the vector in the workpiece frame, actual minus ideal"
    )
    positions, errors, parameters = positions_argument(machine), errors_argument(machine), parameters_argument(machine)
    for exact in (True, False):
        binder = Binder()
        walked = walk(main, start, binder, exact=exact, true_rotation=machine.true_rotation, direction=True)
        if exact:
            yield build(
                "tool_orientation_ideal",
                "Ideal direction of a vector of the tool frame in the workpiece frame.",
                "Eqs. (1)-(4) without errors, rotations alone",
                (positions, axis),
                (ideal,),
                _rows(ideal.rows, walked.ideal),
                binder.assignments,
            )
        yield build(
            "tool_orientation_deviation" + ("" if exact else "_first_order"),
            "Deviation of a direction of the tool frame in the workpiece frame, "
            + ("exact." if exact else "to first order."),
            "Eqs. (1)-(4), rotations alone",
            (positions, errors, parameters, axis),
            (deviation,),
            _rows(deviation.rows, walked.deviation),
            binder.assignments,
        )


def _curve_routines(machine: Machine, main: ViewWalk) -> Iterator[Routine]:
    powers = range(1, machine.curve_degree + 1)
    rows = tuple(coefficient(name, power).name for name in machine.components for power in powers)
    curves = Argument(
        "curves",
        rows,
        (len(machine.components), machine.curve_degree),
        False,
        "mm/mm^k, rad/mm^k" + (" (deg^k for rotary axes)" if any(axis in ROTARY for axis in machine.axes) else ""),
        f"coefficients of the powers 1 to {machine.curve_degree} of the axis position, per component error",
    )
    inputs = (
        positions_argument(machine),
        curves,
        parameters_argument(machine),
        point_argument("tool", per_point=False),
    )
    deviation = vector_argument(
        "deviation", ("dx", "dy", "dz"), "tool point in the workpiece frame, actual minus ideal"
    )
    yield build(
        f"{main.name}_deviation_curves",
        "Deviation of the tool point under polynomial error curves, exact.",
        "Eqs. (1)-(4), (44)",
        inputs,
        (deviation,),
        *_walk_with_curves(machine, main, deviation.rows, exact=True),
    )
    binder = Binder()
    folded = folded_deviation(machine, main, symbols.point(), binder)
    candidates = [
        build(
            f"{main.name}_deviation_first_order_curves",
            f"Deviation of the tool point under polynomial error curves, to first order{remark}.",
            "Eqs. (1)-(4), (44)",
            inputs,
            (deviation,),
            results,
            bound,
        )
        for remark, (results, bound) in (
            (", constants folded once per call", (_rows(deviation.rows, folded), binder.assignments)),
            ("", _walk_with_curves(machine, main, deviation.rows, exact=False)),
        )
    ]
    # With two rotary axes there are more monomials to fold by than component errors.
    yield min(candidates, key=lambda routine: routine.operations)


def _walk_with_curves(
    machine: Machine, main: ViewWalk, rows: tuple[str, ...], *, exact: bool
) -> tuple[dict[str, sp.Expr], list[Assignment]]:
    """The walk with each component error replaced by its polynomial: results and what they refer to."""
    curves, steps = Binder("_curve"), Binder("_walk")
    values = {symbols.named(name): curves.bind(curve(name, machine.curve_degree)) for name in machine.components}
    walked = walk(main, symbols.point(), steps, exact=exact, true_rotation=machine.true_rotation)
    bound = [(target, value.xreplace(values)) for target, value in steps.assignments]
    results = dict(zip(rows, (d.xreplace(values) for d in walked.deviation), strict=True))
    return results, curves.assignments + bound


def _ballbar(machine: Machine, main: ViewWalk) -> Routine:
    binder = Binder()
    walked = walk(main, symbols.point(), binder, true_rotation=machine.true_rotation)
    ball = symbols.point("b")
    length = sp.Symbol("length", real=True)
    ideal = binder.bind_all(p - b for p, b in zip(walked.ideal, ball, strict=True))
    actual = binder.bind_all(v + d for v, d in zip(ideal, walked.deviation, strict=True))
    before = binder.bind(sp.sqrt(sum(v * v for v in ideal)))
    after = binder.bind(sp.sqrt(sum(v * v for v in actual)))
    # |v + d| - |v| without cancellation: (2 v + d) . d / (|v + d| + |v|)
    growth = sum((v + a) * d for v, a, d in zip(ideal, actual, walked.deviation, strict=True)) / (after + before)
    error = binder.bind((before - length) + growth)
    over = binder.bind(error / after)
    results = {"e": error} | {f"e{axis}": over * a for axis, a in zip(_XYZ, actual, strict=True)}
    inputs = (
        positions_argument(machine),
        errors_argument(machine),
        parameters_argument(machine),
        point_argument("tool"),
        point_argument("workpiece", name="ball", prefix="b"),
        Argument("length", ("length",), (1,), True, "mm", "ideal length of the ball bar"),
    )
    output = Argument(
        "error", tuple(results), (4,), True, "mm", "positioning error E, then its components E_x, E_y, E_z"
    )
    return build(
        "ballbar_error",
        "Positioning error of a ball bar between a tool ball and a workpiece ball, exact.",
        "Eqs. (5), (6)",
        inputs,
        (output,),
        results,
        binder.assignments,
    )


def _correction(machine: Machine, main: ViewWalk) -> Iterator[Routine]:
    """The inverse: moves of the linear axes that displace the ideal tool point by a given vector (Eqs. 53-55).

    A machine whose linear axes do not span space at any pose has none.
    """
    linear = [axis for axis in machine.axes if axis in LINEAR]
    if len(linear) != 3:
        return
    ideal = sp.Matrix(first_order(main, symbols.point()).ideal)
    jacobian = ideal.jacobian([symbols.position(axis) for axis in linear])
    inverse = _inverse(machine, jacobian)
    deviation = vector_argument(
        "deviation", ("dx", "dy", "dz"), "displacement of the tool point in the workpiece frame"
    )
    moves = inverse * sp.Matrix([symbols.named(row) for row in deviation.rows])
    rows = tuple(f"move_{axis.lower()}" for axis in linear)
    output = vector_argument("moves", rows, f"moves of {' '.join(linear)}")
    yield build(
        "correction",
        "Moves of the linear axes that displace the ideal tool point by the given vector.",
        "Eqs. (53)-(55), inverse",
        (positions_argument(machine), deviation),
        (output,),
        dict(zip(rows, moves, strict=True)),
    )


def _inverse(machine: Machine, jacobian: sp.Matrix) -> sp.Matrix:
    pythagoras = {symbols.sine(axis) ** 2: 1 - symbols.cosine(axis) ** 2 for axis in machine.axes if axis in ROTARY}
    gram = (jacobian * jacobian.T).applyfunc(lambda entry: sp.expand(sp.expand(entry).subs(pythagoras)))
    if gram == sp.eye(3):
        return jacobian.T
    return jacobian.adjugate() / jacobian.det()
