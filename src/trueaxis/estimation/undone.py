"""What is wrong with the readings of a run, and what they would be without: sign, unit, order of the targets."""

from collections.abc import Mapping
from typing import Literal

import numpy as np

from trueaxis.estimation.display import DECIMALS
from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.measurement.instrument_kinds import ANGLE
from trueaxis.measurement.machine import FloatArray

How = Literal["reversed", "small", "large", "inch", "arcsec", "urad", "mirrored", "swapped", "turned", "framed"]

# By what a run's readings are multiplied to undo it; a mirrored run is put in the other order. Two swapped runs get
# each other's readings. Inches were written for mm; arcseconds for microradians, or the other way round.
INCH, ARCSEC = 25.4, np.pi / 0.648  # mm of an inch, urad of an arcsecond
UNDONE: Mapping[How, float] = {
    "reversed": -1.0,
    "small": 1e3,
    "large": 1e-3,
    "inch": INCH,
    "arcsec": ARCSEC,
    "urad": 1.0 / ARCSEC,
    "mirrored": 1.0,
}
# of all runs of an instrument alone: one that is five or twenty times as quiet as the others, or they as noisy, proves
# no other unit
OF_LENGTHS: tuple[How, ...] = ("inch",)
OF_ANGLES: tuple[How, ...] = ("arcsec", "urad")
ONLY_TOGETHER = (*OF_LENGTHS, *OF_ANGLES)
UNITS: tuple[How, ...] = ("small", "large", *ONLY_TOGETHER)
OF_INSTRUMENTS: tuple[How, ...] = ("reversed", *UNITS)  # that all runs of one may have together
NEARLY = 0.1  # logarithm: noise is known to so much from a hundred readings, and stated to no more
FEWEST_TARGETS = 3
TARGETS = 6  # decimals of mm or deg, within which targets are the same


def undone_reading(one: MeasuredRun, how: How) -> FloatArray | None:
    """(n,): the readings of a run with a fault undone, mm; None where it cannot have the fault."""
    if np.ptp(one.reading) <= 10.0**-DECIMALS:
        return None  # a display that never moved
    if how in (OF_LENGTHS if one.instrument == ANGLE else OF_ANGLES):
        return None
    if how != "mirrored":
        return UNDONE[how] * one.reading
    partner = _mirrored(one)
    return None if partner is None else one.reading[partner]


def unit_of(ratio: float, instrument: str) -> How | None:
    """The wrong unit by which readings have so many times the noise that they should have; None where it is none."""
    for how in UNITS:
        other = how in (OF_LENGTHS if instrument == ANGLE else OF_ANGLES)
        if not other and abs(np.log(ratio * UNDONE[how])) < NEARLY:
            return how
    return None


def _mirrored(one: MeasuredRun) -> IntArray | None:
    """(n,): the row of each row's target counted from the other end, of the same pass; None where there is none."""
    positions = np.round(one.rows.positions, TARGETS) + 0.0
    moving = np.ptp(positions, axis=1)
    if one.instrument == "ballbar" or not moving.any():
        return None
    _, target = np.unique(positions[int(np.argmax(moving))], return_inverse=True)
    count = np.bincount(target)
    if count.size < FEWEST_TARGETS or (count != count[::-1]).any():
        return None
    order = np.argsort(target, kind="stable")
    start = np.cumsum(count) - count
    turn = np.empty_like(target)
    turn[order] = np.arange(target.size) - np.repeat(start, count)  # number of the visit of its target
    return np.asarray(order[start[count.size - 1 - target] + turn])
