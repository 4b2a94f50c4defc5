"""What is asked of a plan, and what of it does not go together."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, get_args

from trueaxis.identification.weighting import NoiseModel
from trueaxis.io.faults import Fault
from trueaxis.jobs.given import Spelled, argument
from trueaxis.jobs.tables import ORIGIN, above_zero
from trueaxis.measurement import readings as readings_files
from trueaxis.measurement import setup as setup_file
from trueaxis.measurement.instrument_kinds import Instrument
from trueaxis.measurement.setup import Vector
from trueaxis.planning.candidates import WITH_CANDIDATES
from trueaxis.planning.propose import VOLUME

MOST_PROPOSED = 100
PlanDatum = Literal["home", "best-fit"]


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanRequest:
    """What is asked of a plan; see the arguments of `plan`. Raises ValueError for values of another form."""

    instruments: Sequence[Instrument] = ()
    hours: float | None = None
    runs: Sequence[str] = ()
    propose: int | None = None
    propose_with: Sequence[Instrument] = ()
    wanted: str = VOLUME
    datum: PlanDatum = "home"
    noise: NoiseModel
    location_errors_only: bool = False
    tools: tuple[Vector, ...] = (ORIGIN,)
    out: Path | None = None

    def __post_init__(self) -> None:
        above_zero(hours=self.hours)
        for name, given in (("instruments", self.instruments), ("propose_with", self.propose_with)):
            if isinstance(given, str) or not set(given) <= set(WITH_CANDIDATES):
                raise ValueError(f"{name}: expected a list, of {', '.join(WITH_CANDIDATES)}; given {given!r}")
        if isinstance(self.runs, str):
            raise ValueError(f"runs: expected a list of ids; given {self.runs!r}")
        if self.propose is not None and not (isinstance(self.propose, int) and 1 <= self.propose <= MOST_PROPOSED):
            raise ValueError(f"propose: expected a whole number from 1 to {MOST_PROPOSED}; given {self.propose}")
        if self.datum not in get_args(PlanDatum):
            raise ValueError(f"datum: expected one of {', '.join(get_args(PlanDatum))}; given {self.datum!r}")


def outputs_of(request: PlanRequest, folder: Path | None) -> dict[str, Path | None]:
    """The files that are written; folder: of the plan that is judged, which may not be the one to be written."""
    out = request.out
    if out is None or (folder is not None and out.resolve() == folder.resolve()):
        return {}
    return {f"{name} of --out": out / name for name in (setup_file.FILE_NAME, readings_files.FILE_NAME)}


def faults_of_request(
    request: PlanRequest, folder: Path | None, spelled: Spelled = argument, *, writes: bool = False
) -> list[Fault]:
    """What does not go together; nothing is read for it. writes: a first plan is of use in a folder alone."""
    found = []
    if request.noise.repeats or request.noise.repeated:
        problem = "a plan has no readings"
        found.append(Fault(spelled("noise_um"), request.noise.repeats or "repeats", problem, "a number of micrometres"))
    found += _of_first_plan(request, spelled, writes) if folder is None else _of_plan(request, spelled)
    return found + ([] if request.out is None else _of_out(request.out, folder, spelled))


def _of_plan(request: PlanRequest, spelled: Spelled) -> list[Fault]:
    found, propose = [], f"{spelled('propose')} N"
    if request.instruments:
        remedy = f"{spelled('propose_with')}, or no {spelled('data')}"
        found.append(Fault(spelled("instruments"), "", "makes a plan from nothing", remedy))
    if request.hours is not None:
        found.append(Fault(spelled("hours"), "", f"goes with {spelled('instruments')}, from nothing", propose))
    if request.propose is None:
        for name, used in (
            ("out", request.out is not None),
            ("propose_with", request.propose_with),
            ("wanted", request.wanted != VOLUME),
        ):
            if used:
                found.append(Fault(spelled(name), "", "is for proposed runs", f"{propose} as well"))
    if request.runs and request.out is not None:
        found.append(Fault(spelled("out"), "", "goes with all runs", f"no {spelled('runs')}"))
    return found


def _of_first_plan(request: PlanRequest, spelled: Spelled, writes: bool) -> list[Fault]:
    if not request.instruments:
        remedy = f"a folder with a plan, or {spelled('instruments')} laser ballbar for a first one"
        return [Fault(spelled("data"), "", "is missing", remedy)]
    found = []
    if writes and request.out is None:
        found.append(Fault(spelled("out"), "", "is missing", "the folder that the first plan is written to"))
    for name in ("runs", "propose", "propose_with", "location_errors_only"):
        if getattr(request, name):
            remedy = f"{spelled('data')} DIR, or leave it out"
            found.append(Fault(spelled(name), "", "goes with a plan that is there", remedy))
    return found


def _of_out(out: Path, folder: Path | None, spelled: Spelled) -> list[Fault]:
    other = out / readings_files.PARQUET_NAME
    if folder is not None and out.resolve() == folder.resolve():
        return [Fault(str(out), "", "is the folder of the plan itself", f"another folder for {spelled('out')}")]
    if other.exists():
        return [Fault(str(other), "", f"would stand beside the new {readings_files.FILE_NAME}", "remove it")]
    return []
