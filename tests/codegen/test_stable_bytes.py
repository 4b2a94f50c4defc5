"""The same spec gives the same bytes, whatever the order in which Python's sets happen to run."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.derivation.test_routine import models
from tests.machines import ROOT
from trueaxis.codegen.render import render

SEEDS = ("0", "12345")  # beside that of this process
PROGRAM = "from tests.codegen.test_stable_bytes import digests; print(digests(), end='')"


def digests() -> str:
    """A line for every file of the machines."""
    return "".join(
        f"{name} {file} {hashlib.sha256(content).hexdigest()}\n"
        for name, model in models().items()
        for file, content in render(model).items()
    )


def test_files_have_the_same_bytes_under_every_hash_seed() -> None:
    running = []
    for seed in SEEDS:
        path = os.pathsep.join([str(ROOT / "src"), str(ROOT)])
        environment = os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": path}
        command = [sys.executable, "-c", PROGRAM]
        running.append(subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment, cwd=ROOT))
    here = digests()
    found = [process.communicate()[0] for process in running]
    assert all(process.returncode == 0 for process in running)
    assert here.count("\n") == 14
    assert found == [here] * len(SEEDS)


@pytest.mark.parametrize("name", ["dmu60p", "five_axis"])
def test_no_file_tells_when_where_or_by_whom_it_was_made(name: str) -> None:
    here = str(Path.home())
    for file, content in render(models()[name]).items():
        text = content.decode()
        for word in (here, str(ROOT), "/tmp", os.uname().nodename, sys.version.split()[0]):
            assert word not in text, file
        assert text.endswith("\n")
        assert "\r" not in text
        assert not [line for line in text.splitlines() if line != line.rstrip()], file
