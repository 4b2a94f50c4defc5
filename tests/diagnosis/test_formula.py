r"""Effects as LaTeX: what stands in it, that browsers' MathML takes it, that it is worth what the expression is."""

import math
import re
import warnings
from collections.abc import Callable
from typing import ClassVar

import numpy as np
import pytest
import sympy as sp
from hypothesis import example, given
from hypothesis import strategies as st

from tests.fuzz import expressions as exact
from tests.machines import DMU60P, machine_at
from trueaxis.derivation import symbols
from trueaxis.derivation.effect_terms import symbolic
from trueaxis.effects.expression import FUNCTIONS, parse
from trueaxis.effects.kind import Effect, Kind, Parameter
from trueaxis.effects.latex import ADDED, component_latex, effect_latex, term_latex
from trueaxis.effects.library import KINDS
from trueaxis.error_name import ErrorName
from trueaxis.reporting.diagnosis.html import mathml

MACHINE = machine_at(DMU60P)
EXPECTED = {
    Effect(kind="backlash", component="EXX"): rf"\delta_{{x}}(x) {ADDED} \frac{{\mathit{{width}}}}{{2}}\,\sigma_{{x}}",
    Effect(kind="backlash_slope", component="ECY"): (
        rf"\varepsilon_{{z}}(y) {ADDED} \mathit{{change}}\,\sigma_{{y}}\,\left(s_{{y}} - \frac{{1}}{{2}}\right)"
    ),
    Effect(kind="cyclic", component="EYY"): (
        rf"\delta_{{y}}(y) {ADDED} "
        r"\mathit{amplitude}\,\cos\left(\frac{2\,\pi\,y}{\mathit{pitch}} + \mathit{phase}\right)"
    ),
    Effect(kind="warm_up", component="EZZ"): (
        rf"\delta_{{z}}(z) {ADDED} \mathit{{amplitude}}\,s_{{z}}\,\exp\left(-\frac{{t}}{{\tau}}\right)"
    ),
    Effect(kind="servo_lag", component="EXX"): rf"\delta_{{x}}(x) {ADDED} -\tau\,v_{{x}}",
    Effect(kind="cross_axis", component="EXX", axis="Y"): rf"\delta_{{x}}(x) {ADDED} k\,s_{{x}}\,s_{{y}}^{{2}}",
    Effect(kind="laser_cosine", runs=("X1", "X2")): (
        rf"L {ADDED} -\frac{{\mathit{{angle}}^{{2}}}}{{2}}\,\ell \quad \text{{(X1, X2)}}"
    ),
    Effect(kind="laser_step", runs=("a_b",)): (
        rf"L {ADDED} \mathit{{jump}}\,H\left(t - t_{{0}}\right) \quad \text{{(one run)}}"
    ),
    Effect(kind="ballbar_length"): rf"\Delta R {ADDED} \mathit{{length}}",
    Effect(kind="point_offset", runs=("X1",), end="target"): (
        rf"\mathbf{{r}}_{{\text{{target}}}} {ADDED} \begin{{pmatrix}} x \\ y \\ z \end{{pmatrix}} \quad \text{{(X1)}}"
    ),
    Effect(kind="squareness", component="EC0X"): rf"E_{{C0X}} {ADDED} \mathit{{angle}}",
}  # fmt: skip


@pytest.mark.parametrize("effect", EXPECTED, ids=lambda effect: effect.label)
def test_formulas(effect: Effect) -> None:
    assert effect_latex(MACHINE.kinds[effect.kind], effect) == EXPECTED[effect]


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_every_kind_is_drawn_without_a_command_left(kind: Kind) -> None:
    component = "EB0Y" if kind.place == "location" else "EYY" if kind.place == "component" else None
    drawn = mathml(
        effect_latex(kind, Effect(kind=kind.name, component=component, axis="X" if kind.other_axis else None))
    )
    assert drawn.startswith("<math")
    assert "\\" not in drawn
    assert not re.search(r"<mo>\s*<m", drawn), "an operator within an operator is no MathML"


def test_components_have_the_names_of_the_paper() -> None:
    for axis in "XYZABC":
        for letter, index, greek in zip("XYZABC", "xyzxyz", ["delta"] * 3 + ["varepsilon"] * 3, strict=True):
            assert component_latex(ErrorName(f"E{letter}{axis}")) == rf"\{greek}_{{{index}}}({axis.lower()})"


NAMES = {
    "q": "x",
    "s": "s_{x}",
    "direction": r"\sigma_{x}",
    "v_b": "v_{y}",
    "T": "T",
    "width": r"\mathit{width}",
    "t_0": "t_{0}",
}
USER = Kind(
    name="user",
    place="component",
    expression="",
    parameters=tuple(Parameter(name=name, unit="u", meaning="") for name in ("width", "t_0")),
    sentence="",
    other_axis=True,
)


NUMERIC = {"Root": math.sqrt, "Absolute": abs, "Sign": np.sign, "Step": lambda x: float(x >= 0)}


def expressions() -> st.SearchStrategy[str]:
    leaves = st.sampled_from([*NAMES, "2", "0.5", "1e-7", "pi", "3"])
    return st.recursive(
        leaves,
        lambda inner: st.one_of(
            st.tuples(inner, st.sampled_from("+-*/"), inner).map(lambda t: f"({t[0]}) {t[1]} ({t[2]})"),
            st.tuples(inner, st.sampled_from("+-*/"), inner).map(lambda t: f"{t[0]} {t[1]} {t[2]}"),
            inner.map(lambda text: f"-({text})"),
            st.tuples(inner, st.integers(1, 3)).map(lambda t: f"({t[0]})^{t[1]}"),
            st.tuples(st.sampled_from(FUNCTIONS), inner).map(lambda t: f"{t[0]}({t[1]})"),
        ),
        max_leaves=6,
    )


@given(expressions())
@example("sign(((q) - (q)) / ((q) - (q)))")
@example("(sqrt(-(q))) - (sqrt(-(q)))")
def test_the_formula_is_worth_what_the_expression_is(text: str) -> None:
    """Read back by a reader of its own, against SymPy's value of the expression."""
    tree = parse(text)
    kind = Kind(
        name="user", place="component", expression=text, parameters=USER.parameters, sentence="", other_axis=True
    )
    latex = term_latex(kind, Effect(kind="user", component="EXX", axis="Y"))
    values = {name: 0.3 + 0.17 * place for place, name in enumerate(NAMES)}
    ordered = [symbols.named(name) for name in values]
    with warnings.catch_warnings(action="ignore"):
        try:
            value = complex(sp.lambdify(ordered, symbolic(tree), modules=[NUMERIC, "math"])(*values.values()))
        except (ArithmeticError, ValueError):
            return
    if value.imag or not math.isfinite(value.real) or abs(value) > 1e12:
        return
    try:
        read = Reader(latex, {shown: values[name] for name, shown in NAMES.items()}).value()
    except (ZeroDivisionError, RuntimeWarning):
        # SymPy cancels u / u where u is 0, or a root of what is below zero; the formula shows it as written: the text
        # has no value there.
        assert exact.value(text, values) is None
        return
    assert read == pytest.approx(value.real, rel=1e-6, abs=1e-9)


class Reader:
    """The value of LaTeX as a person reads it: sums of products, side by side, of atoms with exponents."""

    TOKEN = re.compile(
        r"\\left|\\right|\\mathit\{[a-z]+\}|\\operatorname\{sgn\}|\\[a-z]+(?:_\{\w\})?"
        r"|[A-Za-z]_\{\w\}|[0-9.]+|[A-Za-z]|\S"
    )
    CALLS: ClassVar[dict[str, Callable[[float], float]]] = {
        r"\sin": np.sin, r"\cos": np.cos, r"\exp": np.exp, r"\tanh": np.tanh, r"\operatorname{sgn}": np.sign,
        "H": lambda x: float(x >= 0),
    }  # fmt: skip

    def __init__(self, latex: str, names: dict[str, float]) -> None:
        self.tokens = [*self.TOKEN.findall(latex.replace(r"\,", " ").replace(r"\cdot", " ")), ""]
        self.names, self.at = names, 0

    def value(self) -> float:
        found = self.sum()
        assert self.tokens[self.at] == "", self.tokens[self.at :]
        return found

    def take(self, *expected: str) -> str:
        token: str = self.tokens[self.at]
        assert not expected or token in expected, (token, expected)
        self.at += 1
        return token

    def sum(self) -> float:
        total = -self.product(self.take("-")) if self.tokens[self.at] == "-" else self.product()
        while self.tokens[self.at] in ("+", "-"):
            total += self.product() if self.take() == "+" else -self.product()
        return total

    def product(self, _: str = "") -> float:
        total = self.power()
        while self.tokens[self.at] not in ("", "+", "-", "}", r"\right"):
            total *= self.power()
        return total

    def power(self) -> float:
        base = self.atom()
        if self.tokens[self.at] == "^":
            self.take()
            base = base ** self.braces()
        return base

    def braces(self) -> float:
        self.take("{")
        found = self.sum()
        self.take("}")
        return found

    def atom(self) -> float:
        token = self.take()
        if token == r"\frac":
            return self.braces() / self.braces()
        if token == r"\sqrt":
            return float(np.sqrt(self.braces()))
        if token in self.CALLS:
            self.take(r"\left")
            return float(self.CALLS[token](self.enclosed()))
        if token == r"\left":
            return self.enclosed()
        if token == r"\pi":
            return float(np.pi)
        return self.names[token] if token in self.names else float(token)

    def enclosed(self) -> float:
        opened = self.take("(", "|")
        found = self.sum()
        self.take(r"\right")
        self.take(")", "|")
        return abs(found) if opened == "|" else found
