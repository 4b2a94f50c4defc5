"""A second process for work that nothing else waits for."""

import os
import signal
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from functools import partial
from importlib import import_module
from multiprocessing import get_context
from typing import Any

Result = Callable[[], Any]


@contextmanager
def beside(module: str, *, worth: bool = True) -> Iterator[Callable[..., Result]]:
    """Gives start(function, *arguments), which gives what waits for the result of that function of the module.

    The process imports the module while the caller goes on. Where it is not worth it, or there is one core, or no
    process can be had, the function is called here when its result is asked for.
    """
    if not worth or (os.cpu_count() or 1) < 2:
        yield lambda function, *arguments: partial(_called, module, function, *arguments)
        return
    # spawned, not forked: the threads of linear algebra do not survive that
    with ProcessPoolExecutor(1, get_context("spawn"), _ready, (module,)) as pool:
        _submitted(pool, int)

        def start(function: str, *arguments: object) -> Result:
            call = partial(_called, module, function, *arguments)
            future = _submitted(pool, call)
            return call if future is None else partial(_awaited, future, call)

        yield start


def _ready(module: str) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # who interrupts the program hears of it from the first process
    import_module(module)


def _called(module: str, function: str, *arguments: object) -> object:
    return getattr(import_module(module), function)(*arguments)


def _submitted(pool: ProcessPoolExecutor, call: Result) -> "Future[Any] | None":
    try:
        return pool.submit(call)
    except (BrokenProcessPool, OSError):
        return None


def _awaited(future: "Future[Any]", call: Result) -> object:
    try:
        return future.result()
    except BrokenProcessPool:
        return call()
