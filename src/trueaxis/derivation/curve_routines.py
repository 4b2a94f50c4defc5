"""Routines for error curves that are polynomials: coefficients in, deviation of the tool point out, in folded form.

Each entry of the deviation is a sum of (monomial in positions, cosines and sines) x (constant) x (component error),
and every component error of one axis is a polynomial in the same position. So all terms of one entry that share
monomial and axis are one polynomial, whose coefficients are folded once per call: fewer polynomials per point than
there are component errors.
"""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.chain import Vector
from trueaxis.derivation.first_order import first_order
from trueaxis.derivation.products import Factors, Sum, polynomial
from trueaxis.derivation.routine import (
    Argument,
    Binder,
    Routine,
    build,
    by_row,
    parameters_argument,
    point_argument,
    positions_argument,
    vector_argument,
)
from trueaxis.derivation.sharing import Assignment
from trueaxis.derivation.views import ViewWalk, walk
from trueaxis.error_name import ErrorName
from trueaxis.machine.machine import ROTARY, Machine

Monomial = tuple[int, ...]
Terms = list[tuple[str, sp.Expr]]  # error, constant factor
Folds = dict[Monomial, dict[str, Terms]]  # monomial in positions, cosines and sines -> axis, "" for location errors


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

    def first_order_routine(remark: str, results: dict[str, sp.Expr], bound: list[Assignment]) -> Routine:
        return build(
            f"{main.name}_deviation_first_order_curves",
            f"Deviation of the tool point under polynomial error curves, to first order{remark}.",
            "Eqs. (1)-(4), (44)",
            inputs,
            (deviation,),
            results,
            bound,
        )

    walked = first_order_routine("", *_walk_with_curves(machine, main, deviation.rows, exact=False))
    folds = [_folds(machine, entry) for entry in _rows(first_order(main, symbols.point()).columns)]
    # With two rotary axes there are more monomials to fold by than component errors.
    if _polynomials(folds) * (2 * machine.curve_degree - 1) > walked.operations:
        yield walked
        return
    binder = Binder()
    results = by_row(deviation.rows, _folded_deviation(machine, folds, binder))
    folded = first_order_routine(", constants folded once per call", results, binder.assignments)
    yield min(folded, walked, key=lambda routine: routine.operations)


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


def coefficient(component: str, power: int) -> sp.Symbol:
    """Coefficient of a power of the axis position in a component's polynomial, mm or rad per mm^power or deg^power."""
    return symbols.named(f"{component}_{power}")


def _horner(coefficients: Sequence[sp.Expr], at: sp.Expr) -> sp.Expr:
    """c1 at + c2 at^2 + ... in Horner's form (no constant term)."""
    value: sp.Expr = sp.S.Zero
    for c in reversed(coefficients):
        value = at * (c + value)
    return value


def curve(component: ErrorName, degree: int) -> sp.Expr:
    """A component error as a polynomial of its axis position."""
    powers = range(1, degree + 1)
    return _horner([coefficient(component, power) for power in powers], symbols.position(component.axis))


def _rows(columns: Mapping[str, Vector]) -> list[dict[str, sp.Expr]]:
    """The derivatives of each entry by the errors that it has."""
    return [{name: column[row] for name, column in columns.items() if column[row] != 0} for row in range(3)]


def _folds(machine: Machine, entry: Mapping[str, sp.Expr]) -> Folds:
    """The terms of an entry of the deviation, sorted by what they can be folded by."""
    places = {generator: place for place, generator in enumerate(_generators(machine))}
    axis_of: dict[str, str] = {component: component.axis for component in machine.components}
    folds: Folds = {}
    for name, value in entry.items():
        constants: dict[Monomial, dict[Factors, sp.Number]] = {}
        for factors, number in polynomial(value).numbers.items():
            rest = tuple(factor for factor in factors if factor not in places)
            powers = Counter(places[factor] for factor in factors if factor in places)
            constants.setdefault(tuple(powers[place] for place in places.values()), {})[rest] = number
        for monomial, terms in constants.items():
            constant = Sum(terms).expression()
            folds.setdefault(monomial, {}).setdefault(axis_of.get(name, ""), []).append((name, constant))
    return folds


def _polynomials(folds: Sequence[Folds]) -> int:
    """How many different polynomials are left once all is folded; two that are each other's opposite are one."""
    found = set()
    for by_axis in (group for entry in folds for group in entry.values()):
        for axis, terms in by_axis.items():
            if axis:
                found.add((axis, *((name, _sign(terms) * constant) for name, constant in terms)))
    return len(found)


def _sign(terms: Terms) -> int:
    return -1 if all(constant.could_extract_minus_sign() for _, constant in terms) else 1


def _folded_deviation(machine: Machine, folds: Sequence[Folds], binder: Binder) -> Vector:
    """The first-order deviation of a view (mm) with curves of the machine's degree, folded as above."""
    x, y, z = (
        sp.Add(*(_group(machine, monomial, entry[monomial], binder) for monomial in sorted(entry))) for entry in folds
    )
    return x, y, z


def _group(machine: Machine, monomial: Monomial, by_axis: dict[str, Terms], binder: Binder) -> sp.Expr:
    parts: list[sp.Expr] = []
    for axis, terms in by_axis.items():
        if not axis:
            parts.append(binder.bind(sp.Add(*(constant * symbols.named(name) for name, constant in terms))))
            continue
        powers = range(1, machine.curve_degree + 1)
        # With its sign taken out, a polynomial and its opposite in another entry are one.
        sign = _sign(terms)
        folded = [
            binder.bind(sp.Add(*(sign * constant * coefficient(name, power) for name, constant in terms)))
            for power in powers
        ]
        parts.append(sign * binder.bind(_horner(folded, symbols.position(axis))))
    weight = sp.Mul(*(g**power for g, power in zip(_generators(machine), monomial, strict=True)))
    return binder.bind(weight * binder.bind(sp.Add(*parts)))


def _generators(machine: Machine) -> list[sp.Symbol]:
    linear = [symbols.position(axis) for axis in machine.axes if axis not in ROTARY]
    rotary = [make(axis) for axis in machine.axes if axis in ROTARY for make in (symbols.cosine, symbols.sine)]
    return linear + rotary
