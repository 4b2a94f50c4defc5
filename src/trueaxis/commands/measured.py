"""What `plan` and `identify` read: a machine, its kernels, measured data or a plan, and values known beforehand."""

import argparse
from dataclasses import dataclass

from trueaxis.faults import Fault, InputError
from trueaxis.input_files import gathering
from trueaxis.measure.data import MeasuredData, read_data
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import MachineModel, load_errors, load_model
from trueaxis.spec import read_machine


@dataclass(frozen=True)
class MeasuredInput:
    """The machine's model without error values, the data, and the values of --known (None if not given)."""

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
    if args.known is not None:
        with gathering(found):
            known = load_errors(args.known, machine)
    if found:
        raise InputError(found)
    return MeasuredInput(model, data, known)
