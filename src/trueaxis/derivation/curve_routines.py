"""Routines for error curves that are polynomials: coefficients in, deviation of the tool point out."""

from collections.abc import Iterator

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.arguments import (
    by_row,
    parameters_argument,
    point_argument,
    positions_argument,
    vector_argument,
)
from trueaxis.derivation.folded import coefficient, curve, folded_deviation
from trueaxis.derivation.propagate import walk
from trueaxis.derivation.routine import Argument, Assignment, Binder, Routine, build
from trueaxis.derivation.views import ViewWalk
from trueaxis.machine.machine import ROTARY, Machine


def curve_routines(machine: Machine, main: ViewWalk) -> Iterator[Routine]:
    """The deviation of the tool point from coefficients of polynomial curves, exact and to first order."""
    powers = range(1, machine.curve_degree + 1)
    rows = tuple(coefficient(name, power).name for name in machine.components for power in powers)
    curves = Argument(
        name="curves",
        rows=rows,
        shape=(len(machine.components), machine.curve_degree),
        per_point=False,
        unit="mm/mm^k, rad/mm^k" + (" (deg^k for rotary axes)" if any(axis in ROTARY for axis in machine.axes) else ""),
        description=f"coefficients of the powers 1 to {machine.curve_degree} of the axis position, per component error",
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
            (", constants folded once per call", (by_row(deviation.rows, folded), binder.assignments)),
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
