"""Formulas as GitHub's Markdown has them, to MathML: browsers draw it without a script, so the site needs no network.

Three forms: a fence ```math, `$...$` in a sentence, and $`...`$ where Markdown would touch what stands between.
"""

import html
import re
from typing import Any

from latex2mathml.converter import convert
from markdown import Markdown
from markdown.extensions import Extension
from markdown.inlinepatterns import InlineProcessor

# Code spans have 190 in Markdown: formulas between dollars and backticks come before them, plain dollars after them.
_BEFORE_CODE, _AFTER_CODE = 195, 185
_IN_BACKTICKS = r"\$`([^`]+)`\$"
# A dollar of a shell variable has no partner, or white space beside it.
_IN_DOLLARS = r"(?<![\\$\w])\$(?![\s$])([^$\n]*?[^\s$\\])\$(?![\w$])"
# Brackets grow with a matrix only in fonts for mathematics, which not every device has: the style sheet draws them.
_BRACKETED = re.compile(r"<mo>&#x0005B;</mo><mtable>(.*?</mtable>)<mo>&#x0005D;</mo>")


def mathml(latex: str, display: str) -> str:
    """A formula as a MathML element; display: block or inline."""
    known = latex.replace("{aligned}", "{split}")  # the converter's name of the same
    made = re.sub(r' xmlns="[^"]*"', "", convert(known, display=display), count=1)
    made = _BRACKETED.sub(r'<mtable class="bracketed">\1', made)
    if "\\" in made or "<mi>&" in made.replace("<mi>&#", "<mi>"):
        raise ValueError(f"a formula is not known to the converter: {latex}")
    return made


def block(source: str, *_: Any, **__: Any) -> str:
    """A fence ```math as HTML; the formula scrolls by itself where the screen is narrow."""
    return f'<div class="formula" tabindex="0">{mathml(source, "block")}</div>'


class _Inline(InlineProcessor):
    def handleMatch(  # type: ignore[override]
        self, m: re.Match[str], data: str
    ) -> tuple[str, int, int]:
        """The formula of one match, kept from further reading."""
        return self.md.htmlStash.store(mathml(html.unescape(m.group(1)), "inline")), m.start(0), m.end(0)


class Formulas(Extension):
    """Formulas in sentences."""

    def extendMarkdown(self, md: Markdown) -> None:
        """Register both forms."""
        md.inlinePatterns.register(_Inline(_IN_BACKTICKS, md), "formula-backticks", _BEFORE_CODE)
        md.inlinePatterns.register(_Inline(_IN_DOLLARS, md), "formula-dollars", _AFTER_CODE)


def makeExtension(**options: Any) -> Formulas:
    """The extension."""
    return Formulas(**options)
