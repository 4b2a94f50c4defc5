"""Loaded by each worker of this computer as it starts: it says nothing, and an interrupt is for the first process."""

import os
import signal
from typing import Any

from trueaxis.cluster.quiet import NAMES  # noqa: F401  the package is found before any task asks for it


def dask_setup(_: Any) -> None:
    """Called by the worker. Standard output and error go nowhere: what a task has to tell is in its result."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (1, 2):
        os.dup2(nowhere, stream)
    os.close(nowhere)
