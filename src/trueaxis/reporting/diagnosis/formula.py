"""Formulas in the page: LaTeX to MathML, which browsers draw without any script."""

import re

from latex2mathml.converter import convert

_SPACE = r'(?:<mspace width="[^"]*" />)?'
_ADDED = re.compile(rf"{_SPACE}<mrow><mo>&#x0002B;</mo></mrow><mrow><mo>&#x0003D;</mo></mrow>{_SPACE}")
_LETTERS = re.compile(r'(?:<mi mathvariant="italic">\w</mi>){2,}')


def mathml(latex: str) -> str:
    """A math element in block style. In a page it needs no namespace.

    `+=` is one operator in it and the name of a parameter one identifier, which converters set sign by sign.
    """
    text = re.sub(r' xmlns="[^"]*"', "", convert(latex, display="block"), count=1)
    text = _ADDED.sub('<mo lspace="0.278em" rspace="0.278em">+=</mo>', text)
    return _LETTERS.sub(lambda name: f'<mi class="name">{re.sub("<[^>]*>", "", name.group())}</mi>', text)
