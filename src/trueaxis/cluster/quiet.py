"""Dask's own messages reach nobody: what a user must know of lost workers is told by who gave them work.

Each worker of this computer loads this as it starts: it says nothing, and an interrupt is for the first process.
"""

import logging
import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

NAMES = ("distributed", "tornado", "asyncio")
_SILENT = logging.CRITICAL + 1


@contextmanager
def quiet() -> Iterator[None]:
    """Import Dask and silence its loggers in this process, all below NAMES.

    Where the process had imported it for something else they are as before afterwards; else they stay silent, so that
    nothing is heard of what Dask clears away at the end of an interrupted process.
    """
    foreign = "distributed" in sys.modules and logging.getLogger("distributed").level != _SILENT
    import distributed  # noqa: F401, PLC0415  it sets its loggers when it is imported

    known = [name for name in logging.root.manager.loggerDict if name.split(".")[0] in NAMES]
    before = {name: logging.getLogger(name).level for name in {*NAMES, *known}}
    for name in before:
        logging.getLogger(name).setLevel(_SILENT)
    try:
        yield
    finally:
        for name, level in before.items() if foreign else ():
            logging.getLogger(name).setLevel(level)


def dask_setup(_: Any) -> None:
    """Called by the worker. Standard output and error go nowhere: what a task has to tell is in its result."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (1, 2):
        os.dup2(nowhere, stream)
    os.close(nowhere)
