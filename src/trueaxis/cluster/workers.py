"""Worker processes: those of this computer, or those of a Dask scheduler that runs already."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Any

from trueaxis.cluster.embedded import embedded_client
from trueaxis.cluster.running import running_client
from trueaxis.io.faults import Fault, InputError

MOST_WORKERS = 1024  # of one computer
PACKAGES = ("dask", "distributed")


@dataclass(frozen=True, slots=True, kw_only=True)
class Workers:
    """Who does the work. count: processes on this computer, None: one for each of its cores; memory: bytes that each
    may use, None: that of the computer in equal parts; scheduler: the address of a running one, which has workers of
    its own, None: those of this computer.
    """

    count: int | None = None
    memory: int | None = None
    scheduler: str | None = None


@contextmanager
def client_of(workers: Workers) -> Iterator[Any]:
    """A dask.distributed.Client of workers that are ready.

    Raises InputError where Dask is not installed, or the scheduler does not answer or has no workers.
    """
    if missing := [name for name in PACKAGES if find_spec(name) is None]:
        remedy = "pip install 'trueaxis[cluster]'"
        raise InputError([Fault(f"package {' and '.join(missing)}", "", "is not installed", remedy)])
    if workers.scheduler is not None:
        with running_client(workers.scheduler) as client:
            yield client
    else:
        with embedded_client(workers.count or cores(), workers.memory) as client:
            yield client


def cores() -> int:
    """Those that this process may use, where the system says so."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
