"""Start the Python that runs this program once more, with an import path on which no data folder lies."""

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
