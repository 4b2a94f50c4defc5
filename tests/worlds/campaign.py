"""The campaign: what the package's estimate makes of many machines of many designs, beside the oracle.

    python -m tests.worlds.campaign --out DIR --designs 32 --first 1001 --minutes 60     # one process per core
    python -m tests.worlds.campaign --out DIR --workers 8 --minutes 60                   # or --scheduler ADDRESS
    python -m tests.worlds.campaign --out DIR --table                                    # what is there as tables

A machine is one line of JSON in a file of DIR (designs FIRST to FIRST + N - 1 write results-FIRST-N.jsonl); what is
there already is not done again, and files of several processes or days are added up by --table. Worlds stay in
DIR/worlds, what the machines of a design share in the memory (about 100 MB each). The designs take turns, a few
machines each, so that all have as many when time is up.
"""

import argparse
import json
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

from tests.worlds.campaign_tables import tables
from tests.worlds.estimates import GIVEN, Outcome, World, outcome, world
from trueaxis.cluster.tasks import Task, run_tasks
from trueaxis.cluster.workers import Workers, client_of
from trueaxis.estimation.evidence import LIKELIER

CURVES = ("smooth", "prior")
# machines of a design in turn: half of them draws of a prior; [prior] as nobody has touched it, right, or wrong
KINDS = tuple((CURVES[(k + start) % 2], given) for start in range(2) for k, given in enumerate(GIVEN))
A_TURN = len(KINDS)
SEEDS_APART = 1000  # machines of a design at most


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, metavar="DIR", required=True)
    parser.add_argument("--table", action="store_true", help="print what is in DIR, as Markdown")
    parser.add_argument("--designs", type=int, default=32, metavar="N", help="%(default)s")
    parser.add_argument("--first", type=int, default=1, metavar="SEED", help="of the first design (%(default)s)")
    parser.add_argument("--machines", type=int, default=200, metavar="M", help="of each design (%(default)s)")
    parser.add_argument("--minutes", type=float, default=float("inf"), metavar="T", help="stop after this time")
    parser.add_argument("--workers", type=int, metavar="N", help="processes on this computer (default: this one)")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask scheduler, started in this folder")
    args = parser.parse_args(arguments)
    if args.table:
        print("\n".join(tables(read_lines(args.out))))
        return 0
    seeds = range(args.first, args.first + args.designs)
    machines, until = min(args.machines, SEEDS_APART), time.time() + 60.0 * args.minutes
    if args.workers is None and args.scheduler is None:
        measure_designs(args.out, seeds, machines, until)
        return 0
    args.out.mkdir(parents=True, exist_ok=True)
    return int(not on_workers(args.out, seeds, machines, until, Workers(count=args.workers, scheduler=args.scheduler)))


def on_workers(folder: Path, seeds: range, machines: int, until: float, workers: Workers) -> bool:
    """As measure_designs, a task for each turn of a design, a file for each design. Whether every task ended well."""
    done = {(line["design"], line["machine"]) for line in read_lines(folder)}
    tasks: list[Task] = []
    last: dict[int, str] = {}
    for seed, numbers in _turns(seeds, machines):
        left = tuple(number for number in numbers if (seed, number) not in done)
        if left:  # one after the other: they write into one file
            after = (last[seed],) if seed in last else ()
            last[seed] = f"{seed} {numbers.start}"
            arguments = (folder.resolve(), seed, left, until)
            tasks.append(Task(key=last[seed], function=measure_turn, arguments=arguments, after=after))
    good = True
    with client_of(workers) as client:
        for ended in run_tasks(client, tasks):
            if ended.error is not None or ended.lost:
                good = False
                print(f"design and machine {ended.key}: {ended.error or 'its workers were lost'}", file=sys.stderr)
    return good


def measure_turn(folder: Path, seed: int, numbers: tuple[int, ...], until: float) -> None:
    """Append a line for each of these machines of a design; until: of time.time()."""
    if time.time() > until:
        return
    there = world(seed, folder / "worlds" / str(seed))
    with (folder / f"results-{seed}-1.jsonl").open("a") as results:
        for number in numbers:
            if time.time() > until:
                return
            results.write(json.dumps(line_of(there, number)) + "\n")
            results.flush()


def read_lines(folder: Path) -> list[dict[str, object]]:
    """All machines in all files of a folder."""
    texts = (path.read_text() for path in sorted(folder.glob("results-*.jsonl")))
    return [json.loads(line) for text in texts for line in text.splitlines()]


def measure_designs(folder: Path, seeds: range, machines: int, until: float) -> None:
    """Append a line for every machine that is not there yet; until: of time.time()."""
    folder.mkdir(parents=True, exist_ok=True)
    done = {(line["design"], line["machine"]) for line in read_lines(folder)}
    worlds: dict[int, World] = {}
    with (folder / f"results-{seeds.start}-{len(seeds)}.jsonl").open("a") as results:
        for seed, numbers in _turns(seeds, machines):
            left = [number for number in numbers if (seed, number) not in done]
            if not left:
                continue
            if seed not in worlds:
                worlds[seed] = world(seed, folder / "worlds" / str(seed))
            for number in left:
                if time.time() > until:
                    return
                results.write(json.dumps(line_of(worlds[seed], number)) + "\n")
                results.flush()


def _turns(seeds: range, machines: int) -> Iterator[tuple[int, range]]:
    for start in range(0, machines, A_TURN):
        for seed in seeds:
            yield seed, range(start, min(start + A_TURN, machines))


def line_of(one: World, number: int) -> dict[str, object]:
    """What is kept of a machine; number: among those of its design."""
    curves, given = KINDS[number % len(KINDS)]
    found: Outcome = outcome(one, SEEDS_APART * one.design.seed + number, curves, given)
    lengths = ("true", "error", "oracle", "one_family", "class_sizes", "set_ups_expected", "u")
    figures = (*lengths, "coverage", "oracle_coverage", "seconds")
    return {
        "design": one.design.seed,
        "machine": number,
        "curves": curves,
        "given": given,
        **{name: float(f"{getattr(found, name):.6g}") for name in figures},
        "sizes": {kind: [float(f"{size:.4g}") for size in sizes] for kind, sizes in found.sizes.items()},
        "said": sorted(kind for kind, odds in found.found.likelier.items() if odds > LIKELIER),
        "converged": found.found.iteration.converged,
        "rounds": found.found.iteration.rounds,
        "steps": found.found.iteration.steps,
    }


if __name__ == "__main__":
    raise SystemExit(main())
