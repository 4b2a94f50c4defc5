"""The paper's notation: points r_k and r_l in the frames of the carriages, positions with the index h, readings L."""

import re
from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from trueaxis.codegen.latex import Latex
from trueaxis.codegen.paper_layout import Pattern, Reading
from trueaxis.derivation import symbols
from trueaxis.derivation.chain import Vector
from trueaxis.derivation.motion import MotionEquation, motion_equation
from trueaxis.effects.latex import component_latex
from trueaxis.machine.machine import Body, Machine
from trueaxis.machine.topology import branches
from trueaxis.view import Carrier

_POINT = re.compile(r"r\^?([XYZ]*)_([kl]\w*)([xyz])")
AXES = "xyz"


@dataclass(frozen=True)
class Form:
    """A displacement in one direction: its error-free part, mm, and the coefficient of each error."""

    ideal: sp.Expr
    columns: Mapping[str, sp.Expr]


def point(label: str, pattern: str = "") -> Vector:
    """The coordinates of P_k1, P_l ...; points of a linkage bear its axes, because their numbers begin at 1 again."""
    above = f"^{pattern}" if len(pattern) > 1 and label[-1].isdigit() else ""
    x, y, z = (sp.Symbol(f"r{above}_{label}{axis}", real=True) for axis in AXES)
    return x, y, z


def paper_latex(machine: Machine, values: list[sp.Symbol]) -> Latex:
    """A printer of the paper's names: x_h, delta_x(x_h), r_{k1x}."""
    names = {axis.lower(): f"{axis.lower()}_h" for axis in machine.axes}
    for component in machine.components:
        names[component] = component_latex(component).replace(")", "_h)")
    for symbol in values:
        if found := _POINT.fullmatch(symbol.name):
            above = f"^{{{found[1]}}}" if found[1] else ""
            names[symbol.name] = f"r{above}_{{{found[2]}{found[3]}}}"
    return Latex(machine, names)


def motion(machine: Machine, pattern: str, label: str) -> MotionEquation:
    """The motion equation of a pattern for the point of a label: of P_l on the worktable less P_k on the tool."""
    workpiece, tool = branches(machine)
    terms: tuple[tuple[int, Carrier, Vector], ...] = ()
    ends: tuple[tuple[str, Carrier, tuple[Body, ...]], ...] = (("l", "workpiece", workpiece), ("k", "tool", tool))
    for name, seen, bodies in ends:
        if {body.moves for body in bodies} & set(pattern):
            sign = -1 if terms else 1
            terms += ((sign, seen, _in_frame(bodies[-1], point(name + label, pattern))),)
    return motion_equation(machine, tuple(pattern), terms)


def form(machine: Machine, pattern: Pattern, reading: Reading) -> Form:
    """What a reading is, to first order."""
    equation = motion(machine, pattern.axes, reading.label)
    row = AXES.index(reading.direction)
    columns = {name: sp.expand(column[row]) for name, column in equation.motion.columns.items()}
    return Form(sp.expand(equation.motion.ideal[row]), {n: c for n, c in columns.items() if c != 0})


def _in_frame(end: Body, at: Vector) -> Vector:
    """A point of a carriage in the frame of the end that stands on it."""
    x, y, z = (
        r - (symbols.named(q) if isinstance(q, str) else sp.Float(q)) for r, q in zip(at, end.position, strict=True)
    )
    return x, y, z


def by_monomial(columns: Mapping[str, sp.Expr]) -> list[tuple[sp.Expr, dict[str, sp.Expr]]]:
    """A linear form sorted by the monomials of its coefficients: (monomial, number of each error)."""
    groups: dict[sp.Expr, dict[str, sp.Expr]] = {}
    for name, coefficient in columns.items():
        for term in sp.Add.make_args(sp.expand(coefficient)):
            number, monomial = term.as_coeff_Mul()
            groups.setdefault(monomial, {})[name] = number
    return sorted(groups.items(), key=lambda item: item[0] != 1)


def monomial_terms(columns: Mapping[str, sp.Expr], latex: Latex) -> list[str]:
    """Terms in the paper's shape: r_{kiz} (e_y(x_h) + e_y(z_h))."""
    terms: list[str] = []
    for monomial, numbers in by_monomial(columns):
        terms += latex.linear({name: number * monomial for name, number in numbers.items()})
    return terms
