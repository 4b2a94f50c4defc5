"""Formulas in the page: LaTeX to MathML, which browsers draw without any script."""

import re

from latex2mathml.converter import convert


def mathml(latex: str) -> str:
    """A math element in block style. In a page it needs no namespace."""
    return re.sub(r' xmlns="[^"]*"', "", convert(latex, display="block"), count=1)
