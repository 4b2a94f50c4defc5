"""Kinds of instruments, and the unit in which each reads.

An angle instrument reads rad. Everywhere behind the files its reading is the displacement, in mm, that the rotation
makes at an arm of ARM: so is an angle measured by two beams, and a microradian is a micrometre at a metre. Noise,
sizes, residuals and root mean squares of angles and of lengths are then numbers of one order, and no formula asks which
it has.
"""

from typing import Literal, get_args

Instrument = Literal["laser", "ballbar", "probe", "angle", "displacement"]
SmallUnit = Literal["um", "urad"]

INSTRUMENTS: tuple[Instrument, ...] = get_args(Instrument)
ANGLE: Instrument = "angle"
AT_REST: Instrument = "displacement"  # a sensor at one pose of the machine
ARM = 1000.0  # mm, at which a rotation of 1 urad moves a point by 1 um


def small_unit(instrument: str) -> SmallUnit:
    """Unit of a thousandth of what its readings are in: of mm, or of mm at a metre."""
    return "urad" if instrument == ANGLE else "um"


def unit_of_file(instrument: str) -> Literal["mm", "rad"]:
    """Unit of `reading` in readings.csv."""
    return "rad" if instrument == ANGLE else "mm"
