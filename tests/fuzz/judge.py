"""What a reader and a command may do with any file: read it, or refuse it with faults; nothing else."""

import contextlib
import io
import json
import math
import re
import shutil
import traceback
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from random import Random

import numpy as np
import polars as pl

from tests.fuzz.expressions import expression
from tests.fuzz.readers import KERNELS, Reader
from tests.fuzz.seeds import MACHINES, random_spec, valid_files, write_all
from tests.machines import machine_of
from trueaxis.cli import main as command_line
from trueaxis.io.faults import InputError
from trueaxis.machine import Machine

RANDOM_MACHINES, VARIANTS = 60, 4  # machines that no file describes; sets of valid files of each machine
LONGEST_MESSAGE = 6000  # characters of one fault
_NC_NUMBER = re.compile(r"[A-Z][-+]?(?:nan|inf)", re.IGNORECASE)
_NC_END = re.compile(r"(?<![A-Za-z])M0*(?:2|30)(?![\d.])", re.IGNORECASE)


@dataclass(frozen=True)
class Outcome:
    """`state`: read, refused, done, answered no, or finding; `problem`: the same for findings of one cause."""

    state: str
    problem: str = ""
    detail: str = ""


@dataclass(frozen=True)
class Case:
    """Files of which one is hostile, and whether the command runs on them or the reading function alone."""

    files: Mapping[str, bytes]
    machine: Machine
    by_command: bool


def case_of(reader: Reader, seed: int, *, valid: bool = False) -> Case:
    """The case of a seed, always the same; `valid`: as it is before the change."""
    draw = Random(f"{reader.name} {seed}")
    by_command = reader.read is None or bool(reader.command and draw.random() < reader.share)
    drawn = not by_command and draw.random() < 0.7
    spec = random_spec(Random(draw.randrange(RANDOM_MACHINES))) if drawn else draw.choice(MACHINES).read_text()
    files = dict(_valid(spec, draw.randrange(VARIANTS)))
    if reader.file.endswith(".parquet"):
        del files["data/readings.csv"]
    elif reader.file.startswith("data"):
        del files["data/readings.parquet"]
    if not valid and not (reader.name == "expression" and draw.random() < 0.7):  # random expressions are hostile enough
        files[reader.file] = reader.change(files[reader.file], draw)
    elif reader.name == "expression":
        files[reader.file] = expression(draw)
    return Case(files, _machine(spec), by_command)


@cache
def _valid(spec: str, variant: int) -> Mapping[str, bytes]:
    return valid_files(spec, Random(variant))


@cache
def _machine(spec: str) -> Machine:
    return machine_of(spec)


def judged(reader: Reader, case: Case, folder: Path) -> Outcome:
    """What comes of a case; the folder is emptied."""
    shutil.rmtree(folder, ignore_errors=True)
    write_all(folder / "in", dict(case.files))
    (folder / "out").mkdir()
    try:
        return (
            _command(reader, folder) if case.by_command else _reading(reader, case.machine, folder / "in" / reader.file)
        )
    except (Exception, SystemExit) as error:
        steps = traceback.extract_tb(error.__traceback__)
        own = [step for step in steps if "trueaxis" in step.filename] or steps
        where = f"{Path(own[-1].filename).name}:{own[-1].name}"
        return Outcome(
            "finding", f"{type(error).__name__} in {where}", "".join(traceback.format_exception(error))[-3000:]
        )


def _reading(reader: Reader, machine: Machine, path: Path) -> Outcome:
    assert reader.read is not None
    try:
        reader.read(path, machine)
    except InputError as error:
        for fault in error.faults:
            if not fault.problem or fault.file != str(path) or len(str(fault)) > LONGEST_MESSAGE:
                return Outcome("finding", "a fault without file or problem, or too long", str(fault)[:500])
            if not str(fault).replace("\n", "").isprintable():
                return Outcome("finding", "a fault with control characters", repr(str(fault))[:500])
        return Outcome("refused") if error.faults else Outcome("finding", "refused without a fault")
    return Outcome("read")


def _command(reader: Reader, folder: Path) -> Outcome:
    named = {"IN": folder / "in", "OUT": folder / "out", "KERNELS": KERNELS}
    words = [
        "/".join([str(named.get(word.split("/")[0], word.split("/")[0])), *word.split("/")[1:]])
        for word in reader.command
    ]
    told, said = io.StringIO(), io.StringIO()
    with contextlib.redirect_stderr(told), contextlib.redirect_stdout(said):
        code = command_line.main(words)
    written = [path for path in (folder / "out").rglob("*") if path.is_file()]
    if code not in (0, 1, 2):
        return Outcome("finding", f"exit code {code}", told.getvalue()[:500])
    if code == 2:
        if written:
            return Outcome("finding", "exit code 2, but files are written", str(written))
        if str(folder / "in") not in told.getvalue():
            return Outcome("finding", "exit code 2, but no message names a file", told.getvalue()[:500])
        return Outcome("refused")
    for path in written:
        if (wrong := _not_finite(path)) is not None:
            return Outcome("finding", f"{path.suffix} with a number that is not finite", wrong[:500])
    return Outcome("done" if code == 0 else "answered no")


def _not_finite(path: Path) -> str | None:
    """Where an output file has a number that is not finite; None where it has none."""
    if path.suffix == ".json":
        return next((repr(part) for part in _infinite_parts(json.loads(path.read_bytes()))), None)
    if path.suffix == ".csv":
        frame = pl.read_csv(path, infer_schema=False)
        columns = (frame[name] for name in frame.columns if name != "run")
        return next(
            (f"{one.name}: {cell}" for one in columns for cell in one if cell and not math.isfinite(float(cell))), None
        )
    if path.suffix == ".npz":
        with np.load(path) as arrays:
            return next((name for name in arrays if not np.isfinite(arrays[name]).all()), None)
    return _nc_not_finite(path.read_bytes().decode("latin-1")) if path.suffix == ".nc" else None


def _nc_not_finite(program: str) -> str | None:
    """The line of an NC program with a number that is not finite, up to its end: what follows is copied as it is."""
    percents = 0
    for line in re.sub(r"\([^)\n]*\)|;.*", "", program).split("\n"):
        if _NC_NUMBER.search(line):
            return line
        percents += line.strip().startswith("%")
        if percents == 2 or _NC_END.search(line):
            return None
    return None


def _infinite_parts(node: object) -> Iterator[float]:
    if isinstance(node, float) and not math.isfinite(node):
        yield node
    for inner in node.values() if isinstance(node, dict) else node if isinstance(node, list) else ():
        yield from _infinite_parts(inner)


def minimised(reader: Reader, case: Case, problem: str, folder: Path, tries: int = 150) -> Case:
    """The case with as few lines, then as few characters, of the hostile file as show the same problem."""
    for separator in (b"\n", b""):
        pieces = (
            case.files[reader.file].split(b"\n") if separator else [bytes([one]) for one in case.files[reader.file]]
        )
        size = max(1, len(pieces) // 2)
        while size and tries and len(pieces) < 3000:
            at = 0
            while at < len(pieces) and tries:
                fewer = pieces[:at] + pieces[at + size :]
                smaller = Case({**case.files, reader.file: separator.join(fewer)}, case.machine, case.by_command)
                tries -= 1
                if judged(reader, smaller, folder).problem == problem:
                    case, pieces = smaller, fewer
                else:
                    at += size
            size //= 2
    return case
