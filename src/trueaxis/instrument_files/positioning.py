"""A positioning test from whichever file has one: of ISO 230-2, or a .rtl file of runs over its targets."""

from pathlib import Path

import numpy as np

from trueaxis.evaluation.iso230_2.positioning_test import FEWEST_CYCLES, FloatArray, PositioningTest, Unit, too_few
from trueaxis.evaluation.iso230_2.table_file import read_positioning_test, read_runs
from trueaxis.instrument_files.rtl_file import ANGLES, is_rtl, read_rtl
from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.io.input_files import input_bytes


def positioning_test(path: Path, unit: Unit = "mm", fewest_cycles: int = FEWEST_CYCLES) -> PositioningTest:
    """Read a .rtl, .dat, .csv, .txt or .parquet file. Raises InputError with every fault."""
    if not is_rtl(input_bytes(path)):
        return read_positioning_test(path, unit, fewest_cycles)
    return _of_rtl(path, unit, fewest_cycles)


def positioning_tests(path: Path, fewest_cycles: int = FEWEST_CYCLES) -> dict[str, PositioningTest]:
    """The tests of a file, mm, by name of the run; as `read_runs`, also of a .rtl file."""
    if not is_rtl(input_bytes(path)):
        return read_runs(path, fewest_cycles)
    return {path.stem: _of_rtl(path, "mm", fewest_cycles)}


def _of_rtl(path: Path, unit: Unit, fewest_cycles: int) -> PositioningTest:
    """The k-th approach of a target in a direction is of cycle k."""
    if path.suffix.lower() == ANGLES or unit != "mm":
        problem = "has angles, of an unknown unit" if path.suffix.lower() == ANGLES else "has lengths, not angles"
        raise InputError([Fault(str(path), "", problem, "of a rotary axis a table with units is evaluated")])
    run, faults = read_rtl(path), Faults(str(path))
    targets, directions = run.targets, run.directions
    assert targets is not None  # of a .rtl file both are there
    assert directions is not None
    if (directions == 0).any():
        faults.add(
            "DEVIATIONS", "has a run over its targets that does not go one way", "targets in their order, or back"
        )
        faults.raise_if_any()
    positions = np.unique(targets)
    sides = [_approaches(positions, targets[directions == way], run.reading[directions == way]) for way in (1, -1)]
    counts = {one.shape[1] for one in sides}
    if len(counts) > 1:
        there = f"{sides[0].shape[1]} runs in the positive direction and {sides[1].shape[1]} in the negative one"
        faults.add("DEVIATIONS", f"has {there}", "as many in each: a bidirectional test")
    elif problem := too_few("cycle", counts.pop(), float(np.ptp(positions)), unit, fewest_cycles):
        faults.add("DEVIATIONS", problem)
    if problem := too_few("target", positions.size):
        faults.add("TARGET DATA", problem)
    faults.raise_if_any()
    return PositioningTest(positions, positions[:, np.newaxis] + sides[0], positions[:, np.newaxis] + sides[1])


def _approaches(positions: FloatArray, targets: FloatArray, readings: FloatArray) -> FloatArray:
    """(m, n): readings at each position in their order; a .rtl file has every target in every run."""
    return np.array([readings[targets == one] for one in positions])
