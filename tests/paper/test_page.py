"""docs/errata.md says what the data and the computation say."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from . import claims
from .errata import ERRATA
from .mending import Erratum
from .numeric import counterexample

TESTS = Path(__file__).parent
PAGE = (TESTS.parents[1] / "docs" / "errata.md").read_text(encoding="utf-8")
SECTIONS = dict(re.findall(r"^### (E\d+)\n(.*?)(?=^##)", PAGE, re.MULTILINE | re.DOTALL))


def test_page_has_exactly_the_entries() -> None:
    assert list(SECTIONS) == [f"E{e.number}" for e in ERRATA]


@pytest.mark.parametrize("title", claims.TABLES)
def test_tables_are_those_computed(title: str) -> None:
    assert claims.TABLES[title]() in PAGE


@pytest.mark.parametrize("erratum", ERRATA, ids=lambda e: f"E{e.number}")
def test_entry_is_complete(erratum: Erratum) -> None:
    text = " ".join(SECTIONS[f"E{erratum.number}"].split())
    assert erratum.kind.value.split()[0] in text.split("*Printed")[0].lower()
    for part in ("*Printed:*", "*Follows", "*Proof:*"):
        assert part in text
    found = counterexample(erratum, ERRATA)
    if found is None:
        assert "*Test:*" in text or "*Counterexample:*" in text
    else:
        assert "*Counterexample" in text
        row = next(line for line in claims.counterexamples().splitlines() if line.startswith(f"| E{erratum.number} |"))
        number = row.split("|")[3].strip()
        assert number in text


def test_equations_without_entry_are_named() -> None:
    assert ", ".join(f"({n})" for n in claims.agreeing()) in PAGE


def test_named_tests_exist() -> None:
    defined = {name for file in TESTS.glob("test_*.py") for name in re.findall(r"def (test_\w+)", file.read_text())}
    named = set(re.findall(r"`(test_\w+)`", PAGE))
    assert named <= defined
    assert {e.shown_by for e in ERRATA if e.shown_by} <= defined


def test_links_lead_somewhere() -> None:
    headings = re.findall(r"^#+ (.+)$", PAGE, re.MULTILINE)
    anchors = {re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-") for h in headings}
    assert set(re.findall(r"\]\(#([^)]+)\)", PAGE)) <= anchors
