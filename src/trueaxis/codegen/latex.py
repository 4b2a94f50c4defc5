"""Expressions as LaTeX that GitHub renders, with the paper's symbols, and rows of equations that fit the page."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from copy import copy

import sympy as sp

from trueaxis.derivation.expressions import is_negative as has_minus
from trueaxis.derivation.expressions import opposite
from trueaxis.derivation.products import multiplied_out
from trueaxis.derivation.symbols import describe
from trueaxis.machine.machine import Machine

_POINT = re.compile(r"r([TWB])(\d*)([xyz])")
_READING = re.compile(r"L(\d+)")
_ROTARY = re.compile(r"(?:cos|sin)_[abc]")
# GitHub's page is 840 px wide. MathJax fits its letters to those of the text: measured in a browser, an em of maths is
# 19.1 px beside Arial, 20.4 px beside DejaVu Sans, the widest that GitHub's list of fonts falls back to.
WIDEST = 41.0
_SCRIPTS = r"(?:[_^](?:\{[^{}]*\}|[^{}]))+"
_TOKEN = re.compile(rf"{_SCRIPTS}|\\[a-zA-Z]+|\\.|\{{|\}}|.", re.DOTALL)
_FRACTION = "\\frac"

_WIDTHS = {
    **dict.fromkeys(("+", "-", "=", r"\times", r"\le", r"\leftarrow"), 1.3),
    **dict.fromkeys(("(", ")", "[", "]", r"\left", r"\right", ",", "|", "."), 0.4),
    **dict.fromkeys((r"\cos", r"\sin"), 1.6),
    **dict.fromkeys((r"\Delta", r"\Theta"), 0.85),
    **dict.fromkeys((" ", "&", "\n", "{", "}", r"\mathrm", r"\frac", r"\bigl", r"\bigr"), 0.0),
    r"\,": 0.2,
    r"\quad": 1.0,
    r"\qquad": 2.0,
    r"\sum": 1.5,
    r"\pi": 0.6,
}
_LETTER = 0.58
_SCRIPT = 0.42  # a letter of an index
_CELL = 1.0  # between two columns of a matrix


class Latex:
    """Prints the expressions of one machine; `names` goes before what the machine's symbols are called."""

    def __init__(self, machine: Machine, names: Mapping[str, str] | None = None) -> None:
        self._names = {name: text.latex for name, text in describe(machine).items()} | dict(names or {})
        self._ranks = dict.fromkeys(machine.components, 2) | dict.fromkeys(machine.location_errors, 3)

    def with_names(self, names: Mapping[str, str]) -> "Latex":
        """The same printer with further names of symbols."""
        other = copy(self)
        other._names = self._names | dict(names)
        return other

    def symbol(self, name: str) -> str:
        """The LaTeX of a symbol by its name."""
        if name in self._names:
            return self._names[name]
        if point := _POINT.fullmatch(name):
            return f"r_{{{point[1]}{point[2]}{point[3]}}}"
        if reading := _READING.fullmatch(name):
            return f"L_{{{reading[1]}}}"
        return name

    def __call__(self, value: sp.Expr | sp.Matrix) -> str:
        """The LaTeX of an expression or a matrix."""
        if isinstance(value, sp.MatrixBase):
            rows = (" & ".join(joined(self.terms(cell)) for cell in value.row(k)) for k in range(value.rows))
            return r"\begin{bmatrix}" + r"\\".join(rows) + r"\end{bmatrix}"
        if value.is_Symbol:
            return self.symbol(value.name)
        if value.is_Mul and all(factor.is_Symbol or factor.is_Integer for factor in value.args):
            return self._product(value)
        ranked = {symbol: sp.Symbol(f"{self._rank(symbol.name)}{symbol.name}") for symbol in value.free_symbols}
        names = {ranked[symbol]: self.symbol(symbol.name) for symbol in ranked}
        # Fifteen digits are what a decimal number of the spec comes back as: 92.3, not 92.300000000000001.
        rounded = {number: sp.Float(number, 15) for number in value.atoms(sp.Float)}
        return str(sp.latex(value.xreplace(rounded | ranked), symbol_names=names))

    def _product(self, value: sp.Mul) -> str:
        """A product of symbols and a whole number, as SymPy prints it."""
        number, rest = value.as_coeff_Mul()
        names = sorted((factor.name for factor in sp.Mul.make_args(rest)), key=lambda name: f"{self._rank(name)}{name}")
        size = [] if abs(number) == 1 else [str(abs(number))]
        return ("- " if number < 0 else "") + " ".join([*size, *map(self.symbol, names)])

    def _rank(self, name: str) -> int:
        """Order of the factors of a product: cosines and sines, lengths, motion errors, location errors."""
        return 0 if _ROTARY.fullmatch(name) else self._ranks.get(name, 1)

    def terms(self, value: sp.Expr) -> list[str]:
        """The terms of a sum, each with its sign; a constant term or a positive one leads.

        Lengths that a point adds up, under one cosine or sine, are one term: cos(b) (q_S + q_T + r_T).
        """
        parts = sorted(self._parts(value), key=lambda part: part[0]) if value != 0 else []
        return [f"{'-' if negative else '+'} {text}" for negative, text in parts]

    def _parts(self, value: sp.Expr, *, factors: bool = False) -> Iterator[tuple[bool, str]]:
        """The terms of a sum: whether negative, and without its sign.

        factors: a factor follows each; the lengths that nothing turns are one term then, too.
        """
        groups: dict[sp.Expr, list[sp.Expr]] = {}
        for term in sp.Add.make_args(multiplied_out(value)):
            groups.setdefault(self._turned_by(term), []).append(term)
        for turn, terms in groups.items():
            if len(terms) == 1 or (turn == 1 and not (factors and len(groups) > 1)):
                yield from ((is_negative(term), self(opposite(term) if is_negative(term) else term)) for term in terms)
                continue
            lengths = sp.Add(*terms) if turn == 1 else sp.Add(*(term / turn for term in terms))
            negative = is_negative(lengths)
            inner = rf"\left({joined(self.terms(-lengths if negative else lengths))}\right)"
            yield negative, inner if turn == 1 else f"{self(turn)} {inner}"

    def _turned_by(self, term: sp.Expr) -> sp.Expr:
        """The cosines and sines of a length without error; 1 where there are none, and for a term with an error."""
        if any(symbol.name in self._ranks for symbol in term.free_symbols):
            return sp.S.One
        return sp.Mul(*(f for f in sp.Mul.make_args(term) if any(_ROTARY.fullmatch(s.name) for s in f.free_symbols)))

    def linear(self, columns: Mapping[str, sp.Expr]) -> list[str]:
        """The terms of a linear form, each with its sign: errors of one coefficient stand in one bracket behind it."""
        groups: dict[sp.Expr, list[tuple[str, str]]] = {}
        for name, coefficient in columns.items():
            if coefficient != 0:
                sign, size = ("-", opposite(coefficient)) if is_negative(coefficient) else ("+", coefficient)
                groups.setdefault(size, []).append((sign, name))
        return [term for size, members in groups.items() for term in self._group(size, members)]

    def _group(self, size: sp.Expr, members: list[tuple[str, str]]) -> Iterator[str]:
        if size == 1:
            yield from (f"{sign} {self.symbol(name)}" for sign, name in members)
            return
        lead = members[0][0]
        inner = joined(f"{'+' if sign == lead else '-'} {self.symbol(name)}" for sign, name in members)
        errors = inner if len(members) == 1 else rf"\left({inner}\right)"
        term = f"{lead} {self._factor(size)}{errors}"
        if width(term) <= 0.88 * WIDEST or not size.is_Add:
            yield term
            return
        # Too wide for one row: multiplied out, which is what the bracket means.
        for negative, part in self._parts(size, factors=True):
            yield f"{'-' if negative != (lead == '-') else '+'} {_before_factor(part)}{errors}"

    def _factor(self, value: sp.Expr) -> str:
        terms = self.terms(value)
        return rf"\left({joined(terms)}\right) " if len(terms) > 1 else _before_factor(joined(terms))


def _before_factor(text: str) -> str:
    """A factor and the space behind it: a bracket needs none."""
    return f"{text} " if text.endswith(r"\right)") else f"{text} \\, "


def is_negative(value: sp.Expr) -> bool:
    """Whether a coefficient is printed with a minus in front: all its terms have one."""
    if value.is_Add:
        return all(is_negative(term) for term in value.args)
    return has_minus(value)


def joined(terms: Iterable[str]) -> str:
    """Terms in one row."""
    return " ".join(terms).removeprefix("+ ") or "0"


def width(maths: str) -> float:
    """Estimated width of one row of maths, em."""
    total = 0.0
    while (start := maths.find(_FRACTION)) >= 0:
        above, middle = _argument(maths, start + len(_FRACTION))
        below, end = _argument(maths, middle)
        total += max(width(above), width(below))
        maths = maths[:start] + maths[end:]
    for token in _TOKEN.findall(maths):
        if token[0] in "_^" and len(token) > 1:
            total += max(_SCRIPT * _letters(part) for part in re.split(r"[_^]", token))
        else:
            total += _WIDTHS.get(token, _LETTER)
    return total


def _argument(maths: str, start: int) -> tuple[str, int]:
    """The argument in braces that begins at `start`, and where it ends."""
    depth = 0
    for at in range(start, len(maths)):
        depth += {"{": 1, "}": -1}.get(maths[at], 0)
        if depth == 0:
            return maths[start + 1 : at], at + 1
    raise ValueError(f"braces are not closed: {maths}")


def _letters(script: str) -> int:
    return len(re.sub(r"\\[a-zA-Z]+", "a", script).strip("{}"))


def block_width(maths: str) -> float:
    """Estimated width of a block, em: its widest row, or of a matrix its columns together."""
    flat = re.sub(r"\\(?:begin|end)\{aligned\}", "", maths)
    while found := re.search(r"\\begin\{bmatrix\}((?:(?!\\begin\{bmatrix\}).)*?)\\end\{bmatrix\}", flat, re.DOTALL):
        columns = zip(*(row.split("&") for row in found[1].split(r"\\")), strict=True)
        wide = sum(max(map(width, column)) + _CELL for column in columns)
        flat = flat[: found.start()] + "m" * round(wide / _LETTER + 0.5) + flat[found.end() :]
    return max(width(row) for row in flat.split(r"\\"))


def broken(left: str, terms: Sequence[str]) -> str:
    """`left &= terms` in as many rows of an `aligned` block as their width asks for; each term bears its sign."""
    lines: list[list[str]] = [[terms[0].removeprefix("+ ") if terms else "0"]]
    indent = width(left) + 1.3
    used = indent + width(lines[0][0])
    for term in terms[1:]:
        if used + width(term) > WIDEST:
            lines.append([])
            used = indent + 1.0
        lines[-1].append(term)
        used += width(term)
    return f"{left} &= " + " \\\\\n&\\quad ".join(" ".join(line) for line in lines)
