"""The section of equations.md on the effects of a machine: each as an equation, bound to its axes."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.effect_terms import term
from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.latex import component_latex
from trueaxis.effects.placement import OF_AXIS, OF_OTHER_AXIS, VARIABLES, Variable, context_of
from trueaxis.machine.machine import ROTARY, Machine

_INSTRUMENTS = {"laser": "the laser", "probe": "the probe", "ballbar": "the ball bar"}


@dataclass(frozen=True, kw_only=True)
class EffectText:
    """One effect: its heading, its cause, where it acts, its equation (empty where it has none of its own)."""

    title: str
    cause: str
    where: str
    left: str
    right: str


@dataclass(frozen=True)
class SymbolRow:
    """One row of the table of symbols."""

    latex: str
    name: str
    unit: str
    meaning: str


def effect_texts(machine: Machine) -> list[EffectText]:
    """The effects in the order of the spec; parameters carry the number of their effect as index."""
    return [_text(machine, effect, number) for number, effect in enumerate(machine.effects, 1)]


def effect_symbols(machine: Machine) -> list[SymbolRow]:
    """Every symbol of the effects' equations that the rest of the page does not tell."""
    rows: dict[str, SymbolRow] = {}
    for number, effect in enumerate(machine.effects, 1):
        kind = machine.kinds[effect.kind]
        if kind.place == "location":
            continue
        for parameter in kind.parameters:
            latex = _indexed(parameter.name, number)
            unit = _unit(parameter.unit, effect, effect.own_axis)
            rows[latex] = SymbolRow(latex, f"`{parameter.name}`", unit, f"effect {number}: {parameter.meaning}")
        for variable in (VARIABLES[name] for name in _used(kind) if name not in ("q", "q_b")):
            axis = _axis(variable, effect)
            latex = _bound(variable, effect)
            meaning = (f"{axis}: " if axis else "") + variable.meaning.removesuffix(" (the other axis)")
            rows.setdefault(latex, SymbolRow(latex, "-", _unit(variable.unit, None, axis), meaning))
    return list(rows.values())


def _text(machine: Machine, effect: Effect, number: int) -> EffectText:
    kind = machine.kinds[effect.kind]
    left, right = _equation(kind, effect, number)
    return EffectText(
        title=_escaped(f"{number}. {effect.label}"),
        cause=_escaped(kind.sentence),
        where=_where(kind, effect),
        left=left,
        right=right,
    )


def _where(kind: Kind, effect: Effect) -> str:
    if kind.place == "component":
        return ""
    if kind.place == "location":
        return "A position error like those that the spec gives its bodies: it is in all equations above."
    runs = f"the runs {_escaped(', '.join(effect.runs))}" if effect.runs else "all runs"
    instruments = " or ".join(_INSTRUMENTS[one] for one in kind.instruments) or "any instrument"
    what = "In the readings" if kind.place == "reading" else "In the set-up"
    return f"{what} of {runs} of {instruments}."


def _equation(kind: Kind, effect: Effect, number: int) -> tuple[str, str]:
    if kind.place == "location":
        return "", ""
    if kind.place == "point":
        point = rf"P_{{\mathrm{{{effect.end or 'ball'}}}}}"
        vector = ", ".join(_indexed(parameter.name, number) for parameter in kind.parameters)
        return point, rf"{point} + ({vector})^T"
    value = term(kind)
    names = {symbols.named(parameter.name): _indexed(parameter.name, number) for parameter in kind.parameters}
    names |= {symbols.named(name): _bound(VARIABLES[name], effect) for name in _used(kind)}
    text = _latex(value, names)
    left = "L" if effect.component is None else component_latex(effect.error)
    return left, f"{left} {text}" if text.startswith("-") else f"{left} + {text}"


def _latex(value: sp.Expr, names: Mapping[sp.Symbol, str]) -> str:
    rounded = value.xreplace({number: sp.Float(number, 15) for number in value.atoms(sp.Float)})
    return str(sp.latex(rounded, symbol_names=dict(names)))


def _used(kind: Kind) -> Iterator[str]:
    free = {symbol.name for symbol in term(kind).free_symbols} if kind.expression else set()
    yield from (name for name in context_of(kind) if name in free)


def _axis(variable: Variable, effect: Effect) -> str:
    if variable in OF_AXIS:
        return effect.own_axis
    return (effect.axis or "") if variable in OF_OTHER_AXIS else ""


def _bound(variable: Variable, effect: Effect) -> str:
    axis = _axis(variable, effect).lower()
    if not axis:
        return variable.latex
    letter = variable.latex.removesuffix("_b")
    return axis if letter == "q" else f"{letter}_{{{axis}}}"


def _indexed(parameter: str, number: int) -> str:
    text = symbols.parameter_latex(parameter)
    return f"{text[:-1]},{number}}}" if "_{" in text else f"{text}_{{{number}}}"


def _unit(unit: str, effect: Effect | None, axis: str) -> str:
    names = {"u": effect.error.unit if effect and effect.component else "mm", "axis": "deg" if axis in ROTARY else "mm"}
    return re.sub(r"\b(u|axis)\b", lambda found: names[found[0]], unit)


def _escaped(text: str) -> str:
    """Text that Markdown and maths leave alone, whatever the ids of runs are."""
    return re.sub(r"[^\w .,:;()+-]", lambda found: f"&#{ord(found[0])};", text).replace("_", r"\_")
