"""What a machine's model lacks, named from what it leaves unexplained in measured data."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from html import escape
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

import polars as pl

from trueaxis.identification.notes import compensation_note
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering
from trueaxis.io.safe_text import html_table
from trueaxis.jobs.beside import beside
from trueaxis.jobs.derive import identification_runs
from trueaxis.jobs.extending import SECOND, Extending, Given, Start, contents_of, outputs, spec_text
from trueaxis.jobs.given import files_of, kernels_of, warn_of_misfit, with_errors
from trueaxis.jobs.identify import believed, check_noise
from trueaxis.jobs.load import DataFolder, Errors
from trueaxis.jobs.outputs import overwritten
from trueaxis.jobs.tables import Tabular
from trueaxis.jobs.typed import AnyPath, typed
from trueaxis.machine import Machine, read_machine
from trueaxis.measurement.active_compensation import active_file
from trueaxis.measurement.data import MeasuredData
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel
from trueaxis.own_python import cores
from trueaxis.reporting.reliance import misfit_sentence

if TYPE_CHECKING:
    from trueaxis.derivation.systems import RunPattern
    from trueaxis.diagnosis.result import Diagnosis


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Diagnosed(Tabular):
    """What the model lacks. diagnosis: verdict, causes, evidence, gain, checks; machine: with the causes named, spec:
    the text of its file, values: of its errors, identified anew; all three None where no cause extends it; files: that
    were written; notes: of the values given and of the readings. Printed, it is the report of `trueaxis diagnose`.
    """

    diagnosis: "Diagnosis" = field(repr=False)
    machine: Machine | None
    spec: str | None = field(repr=False)
    values: ErrorValues | None = field(repr=False)
    files: tuple[Path, ...]
    notes: tuple[str, str]

    @property
    def verdict(self) -> str:
        """Of the diagnosis, see docs/diagnosis.md."""
        return self.diagnosis.verdict

    def to_polars(self) -> pl.DataFrame:
        """A row for each parameter of each cause: its value and standard uncertainty, in `unit`, and the evidence."""
        rows = [
            (one.effect.kind, one.effect.component, part.name, part.value, part.u, part.unit, one.p_value,
             one.held_out_gain, "; ".join(rival.effect.label for rival in one.rivals))
            for one in self.diagnosis.causes
            for part in one.parameters
        ]  # fmt: skip
        texts, numbers = pl.String, pl.Float64
        schema = {
            "effect": texts, "component": texts, "parameter": texts, "value": numbers, "u": numbers, "unit": texts,
            "p_value": numbers, "held_out_gain": numbers, "cannot_be_told_from": texts,
        }  # fmt: skip
        return pl.DataFrame(rows, schema=schema, orient="row")

    def html(self) -> str:
        """The page that the command writes as report.html."""
        from trueaxis.reporting.diagnosis.figures import pictures_of  # noqa: PLC0415
        from trueaxis.reporting.diagnosis.html import report_html  # noqa: PLC0415  Jinja2 and matplotlib: for who asks

        return report_html(self.diagnosis, pictures_of(self.diagnosis))

    def __str__(self) -> str:
        from trueaxis.reporting.diagnosis.text import summary_text  # noqa: PLC0415  as the diagnosis itself

        before, behind = (f"note: {one}\n" if one else "" for one in self.notes)
        return before + summary_text(self.diagnosis) + behind

    def _repr_html_(self) -> str:
        frame = self.to_polars()
        table = html_table(f"{self.diagnosis.machine}: {self.verdict}", frame.columns, frame.rows())
        return f"{table}<pre>{escape(str(self))}</pre>"


@typed
def diagnose(
    model: MachineModel,
    data: DataFolder,
    errors: Errors | None = None,
    *,
    noise_um: float | None = None,
    out: AnyPath | None = None,
) -> Diagnosed:
    """Name what a machine's model lacks: the causes of the effect library (docs/effects.md) that explain the residuals
    of the readings.

    errors: None: all zero, the nominal machine. noise_um: standard deviation of a reading, um (from repeats). out:
    a folder for diagnosis.json, report.html and, if causes were named, the extended model: NAME.toml, errors.json
    and generated/NAME/. Raises InputError if no reading can be used, the spec was changed since it was loaded, or
    an output is an input; ValueError for arguments of another form. Where the values of the extended machine do not
    converge there is none.
    """
    check_noise(noise_um)
    machine, folder = model.machine, None if out is None else Path(out)
    source = machine.source
    if source is None:
        raise ValueError(
            "model: expected one whose spec is in a file (load_model): the extended spec is written from it"
        )
    target = folder or source.parent
    found = faults_of_target(target)
    inputs = {"the spec": source, "data": data.folder, **files_of(errors)}
    inputs["the active compensation of the data"] = active_file(data.folder, data.data.setup)
    written = {} if folder is None else outputs_of(folder, model.name)
    found += overwritten(inputs, {f"{name} of out": path for name, path in written.items()}, kernels_of(model))
    runs: tuple[RunPattern, ...] = ()
    text = ""
    with gathering(found):
        runs = identification_runs(machine, source)
    with gathering(found):
        text = spec_text(source, target)
        if read_machine(source).digest != machine.digest:
            raise InputError([Fault(str(source), "", "was changed since the model was loaded", "load it again")])
    if found := found + faults_of_data(data.data, data.folder, found):
        raise InputError(found)
    warn_of_misfit(errors)
    model = model.with_values(ErrorValues(machine=machine.name)) if errors is None else with_errors(model, errors)
    given = Given(
        model=model, covariance=None if errors is None else errors.covariance,
        data=believed(model, data, model.errors), folder=data.folder, spec=text, runs=runs,
    )  # fmt: skip
    if folder is None:
        return diagnosed(given, target, noise_um, _here, write=False)
    with beside(SECOND) as start:
        return diagnosed(given, folder, noise_um, start)


def diagnosed(
    given: Given,
    out: Path,
    noise_um: float | None,
    start: Start,
    show: Callable[[str], None] = lambda _: None,
    *,
    write: bool = True,
) -> Diagnosed:
    """As `diagnose`. out: the folder that is written, or for which the spec would read as it does; start: has things
    done beside; show: told each stage.
    """
    # slow to import, and not for wrong input
    from trueaxis.diagnosis.procedure import DiagnoseOptions  # noqa: PLC0415
    from trueaxis.diagnosis.procedure import diagnose as procedure  # noqa: PLC0415

    extending = Extending(out, given, start)
    with ThreadPoolExecutor(cores()) as pool:
        found = procedure(
            given.model,
            given.data,
            DiagnoseOptions(
                noise_um=noise_um, covariance=given.covariance, progress=show, each=pool.map, extend=extending
            ),
        )
    show("report")
    contents = contents_of(out, given, found, extending) if write else {}
    write_files(contents)
    fit, key = given.model.errors.fit, given.data.setup.compensation
    extended = extending.extended if found.values is not None else None
    return Diagnosed(
        diagnosis=found,
        machine=None if extended is None else extended.machine,
        spec=None if extended is None else extended.text,
        values=found.values,
        files=tuple(contents),
        notes=(
            misfit_sentence(fit) if fit is not None and fit.state == "misfit" else "",
            "" if key is None or key.file is None else compensation_note(given.data.setup, given.folder),
        ),
    )


def left_behind(out: Path, done: Diagnosed) -> list[Path]:
    """Files of an earlier diagnosis in the folder that are no part of this one."""
    return [path for path in outputs(out, done.diagnosis.machine) if path not in done.files and path.exists()]


def faults_of_target(out: Path) -> list[Fault]:
    """Of a folder that is to be written."""
    return [Fault(str(out), "", "is a file", "a folder for --out")] if out.exists() and not out.is_dir() else []


def faults_of_data(data: MeasuredData, folder: Path, before: list[Fault]) -> list[Fault]:
    """Where there is no reading to go by; before: faults so far, with which readings are not looked at closely."""
    from trueaxis.diagnosis.null_model.rows import rows_of  # noqa: PLC0415  as the diagnosis itself

    if data.readings.planned.all():
        remedy = "take them, or make some with simulate"
        return [Fault(str(folder), "column reading", "is a plan: there is no reading in it", remedy)]
    if not before and rows_of(data).size == 0:
        problem = "in none of them is it known from where all moving axes came, away from a reversal"
        return [Fault(str(folder), "readings", problem, "columns dir_X ..., or more readings a run")]
    return []


def outputs_of(out: Path, name: str) -> dict[str, Path | None]:
    """Every file that may be written, by what it is to a user."""
    return {str(path.relative_to(out)): path for path in outputs(out, name)}


def _here(function: str, *arguments: Any) -> Callable[[], object]:
    """What gives the result of a function of SECOND when it is asked for, in this process."""
    return lambda: getattr(import_module(SECOND), function)(*arguments)
