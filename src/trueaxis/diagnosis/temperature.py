"""The temperature without the flicker of the thermometer.

No structure follows a thermometer from reading to reading; what flickers there would make every thermal effect look
smaller than it is (errors in variables). A polynomial in time for each run keeps its course.
"""

from dataclasses import replace

import numpy as np
from numpy.polynomial import Legendre

from trueaxis.diagnosis.result import FloatArray
from trueaxis.measurement.data import MeasuredData

BENDS_S = 600.0  # s, of a run, for each further degree beyond 2
PER_DEGREE = 8  # readings, at least


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


def _course(time: FloatArray, temperature: FloatArray) -> FloatArray:
    span = float(np.ptp(time)) if time.size else 0.0
    degree = min(2 + int(span / BENDS_S), time.size // PER_DEGREE)
    if span == 0.0 or degree < 1:
        return temperature
    return np.asarray(Legendre.fit(time, temperature, degree)(time))
