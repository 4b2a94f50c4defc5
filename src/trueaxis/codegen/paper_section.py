"""The sections of equations.md that only the page of the paper's own machine has: Eqs. (12) to (38) in its order."""

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

from trueaxis.codegen.latex import Latex, broken, is_negative, joined
from trueaxis.codegen.paper_layout import ERRATA_PAGE, PATTERNS, RUNS, Pattern, Reading, System, beside, erratum
from trueaxis.codegen.paper_notation import (
    AXES,
    Form,
    Table1,
    form,
    kernel_lines,
    monomial_terms,
    motion,
    paper_latex,
    points,
    position_errors,
    reduced,
    table_1,
    table_3,
)
from trueaxis.derivation.model import DerivedModel
from trueaxis.derivation.products import multiplied_out
from trueaxis.machine.machine import Machine
from trueaxis.view import view_of

Row = str


@dataclass(frozen=True, kw_only=True)
class Block:
    """One numbered equation: a title, a sentence before it, plain maths or rows or both, behind it a warning and
    what its kernels take and return.
    """

    number: int
    title: str
    text: str
    maths: str = ""
    rows: tuple[Row, ...] = ()
    warning: str = ""
    kernels: tuple[str, ...] = ()

    @property
    def beside(self) -> str:
        """Links to its errata."""
        return beside(self.number)


@dataclass(frozen=True)
class Section:
    """A section of the paper."""

    number: str
    title: str
    blocks: tuple[Block, ...]

    @property
    def link(self) -> str:
        """What the contents call it."""
        return f"Sect. {self.number}"

    @property
    def anchor(self) -> str:
        """Its anchor on the page."""
        return f"sect-{self.number.replace('.', '')}-{self.title.lower().replace(' ', '-').replace(',', '')}"


@dataclass(frozen=True, kw_only=True)
class PaperPart:
    """What the template asks for."""

    table_1: Table1
    motions: tuple[str, ...]
    table_3: tuple[tuple[str, ...], ...]
    position_errors: tuple[str, ...]
    sections: tuple[Section, ...]
    points: tuple[tuple[str, str, str, str], ...]
    errata_page: str = ERRATA_PAGE

    def beside(self, *sources: int | str) -> str:
        """Links to the errata of these equations."""
        return beside(*sources)

    def erratum(self, number: int) -> str:
        """A link to one erratum."""
        return erratum(number)


def is_the_papers(model: DerivedModel) -> bool:
    """Whether a spec names the paper's numbers and its 18 runs."""
    return bool(model.machine.references) and {run.name for run in model.runs} == RUNS


def paper_part(model: DerivedModel) -> PaperPart:
    """The sections of the paper's machine."""
    machine = model.machine
    latex = _printer(machine)
    parts: dict[str, list[Block]] = {}
    for pattern in PATTERNS:
        parts.setdefault(pattern.section, []).append(_motion_block(machine, pattern, latex))
    for pattern in PATTERNS:
        parts[pattern.section] += _reading_blocks(machine, pattern, latex)
        for system in pattern.systems:
            parts[pattern.section] += _system_blocks(model, pattern, system, latex)
    titles = {"3.2": "Single axes"} | {p.section: p.title for p in PATTERNS if len(p.axes) > 1}
    sections = tuple(
        Section(number, titles[number], tuple(sorted(blocks, key=lambda block: block.number)))
        for number, blocks in parts.items()
    )
    patterns = tuple(pattern.axes for pattern in (*PATTERNS[:3], PATTERNS[4], PATTERNS[3], PATTERNS[5]))
    return PaperPart(
        table_1=Table1(("X", "Y", "Z"), tuple(table_1(machine))),
        motions=patterns,
        table_3=tuple(table_3(patterns)),
        position_errors=tuple(position_errors(machine, latex)),
        sections=sections,
        points=tuple(points(model)),
    )


def _printer(machine: Machine) -> Latex:
    values: set[sp.Symbol] = set()
    for pattern in PATTERNS:
        for label in ("", "i", *(reading.label for system in pattern.systems for reading in system.readings)):
            equation = motion(machine, pattern.axes, label)
            for column in equation.motion.columns.values():
                values |= {symbol for entry in column for symbol in entry.free_symbols}
    return paper_latex(machine, sorted(values, key=str))


def _motion_block(machine: Machine, pattern: Pattern, latex: Latex) -> Block:
    equation = motion(machine, pattern.axes, "")
    differences = [f"{{}}_{{{seen[0].replace('w', 'l').replace('t', 'k')}{{pose}}}}" for _, seen, _ in equation.terms]
    rows = []
    for i, axis in enumerate(AXES):
        left = " - ".join(_difference(text, axis, bracket=n > 0) for n, text in enumerate(differences))
        column = {name: entry[i] for name, entry in equation.motion.columns.items()}
        rows.append(broken(left, latex.terms(equation.motion.ideal[i]) + monomial_terms(column, latex)))
    views = " less that of ".join(f"the view `{view_of(seen, 'bed')}`" for _, seen, _ in equation.terms)
    sign = "" if "Y" in pattern.axes else "The negative of "
    text = (
        f"{sign}Eq. (11) with the columns {pattern.axes} of Table 3; to first order the change since home of {views}:"
    )
    return Block(number=pattern.motion, title=f"motion of {pattern.title}", text=text, rows=tuple(rows))


def _difference(text: str, axis: str, *, bracket: bool) -> str:
    moved, home = (text.replace("{}", axis, 1).replace("{pose}", pose) for pose in "h0")
    return f"({moved} - {home})" if bracket else f"{moved} - {home}"


def _reading_blocks(machine: Machine, pattern: Pattern, latex: Latex) -> Iterator[Block]:
    if pattern.projected:
        number, sine, cosine = pattern.projected
        rows: tuple[Row, ...] = (
            f"L_{{i{sine}h}} &= L_{{ih}}\\,\\sin\\theta + \\delta_{{ih}}\\,\\cos\\theta",
            f"L_{{i{cosine}h}} &= L_{{ih}}\\,\\cos\\theta - \\delta_{{ih}}\\,\\sin\\theta",
        )
        text = (
            "The displacement $L_{ih}$ along the linkage line and the straightness $\\delta_{ih}$ across it, $\\theta$ "
            f"measured from the {cosine.upper()} axis:"
        )
        yield Block(number=number, title="projections of the line", text=text, rows=rows)
    if pattern.general:
        number, directions = pattern.general
        text = f"The rows of Eq. ({pattern.motion}) that are read, for any point $i$:"
        rows = tuple(_reading_row(machine, pattern, Reading("i", d), latex) for d in directions)
        yield Block(number=number, title="readings", text=text, rows=rows)
    for number, readings in pattern.special:
        projected = f"; their projections are those of Eq. ({pattern.projected[0]})" if pattern.projected else ""
        text = f"The same at the points of Table 5, rows of Eq. ({pattern.motion}){projected}:"
        rows = tuple(_reading_row(machine, pattern, reading, latex) for reading in readings)
        yield Block(number=number, title="readings at the measured points", text=text, rows=rows)


def _reading_row(machine: Machine, pattern: Pattern, reading: Reading, latex: Latex) -> Row:
    found = form(machine, pattern, reading)
    return broken(reading.latex, latex.terms(found.ideal) + monomial_terms(found.columns, latex))


def _system_blocks(model: DerivedModel, pattern: Pattern, system: System, latex: Latex) -> Iterator[Block]:
    machine = model.machine
    forms = [form(machine, pattern, reading) for reading in system.readings]
    matrix = sp.Matrix([[f.columns.get(name, sp.S.Zero) for name in system.unknowns] for f in forms])
    unknowns = r"\begin{bmatrix}" + r"\\".join(latex.symbol(name) for name in system.unknowns) + r"\end{bmatrix}"
    known = [{n: c for n, c in f.columns.items() if n not in system.unknowns} for f in forms]
    warning = _rank_warning(model, system)
    kernels = tuple(kernel_lines(model, pattern, system, forms, latex))
    assumed = _assumed(machine, forms, latex)
    if not system.rows:
        left = r"\begin{bmatrix}" + r"\\".join(
            reduced(r, f, latex) for r, f in zip(system.readings, forms, strict=True)
        )
        left += r"\end{bmatrix}"
        text = f"The rows of Eq. ({pattern.motion}) that are read at the three points of Table 4:"
        maths = f"{left} = {latex(matrix)} {unknowns}"
        yield Block(number=system.number, title=f"system of {pattern.title}", text=text, maths=maths, warning=warning)
        maths = f"{unknowns} = {latex(matrix)}^{{-1}} {left}"
        title, text = f"solution of {pattern.title}", f"Eq. ({system.number}) solved:"
        yield Block(number=system.solution, title=title, text=text, maths=maths, warning=warning, kernels=kernels)
        return
    if system.number:
        sources = " and ".join(f"({number})" for number, rows in pattern.special if set(rows) & set(system.readings))
        right = f"On the right, in $b_k$, are the readings and the errors identified before{assumed}:"
        text = f"Eq. {sources} as a system. {right}"
        names = [f"b_{{{k + 1}}}" for k in range(len(forms))]
        stack = r"\begin{bmatrix}" + r"\\".join(names) + r"\end{bmatrix}"
        rows = tuple(
            broken(name, _known_terms(r, f, k, latex))
            for name, r, f, k in zip(names, system.readings, forms, known, strict=True)
        )
        yield Block(
            number=system.number, title="system", text=text, maths=f"{latex(matrix)} {unknowns} = {stack}", rows=rows
        )
    rows = tuple(_closed_forms(system, forms, latex))
    source = system.number or next(number for number, rows in pattern.special if set(rows) >= set(system.readings))
    yield Block(
        number=system.solution, title="solution", text=f"Eq. ({source}) solved{assumed}:", rows=rows, kernels=kernels
    )


def _assumed(machine: Machine, forms: list[Form], latex: Latex) -> str:
    """`; eps_xz is assumed to be known`: no reading gives the location errors that these have."""
    names = [name for name in machine.location_errors if any(name in form.columns for form in forms)]
    listed = ", ".join(f"${latex.symbol(name)}$" for name in names)
    return f"; {listed} is assumed to be known ([E30]({ERRATA_PAGE}#e30))" if names else ""


def _known_terms(reading: Reading, found: Form, known: dict[str, sp.Expr], latex: Latex) -> list[str]:
    moved = monomial_terms({name: -value for name, value in known.items()}, latex)
    return [f"+ {reading.latex}", *latex.terms(-found.ideal), *moved]


def _closed_forms(system: System, forms: list[Form], latex: Latex) -> Iterator[Row]:
    """Unknowns pair by pair: a rotation from the difference of two readings, a displacement from the first."""
    free = list(system.unknowns)
    while free:
        displacement = free.pop(0)
        rows = [k for k, found in enumerate(forms) if displacement in found.columns]
        rotation = next((n for n in free if n in forms[rows[0]].columns), None)
        if rotation is not None:
            free.remove(rotation)
            yield _rotation_row(rotation, displacement, rows, system, forms, latex)
        own = forms[rows[0]].columns
        sign = own[displacement]
        others = {name: -sign * value for name, value in own.items() if name != displacement}
        reading = f"{'+' if sign > 0 else '-'} {system.readings[rows[0]].latex}"
        terms = [reading, *latex.terms(-sign * forms[rows[0]].ideal), *monomial_terms(others, latex)]
        yield broken(latex.symbol(displacement), terms)


def _rotation_row(
    rotation: str, displacement: str, rows: list[int], system: System, forms: list[Form], latex: Latex
) -> Row:
    """(difference of two readings less what is known) / (difference of two coordinates)."""
    first, second = (forms[k] for k in rows)
    base = multiplied_out(first.columns[rotation] - second.columns[rotation])
    order = list(rows)
    sign = 1
    lead = base.as_ordered_terms()[0]
    if is_negative(lead):
        base, sign = -base, -1
        order.reverse()
    difference = {
        name: multiplied_out(-sign * (first.columns.get(name, 0) - second.columns.get(name, 0)))
        for name in {**first.columns, **second.columns}
        if name not in (rotation, displacement)
    }
    readings = [f"+ {system.readings[order[0]].latex}", f"- {system.readings[order[1]].latex}"]
    ideal = latex.terms(-sign * multiplied_out(first.ideal - second.ideal))
    top = joined([*readings, *ideal, *latex.linear(difference)])
    return f"{latex.symbol(rotation)} &= \\frac{{{top}}}{{{joined(latex.terms(base))}}}"


def _rank_warning(model: DerivedModel, system: System) -> str:
    found = model.identification
    assert found is not None
    for each in found.systems:
        if set(each.unknowns) == set(system.unknowns) and each.rank < len(each.unknowns):
            return (
                f"**At these points the rank is {each.rank}, less than the {len(each.unknowns)} unknowns: this system "
                f"has no unique solution** ([E33]({ERRATA_PAGE}#e33))."
            )
    return ""
