"""Draws of tool point errors, in this process or on workers: the same result whoever makes them."""

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np

from trueaxis import __version__
from trueaxis.cluster.tasks import Task, run_tasks
from trueaxis.cluster.workers import LEAST_MEMORY, MOST_WORKERS, Workers, client_of
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files
from trueaxis.jobs.given import Spelled, argument, kernels_of
from trueaxis.machine.machine import Machine
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import FloatArray
from trueaxis.model.errors import ErrorValues
from trueaxis.model.kernels import Kernels, load_kernels
from trueaxis.model.model import MachineModel
from trueaxis.monte_carlo.drawn import Bins, Drawn, Tally, drawn_of
from trueaxis.monte_carlo.kept import dump_kept, kept_name, read_kept
from trueaxis.monte_carlo.points import Drawing, DrawnPoints, with_length
from trueaxis.monte_carlo.settings import MOST_DRAWS, Draws, generators, parts

BLOCK = 2000  # points whose distributions are held at once, 10 kB each; a task of 5000 draws then takes a second
MOST_POINTS = 20_000  # of one block, where all points are needed at once
FIRST_SAMPLE = 1000  # draws from which the ranges of the bins are taken, of few points
FIRST_ENTRIES = 2_000_000  # of all points together; never less than a tenth of the above
AHEAD = 1  # tasks that wait at each worker: they take a second or two
Show = Callable[[str], None]
_LOADED: dict[tuple[str, Path], Kernels] = {}
GB = 10**9  # bytes


def drawn(
    model: MachineModel, points: DrawnPoints, value: FloatArray, u: FloatArray, show: Show = lambda _: None
) -> Drawn:
    """The distribution of the error vectors of points.

    value, u: (3, n), mm, of linear propagation, to be compared with. show: told how far it is. Points are drawn in
    blocks, each with the same draws of the values and its own of noise and context; all at once where a best fit is
    taken off. Raises InputError where there are no workers.
    """
    draws = points.draws
    asked = workers_of(None if draws.scheduler else draws.workers, None, draws.scheduler)
    count = points.positions.shape[1]
    size = BLOCK if points.placements is None else count
    blocks = [slice(start, start + size) for start in range(0, count, size)]
    found = []
    with ExitStack() as stack:
        client = None if asked.count == 1 else stack.enter_context(client_of(asked))
        for number, rows in enumerate(blocks, 1):
            block = f"block {number} of {len(blocks)}, " if len(blocks) > 1 else ""
            of_block = points if len(blocks) == 1 else points.of(rows)
            found.append(_block(model, of_block, value[:, rows], u[:, rows], client, f"draws: {block}", show))
    return Drawn.joined(found)


def _block(
    model: MachineModel, points: DrawnPoints, value: FloatArray, u: FloatArray, client: Any, head: str, show: Show
) -> Drawn:
    """Of points that are drawn at once, or as they were kept. client: of workers, None: in this process."""
    draws, tasks = points.draws, parts(points.draws.count)
    drawing = Drawing(model, points)
    entries = FIRST_ENTRIES // points.positions.shape[1]
    first = min(draws.count, max(FIRST_SAMPLE // 10, min(FIRST_SAMPLE, entries)))
    sample = with_length(np.concatenate(list(drawing.errors(generators(draws.seed, len(tasks), 0), first))))
    kept = None if draws.keep is None else draws.keep / kept_name(__version__, draws, sample, value, u)
    if kept is not None and (before := read_kept(kept)) is not None:
        return before
    bins = Bins.of_sample(sample)
    del sample
    whole = Tally(bins)
    made = _here(drawing, bins, tasks, draws.seed) if client is None else _there(model, points, bins, tasks, client)
    for number, part in enumerate(made, 1):
        whole.merge(part)
        show(f"{head}{number} of {len(tasks)} parts")
    done = drawn_of(whole, value, u)
    if kept is not None:
        write_files({kept: dump_kept(done)})
    return done


def faults_of_draws(
    covariance: Covariance, count: int, file: str, spelled: Spelled = argument, *, at_once: bool = False
) -> list[Fault]:
    """What is wrong with draws at so many points. file: of the error values; at_once: a best fit of all points is taken
    off.
    """
    found = []
    if covariance.root is None:
        remedy = "values that identify wrote, with the file of their covariance"
        found.append(Fault(file, "u", "the uncertainty of the values is not known: there is nothing to draw", remedy))
    if at_once and count > MOST_POINTS:
        found.append(
            Fault(
                spelled("draws"),
                "",
                f"is of the best fit of {count} points",
                f"{MOST_POINTS} at most, or another datum",
            )
        )
    if count == 0:
        found.append(Fault(spelled("draws"), "", "is of no points", "one point or more"))
    return found


def checked(draws: Draws | int | None) -> Draws | None:
    """The draws asked for. Raises ValueError where a number is out of its range."""
    asked = Draws(count=draws) if isinstance(draws, int) else draws
    if asked is None:
        return None
    for name, value, least, most in (("count", asked.count, 2, MOST_DRAWS), ("seed", asked.seed, 0, 2**63 - 1)):
        if not (isinstance(value, int) and least <= value <= most):
            raise ValueError(f"draws.{name}: expected a whole number from {least} to {most}; given {value}")
    for name, size in (("noise_um", asked.noise_um), ("u_temperature", asked.u_temperature)):
        if not 0.0 <= size < np.inf:
            raise ValueError(f"draws.{name}: expected a finite number, at least 0; given {size}")
    workers_of(None if asked.scheduler else asked.workers, None, asked.scheduler)
    if faults := faults_of_keep(asked.keep):
        raise InputError(faults)
    return asked


def faults_of_keep(keep: Path | None) -> list[Fault]:
    """What is wrong with the folder of results that are kept."""
    if keep is None or keep.is_dir() or not keep.exists():
        return []
    return [Fault(str(keep), "", "is no folder", "a folder for results, or a new name")]


def _here(drawing: Drawing, bins: Bins, tasks: list[int], seed: int) -> Iterator[Tally]:
    for number, count in enumerate(tasks):
        yield _part(drawing, bins, generators(seed, len(tasks), number), count)


def _there(model: MachineModel, points: DrawnPoints, bins: Bins, tasks: list[int], client: Any) -> Iterator[Tally]:
    """The parts in their order, from whatever order the workers give them in."""
    folder = kernels_of(model)
    assert folder is not None
    given = client.scatter((model.machine, folder.resolve(), model.errors, points, bins), broadcast=True, hash=False)
    work = [
        Task(key=str(number), function=draw_part, arguments=(given, tuple(tasks), number))
        for number in range(len(tasks))
    ]
    early: dict[int, Tally] = {}
    following = 0
    for ended in run_tasks(client, work, AHEAD):
        if ended.error is not None:
            raise ended.error
        if ended.lost:
            problem = f"{ended.lost} workers were lost with one part, killed or out of memory"
            raise InputError([Fault("--draws", "", problem, "fewer --workers, or fewer points")])
        early[int(ended.key)] = ended.result
        while following in early:
            yield early.pop(following)
            following += 1


def draw_part(
    given: tuple[Machine, Path, ErrorValues, DrawnPoints, Bins], tasks: tuple[int, ...], number: int
) -> Tally:
    """One part, by a worker. given: the machine, the folder of its kernels, its error values, points and bins."""
    machine, folder, values, points, bins = given
    model = MachineModel(machine, _kernels(machine, folder), values)
    return _part(Drawing(model, points), bins, generators(points.draws.seed, len(tasks), number), tasks[number])


def _part(drawing: Drawing, bins: Bins, sources: list[np.random.Generator], count: int) -> Tally:
    tally = Tally(bins, np.uint16 if count < 2**16 else np.uint32)
    for errors in drawing.errors(sources, count):
        tally.add(with_length(errors))
    return tally


def _kernels(machine: Machine, folder: Path) -> Kernels:
    """Loaded once in a worker."""
    key = machine.digest, folder
    if key not in _LOADED:
        _LOADED[key] = load_kernels(machine, machine.source or Path(machine.name), folder)
    return _LOADED[key]


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
