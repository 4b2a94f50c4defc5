"""No formula is wider than GitHub's page of 840 px: measured by another typesetter than the estimate."""

import re

import pytest
from matplotlib.font_manager import FontProperties
from matplotlib.mathtext import MathTextParser

from tests.page.pages import page
from tests.page.rows import rows_of
from trueaxis.codegen.latex import WIDEST, block_width, broken, width

PIXELS, PIXELS_PER_EM = 840, 20.4  # GitHub's column; an em of maths beside DejaVu Sans, measured in a browser
_FONT = FontProperties(size=10, math_fontfamily="cm")


def measured(maths: str) -> float:
    """Width of one row without matrices, em, set by matplotlib."""
    flat = re.sub(r"\\(?:left|right)\b|&", "", maths).replace("\n", " ")
    return float(MathTextParser("path").parse(f"${flat}$", dpi=72, prop=_FONT).width) / 10


@pytest.mark.parametrize("name", ["dmu60p", "headhead_mill"])
def test_no_row_is_wider_than_the_page(name: str) -> None:
    lines = [
        line.removeprefix("&\\quad")
        for block in re.findall(r"^```math\n(.*?)^```$", page(name), re.MULTILINE | re.DOTALL)
        if "bmatrix" not in block
        for line in re.sub(r"\\(?:begin|end)\{aligned\}", "", block).split("\\\\\n")
    ]
    for line in sorted(lines, key=width)[-10:]:
        assert measured(line) * PIXELS_PER_EM < PIXELS, line
    blocks = re.findall(r"^```math\n(.*?)^```$", page(name), re.MULTILINE | re.DOTALL)
    assert max(map(block_width, blocks)) <= WIDEST + 0.5  # a fraction cannot be broken


def test_the_estimate_errs_on_the_wide_side() -> None:
    texts = [row.text for row in rows_of(page("dmu60p")) if "bmatrix" not in row.text]
    for text in texts[::8]:
        if (size := measured(text)) > 5:
            assert width(text) > 0.9 * size, text


def test_long_rows_are_broken_before_a_sign() -> None:
    text = broken("a", [f"+ x_{{{k}}}" for k in range(60)])
    assert all(width(line) <= WIDEST for line in text.split("\\\\"))
    assert all(line.startswith("&\\quad + ") for line in text.split(" \\\\\n")[1:])
    assert broken("a", []) == "a &= 0"


def test_no_double_negative_is_on_a_page() -> None:
    for text in (row.text for name in ("dmu60p", "dmu60p_5axis", "headhead_mill") for row in rows_of(page(name))):
        plain = re.sub(r"\([abcxyz](?:_h)?\)", "", text)
        assert not re.search(r"-\s*(?:\\left)?\(\s*-|[-+]\s*-", plain), text
        assert not re.search(r"\\left\(- [^()]*\\right\)", plain), text
