"""Dask's own messages reach nobody: what a user must know of lost workers is told by who gave them work."""

import logging
from collections.abc import Iterator
from contextlib import contextmanager

NAMES = ("distributed", "tornado", "asyncio")
_SILENT = logging.CRITICAL + 1


@contextmanager
def quiet() -> Iterator[None]:
    """Silence the loggers of Dask in this process, all below NAMES; they are as before afterwards."""
    known = [name for name in logging.root.manager.loggerDict if name.split(".")[0] in NAMES]
    before = {name: logging.getLogger(name).level for name in {*NAMES, *known}}
    for name in before:
        logging.getLogger(name).setLevel(_SILENT)
    try:
        yield
    finally:
        for name, level in before.items():
            logging.getLogger(name).setLevel(level)
