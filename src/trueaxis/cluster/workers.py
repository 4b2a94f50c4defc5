"""Worker processes: those of this computer, or those of a Dask scheduler that runs already.

On this computer there is nothing to set up, no port that another computer reaches, nothing printed. A worker is a
process with one thread, watched by a nanny: who dies or takes more memory than its share is started again.

Dask's own messages reach nobody: what a user must know of lost workers is told by who gave them work.
"""

import asyncio
import logging
import os
import signal
import socket
import sys
import tempfile
import warnings
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Any
from urllib.parse import urlsplit

from trueaxis.import_path import without_current_folder
from trueaxis.io.faults import Fault, InputError
from trueaxis.own_python import cores

MOST_WORKERS = 1024  # of one computer
PACKAGES = ("dask", "distributed")
LOOPBACK = "127.0.0.1"
# A task that has taken so many workers with it is given up. One loss may be another program's fault, and workers wait
# for tasks one at a time, so that no task is blamed for its neighbour.
WORKERS_LOST = 3
LEAST_MEMORY = 500_000_000  # bytes of a worker: twice what one takes that has loaded the program
MEMORY_SHARE = 0.95  # of a worker's memory: from there on it is ended, before the system has to choose a process

# OpenBLAS and its like: one thread, as in the command itself; the last digits depend on the number of threads.
# PYTHONSAFEPATH: a new process imports nothing from the current folder, which holds data. DASK_LOGGING: what a worker
# says before it is silent, and PYTHONWARNINGS what it warns of, such as a disk that is slow when it is started anew.
# Threads and import path must be in the environment before a process starts.
ENVIRONMENT = {
    "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1", "VECLIB_MAXIMUM_THREADS": "1",
    "PYTHONSAFEPATH": "1", "DASK_LOGGING__DISTRIBUTED": "critical", "PYTHONWARNINGS": "ignore",
}  # fmt: skip

_CONFIGURATION = {
    "distributed.scheduler.allowed-failures": WORKERS_LOST - 1,
    "distributed.scheduler.worker-saturation": 1.0,
    "distributed.scheduler.http.routes": [],
    "distributed.worker.http.routes": [],
    "distributed.worker.preload": [__name__],  # for `dask_setup`
    "distributed.worker.memory.target": False,
    "distributed.worker.memory.spill": False,
    "distributed.worker.memory.pause": False,
    "distributed.worker.memory.terminate": MEMORY_SHARE,
}
SECONDS = 5.0  # for an answer: on a network that works it takes milliseconds
OPTION = "--scheduler"
PROTOCOLS = ("tcp", "tls")
_RIGHT = "an address such as tcp://192.168.0.10:8786, as the scheduler prints it when it starts"
_LOGGERS = ("distributed", "tornado", "asyncio")
_SILENT = logging.CRITICAL + 1


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
        with _running_client(workers.scheduler) as client:
            yield client
    else:
        with _embedded_client(workers.count or cores(), workers.memory) as client:
            yield client


@contextmanager
def _embedded_client(count: int, memory: int | None) -> Iterator[Any]:
    """A client of so many workers. memory: bytes of each, None: that of the computer in equal parts."""
    with ExitStack() as stack:
        stack.enter_context(_workers_environment())
        folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="trueaxis-", ignore_cleanup_errors=True))
        stack.enter_context(quiet())
        import dask  # noqa: PLC0415  an extra, and half a second
        from distributed import Client, Nanny, Scheduler, SpecCluster  # noqa: PLC0415
        from distributed.system import MEMORY_LIMIT  # noqa: PLC0415

        stack.enter_context(dask.config.set({**_CONFIGURATION, "temporary-directory": folder}))
        share = MEMORY_LIMIT // count
        if memory is None and share < LEAST_MEMORY:
            problem = f"{count} of them have {share / 1e9:.2g} GB of memory each"
            raise InputError([Fault("workers", "", problem, f"{max(1, MEMORY_LIMIT // LEAST_MEMORY)} at most")])
        # an HTTP server there must be; this one has nothing to show
        http = {"dashboard": False, "dashboard_address": f"{LOOPBACK}:0"}
        options = {"nthreads": 1, "memory_limit": memory or share, "host": LOOPBACK, **http}
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # of this process's nannies, as of the workers
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


@contextmanager
def _workers_environment() -> Iterator[None]:
    """The environment that new processes get, in this process meanwhile; Dask's nannies leave theirs in it for good."""
    before = dict(os.environ)
    os.environ.update(ENVIRONMENT)
    if given := before.get("PYTHONPATH"):
        os.environ["PYTHONPATH"] = os.pathsep.join(without_current_folder(given.split(os.pathsep)))
    try:
        yield
    finally:
        for name in os.environ.keys() - before.keys():
            del os.environ[name]
        os.environ.update(before)


@contextmanager
def _running_client(address: str) -> Iterator[Any]:
    """A client of the scheduler at that address. Raises InputError where none answers there, or it has no workers."""
    host, port = _host_and_port(address)
    try:  # Dask would try again and again
        socket.create_connection((host, port), SECONDS).close()
    except OSError as error:
        raise _fault(address, f"nothing answers there: {error.strerror or error}") from None
    with quiet():
        from distributed import Client  # noqa: PLC0415  an extra, and half a second

        try:
            asyncio.run(asyncio.wait_for(_identity(address), SECONDS))
        except (OSError, TimeoutError, ValueError) as error:  # another service, or another protocol
            problem = f"no Dask scheduler answers there within {SECONDS:g} s ({type(error).__name__})"
            raise _fault(address, problem) from None
        with Client(address, timeout=SECONDS, set_as_default=False) as client:
            try:
                client.wait_for_workers(1, timeout=SECONDS)
            except TimeoutError:
                raise _fault(address, "has no workers", f"start some: dask worker {address}") from None
            yield client


async def _identity(address: str) -> object:
    """What a scheduler says of itself. A client would wait for a service that never answers without end."""
    from distributed.core import connect  # noqa: PLC0415  as above
    from distributed.security import Security  # noqa: PLC0415

    comm = await connect(address, timeout=SECONDS, **Security().get_connection_args("client"))
    try:
        await comm.write({"op": "identity", "reply": True})
        return await comm.read()
    finally:
        comm.abort()


def _host_and_port(address: str) -> tuple[str, int]:
    try:
        parts = urlsplit(address if "://" in address else f"tcp://{address}")
        host, port = parts.hostname, parts.port
    except ValueError:
        raise _fault(address, "is no address") from None
    if not host or not port or parts.scheme not in PROTOCOLS:
        raise _fault(address, "is no address")
    return host, port


def _fault(address: str, problem: str, remedy: str = _RIGHT) -> InputError:
    return InputError([Fault(f"{OPTION} {address}", "", problem, remedy)])


@contextmanager
def quiet() -> Iterator[None]:
    """Import Dask and silence its loggers in this process, all below _LOGGERS.

    Where the process had imported it for something else they are as before afterwards; else they stay silent, so that
    nothing is heard of what Dask clears away at the end of an interrupted process.
    """
    foreign = "distributed" in sys.modules and logging.getLogger("distributed").level != _SILENT
    import distributed  # noqa: F401, PLC0415  it sets its loggers when it is imported

    known = [name for name in logging.root.manager.loggerDict if name.split(".")[0] in _LOGGERS]
    before = {name: logging.getLogger(name).level for name in {*_LOGGERS, *known}}
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
