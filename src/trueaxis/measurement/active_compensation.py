"""Readings taken while a compensation was active on the control, and those of the machine without it.

A control that compensates with error values takes from each reading what the exact model with these values expects of
it. This is added again before anything else is done with the readings: to first order in the errors, since the machine
was at slightly other positions.
"""

import json
import os
import re
import tomllib
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from trueaxis.io.faults import Fault, InputError
from trueaxis.io.input_files import input_bytes, utf8_text
from trueaxis.machine import Machine
from trueaxis.measurement.context import context_of, faults_of_readings
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import expected_readings, ideal_reading
from trueaxis.measurement.readings import Readings
from trueaxis.measurement.setup import FILE_NAME, Run, Setup
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, load_errors

_KEY = re.compile(r"""^([ \t]*(?:compensation|"compensation")[ \t]*=[ \t]*)("(?:[^"\\\n]|\\.)*"|'[^'\n]*')""", re.M)


def active_file(folder: Path, setup: Setup) -> Path | None:
    """The file of the error values that the control compensated with; None where none is named."""
    key = setup.compensation
    return None if key is None or key.file is None else folder / key.file


def active_values(folder: Path, setup: Setup, machine: Machine) -> ErrorValues | None:
    """The error values that the control compensated with; None where none were active, or nothing is said of them.

    Raises InputError at the key of setup.toml where the file is missing, or no error values of this machine.
    """
    key, file = setup.compensation, active_file(folder, setup)
    if key is None or file is None:
        return None
    try:
        return load_errors(file, machine)
    except InputError as error:
        remedy = 'the error values that the control worked with, or "none"'
        raise InputError(
            Fault(str(folder / FILE_NAME), key.location, str(fault), remedy) for fault in error.faults
        ) from None


def compensated_part(model: MachineModel, active: ErrorValues, runs: Sequence[Run], readings: Readings) -> FloatArray:
    """(n,): what a compensation with the values takes from each reading, mm.

    Raises InputError where the readings lack a column that an effect among the values depends on.
    """
    model = model.with_values(active)
    context = None
    if active.effects:
        context = context_of(runs, readings)
        every = np.ones(readings.run.size, dtype=bool)
        faults = faults_of_readings(model, runs, readings, context, every, "readings")
        if faults:
            raise InputError(faults)
    expected = expected_readings(model, runs, readings.run, readings.positions, context)
    for index, run in enumerate(runs):
        rows = np.flatnonzero(readings.run == index)
        if rows.size:
            expected[rows] -= ideal_reading(model, run, np.ascontiguousarray(readings.positions[:, rows]))
    return expected


def uncompensated(model: MachineModel, data: MeasuredData, active: ErrorValues) -> MeasuredData:
    """The readings that the machine would have given without the compensation. Rows without a reading stay so."""
    added = compensated_part(model, active, data.setup.runs, data.readings)
    return replace(data, readings=replace(data.readings, reading=data.readings.reading + added))


def moved_setup(source: Path, target: Path) -> bytes:
    """setup.toml of the folder `source` as it must read in `target`: its `compensation` leads to the same file.

    Raises InputError where the key is no text of one line.
    """
    path = source / FILE_NAME
    given = input_bytes(path)
    text = utf8_text(path, given)
    tree = tomllib.loads(text)
    file = tree.get("compensation", "none")
    if file == "none" or (target / file).resolve() == (source / file).resolve():
        return given
    way = Path(os.path.relpath((source / file).resolve(), target.resolve())).as_posix()
    for found in _KEY.finditer(text):
        moved = f"{text[: found.end(1)]}{json.dumps(way)}{text[found.end() :]}"
        if tomllib.loads(moved) == tree | {"compensation": way}:
            return moved.encode()
    problem = "cannot be written for another folder"
    raise InputError([Fault(str(path), "key compensation", problem, "a text of one line in quotes")])
