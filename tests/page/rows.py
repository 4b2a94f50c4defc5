"""The formulas of a page: every row of every block of maths, under its headings."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

_HEADING = re.compile(r"^(#{2,3}) (.*)$|^\*\*(Body .*)\*\*$")
_INLINE = re.compile(r"\$([^$]*)\$")


@dataclass(frozen=True)
class Row:
    """One formula, with `=` between its sides; section and title are the headings above it."""

    section: str
    title: str
    text: str


def rows_of(page: str) -> list[Row]:
    """Every formula of the blocks of maths of a page, and every equality within its sentences."""
    section = title = ""
    found: list[Row] = []
    lines = iter(page.splitlines())
    for line in lines:
        if heading := _HEADING.match(line):
            if heading[1] == "##":
                section, title = heading[2], ""
            else:
                title = heading[2] or heading[3] or ""
        elif line == "```math":
            block = []
            while (line := next(lines)) != "```":
                block.append(line)
            found += [Row(section, title, text) for text in _split("\n".join(block))]
        elif not line.startswith("|"):
            found += [Row(section, title, text) for text in _INLINE.findall(line) if "=" in text]
    return found


def _split(block: str) -> Iterator[str]:
    # As TeX reads it: a bracket behind \begin{aligned} is its option (where to align) and is not printed; {} keeps it.
    text = re.sub(r"\\begin\{aligned\}(?:\s*\[[^\]]*\]|\s*\{\})?|\\end\{aligned\}", "", block)
    text = text.replace("\\\\\n&\\quad", " ").replace("_{i=1}", "_{i:1}")
    text = re.sub(r"\\begin\{bmatrix\}.*?\\end\{bmatrix\}", lambda m: m[0].replace("&", ";"), text, flags=re.DOTALL)
    for line in text.split("\\\\\n"):
        without = re.sub(r"\\qquad \(\d+\)|& \(\d+\)", "", line)
        yield from (part.replace("&", "").strip() for part in re.split(r"(?<=\S) & ", without) if part.strip())


def cells_of(page: str, heading: str) -> list[list[str]]:
    """The rows of the first table behind a heading."""
    behind = page[page.index(heading) :].splitlines()[1:]
    start = next(k for k, line in enumerate(behind) if line.startswith("|"))
    table = []
    for line in behind[start:]:
        if not line.startswith("|"):
            break
        table.append([cell.strip() for cell in line.strip("|").split("|")])
    return [table[0], *table[2:]]
