"""trueaxis import: instrument files to a folder of measured data."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.cli.arguments import key_value
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.instrument_files.data_folder import readings_bytes, setup_text
from trueaxis.instrument_files.data_run import DataRun, data_run, renamed
from trueaxis.instrument_files.read import FORMATS, read_instrument_file
from trueaxis.instrument_files.user_keys import Question, UserKeys
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering
from trueaxis.io.plain_text import shown
from trueaxis.machine import Machine, read_machine
from trueaxis.measurement import readings as readings_files
from trueaxis.measurement import setup as setup_file
from trueaxis.measurement.instrument_run import FloatArray, InstrumentRun
from trueaxis.model.model import load_model

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

COMPENSATION = "compensation"
DESCRIPTION = """\
Bring files of instruments into a folder of measured data: Renishaw .rtl, positioning tests of ISO 230-2 (.dat, tables),
tables of a ball bar (angle and deviation or radius) and any table with named columns and units; with points or commas
in numbers and any separator. What a file does not say (the point that was measured, where the other axes stood, the
axis that moved) comes from --map, or is asked for on a terminal; it is written into setup.toml, marked as assumed."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser(
        "import", help="instrument files to a folder of measured data", description=DESCRIPTION,
        epilog="docs/import.md lists the keys of --map and what of each format is read",
    )  # fmt: skip
    parser.add_argument("files", type=Path, nargs="+", metavar="FILE", help="files of instruments")
    parser.add_argument("--machine", type=Path, required=True, metavar="M.toml", help="the machine spec")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder of measured data, to be written")
    parser.add_argument("--format", choices=FORMATS, help="of all files (default: as their content shows)")
    parser.add_argument(
        "--map", type=key_value, action="extend", nargs="+", default=[], metavar="KEY=VALUE",
        help="what the files do not say, such as axis=X target.point=0,0,-150 at.Y=200; RUN:KEY=VALUE for one run, or "
        "for the runs of one file by its name without suffix",
    )  # fmt: skip
    parser.add_argument(
        "--kernels", type=Path, default=Path("generated"), metavar="DIR",
        help="folder of derived kernels, for where the ball of a ball bar stands (%(default)s)",
    )  # fmt: skip
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Read, ask, write; raises InputError with every fault of every file."""
    found = _faults_of_out(args)
    machine = read_machine(args.machine)
    given: dict[str, str] = {}
    for key, value in args.map:
        if given.setdefault(key, value) != value:
            found.append(Fault("--map", shown(key), "is given more than once", "one value for each key"))
    unknown = UserKeys(given).unknown()
    asked = not found and not unknown and sys.stdin is not None and sys.stdin.isatty() and sys.stderr.isatty()
    while True:
        runs, keys = _runs(args, machine, given, found)
        if not (asked and keys.questions and not keys.faults):
            break
        question = keys.questions[0]
        given[f"{question.run}:{question.key}"] = _answer(question, given)
    faults = [*unknown, *keys.faults, *(question.fault for question in keys.questions)]
    if not faults:
        faults = keys.unused()
    if found + faults:
        raise InputError(found + faults)
    ready = renamed(tuple(runs))
    setup, readings = args.out / setup_file.FILE_NAME, args.out / readings_files.FILE_NAME
    write_files({
        setup: setup_text(ready, machine.name, given.get(COMPENSATION)),
        readings: readings_bytes(ready, machine.axes),
    })  # fmt: skip
    for item in ready:
        assumed = sorted({key for key in item.assumed.sources if key != "id"})
        print(f"{shown(item.run.id)}: {item.reading.size} readings of {shown(Path(item.source.file).name)}")
        if assumed:
            print(f"  not in the file: {', '.join(assumed)}")
    print(f"{named(args.out)}: {len(ready)} runs; {setup_file.FILE_NAME} marks what is assumed: look it through")
    return 0


def _runs(
    args: argparse.Namespace, machine: Machine, given: dict[str, str], found: list[Fault]
) -> tuple[list[DataRun], UserKeys]:
    """The runs that can be made with these keys; what else is needed is noted in the keys.

    Raises InputError where a file is wrong, with the faults of all files and those found before.
    """
    keys = UserKeys(given, used={COMPENSATION})
    faults: list[Fault] = list(found)
    sources: list[InstrumentRun] = []
    for path in args.files:
        with gathering(faults):
            sources += read_instrument_file(path, args.format, keys)
    if faults:
        raise InputError([*faults, *keys.unknown()])

    def view(positions: FloatArray, point: FloatArray) -> FloatArray:
        return load_model(args.machine, None, args.kernels).ideal(positions, point)

    runs = [data_run(source, machine, keys, view) for source in sources]
    return [item for item in runs if item is not None], keys


def _answer(question: Question, given: dict[str, str]) -> str:
    """What the person at the terminal types; an empty line repeats the last answer to that key."""
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


def _faults_of_out(args: argparse.Namespace) -> list[Fault]:
    other = args.out / readings_files.PARQUET_NAME
    if other.exists():
        return [Fault(str(other), "", f"would stand beside the new {readings_files.FILE_NAME}", "remove it")]
    inputs: dict[str, Path | None] = {"--machine": args.machine}
    inputs |= {f"FILE {number}": path for number, path in enumerate(args.files, start=1)}
    outputs: dict[str, Path | None] = {
        f"{name} of --out": args.out / name for name in (setup_file.FILE_NAME, readings_files.FILE_NAME)
    }
    return overwritten(inputs, outputs, args.kernels)
