"""equations.md: maths that GitHub renders, on pages of machines of every kind."""

import re
from collections.abc import Iterator
from functools import cache

import pytest

from tests.derivation.test_routine import models
from tests.derivation.topologies import OTHERS
from tests.kernels import model_of
from trueaxis.codegen.equations import equations_page

PAGES = ("dmu60p", "five_axis", "shared", "all on the workpiece side", "table B, head A")


@cache
def page(name: str) -> str:
    model = models()[name] if name in models() else model_of(OTHERS[name])
    return equations_page(model)


def blocks(text: str) -> Iterator[str]:
    yield from re.findall(r"^```math\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def inline(text: str) -> Iterator[str]:
    outside = re.sub(r"^```math\n.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)
    yield from re.findall(r"\$([^$]*)\$", outside)


def balanced(maths: str) -> bool:
    depth = 0
    for sign in re.findall(r"\\.|[{}]", maths):  # \{ and \\ are signs of their own
        depth += {"{": 1, "}": -1}.get(sign, 0)
        if depth < 0:
            return False
    return depth == 0


@pytest.mark.parametrize("name", PAGES)
class TestEveryPage:
    def test_fences_and_braces_are_balanced(self, name: str) -> None:
        text = page(name)
        assert text.count("```") == 2 * len(list(blocks(text)))
        for maths in [*blocks(text), *inline(text)]:
            assert maths.strip()
            assert balanced(maths), maths
            assert len(re.findall(r"\\left\b", maths)) == len(re.findall(r"\\right\b", maths)), maths
            opened = re.findall(r"\\begin\{(\w+)\}", maths)
            assert sorted(opened) == sorted(re.findall(r"\\end\{(\w+)\}", maths))
            assert "$" not in maths
            assert "\n\n" not in maths

    def test_no_bracket_spans_a_line_or_a_column(self, name: str) -> None:
        # \left( must be closed before the next \\ or &, or the page shows an error instead of an equation.
        for maths in blocks(page(name)):
            depth = 0
            for sign in re.findall(r"\\left\b|\\right\b|\\\\|&|\\begin\{\w+\}|\\end\{\w+\}", maths):
                if sign == r"\left":
                    depth += 1
                elif sign == r"\right":
                    depth -= 1
                elif sign in (r"\\", "&"):
                    assert depth == 0, maths

    def test_rows_of_tables_have_the_columns_of_their_heads(self, name: str) -> None:
        lines = page(name).splitlines()
        for at, line in enumerate(lines):
            if not re.fullmatch(r"\|(-+\|)+", line):
                continue
            columns = line.count("|")
            assert lines[at - 1].count("|") == columns
            rows = list(_until_blank(lines[at + 1 :]))
            assert rows, lines[at - 1]
            for row in rows:
                assert row.count("|") == columns, row
                assert row.count("$") % 2 == 0, row

    def test_every_symbol_of_the_page_is_typeset(self, name: str) -> None:
        # Names of files (EXX, cos_b, q_Tz) belong to code spans; in maths they have been given signs.
        for maths in [*blocks(page(name)), *inline(page(name))]:
            assert not re.search(r"\bE[XYZABC][XYZABC]\b|\b(?:cos|sin)_[abc]|_bound|_shared|\bw\d+\b", maths), maths
            assert not re.search(r"\d\.\d{16,}", maths), "a number with the digits of its rounding"
            assert not re.search(r"\b(nan|zoo|None|Matrix|Integer)\b", maths), maths

    def test_symbols_are_listed_with_units(self, name: str) -> None:
        model = models()[name] if name in models() else model_of(OTHERS[name])
        section = page(name).split("## Symbols")[1].split("\n##")[0]
        for symbol in (*model.machine.components, *model.machine.parameters):
            (row,) = [line for line in section.splitlines() if f'<a id="{symbol}"></a>`{symbol}` |' in line]
            cells = [cell.strip() for cell in row.strip("|").split("|")]
            assert cells[2] in ("mm", "rad")
            assert cells[3]

    def test_headings_are_there_and_the_first_line_says_how_the_page_is_made(self, name: str) -> None:
        text = page(name)
        assert text.startswith("<!-- Generated from machines/")
        assert "regenerate with: trueaxis derive machines/" in text.splitlines()[0]
        for heading in ("Topology", "Symbols", "The chain", "Ball bar", "Kernels"):
            assert f"\n## {heading}" in text


def _until_blank(lines: list[str]) -> Iterator[str]:
    for line in lines:
        if not line.startswith("|"):
            return
        yield line


def test_the_papers_numbers_stand_beside_its_equations() -> None:
    text = page("dmu60p")
    for heading in (
        "### Eq. (12): motion of X alone\n",
        "### Eq. (27): motion of X and Y together (errata: [E10](../../docs/errata.md#e10), [E21]",
        "### Eq. (26): solution (errata: [E19]",
        "## Sect. 3.6: Squareness\n",
    ):
        assert f"\n{heading}" in text


def test_every_number_of_the_paper_s_sections_is_on_its_page() -> None:
    text = page("dmu60p")
    assert {int(n) for n in re.findall(r"\((\d+)\)", text)} >= set(range(1, 44))
    order = [int(n) for n in re.findall(r"^### Eq\. \((\d+)\)", text, re.MULTILINE)]
    assert order == list(range(12, 44))
    for table in ("### Table 1", "Table 2", "### Table 3", "### Tables 4 and 5"):
        assert table in text


def test_a_machine_that_is_not_the_papers_has_its_own_order_of_sections() -> None:
    assert "Sect. 3.2" not in page("five_axis")
    assert "\n## Motion equations\n" in page("five_axis")


def test_the_singular_points_are_told() -> None:
    """Beside the system, beside its solution, and beside its kernel in the table."""
    for number in (17, 20):
        section = page("dmu60p").split(f"### Eq. ({number})")[1].split("\n### ")[0]
        assert "the rank is 2, less than the 3 unknowns" in section
    assert "the rank is 2" in page("dmu60p").split("| `system_3` |")[1].split("\n")[0]
    assert page("dmu60p").count("the rank is") == 3


def test_what_cannot_be_determined_is_told() -> None:
    section = page("dmu60p").split("## What these runs cannot determine")[1].split("\n## ")[0]
    for name in ("eps_xy", "eps_xz", "eps_yz"):
        assert name in section


def test_lengths_under_one_cosine_stand_in_one_bracket() -> None:
    """cos(b) (q_S + q_T + r), not cos(b) q_S + cos(b) q_T + cos(b) r."""
    alone = re.compile(r"\\(cos|sin)\((\w)\) ((?:q_\{\w)|r_)[\w{}]*(x|y|z)\}")
    for maths in blocks(page("five_axis")):
        for row in re.split(r"\\\\\n(?!&\\quad)", maths):
            found = [(m[1], m[2], m[4]) for m in alone.finditer(row)]
            by_error = [row[m.end() :].split("+")[0].split("-")[0].strip() for m in alone.finditer(row)]
            both = list(zip(found, by_error, strict=True))
            assert len(set(both)) == len(both), row


def test_a_machine_of_one_linear_axis_has_no_squareness() -> None:
    assert "## Squareness of the axes" not in page("all on the workpiece side")
    assert "## Squareness of the axes" in page("shared")


def test_rotary_functions_read_unambiguously() -> None:
    assert r"\cos(c) d_x" in page("five_axis")
    assert "92.3" in page("five_axis")
