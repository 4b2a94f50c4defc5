"""Readings normalised to 20 degC: what a scale or screw of a temperature would have moved by at 20 degC.

A laser measures the way that an axis goes as it is; a warm screw goes too far by its coefficient of expansion.
Instruments may have taken that off already, by a coefficient of their own: it is added again before the axis's own is
taken off, so that nothing is normalised twice.
"""

from dataclasses import replace

import numpy as np

from trueaxis.effects.variables import REFERENCE_TEMPERATURE
from trueaxis.instrument_files.user_keys import RunKeys
from trueaxis.measurement.instrument_run import FloatArray, InstrumentRun
from trueaxis.measurement.limits import COLDEST, WARMEST
from trueaxis.measurement.setup_reader import LARGEST_EXPANSION

PER_KELVIN = 1e-6  # of what the keys are in


def normalised(
    source: InstrumentRun, own: RunKeys, axis: str | None, way: FloatArray
) -> tuple[InstrumentRun, float | None, tuple[str, ...]] | None:
    """The run, the coefficient that its readings are normalised by (1e-6/K), and sentences on that.

    way: (n,), mm, ideal displacement since home along the sensed direction. The run as it is where no coefficient of
    its axis is given; None where something is open or wrong, which is noted.
    """
    if axis is None or own.said(f"expansion.{axis}") is None:
        return source, None, ()
    wanted = own.number(f"expansion.{axis}", "", "11.5")
    meaning = (
        "by which coefficient the instrument has normalised its readings to 20 degC already, 1e-6/K (0: it has not)"
    )
    applied = own.number("normalised", meaning, "0")
    temperature = _temperature(source, own)
    for key, value in ((f"expansion.{axis}", wanted), ("normalised", applied)):
        if value is not None and not 0.0 <= value <= LARGEST_EXPANSION:
            own.wrong(key, own.values[key], f"a coefficient in 1e-6/K, from 0 to {LARGEST_EXPANSION:g}")
            return None
    if wanted is None or applied is None or temperature is None:
        return None
    warmer = temperature - REFERENCE_TEMPERATURE
    reading = source.reading - (wanted - applied) * PER_KELVIN * warmer * way
    low, high = float(temperature.min()), float(temperature.max())
    at = f"{low:.6g}" if low == high else f"{low:.6g} to {high:.6g}"
    before = f", of which the instrument had done {applied:g}e-6/K" if applied else ""
    said = f"readings are normalised to 20 degC by {wanted:g}e-6/K, at {at} degC{before}"
    return replace(source, reading=reading), wanted, (said,)


def _temperature(source: InstrumentRun, own: RunKeys) -> FloatArray | None:
    """(n,), degC: of the rows where the file has it, else as the user says."""
    if source.temperature is not None and np.isfinite(source.temperature).all():
        return source.temperature
    value = own.number("temperature", "how warm the scale or screw of the axis was, degC", "21.5")
    if value is not None and not COLDEST <= value <= WARMEST:
        own.wrong("temperature", own.values["temperature"], f"degC, from {COLDEST:g} to {WARMEST:g}")
        return None
    return None if value is None else np.full(source.reading.size, value)
