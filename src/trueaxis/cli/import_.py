"""trueaxis import: instrument files to a folder of measured data."""

import argparse
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.cli.arguments import key_value
from trueaxis.instrument_files.read import FORMATS
from trueaxis.instrument_files.user_keys import Question
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.input_files import gathering
from trueaxis.io.safe_text import shown
from trueaxis.jobs.import_readings import faults_of_out, imported, tool_view
from trueaxis.machine import read_machine
from trueaxis.model.model import load_errors, load_model

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Convert files of instruments to a folder of measured data: Renishaw .rtl, positioning tests of ISO 230-2 (.dat, tables),
tables of a ball bar (angle and deviation or radius) and any table with named columns and units, with points or commas
in numbers and any separator. What a file does not say (the point that was measured, where the other axes stood, the
axis that moved) comes from --map, or is asked for on a terminal. Defaults are written into setup.toml, marked as
assumed."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser(
        "import", help="instrument files to a folder of measured data", description=DESCRIPTION,
        epilog="docs/import.md lists the keys of --map and what of each format is read",
    )  # fmt: skip
    parser.add_argument("files", type=Path, nargs="+", metavar="FILE", help="files of instruments")
    parser.add_argument("--machine", type=Path, required=True, metavar="M.toml", help="the machine spec")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder of measured data, to be written")
    parser.add_argument("--format", choices=FORMATS, help="format of all files (default: by their content)")
    parser.add_argument(
        "--map", type=key_value, action="extend", nargs="+", default=[], metavar="KEY=VALUE",
        help="keys that the files do not give, such as axis=X target.point=0,0,-150 at.Y=200; RUN:KEY=VALUE for one "
        "run, or for the runs of one file by its name without suffix",
    )  # fmt: skip
    parser.add_argument(
        "--kernels", type=Path, default=Path("generated"), metavar="DIR",
        help="folder of derived kernels, for the position of the workpiece ball of a ball bar (%(default)s)",
    )  # fmt: skip
    parser.add_argument(
        "--known", type=Path, metavar="E.json",
        help="error values that have the dimensions which the spec names, for the position of that ball",
    )  # fmt: skip
    parser.add_argument("--replace", action="store_true", help="replace other data that the folder holds")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Read, ask, write; raises InputError with every fault of every file."""
    inputs: dict[str, Path | None] = {"--machine": args.machine, "--known": args.known}
    inputs |= {f"FILE {number}": path for number, path in enumerate(args.files, start=1)}
    found = faults_of_out(args.out, inputs, args.kernels)
    machine = read_machine(args.machine)
    given: dict[str, str] = {}
    for key, value in args.map:
        if given.setdefault(key, value) != value:
            found.append(Fault("--map", shown(key), "is given more than once", "one value for each key"))
    person = sys.stdin is not None and sys.stdin.isatty() and sys.stderr.isatty()

    known = None
    if args.known is not None:
        with gathering(found):
            known = load_errors(args.known, machine)
    view = tool_view(machine, known, lambda: load_model(args.machine, args.known, args.kernels))
    ask = _answer if person else None
    made = imported(
        args.files, machine, args.out, view, given, format=args.format, found=found, ask=ask, replace=args.replace
    )
    print(made, end="")
    return 0


def _answer(question: Question, given: Mapping[str, str], wrong: Sequence[Fault]) -> str:
    """What the person at the terminal types; an empty line repeats the last answer to that key. wrong: faults of the
    answer before.
    """
    for fault in wrong:
        print(fault, file=sys.stderr)
    earlier = [value for key, value in given.items() if key.partition(":")[2] == question.key]
    again = f" [{earlier[-1]}]" if earlier else ""
    meaning = f"{Path(question.file).name}, run {question.run}: {question.meaning}"
    while True:
        print(f"{meaning} (such as {question.right}){again}: ", end="", file=sys.stderr, flush=True)
        line = sys.stdin.readline()
        if not line:
            raise InputError([question.fault])
        if line.strip() or earlier:
            return line.strip() or earlier[-1]
