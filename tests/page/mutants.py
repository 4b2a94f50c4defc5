"""Slips of the pen put into a formula: sign, term, factor, letter, index, function, order, transposition, inversion."""

import re
from collections.abc import Callable, Iterator
from itertools import pairwise

_SIGN = re.compile(r"(?<![_^{])[+-](?!1\})")
_SYMBOL = re.compile(
    r"(?:\\(?:varepsilon|delta|Theta|mathrm|theta)|[a-zA-Z]'?)"
    r"(?:[_^](?:\{[^{}]*\}|[a-zA-Z0-9]))*(?:\{[^{}]*\})?(?:\([xyzabc](?:_[hi])?\))?"
)
_FACTOR = re.compile(r"\[S\w+\](?:_\{?\w+\}?)?")
_MATRIX = re.compile(r"\\begin\{bmatrix\}(.*?)\\end\{bmatrix\}", re.DOTALL)
_NEXT = str.maketrans("xyz", "yzx")
_OTHER_INDEX = str.maketrans("12kl", "21lk")
_COMMANDS = ("begin", "end", "bmatrix")


def mutants(text: str) -> Iterator[tuple[str, str]]:
    """Each slip with its kind; the left side of the first `=` is left alone where it is a name."""
    start = text.index("=") + 1
    for kind, slips in (
        ("sign", _signs(text, start)),
        ("omission of a term", _terms(text, start)),
        ("omission of a factor", _factors(text, start)),
        ("letter", _letters(text, start)),
        ("index", _indices(text, start)),
        ("function", _functions(text, start)),
        ("order", _orders(text)),
        ("transposition", _matrices(text, _transposed)),
        ("order of rows", _matrices(text, _rows_swapped)),
        ("inversion", _inversions(text)),
    ):
        yield from ((kind, slip) for slip in slips if slip != text)


def _signs(text: str, start: int) -> Iterator[str]:
    for found in _SIGN.finditer(text, start):
        other = "-" if found[0] == "+" else "+"
        yield text[: found.start()] + other + text[found.end() :]
    for found in _MATRIX.finditer(text):
        for cell in re.finditer(r"(?<![^;\\])\s*(?!0\s*(?:;|\\|$))(?=[^\s\-;])", found[1]):
            at = found.start(1) + cell.end()
            yield f"{text[:at]}- {text[at:]}"
    head = text[start:].lstrip()
    if not head.startswith(("-", r"\begin", "[", "0")):
        yield f"{text[:start]} - {head}"


def _terms(text: str, start: int) -> Iterator[str]:
    """Each term behind a sign left out, at any depth of brackets."""
    for found in _SIGN.finditer(text, start):
        depth, at = 0, found.end()
        while at < len(text):
            sign = text[at]
            if depth == 0 and (sign in "+-=;)}" or text.startswith((r"\\", r"\end", r"\right"), at)):
                break
            depth += {"(": 1, "{": 1, ")": -1, "}": -1}.get(sign, 0)
            at += 1
        if text[at - 1] not in "^_{":
            yield text[: found.start()] + text[at:]


def _symbols(text: str, start: int) -> Iterator[re.Match[str]]:
    for found in _SYMBOL.finditer(text, start):
        before = text[: found.start()]
        if before.endswith("\\") or re.search(r"(?:\\[a-zA-Z]*|[_^]\{?[^{}\s]*|\[[^\]]*)$", before):
            continue
        if found[0].split("_", maxsplit=1)[0] not in _COMMANDS and not _in_command(text, found.start()):
            yield found


def _in_command(text: str, at: int) -> bool:
    return text[max(0, text.rfind("{", 0, at) - 6) : at].startswith((r"\begin", "begin", r"\end", "end"))


def _factors(text: str, start: int) -> Iterator[str]:
    for found in _symbols(text, start):
        yield f"{text[: found.start()]} 1 {text[found.end() :]}"


def _letters(text: str, start: int) -> Iterator[str]:
    """One axis letter of a symbol replaced by the next: in its index, then in its argument."""
    for found in _symbols(text, start):
        for at in range(found.start(), found.end()):
            name = text[found.start() : at]
            if text[at] in "xyz" and not re.search(r"\\[a-zA-Z]*$", name):
                yield text[:at] + text[at].translate(_NEXT) + text[at + 1 :]


def _indices(text: str, start: int) -> Iterator[str]:
    """A number of an index replaced by another, a point of the tool by one of the worktable."""
    for found in _symbols(text, start):
        for at in (
            found.start() + each.start() for each in re.finditer(r"(?<=[{kluvxyz])[12kl](?=[}0-9uvxyzh])", found[0])
        ):
            yield text[:at] + text[at].translate(_OTHER_INDEX) + text[at + 1 :]


def _functions(text: str, start: int) -> Iterator[str]:
    """Displacement for angle, cosine for sine, and the other way round."""
    for pair in ((r"\delta", r"\varepsilon"), (r"\cos", r"\sin")):
        for one, other in (pair, pair[::-1]):
            for found in re.finditer(re.escape(one) + r"(?![a-z])", text[start:]):
                yield text[: start + found.start()] + other + text[start + found.end() :]


def _orders(text: str) -> Iterator[str]:
    """Neighbouring matrices exchanged."""
    found = list(_FACTOR.finditer(text, text.index("=") + 1))
    for first, second in pairwise(found):
        between = text[first.end() : second.start()]
        if re.fullmatch(r"[\s\\,]*", between):
            yield text[: first.start()] + second[0] + between + first[0] + text[second.end() :]


def _matrices(text: str, change: Callable[[list[list[str]]], list[list[str]]]) -> Iterator[str]:
    for found in _MATRIX.finditer(text):
        cells = [[cell.strip() for cell in row.split(";")] for row in found[1].split(r"\\")]
        body = r"\\".join(" ; ".join(row) for row in change(cells))
        if change(cells) != cells:
            yield f"{text[: found.start()]}\\begin{{bmatrix}}{body}\\end{{bmatrix}}{text[found.end() :]}"


def _transposed(cells: list[list[str]]) -> list[list[str]]:
    return [list(column) for column in zip(*cells, strict=True)]


def _rows_swapped(cells: list[list[str]]) -> list[list[str]]:
    return [cells[1], cells[0], *cells[2:]] if len(cells) > 1 else cells


def _inversions(text: str) -> Iterator[str]:
    if "^{-1}" in text:
        yield text.replace("^{-1}", "", 1)
    for found in re.finditer(r"\[S\w+\](?!_|\^)", text):
        yield text[: found.end()] + "^{-1}" + text[found.end() :]
    for found in _MATRIX.finditer(text):
        cells = found[1].split(r"\\")
        if len(cells) == cells[0].count(";") + 1 > 1 and not text.startswith("^{-1}", found.end()):
            yield text[: found.end()] + "^{-1}" + text[found.end() :]
    for found in re.finditer(r"\\frac", text):
        above_end = _closing(text, found.end())
        below_end = _closing(text, above_end)
        above, below = text[found.end() : above_end], text[above_end:below_end]
        yield text[: found.end()] + below + above + text[below_end:]


def _closing(text: str, start: int) -> int:
    depth = 0
    for at in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        if depth == 0:
            return at + 1
    raise ValueError(text)
