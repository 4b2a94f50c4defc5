"""equations.md: the derived equations as a person reads them, on a page that GitHub renders."""

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

from trueaxis.derive import symbols
from trueaxis.derive.chain import Joint, chains, matrix
from trueaxis.derive.first_order import first_order
from trueaxis.derive.model import DerivedModel, motion_name, system_name
from trueaxis.derive.motion import MotionEquation
from trueaxis.derive.systems import IdentificationSystem
from trueaxis.derive.views import view
from trueaxis.emit.effect_section import effect_symbols, effect_texts
from trueaxis.emit.latex import Latex, broken
from trueaxis.emit.meta import ABI, spec_name
from trueaxis.emit.templates import environment
from trueaxis.emit.undetermined import combination_text
from trueaxis.topology import lower_body_array

_ROWS = ("x", "y", "z")


@dataclass(frozen=True)
class JointText:
    """One joint of the chain: its four factors, None where a factor is the unit matrix."""

    title: str
    name: str
    factors: tuple[tuple[str, str | None], ...]


@dataclass(frozen=True)
class EquationText:
    """A titled block of lines `left &= right`."""

    title: str
    reference: str
    lines: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class SystemText:
    """One identification system."""

    title: str
    reference: str
    runs: tuple[tuple[str, str], ...]
    points: tuple[tuple[str, str, str], ...]
    unknowns: str
    matrix: str
    right: tuple[str, ...]
    solution: tuple[tuple[str, str], ...]
    determinant: str
    rank: int
    size: int


def equations_page(model: DerivedModel) -> str:
    """The text of equations.md."""
    machine = model.machine
    latex = Latex(machine)
    array = lower_body_array(machine)
    workpiece, tool = chains(machine)
    main = first_order(view(machine, "tool_in_workpiece"), symbols.point())
    references = dict(machine.references)
    found = model.identification
    return (
        environment()
        .get_template("equations.md.j2")
        .render(
            spec=spec_name(machine),
            digest=machine.digest,
            abi=ABI,
            title=machine.title,
            bodies=[array[0], *array[1:]],
            body_rows=[
                (
                    b.number,
                    b.name,
                    b.lower,
                    b.moves or "-",
                    " ".join(b.motion_errors) or "-",
                    ", ".join(f"{d} = {p}" for d, p in b.position_errors) or "-",
                )
                for b in machine.bodies
            ],
            symbols=[
                (f"${t.latex}$", f"`{name}`", t.unit, t.description) for name, t in symbols.describe(machine).items()
            ],
            joints=[_joint(part, latex) for part in _distinct(workpiece + tool)],
            branches=[("[SBW]", "(2)", _branch(workpiece)), ("[SBT]", "(3)", _branch(tool))],
            position=[(f"P^W_{{T{row}}}", latex.entry(main.ideal[i], main.columns, i)) for i, row in enumerate(_ROWS)],
            sensitivities=[
                (f"`{name}`", *(f"${latex(entry)}$" for entry in column)) for name, column in main.columns.items()
            ],
            motions=[_motion(equation, latex, references) for equation in model.motions],
            systems=[_system(k, s, latex, references) for k, s in enumerate(found.systems)] if found else [],
            undetermined=[combination_text(machine, c) for c in found.combinations] if found else [],
            unseen=", ".join((*found.unseen, *found.unreached)) if found else "",
            squareness=[("".join(s.axes), latex(s.product)) for s in model.squareness],
            squareness_reference=references.get("squareness", ""),
            correction=[(latex.symbol(target.name), latex(value)) for target, value in _body(model, "correction")],
            effects=effect_texts(machine),
            effect_symbols=effect_symbols(machine),
        )
    )


def _distinct(joints: tuple[Joint, ...]) -> list[Joint]:
    return list({part.body.number: part for part in joints}.values())


def _name(joint: Joint) -> str:
    return f"[S{joint.body.lower}{joint.body.number}]"


def _branch(joints: tuple[Joint, ...]) -> str:
    return r"\,".join(f"{_name(part)}_{{{index}}}" for part in joints for index in ("p", "pe", "s", "se"))


def _joint(part: Joint, latex: Latex) -> JointText:
    names = ("p", "pe", "s", "se")
    texts = [
        (f"{_name(part)}_{{{n}}}", None if (m := matrix(s)) == sp.eye(4) else latex(m))
        for n, s in zip(names, part.steps, strict=True)
    ]
    return JointText(f"Body {part.body.number}, {part.body.name}, on body {part.body.lower}", _name(part), tuple(texts))


def _motion(equation: MotionEquation, latex: Latex, references: dict[str, str]) -> EquationText:
    what = " minus ".join(f"{seen} point" for _, seen, _ in equation.terms)
    name = motion_name(equation.moves)
    motion = equation.motion
    lines = tuple((f"\\Delta {row}", latex.entry(motion.ideal[i], motion.columns, i)) for i, row in enumerate(_ROWS))
    return EquationText(f"{' and '.join(equation.moves)}: {what}", references.get(name, ""), lines)


def _system(index: int, system: IdentificationSystem, latex: Latex, references: dict[str, str]) -> SystemText:
    readings = [sp.Symbol(f"L{k + 1}", real=True) for k in range(len(system.runs))]
    unknowns = sp.Matrix([symbols.named(name) for name in system.unknowns])
    return SystemText(
        f"{index + 1}. {', '.join(system.unknowns)} ({' and '.join(''.join(m) for m in system.moves)})",
        references.get(system_name(index), ""),
        tuple((latex(reading), run) for reading, run in zip(readings, system.runs, strict=True)),
        tuple(
            (f"({', '.join(latex(s) for s in triple)})", on, f"({', '.join(f'{c:g}' for c in at)})")
            for triple, on, at in system.points
        ),
        latex(unknowns),
        latex(system.matrix),
        tuple(_right(latex, reading, known) for reading, known in zip(readings, system.known, strict=True)),
        tuple(_solution(system, readings, latex)),
        latex(system.determinant) if system.determinant is not None else "",
        system.rank,
        len(system.unknowns),
    )


def _right(latex: Latex, reading: sp.Symbol, known: sp.Expr) -> str:
    return " ".join([latex(reading), *_terms(latex, -known)])


def _terms(latex: Latex, value: sp.Expr) -> list[str]:
    texts = [latex(term) for term in sp.Add.make_args(value) if term != 0]
    return [text if text.startswith("-") else f"+ {text}" for text in texts]


def _solution(system: IdentificationSystem, readings: list[sp.Symbol], latex: Latex) -> Iterator[tuple[str, str]]:
    """Each unknown from the reduced readings b_k = L_k minus what is known."""
    if system.inverse is None or system.determinant is None:
        return
    reduced = sp.Matrix([sp.Symbol(f"b_{{{k + 1}}}") for k in range(len(readings))])
    adjugate = system.matrix.adjugate() * reduced
    for name, row in zip(system.unknowns, adjugate, strict=True):
        if system.determinant in (1, -1):
            yield latex.symbol(name), latex(sp.expand(row / system.determinant))
        else:
            yield f"D\\,{latex.symbol(name)}", broken(_collected(latex, row, reduced), 1 if len(readings) > 2 else 3)


def _collected(latex: Latex, value: sp.Expr, reduced: sp.Matrix) -> list[str]:
    expanded = sp.expand(value)
    terms: list[str] = []
    for symbol in reduced:
        coefficient = expanded.coeff(symbol)
        if coefficient == 0:
            continue
        text = latex(coefficient)
        factor = rf"\left({text}\right)" if coefficient.is_Add else {"1": "", "-1": "-"}.get(text, text)
        terms.append(f"{factor}{symbol.name}" if factor.startswith("-") else f"+ {factor}{symbol.name}")
    return terms


def _body(model: DerivedModel, name: str) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    return next((routine.body for routine in model.routines if routine.name == name), ())
