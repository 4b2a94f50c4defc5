"""The machine with the causes that a diagnosis names, and the files that say it all."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, cast

from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.io.input_files import input_bytes, utf8_text
from trueaxis.machine.read import parse_machine
from trueaxis.measurement.data import MeasuredData
from trueaxis.model.covariance import Covariance
from trueaxis.model.errors import ErrorValues, dump_errors
from trueaxis.model.kernels import numpy_kernels
from trueaxis.model.manifest import KERNEL_FILES
from trueaxis.model.model import MachineModel

if TYPE_CHECKING:
    from trueaxis.derivation.systems import RunPattern
    from trueaxis.diagnosis.extended_spec import Extended
    from trueaxis.diagnosis.result import Diagnosis
    from trueaxis.reporting.diagnosis.picture import Pictures

_DrawnAndDerived = tuple["Pictures", Mapping[str, bytes]]
Start = Callable[..., Callable[[], object]]  # of a function of SECOND, with its arguments; gives what waits for it
SECOND = "trueaxis.jobs.drawn_and_derived"
DIAGNOSIS, REPORT, ERRORS, KERNELS = "diagnosis.json", "report.html", "errors.json", "generated"


@dataclass(frozen=True, kw_only=True)
class Given:
    """What was read. covariance: of the error values; spec: its text as it must read in the folder to be written; runs:
    whose systems are derived; folder: of the data, for notes.
    """

    model: MachineModel
    covariance: Covariance | None
    data: MeasuredData
    spec: str
    runs: "tuple[RunPattern, ...]"
    folder: Path = Path()


class Extending:
    """The model of the machine with the causes that a diagnosis names, which the second process draws and derives
    meanwhile. extended: None before it is called, and where none was named.
    """

    def __init__(self, out: Path, given: Given, start: Start) -> None:
        self.out, self.given, self.start = out, given, start
        self.extended: Extended | None = None
        self.misfits: tuple[str, ...] = ()

    def __call__(self, diagnosis: "Diagnosis") -> MachineModel:
        """See `Extend`; once for a diagnosis."""
        model = self.given.model
        self.extended, self.misfits = _extended(self.out, self.given, diagnosis), diagnosis.misfits
        self.second = cache(
            cast("Callable[[], _DrawnAndDerived]", self.start("drawn_and_derived", diagnosis, self.extended))
        )
        if self.extended is None:
            return model
        machine, kernels = self.extended.machine, model.kernels
        # kernels serve any machine with the same parameters: effects have theirs apart, location errors have not
        if machine.parameters != model.machine.parameters:
            kernels = numpy_kernels(self.second()[1]["kernels.py"], self.out / self.extended.spec)
        return MachineModel(machine, kernels, ErrorValues(machine=machine.name))


def contents_of(out: Path, given: Given, diagnosis: "Diagnosis", extending: Extending) -> dict[Path, bytes | str]:
    """Of every file that is written."""
    from trueaxis.reporting.diagnosis.html import report_html  # noqa: PLC0415
    from trueaxis.reporting.diagnosis.json_file import diagnosis_json  # noqa: PLC0415

    pictures, files = extending.second()
    if diagnosis.misfits != extending.misfits:  # names were taken back
        from trueaxis.reporting.diagnosis.figures import pictures_of  # noqa: PLC0415 - seldom, and slow to import

        pictures = pictures_of(diagnosis)
    extended = extending.extended if diagnosis.values is not None else None
    spec = None if extended is None else extended.spec
    contents: dict[Path, bytes | str] = {
        out / DIAGNOSIS: diagnosis_json(diagnosis, spec, ERRORS if extended else None),
        out / REPORT: report_html(diagnosis, pictures),
    }
    if extended is not None and diagnosis.values is not None:
        machine = extended.machine
        contents[out / extended.spec] = extended.text
        contents[out / ERRORS] = dump_errors(
            replace(diagnosis.values, chain=machine.chain),
            components=machine.components,
            parameters=machine.parameters,
            effects=machine.effects,
        )
        contents |= {out / KERNELS / given.model.name / name: content for name, content in files.items()}
    return contents


def outputs(out: Path, name: str) -> list[Path]:
    """Every file that may be written."""
    kernels = [out / KERNELS / name / file for file in KERNEL_FILES]
    return [out / DIAGNOSIS, out / REPORT, out / f"{name}.toml", out / ERRORS, *kernels]


def _extended(out: Path, given: Given, diagnosis: "Diagnosis") -> "Extended | None":
    """The machine with the causes that were named; None where none was."""
    from trueaxis.diagnosis.extend import named_effects  # noqa: PLC0415
    from trueaxis.diagnosis.extended_spec import Extended, extended_spec  # noqa: PLC0415

    effects = named_effects(diagnosis)
    if not effects:
        return None
    path = out / f"{given.model.name}.toml"
    text = extended_spec(given.spec, effects)
    return Extended(parse_machine(text, Faults(str(path))), given.runs, path.name, text)


def spec_text(source: Path, out: Path) -> str:
    """The text of a spec as it must read in the folder. Raises InputError where it cannot be read or moved."""
    from trueaxis.diagnosis.extended_spec import moved_spec  # noqa: PLC0415  as the diagnosis itself

    text = utf8_text(source, input_bytes(source))
    try:
        return moved_spec(text, source.parent, out)
    except ValueError:
        problem = "cannot be written for another folder"
        raise InputError([Fault(str(source), "key runs", problem, "a text of one line in quotes")]) from None
