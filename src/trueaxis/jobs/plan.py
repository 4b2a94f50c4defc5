"""What runs will tell before they are made, and which runs to make."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
import numpy.typing as npt
import polars as pl

from trueaxis.estimation.result import Estimate
from trueaxis.identification.notes import dimension_notes
from trueaxis.io.faults import Fault, InputError, RefusedError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import utf8_text
from trueaxis.jobs.given import Spelled, argument, faults_of_runs, files_of, kernels_of, warn_of_misfit
from trueaxis.jobs.identify import Noise, believed, noise_model
from trueaxis.jobs.load import DataFolder, Errors, load_data
from trueaxis.jobs.outputs import overwritten
from trueaxis.jobs.plan_request import PlanDatum, PlanRequest, faults_of_request, outputs_of
from trueaxis.jobs.printed import Printed
from trueaxis.jobs.tables import ORIGIN, Tabular
from trueaxis.jobs.typed import AnyPath, typed
from trueaxis.measurement import readings as readings_files
from trueaxis.measurement import setup as setup_file
from trueaxis.measurement.active_compensation import moved_setup
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.instrument_kinds import Instrument
from trueaxis.measurement.readings import dump_readings
from trueaxis.measurement.setup import Vector
from trueaxis.model.curves import Curve, PolynomialCurve
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel
from trueaxis.planning.judge import slices
from trueaxis.planning.method import PlanOptions, Proposed, first_plan, judged_plan, proposed
from trueaxis.planning.propose import VOLUME
from trueaxis.planning.report import PlanReport
from trueaxis.planning.report_text import report_json, report_text
from trueaxis.planning.runs import PlannedRuns, new_setup, setup_text


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Planned(Printed, Tabular):
    """What runs will tell. report: u to expect of every error and of the tool point over the volume, proposals;
    expected: the estimate to expect, of the plan with the runs proposed; tools: points whose uncertainty counts;
    contents: of the folder with the proposed runs, by the name of the file, empty where none were; folder: where it was
    written, None where it was not. Printed, it is the report of `trueaxis plan`.
    """

    report: PlanReport
    expected: Estimate = field(repr=False)
    tools: tuple[Vector, ...]
    contents: dict[str, str | bytes] = field(repr=False)
    folder: Path | None

    @property
    def data(self) -> DataFolder:
        """The plan that was written, to be simulated or measured. Raises ValueError where none was."""
        if self.folder is None:
            raise ValueError("data: this plan is in no folder; plan(..., out=FOLDER) writes one")
        return load_data(self.folder, self.expected.layout.model)

    def to_polars(self) -> pl.DataFrame:
        """A row for each component and location error: by what it will be determined, u, its root mean square over the
        travel, what [prior] lets expect, mm or rad; with the runs proposed where there are some.
        """
        proposal = self.report.proposal
        found = self.report.expected if proposal is None else proposal.after
        rows = [] if found is None else [*found.components, *found.locations]
        numbers = dict.fromkeys(("u", "u_rms", "prior"), pl.Float64)
        schema = {"error": pl.String, "state": pl.String, "unit": pl.String, **numbers}
        table = [(one.name, one.state, one.unit, one.u, one.u_rms, one.prior) for one in rows]
        return pl.DataFrame(table, schema=schema, orient="row").fill_nan(None)

    def to_json(self) -> str:
        """The report as `--report` of the command has it."""
        return report_json(self.report)

    def picture(self) -> bytes:
        """The uncertainty of the tool point on slices through the volume, as PNG."""
        from trueaxis.reporting.pictures.tool_point import uncertainty_picture  # noqa: PLC0415  matplotlib takes long to import

        return uncertainty_picture(slices(self.expected, self.tools))

    def __str__(self) -> str:
        return report_text(self.report)


@typed
def plan(
    model: MachineModel,
    data: DataFolder | None = None,
    *,
    instruments: Sequence[Instrument] = (),
    hours: float | None = None,
    runs: Sequence[str] = (),
    propose: int | None = None,
    propose_with: Sequence[Instrument] = (),
    wanted: str = VOLUME,
    datum: PlanDatum = "home",
    noise_um: Noise = None,
    noise_urad: float | None = None,
    known: Errors | None = None,
    effects: Errors | None = None,
    location_errors_only: bool = False,
    tool: npt.ArrayLike = ORIGIN,
    out: AnyPath | None = None,
) -> Planned:
    """Say how well the runs of `data` will determine the errors, or, without it, make a first plan with `instruments`.

    runs: ids of those that are judged (all). propose: how many runs to add, those that lower the uncertainty most per
    minute, with propose_with (the instruments of the plan). wanted: the error that proposed runs determine best,
    "volume", a component such as "EYX" or a location error; datum: reference of the tool point for them. noise_um: of a
    reading, um, or by name of an instrument or run (from [device] tables, else 1); noise_urad: of angle instruments.
    known: known values; hours: at most, for a first plan; effects: values of effects to plan for; location_errors_only:
    error motions are no unknowns. tool: (3,) or (3, n), points in the tool frame, mm, whose mean uncertainty counts.
    out: a folder to write, the plan with runs proposed.

    Raises InputError if arguments do not go together, or the plan contradicts the machine; RefusedError if no run
    determines what is asked for; ValueError for arguments of another form.
    """
    request = PlanRequest(
        instruments=instruments, hours=hours, runs=runs, propose=propose, propose_with=propose_with, wanted=wanted,
        datum=datum, noise=noise_model(noise_um, noise_urad), location_errors_only=location_errors_only,
        tools=_points(tool), out=None if out is None else Path(out),
    )  # fmt: skip
    folder = None if data is None else data.folder
    inputs = {"the spec": model.machine.source, "data": folder, **files_of(known)}
    inputs |= {f"{name} of the effects": path for name, path in files_of(effects).items()}
    found = overwritten(inputs, outputs_of(request, folder), kernels_of(model))
    found += faults_of_request(request, folder)
    if found:
        raise InputError(found)
    warn_of_misfit(known)
    values = None if known is None else known.values
    measured = None if data is None else believed(model, data, values)
    of_effects = () if effects is None else effects.values.effects
    done = planned(model, measured, values, of_effects, request, folder)
    if request.out is not None:
        write_files({request.out / name: content for name, content in done.contents.items()})
    return done


def planned(
    model: MachineModel,
    data: MeasuredData | None,
    known: ErrorValues | None,
    effects: tuple[EffectValues, ...],
    request: PlanRequest,
    folder: Path | None,
    spelled: Spelled = argument,
) -> Planned:
    """As `plan`, without writing; data: readings of the machine without compensation, of the folder."""
    options = _options(model, known, effects, request, spelled)
    contents: dict[str, str | bytes] = {}
    if data is None or folder is None:
        made = first_plan(model, options, request.instruments, request.hours)
        if not made.runs:
            raise RefusedError((_no_run(request),), None)
        report = PlanReport(machine=model.name, source="", expected=None, proposal=made.report)
        expected = made.expected
        contents = _contents(new_setup(model.name), request.out or Path(), made)
    else:
        if found := faults_of_runs(request.runs, data, spelled):
            raise InputError(found)
        runs = PlannedRuns(str(folder), data.setup.runs, data.readings)
        runs = runs.of(request.runs) if request.runs else runs
        report, expected = judged_plan(model, options, runs)
        if request.propose is not None:
            added = proposed(model, options, runs, request.propose, request.propose_with)
            report, expected = replace(report, proposal=added.report), added.expected
            if request.out is not None:
                setup = folder / setup_file.FILE_NAME
                contents = _contents(utf8_text(setup, moved_setup(folder, request.out)), setup, added)
    return Planned(
        report=replace(report, caveats=dimension_notes(model, options.given)), expected=expected, tools=options.tools,
        contents=contents, folder=request.out if contents else None,
    )  # fmt: skip


def _no_run(request: PlanRequest) -> str:
    if request.hours is None:
        return "no run of these instruments determines what is asked for"
    return f"no run that determines what is asked for fits into {request.hours:g} h with its set-up"


def _options(
    model: MachineModel,
    known: ErrorValues | None,
    effects: tuple[EffectValues, ...],
    request: PlanRequest,
    spelled: Spelled,
) -> PlanOptions:
    given = known or ErrorValues(machine=model.name)
    given = replace(given, u={}, undetermined=(), covariance=None, fit=None)
    if request.location_errors_only:
        zeros: dict[str, Curve] = dict.fromkeys(model.components, PolynomialCurve(powers=(), coefficients=()))
        given = replace(given, motion_errors={**zeros, **given.motion_errors})
    unknown: list[str] = [name for name in model.components if name not in given.motion_errors]
    unknown += [name for name in model.location_errors if name not in given.parameters]
    if request.wanted not in (VOLUME, *unknown):
        problem = "is no error that is to be identified"
        remedy = f"{VOLUME}, or one of {', '.join(unknown)}"
        raise InputError([Fault(spelled("wanted"), request.wanted, problem, remedy)])
    return PlanOptions(
        given=given, noise=request.noise, tools=request.tools, wanted=request.wanted, datum=request.datum,
        effects=effects,
    )  # fmt: skip


def _contents(setup: str, file: Path, made: Proposed) -> dict[str, str | bytes]:
    """The plan with the runs, as a folder of measured data. setup: the text that they are added to, of a file."""
    return {
        setup_file.FILE_NAME: setup_text(setup, made.runs, str(file)),
        readings_files.FILE_NAME: dump_readings(made.planned.readings, made.planned.runs),
    }


def _points(tool: npt.ArrayLike) -> tuple[Vector, ...]:
    array = np.asarray(tool, dtype=np.float64)
    if array.shape[:1] != (3,) or array.ndim > 2 or not np.isfinite(array).all():
        raise ValueError(f"tool: expected finite numbers of shape (3,) or (3, n), mm; given shape {array.shape}")
    return tuple((x, y, z) for x, y, z in array.reshape(3, -1).T.tolist())
