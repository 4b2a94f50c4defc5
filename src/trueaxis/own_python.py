"""Processes of the Python that runs this program, on whose import path no data folder lies, and the cores for them."""

import os
import subprocess
import sys
from typing import Any

from trueaxis.import_path import without_current_folder


def own_python(*words: str, **options: Any) -> "subprocess.Popen[bytes]":
    """A process of the same Python. options: of subprocess.Popen, without `env`.

    -P keeps the current folder and that of the script off its import path. Entries of PYTHONPATH are kept as absolute
    paths: a relative one would mean another folder where the process starts in another.
    Raises OSError when there can be no process.
    """
    environment = dict(os.environ)
    if given := environment.get("PYTHONPATH"):
        environment["PYTHONPATH"] = os.pathsep.join(without_current_folder(given.split(os.pathsep)))
    return subprocess.Popen([sys.executable, "-P", *words], env=environment, **options)


def cores() -> int:
    """Those that this process may use, where the system says so."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
