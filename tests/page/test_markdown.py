"""Maths within sentences comes through Markdown as it was written.

GitHub reads Markdown before maths: between plain dollars it drops a backslash before punctuation and takes pairs of
underscores for emphasis. Between $` and `$ it leaves all as it is.
"""

import re

import pytest

from tests.machines import ROOT
from tests.page.pages import page

_MATHS = re.compile(r"\$[^$\n]*\$")
_CODE = re.compile(r"^```.*?^```$|`[^`\n]*`", re.MULTILINE | re.DOTALL)
_BLOCK = re.compile(r"\n\s*\n|\n(?=\|)|(?<=\|)\s(?=\|)|(?<= )\|(?= )")
DOCS = ("derivation.md", "errata.md", "compensation.md", "machine.md")


def spoiled(text: str) -> list[str]:
    """Formulas between plain dollars that Markdown changes."""
    found = []
    for block in _BLOCK.split(_CODE.sub("c", text)):
        emphasis = emphasised(block)
        for maths in _MATHS.finditer(block):
            if re.search(r"\\[!-/:-@\[-`{-~]", maths[0]) or any(maths.start() < at < maths.end() for at in emphasis):
                found.append(maths[0])
    return found


def emphasised(block: str) -> list[int]:
    """Underscores that open or close emphasis (CommonMark): one behind a sign or space, a later one before such."""
    openers = [m.start() for m in re.finditer(r"(?<![a-zA-Z0-9])_(?!\s)", block)]
    closers = [m.start() for m in re.finditer(r"(?<=\S)_(?![a-zA-Z0-9])", block)]
    pairs = [(a, b) for a in openers[:1] for b in closers if b > a]
    return [at for pair in pairs[:1] for at in pair]


@pytest.mark.parametrize("name", ["dmu60p", "bridge_cmm", "trunnion_mill"])
def test_formulas_of_pages_come_through(name: str) -> None:
    assert spoiled(page(name)) == []


@pytest.mark.parametrize("name", DOCS)
def test_formulas_of_documents_come_through(name: str) -> None:
    assert spoiled((ROOT / "docs" / name).read_text(encoding="utf-8")) == []


def test_what_is_spoiled() -> None:
    assert spoiled(r"$a\,b$ and $x_{h}$") == [r"$a\,b$"]
    assert spoiled("$[S]_{p}$, $[T]_{p}$") == ["$[S]_{p}$", "$[T]_{p}$"]
    assert spoiled("$[S]_{p}$") == []
    assert spoiled("$`[S]_{p}\\,a`$, $`[T]_{p}`$") == []


def test_no_left_side_is_read_as_an_option() -> None:
    """TeX reads a bracket behind \\begin{aligned} or behind a line's end as an option and does not print it."""
    for name in ("dmu60p", "dmu60p_5axis", "trunnion_mill"):
        assert not re.search(r"\\begin\{aligned\}\s*\[|\\\\\[", page(name))
