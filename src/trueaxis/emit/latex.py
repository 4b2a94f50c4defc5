"""Expressions as LaTeX that GitHub renders, with the paper's symbols."""

import re
from collections.abc import Mapping, Sequence

import sympy as sp

from trueaxis.derive.chain import Vector
from trueaxis.derive.symbols import describe
from trueaxis.spec.machine import Machine

_POINT = re.compile(r"r([TWB])(\d*)([xyz])")
_READING = re.compile(r"L(\d+)")


class Latex:
    """Prints the expressions of one machine."""

    def __init__(self, machine: Machine) -> None:
        self._names = {name: text.latex for name, text in describe(machine).items()}

    def symbol(self, name: str) -> str:
        """The LaTeX of a symbol by its name."""
        if point := _POINT.fullmatch(name):
            return f"r_{{{point[1]}{point[2]}{point[3]}}}"
        if reading := _READING.fullmatch(name):
            return f"L_{{{reading[1]}}}"
        return self._names.get(name, name)

    def __call__(self, value: sp.Expr | sp.Matrix) -> str:
        """The LaTeX of an expression or a matrix."""
        names = {symbol: self.symbol(symbol.name) for symbol in value.free_symbols}
        # Fifteen digits are what a decimal number of the spec comes back as: 92.3, not 92.300000000000001.
        rounded = value.xreplace({number: sp.Float(number, 15) for number in value.atoms(sp.Float)})
        return str(sp.latex(rounded, symbol_names=names, mat_str="bmatrix", mat_delim=""))

    def linear(self, columns: Mapping[str, sp.Expr]) -> list[str]:
        """The terms of a linear form, each with its sign: coefficient times error symbol."""
        terms: list[str] = []
        for name, coefficient in columns.items():
            sign, size = ("-", -coefficient) if _negative(coefficient) else ("+", coefficient)
            factor = "" if size == 1 else self._factor(size)
            terms.append(f"{sign} {factor}{self.symbol(name)}")
        return terms

    def _factor(self, value: sp.Expr) -> str:
        text = self(value)
        return rf"\left({text}\right) " if value.is_Add else f"{text} \\, "

    def entry(self, ideal: sp.Expr, columns: Mapping[str, Vector], row: int) -> str:
        """One entry of ideal + sum of columns times errors, broken into lines of an `aligned` block."""
        terms = self.linear({name: column[row] for name, column in columns.items() if column[row] != 0})
        head = "" if ideal == 0 else self(ideal)
        return broken([head, *terms] if head else terms)


def broken(terms: Sequence[str], width: int = 5) -> str:
    """Terms in lines of `width`, for the right of `&=` in an `aligned` block."""
    if not terms:
        return "0"
    first = terms[0].removeprefix("+ ")
    lines = [[first, *terms[1:width]]] + [list(terms[k : k + width]) for k in range(width, len(terms), width)]
    return " \\\\\n&\\quad ".join(" ".join(line) for line in lines)


def _negative(value: sp.Expr) -> bool:
    if value.is_Add:
        return all(_negative(term) for term in value.args)
    return bool(value.could_extract_minus_sign())
