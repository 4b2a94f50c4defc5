"""What `plan`, `identify` and `diagnose` read: a machine, its kernels, measured data or a plan, values known before."""

import argparse
import logging
from dataclasses import dataclass
from pathlib import Path

from trueaxis.identification.believable_setup import setup_faults
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.input_files import gathering
from trueaxis.machine import read_machine
from trueaxis.measurement.active_compensation import active_values, uncompensated
from trueaxis.measurement.data import MeasuredData, read_data
from trueaxis.measurement.setup import Setup
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, load_errors, load_model

_LOG = logging.getLogger(__name__)
SILENT = "setup.toml does not say whether a compensation of the control was active; none is assumed"


@dataclass(frozen=True)
class MeasuredInput:
    """The machine's model without error values, the data, and the values of --known (None if not given).

    Readings are those of the machine without compensation, whatever was active on the control.
    """

    model: MachineModel
    data: MeasuredData
    known: ErrorValues | None


def read_measured(args: argparse.Namespace, found: list[Fault]) -> MeasuredInput:
    """Read the files of `machine`, `data`, `known` and `kernels`.

    Raises InputError with the faults of all of them, after those found before.
    """
    machine = read_machine(args.machine)
    known = None
    with gathering(found):
        model = load_model(args.machine, None, args.kernels)
    with gathering(found):
        data = read_data(args.data, machine)
        active = active_values(args.data, data.setup, machine)
    if args.known is not None:
        with gathering(found):
            known = load_errors(args.known, machine)
    if found:
        raise InputError(found)
    if known is not None and known.fit is not None and known.fit.state == "misfit":
        _LOG.warning("%s: these values did not fit the readings that they are from", args.known)
    found += setup_faults(model.with_values(known or ErrorValues(machine.name)), data, args.data)
    if found:
        raise InputError(found)
    if active is not None:
        data = uncompensated(model, data, active)
    return MeasuredInput(model, data, known)


def compensation_note(setup: Setup, folder: Path) -> str:
    """What a reader of identified values must know of the compensation while the readings were taken."""
    key = setup.compensation
    if key is None:
        return SILENT
    if key.file is None:
        return "no compensation was active while the readings were taken (setup.toml)"
    return (
        f"{folder / key.file} was active on the control: what it took from the readings was added again, to first "
        "order in the errors. The values are those of the machine without compensation: use them instead of the active "
        "ones, not on top of them"
    )
