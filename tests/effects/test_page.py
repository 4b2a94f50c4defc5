"""docs/effects.md is what the library says."""

import re
import subprocess
import sys

from tests.machines import ROOT
from trueaxis.effects.library import KINDS
from trueaxis.effects.placement import VARIABLES

PAGE = ROOT / "docs" / "effects.md"


def test_the_page_is_current() -> None:
    done = subprocess.run([sys.executable, "-m", "trueaxis.effects.page"], capture_output=True, check=True)
    command = "python -m trueaxis.effects.page > docs/effects.md"
    assert done.stdout == PAGE.read_bytes(), f"the library has changed; run: {command}"


def test_every_kind_and_variable_has_its_row_and_tables_are_whole() -> None:
    text = PAGE.read_text(encoding="utf-8")
    for name in (*(kind.name for kind in KINDS), *VARIABLES):
        assert len(re.findall(rf"^\| `{name}` \|", text, re.MULTILINE)) >= 1, name
    for table in re.findall(r"(?:^\|.*\n)+", text, re.MULTILINE):
        assert len({line.count("|") for line in table.splitlines()}) == 1, table
