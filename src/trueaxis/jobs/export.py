"""Error values as compensation tables of a control, or as a kinematics module that it runs."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
import numpy.typing as npt

from trueaxis.compensation.reliance import PRIOR_SIZES
from trueaxis.controllers.formats import COMP, FORMATS, KINS, Export, Layout, export_module, export_tables, problem_of
from trueaxis.controllers.linuxcnc import ACTUAL, FILE_TYPES
from trueaxis.controllers.linuxcnc_kins import BEYOND, taken_by_module
from trueaxis.controllers.remaining import Remaining
from trueaxis.io.faults import Fault, InputError, RefusedError
from trueaxis.io.files import write_files
from trueaxis.jobs.given import Spelled, argument, check_fit, files_of, kernels_of, name_of, with_errors
from trueaxis.jobs.load import Errors
from trueaxis.jobs.outputs import overwritten
from trueaxis.jobs.printed import Printed
from trueaxis.jobs.tables import ORIGIN, above_zero, at_least_zero, tool_points
from trueaxis.jobs.typed import AnyPath, typed
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import FloatArray
from trueaxis.model.extent import UncertaintyExtent, travel_positions, uncertainty_extent
from trueaxis.model.manifest import verified_control_code
from trueaxis.model.measured_range import beyond_measured
from trueaxis.model.model import MachineModel
from trueaxis.model.uncertainty import prior_size
from trueaxis.reporting.export import (
    ACCEPT_WORSE,
    example_position,
    export_sentences,
    head_lines,
    left_text,
    module_limit_sentence,
    module_readme,
    worse_sentence,
)
from trueaxis.reporting.reliance import (
    error_free_sentences,
    extent_sentences,
    prior_sentences,
    travel_sentences,
    uncertain_sentence,
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Exported(Printed):
    """Tables of a control, or a module for it. texts: by the name of the file, the one name "" for a format of a single
    file; files: those that were written; remaining: RMS of the tool point over the travel, from home, mm, before and
    with them; uncertainty: of the tool point over the travel; notes: what must be known of them. Printed, it is the
    report of `trueaxis export`.
    """

    texts: Mapping[str, str] = field(repr=False)
    files: tuple[Path, ...]
    remaining: Remaining
    uncertainty: UncertaintyExtent
    notes: tuple[str, ...]

    def __str__(self) -> str:
        left = self.remaining
        worse = (
            f"warning: the error is larger with these tables than without them ({ACCEPT_WORSE})\n" if left.worse else ""
        )
        return (
            self.notes_text()
            + worse
            + (
                f"RMS of the tool point over the travel, from home: {left.before * 1e3:.3g} um, "
                f"{left_text(left.after)} left\n"
            )
        )

    def notes_text(self) -> str:
        """The notes, a line each."""
        return "".join(f"note: {one}\n" for one in self.notes)


@dataclass(frozen=True, slots=True, kw_only=True)
class ExportOptions:
    """As the arguments of `export`; kernels: folder whose files nothing may be written over; file_type: COMP_FILE_TYPE,
    None where it is not given.
    """

    step: float | None = None
    max_u: float | None = None
    max_correction: float | None = None
    accept_u: bool = False
    accept_worse: bool = False
    kernels: Path | None = None
    file_type: int | None = None


@typed
def export(
    model: MachineModel,
    errors: Errors,
    format: str,  # noqa: A002  the word of the command
    out: AnyPath | None = None,
    *,
    step: float | None = None,
    tool: npt.ArrayLike = ORIGIN,
    max_u: float | None = None,
    max_correction: float | None = None,
    accept_misfit: bool = False,
    accept_u: bool = False,
    accept_worse: bool = False,
    comp_file_type: int | None = None,
) -> Exported:
    """Write error values as tables that a control reads; docs/controllers has the formats, with their sources.

    format: "isg-csv", "siemens-enc", "siemens-cec", "heidenhain-com", "linuxcnc-comp" or "linuxcnc-kins" (sources of a
    kinematics module); out: the file to write, or the
    folder of a format of several; None: nothing is written. step: largest distance of positions in a table, mm or deg;
    tool: (3,), the point in the tool frame that tables of single axes are made for, and from which the module measures
    the lengths of tools, mm. max_u: largest standard
    uncertainty of the tool point over the travel, mm; max_correction: largest deviation, mm (three times what [prior]
    expects). accept_misfit, accept_u: accept values that do not fit their readings, or that are smaller than their
    noise; accept_worse: accept tables with which the error is larger than without them. comp_file_type: of
    "linuxcnc-comp", 0 (where the joint really is, the default) or 1 (what is added to the command).

    Raises RefusedError if a limit is exceeded, InputError if the machine cannot be exported, values are a misfit or
    `out` is an input; ValueError for arguments of another form.
    """
    if format not in FORMATS:
        raise ValueError(f"format: expected one of {', '.join(FORMATS)}; given {format!r}")
    if comp_file_type not in (None, *FILE_TYPES):
        raise ValueError(f"comp_file_type: expected 0 or 1; given {comp_file_type!r}")
    above_zero(step=step, max_correction=max_correction)
    at_least_zero(max_u=max_u)
    point = tool_points(tool, 1)
    model = with_errors(model, errors)
    check_fit(errors.values, name_of(errors), accept_misfit)
    options = ExportOptions(
        step=step, max_u=max_u, max_correction=max_correction, accept_u=accept_u, accept_worse=accept_worse,
        kernels=kernels_of(model), file_type=comp_file_type,
    )  # fmt: skip
    inputs = {"the spec": model.machine.source, **files_of(errors)}
    return exported(model, errors.covariance, format, None if out is None else Path(out), point, options, inputs)


def exported(
    model: MachineModel,
    covariance: Covariance,
    name: str,
    out: Path | None,
    tool: FloatArray,
    options: ExportOptions,
    inputs: Mapping[str, Path | None],
    spelled: Spelled = argument,
) -> Exported:
    """As `export`; model: with error values; tool: (3, 1); inputs: what nothing may be written over, by its name."""
    found = []
    if problem := problem_of(name, model, options.step):
        found.append(Fault(str(model.machine.source or model.name), f"{spelled('format')} {name}", problem))
    if options.file_type is not None and name != COMP:
        found.append(Fault(f"{spelled('format')} {name}", spelled("comp_file_type"), f"only {COMP} has types of files"))
    if found:
        raise InputError(found)
    positions = travel_positions(model, covariance)
    made = _made(name, model, tool, options, positions)
    contents = _contents(out, made)
    outputs: dict[str, Path | None] = {f"{path.name} of {spelled('out')}": path for path in contents}
    if found := overwritten(inputs, outputs, options.kernels):
        raise InputError(found)
    extent = uncertainty_extent(model, covariance, positions, tool)
    beyond = travel_sentences(beyond_measured(model.errors, model.axes, positions))
    refusals = _refusals(name, options, model, tool, positions, extent)
    if made.remaining.worse and not options.accept_worse:
        refusals.append(worse_sentence(name, made.remaining))
    if not refusals:
        write_files(contents)
    done = Exported(
        texts=made.files,
        files=() if refusals else tuple(contents),
        remaining=made.remaining,
        uncertainty=extent,
        notes=(
            *error_free_sentences(model.error_free),
            *export_sentences(name, model, made),
            *extent_sentences(extent, "over the travel"),
            *prior_sentences(model.errors, extent.components),
            *beyond,
        ),
    )
    if refusals:
        raise RefusedError(tuple(refusals), done)
    return done


def _made(name: str, model: MachineModel, tool: FloatArray, options: ExportOptions, positions: FloatArray) -> Export:
    """The files of a format, and what remains with them."""
    if name != KINS:
        layout = Layout(comments=head_lines(name, model), file_type=options.file_type or ACTUAL)
        return export_tables(name, model, tool, options.step, positions, layout)
    folder = Path(model.kernels.module.__file__ or "").parent
    spec = model.machine.source or f"{model.name}.toml"
    kernels = verified_control_code(folder, remedy=f"run: trueaxis derive {spec} --out {folder.parent}")
    made = export_module(model, tool, positions, kernels)
    moves = -taken_by_module(model, tool)(example_position(model), np.zeros(len(model.axes)))
    page = module_readme(model, tool, moves, export_sentences(name, model, made))
    return replace(made, files={**made.files, "README.md": page})


def _contents(out: Path | None, made: Export) -> dict[Path, bytes | str]:
    return {} if out is None else {out / name if name else out: text for name, text in made.files.items()}


def _refusals(
    name: str,
    options: ExportOptions,
    model: MachineModel,
    tool: FloatArray,
    positions: FloatArray,
    extent: UncertaintyExtent,
) -> list[str]:
    """Why nothing may be written."""
    sentences = []
    if extent.refused(options.max_u, options.accept_u):
        sentences.append(uncertain_sentence(extent, options.max_u))
    off = np.linalg.norm(model.deviation(positions, tool), axis=0)
    allowed = PRIOR_SIZES * prior_size(model, positions, tool)
    if options.max_correction is not None:
        allowed = np.full(off.size, options.max_correction)
    worst = int(np.argmax(off - allowed))
    if off[worst] > allowed[worst]:
        at = " ".join(f"{axis}{value:g}" for axis, value in zip(model.axes, positions[:, worst], strict=True))
        sentences.append(
            f"the tool point is off by {off[worst]:.4g} mm at {at}, more than {allowed[worst]:.4g} mm; "
            "--max-correction allows more, or larger sizes in [prior] of the spec, if the machine is that far off"
        )
    if name == KINS and off.max() > BEYOND:
        sentences.append(module_limit_sentence(float(off.max()), BEYOND))
    return sentences
