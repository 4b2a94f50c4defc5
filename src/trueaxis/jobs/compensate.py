"""An NC program in, the same with compensated positions out."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from io import BytesIO
from os import PathLike
from pathlib import Path
from typing import Unpack, get_args

import numpy as np
import numpy.typing as npt
import polars as pl

from trueaxis.compensation.files import compensated
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.reliance import Limits, judge_of
from trueaxis.compensation.report import Changes, CompensationReport
from trueaxis.compensation.settings import Language, Settings
from trueaxis.compensation.tools import ToolTable
from trueaxis.io.faults import Fault, InputError, RefusedError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering, said_of
from trueaxis.jobs.compensation_arguments import (
    CompensationSettings,
    Tools,
    WorkOffsets,
    offsets_of,
    settings_of,
    tools_of,
)
from trueaxis.jobs.drawn_program import DrawnProgram, Remembering, drawn_program
from trueaxis.jobs.draws import checked, faults_of_draws
from trueaxis.jobs.given import check_fit, files_of, kernels_of, name_of, with_errors
from trueaxis.jobs.load import Errors
from trueaxis.jobs.outputs import overwritten
from trueaxis.jobs.printed import Printed
from trueaxis.jobs.tables import ORIGIN, Tabular, above_zero, at_least_zero, tool_points
from trueaxis.jobs.typed import AnyPath, typed
from trueaxis.model.curves import FloatArray
from trueaxis.model.model import MachineModel
from trueaxis.monte_carlo.settings import Draws
from trueaxis.reporting.compensation import compensation_text
from trueaxis.reporting.compensation_checks import tool_frame_sentences
from trueaxis.reporting.reliance import (
    draw_sentences,
    error_free_sentences,
    prior_sentences,
    program_sentences,
    refusal_sentences,
)


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Compensated(Printed, Tabular):
    """A compensated program. text: of the program; report: counts, lengths of error vectors, what was assumed;
    `report.good` says whether every point converged, is within tolerance and travel. axes: letters, the rows of
    positions; lines: (n,), of the given program; programmed, compensated: (n_axes, n), mm or deg, ends of motions with
    those of chords and cuts (2.5 mm apart or less on arcs that stay arcs), as programmed (NaN where an axis has no
    known position) and as the words that were written name them; in machine coordinates, under tool centre point
    control those of the tip. file: where it was written, None where it was not; notes: how far it may be relied on;
    left: with draws, the error that is left. Printed, it is the report of `trueaxis compensate`.
    """

    text: str = field(repr=False)
    report: CompensationReport
    axes: tuple[str, ...]
    lines: npt.NDArray[np.int64]
    programmed: FloatArray
    compensated: FloatArray
    file: Path | None
    notes: tuple[str, ...]
    left: DrawnProgram | None = None

    @property
    def correction(self) -> FloatArray:
        """(n_axes, n): compensated less programmed positions, mm or deg."""
        return self.compensated - self.programmed

    def to_polars(self) -> pl.DataFrame:
        """A row for each point: line, programmed positions (X ...), compensated ones (X_compensated ...)."""
        columns = dict(zip(self.axes, self.programmed, strict=True))
        columns |= {f"{axis}_compensated": row for axis, row in zip(self.axes, self.compensated, strict=True)}
        return pl.DataFrame({"line": self.lines, **columns}).fill_nan(None)

    def __str__(self) -> str:
        return "\n".join([compensation_text(self.report), *(f"note: {one}" for one in self.notes)]) + "\n"


@typed
def compensate(
    model: MachineModel,
    errors: Errors,
    program: AnyPath,
    out: AnyPath | None = None,
    *,
    tool: npt.ArrayLike = ORIGIN,
    offsets: WorkOffsets | None = None,
    tools: Tools | None = None,
    format: Language | None = None,  # noqa: A002  the word of the command
    via_linuxcnc: AnyPath | None = None,
    max_u: float | None = None,
    max_correction: float | None = None,
    accept_misfit: bool = False,
    accept_u: bool = False,
    draws: Draws | int | None = None,
    **settings: Unpack[CompensationSettings],
) -> Compensated:
    """Rewrite an NC program (ISO 6983 / RS-274) or an APT cutter location file so that geometric errors no longer move
    the tool (Eqs. 55, 56 of the paper).

    program: the path of its file; out: the file to write; None: nothing is written, the result has the text. tool:
    (3,), the point to be compensated, tool frame, mm. offsets: the file of work offsets, or by name the machine
    position of their zeros, {"G54": {"X": 1.0, "Y": 2.0, "Z": (0, 5)}}, mm or deg; a pair: the worst case. tools: the
    file of the tools, or by number a length, mm, or a `Tool`. format: "nc" or "apt"; via_linuxcnc: the folder of
    LinuxCNC, whose interpreter expands the program first. max_u: largest standard uncertainty of the tool point in the
    program, from home, mm; max_correction: largest correction, mm (three times what [prior] expects).
    accept_misfit, accept_u: accept values that do not fit their readings, or that are smaller than their noise. draws:
    number of draws of the remaining error of the tool at points of the program, see `predict`.
    settings: see `CompensationSettings`.

    Raises InputError with every fault of the program and of files; RefusedError where a limit is passed, and nothing is
    written; ValueError or TypeError for arguments of another form.
    """
    above_zero(max_correction=max_correction)
    at_least_zero(max_u=max_u)
    asked = checked(draws)
    if format not in (None, *get_args(Language)):
        raise ValueError(f"format: expected nc or apt; given {format!r}")
    source, file, unrolled = _file(program), *(None if one is None else Path(one) for one in (out, via_linuxcnc))
    given = settings_of(settings) | {"tool_point": tuple(tool_points(tool, 1)[:, 0].tolist())}
    model, given["offsets"], given["tools"] = _read(model, errors, source, file, offsets, tools, accept_misfit)
    if asked is not None:
        _check_draws(errors)
    limits = Limits(max_u=max_u, max_correction=max_correction, accept_u=accept_u)
    changes, buffer = Changes(len(model.axes)), BytesIO()
    judge, chosen = Remembering(judge_of(model, errors.covariance, limits)), of_machine(Settings(**given), model)
    with as_faults(source):
        report = compensated(
            source, lambda: buffer, model, chosen, language=format, judge=judge, changes=changes, via_linuxcnc=unrolled
        )
        if file is not None and not report.refused:
            write_files({file: buffer.getvalue()})
    left = None
    if asked is not None and not report.refused:
        left = drawn_program(model, errors.covariance, judge.visited, chosen, asked)
    done = _done(report, buffer.getvalue(), changes, file, model, left)
    if report.reliance is not None and report.refused:
        raise RefusedError(tuple(refusal_sentences(report.reliance, max_u)), done)
    return done


def _check_draws(errors: Errors) -> None:
    if wrong := faults_of_draws(errors.covariance, 1, name_of(errors)):
        raise InputError(wrong)


def _done(
    report: CompensationReport, written: bytes, changes: Changes, file: Path | None, model: MachineModel,
    left: DrawnProgram | None,
) -> Compensated:  # fmt: skip
    """The result; nothing of a program that is refused."""
    return Compensated(
        text="" if report.refused else written.decode("latin-1"), report=report, axes=model.axes, lines=changes.lines,
        programmed=changes.programmed, compensated=changes.compensated, file=None if report.refused else file,
        notes=(*notes_of(report, model), *notes_of_draws(left)), left=left,
    )  # fmt: skip


def _read(
    model: MachineModel,
    errors: Errors,
    program: Path,
    out: Path | None,
    offsets: WorkOffsets | None,
    tools: Tools | None,
    accept_misfit: bool,
) -> tuple[MachineModel, Offsets, ToolTable | None]:
    """The model with the values, work offsets and tools. Raises InputError with the faults of all that is read."""
    found: list[Fault] = []
    table, systems = None, Offsets()
    with gathering(found):
        systems = offsets_of(offsets)
    with gathering(found):
        table = tools_of(tools)
    with gathering(found):
        model = with_errors(model, errors)
        check_fit(errors.values, name_of(errors), accept_misfit)
    files = {"offsets": offsets, "tools": tools}
    inputs = {"the spec": model.machine.source, **files_of(errors), "program": program}
    inputs |= {name: Path(one) for name, one in files.items() if isinstance(one, str | PathLike)}
    found += overwritten(inputs, {"out": out}, kernels_of(model))
    if found:
        raise InputError(found)
    return model, systems, table


def of_machine(settings: Settings, model: MachineModel) -> Settings:
    """The settings with what the spec says of programs: where axes stand before one, the reference points."""
    points = {code: dict(position) for code, position in model.machine.reference_points}
    return replace(settings, assumed=dict(model.machine.start), reference_points=points)


def notes_of(report: CompensationReport, model: MachineModel) -> tuple[str, ...]:
    """How far the program may be relied on, in sentences."""
    found = error_free_sentences(model.error_free)
    if report.tools:
        found += tool_frame_sentences(model.machine, model.errors.parameters)
    if report.reliance is not None:
        found += program_sentences(report.reliance)
        found += prior_sentences(model.errors, report.reliance.uncertainty.components)
    return tuple(found)


def notes_of_draws(left: DrawnProgram | None) -> tuple[str, ...]:
    """What draws say, in sentences."""
    return () if left is None else tuple(draw_sentences(left.drawn, left.axes, left.positions, with_noise=False))


@contextmanager
def as_faults(program: Path) -> Iterator[None]:
    """What the system cannot read or write is a fault of the program's file, or of the one that it names."""
    try:
        yield
    except OSError as problem:
        name = problem.filename or program
        raise InputError([Fault(str(name), "", *said_of(problem))]) from None


def _file(program: AnyPath) -> Path:
    """A path, and never the text of a program: every other `str` of this interface names a file, too."""
    if isinstance(program, str) and "\n" in program:
        lines = program.count("\n") + 1
        raise ValueError(f"program: expected the path of a file; given a text of {lines} lines: write it to a file")
    return Path(program)
