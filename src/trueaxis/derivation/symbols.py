"""The symbols of a machine's equations: names as in its files, LaTeX as in the paper."""

from dataclasses import dataclass
from functools import cache

import sympy as sp

from trueaxis.effects.latex import component_latex
from trueaxis.machine.error_words import component_words, location_words
from trueaxis.machine.machine import ROTARY, Machine


@dataclass(frozen=True)
class SymbolText:
    """What a reader must know of a symbol: LaTeX, unit, a sentence."""

    latex: str
    unit: str
    description: str


@cache
def position(axis: str) -> sp.Symbol:
    """Commanded position of an axis: x, y, z (mm), a, b, c (deg)."""
    return sp.Symbol(axis.lower(), real=True)


@cache
def cosine(axis: str) -> sp.Symbol:
    """Cosine of the rotation of a rotary body, computed once per point before anything else."""
    return sp.Symbol(f"cos_{axis.lower()}", real=True)


@cache
def sine(axis: str) -> sp.Symbol:
    """Sine of the rotation of a rotary body."""
    return sp.Symbol(f"sin_{axis.lower()}", real=True)


@cache
def named(name: str) -> sp.Symbol:
    """The symbol of a component error or a parameter: its name in the files."""
    return sp.Symbol(name, real=True)


def point(prefix: str = "r") -> tuple[sp.Symbol, sp.Symbol, sp.Symbol]:
    """Coordinates of a point in the frame of its body, mm."""
    x, y, z = (named(prefix + axis) for axis in "xyz")
    return x, y, z


def describe(machine: Machine) -> dict[str, SymbolText]:
    """Every symbol of a machine's equations by name, in the order positions, components, parameters, point."""
    table: dict[str, SymbolText] = {}
    for axis in machine.axes:
        unit = "deg" if axis in ROTARY else "mm"
        table[axis.lower()] = SymbolText(
            axis.lower(), unit, f"commanded position of {axis} ({machine.mover(axis).name})"
        )
    for axis in machine.axes:
        if axis in ROTARY:
            letter = axis.lower()
            table[f"cos_{letter}"] = SymbolText(rf"\cos({letter})", "1", f"cosine of the rotation about {axis}")
            table[f"sin_{letter}"] = SymbolText(rf"\sin({letter})", "1", f"sine of the rotation about {axis}")
    for component in machine.components:
        table[component] = SymbolText(component_latex(component), component.unit, component_words(component))
    for name in machine.dimensions:
        text = f"home position along {_along(machine, name)}, {_where(machine, name)}"
        table[name] = SymbolText(parameter_latex(name), "mm", text)
    for name in machine.location_errors:
        text = f"location error: {location_words(machine, name)}"
        table[name] = SymbolText(parameter_latex(name), machine.parameter_unit(name), text)
    for letter, symbol in zip("xyz", point(), strict=True):
        table[symbol.name] = SymbolText(
            f"r_{{{letter}}}", "mm", f"{letter} coordinate of the point in its body's frame"
        )
    return table


def parameter_latex(name: str) -> str:
    r"""`eps_xy` becomes \varepsilon_{xy}, `q_Tx` q_{Tx}; other names are set upright."""
    head, _, tail = name.partition("_")
    heads = {"eps": r"\varepsilon", "delta": r"\delta", "alpha": r"\alpha", "beta": r"\beta", "gamma": r"\gamma"}
    if tail and (head in heads or len(head) == 1):
        return f"{heads.get(head, head)}_{{{tail.replace('_', ',')}}}"
    return rf"\mathrm{{{name.replace('_', chr(92) + '_')}}}"


def _along(machine: Machine, dimension: str) -> str:
    return next("XYZ"[body.position.index(dimension)] for body in machine.bodies if dimension in body.position)


def _where(machine: Machine, name: str) -> str:
    for body in machine.bodies:
        if name in body.position:
            return f"body {body.number} ({body.name}) on body {body.lower}"
    raise KeyError(name)
