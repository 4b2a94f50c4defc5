"""A positioning test from whichever file has one: of ISO 230-2, or a .rtl file of runs over its targets."""

from pathlib import Path

import numpy as np

from trueaxis.evaluation.iso230_2.positioning_test import (
    FEWEST_CYCLES,
    LARGEST_DEVIATION,
    MOST_TARGETS,
    FloatArray,
    PositioningTest,
    Unit,
    too_few,
)
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
    positions = np.unique(targets)
    if positions.size > MOST_TARGETS:
        faults.add("TARGET DATA", f"has {positions.size} targets", f"at most {MOST_TARGETS}")
    elif problem := too_few("target", positions.size):
        faults.add("TARGET DATA", problem)
    largest = float(np.abs(run.reading).max())
    if largest > LARGEST_DEVIATION:
        faults.add("DEVIATIONS", f"one is {largest:.6g} mm", f"at most {LARGEST_DEVIATION:g} mm, in um")
    if (directions == 0).any():
        problem = "has a run over its targets that does not go one way"
        faults.add("DEVIATIONS", problem, "targets in their order, or back")
    faults.raise_if_any()
    up, down = (_approaches(targets[directions == way], run.reading[directions == way], positions) for way in (1, -1))
    if up.shape != down.shape:
        there = f"{up.shape[1]} runs in the positive direction and {down.shape[1]} in the negative one"
        faults.add("DEVIATIONS", f"has {there}", "as many in each: a bidirectional test")
    elif problem := too_few("cycle", up.shape[1], float(np.ptp(positions)), unit, fewest_cycles):
        faults.add("DEVIATIONS", problem)
    faults.raise_if_any()
    return PositioningTest(positions, positions[:, np.newaxis] + up, positions[:, np.newaxis] + down)


def _approaches(targets: FloatArray, readings: FloatArray, positions: FloatArray) -> FloatArray:
    """(m, n): readings at each position in their order; a .rtl file has every target in every run."""
    return readings[np.argsort(targets, kind="stable")].reshape(positions.size, -1)
