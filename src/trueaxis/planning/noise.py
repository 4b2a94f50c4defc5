"""The noise that a plan is judged for: as given, as the device's table states it, else a round figure."""

from collections.abc import Mapping, Sequence

import numpy as np

from trueaxis.estimation.observations import Observations
from trueaxis.identification.weighting import NoiseModel, weighting
from trueaxis.io.faults import Fault, InputError
from trueaxis.measurement.instrument_kinds import ANGLE
from trueaxis.measurement.setup import Device

DEFAULT_UM = 1.0  # what lasers, ball bars and probes scatter by in a shop, and in urad angular optics and levels


def noise_of_runs(observed: Observations, stated: NoiseModel) -> dict[int, float]:
    """Standard deviation of the readings of every run, by index, mm. Raises InputError where one has none."""
    if stated.by_group:
        weights = weighting(observed, stated)
        assert weights.sigma is not None
        each = weights.sigma / weights.roots
        return {int(index): float(each[observed.run == index][0]) for index in np.unique(observed.run)}
    runs = [(int(index), observed.runs[index]) for index in np.unique(observed.run)]
    return {index: _of_device(run.instrument, run.device, stated) for index, run in runs}


def noise_of_instruments(
    instruments: Sequence[str], devices: Mapping[str, Device], stated: NoiseModel
) -> dict[str, float]:
    """Standard deviation of the readings of new runs, by instrument, mm. Raises InputError where one has none."""
    if not stated.by_group:
        return {name: _of_device(name, devices.get(name), stated) for name in instruments}
    missing = [name for name in instruments if name not in stated.by_group and name != ANGLE]
    if missing:
        raise InputError(
            [Fault("--noise-um", "", f"says nothing of new runs of the {name}", f"{name}=S") for name in missing]
        )
    return {
        name: _of_device(name, devices.get(name), stated) if name == ANGLE else 1e-3 * stated.by_group[name]
        for name in instruments
    }


def _of_device(instrument: str, device: Device | None, stated: NoiseModel) -> float:
    """Standard deviation, mm; of an angle at ARM, where a microradian is a micrometre."""
    given = stated.urad if instrument == ANGLE else stated.um
    if given is not None:
        return 1e-3 * given
    return device.noise if device is not None and device.noise is not None else 1e-3 * DEFAULT_UM
