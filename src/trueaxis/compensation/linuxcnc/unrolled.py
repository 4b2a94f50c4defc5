"""Compensation of a program that LinuxCNC's interpreter unrolls: which settings go with it, what its report says."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby
from pathlib import Path

import numpy as np

from trueaxis.compensation.datum import Datum, datum_shift
from trueaxis.compensation.dialects import head_of
from trueaxis.compensation.linuxcnc.blocks import Unrolled
from trueaxis.compensation.linuxcnc.interpreter import unroll
from trueaxis.compensation.linuxcnc.modes import PASSED
from trueaxis.compensation.linuxcnc.source import offset_faults
from trueaxis.compensation.machine import ErrorModel, rotary_rows
from trueaxis.compensation.moves import Notes
from trueaxis.compensation.nc import m_codes
from trueaxis.compensation.nc.modes import EXACT_SINCE
from trueaxis.compensation.nc.tool_codes import IN_SPINDLE
from trueaxis.compensation.offsets import Offsets, middle
from trueaxis.compensation.overview import foreign_alone
from trueaxis.compensation.report import CompensationReport
from trueaxis.compensation.settings import Language, Settings
from trueaxis.compensation.touched_off import OPTION as TOUCHED_OFF
from trueaxis.compensation.tracker import acting
from trueaxis.io.faults import Fault, InputError

UNROLLED = (
    "LinuxCNC's interpreter has unrolled the program: what is written is in machine coordinates (G59.3 is set to 0): "
    "offsets, tool lengths and diameters that were given are in its words, and must be those of the control exactly; "
    "its N words, and lines in this report, are lines of the source; comments but for messages are left out"
)
KEEP_G53 = Fault(
    "--keep-g53", "", "does not go with --via-linuxcnc, whose interpreter does not say which motions G53 makes",
    "leave it out: taught places are then compensated, too; or write the blocks out, and leave out --via-linuxcnc",
)  # fmt: skip


def check_unrolled(settings: Settings, language: Language, model: ErrorModel) -> None:
    """Faults of what does not go with --via-linuxcnc."""
    if language == "apt" or settings.dialect not in (None, "linuxcnc"):
        given = "a CL file" if language == "apt" else f"--dialect {settings.dialect}"
        problem = f"makes programs for LinuxCNC of programs for LinuxCNC, and this is {given}"
        raise InputError([Fault("--via-linuxcnc", "", problem, "have macros and subprograms written out by the post")])
    if settings.touched_off and rotary_rows(model.axes):
        problem = "does not go with --via-linuxcnc on a machine with rotary axes, with which the datum turns"
        raise InputError([Fault(TOUCHED_OFF, "", problem, "set the work offsets with compensated positions")])
    if settings.keep_g53:
        raise InputError([KEEP_G53])


def unrolled_first(
    program: Path, model: ErrorModel, settings: Settings, package: Path, name: str, notes: Notes
) -> tuple[Unrolled, Settings]:
    """The program unrolled by LinuxCNC's interpreter, and the settings with which what comes out is read."""
    offsets = settings.offsets
    if settings.touched_off:
        if faults := offset_faults(program.read_bytes(), name):
            raise InputError(faults)
        offsets = _at_true_zeros(model, settings, notes)
    with foreign_alone(name, head_of(program)):
        made = unroll(
            program, package, offsets, settings.tools, name, settings.block_delete, model.axes,
            settings.reference_points, m_codes.TOOL_CHANGE in settings.pass_m, settings.spindle_tool,
        )  # fmt: skip
    notes.add(0, UNROLLED)
    if made.exact_since:
        notes.add(made.exact_since, EXACT_SINCE)
    if made.tool is not None and settings.spindle_tool is None:
        notes.add(0, IN_SPINDLE.format(made.tool))
    passed = (*settings.pass_m, *PASSED)
    return made, replace(
        settings, dialect="linuxcnc", judged=True, pass_m=passed, spindle_tool=made.tool, touched_off=()
    )  # fmt: skip


def _at_true_zeros(model: ErrorModel, settings: Settings, notes: Notes) -> Offsets:
    """The work offsets, those that were touched off where their zeros truly are: positions that are counted from there
    are right against the datum.
    """
    effects = acting(model, settings)
    still = model if effects is None else effects.at_rest
    point = np.array(settings.tool_point, dtype=np.float64)[:, np.newaxis]
    systems = dict(settings.offsets.systems)
    for system, group in groupby(sorted(settings.touched_off, key=lambda one: one.system), key=lambda one: one.system):
        touched, value = list(group), {axis: middle(of_axis) for axis, of_axis in systems[system].items()}
        at = np.array([[value.get(axis, 0.0)] for axis in model.axes])
        by = still.correction(at, datum_shift(still, touched, value, point))[:, 0]
        moved = {axis: float(way) for axis, way in zip(model.axes, by, strict=True)}
        systems[system] = {
            axis: (low + moved.get(axis, 0.0), high + moved.get(axis, 0.0))
            for axis, (low, high) in systems[system].items()
        }
        notes.add(0, Datum(touched, point, 0.0).zero(still, value).sentence(system))
    return replace(settings.offsets, systems=systems)


def of_source(report: CompensationReport, program: Path, vouched: Sequence[int]) -> CompensationReport:
    """The report of an unrolled program: what is read is the source, its offsets are in the words; vouched: M codes
    that the user names.
    """
    passed = tuple(one for one in report.passed if one.code in vouched)
    return replace(report, blocks_in=len(program.read_bytes().splitlines()), offsets=(), passed=passed)
