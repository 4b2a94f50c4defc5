"""The value of a piece of LaTeX in numbers: the small language of equations.md, nothing of the package used.

Juxtaposed factors are multiplied, matrices as matrices. A symbol is looked up by its name without braces, spaces and
commas: `\\varepsilon_{z}(x_h)` is `\\varepsilon_z(x_h)`.
"""

import re
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

Lookup = Callable[[str, int], Any]
_TOKEN = re.compile(r"\\[a-zA-Z]+|\\.|\d+(?:\.\d+)?|[a-zA-Z]'?|\S", re.DOTALL)
_SKIPPED = {r"\,", "&", r"\quad", r"\left", r"\right", r"\bigl", r"\bigr"}
_ARGUMENT = re.compile(r"\\(?:varepsilon|delta)_[xyz]")
SAMPLES = 4
"""Samples of a sum: what n stands for."""


class NotMathsError(ValueError):
    """A text that is no formula of the language, or a name that stands for nothing."""


def names_in(known: Mapping[str, Any]) -> Lookup:
    """Looks names up in a table."""
    return lambda name, _: known.get(name)


def value_of(text: str, lookup: Lookup) -> Any:
    """The number or matrix that the text stands for. Raises NotMathsError."""
    tokens = [token for token in _TOKEN.findall(text) if token not in _SKIPPED]
    reader = _Reader(tokens, lookup)
    result = reader.sum()
    if reader.at != len(tokens):
        raise NotMathsError(f"unread: {' '.join(tokens[reader.at :])}")
    return result


class _Reader:
    def __init__(self, tokens: list[str], lookup: Lookup) -> None:
        self.tokens, self.lookup, self.at, self.index = tokens, lookup, 0, 0

    def peek(self, ahead: int = 0) -> str:
        return self.tokens[self.at + ahead] if self.at + ahead < len(self.tokens) else ""

    def take(self, wanted: str = "") -> str:
        token = self.peek()
        if not token or (wanted and token != wanted):
            raise NotMathsError(f"{wanted or 'something'} expected, not {token!r}")
        self.at += 1
        return token

    def sum(self) -> Any:
        result: Any = None
        while True:
            sign = -1 if self.peek() == "-" else 1
            if self.peek() in ("+", "-"):
                self.at += 1
            elif result is not None:
                return result
            term = sign * self.product()
            result = term if result is None else _added(result, term)

    def product(self) -> Any:
        if self.peek() == "":
            raise NotMathsError("an empty term")
        result = self.factor()
        while self.peek() and self.peek() not in ("+", "-", ")", "}", ",", ";", r"\\", "|", r"\end", "]"):
            if self.peek() == "/":
                self.at += 1
                result = result / self.factor()
                continue
            if self.peek() == r"\times":
                self.at += 1
                return _crossed(result, self.product())
            result = _times(result, self.factor())
        return result

    def factor(self) -> Any:
        result = self.atom()
        if self.peek() == "^":
            self.at += 1
            power = self.script()
            if power == "T":
                return np.transpose(result) if np.shape(result) == (3, 3) else np.reshape(result, (-1, 1))
            if not re.fullmatch(r"-?\d+", power):
                raise NotMathsError(f"no power: {power}")
            return np.linalg.inv(result) if power == "-1" and np.ndim(result) == 2 else result ** int(power)
        return result

    def atom(self) -> Any:
        token = self.take()
        if re.fullmatch(r"\d+(\.\d+)?", token):
            return float(token)
        if token == "(":
            return self.bracket()
        if token == "|":
            inner = self.sum()
            self.take("|")
            return np.linalg.norm(inner)
        if token in _COMMANDS:
            return _COMMANDS[token](self)
        if token == "[":
            name = "[" + self.until("]") + "]"
            return self.named(name, scripts_up=False)
        if re.fullmatch(r"\\[a-zA-Z]+|[a-zA-Z]'?", token):
            return self.named(token, scripts_up=True)
        raise NotMathsError(f"no factor: {token}")

    def bracket(self) -> Any:
        parts = [self.sum()]
        while self.peek() == ",":
            self.at += 1
            parts.append(self.sum())
        self.take(")")
        return parts[0] if len(parts) == 1 else np.array([float(np.real(part)) for part in parts])

    def until(self, end: str) -> str:
        taken = []
        while self.peek() != end:
            taken.append(self.take())
        self.take(end)
        return "".join(taken)

    def script(self) -> str:
        """What stands behind _ or ^."""
        token = self.take()
        return self.until("}") if token == "{" else token

    def named(self, name: str, *, scripts_up: bool) -> Any:
        if scripts_up and self.peek() == "^" and not re.fullmatch(r"[{\dT-]", self._inside(1)):
            self.at += 1
            name += "^" + self.script()
        if self.peek() == "_":
            self.at += 1
            name += "_" + self.script().replace(",", "")
        if scripts_up and self.peek() == "^" and not re.fullmatch(r"[\dT-]", self._inside(1)):
            self.at += 1
            name += "^" + self.script()
        if _ARGUMENT.fullmatch(name) and self.peek() == "(":
            self.at += 1
            name += "(" + self.until(")") + ")"
        found = self.lookup(re.sub(r"[{}\s]", "", name), self.index)
        if found is None:
            raise NotMathsError(f"{name} stands for nothing")
        if callable(found):
            self.take("(")
            arguments = [self.sum()]
            while self.peek() == ",":
                self.at += 1
                arguments.append(self.sum())
            self.take(")")
            return found(*arguments)
        return found

    def _inside(self, ahead: int) -> str:
        return self.peek(ahead + 1) if self.peek(ahead) == "{" else self.peek(ahead)

    def group(self) -> Any:
        self.take("{")
        result = self.sum()
        self.take("}")
        return result

    def fraction(self) -> Any:
        above = self.group()
        return above / self.group()

    def of_angle(self, function: Callable[[Any], Any]) -> Any:
        if self.peek() == "(":
            self.at += 1
            result = function(self.sum() * np.pi / 180)  # positions of rotary axes, deg
            self.take(")")
            return result
        return function(self.factor())

    def summed(self) -> Any:
        """A sum binds what follows it up to the next sum or the end of the term."""
        if (self.take("_"), self.script()) != ("_", "i:1"):
            raise NotMathsError("a sum begins at i = 1")
        self.take("^")
        last = self.lookup(self.script(), 0)
        if not isinstance(last, int):
            raise NotMathsError("no number where a sum ends")
        start, total = self.at, None
        for self.index in range(1, last + 1):
            self.at = start
            term = self.factor()
            while self.peek() and self.peek() not in ("+", "-", ")", "}", r"\sum"):
                term = _times(term, self.factor())
            total = term if total is None else total + term
        self.index = 0
        return total

    def matrix(self) -> Any:
        if self.until("}") != "{bmatrix":
            raise NotMathsError("no matrix")
        rows: list[list[Any]] = [[]]
        while True:
            rows[-1].append(self.sum())
            token = self.take()
            if token == r"\\":
                rows.append([])
            elif token == r"\end":
                self.until("}")
                return np.array(rows)
            elif token != ";":
                raise NotMathsError(f"in a matrix: {token}")

    def upright(self) -> Any:
        self.take("{")
        return self.named(r"\mathrm" + self.until("}").replace("\\", ""), scripts_up=False)


_COMMANDS: Mapping[str, Callable[[_Reader], Any]] = {
    r"\frac": _Reader.fraction,
    r"\sqrt": lambda reader: np.sqrt(reader.group()),
    r"\cos": lambda reader: reader.of_angle(np.cos),
    r"\sin": lambda reader: reader.of_angle(np.sin),
    r"\arccos": lambda reader: np.arccos(reader.factor()),
    r"\sum": _Reader.summed,
    r"\begin": _Reader.matrix,
    r"\pi": lambda _: np.pi,
    r"\Delta": lambda reader: reader.named(r"\Delta" + reader.take(), scripts_up=False),
    r"\mathrm": _Reader.upright,
}


def _times(left: Any, right: Any) -> Any:
    if np.ndim(left) == 2 and np.ndim(right) >= 1:
        if np.shape(left)[1] != np.shape(right)[0]:
            raise NotMathsError("matrices that do not fit")
        return left @ right
    return left * right


def _crossed(left: Any, right: Any) -> Any:
    """The vector product; of a point its three coordinates."""
    return np.cross(np.ravel(left)[:3], np.ravel(right)[:3])


def _added(left: Any, right: Any) -> Any:
    if isinstance(left, float) and left == 1 and np.shape(right) == (4, 4):
        left = np.eye(4)  # the unit matrix is written 1
    if np.shape(left) != np.shape(right):
        raise NotMathsError("a sum of shapes that differ")
    return left + right
