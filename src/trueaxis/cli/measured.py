"""What `plan`, `identify` and `diagnose` read: a machine, its kernels, measured data or a plan, values known before."""

import argparse
import logging
from dataclasses import dataclass

from trueaxis.io.faults import Fault, InputError
from trueaxis.io.input_files import gathering
from trueaxis.jobs.identify import believed
from trueaxis.jobs.load import load_data, load_model
from trueaxis.machine import read_machine
from trueaxis.measurement.data import MeasuredData
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, load_errors

_LOG = logging.getLogger(__name__)


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
        model = load_model(args.machine, args.kernels)
    with gathering(found):
        data = load_data(args.data, machine)
    if args.known is not None:
        with gathering(found):
            known = load_errors(args.known, machine)
    if found:
        raise InputError(found)
    if known is not None and known.fit is not None and known.fit.state == "misfit":
        _LOG.warning("%s: these values did not fit the readings that they are from", args.known)
    return MeasuredInput(model, believed(model, data, known), known)
