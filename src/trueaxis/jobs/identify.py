"""Error values from measured data."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

from trueaxis.estimation.observations import observations
from trueaxis.estimation.setting import EstimationOptions
from trueaxis.identification.believable_setup import setup_faults
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.identification.notes import compensation_note, unread_caveats
from trueaxis.identification.paper.method import identify_paper
from trueaxis.identification.paper.solution import PaperOptions
from trueaxis.identification.report import IdentificationReport, origin_of
from trueaxis.identification.report_text import report_text
from trueaxis.identification.weighting import NoiseModel
from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.jobs.given import Spelled, argument, faults_of_runs, warn_of_misfit
from trueaxis.jobs.load import DataFolder, Errors
from trueaxis.jobs.printed import Printed
from trueaxis.jobs.tables import check_among
from trueaxis.jobs.typed import typed
from trueaxis.measurement.active_compensation import uncompensated
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.limits import NOISE_UM
from trueaxis.model.believable import check_believable
from trueaxis.model.covariance import Covariance
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel

HIGHEST_DEGREE = 30
DEGREE_WITHOUT_PRIOR = 7  # nothing keeps curves of a higher order from following the noise
Method = Literal["global", "stepwise"]
Squareness = Literal["convention", "known", "from-angles"]
Curves = Literal["table", "polynomial", "held-out"]
Noise = NoiseModel | Mapping[str, float | Literal["repeats"]] | Literal["repeats", "repeats-by-run"] | float | None


class UnbelievableError(ValueError):
    """Values that no machine has. faults: of the values; report: of the identification, which says where it is off."""

    def __init__(self, faults: tuple[Fault, ...], report: IdentificationReport) -> None:
        super().__init__("; ".join(map(str, faults)))
        self.faults, self.report = faults, report


@dataclass(frozen=True, slots=True, eq=False)
class Identified(Printed):
    """errors: values with their covariance, `errors.values.fit` says how the fit ended; report: what is determined and
    by what, residuals by run, notes. Printed, it is the report of `trueaxis identify`.
    """

    errors: Errors = field(repr=False)
    report: IdentificationReport

    def __str__(self) -> str:
        return report_text(self.report)


@typed
def identify(
    model: MachineModel,
    data: DataFolder,
    *,
    runs: Sequence[str] = (),
    known: Errors | None = None,
    noise_um: Noise = None,
    noise_urad: float | None = None,
    squareness: Squareness = "convention",
    prior: bool = True,
    ideal_instruments: bool = False,
    degree: int | None = None,
    method: Method = "global",
    curves: Curves | None = None,
) -> Identified:
    """Identify the error motions and location errors of a machine from readings, on the exact model.

    runs: ids of those whose readings count (all). known: known values, which are not identified, dimensions included.
    noise_um: standard deviation of a reading, um, or by name of an instrument or a run (or "repeats": from its repeated
    readings); noise_urad: of angle instruments; None: from the readings. squareness: source of the squareness: level
    straightness lines (ISO 230-1), `known`, or Sect. 3.6 of the paper. prior: whether the errors have the sizes of
    [prior]; if not, errors that readings do not determine are zero and named. ideal_instruments: the instruments have
    no unknowns. degree: highest order of the curves (14, or more where readings tell more; 7 without prior). method
    "stepwise" is the paper's, point by point, with curves as a "table", a "polynomial" by its procedure, or one whose
    order is chosen by "held-out" positions.

    Raises InputError if arguments do not go together, the set-up contradicts the machine, or no reading depends on an
    error; NotConvergedError if the fit does not converge; UnbelievableError if no machine has such values;
    ValueError for arguments of another form.
    """
    check_among(method=(method, Method), squareness=(squareness, Squareness), curves=(curves, Curves))
    if degree is not None and not (isinstance(degree, int) and 1 <= degree <= HIGHEST_DEGREE):
        raise ValueError(f"degree: expected a whole number from 1 to {HIGHEST_DEGREE}; given {degree}")
    choice = MethodChoice(
        method=method, squareness=squareness, curves=curves, known=known is not None,
        noise=noise_model(noise_um, noise_urad),
        degree=degree, ideal_instruments=ideal_instruments, prior=prior,
    )  # fmt: skip
    if unfit := faults_of_choice(choice):
        raise InputError(unfit)
    if absent := faults_of_runs(runs, data.data):
        raise InputError(absent)
    values = None if known is None else known.values
    warn_of_misfit(known)
    measured = believed(model, data, values, runs)
    observed = observations(str(data.folder), measured.setup.runs, measured.readings, runs)
    if method == "global":
        found = identify_estimated(model, observed, _options(choice, values))
    else:
        found = identify_paper(model, observed, PaperOptions(squareness, values, choice.noise.um, curves or "table"))
    faults = Faults(str(data.folder))
    check_believable(model.machine, found.values, faults)
    if faults.found:
        raise UnbelievableError(tuple(faults.found), found.report)
    report = _of_data(found.report, measured, data.folder)
    covariance = _with_known(found.covariance, known)
    origin = origin_of(report, data.folder.resolve().name, method == "global" and prior)
    told = replace(found.values, origin=origin, chain=model.machine.chain)
    return Identified(Errors(told, covariance, machine=model.machine), report)


def _of_data(report: IdentificationReport, measured: MeasuredData, folder: Path) -> IdentificationReport:
    """With what the data folder says beside the readings."""
    return replace(
        report,
        notes=(*report.notes, compensation_note(measured.setup, folder)),
        caveats=(*report.caveats, *unread_caveats(measured)),
        measurement=measured.setup.report,
    )


def _options(choice: "MethodChoice", values: ErrorValues | None) -> IdentifyOptions:
    """What the estimate is told. values: that are known."""
    degree = choice.degree or (None if choice.prior else DEGREE_WITHOUT_PRIOR)
    return IdentifyOptions(
        "known" if choice.squareness == "known" else "convention",
        values,
        choice.noise,
        EstimationOptions(prior=choice.prior, ideal=choice.ideal_instruments, degree=degree),
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class MethodChoice:
    """How errors are to be identified, as the arguments of `identify`; known: whether values are taken as they are."""

    method: Method
    squareness: Squareness
    curves: Curves | None
    known: bool
    noise: NoiseModel
    degree: int | None
    ideal_instruments: bool
    prior: bool


def faults_of_choice(choice: MethodChoice, spelled: Spelled = argument) -> list[Fault]:
    """What does not go together."""
    found, way = [], spelled("method")
    angles: Squareness = "from-angles"
    if choice.method == "global":
        if choice.squareness == angles:
            place = f"{spelled('squareness')} {angles}"
            found.append(Fault(place, "", f"goes with {way} stepwise", "convention or known"))
        if choice.curves is not None:
            remedy = "method global has curves of its own"
            found.append(Fault(spelled("curves"), "", f"goes with {way} stepwise", remedy))
    if choice.squareness == "known" and not choice.known:
        place = f"{spelled('squareness')} known"
        found.append(Fault(place, "", "needs the squareness", f"give a file with {spelled('known')}"))
    if choice.method == "stepwise":
        for name, used, remedy in (
            ("noise_um", choice.noise.names or choice.noise.repeats, "one value"),
            ("noise_urad", choice.noise.urad is not None, f"{way} global"),
            ("degree", choice.degree is not None, f"{way} global"),
            ("ideal_instruments", choice.ideal_instruments, f"{way} global"),
            ("prior", not choice.prior, f"{way} global"),
        ):
            if used:
                found.append(Fault(spelled(name), "", f"goes with {way} global", remedy))
    return found


def believed(
    model: MachineModel, data: DataFolder, known: ErrorValues | None, runs: Sequence[str] = ()
) -> MeasuredData:
    """The readings of the machine without compensation, whatever was active on the control.

    runs: ids of those that are to be used, else all. Raises InputError where their set-up or readings contradict the
    machine, whose dimensions are those known.
    """
    placed = model.with_values(known or ErrorValues(machine=model.name))
    if faults := setup_faults(placed, data.data, data.folder, runs):
        raise InputError(faults)
    return data.data if data.active is None else uncompensated(model, data.data, data.active)


def noise_model(noise_um: Noise, noise_urad: float | None = None) -> NoiseModel:
    """What is known of the noise. Raises ValueError where a standard deviation is not above 0."""
    if noise_urad is not None and not noise_urad > 0.0:
        raise ValueError(f"noise_urad: expected microradians above 0; given {noise_urad}")
    if noise_um is None or isinstance(noise_um, NoiseModel):
        given = noise_um or NoiseModel()
        return given if noise_urad is None else replace(given, urad=noise_urad)
    if isinstance(noise_um, str):
        check_among(noise_um=(noise_um, Literal["repeats", "repeats-by-run"]))
        return NoiseModel(repeats="run" if noise_um.endswith("run") else "instrument", urad=noise_urad)
    said = dict(noise_um) if isinstance(noise_um, Mapping) else {}
    by_group = {name: value for name, value in said.items() if not isinstance(value, str)}
    repeated = frozenset(said.keys() - by_group.keys())
    if wrong := [value for name, value in said.items() if name in repeated and value != "repeats"]:
        raise ValueError(f'noise_um: expected a number or "repeats"; given {wrong[0]!r}')
    whole = None if isinstance(noise_um, Mapping) else float(noise_um)
    for value in (*by_group.values(), whole):
        check_noise(value)
    return NoiseModel(um=whole, by_group=by_group, urad=noise_urad, repeated=repeated)


def check_noise(um: float | None) -> None:
    """Raise ValueError where it is no standard deviation of a reading, um; None: it was not given."""
    low, high = NOISE_UM
    if um is not None and not um > 0.0:
        raise ValueError(f"noise_um: expected micrometres above 0; given {um}")
    if um is not None and not low <= um <= high:
        raise ValueError(f"noise_um: expected micrometres from {low:g} to {high:g}; given {um}")


def _with_known(identified: Covariance, known: Errors | None) -> Covariance:
    """The covariance with what is known of the values that were taken as they are."""
    if known is None:
        return identified
    given, values = known.covariance, known.values
    components = set(given.components) & set(values.motion_errors) - set(identified.components)
    locations = set(given.locations) & set(values.parameters) - set(identified.locations)
    effects = set(given.effects) - set(identified.effects)
    return identified.joined(given.of(components, locations, effects))
