"""Commands that begin where theirs have loaded their libraries: forks of a process that has loaded them once for all.

A fork is a process of its own with its own streams, signals and end. What it skips is what takes most of the time of
a command with small inputs, Python's own start and imports. `command_lines.run` is how users start a command.
"""

import ctypes
import gc
import json
import os
import pkgutil
import subprocess
import sys
from collections.abc import Mapping
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from signal import Signals
from typing import Any

from tests.command_lines import WITH_ITS_PARENT, words_of
from tests.machines import ROOT

# what commands import where they need it
LIBRARIES = ("matplotlib.figure", "scipy.optimize", "scipy.interpolate", "statsmodels.api", "sympy", "jinja2")


class Loaded:
    """The process that has loaded everything; one command of it runs at a time."""

    def __init__(self) -> None:
        code = WITH_ITS_PARENT + "from tests.loaded import serve; serve()"
        self.process = subprocess.Popen(
            [sys.executable, "-c", code], cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def close(self) -> None:
        self.process.communicate()

    def start(self, folder: Path, words: str, told: Path, env: Mapping[str, str]) -> "Command":
        """A command in a folder. told: the file that gets what it says on standard error."""
        assert self.process.stdin is not None
        told.touch()
        request = {"folder": str(folder), "words": words_of(words.split()), "told": str(told), "env": dict(env)}
        print(json.dumps(request), file=self.process.stdin, flush=True)
        return Command(self, int(self.line()), told)

    def line(self) -> str:
        assert self.process.stdout is not None
        return self.process.stdout.readline()


class Command:
    """As much of subprocess.Popen as tests need."""

    def __init__(self, loaded: Loaded, number: int, told: Path) -> None:
        self.loaded, self.number, self.told = loaded, number, told

    def send_signal(self, number: Signals) -> None:
        with suppress(ProcessLookupError):
            os.kill(self.number, number)

    def ended(self) -> tuple[int, str]:
        """Waits; exit code, negative for a signal, and what was said on standard error."""
        return int(self.loaded.line()), self.told.read_text()


def serve() -> None:
    """Start what standard input asks for, one after the other, and tell the number of each process and its end."""
    import trueaxis

    for module in pkgutil.walk_packages(trueaxis.__path__, "trueaxis."):
        if not module.name.endswith("__main__"):
            import_module(module.name)
    for name in LIBRARIES:
        import_module(name)
    gc.collect()
    gc.freeze()  # else each fork looks at all of it, and copies it, when it collects and when it ends
    while line := sys.stdin.readline():
        number = os.fork()
        if number == 0:
            _become(json.loads(line))
        print(number, flush=True)
        print(os.waitstatus_to_exitcode(os.waitpid(number, 0)[1]), flush=True)


def _become(request: Mapping[str, Any]) -> None:
    """The command, which ends the process."""
    from trueaxis.__main__ import main

    os.setsid()
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(1, 9)  # see WITH_ITS_PARENT
    os.chdir(request["folder"])
    os.environ.update(request["env"])
    for number, path in enumerate((os.devnull, os.devnull, request["told"])):
        opened = os.open(path, os.O_RDWR)
        os.dup2(opened, number)
        os.close(opened)
    sys.argv = ["trueaxis", *request["words"]]
    sys.exit(main())
