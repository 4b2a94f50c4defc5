"""One machine and one folder of its data: what a worker of a fleet does. Whatever goes wrong is in the row."""

import logging
import math
import os
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

from trueaxis import __version__
from trueaxis.fleets.rows import ROW_FILE, CauseFound, Row, StaleFound, ToolFound, ValueFound, read_row, row_text
from trueaxis.fleets.unit import Unit, inputs_digest, kept_row, values_before
from trueaxis.identification.fit_quality import NotConvergedError
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import remove_files, write_files
from trueaxis.io.safe_text import shown
from trueaxis.jobs.derive import derive
from trueaxis.jobs.given import name_of, with_errors
from trueaxis.jobs.identify import UnbelievableError, identify
from trueaxis.jobs.load import DataFolder, Errors, load_data, load_errors, load_model, save_errors
from trueaxis.jobs.report import report
from trueaxis.machine import read_machine
from trueaxis.model.model import MachineModel
from trueaxis.reporting.certificate_content import Content, ErrorLine, Known, content

ERRORS, REPORT, DIAGNOSIS = "errors.json", "report.html", "diagnosis"
TOOL = (0.0, 0.0, 0.0)  # the point whose deviation over the volume is told, tool frame, mm


def do_unit(unit: Unit) -> tuple[Row, bool]:
    """Do what is asked for of the unit, write it and then its row; unless that was done before from the same inputs.
    The row, and whether it was made now.
    """
    digest = inputs_digest(unit)
    if kept := kept_row(unit, digest):
        return kept, False
    clear(unit.out)
    work = _Work(unit)
    with _told(work.notes):
        work.run()
    row = work.row(digest)
    write_files({unit.out / ROW_FILE: row_text(row)})
    return row, True


def clear(out: Path) -> None:
    """Remove the row first, then the files that it names: a run that is killed leaves none that passes for done."""
    before = read_row(out)
    remove_files([out / ROW_FILE, *(out / name for name in (() if before is None else before.files))])


def prepare(spec: Path, kernels: Path) -> None:
    """Derive the kernels of a spec where they are missing, so that units of one spec need not do it at once."""
    try:
        _kernels_of(spec, kernels)
    except (InputError, OSError):  # each unit of the spec tells it
        return


class _Work:
    """What becomes of a unit; every step adds what it found, or its faults."""

    def __init__(self, unit: Unit) -> None:
        self.unit = unit
        self.faults: list[str] = []
        self.notes: list[str] = []
        self.files: list[Path] = []
        self.identified: Errors | None = None
        self.found: Row = Row(machine=unit.machine, data=unit.data, date=unit.date, inputs="", tasks=unit.tasks)

    def run(self) -> None:
        with self.telling():
            model, given, before, data = self._read()
            self._identify(model, data)
            known = given or before
            if "diagnose" in self.unit.tasks and data is not None and not self._failed("identify", known):
                self._diagnose(model, data, known or self.identified)
            if (now := self.identified or given) is not None and not self._failed("identify", None):
                self._compare(model, now, before)

    def row(self, digest: str) -> Row:
        """The row as it is written; digest: of its inputs."""
        base, out = self.unit.base, self.unit.out
        # a path of this machine's disk says nothing to who reads the results elsewhere
        faults, notes = ([one.replace(f"{base}/", "") for one in texts] for texts in (self.faults, self.notes))
        before = values_before(self.unit)
        newest = ERRORS if self.identified is not None else None
        if newest is None and before is not None:
            newest = _relative(before, out)
        return replace(
            self.found, inputs=digest, faults=tuple(dict.fromkeys(faults)), notes=tuple(dict.fromkeys(notes)),
            files=tuple(path.relative_to(out).as_posix() for path in self.files), newest=newest,
        )  # fmt: skip

    @contextmanager
    def telling(self) -> Iterator[None]:
        """What is raised inside is told as faults: one machine never ends the others' work."""
        try:
            yield
        except InputError as error:
            self.faults += map(str, error.faults)
        except UnbelievableError as error:
            self.faults += [f"identify: not written: {one}" for one in error.faults]
        except NotConvergedError as error:
            self.faults.append(f"identify: {error}; nothing was written")
        except MemoryError:
            self.faults.append("this needs more memory than there is; give workers more (--memory), or fewer readings")
        except OSError as error:
            self.faults.append(f"{error.filename or 'system'}: {error.strerror or error}")
        except Exception as error:
            self.faults.append(shown(f"the program failed here: {type(error).__name__}: {error}"))

    def _read(self) -> tuple[MachineModel, Errors | None, Errors | None, DataFolder | None]:
        """Model, values given, values before, data. Raises InputError with the faults of all of them."""
        unit = self.unit
        if unit.version != __version__:
            problem = f"has trueaxis {__version__}; the fleet was started by {unit.version}"
            raise InputError([Fault("the worker", "", problem, "the same version on all computers")])
        faults: list[Fault] = []
        model = _model(unit.spec, _kernels_of(unit.spec, unit.kernels), unit.spec.read_bytes())
        earlier = values_before(unit)
        found: list[Errors | DataFolder | None] = []
        readers: tuple[Callable[[], Errors | DataFolder | None], ...] = (
            lambda: None if unit.errors is None else load_errors(unit.errors, model),
            lambda: None if earlier is None else load_errors(earlier, model),
            lambda: None if unit.folder is None else load_data(unit.folder, model),
        )
        for read in readers:
            try:
                found.append(read())
            except InputError as error:
                faults += error.faults
                found.append(None)
        if faults:
            raise InputError(dict.fromkeys(faults))
        given, before, data = found
        assert isinstance(given, Errors | None)
        assert isinstance(before, Errors | None)
        assert isinstance(data, DataFolder | None)
        return model, given, before, data

    def _failed(self, task: str, instead: Errors | None) -> bool:
        """Whether a task was to give error values, gave none, and there are none to take instead."""
        return task in self.unit.tasks and self.identified is None and instead is None

    def _identify(self, model: MachineModel, data: DataFolder | None) -> None:
        if "identify" not in self.unit.tasks or data is None:
            return
        with self.telling():
            done = identify(model, data)
            if done.report.nothing_determined:
                self.notes.append("the readings determine none of the errors")
            self.files += save_errors(self.unit.out / ERRORS, done.errors, model)
            self.identified = load_errors(self.unit.out / ERRORS, model)
            fit = done.errors.values.fit
            if fit is not None:
                self.found = replace(self.found, fit=fit.state, chi2=_known(fit.chi2))

    def _diagnose(self, model: MachineModel, data: DataFolder, errors: Errors | None) -> None:
        from trueaxis.jobs.diagnose import diagnose  # noqa: PLC0415  half a second, for who asks for it

        with self.telling():
            done = diagnose(model, data, errors, out=self.unit.out / DIAGNOSIS)
            self.files += done.files
            causes = tuple(
                CauseFound(
                    kind=one.effect.kind, component=one.effect.component, label=one.effect.label,
                    certain=one.alone,
                    rivals=tuple(dict.fromkeys(each.effect.label for each in one.rivals)),
                    parameters={part.name: (part.value, _known(part.u), part.unit) for part in one.parameters},
                )
                for one in done.diagnosis.causes
            )  # fmt: skip
            stale = tuple(
                StaleFound(name=one.component, change=one.value, u=_known(one.u), unit=one.unit)
                for one in done.diagnosis.stale
            )
            self.found = replace(self.found, verdict=done.verdict, causes=causes, stale=stale)

    def _compare(self, model: MachineModel, now: Errors, before: Errors | None) -> None:
        """The errors as figures, beside those before; as a document where that is asked for."""
        with self.telling():
            older = None if before is None or _same(before, now) else before
            if "report" in self.unit.tasks:
                page = self.unit.out / REPORT
                figures = report(model, now, page, against=older).content
                self.files.append(page)
            else:
                known = [None if one is None else Known(with_errors(model, one), one.covariance, name_of(one))
                         for one in (now, older)]  # fmt: skip
                assert known[0] is not None
                figures = content(known[0], known[1], TOOL)
            against = None if older is None or older.file is None else _relative(older.file, self.unit.out)
            self.found = replace(self.found, values=_values(figures), tool=_tool(figures), against=against)


@contextmanager
def _told(notes: list[str]) -> Iterator[None]:
    """Warnings of this program that this thread gives are notes."""
    handler, thread = logging.Handler(logging.WARNING), threading.get_ident()

    def emit(record: logging.LogRecord) -> None:
        if record.thread == thread:
            notes.append(shown(record.getMessage()))

    handler.emit = emit  # type: ignore[method-assign]
    log = logging.getLogger("trueaxis")
    log.addHandler(handler)
    try:
        yield
    finally:
        log.removeHandler(handler)


def _kernels_of(spec: Path, kernels: Path) -> Path:
    """The folder of the kernels of a spec, which are derived where they are missing or of another version."""
    machine = read_machine(spec)
    folder = kernels / machine.digest[:16]
    try:
        _model(spec, folder, spec.read_bytes())
    except InputError:
        derive(spec, folder)
    return folder


@lru_cache(maxsize=32)
def _model(spec: Path, kernels: Path, _content: bytes) -> MachineModel:
    """Loaded once in a worker; _content: of the spec, which may change while a worker lives."""
    return load_model(spec, kernels)


def _values(figures: Content) -> tuple[ValueFound, ...]:
    return tuple(_value(one) for one in (*figures.components, *figures.locations))


def _value(one: ErrorLine) -> ValueFound:
    change = one.change
    return ValueFound(
        name=str(one.name), value=one.value, u=_known(one.u), at=one.at, unit=one.unit, determined=one.determined,
        change=None if change is None else change.rms, change_in_u=None if change is None else _known(change.in_u),
    )  # fmt: skip


def _tool(figures: Content) -> ToolFound:
    volume, changed = figures.volume, figures.changed
    u = _known(volume.u_rms)
    return ToolFound(rms=volume.rms, largest=volume.largest, u=u, change=None if changed is None else changed.rms)


def _known(value: float | None) -> float | None:
    """None where it is no finite number."""
    return None if value is None or not math.isfinite(value) else value


def _same(one: Errors, other: Errors) -> bool:
    """Whether both were read from one file."""
    return one.file is not None and other.file is not None and one.file.samefile(other.file)


def _relative(path: Path, folder: Path) -> str:
    return Path(os.path.relpath(path, folder)).as_posix()
