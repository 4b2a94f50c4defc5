"""The noise that a plan is judged for: as given, as the device's table states it, else a round figure."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from trueaxis.estimation.observations import Observations
from trueaxis.identification.weighting import NoiseModel, weighting
from trueaxis.io.faults import Fault, InputError
from trueaxis.measurement.instrument_kinds import ANGLE, INSTRUMENTS
from trueaxis.measurement.setup import Device

DEFAULT_UM = 1.0  # what lasers, ball bars and probes scatter by in a shop, and in urad angular optics and levels


def noise_of_runs(observed: Observations, stated: NoiseModel) -> dict[int, float]:
    """Standard deviation of the readings of every run, by index, mm: stated for the run or its instrument, else as of a
    plan that states none. Raises InputError for names that are no run and no instrument.
    """
    runs = [(int(index), observed.runs[index]) for index in np.unique(observed.run)]
    found = {index: _of_device(run.instrument, run.device, stated) for index, run in runs}
    if not stated.by_group:
        return found
    silent = [(index, run) for index, run in runs if not {run.id, run.instrument} & stated.by_group.keys()]
    filled = {run.id: 1e3 * found[index] for index, run in silent if run.instrument != ANGLE}
    angles = [1e3 * found[index] for index, run in runs if run.instrument == ANGLE]
    whole = replace(stated, by_group={**stated.by_group, **filled}, urad=stated.urad or next(iter(angles), None))
    weights = weighting(observed, whole)
    assert weights.sigma is not None
    each = weights.sigma / weights.roots
    named = {index: float(each[observed.run == index][0]) for index, _ in runs}
    return {**named, **{index: found[index] for index, _ in silent}}


def noise_of_instruments(
    instruments: Sequence[str], devices: Mapping[str, Device], stated: NoiseModel
) -> dict[str, float]:
    """Standard deviation of the readings of new runs, by instrument, mm: stated for it, else as of a plan that states
    none.
    """
    return {
        name: 1e-3 * stated.by_group[name]
        if name in stated.by_group and name != ANGLE
        else _of_device(name, devices.get(name), stated)
        for name in instruments
    }


def refuse_runs(stated: NoiseModel) -> None:
    """Raise InputError where the noise of a first plan names what is no instrument: it has no runs yet."""
    wrong = [name for name in stated.by_group if name not in INSTRUMENTS or name == ANGLE]
    right = ", ".join(name for name in INSTRUMENTS if name != ANGLE)
    if wrong:
        raise InputError([Fault("--noise-um", name, "is no instrument of lengths", right) for name in wrong])


def _of_device(instrument: str, device: Device | None, stated: NoiseModel) -> float:
    """Standard deviation, mm; of an angle at ARM, where a microradian is a micrometre."""
    given = stated.urad if instrument == ANGLE else stated.um
    if given is not None:
        return 1e-3 * given
    return device.noise if device is not None and device.noise is not None else 1e-3 * DEFAULT_UM
