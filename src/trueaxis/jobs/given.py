"""Error values as they are given to a job: of this machine, unedited since their covariance, fit to be relied on."""

import logging
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from trueaxis.io.faults import Fault, InputError
from trueaxis.jobs.load import Errors
from trueaxis.measurement.data import MeasuredData
from trueaxis.model.covariance import digest_of_numbers, digest_of_values
from trueaxis.model.errors import CovarianceLink, ErrorValues
from trueaxis.model.model import MachineModel
from trueaxis.model.uncertainty import covariance_file
from trueaxis.reporting.reliance import misfit_sentence

_LOG = logging.getLogger(__name__)
Spelled = Callable[[str], str]  # an argument by the name that a user gives it: `propose`, or --propose


def argument(name: str) -> str:
    """As Python spells an argument."""
    return name


def name_of(errors: Errors) -> str:
    """The file that the values were read from, for faults."""
    return "errors" if errors.file is None else str(errors.file)


def files_of(errors: Errors | None) -> dict[str, Path | None]:
    """What nothing may be written over: the files that the values were read from."""
    if errors is None or errors.file is None:
        return {}
    linked = covariance_file(errors.file, errors.values)
    return {"the file of the errors": errors.file, "the covariance of the errors": linked}


def kernels_of(model: MachineModel) -> Path | None:
    """The folder of derived kernels that the model's are in, where nothing may be written."""
    file = model.kernels.module.__file__
    return None if file is None else Path(file).parent.parent


def with_errors(model: MachineModel, errors: Errors) -> MachineModel:
    """The model with the values.

    Raises ValueError where they are another machine's, InputError where they were edited since their covariance.
    """
    values, covariance = errors.values, errors.covariance
    if values.machine != model.name:
        raise ValueError(f"errors: expected those of {model.name}; given those of {values.machine}")
    digest = digest_of_values(values)
    if covariance.sha256_of_values not in ("", digest, digest_of_numbers(values)):
        remedy = "identify again: edited values have no uncertainty of their own"
        raise InputError([Fault(name_of(errors), "covariance", "is the covariance of other values", remedy)])
    if values.covariance is None and covariance.of_prior is not None:
        values = replace(values, covariance=CovarianceLink("", digest))  # of an estimate that is in no file yet
    return model.with_values(values)


def check_fit(errors: ErrorValues, file: str, accepted: bool, spelled: Spelled = argument) -> None:
    """Raise InputError where the values are a misfit that was not accepted. file: as faults name it."""
    if errors.fit is not None and errors.fit.state == "misfit" and not accepted:
        remedy = f"correct the set-up or the data and identify again, or {spelled('accept_misfit')}"
        raise InputError([Fault(file, "fit", misfit_sentence(errors.fit), remedy)])


def warn_of_misfit(errors: Errors | None) -> None:
    """Log a warning where known values are a misfit."""
    if errors is not None and errors.values.fit is not None and errors.values.fit.state == "misfit":
        _LOG.warning("%s: these values did not fit the readings that they are from", name_of(errors))


def faults_of_runs(names: Sequence[str], data: MeasuredData, spelled: Spelled = argument) -> list[Fault]:
    """Runs asked for that the data do not have."""
    ids = [run.id for run in data.setup.runs]
    return [
        Fault(spelled("runs"), name, "is no run of the setup", f"of {', '.join(ids)}")
        for name in names
        if name not in ids
    ]
