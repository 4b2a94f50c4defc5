"""Rows of an equation that fit the page: estimated widths, and lines of an `aligned` block broken by them."""

import re
from collections.abc import Sequence

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


def broken(left: str, terms: Sequence[str], widest: float = WIDEST) -> str:
    """`left &= terms` in as many rows of an `aligned` block as their width asks for; each term bears its sign."""
    lines: list[list[str]] = [[terms[0].removeprefix("+ ") if terms else "0"]]
    indent = width(left) + 1.3
    used = indent + width(lines[0][0])
    for term in terms[1:]:
        if used + width(term) > widest:
            lines.append([])
            used = indent + 1.0
        lines[-1].append(term)
        used += width(term)
    return f"{left} &= " + " \\\\\n&\\quad ".join(" ".join(line) for line in lines)
