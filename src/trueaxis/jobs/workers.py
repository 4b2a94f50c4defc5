"""Who does the work, as a user asks for it."""

from trueaxis.cluster.embedded import LEAST_MEMORY
from trueaxis.cluster.workers import MOST_WORKERS, Workers
from trueaxis.io.faults import Fault, InputError
from trueaxis.jobs.given import Spelled, argument

GB = 10**9  # bytes


def workers_of(workers: int | None, memory: float | None, scheduler: str | None) -> Workers:
    """workers: processes on this computer; memory: GB of each; scheduler: an address; None: not given.

    Raises ValueError for numbers out of their range, InputError for what does not go together.
    """
    if memory is not None and not LEAST_MEMORY <= memory * GB < float("inf"):
        raise ValueError(f"memory: expected GB, at least {LEAST_MEMORY / GB:g}; given {memory}")
    if workers is not None and not (isinstance(workers, int) and 1 <= workers <= MOST_WORKERS):
        raise ValueError(f"workers: expected a whole number from 1 to {MOST_WORKERS}; given {workers}")
    if faults := faults_of_workers(scheduler, workers=workers, memory=memory):
        raise InputError(faults)
    return Workers(count=workers, memory=None if memory is None else int(memory * GB), scheduler=scheduler)


def faults_of_workers(scheduler: str | None, spelled: Spelled = argument, **here: float | None) -> list[Fault]:
    """What does not go together. here: what was given of workers of this computer, by argument, None: not given."""
    if scheduler is None:
        return []
    remedy = f"leave it out, or {spelled('scheduler')}"
    problem = "is of workers on this computer; those of a scheduler are as they were started"
    return [Fault(spelled(name), "", problem, remedy) for name, value in here.items() if value is not None]
