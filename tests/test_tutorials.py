"""The tutorials of docs/tutorials, run as a reader does."""

from pathlib import Path

import pytest

from tests import tutorials
from tests.machines import ROOT

FOLDER = ROOT / "docs" / "tutorials"
PAGES = sorted(path.stem for path in FOLDER.glob("*.md") if path.name != "README.md")


@pytest.mark.slow
@pytest.mark.parametrize("name", PAGES)
def test_every_step_does_what_the_page_says(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert tutorials.run((FOLDER / f"{name}.md").read_text(encoding="utf-8"), tmp_path) >= 5


def test_the_five_are_there_and_the_index_names_them() -> None:
    index = (FOLDER / "README.md").read_text(encoding="utf-8")
    assert len(PAGES) >= 5
    assert [name for name in PAGES if f"({name}.md)" not in index] == []


PAGE = """
```toml title="mill.toml"
schema = 1
```

```console
$ trueaxis derive mill.toml
trueaxis: mill.toml: name: is missing
# exit code 2
```
"""


def test_the_runner_writes_files_and_checks_codes_and_output(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (command,) = tutorials.commands(PAGE.partition("```console\n")[2].partition("```")[0])
    assert command == tutorials.Command(
        ("trueaxis", "derive", "mill.toml"), 2, (("trueaxis: mill.toml: name: is missing",),)
    )
    with pytest.raises(AssertionError, match="ended with 2"):
        tutorials.run(PAGE.replace("# exit code 2\n", ""), tmp_path)
    with pytest.raises(AssertionError, match="does not print"):
        tutorials.run(PAGE, tmp_path)  # the fault has more to say
    assert (tmp_path / "mill.toml").read_text() == "schema = 1\n"


def test_lines_agree_but_for_last_digits() -> None:
    assert tutorials.alike(("u  12.31 um of 50",), ("u 12.3 um  of 50",))
    assert not tutorials.alike(("u 12.9 um",), ("u 12.3 um",))
    assert not tutorials.alike(("u 12.3 mm",), ("u 12.3 um",))
    assert not tutorials.alike(("EXX 1", "EYX 2"), ("EXX 1",))
