"""Tasks in an order that they ask for, a bounded number at a time; whatever becomes of one, the others go on."""

import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from trueaxis.io.faults import Fault, InputError

# s: workers come and go, and to ask the scheduler how many there are takes 20 ms, as long as a hundred small tasks
ASK_AGAIN = 1.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """A call of a function of a module. key: its name, unlike all others; after: keys of tasks that must have ended
    before, in whatever way. It may be called again where a worker is lost before it has told that it is done.
    """

    key: str
    function: Callable[..., Any]
    arguments: tuple[Any, ...]
    after: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Ended:
    """A task that has ended. result: what it returned; lost: how often it took its worker with it, 0: it did not;
    error: what it raised.
    """

    key: str
    result: Any = None
    lost: int = 0
    error: BaseException | None = None


def run_tasks(client: Any, tasks: Sequence[Task], ahead: int = 0) -> Iterator[Ended]:
    """Each task once it has ended, in whatever order they end.

    ahead: tasks that wait at each worker while it works: 0 where a task takes seconds and may take its worker with it,
    1 or 2 where tasks are short. Raises InputError where the scheduler is lost.
    """
    from distributed import as_completed  # noqa: PLC0415  an extra, and half a second

    of_key = {task.key: task for task in tasks}
    left = {task.key: {key for key in task.after if key in of_key} for task in tasks}
    followers: dict[str, list[str]] = {}
    for task in tasks:
        for key in left[task.key]:
            followers.setdefault(key, []).append(task.key)
    ready = deque(task.key for task in tasks if not left[task.key])
    running = as_completed([], loop=client.loop)
    keys: dict[Any, str] = {}

    threads, asked_at = 0, -ASK_AGAIN

    def fill() -> None:
        nonlocal threads, asked_at
        if ready and time.monotonic() - asked_at >= ASK_AGAIN:
            threads, asked_at = sum(client.nthreads().values()), time.monotonic()
        while ready and len(keys) < max(1, threads * (1 + ahead)):
            task = of_key[ready.popleft()]
            future = client.submit(task.function, *task.arguments, pure=False)
            keys[future] = task.key
            running.add(future)

    fill()
    for future in running:
        ended = _ended(keys.pop(future), future)
        for key in followers.get(ended.key, ()):
            left[key].discard(ended.key)
            if not left[key]:
                ready.append(key)
        del future  # the scheduler forgets what nobody holds
        fill()
        yield ended


def _ended(key: str, future: Any) -> Ended:
    if future.status == "finished":
        return Ended(key, future.result())
    if future.status != "error":
        problem = "the connection to the scheduler was lost"
        raise InputError([Fault("the scheduler", "", problem, "what is done is kept: run the same command again")])
    from distributed.scheduler import KilledWorker  # noqa: PLC0415  as above

    error = future.exception()
    if isinstance(error, KilledWorker):
        return Ended(key, lost=int(error.allowed_failures) + 1)
    return Ended(key, error=error)
