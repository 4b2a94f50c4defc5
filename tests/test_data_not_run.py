"""A folder that holds data is on no import path: modules that lie in it are never run."""

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.command_lines import COMMANDS, command_line, run
from tests.hostile import EVIL, MODULES, make_hostile, run_of
from tests.machines import ROOT
from trueaxis.import_path import without_current_folder
from trueaxis.own_python import own_python


@pytest.fixture(scope="module")
def hostile(prepared: Path) -> Path:
    names = ("dmu60p_runs", "small_runs", "data", "out")
    make_hostile(prepared, *(prepared / name for name in names))
    return prepared


@pytest.fixture
def evidence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    path = tmp_path / "evidence"
    monkeypatch.setenv("EVIDENCE", str(path))
    yield path
    assert run_of(path) == []


@pytest.mark.parametrize("name", COMMANDS)
@pytest.mark.usefixtures("evidence")
def test_no_command_runs_modules_of_its_folder(hostile: Path, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    # variables with empty entries, which mean the current folder, and a backend that is no module of ours
    monkeypatch.setenv("PATH", f":{os.environ['PATH']}:.")
    monkeypatch.setenv("TRUEAXIS_CACHE", str(hostile / "cache"))  # the first that needs kernels compiles them here
    monkeypatch.setenv("CPATH", ":")
    monkeypatch.setenv("MPLBACKEND", "module://evil")
    done = run(hostile, COMMANDS[name].format(out="out"))
    assert done.returncode in (0, 1), done.stderr
    assert "cannot be compiled" not in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.usefixtures("evidence")
def test_the_folder_of_a_module_run_is_left_out_too(hostile: Path, tmp_path: Path) -> None:
    """`python -m trueaxis`: what Python itself imports on the way is its own; the rest is not taken from here."""
    of_python = _imported_to_run_a_module()
    for name in MODULES:
        if name not in of_python:
            (tmp_path / f"{name}.py").write_text(EVIL)
    (tmp_path / "trueaxis.py").unlink()
    words = [sys.executable, "-m", "trueaxis", "evaluate", str(hostile / "test.csv"), "--picture", "t.png"]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def _imported_to_run_a_module() -> set[str]:
    code = "import sys, runpy, pkgutil; print(' '.join(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(done.stdout.split())


@pytest.mark.usefixtures("evidence")
def test_an_empty_entry_of_the_import_path_means_no_folder(
    hostile: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "polars.py").write_text(EVIL)
    (tmp_path / "numpy.py").write_text(EVIL)
    monkeypatch.setenv("PYTHONPATH", f":{ROOT / 'src'}")
    at = f"--errors {hostile / 'e.json'} --at {hostile / 'points.parquet'}"
    done = run(tmp_path, f"predict {hostile / 'm.toml'} {at} --out p.csv")
    assert done.returncode == 0, done.stderr


def test_our_own_processes_keep_the_rest_of_the_path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "library").mkdir()
    (tmp_path / "library" / "of_the_user.py").write_text("NUMBER = 7\n")
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PYTHONPATH", "library")
    code = "import of_the_user, sys; sys.exit(of_the_user.NUMBER)"
    with own_python("-c", code, cwd=tmp_path / "elsewhere") as process:
        assert process.wait() == 7


def test_only_the_current_folder_goes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "sub").mkdir()
    (tmp_path / "link").symlink_to(tmp_path)
    monkeypatch.chdir(tmp_path)
    entries = ["", ".", str(tmp_path), str(tmp_path / "link"), "sub", "/no/such", str(tmp_path / "sub" / "..")]
    entries.append("__editable__.name.finder.__path_hook__")
    assert without_current_folder(entries) == [str(tmp_path / "sub"), "/no/such", entries[-1]]
    monkeypatch.chdir(ROOT / "src")  # else the program could not go on
    assert without_current_folder([""]) == [str(ROOT / "src")]


def test_no_module_starts_processes_by_another_way() -> None:
    # beside.py: constants of subprocess alone; linuxcnc/interpreter.py: LinuxCNC's interpreter
    starters = {"own_python.py", "compiler.py", "beside.py", "interpreter.py"}
    for path in (ROOT / "src").rglob("*.py"):
        text = path.read_text()
        if path.name not in starters:
            for word in ("subprocess.run(", "Popen(", "multiprocessing", "os.system(", "sys.executable"):
                assert word not in text, f"{path}: {word}"


def test_the_command_line_is_that_of_the_script() -> None:
    project = (ROOT / "pyproject.toml").read_text()
    assert 'trueaxis = "trueaxis.__main__:main"' in project
    assert "from trueaxis.__main__ import main" in command_line("derive m.toml")[3]
