"""The sections of equations.md on motion equations and identification systems, and what these cannot tell apart."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import sympy as sp

from trueaxis.codegen.chain_section import AXES, Row
from trueaxis.codegen.latex import WIDEST, Latex, broken, is_negative, joined, width
from trueaxis.derivation import symbols
from trueaxis.derivation.chain import Vector
from trueaxis.derivation.model import motion_name, system_name
from trueaxis.derivation.motion import MotionEquation
from trueaxis.derivation.products import linear_form, multiplied_out
from trueaxis.derivation.systems import IdentificationSystem, RunPattern
from trueaxis.machine.machine import Machine
from trueaxis.view import view_of


@dataclass(frozen=True)
class EquationText:
    """A titled block of rows, and where it comes from."""

    title: str
    reference: str
    source: str
    rows: tuple[Row, ...]


@dataclass(frozen=True)
class ReadingText:
    """One reading: its symbol, its run, what it senses."""

    symbol: str
    run: str
    what: str


@dataclass(frozen=True, kw_only=True)
class SystemText:
    """One identification system: matrix times unknowns = b; b by rows; the solution by rows, none where it is left."""

    title: str
    reference: str
    kernel: str
    readings: tuple[ReadingText, ...]
    points: tuple[tuple[str, str, str], ...]
    unknowns: str
    matrix: str
    reduced: str
    right: tuple[Row, ...]
    solution: tuple[Row, ...]
    rank: int
    size: int


def motion_text(equation: MotionEquation, latex: Latex, references: dict[str, str]) -> EquationText:
    """A motion equation: displacement since home of the points of its terms."""
    motion = equation.motion
    rows = tuple(
        broken(
            f"\\Delta {row}",
            latex.terms(motion.ideal[i]) + latex.linear({n: c[i] for n, c in motion.columns.items()}),
        )
        for i, row in enumerate(AXES)
    )
    what = " minus ".join(f"{seen} point" for _, seen, _ in equation.terms)
    sources = " less ".join(f"`{view_of(seen, equation.frame)}`" for _, seen, _ in equation.terms)
    reference = references.get(motion_name(equation.moves), "")
    return EquationText(f"{' and '.join(equation.moves)}: {what}", reference, sources, rows)


def coefficients(machine: Machine, value: sp.Expr) -> dict[str, sp.Expr]:
    """A linear form of errors as its coefficients, in the machine's order."""
    found = linear_form(value, map(symbols.named, machine.components + machine.location_errors))
    return {symbol.name: coefficient for symbol, coefficient in found.items()}


def system_text(
    machine: Machine, index: int, system: IdentificationSystem, runs: dict[str, RunPattern], latex: Latex
) -> SystemText:
    """One system of a machine, in the order in which it is solved."""
    readings = [sp.Symbol(f"L{k + 1}", real=True) for k in range(len(system.runs))]
    names = [_reduced(k) for k in range(len(readings))]
    right = tuple(
        broken(name, [f"+ {latex(reading)}", *latex.linear(coefficients(machine, -known))])
        for name, reading, known in zip(names, readings, system.known, strict=True)
    )
    matrix = sp.Matrix(system.matrix)
    return SystemText(
        title=f"{index + 1}. {', '.join(system.unknowns)} ({' and '.join(''.join(m) for m in system.moves)})",
        reference=dict(machine.references).get(system_name(index), ""),
        kernel=system_name(index) if system.adjugate is not None else "",
        readings=tuple(
            ReadingText(latex(reading), run, _sensed(runs[run]))
            for reading, run in zip(readings, system.runs, strict=True)
        ),
        points=tuple(
            (f"({', '.join(latex(s) for s in triple)})", on, f"({', '.join(f'{c:g}' for c in at)})")
            for triple, on, at in system.points
        ),
        unknowns=latex(sp.Matrix([symbols.named(name) for name in system.unknowns])),
        matrix=latex(matrix),
        reduced=r"\begin{bmatrix}" + r"\\".join(names) + r"\end{bmatrix}",
        right=right,
        solution=tuple(_solution(system, names, latex)),
        rank=system.rank,
        size=len(system.unknowns),
    )


def _reduced(number: int) -> str:
    return f"b_{{{number + 1}}}"


def _sensed(run: RunPattern) -> str:
    """What a run reads, in words: the displacement of one end against the other, along a direction."""
    axis = [f"{'+' if part > 0 else '-'}{letter}" for part, letter in zip(run.direction, "XYZ", strict=True) if part]
    along = axis[0] if len(axis) == 1 else f"({', '.join(f'{part:g}' for part in run.direction)})"
    ends = [end[0] for end in (run.target, run.reference) if end[0] != run.frame]
    verb = "moves" if len(run.moves) == 1 else "move"
    return f"{' against '.join(ends)} along {along} of the {run.frame}, while {' and '.join(run.moves)} {verb}"


def _solution(system: IdentificationSystem, names: list[str], latex: Latex) -> Iterator[Row]:
    """Each unknown by Cramer's rule from the right-hand sides b_k."""
    if system.adjugate is None or system.determinant is None:
        return
    adjugate, determinant = system.adjugate, multiplied_out(system.determinant)
    plain = determinant in (1, -1)
    if not plain:
        yield broken("D", latex.terms(determinant))
    for name, row in zip(system.unknowns, range(adjugate.rows), strict=True):
        entries = [multiplied_out(entry * (determinant if plain else 1)) for entry in adjugate.row(row)]
        left = latex.symbol(name) if plain else f"D\\,{latex.symbol(name)}"
        yield broken(left, list(products(entries, names, latex)))


def products(entries: list[sp.Expr], names: list[str], latex: Latex) -> Iterator[str]:
    """Terms `+ (entry) name`; an entry that is too wide for one row is multiplied out."""
    for entry, name in zip(entries, names, strict=True):
        if entry == 0:
            continue
        sign, size = ("-", multiplied_out(-entry)) if is_negative(entry) else ("+", entry)
        inner = joined(latex.terms(size))
        if size == 1:
            yield f"{sign} {name}"
        elif not size.is_Add:
            yield f"{sign} {inner}\\,{name}"
        elif width(inner) < 0.8 * WIDEST:
            yield f"{sign} \\left({inner}\\right) {name}"
        else:
            yield from (f"{term}\\,{name}" for term in latex.terms(entry))


def point_name(triple: Vector) -> str:
    """`rT1` of (rT1x, rT1y, rT1z)."""
    return str(triple[0].name)[:-1]


def combination_text(machine: Machine, combination: Mapping[str, sp.Rational]) -> str:
    """One sentence on a combination of changes that leaves every reading as it is."""
    location = [name for name in combination if name in machine.location_errors]
    curves = [name for name in machine.components if name in combination]
    if location:
        change = ", ".join(f"{_signed(combination[n])} {machine.parameter_unit(n)} in {n}" for n in location)
        if not curves:
            return f"{', '.join(location)}: a change of {change} changes no reading; the runs do not see it at all."
        if not all(n.is_of_linear_axis for n in curves):
            return (
                f"{', '.join(location)}: the curves of {', '.join(curves)} can take up a change of {change} "
                "position by position, and no reading changes."
            )
        names = f"{', '.join(location)} and the slope of {', '.join(curves)}"
        slopes = ", ".join(f"{_signed(combination[n])} {n.unit} per {n.axis_unit} in the slope of {n}" for n in curves)
        text = f"{names}: a change of {change} with {slopes} changes no reading"
        if len(location) == len(curves) == 1:
            sign = "-" if combination[curves[0]] / combination[location[0]] > 0 else "+"
            ratio = abs(combination[curves[0]] / combination[location[0]])
            factor = "" if ratio == 1 else f"{float(ratio):g} "
            return f"{text}; only (slope of {curves[0]}) {sign} {factor}{location[0]} is determined."
        return f"{text}."
    return (
        f"{', '.join(curves)}: at every position one combination of them is free, because the equations that hold "
        "them are not independent at the points of these runs."
    )


def _signed(value: sp.Rational) -> str:
    number = float(value)
    return f"{number:+g}"
