"""Every routine of a machine: what its kernels compute, from its spec alone."""

from collections.abc import Iterator

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.curve_routines import curve_routines
from trueaxis.derivation.first_order import first_order
from trueaxis.derivation.products import multiplied_out
from trueaxis.derivation.routine import (
    Argument,
    Binder,
    Routine,
    build,
    by_row,
    errors_argument,
    parameters_argument,
    point_argument,
    positions_argument,
    vector_argument,
)
from trueaxis.derivation.views import ViewWalk, view, views, walk
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
    routines += curve_routines(machine, main)
    routines.append(_ballbar(machine, main))
    routines += _correction(machine, main)
    return tuple(routines)


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
        by_row(ideal.rows, linear.ideal),
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
            by_row(deviation.rows, walked.deviation),
            binder.assignments,
        )
    names = machine.components + machine.location_errors
    sensitivity = Argument(
        name="sensitivity",
        rows=tuple(f"d{axis}_{name}" for axis in _XYZ for name in names),
        shape=(3, len(names)),
        per_point=True,
        unit="mm/mm, mm/rad",
        description="derivative of the deviation by each component error, then by each location error",
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
        name="direction",
        rows=("tx", "ty", "tz"),
        shape=(3,),
        per_point=True,
        unit="1",
        description="unit vector in the tool frame, (0, 0, 1) for the tool axis",
    )
    start = tuple(symbols.named(row) for row in axis.rows)
    ideal = Argument(
        name="ideal",
        rows=("ix", "iy", "iz"),
        shape=(3,),
        per_point=True,
        unit="1",
        description="the vector in the workpiece frame, without errors",
    )
    deviation = Argument(
        name="deviation",
        rows=("dx", "dy", "dz"),
        shape=(3,),
        per_point=True,
        unit="1",
        description="the vector in the workpiece frame, actual minus ideal",
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
                by_row(ideal.rows, walked.ideal),
                binder.assignments,
            )
        yield build(
            "tool_orientation_deviation" + ("" if exact else "_first_order"),
            "Deviation of a direction of the tool frame in the workpiece frame, "
            + ("exact." if exact else "to first order."),
            "Eqs. (1)-(4), rotations alone",
            (positions, errors, parameters, axis),
            (deviation,),
            by_row(deviation.rows, walked.deviation),
            binder.assignments,
        )


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
        Argument(
            name="length",
            rows=("length",),
            shape=(1,),
            per_point=True,
            unit="mm",
            description="ideal length of the ball bar",
        ),
    )
    output = Argument(
        name="error",
        rows=tuple(results),
        shape=(4,),
        per_point=True,
        unit="mm",
        description="positioning error E, then its components E_x, E_y, E_z",
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
    if inverse is None:
        return
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


def _inverse(machine: Machine, jacobian: sp.Matrix) -> sp.Matrix | None:
    """None where there is none: of an axis that carries workpiece and tool both."""
    pythagoras = {symbols.sine(axis) ** 2: 1 - symbols.cosine(axis) ** 2 for axis in machine.axes if axis in ROTARY}
    gram = (jacobian * jacobian.T).applyfunc(lambda entry: multiplied_out(multiplied_out(entry).subs(pythagoras)))
    if gram == sp.eye(3):
        return jacobian.T
    volume = jacobian.det()
    return None if multiplied_out(volume) == 0 else jacobian.adjugate() / volume
