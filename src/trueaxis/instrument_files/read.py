"""An instrument file of whichever format, known by its content: its runs, or the positioning test that is in it.

Positioning tests of ISO 230-2 are read as runs of a laser. A positioning test is read from such a file, from a .rtl
file of runs over its targets, or from a table whose columns the user names.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

import numpy as np

from trueaxis.evaluation.positioning_dat_file import read_dat
from trueaxis.evaluation.positioning_table_file import COLUMNS, TABLES, read_positioning_test, read_runs
from trueaxis.evaluation.positioning_test import (
    FEWEST_CYCLES,
    LARGEST_DEVIATION,
    MOST_TARGETS,
    FloatArray,
    PositioningTest,
    Unit,
    too_few,
)
from trueaxis.instrument_files.csv_file import is_ball_bar, read_csv
from trueaxis.instrument_files.rtl_file import ANGLES, is_rtl, read_rtl
from trueaxis.instrument_files.user_keys import UserKeys
from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.io.input_files import gathering, input_bytes
from trueaxis.measurement.delimited import heading, read_delimited
from trueaxis.measurement.instrument_run import DirectionArray, InstrumentRun

Format = Literal["rtl", "iso230-2", "ballbar-csv", "csv"]
FORMATS: tuple[Format, ...] = ("rtl", "iso230-2", "ballbar-csv", "csv")
_START = 100_000  # bytes in which a format shows
ORDER = "the targets were approached cycle by cycle, all in the positive direction and then all in the negative one"


def read_instrument_file(path: Path, of: Format | None, keys: UserKeys) -> tuple[InstrumentRun, ...]:
    """The runs of a file. `of`: its format, None: as its content shows.

    Raises InputError with every fault of the file; what a table of columns does not say is a question in `keys`.
    """
    of = of or recognised(path)
    if of == "rtl":
        return (read_rtl(path),)
    if of == "iso230-2":
        return (_read_positioning(path),)
    return read_csv(path, keys, ballbar=of == "ballbar-csv")


def recognised(path: Path) -> Format:
    """The format that the content shows. Raises InputError where it shows none."""
    data = input_bytes(path)
    if is_rtl(data):
        return "rtl"
    start = data[:_START]
    if path.suffix == ".parquet" or b"TGT_DATA[" in start:
        return "iso230-2"
    first = start.removeprefix(b"\xef\xbb\xbf").lstrip().split(b"\n", 1)[0].replace(b" ", b"").strip()
    if sorted(first.split(b",")) == sorted(name.encode() for name in COLUMNS):
        return "iso230-2"
    header = read_delimited(path).header
    if sorted(heading(name).name for name in header) == sorted(COLUMNS):
        return "iso230-2"
    return "ballbar-csv" if is_ball_bar(header) else "csv"


def _read_positioning(path: Path) -> InstrumentRun:
    """Read such a file. Raises InputError with every fault of the file."""
    test = read_positioning_test(path) if path.suffix in TABLES else read_dat(path)
    up = np.argsort(test.targets)
    down = up[::-1]
    cycles = test.positive.shape[1]
    targets = np.tile(np.concatenate([test.targets[up], test.targets[down]]), cycles)
    measured = np.concatenate([part for k in range(cycles) for part in (test.positive[up, k], test.negative[down, k])])
    return InstrumentRun(
        file=str(path),
        id=path.stem,
        targets=targets,
        reading=measured - targets,
        directions=np.tile(np.repeat(np.array([1, -1], dtype=np.int8), up.size), cycles),
        assumed=(ORDER,),
    )


def positioning_test(path: Path, unit: Unit = "mm") -> PositioningTest:
    """Read a .rtl, .dat, .csv, .txt or .parquet file. Raises InputError with every fault."""
    if not is_rtl(input_bytes(path)):
        return read_positioning_test(path, unit)
    return _of_rtl(path, unit, FEWEST_CYCLES)


def mapped_tests(
    path: Path, given: Mapping[str, str], unit: Unit = "mm", fewest_cycles: int = FEWEST_CYCLES
) -> dict[str, PositioningTest]:
    """Read a table whose columns and units the user names, by keys as `read_csv` takes them: its tests by name of the
    run. Cycles are counted by approaches, as of a .rtl file. Raises InputError with every fault.
    """
    keys, found = UserKeys(given=given), list[Fault]()
    runs: Sequence[InstrumentRun] = ()
    with gathering(found):
        runs = read_csv(path, keys)
    found += [*keys.unknown(), *keys.faults, *(one.fault for one in keys.questions)]
    found += [] if found else keys.unused()
    if found:
        raise InputError(found)
    tests = {}
    for run in runs:
        with gathering(found):
            tests[run.id] = _of_table(run, unit, fewest_cycles)
    if found:
        raise InputError(found)
    return tests


def _of_table(run: InstrumentRun, unit: Unit, fewest_cycles: int) -> PositioningTest:
    if (run.instrument == "angle") != (unit == "deg"):
        problem = f"has {'angles' if run.instrument == 'angle' else 'lengths'}"
        raise InputError([Fault(run.file, "", problem, "of a rotary axis angles, else lengths")])
    if run.targets is None:
        raise InputError([Fault(run.file, "", "has no targets", "--map column.target=NAME")])
    if unit == "deg":
        run = replace(run, reading=np.degrees(run.reading))
    return _of_run(run, _Places(targets="column target", readings="readings"), unit, fewest_cycles)


def positioning_tests(path: Path, fewest_cycles: int = FEWEST_CYCLES) -> dict[str, PositioningTest]:
    """The tests of a file, mm, by name of the run; as `read_runs`, also of a .rtl file."""
    if not is_rtl(input_bytes(path)):
        return read_runs(path, fewest_cycles)
    return {path.stem: _of_rtl(path, "mm", fewest_cycles)}


def _of_rtl(path: Path, unit: Unit, fewest_cycles: int) -> PositioningTest:
    if path.suffix.lower() == ANGLES or unit != "mm":
        problem = "has angles, of an unknown unit" if path.suffix.lower() == ANGLES else "has lengths, not angles"
        raise InputError([Fault(str(path), "", problem, "of a rotary axis a table with units is evaluated")])
    return _of_run(read_rtl(path), _Places(targets="TARGET DATA", readings="DEVIATIONS"), unit, fewest_cycles)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Places:
    """Where in its file faults of the targets and of the readings are."""

    targets: str
    readings: str


def _of_run(run: InstrumentRun, at: _Places, unit: Unit, fewest_cycles: int) -> PositioningTest:
    """The k-th approach of a target in a direction is of cycle k; readings in `unit`."""
    faults = Faults(run.file)
    targets, directions = run.targets, run.directions
    assert targets is not None  # of such a file both are there
    assert directions is not None
    positions = np.unique(targets)
    if positions.size > MOST_TARGETS:
        faults.add(at.targets, f"has {positions.size} targets", f"at most {MOST_TARGETS}")
    elif problem := too_few("target", positions.size):
        faults.add(at.targets, problem)
    largest = float(np.abs(run.reading).max())
    if largest > LARGEST_DEVIATION:
        faults.add(at.readings, f"one is {largest:.6g} {unit}", f"at most {LARGEST_DEVIATION:g} {unit}")
    if (directions == 0).any():
        problem = "has a run over its targets that does not go one way"
        faults.add(at.readings, problem, "targets in their order, or back")
    faults.raise_if_any()
    _check_counts(targets, directions, at, faults)
    up, down = (_approaches(targets[directions == way], run.reading[directions == way], positions) for way in (1, -1))
    if up.shape != down.shape:
        there = f"{up.shape[1]} runs in the positive direction and {down.shape[1]} in the negative one"
        faults.add(at.readings, f"has {there}", "as many in each: a bidirectional test")
    elif problem := too_few("cycle", up.shape[1], float(np.ptp(positions)), unit, fewest_cycles):
        faults.add(at.readings, problem)
    faults.raise_if_any()
    return PositioningTest(positions, positions[:, np.newaxis] + up, positions[:, np.newaxis] + down, unit)


def _check_counts(targets: FloatArray, directions: DirectionArray, at: _Places, faults: Faults) -> None:
    """Raises InputError where a target was not approached as often as the others in its direction."""
    for way, name in ((1, "positive"), (-1, "negative")):
        found, counts = np.unique(targets[directions == way], return_counts=True)
        if found.size and (found.size < np.unique(targets).size or np.ptp(counts) > 0):
            problem = f"not all targets were approached equally often in the {name} direction"
            faults.add(at.readings, problem, "every target in every cycle, in both directions")
    faults.raise_if_any()


def _approaches(targets: FloatArray, readings: FloatArray, positions: FloatArray) -> FloatArray:
    """(m, n): readings at each position in their order; a .rtl file has every target in every run."""
    return readings[np.argsort(targets, kind="stable")].reshape(positions.size, -1)
