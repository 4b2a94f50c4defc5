"""The notebooks of docs/: their cells run, as in a kernel, and what they claim is so; none holds outputs of a machine.

Cells are run by `exec` in one namespace, the last expression of each shown as a notebook would: no kernel is needed.
"""

import ast
import json
import shutil
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pytest

import trueaxis as ta
from tests.machines import ROOT
from trueaxis.cli.main import main

FOLDER = ROOT / "docs" / "notebooks"
NOTEBOOKS = sorted(path.name for path in FOLDER.glob("*.ipynb"))


def cells(name: str) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = json.loads((FOLDER / name).read_text(encoding="utf-8"))["cells"]
    return found


def run(name: str) -> dict[str, Any]:
    """The names that a notebook ends with."""
    names: dict[str, Any] = {}
    for cell in cells(name):
        if cell["cell_type"] != "code":
            continue
        tree = ast.parse("".join(cell["source"]))
        last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, f"{name} {cell['id']}", "exec"), names)
        if isinstance(last, ast.Expr):
            shown = eval(compile(ast.Expression(last.value), f"{name} {cell['id']}", "eval"), names)
            assert getattr(shown, "_repr_html_", str)() or repr(shown)
    plt.close("all")
    return names


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy of what they read, with them in its place."""
    for name in ("machines", "generated", "docs/notebooks"):
        shutil.copytree(ROOT / name, tmp_path / name)
    monkeypatch.chdir(tmp_path / "docs" / "notebooks")
    monkeypatch.setenv("MPLBACKEND", "agg")
    return tmp_path / "docs" / "notebooks"


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_it_holds_no_outputs(name: str) -> None:
    text = json.loads((FOLDER / name).read_text(encoding="utf-8"))
    assert (text["nbformat"], text["nbformat_minor"]) == (4, 5)
    ids = [cell["id"] for cell in text["cells"]]
    assert len(set(ids)) == len(ids) > 5
    code = [cell for cell in text["cells"] if cell["cell_type"] == "code"]
    assert all(cell["outputs"] == [] and cell["execution_count"] is None for cell in code)


def test_they_are_these() -> None:
    assert NOTEBOOKS == ["own_data.ipynb", "paper_machine.ipynb"]


@pytest.mark.slow
def test_the_paper_machine(here: Path) -> None:
    names = run("paper_machine.ipynb")
    assert names["found"].errors.values.fit.state == "converged"
    assert names["rms"]["off, um"] < 2.0 * names["rms"]["stated u, um"]
    assert names["done"].report.good
    assert np.abs(names["estimate"] - names["true"]).max() < 2e-3
    assert (here / "paper_machine" / "part_compensated.nc").exists()


@pytest.mark.slow
def test_own_data_to_a_name(here: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    names = run("own_data.ipynb")
    monkeypatch.chdir(here / "own_data")
    assert names["found"].errors.values.fit.state == "misfit"
    (row,) = names["diagnosis"].to_polars().iter_rows(named=True)
    assert (names["diagnosis"].verdict, row["effect"], row["component"]) == ("explained", "backlash", "EXX")
    assert abs(row["value"] - 0.006) < 3.0 * row["u"]
    assert isinstance(names["values"], ta.Errors)
    capsys.readouterr()
    # a cause that is named: the same files as by the command, the extended machine among them
    assert main(["diagnose", "mill.toml", "--data", "data", "--out", "by_command"]) == 0
    assert capsys.readouterr().out.startswith(str(names["diagnosis"]))
    files = {path.relative_to("diagnosis") for path in Path("diagnosis").rglob("*") if path.is_file()}
    assert {Path("mill.toml"), Path("errors.json"), Path("generated/mill/kernels.py")} <= files
    for file in files:
        assert (Path("by_command") / file).read_bytes() == (Path("diagnosis") / file).read_bytes(), file
