"""Draw cases of worlds, put them before the diagnosis, grade what it says.

    python -m tests.worlds.diagnosis --out DIR --first SEED --worlds N --cases K [--only KIND,...] [--processes P]
    python -m tests.worlds.diagnosis --out DIR --table         # what is there, as Markdown
    python -m tests.worlds.diagnosis --out DIR --failures      # each failure, its case and the ingredients of its world

A case is a line of JSON in DIR; what is there already is not done again. The worlds take turns, a few cases each.
"""

import argparse
import os
import sys
import time
from collections.abc import Sequence
from multiprocessing import get_context
from pathlib import Path
from typing import Any

THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
os.environ.update(dict.fromkeys(THREADS, "1"))  # before NumPy is imported, here and in the processes that are spawned

from tests.worlds.design import draw_design  # noqa: E402
from tests.worlds.diagnosis.cases import KINDS, MACHINES_APART  # noqa: E402
from tests.worlds.diagnosis.measuring import ENGINES, measure_worlds, read_lines  # noqa: E402
from tests.worlds.diagnosis.tables import failures, tables  # noqa: E402
from trueaxis.cluster.tasks import Task, run_tasks  # noqa: E402
from trueaxis.cluster.workers import Workers, client_of  # noqa: E402


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, metavar="DIR", required=True)
    parser.add_argument("--first", type=int, default=1, metavar="SEED", help="of the first world (%(default)s)")
    parser.add_argument("--worlds", type=int, default=40, metavar="N", help="%(default)s")
    parser.add_argument("--cases", type=int, default=75, metavar="K", help="of each world (%(default)s)")
    parser.add_argument("--most-readings", type=int, default=10**9, metavar="R", help="leave out worlds with more")
    parser.add_argument("--only", default="", metavar="KIND,...", help=f"of {', '.join(KINDS)} (default: the mix)")
    parser.add_argument("--engine", choices=ENGINES, default="process", help="%(default)s")
    parser.add_argument("--processes", type=int, default=1, metavar="P", help="%(default)s")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask scheduler, started in this folder")
    parser.add_argument("--minutes", type=float, default=float("inf"), metavar="T", help="stop after this time")
    parser.add_argument("--table", action="store_true")
    parser.add_argument("--failures", action="store_true")
    args = parser.parse_args(arguments)
    only = tuple(kind for kind in args.only.split(",") if kind)
    if set(only) - set(KINDS):
        parser.error(f"--only: there are {', '.join(KINDS)}")
    if args.table or args.failures:
        print("\n".join((failures if args.failures else tables)(read_lines(args.out))))
        return 0
    until = time.time() + 60.0 * args.minutes
    seeds = [seed for seed in range(args.first, args.first + args.worlds) if _readings(seed) <= args.most_readings]
    parts = [tuple(seeds[k :: args.processes]) for k in range(args.processes)]
    work = [(args.out, part, min(args.cases, MACHINES_APART), only, args.engine, until) for part in parts if part]
    args.out.mkdir(parents=True, exist_ok=True)
    if args.scheduler is not None:
        return int(not on_workers(args.scheduler, [(args.out.resolve(), (seed,), *work[0][2:]) for seed in seeds]))
    if len(work) == 1:
        measure_worlds(*work[0])
    else:
        with get_context("spawn").Pool(len(work)) as pool:
            pool.starmap(measure_worlds, work)
    return 0


def on_workers(scheduler: str, work: Sequence[tuple[Any, ...]]) -> bool:
    """A task for each world. Whether every task has ended well."""
    tasks = [Task(key=str(one[1][0]), function=measure_worlds, arguments=one) for one in work]
    good = True
    with client_of(Workers(scheduler=scheduler)) as client:
        for ended in run_tasks(client, tasks):
            if ended.error is not None or ended.lost:
                good = False
                print(f"world {ended.key}: {ended.error or 'its workers were lost'}", file=sys.stderr)
    return good


def _readings(seed: int) -> int:
    return draw_design(seed).plan.count


if __name__ == "__main__":
    raise SystemExit(main())
