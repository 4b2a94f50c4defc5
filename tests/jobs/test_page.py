"""docs/python.md: its code runs, its table names the functions there are, with their arguments."""

import inspect
import re
import shutil
from pathlib import Path

import pytest

import trueaxis as ta
from tests.machines import ROOT

PAGE = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")


def test_its_code_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("machines", "generated"):
        shutil.copytree(ROOT / name, tmp_path / name)
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    for code in re.findall(r"```python\n(.*?)```", PAGE, re.S):
        exec(compile(code, "python.md", "exec"), names)
    told = capsys.readouterr().out
    off, u = map(float, re.search(r"([\d.e-]+) um off, u up to ([\d.e-]+)", told).groups())  # type: ignore[union-attr]
    assert off < 3.0 * u
    for made in ("errors.npz", "part_compensated.nc", "first_plan/readings.csv", "enc.ini", "errors.html", "mill.toml"):
        assert (tmp_path / made).stat().st_size > 0
    assert "--max-u allows 0.01 um" in told


def test_its_table_has_every_function_and_its_arguments() -> None:
    first_cells = "\n".join(re.findall(r"^\| (`.*?`) \|", PAGE.split("| function")[1], re.M))
    described = dict(re.findall(r"`(\w+)\(([^)]*)\)`", first_cells))
    functions = {name for name in ta.__all__ if inspect.isfunction(getattr(ta, name))}
    assert described.keys() == functions
    for name, arguments in described.items():
        named = [one for one in re.split(r", ", arguments) if one != "..."]
        assert set(named) <= set(inspect.signature(getattr(ta, name)).parameters), name
