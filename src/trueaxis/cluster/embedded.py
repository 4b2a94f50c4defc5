"""Workers on this computer: nothing to set up, no port that another computer reaches, nothing printed.

A worker is a process with one thread, watched by a nanny: who dies or takes more memory than its share is started
again.
"""

import os
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import Any

from trueaxis.cluster.quiet import quiet
from trueaxis.import_path import without_current_folder
from trueaxis.io.faults import Fault, InputError

LOOPBACK = "127.0.0.1"
# A task that has taken so many workers with it is given up. One loss may be another program's fault, and workers wait
# for tasks one at a time, so that no task is blamed for its neighbour.
WORKERS_LOST = 3
LEAST_MEMORY = 500_000_000  # bytes of a worker: twice what one takes that has loaded the program
MEMORY_SHARE = 0.95  # of a worker's memory: from there on it is ended, before the system has to choose a process
# OpenBLAS and its like: one thread, as in the command itself; the last digits depend on the number of threads.
# PYTHONSAFEPATH: a new process imports nothing from the current folder, which holds data. DASK_LOGGING: what a worker
# says before it is silent.
ENVIRONMENT = {
    "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1", "VECLIB_MAXIMUM_THREADS": "1",
    "PYTHONSAFEPATH": "1", "DASK_LOGGING__DISTRIBUTED": "critical",
}  # fmt: skip
_CONFIGURATION = {
    "distributed.scheduler.allowed-failures": WORKERS_LOST - 1,
    "distributed.scheduler.worker-saturation": 1.0,
    "distributed.scheduler.http.routes": [],
    "distributed.worker.http.routes": [],
    "distributed.worker.preload": ["trueaxis.cluster.quiet_worker"],
    "distributed.worker.memory.target": False,
    "distributed.worker.memory.spill": False,
    "distributed.worker.memory.pause": False,
    "distributed.worker.memory.terminate": MEMORY_SHARE,
}


@contextmanager
def embedded_client(count: int, memory: int | None) -> Iterator[Any]:
    """A client of so many workers. memory: bytes of each, None: that of the computer in equal parts."""
    environment = dict(ENVIRONMENT)
    if given := os.environ.get("PYTHONPATH"):
        environment["PYTHONPATH"] = os.pathsep.join(without_current_folder(given.split(os.pathsep)))
    with ExitStack() as stack:
        folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="trueaxis-", ignore_cleanup_errors=True))
        stack.enter_context(quiet())
        import dask  # noqa: PLC0415  an extra, and half a second
        from distributed import Client, Nanny, Scheduler, SpecCluster  # noqa: PLC0415
        from distributed.system import MEMORY_LIMIT  # noqa: PLC0415

        own = {"distributed.nanny.pre-spawn-environ": environment, "temporary-directory": folder}
        stack.enter_context(dask.config.set({**_CONFIGURATION, **own}))
        share = MEMORY_LIMIT // count
        if memory is None and share < LEAST_MEMORY:
            problem = f"{count} of them have {share / 1e9:.2g} GB of memory each"
            raise InputError([Fault("workers", "", problem, f"{max(1, MEMORY_LIMIT // LEAST_MEMORY)} at most")])
        # an HTTP server there must be; this one has nothing to show
        http = {"dashboard": False, "dashboard_address": f"{LOOPBACK}:0"}
        options = {"nthreads": 1, "memory_limit": memory or share, "host": LOOPBACK, **http}
        try:
            cluster = SpecCluster(
                scheduler={"cls": Scheduler, "options": {"host": LOOPBACK, "port": 0, **http}},
                workers={number: {"cls": Nanny, "options": options} for number in range(count)},
                silence_logs=False,
            )
        except RuntimeError as error:
            remedy = 'a script that asks for workers does so under `if __name__ == "__main__":`'
            raise InputError([Fault("workers", "", f"cannot be started: {error}", remedy)]) from None
        stack.enter_context(cluster)
        yield stack.enter_context(Client(cluster, set_as_default=False))
