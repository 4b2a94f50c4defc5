"""Error values as a document, beside older ones."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy.typing as npt

from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files
from trueaxis.jobs.given import files_of, kernels_of, name_of, with_errors
from trueaxis.jobs.load import Errors
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.jobs.printed import Printed
from trueaxis.jobs.tables import ORIGIN, tool_points
from trueaxis.jobs.typed import AnyPath, typed
from trueaxis.model.model import MachineModel
from trueaxis.reporting.certificate_content import Content, Known, content

PAGES = (".html", ".htm")


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Document(Printed):
    """Error values as a document of two printed pages. content: the figures in it; html: the page; file: where it was
    written, None where it was not. Printed, it is what `trueaxis report` says.
    """

    content: Content = field(repr=False)
    html: str = field(repr=False)
    file: Path | None

    def __str__(self) -> str:
        where = "" if self.file is None else f"{named(self.file)}: "
        return f"{where}{self.content.title}\n"


@typed
def report(
    model: MachineModel,
    errors: Errors,
    out: AnyPath | None = None,
    *,
    against: Errors | None = None,
    tool: npt.ArrayLike = ORIGIN,
) -> Document:
    """Write error values as a document: every error with its uncertainty and what determines it, the deviation of the
    tool point over the volume in figures and maps.

    out: the .html file to write; None: nothing is written. against: older values, for the changes and their
    number of standard uncertainties; tool: (3,), the point in the tool frame whose deviation is shown, mm. Raises
    InputError where `out` is an input, or values were edited since they were identified; ValueError for arguments of
    another form or values of another machine.
    """
    x, y, z = tool_points(tool, 1)[:, 0].tolist()
    now = Known(with_errors(model, errors), errors.covariance, name_of(errors))
    before = None
    if against is not None:
        before = Known(with_errors(model, against), against.covariance, name_of(against))
    file = None if out is None else Path(out)
    inputs = {"the spec": model.machine.source, **files_of(errors)}
    inputs |= {f"{name} of against": path for name, path in files_of(against).items()}
    wrong = [] if file is None else faults_of_page(file, "out")
    if found := [*wrong, *overwritten(inputs, {"out": file}, kernels_of(model))]:
        raise InputError(found)
    return documented(now, before, (x, y, z), file)


def faults_of_page(out: Path, place: str) -> list[Fault]:
    """What is wrong with the name of the page; place: the argument that gives it."""
    if out.suffix.lower() in PAGES:
        return []
    return [
        Fault(place, "", f"{out.name} is no name of a page", "a name that ends in .html; a browser prints it as PDF")
    ]


def documented(now: Known, before: Known | None, tool: tuple[float, float, float], out: Path | None) -> Document:
    """As `report`."""
    from trueaxis.reporting.certificate import certificate  # noqa: PLC0415  matplotlib and Jinja2: only for sound input

    figures = content(now, before, tool)
    html = certificate(figures, dict(now.model.kinds))
    if out is not None:
        write_files({out: html})
    return Document(content=figures, html=html, file=out)
