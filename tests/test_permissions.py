"""What may not be read or written is a fault of one line; as the superuser, commands are run as another user for it."""

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.command_lines import COMMANDS, command_line, prepare

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="permissions of POSIX")
NOBODY = 65534
LOWER = {"user": NOBODY, "group": NOBODY} if hasattr(os, "geteuid") and os.geteuid() == 0 else {}


@pytest.fixture
def folder() -> Iterator[Path]:
    """Inputs in a folder that another user may enter; all of it is given to that user."""
    place = Path(tempfile.mkdtemp())
    place.chmod(0o755)
    prepare(place / "in")
    for path in (place, *place.rglob("*")):
        if LOWER:
            os.chown(path, NOBODY, NOBODY)
    words = [*command_line("evaluate test.csv")]
    if subprocess.run(words, cwd=place / "in", capture_output=True, check=False, **LOWER).returncode:  # type: ignore[call-overload]
        shutil.rmtree(place)
        pytest.skip("another user may not run this Python")
    yield place
    for path in place.rglob("*"):
        path.chmod(0o755)
    shutil.rmtree(place)


@pytest.mark.slow
def test_each_is_one_line(folder: Path) -> None:
    def fault(name: str, mode: int, path: Path) -> str:
        before = path.stat().st_mode
        path.chmod(mode)
        done = subprocess.run(
            command_line(COMMANDS[name].format(out=folder / "out")), cwd=folder / "in", capture_output=True,
            env={**os.environ, "HOME": str(folder)}, text=True, check=False, **LOWER,
        )  # type: ignore[call-overload]  # fmt: skip
        path.chmod(before)
        assert done.returncode == 2, done.stderr
        (line,) = done.stderr.splitlines()
        return str(line)

    def read_fault(name: str, path: str) -> None:
        line = fault(name, 0o200, folder / "in" / path)
        assert line.startswith(f"trueaxis: {path}: cannot be read: Permission denied")

    read_fault("predict", "m.toml")
    read_fault("predict", "points.parquet")
    read_fault("fit", "tables.json")
    read_fault("compensate", "e.json")
    assert "part.nc: Permission denied" in fault("compensate", 0o200, folder / "in" / "part.nc")
    (folder / "out").mkdir(mode=0o777)
    (folder / "out").chmod(0o777)
    (folder / "out" / "p.csv").write_text("kept")
    line = fault("predict", 0o444, folder / "out" / "p.csv")
    assert line == f"trueaxis: {folder}/out/p.csv: Permission denied"
    assert fault("predict", 0o555, folder / "out").startswith(f"trueaxis: {folder}/out/p.csv: Permission denied")
    assert "Permission denied" in fault("predict", 0o000, folder / "out")
    assert (folder / "out" / "p.csv").read_text() == "kept"
    for closed in (0o000, 0o666):
        assert "Permission denied" in fault("identify", closed, folder / "in" / "data")
