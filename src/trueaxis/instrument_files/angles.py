"""Readings of files of angles: in which unit they are, and about which axis they count."""

import math
from dataclasses import replace
from typing import cast

import numpy as np

from trueaxis.instrument_files.user_keys import Question, RunKeys
from trueaxis.machine.machine import LINEAR, Machine
from trueaxis.measurement.instrument_kinds import ARM
from trueaxis.measurement.instrument_run import InstrumentRun
from trueaxis.measurement.setup import Vector

UNITS = {"rad": 1.0, "mrad": 1e-3, "urad": 1e-6, "arcsec": math.radians(1.0 / 3600.0)}
# rad: angular errors of linear axes and positions of rotary ones are off by some ten to hundred microradians. What is
# beyond a milliradian, in a file of which nobody has said the unit, is milliradians taken for radians.
BELIEVED = 1e-3


def in_angles(source: InstrumentRun, own: RunKeys) -> InstrumentRun | None:
    """The run with readings in mm at ARM; None where it is open in which unit the file has them, which is noted."""
    unit = own.text("unit.reading", "", "rad", among=tuple(UNITS), default="rad")
    if unit is None:
        return None
    angle = source.reading * UNITS[unit]
    largest = float(np.abs(angle).max(initial=0.0))
    if own.sources["unit.reading"] == "default" and largest > BELIEVED:
        meaning = f"in which unit its angles are (rad, mrad, urad, arcsec); in rad they would reach {largest:.3g} rad"
        own.keys.questions.append(
            Question(file=source.file, run=source.id, key="unit.reading", meaning=meaning, right="mrad")
        )
        return None
    return replace(source, reading=angle * ARM)


def about(machine: Machine, axis: str | None) -> tuple[str, str, Vector | None]:
    """Meaning, example and default of `direction`, the axis of the rotation; an axis that turns has a default."""
    meaning = "about which axis it reads the rotation, right-handed, in `frame` (pitch and yaw are about others)"
    if axis is None or axis in LINEAR:
        return meaning, "0,0,1", None
    sense = float(machine.mover(axis).sense)
    letter = "ABC".index(axis)
    return meaning, "0,0,1", cast(Vector, tuple(sense if k == letter else 0.0 for k in range(3)))
