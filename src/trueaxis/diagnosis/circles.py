"""Circularity of the measured circles, and what each stage of the model leaves of it."""

import numpy as np

from trueaxis.diagnosis.gain import Left
from trueaxis.diagnosis.result import Circle, FloatArray
from trueaxis.diagnosis.signatures import Readings


def circles_of(readings: Readings, left: Left) -> tuple[Circle, ...]:
    """One per ball-bar run: largest minus smallest radius about the least-squares centre (ISO 230-4, G), mm."""
    rows, found = readings.rows, []
    for index in rows.present:
        if rows.runs[index].instrument != "ballbar":
            continue
        mine = rows.of_run(index)
        theta = readings.reading.theta[mine]
        found.append(
            Circle(
                rows.runs[index].id,
                *(circularity(theta, part[mine]) for part in (rows.reading, left.given, left.refitted, left.extended)),
            )
        )
    return tuple(found)


def circularity(theta: FloatArray, deviation: FloatArray) -> float:
    """Range of the radial deviations (n,), mm, at polar angles (n,), rad, less the centre fitted."""
    centre = np.stack([np.ones(theta.size), np.cos(theta), np.sin(theta)], axis=1)
    rest = deviation - centre @ np.linalg.lstsq(centre, deviation, rcond=None)[0]
    return float(np.ptp(rest)) if rest.size else 0.0
