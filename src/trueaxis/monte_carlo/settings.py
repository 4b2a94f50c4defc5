"""How many draws, of what, in which parts: the same for any number of workers."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

MOST_DRAWS = 10_000_000
LEAST_TASKS = 100
DRAWS_OF_A_TASK = 5000  # a task of 1000 points takes a second or two: long beside what sending it costs


@dataclass(frozen=True, slots=True, kw_only=True)
class Draws:
    """count: of draws; seed: of the random numbers. noise_um: standard deviation of what does not repeat of the tool
    point, in each coordinate, um; u_temperature: standard uncertainty of the temperature, K; either_direction: whether
    axes whose direction of approach is not given came from either side alike: of machines with effects that depend on
    them. workers: processes, 1: this one; scheduler: address of a running Dask scheduler, None: processes of this
    computer. keep: folder for the results of each block of points, which are read instead of drawn again; None: none.
    """

    count: int
    seed: int = 0
    noise_um: float = 0.0
    u_temperature: float = 0.0
    either_direction: bool = False
    workers: int = 1
    scheduler: str | None = None
    keep: Path | None = None


def parts(count: int) -> list[int]:
    """How many draws each task makes: `LEAST_TASKS` tasks, or as many more as `DRAWS_OF_A_TASK` ask for."""
    tasks = min(count, max(LEAST_TASKS, -(-count // DRAWS_OF_A_TASK)))
    return [count * (number + 1) // tasks - count * number // tasks for number in range(tasks)]


def generators(seed: int, tasks: int, number: int) -> list[np.random.Generator]:
    """Random numbers of a task for the values, the noise and the context, each apart from all others."""
    own = np.random.SeedSequence(seed).spawn(tasks)[number]
    return [np.random.Generator(np.random.PCG64(one)) for one in own.spawn(3)]
