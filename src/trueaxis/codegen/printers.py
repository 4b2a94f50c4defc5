"""Expressions as code, NumPy and C: every digit of a constant, powers as products, no call but those that kernels need.

Terms, factors, signs and brackets stand as SymPy's printers put them. Polynomials in Horner's form, as the derivation
leaves them, are found again; variables are named as the symbols are.
"""

from collections.abc import Collection, Mapping, Sequence
from typing import ClassVar

import sympy as sp
from sympy.printing.precedence import PRECEDENCE, precedence

from trueaxis.derivation.effect_terms import Absolute, Root, Sign, Step
from trueaxis.derivation.expressions import is_negative, opposite, ordered_factors, ordered_terms
from trueaxis.derivation.routine import Argument, Routine

Polynomial = tuple[sp.Symbol, tuple[sp.Expr, ...]]
_SIGN = (PRECEDENCE["Mul"] + PRECEDENCE["Pow"]) / 2  # how strongly a sign holds the one factor behind it
_HALF = sp.Rational(1, 2)


class _Printer:
    """What NumPy and C have in common; _functions: how a call of each is written."""

    _functions: ClassVar[Mapping[type[sp.Expr], str]]

    def __init__(self, names: Mapping[str, str]) -> None:
        self._names = names

    def doprint(self, value: sp.Expr) -> str:
        """The code of an expression. Raises ValueError for what no kernel needs."""
        if value.is_Symbol:
            return self._names.get(value.name, value.name)
        if value.is_Add:
            first, *others = map(self.doprint, ordered_terms(value))
            return first + "".join(f" - {text[1:]}" if text[0] == "-" else f" + {text}" for text in others)
        if value.is_Mul:
            return self._product(value)
        if value.func in self._functions:
            return self._functions[value.func].format(self.doprint(value.args[0]))
        if value.is_Pow and (value.exp.is_Integer or abs(value.exp) == _HALF):
            return self._power(value)
        if value.is_Number or value is sp.pi:
            return self._number(value)
        raise ValueError(f"no kernel needs {value}")

    def _product(self, value: sp.Expr) -> str:
        minus = is_negative(value)
        return self._signed(minus, ordered_factors(opposite(value) if minus else value))

    def _signed(self, minus: bool, factors: Sequence[sp.Expr]) -> str:
        """The product of factors, behind a minus sign or not; those of a negative power are divided by."""
        level = PRECEDENCE["Add" if minus else "Mul"]
        below = [one for one in factors if one.is_Pow and one.exp.is_Rational and one.exp.is_negative]
        above = [one for one in factors if one not in below] or [sp.S.One]
        over = "*".join(self._bracketed(one, _SIGN if minus and len(above) == 1 else level) for one in above)
        under = [self._bracketed(one.base if one.exp == -1 else one.base**-one.exp, level) for one in below]
        quotient = "" if not under else f"/{under[0]}" if len(under) == 1 else f"/({'*'.join(under)})"
        return f"{'-' if minus else ''}{over}{quotient}"

    def _bracketed(self, value: sp.Expr, level: float) -> str:
        """The code of a factor, in brackets where it would be read otherwise."""
        text = self.doprint(value)
        return text if value.is_Symbol or precedence(value) > level else f"({text})"

    def _power(self, value: sp.Pow) -> str:
        raise NotImplementedError

    def _number(self, value: sp.Expr) -> str:
        raise NotImplementedError


class PythonPrinter(_Printer):
    """SymPy's own NumPy printer rounds constants to 15 digits and writes powers as calls."""

    _functions: ClassVar = {
        sp.cos: "np.cos({})",
        sp.sin: "np.sin({})",
        sp.exp: "np.exp({})",
        sp.tanh: "np.tanh({})",
        Absolute: "np.abs({})",
        Sign: "np.sign({})",
        Step: "np.heaviside({}, 1.0)",
        Root: "np.sqrt({})",
    }

    def code(self, value: sp.Expr) -> str:
        """The value as a Python expression; constants as doubles, polynomials as calls of `_polynomial`."""
        if value.is_Integer:
            return repr(float(value))
        if polynomial := horner_coefficients(value):
            at, coefficients = polynomial
            return f"_polynomial({', '.join(self.doprint(part) for part in (at, *coefficients))})"
        return self.doprint(value)

    def _power(self, value: sp.Pow) -> str:
        base = self._bracketed(value.base, PRECEDENCE["Func"])
        if not value.exp.is_Integer:
            root = f"np.sqrt({self.doprint(value.base)})"
            return root if value.exp > 0 else f"1.0/{root}"
        product = base if value.exp == -1 else "(" + "*".join([base] * abs(int(value.exp))) + ")"
        return product if value.exp > 0 else f"1.0/{product}"

    def _number(self, value: sp.Expr) -> str:
        return str(value) if value.is_Integer else repr(float(value))


class CPrinter(_Printer):
    """SymPy's own C printer writes x**2 as pow(x, 2), 1/2 as 1.0/2.0 and pi as a macro that ISO C does not have."""

    _functions: ClassVar = {
        sp.cos: "cos({})",
        sp.sin: "sin({})",
        sp.exp: "exp({})",
        sp.tanh: "tanh({})",
        Absolute: "fabs({})",
        Sign: "sign({})",
        Step: "step({})",
        Root: "sqrt({})",
    }

    def _product(self, value: sp.Expr) -> str:
        constants = [factor for factor in value.args if factor.is_number]
        if not constants or constants == [sp.S.NegativeOne]:
            return super()._product(value)
        number = sp.Mul(*constants)
        if number in (1, -1) or len(constants) == len(value.args):
            return super()._product(value)
        # One constant instead of several: pi*b/180 is one multiplication.
        number = sp.Float(number.evalf(30), 30)
        rest = sp.Mul(*(factor for factor in value.args if not factor.is_number))
        return (
            self._signed(True, [-number, *ordered_factors(rest)]) if number < 0 else self._signed(False, [number, rest])
        )

    def _power(self, value: sp.Pow) -> str:
        base = self.doprint(value.base)
        if not value.exp.is_Integer:
            return f"sqrt({base})" if value.exp > 0 else f"(1.0/sqrt({base}))"
        factor = base if value.base.is_Symbol else f"({base})"
        product = "*".join([factor] * abs(int(value.exp)))
        if value.exp > 1:
            return f"({product})"
        return f"(1.0/({product}))" if value.exp < -1 else f"(1.0/{product})"

    def _number(self, value: sp.Expr) -> str:
        return repr(float(value) if value.is_Integer else float(value.evalf(30)))


def horner_coefficients(value: sp.Expr) -> Polynomial | None:
    """(s, (c1, c2, ..)) of s*(c1 + s*(c2 + ..)); None where the value is something else or has one coefficient."""
    if not value.is_Mul or len(value.args) != 2:
        return None
    at, inner = value.args if value.args[0].is_Symbol else value.args[::-1]
    if not at.is_Symbol or not inner.is_Add:
        return None
    coefficients: list[sp.Expr] = []
    while leading := [term for term in sp.Add.make_args(inner) if at in term.free_symbols]:
        others = [factor for factor in sp.Mul.make_args(leading[0]) if factor is not at]
        if len(leading) > 1 or not inner.is_Add or len(others) == len(sp.Mul.make_args(leading[0])):
            return None
        coefficients.append(sp.Add(*(term for term in inner.args if term is not leading[0])))
        inner = sp.Mul(*others)
    return (at, (*coefficients, inner)) if coefficients else None


def variable_names(routine: Routine, taken: Collection[str]) -> Mapping[str, str]:
    """Every symbol's variable: its own name, with `_` added where that is an argument's name or one of `taken`."""
    kept = {*taken, *(a.name for a in routine.inputs + routine.outputs)}
    symbols = [row for a in routine.inputs + routine.outputs for row in a.rows]
    symbols += [target.name for stage in (routine.batch, routine.preparation, routine.body) for target, _ in stage]
    names: dict[str, str] = {}
    for symbol in symbols:
        name = symbol
        while name in kept or (name != symbol and name in symbols):
            name += "_"
        names[symbol] = name
    return names


def rows_text(argument: Argument) -> str:
    """The names of an argument's rows in their order, where they are few enough to be read."""
    if len(argument.rows) <= 40:
        return " ".join(argument.rows)
    return f"{argument.rows[0]} {argument.rows[1]} .. {argument.rows[-1]}, last index fastest"
