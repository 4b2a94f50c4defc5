"""How warm the machine was: the course of the temperature in each run, and what is assumed of runs without it."""

from dataclasses import replace

import numpy as np
from numpy.polynomial import Legendre

from trueaxis.diagnosis.result import FloatArray
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.readings import Readings
from trueaxis.model.context import Context

BENDS_S = 600.0  # s, of a run, for each further degree beyond 2
PER_DEGREE = 8  # readings, at least
# K, one standard deviation: by how much a run without a temperature may have been warmer or colder than the others.
# From morning to afternoon, and from one day to the next, a shop without air conditioning changes by so much.
UNKNOWN = 3.0


def smoothed(data: MeasuredData) -> MeasuredData:
    """The data with the course of the temperature in place of its readings; as they are where a clock is missing."""
    readings = data.readings
    if readings.time is None or readings.temperature is None:
        return data
    course = readings.temperature.copy()
    for index in range(len(readings.run_ids)):
        mine = readings.run == index
        if np.isfinite(readings.time[mine]).all() and np.isfinite(course[mine]).all():
            course[mine] = _course(readings.time[mine], course[mine])
    return replace(data, readings=replace(readings, temperature=course))


def assumed(readings: Readings) -> Readings:
    """With the mean temperature of the other runs where a run has none: they may be by UNKNOWN other than that.

    A shop writes down the temperature of some runs only; an effect that follows it shows in these, and is in the others
    all the same. Gaps within a run stay.
    """
    temperature = readings.temperature
    if temperature is None or not np.isfinite(temperature).any():
        return readings
    ones = [readings.run == index for index in range(len(readings.run_ids))]
    known = [float(np.nanmean(temperature[mine])) for mine in ones if np.isfinite(temperature[mine]).any()]
    filled = temperature.copy()
    for mine in ones:
        if np.isnan(temperature[mine]).all():
            filled[mine] = np.mean(known)
    return replace(readings, temperature=filled)


def warmer(context: Context) -> Context:
    """As if it had been warmer by UNKNOWN."""
    home = context.home and replace(context.home, temperature=context.home.temperature + UNKNOWN)
    return replace(context, temperature=context.temperature + UNKNOWN, home=home)


def _course(time: FloatArray, temperature: FloatArray) -> FloatArray:
    span = float(np.ptp(time)) if time.size else 0.0
    degree = min(2 + int(span / BENDS_S), time.size // PER_DEGREE)
    if span == 0.0 or degree < 1:
        return temperature
    return np.asarray(Legendre.fit(time, temperature, degree)(time))
