"""What the documentation site is built with: formulas, links to files of the repository, pages that are made."""

import re

import pytest
from markdown import Markdown
from pymdownx.superfences import SuperFencesException

from docs.hooks import formulas, made_pages, repository
from tests.machines import ROOT
from trueaxis import __all__ as public
from trueaxis.cli.main import COMMANDS


def rendered(text: str) -> str:
    return str(Markdown(extensions=["docs.hooks.formulas", "tables"]).convert(text))


def test_formulas_in_sentences_become_mathml() -> None:
    assert "<math" in rendered("the error $\\delta_x(x)$ of X")
    assert rendered("$`a\\,b_{h}`$ and $`c_{h}`$").count("<math") == 2
    assert "<em>" not in rendered("$`[S]_{p}\\,a`$, $`[T]_{p}`$")


@pytest.mark.parametrize("text", ["($XDG_CACHE_HOME or `~/.cache`)", "`$a$`", "it costs 3 $ and 4 $", "no $M or $PLAN"])
def test_other_dollars_stay(text: str) -> None:
    assert "<math" not in rendered(text)


def test_columns_are_aligned_and_matrices_have_brackets() -> None:
    made = formulas.block(
        "\\begin{aligned} A &= \\begin{bmatrix} 1 & 0 \\\\ 0 & 1 \\end{bmatrix} \\\\ b &= c \\end{aligned}"
    )
    assert made.count("<mtr>") == 4
    assert 'columnalign="right"' in made
    assert made.count('class="bracketed"') == 1


def test_what_the_converter_does_not_know_ends_the_build() -> None:
    with pytest.raises(SuperFencesException, match="nonsense"):
        formulas.block("a \\nonsense b")


def test_links_of_the_repository_lead_to_pages() -> None:
    assert repository.resolved("../machines/dmu60p.toml", "docs/machine.md") == "machines/dmu60p.toml"
    assert repository.resolved("files.md", "docs/machine.md") == "docs/files.md"
    assert repository.resolved("../../etc", "docs/machine.md") is None
    assert repository.site_uri("README.md") == "index.md"
    assert repository.site_uri("docs/files.md") == "files.md"
    assert repository.site_uri("machines/dmu60p.toml") == "repository/machines/dmu60p.toml.md"
    assert "`derivation/`" in repository.shown("src/trueaxis")
    assert "# The paper's machine" in repository.shown("docs/notebooks/paper_machine.ipynb")


def test_the_reference_has_every_command_option_and_name() -> None:
    page = made_pages.commands_page()
    assert re.findall(r"^## trueaxis (\w+)$", page, re.M) == list(COMMANDS)
    assert "`--max-correction MM`" in page
    python = made_pages.python_page()
    assert sorted(re.findall(r"^::: [\w.]+\.(\w+)$", python, re.M)) == sorted(public)


def test_every_link_of_a_document_leads_somewhere() -> None:
    documents = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), ROOT / "benchmarks" / "README.md"]
    broken = [
        f"{path.relative_to(ROOT)}: {link}"
        for path in documents
        for link in re.findall(r"\]\(([^)\s#]+)", re.sub(r"^```.*?^```$", "", path.read_text(), flags=re.M | re.S))
        if "://" not in link and not (path.parent / link).exists()
    ]
    # made when the site is built
    assert [one for one in broken if not one.endswith(("reference/commands.md", "reference/python.md"))] == []


def test_lists_begin_after_an_empty_line() -> None:
    """Else the site goes on with the sentence or the table before."""
    for path in [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), ROOT / "benchmarks" / "README.md"]:
        text = re.sub(r"^```.*?^```$", "", path.read_text(), flags=re.M | re.S)
        for block in re.split(r"\n\s*\n", text):
            first, *rest = block.strip("\n").split("\n")
            if not re.match(r" *(- |\d+\. |#)", first):
                assert [line for line in rest if re.match(r"(- |1\. )", line)] == [], path
            if re.match(r" +\|", first):
                assert [line for line in rest if not line.startswith(" ")] == [], path
