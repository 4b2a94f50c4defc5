"""The tutorials of docs/tutorials, run as a reader does."""

import json
import tomllib
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft7Validator

from tests import tutorials
from tests.machines import ROOT
from trueaxis.schemas.__main__ import schemas

FOLDER = ROOT / "docs" / "tutorials"
PAGES = sorted(path.stem for path in FOLDER.glob("*.md") if path.name != "README.md")
WITH_FILES = {"laser_to_control"}  # begins with a folder of files: tests/laser_to_control runs it


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted({*PAGES} - WITH_FILES))
def test_every_step_does_what_the_page_says(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert tutorials.run((FOLDER / f"{name}.md").read_text(encoding="utf-8"), tmp_path) >= 5
    files = [path for path in sorted(tmp_path.rglob("*")) if path.suffix in (".toml", ".json")]
    files = [path for path in files if path.name != "manifest.json"]
    assert len(files) >= 3
    for path in files:  # what is written by hand and by commands is what editors are told to expect
        schema = schemas()[f"{kind_of(path)}.schema.json"]
        assert list(Draft7Validator(schema).iter_errors(tree_of(path))) == [], path


def test_programs_of_three_controls_come_out_as_the_page_says(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert tutorials.run((ROOT / "docs" / "how-to" / "programs.md").read_text(encoding="utf-8"), tmp_path) == 4
    for name in ("plate_c.nc", "plate_c.mpf", "plate_c.h"):
        assert "TRUEAXIS COMPENSATED" in (tmp_path / name).read_text()


def kind_of(path: Path) -> str:
    if path.suffix == ".json":
        return "diagnosis" if path.name == "diagnosis.json" else "errors"
    return "setup" if path.name == "setup.toml" else "machine"


def tree_of(path: Path) -> Any:
    text = path.read_text(encoding="utf-8")
    return json.loads(text) if path.suffix == ".json" else tomllib.loads(text)


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
