"""What `diagnose` has done by a second process, while the first one identifies the values of the extended machine."""

from collections.abc import Mapping

from trueaxis.diagnosis.extended_spec import Extended
from trueaxis.diagnosis.result import Diagnosis
from trueaxis.reporting.diagnosis.figures import pictures_of
from trueaxis.reporting.diagnosis.picture import Pictures


def drawn_and_derived(diagnosis: Diagnosis, extended: Extended | None) -> tuple[Pictures, Mapping[str, bytes]]:
    """The figures of the report, and the files of generated/NAME/ of the extended machine, none where there is none."""
    pictures = pictures_of(diagnosis)
    if extended is None:
        return pictures, {}
    # SymPy and Jinja2: only where a machine is extended
    from trueaxis.codegen.render import render  # noqa: PLC0415
    from trueaxis.derivation.model import derive_model  # noqa: PLC0415

    return pictures, render(derive_model(extended.machine, extended.runs), extended.spec)
