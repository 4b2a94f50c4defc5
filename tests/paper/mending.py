"""How a printed part is mended: small changes to its right-hand side, one per erratum."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from enum import StrEnum

import sympy as sp

from .notation import DIRECTIONS, Formula, r

Change = Callable[[Formula], Formula]


class Kind(StrEnum):
    """What sort of disagreement an erratum is."""

    RECOGNITION = "recognition slip"
    MISPRINT = "misprint"
    SIGN = "wrong sign"
    FORMULA = "wrong formula"
    CONFLICT = "conflict within the paper"


@dataclass(frozen=True, slots=True)
class Mend:
    """One changed part: a formula by `change`, an entry by what must stand there."""

    source: int | str
    label: str
    change: Change | None = None
    instead: object = None


@dataclass(frozen=True, slots=True)
class Erratum:
    """One settled disagreement; those without mends concern a method or data and are shown by the named test."""

    number: int
    where: str
    kind: Kind
    line: str
    mends: tuple[Mend, ...] = ()
    shown_by: str = ""


def on_right(function: Callable[[sp.Expr], sp.Expr]) -> Change:
    """A change of the right-hand side."""
    return lambda formula: replace(formula, rhs=function(formula.rhs))


def on_left(function: Callable[[sp.Expr], sp.Expr]) -> Change:
    """A change of the left-hand side."""
    return lambda formula: replace(formula, lhs=function(formula.lhs))


def rename(names: Mapping[sp.Expr, sp.Expr]) -> Change:
    """Symbols read as others on both sides."""

    def change(formula: Formula) -> Formula:
        lhs, rhs = (side.xreplace(dict(names)) for side in (formula.lhs, formula.rhs))
        return replace(formula, lhs=lhs, rhs=rhs)

    return change


def add(term: sp.Expr) -> Change:
    """What is missing on the right-hand side."""
    return on_right(lambda rhs: rhs + term)


def times(factor: sp.Expr) -> Change:
    """A factor of the right-hand side."""
    return on_right(lambda rhs: rhs * factor)


def coordinates(names: Mapping[str, str]) -> dict[sp.Expr, sp.Expr]:
    """r_a -> r_b for all three coordinates."""
    return {r(a, d): r(b, d) for a, b in names.items() for d in DIRECTIONS}
