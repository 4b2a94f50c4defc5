"""The page on the kinds of effects, written from the library: python -m trueaxis.effects.page > docs/effects.md."""

import sys
from collections.abc import Iterable, Sequence

from trueaxis.effects.expression import DEEPEST, FUNCTIONS, HIGHEST_DEGREE, LARGEST_EXPONENT, LONGEST
from trueaxis.effects.kind import Kind
from trueaxis.effects.library import KINDS
from trueaxis.effects.placement import OF_COMPONENT_TERMS, OF_READING_TERMS, VARIABLES, Variable

_PLACES = {
    "component": "Terms of component errors",
    "reading": "Terms of readings",
    "point": "Points of the set-up",
    "location": "Location errors",
}


INSTRUMENTS = {"laser": "laser", "probe": "probe", "ballbar": "ball bar"}
_ENTERS = {"linear": "linear", "phase": "phase", "root": "its square", "grid": "otherwise, searched on a grid"}

_INTRODUCTION = """
Effects are causes of deviations beside the geometric errors: in the machine, in the instruments, in the set-up. A
machine spec names the effects that the machine has ([machine.md](machine.md#effects)). `trueaxis diagnose` searches
measured data for all kinds of this page and the spec's own kinds. The zero and the slope of runs are part of every
set-up: it estimates them, and names one only where it is far larger than usual. A term is written once, in the
variables below. Its contribution to a reading follows from the derivation: the sensitivity of the reading to the
component error, times the term.

Units: `u` is that of the component error (mm or rad), `axis` that of its axis (mm or deg).
"""
_LOCATION = """
Its value is one of the `parameters` of the error values, under the name of the effect's component: `EC0X`.
"""
_VARIABLES = """
A term of a component error uses the variables of its axis, time and temperature; if the kind has another axis, also
those of that axis, with `_b`. A term of readings uses `along`, `theta`, `along_line`, time and temperature.
"""
_EXPRESSIONS = f"""
Numbers, names, `+ - * / ^`, parentheses, `pi` and the functions {" ".join(f"`{name}`" for name in FUNCTIONS)}.
`step(x)` is 1 for x >= 0 and 0 below, `sign(0)` is 0. A minus sign binds less than `^`: `-s^2` is `-(s^2)`. An exponent
is a whole number from 1 to {LARGEST_EXPONENT}; nested powers, as in `((q^3)^2)^2`, multiply to at most
{HIGHEST_DEGREE}. An expression has at most {LONGEST} characters, and {DEEPEST} levels of
parentheses, functions and minus signs.
"""


def page() -> str:
    """The text of docs/effects.md."""
    parts = ["<!-- Written by: python -m trueaxis.effects.page > docs/effects.md -->", "# Effects", _INTRODUCTION]
    for place, title in _PLACES.items():
        kinds = [kind for kind in KINDS if kind.place == place]
        parts += [f"## {title}", _kinds_table(kinds), _LOCATION if place == "location" else _parameters_table(kinds)]
    parts += ["## Variables", _VARIABLES, _variables_table(VARIABLES.values()), "## Expressions", _EXPRESSIONS]
    return "\n\n".join(part.strip("\n") for part in parts) + "\n"


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _kinds_table(kinds: Iterable[Kind]) -> str:
    rows = [
        (
            f"`{kind.name}`",
            f"`{kind.expression}`" if kind.expression else "-",
            _acts_on(kind),
            kind.sentence,
            kind.confused_with or "-",
            kind.broken_by or "-",
        )
        for kind in kinds
    ]
    return _table(("kind", "term", "acts on", "cause", "taken for", "told apart by"), rows)


def _acts_on(kind: Kind) -> str:
    if kind.place in ("reading", "point"):
        name = ", ".join(INSTRUMENTS[one] for one in kind.instruments) or "all instruments"
        return f"{name}; runs that it names" if kind.by_run else name
    words = ", ".join(kind.directions + kind.components)
    return f"{words}; names another axis" if kind.other_axis else words


def _parameters_table(kinds: Iterable[Kind]) -> str:
    rows = [
        (f"`{kind.name}`", f"`{one.name}`", one.unit, one.meaning, _ENTERS[one.role])
        for kind in kinds
        for one in kind.parameters
    ]
    return _table(("kind", "parameter", "unit", "meaning", "enters"), rows)


def _variables_table(variables: Iterable[Variable]) -> str:
    rows = [(f"`{one.name}`", one.unit, one.meaning, _where(one)) for one in variables]
    return _table(("variable", "unit", "meaning", "in terms of"), rows)


def _where(variable: Variable) -> str:
    places = {"components": OF_COMPONENT_TERMS, "readings": OF_READING_TERMS}
    return ", ".join(name for name, among in places.items() if variable in among)


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8", newline="\n")  # type: ignore[union-attr]  # a stream of text, always
    sys.stdout.write(page())
