"""The paper's notation: points r_k and r_l in the frames of the carriages, positions with the index h, readings L.

In it, what the kernels of the paper's systems take and return, and Tables 1, 3, 4 and 5.
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import sympy as sp

from trueaxis.codegen.latex import Latex, joined
from trueaxis.codegen.paper_layout import Pattern, Reading, System
from trueaxis.codegen.system_section import point_name
from trueaxis.derivation import symbols
from trueaxis.derivation.chain import Vector, chains, matrix
from trueaxis.derivation.model import DerivedModel, system_name
from trueaxis.derivation.motion import MotionEquation, motion_equation
from trueaxis.derivation.products import multiplied_out
from trueaxis.derivation.systems import IdentificationSystem, Point, RunPattern
from trueaxis.effects.latex import component_latex
from trueaxis.machine.machine import Body, Machine
from trueaxis.machine.topology import branches
from trueaxis.view import Carrier

_POINT = re.compile(r"r\^?([XYZ]*)_([kl]\w*)([xyz])")
AXES = "xyz"
HOME = {"tool": ("k", "q_T"), "workpiece": ("l", "q_w")}
"""Letter of a carriage's points, and the home of the frame that stands on the carriage."""

_TABLE_1 = (
    ("positioning error", ("EXX", "EYY", "EZZ")),
    ("straightness error, x direction", ("", "EXY", "EXZ")),
    ("straightness error, y direction", ("EYX", "", "EYZ")),
    ("straightness error, z direction", ("EZX", "EZY", "")),
    ("roll error", ("EAX", "EBY", "ECZ")),
    ("pitch error", ("EBX", "EAY", "EAZ")),
    ("yaw error", ("ECX", "ECY", "EBZ")),
    ("XY perpendicularity error", ("eps_xy", "", "")),
    ("XZ perpendicularity error", ("eps_xz", "", "")),
    ("YZ perpendicularity error", ("eps_yz", "", "")),
)


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
    columns = {name: multiplied_out(column[row]) for name, column in equation.motion.columns.items()}
    return Form(multiplied_out(equation.motion.ideal[row]), {n: c for n, c in columns.items() if c != 0})


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
        for term in sp.Add.make_args(multiplied_out(coefficient)):
            number, monomial = term.as_coeff_Mul()
            groups.setdefault(monomial, {})[name] = number
    return sorted(groups.items(), key=lambda item: item[0] != 1)


def monomial_terms(columns: Mapping[str, sp.Expr], latex: Latex) -> list[str]:
    """Terms in the paper's shape: r_{kiz} (e_y(x_h) + e_y(z_h))."""
    terms: list[str] = []
    for monomial, numbers in by_monomial(columns):
        terms += latex.linear({name: number * monomial for name, number in numbers.items()})
    return terms


def kernel_lines(
    model: DerivedModel, pattern: Pattern, system: System, forms: list[Form], latex: Latex
) -> Iterator[str]:
    """A sentence per kernel of a system, in the order of the system's unknowns: readings, points, order of return."""
    assert model.identification is not None
    numbered = dict(enumerate(model.identification.systems))
    own = {k: each for k, each in numbered.items() if set(each.unknowns) <= set(system.unknowns)}
    runs = {run.name: run for run in model.runs}
    for k, each in sorted(own.items(), key=lambda item: system.unknowns.index(item[1].unknowns[0])):
        taken = [system.readings.index(_reading(runs[name])) for name in each.runs]
        readings = ", ".join(f"${reduced(system.readings[n], forms[n], latex)}$" for n in taken)
        points = ", ".join(_points(each, pattern, [runs[name] for name in each.runs]))
        unknowns = ", ".join(f"${latex.symbol(name)}$" for name in each.unknowns)
        several = " in this order" if len(each.unknowns) > 1 else ""
        yield (
            f"`{system_name(k)}` takes the displacements less those of the error-free machine, {readings}, "
            f"and the points in TCS and WCS, {points}; it returns {unknowns}{several}."
        )


def reduced(reading: Reading, form: Form, latex: Latex) -> str:
    """A displacement less that of the error-free machine: L_{1xh} - x_h."""
    return joined([f"+ {reading.latex}", *latex.terms(-form.ideal)])


def _reading(run: RunPattern) -> Reading:
    label = run.name.partition("-")[2]
    return Reading(label[0], label[1:] or run.moves[0].lower())


def _points(system: IdentificationSystem, pattern: Pattern, runs: list[RunPattern]) -> Iterator[str]:
    """`r_{k1} - q_T` with the kernel's name for it."""
    labels: dict[tuple[Carrier, Point], str] = {}
    for run in runs:
        for end in (run.target, run.reference):
            labels.setdefault(end, _reading(run).label)
    above = f"^{{{pattern.axes}}}" if len(pattern.axes) > 1 else ""
    for triple, on, at in system.points:
        letter, home = HOME[on]
        yield f"$`r{above}_{{{letter}{labels[on, at]}}} - {home}`$ (`{point_name(triple)}`)"


@dataclass(frozen=True)
class Table1:
    """Axes, and rows of a name and three cells."""

    axes: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def kinds_of_table_1() -> dict[str, str]:
    """`yaw error of X` for each rotation of an axis."""
    turns = [(kind, errors) for kind, errors in _TABLE_1 if kind in ("roll error", "pitch error", "yaw error")]
    return {name: f"{kind} of {axis}" for kind, errors in turns for axis, name in zip("XYZ", errors, strict=True)}


def table_1(machine: Machine) -> Iterator[tuple[str, ...]]:
    """Rows of Table 1: a name, then the errors of the axes X, Y, Z, linked to the table of symbols."""
    texts = symbols.describe(machine)
    for title, errors in _TABLE_1:
        yield title, *(f"${texts[name].latex}$ [`{name}`](#{name})" if name else "" for name in errors)


def table_3(patterns: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """Rows of Table 3: the ideal motion of bodies L, J and K in each pattern, without the fourth element, 1."""
    for letter, axis in (("l", "Y"), ("j", "X"), ("k", "Z")):
        cells = [[f"{a.lower()}_h" if a == axis and axis in moving else "0" for a in "XYZ"] for moving in patterns]
        yield f"$S^l_{{{letter}h}}$", *(f"$({', '.join(cell)})$" for cell in cells)


def position_errors(machine: Machine, latex: Latex) -> Iterator[str]:
    """[SIJ]_pe and [SJK]_pe of Table 3, the position errors of the X and the Z carriage."""
    for axis in "XZ":
        (error,) = (step for joint in chains(machine)[1] if joint.body.moves == axis for step in joint.steps[1:2])
        yield latex(matrix(error))


def points(model: DerivedModel) -> Iterator[tuple[str, str, str, str]]:
    """Points of Tables 4 and 5: name, coordinates, frame, runs."""
    found: dict[tuple[str, str, str], list[str]] = {}
    for run in model.runs:
        pattern, _, label = run.name.partition("-")
        above = f"^{{{pattern}}}" if len(pattern) > 1 else ""
        for body, at in (run.target, run.reference):
            if body != "bed":
                letter, frame = ("k", "TCS") if body == "tool" else ("l", "WCS")
                key = (f"$P{above}_{{{letter}{label[0]}}}$", f"({', '.join(f'{c:g}' for c in at)})", frame)
                found.setdefault(key, []).append(run.name)
    for key, runs in found.items():
        yield *key, ", ".join(runs)
