"""A Dask scheduler and its workers, as processes that nobody of ours started."""

import os
import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from tests.machines import ROOT

ENVIRONMENT = os.environ | {"PYTHONPATH": os.pathsep.join([str(ROOT / "src"), str(ROOT)])}


@contextmanager
def process(*words: str) -> Iterator["subprocess.Popen[str]"]:
    command = [sys.executable, "-m", *words]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True, env=ENVIRONMENT) as running:
        try:
            yield running
        finally:
            running.kill()


@contextmanager
def scheduler() -> Iterator[str]:
    """Its address."""
    words = ("--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--dashboard-address", "127.0.0.1:0")
    with process("distributed.cli.dask_scheduler", *words) as running:
        assert running.stderr is not None
        for line in running.stderr:
            if found := re.search(r"Scheduler at:\s+(tcp://\S+)", line):
                yield found[1]
                return


@contextmanager
def worker_processes(address: str) -> Iterator[None]:
    """Two of them, ready."""
    words = ("--nthreads", "1", "--nworkers", "2", "--host", "127.0.0.1", "--no-dashboard")
    with process("distributed.cli.dask_worker", address, *words) as running:
        assert running.stderr is not None
        for _ in range(2):
            next(line for line in running.stderr if "Registered to:" in line)
        yield
