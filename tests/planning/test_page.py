"""docs/plan.md shows what the command prints."""

import re
import shlex
from collections.abc import Iterator

import pytest

from tests.planning.data import ROOT
from trueaxis.cli.main import main

PAGE = ROOT / "docs" / "plan.md"


def shown() -> Iterator[tuple[str, list[list[str]]]]:
    """Commands and the parts of their output between the dots."""
    for command, text in re.findall(r"^```console\n\$ trueaxis (.*)\n((?:.*\n)*?)```$", PAGE.read_text(), re.MULTILINE):
        parts = [part.splitlines() for part in re.split(r"^\.\.\.\n", text, flags=re.MULTILINE) if part.strip()]
        yield command, parts


def test_the_page_has_commands() -> None:
    assert len(list(shown())) >= 4


@pytest.mark.parametrize("command", dict.fromkeys(command for command, _ in shown()))
def test_output_is_as_shown(command: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(ROOT)
    assert main(shlex.split(command)) == 0
    printed = capsys.readouterr().out.splitlines()
    for parts in [parts for one, parts in shown() if one == command]:
        start = 0
        for part in parts:
            places = [i for i in range(start, len(printed)) if printed[i : i + len(part)] == part]
            assert places, f"not printed: {part[0]}"
            start = places[0] + len(part)
