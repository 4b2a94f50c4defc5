"""Readings that instruments would take of a machine with errors."""

from dataclasses import replace

import numpy as np

from trueaxis.identification.believable_setup import setup_faults
from trueaxis.io.faults import InputError
from trueaxis.jobs.load import DataFolder, Errors
from trueaxis.jobs.typed import typed
from trueaxis.measurement.active_compensation import compensated_part
from trueaxis.measurement.context import context_of, faults_of_readings
from trueaxis.measurement.data import readings_path
from trueaxis.measurement.simulate import check_simulated, filled_in, rows_to_fill
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel


@typed
def simulate(
    model: MachineModel,
    errors: Errors | ErrorValues,
    plan: DataFolder,
    *,
    noise_um: float = 0.0,
    noise_urad: float = 0.0,
    seed: int = 0,
    replace_all: bool = False,
) -> DataFolder:
    """Fill in the empty readings of a measuring plan (with replace_all: all of them) from the exact model.

    noise_um: standard deviation of Gaussian noise, um, drawn from the seed; noise_urad: of angle instruments; readings
    are those of the compensated machine if the plan names an active compensation. Raises ValueError if the noise is
    negative, InputError if the set-up contradicts the machine or an effect lacks a variable.
    """
    for name, unit, noise in (("noise_um", "micrometres", noise_um), ("noise_urad", "microradians", noise_urad)):
        if not noise >= 0.0:
            raise ValueError(f"{name}: expected a number of {unit}, at least 0; given {noise}")
    model = model.with_values(errors.values if isinstance(errors, Errors) else errors)
    runs, rows = plan.data.setup.runs, plan.data.readings
    if faults := setup_faults(model, plan.data, plan.folder):
        raise InputError(faults)
    file, context = str(readings_path(plan.folder)), None
    fill = rows_to_fill(rows, replace_all)
    if model.effect_values:
        context = context_of(runs, rows)
        if faults := faults_of_readings(model, runs, rows, context, fill, file):
            raise InputError(faults)
    filled = filled_in(
        model,
        runs,
        rows,
        noise_um=noise_um,
        noise_urad=noise_urad,
        seed=seed,
        replace_all=replace_all,
        context=context,
    )
    if plan.active is not None:
        taken = compensated_part(model, plan.active, runs, rows)
        filled = replace(filled, reading=np.where(fill, filled.reading - taken, filled.reading))
    check_simulated(filled, runs, file)
    return replace(plan, data=replace(plan.data, readings=filled))
