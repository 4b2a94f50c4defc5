r"""Effects as equations in LaTeX, bound to their place: \delta_{x}(x) += width/2 \sigma_{x}.

Written by the one writer for the generated equations and for the report of a diagnosis. Kept to what browsers, GitHub
and latex2mathml all draw.
"""

import re

from trueaxis.effects.expression import Binary, Call, Expression, Function, Name, Negative, Number, Pi, Power, parse
from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.placement import OF_AXIS, VARIABLES
from trueaxis.error_name import ErrorName

ADDED = r"\;{+}{=}\;"  # \mathrel{+}= nests one operator in another, which MathML does not allow
_GREEK = ("alpha", "beta", "gamma", "delta", "epsilon", "kappa", "lambda", "mu", "nu", "rho", "tau", "phi", "omega")
_FUNCTIONS = {
    "sin": r"\sin",
    "cos": r"\cos",
    "exp": r"\exp",
    "tanh": r"\tanh",
    "sign": r"\operatorname{sgn}",
    "step": "H",
}
_MOST_RUNS = 4  # named in a formula
_PLAIN = re.compile(r"[A-Za-z0-9 .:+/-]+")  # what \text sets as it is wherever it is drawn


def effect_latex(kind: Kind, effect: Effect) -> str:
    """What an effect adds, and to what, values not filled in. Raises ExpressionError.

    The left side is the component error by its name in the paper, the reading L of a laser or probe, the change of a
    ball bar's length, a point of the set-up, or the position error by its name in ISO 230-7.
    """
    if kind.place == "component":
        return f"{component_latex(effect.error)} {ADDED} {term_latex(kind, effect)}"
    if kind.place == "location":
        return f"E_{{{effect.error.subscript}}} {ADDED} {_parameter(kind.parameters[0].name)}"
    if kind.place == "point":
        point = rf"\mathbf{{r}}_{{\text{{{effect.end or 'ball'}}}}}"
        coordinates = r" \\ ".join(_parameter(one.name) for one in kind.parameters)
        return rf"{point} {ADDED} \begin{{pmatrix}} {coordinates} \end{{pmatrix}}{_of_runs(effect)}"
    reading = r"\Delta R" if kind.instruments == ("ballbar",) else "L"
    return f"{reading} {ADDED} {term_latex(kind, effect)}{_of_runs(effect)}"


def term_latex(kind: Kind, effect: Effect) -> str:
    """The expression of a kind, its variables those of the effect's axes. Raises ExpressionError."""
    return _Writer(kind, effect).sum(parse(kind.expression))


def component_latex(component: ErrorName) -> str:
    r"""The paper's name of a component error: \delta_{x}(y) of EXY, \varepsilon_{z}(x) of ECX."""
    letter = r"\varepsilon" if component.is_rotation else r"\delta"
    return f"{letter}_{{{component.direction.line.lower()}}}({component.axis.lower()})"


def _parameter(name: str) -> str:
    head, _, tail = name.partition("_")
    if head in _GREEK:
        text = f"\\{head}"
    elif len(head) == 1:
        text = head
    else:
        text = rf"\mathit{{{head}}}"
    index = tail.replace("_", ",")
    return f"{text}_{{{index}}}" if index else text


def _of_runs(effect: Effect) -> str:
    """The runs, where an effect is of some alone."""
    if not effect.runs:
        return ""
    said = ", ".join(effect.runs)
    if len(effect.runs) > _MOST_RUNS or not _PLAIN.fullmatch(said.replace(",", "")):
        said = f"{len(effect.runs)} runs" if len(effect.runs) > 1 else "one run"
    return rf" \quad \text{{({said})}}"


class _Writer:
    """Writes a syntax tree; one method per level of the grammar, parentheses where a level needs them."""

    def __init__(self, kind: Kind, effect: Effect) -> None:
        self._axes = {"": effect.own_axis.lower(), "_b": (effect.axis or "").lower()}
        self._parameters = {one.name for one in kind.parameters}

    def sum(self, expression: Expression) -> str:
        if not (isinstance(expression, Binary) and expression.operator in "+-"):
            return self._product(expression)
        # on the right of a minus a sum needs parentheses, which the text had, too
        right = self._product(expression.right) if not _is_sum(expression.right) else self._enclosed(expression.right)
        right = rf"\left({right}\right)" if right.startswith("-") else right
        return f"{self.sum(expression.left)} {expression.operator} {right}"

    def _product(self, expression: Expression) -> str:
        negative, tree = _signed(expression)
        return ("-" if negative else "") + self._unsigned(tree)

    def _unsigned(self, tree: Expression) -> str:
        if isinstance(tree, Binary) and tree.operator == "/":
            over = self.sum(tree.left) if _is_sum(tree.left) else self._product(tree.left)
            return rf"\frac{{{over}}}{{{self.sum(tree.right)}}}"
        if isinstance(tree, Binary) and tree.operator == "*":
            left, right = self._factor(tree.left, first=True), self._factor(tree.right)
            # two numbers side by side would read as one
            sign = r" \cdot " if right[0].isdigit() else r"\,"
            return f"{left}{sign}{right}"
        return self._atom(tree)

    def _factor(self, tree: Expression, *, first: bool = False) -> str:
        if isinstance(tree, Binary) and tree.operator == "*" and not first:
            return self._enclosed(tree)
        if isinstance(tree, Binary) and tree.operator in "*/":
            return self._unsigned(tree)
        return self._atom(tree)

    def _atom(self, tree: Expression) -> str:
        match tree:
            case Number(value=value):
                text = _number(value)
            case Pi():
                text = r"\pi"
            case Name(name=name):
                text = self._name(name)
            case Call(function=function, argument=argument):
                text = _called(function, self.sum(argument))
            case Power(base=base, exponent=exponent):
                plain = isinstance(base, Name | Pi) or (isinstance(base, Number) and _number(base.value).isdigit())
                inner = self._atom(base) if plain else self._enclosed(base)
                text = f"{inner}^{{{exponent}}}"
            case _:
                text = self._enclosed(tree)
        return text

    def _enclosed(self, tree: Expression) -> str:
        return rf"\left({self.sum(tree)}\right)"

    def _name(self, name: str) -> str:
        if name in self._parameters:
            return _parameter(name)
        own = name.removesuffix("_b")
        if own not in {one.name for one in OF_AXIS}:
            return VARIABLES[name].latex
        axis = self._axes[name[len(own) :]]
        return axis if own == "q" else f"{VARIABLES[own].latex}_{{{axis}}}"


def _called(function: Function, argument: str) -> str:
    match function:
        case "sqrt":
            return rf"\sqrt{{{argument}}}"
        case "abs":
            return rf"\left|{argument}\right|"
        case _:
            return rf"{_FUNCTIONS[function]}\left({argument}\right)"


def _is_sum(tree: Expression) -> bool:
    return isinstance(tree, Binary) and tree.operator in "+-"


def _signed(tree: Expression) -> tuple[bool, Expression]:
    """A minus sign at the front of a product or quotient taken out."""
    if isinstance(tree, Negative):
        negative, inner = _signed(tree.operand)
        return not negative, inner
    if isinstance(tree, Binary) and tree.operator in "*/":
        negative, left = _signed(tree.left)
        return negative, Binary(tree.operator, left, tree.right)
    return False, tree


def _number(value: float) -> str:
    text = repr(value).removesuffix(".0")
    mantissa, _, exponent = text.partition("e")
    return rf"{mantissa} \cdot 10^{{{int(exponent)}}}" if exponent else text
