"""trueaxis fleet: many machines, each with measured data of many days."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.cli.arguments import option, positive, whole
from trueaxis.cli.progress import progress
from trueaxis.cluster.workers import LEAST_MEMORY, MOST_WORKERS
from trueaxis.io.faults import InputError
from trueaxis.jobs.draws import GB, faults_of_workers
from trueaxis.jobs.outputs import named

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Identify, diagnose and document many machines. FLEET.toml has a table [[machine]] for each: id, spec, errors (the values
active on its control now), data (a folder, a list of folders, or a pattern such as "data/M17/2026-*", dated by their
names), tasks (of identify, diagnose, report; default identify); paths are relative to the file. --out gets
results.parquet (a row for each machine and folder of data), index.html (what has changed and by how many standard
uncertainties, which machines share a cause, which failed and why) and, in machines/ID/FOLDER/, the files that the
single commands write. Unchanged work is not repeated, and a run that was stopped continues where it was. The work is
done by processes of this computer, or by those of a running Dask scheduler; it needs the extra trueaxis[cluster]."""

EPILOG = """\
exit code: 0 every row is done; 1 rows have faults (a machine that fails does not end the others); 2 the fleet file is
wrong, or no scheduler answers, and nothing was written"""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser(
        "fleet",
        help="identify, diagnose and document many machines over many days",
        description=DESCRIPTION,
        epilog=EPILOG,
    )
    parser.add_argument("fleet", type=Path, metavar="FLEET.toml", help="the machines")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder to be written")
    parser.add_argument(
        "--workers", type=whole(1, MOST_WORKERS), metavar="N",
        help="processes on this computer (default: one for each core)",
    )  # fmt: skip
    parser.add_argument(
        "--memory", type=_memory, metavar="GB",
        help="memory of each process: one that needs more is ended and started again; a machine that needs more three "
        "times gets a row that says so (default: that of the computer in equal parts)",
    )  # fmt: skip
    parser.add_argument(
        "--scheduler", metavar="ADDRESS",
        help="a running Dask scheduler, such as tcp://10.0.0.5:8786, whose workers do the work; they must see the same "
        "files at the same paths",
    )  # fmt: skip
    parser.add_argument("--again", action="store_true", help="repeat unchanged work, too")
    parser.set_defaults(run=run)


def _memory(text: str) -> float:
    """GB. Raises argparse.ArgumentTypeError where no worker can work with them."""
    given = positive(text)
    if given * GB < LEAST_MEMORY:
        raise argparse.ArgumentTypeError(f"{text} is less than a worker needs: {LEAST_MEMORY / GB:g} GB")
    return given


def run(args: argparse.Namespace) -> int:
    """Do the fleet; raises InputError with the faults of its file and of the options."""
    if faults := faults_of_workers(args.scheduler, option, workers=args.workers, memory=args.memory):
        raise InputError(faults)
    from trueaxis.jobs.fleet import fleet  # noqa: PLC0415  all that it does is imported with it, and not for --help

    with progress() as show:
        done = fleet(
            args.fleet, args.out, workers=args.workers, memory=args.memory, scheduler=args.scheduler, again=args.again,
            show=show,
        )  # fmt: skip
    print(done, end="")
    print(f"written: {', '.join(map(named, done.files))}")
    return 0 if done.good else 1
