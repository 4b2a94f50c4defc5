"""What is fuzzed: for each kind of file the function that reads it, and a command that uses what was read.

A new reader is an entry of READERS and, where it reads a new kind of file, its valid content in `seeds.valid_files`.
"""

import io
import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from random import Random
from unittest.mock import patch

import mpmath
import numpy as np
import polars as pl

from tests.fuzz import expressions, mutate
from tests.fuzz.seeds import TINY
from tests.machines import ROOT
from trueaxis.codegen.check import faults_of_kinds
from trueaxis.codegen.numpy_source import numpy_source
from trueaxis.compensation.offsets import read_offsets
from trueaxis.compensation.tools import read_tools
from trueaxis.derivation.effect_terms import effect_routine
from trueaxis.effects.evaluate import sampled_parameters, sampled_positions, samples
from trueaxis.effects.expression import parse
from trueaxis.effects.placement import context_of
from trueaxis.evaluation.diagonal_test import diagonal_figures, diagonal_test
from trueaxis.evaluation.positioning_table_file import read_runs
from trueaxis.evaluation.positioning_test import evaluate
from trueaxis.fleets.fleet_file import read_fleet
from trueaxis.fleets.unit import chains_of
from trueaxis.instrument_files.data_folder import readings_bytes, renamed, setup_text
from trueaxis.instrument_files.data_run import ToolView, data_run
from trueaxis.instrument_files.read import positioning_test, read_instrument_file
from trueaxis.instrument_files.user_keys import UserKeys
from trueaxis.io.faults import Faults, InputError
from trueaxis.machine import Machine, read_machine
from trueaxis.machine.read import parse_machine
from trueaxis.measurement import table
from trueaxis.measurement.data import read_data
from trueaxis.measurement.points import read_points
from trueaxis.measurement.readings_reader import read_readings
from trueaxis.measurement.setup_reader import read_setup
from trueaxis.model.covariance_file import read_covariance
from trueaxis.model.errors import read_errors


@dataclass(frozen=True)
class Reader:
    """A kind of file and what is done with it.

    name: as `--only` takes it; file: the one of the valid files that is made hostile. read: called with its path and
    the machine; None where only the command is run. command: arguments, IN, OUT and KERNELS for folders; share: of the
    inputs that are given to the command where there is a function, too. every: seeds of which one is run, more than 1
    where a case takes long. change: makes a hostile file of a valid one.
    """

    name: str
    file: str
    read: Callable[[Path, Machine], object] | None
    command: tuple[str, ...] = ()
    share: float = 0.2
    every: int = 1
    change: Callable[[bytes, Random], bytes] = mutate.text


def _errors(path: Path, machine: Machine) -> object:
    return read_errors(path, machine=machine.name, components=machine.components, parameters=machine.parameters,
                       effects=machine.effects, kinds=machine.kinds)  # fmt: skip


def _covariance(path: Path, machine: Machine) -> object:
    return read_covariance(path, machine)


def expression_machine(text: str, file: str) -> Machine:
    """A machine with a kind of that expression. Raises InputError."""
    quoted = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", " ")
    return parse_machine(TINY.replace('"a*sin(q/p)"', f'"{quoted}"'), Faults(file))


def _expression(path: Path, machine: Machine) -> object:
    """Its kernel, where it is not refused, has finite values and derivatives, and those of another arithmetic."""
    text = path.read_bytes().decode(errors="replace")
    machine = expression_machine(text, str(path))
    if found := faults_of_kinds(machine, str(path)):
        return found
    kind = machine.effect_kinds[-1]
    namespace: dict[str, Callable[..., np.ndarray]] = {}
    exec(numpy_source(machine, (effect_routine(kind),)), namespace)
    draw = Random(0)
    positions, grids = sampled_positions(machine.travel.values()), sampled_parameters(kind.parameters)
    for _, values in zip(range(8), samples(parse(kind.expression), positions, grids), strict=False):
        context = np.array([[values.get(name, 0.0)] for name in context_of(kind)])
        with np.errstate(all="ignore"):
            term = namespace["effect_wave"](context, np.array([values.get("a", 0.0), values.get("p", 0.0)]))[:, 0]
        assert np.isfinite(term).all(), f"{text!r} is {term} at {values}"
        near = [expressions.value(text, values, draw) for _ in range(4)]
        wanted = expressions.value(text, values)
        if wanted is None or any(one is None or abs(one - wanted) > abs(wanted) * mpmath.mpf(1e-8) for one in near):
            continue  # a step, or digits that cancel: what is right depends on the last digit
        if abs(wanted) > 1e-290:
            assert abs(term[0] - wanted) <= 1e-6 * abs(wanted), f"{text!r} is {term[0]}, not {wanted}, at {values}"
    return None


def _positioning_test(path: Path, _: Machine) -> object:
    return evaluate(positioning_test(path), "iso")


def _diagonals(path: Path, _: Machine) -> object:
    runs = [(str(path), name, test) for name, test in read_runs(path, fewest_cycles=1).items()]
    return diagonal_figures(diagonal_test(runs, {"X": 60.0, "Y": 80.0}, str(path)))


def _machine(path: Path, _: Machine) -> object:
    return read_machine(path)


def _frame(path: Path, machine: Machine) -> object:
    """As in `_readings`, but parsed in this process: the bytes are right, and a process of its own takes long."""
    with patch.object(table, "_parquet", lambda data, _: table.Table(pl.read_parquet(io.BytesIO(data)), None)):
        return read_readings(path, machine, None)


def _readings(path: Path, machine: Machine) -> object:
    return read_readings(path, machine, None)


def _offsets(path: Path, _: Machine) -> object:
    return read_offsets(path)


def _tools(path: Path, _: Machine) -> object:
    return read_tools(path)


def _fleet(path: Path, _: Machine) -> object:
    """Its machines, and the folders that their patterns match."""
    fleet = read_fleet(path)
    return [chain.row or chain.units for chain in chains_of(fleet, path.parent / "out")]


def _instrument(path: Path, machine: Machine) -> object:
    """What `import` makes of the file reads back as a data folder."""
    given = {f"at.{axis}": repr(sum(machine.travel[axis]) / 2) for axis in machine.axes}
    given |= {"axis": machine.axes[0], "target.point": "0,0,0", "reference.point": "0,0,0", "direction": "1,0,0"}
    unit = "urad" if path.suffix == ".rta" else "um"
    keys = UserKeys(given=given | {"length": "0.5", "plane": "XY", "unit.reading": unit})
    sources = read_instrument_file(path, None, keys)
    runs = [data_run(source, machine, keys, ToolView(lambda _, point: point)) for source in sources]
    if faults := [*keys.faults, *(question.fault for question in keys.questions)]:
        raise InputError(faults)
    ready = renamed(tuple(run for run in runs if run is not None))
    folder = path.with_suffix(".imported")
    folder.mkdir()
    (folder / "setup.toml").write_text(setup_text(ready, machine.name, None))
    (folder / "readings.csv").write_bytes(readings_bytes(ready, machine.axes))
    read_data(folder, machine)  # raises InputError of another file where it does not
    return ready


_MODEL = ("IN/machine.toml", "--errors", "IN/errors.json", "--kernels", "KERNELS")
_PREDICT = ("predict", *_MODEL, "--at", "IN/points.csv", "--out", "OUT/p.csv")
_WITH_U = (*_PREDICT, "--covariance", "IN/errors.npz")
_SIMULATE = ("simulate", *_MODEL, "--data", "IN/data", "--out", "OUT/data", "--replace", "--noise-um", "0.1")
_IDENTIFY = ("identify", "IN/machine.toml", "--kernels", "KERNELS", "--data", "IN/data", "--out", "OUT/e.json")
_GLOBAL = (*_IDENTIFY, "--method", "global", "--prior", "none", "--noise-um", "1", "--degree", "3")
_COMPENSATE = ("compensate", *_MODEL, "--report", "OUT/r.json", "--out", "OUT/p.nc")
_FANUC = (*_COMPENSATE, "--dialect", "fanuc", "--tools", "IN/tools.toml")
_FIT = ("fit", "IN/machine.toml", "--errors", "IN/errors.json", "--out", "OUT/e.json")
_PLAN = ("plan", "IN/machine.toml", "--kernels", "KERNELS", "--data", "IN/data")
_DIAGNOSE = ("diagnose", *_MODEL, "--data", "IN/data", "--out", "OUT/found")
_IMPORT = ("import", "IN/laser.csv", "--machine", "IN/machine.toml", "--out", "OUT/data", "--kernels", "KERNELS")
_EVALUATE = ("evaluate", "--out", "OUT/e.json")

READERS = (
    Reader("machine", "machine.toml", _machine, _PREDICT, 0.05),
    Reader("derive", "tiny.toml", _machine, ("derive", "IN/tiny.toml", "--out", "OUT/k"), 0.02),
    Reader("expression", "expression.txt", _expression, every=2),
    Reader("setup", "data/setup.toml", read_setup, _SIMULATE),
    Reader("setup-identify", "data/setup.toml", None, _GLOBAL, every=10),
    Reader("setup-plan", "data/setup.toml", None, _PLAN, every=30),
    Reader("readings", "data/readings.csv", _readings, _SIMULATE),
    Reader("readings-identify", "data/readings.csv", None, _IDENTIFY, every=3),
    Reader("readings-global", "data/readings.csv", None, _GLOBAL, every=10),
    Reader("readings-diagnose", "data/readings.csv", None, _DIAGNOSE, every=400),
    Reader("parquet", "data/readings.parquet", _frame, change=mutate.frame),
    Reader("parquet-bytes", "data/readings.parquet", _readings, _SIMULATE, change=mutate.parquet, every=50),
    Reader("points", "points.csv", read_points, _PREDICT),
    Reader("errors", "errors.json", _errors, _PREDICT, 0.5),
    Reader("errors-fit", "errors.json", None, _FIT, every=5),
    Reader("errors-compensate", "errors.json", None, (*_COMPENSATE, "IN/program.nc"), every=2),
    Reader("covariance", "errors.npz", _covariance, _WITH_U, 0.5, 1, mutate.archive),
    Reader("nc", "program.nc", None, (*_COMPENSATE, "IN/program.nc")),
    Reader("apt", "program.apt", None, (*_COMPENSATE, "IN/program.apt")),
    Reader("siemens", "program.mpf", None, (*_COMPENSATE, "IN/program.mpf")),
    Reader("klartext", "program.h", None, (*_COMPENSATE, "IN/program.h")),
    Reader("fanuc", "fanuc.nc", None, (*_FANUC, "--offset", "G54.1P3=X0.5,Y0.5,Z0.5", "IN/fanuc.nc")),
    Reader("tcp", "tcp.nc", None, (*_FANUC, "IN/tcp.nc")),
    Reader("offsets-var", "linuxcnc.var", _offsets, (*_COMPENSATE, "--offsets", "IN/linuxcnc.var", "IN/program.nc")),
    Reader("offsets-toml", "offsets.toml", _offsets, (*_COMPENSATE, "--offsets", "IN/offsets.toml", "IN/program.nc")),
    Reader("tools-tbl", "tool.tbl", _tools, (*_COMPENSATE, "--tools", "IN/tool.tbl", "IN/program.nc")),
    Reader("tools-toml", "tools.toml", _tools, (*_COMPENSATE, "--tools", "IN/tools.toml", "IN/program.nc")),
    Reader("fleet", "fleet.toml", _fleet),
    Reader("iso230-table", "test.csv", _positioning_test, (*_EVALUATE, "IN/test.csv")),
    Reader("iso230-dat", "test.dat", _positioning_test, (*_EVALUATE, "IN/test.dat")),
    Reader("iso230-rtl", "laser.rtl", _positioning_test, (*_EVALUATE, "IN/laser.rtl")),
    Reader("diagonals", "diagonals.csv", _diagonals, (*_EVALUATE, "IN/diagonals.csv", "--diagonals", "X=60", "Y=80")),
    Reader("rtl", "laser.rtl", _instrument),
    Reader("rta", "laser.rta", _instrument),
    Reader("laser-csv", "laser.csv", _instrument, (*_IMPORT, "--map", "target.point=0,0,0", "direction=0,0,1")),
    Reader("ballbar-csv", "bar.csv", _instrument),
)
# What the watch over the process must see: a reader that does not return, and one that takes the process with it.
DRILLS = (
    Reader("hangs", "points.csv", lambda *_: time.sleep(1000)),
    Reader("dies", "points.csv", lambda *_: os._exit(0)),
)
KERNELS = ROOT / "generated"
