"""What files of instruments leave unsaid: unit of angles, direction of a run, temperature of readings, passes of rows.

A laser measures the way that an axis goes as it is; a warm screw goes too far by its coefficient of expansion.
Instruments may have taken that off already, by a coefficient of their own: it is added again before the axis's own is
taken off, so that nothing is normalised twice.
"""

import math
from dataclasses import replace
from typing import cast

import numpy as np
import numpy.typing as npt

from trueaxis.effects.placement import REFERENCE_TEMPERATURE
from trueaxis.instrument_files.user_keys import Question, RunKeys
from trueaxis.machine.machine import LINEAR, Machine
from trueaxis.measurement.instrument_kinds import ARM
from trueaxis.measurement.instrument_run import DirectionArray, FloatArray, InstrumentRun
from trueaxis.measurement.limits import COLDEST, WARMEST
from trueaxis.measurement.setup import Vector
from trueaxis.measurement.setup_reader import LARGEST_EXPANSION

UNITS = {"rad": 1.0, "mrad": 1e-3, "urad": 1e-6, "arcsec": math.radians(1.0 / 3600.0)}
# rad: angular errors of linear axes and positions of rotary ones are off by some ten to hundred microradians. What is
# beyond a milliradian, in a file of which nobody has said the unit, is milliradians taken for radians.
BELIEVED = 1e-3
SMALLEST = 1e-9  # length of a direction that can be made a unit vector
PER_KELVIN = 1e-6  # of what the keys are in
ONE_WAY = "passes that begin where the one before began come from beyond their first target, as a test from one side"
FEWEST_OF_PASS = 3  # rows, to tell a pass that is repeated from targets in no order


def in_angles(source: InstrumentRun, own: RunKeys) -> InstrumentRun | None:
    """The run with readings in mm at ARM; None where it is open in which unit the file has them, which is noted."""
    if not source.unit_open:
        return replace(source, reading=source.reading * ARM)
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


def directions_of(along: DirectionArray, positions: FloatArray, mover: int | None) -> DirectionArray:
    """(n_axes, n): ways of the axes where the file says those along the line, (n,). mover: row of the axis that moves
    alone, whose ways these are; of several each goes with the line or against it, as the steps between rows tell.
    """
    found = np.zeros(positions.shape, dtype=np.int8)
    if mover is not None:
        found[mover] = along
    else:  # the step that leads to a reading is in its direction, but for a few after a turn
        with_line = np.sign(np.sum(np.sign(np.diff(positions, axis=1)) * along[1:], axis=1))
        found[:] = with_line[:, np.newaxis] * along
    return found


def _about(machine: Machine, axis: str | None) -> tuple[str, str, Vector | None]:
    """Meaning, example and default of `direction`, the axis of the rotation; an axis that turns has a default."""
    meaning = "about which axis it reads the rotation, right-handed, in `frame` (pitch and yaw are about others)"
    if axis is None or axis in LINEAR:
        return meaning, "0,0,1", None
    sense = float(machine.mover(axis).sense)
    letter = "ABC".index(axis)
    return meaning, "0,0,1", cast(Vector, tuple(sense if k == letter else 0.0 for k in range(3)))


def sensed(machine: Machine, own: RunKeys, axis: str | None, *, angle: bool, backwards: bool) -> Vector | None:
    """The direction of a run. By default along the axis, so that readings grow with commands.

    backwards: whether the target, seen from the reference, goes the other way than what the axis carries.
    """
    default: Vector | None = None
    meaning, right = "the direction in which it reads positive, in `frame`", "1,0,0"
    if angle:
        meaning, right, default = _about(machine, axis)
    elif axis is not None and axis in LINEAR:
        sense = float(machine.mover(axis).sense) * (-1.0 if backwards else 1.0)
        default = cast(Vector, tuple(sense if name == axis else 0.0 for name in LINEAR))
    given = own.vector("direction", meaning, right, default=default)
    if given is None:
        return None
    size = math.hypot(*given)
    if not size > SMALLEST:
        own.wrong("direction", own.said("direction") or "", "three numbers that are not all zero")
        return None
    return cast(Vector, tuple(value / size for value in given))


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


def passes_of(targets: FloatArray) -> tuple[npt.NDArray[np.int64], bool]:
    """(n,): the number of the pass that each row belongs to: a new one where the way turns round; and whether some
    begin where the one before began.

    A row at the position of the one before begins the next pass: there the axis went beyond and came back. So does one
    at the first target of a pass of several: a test from one side goes back to where it began, and beyond.
    """
    passes = np.zeros(targets.size, dtype=np.int64)
    way, begin, one_way = 0.0, 0, False
    for row in range(1, targets.size):
        step = float(np.sign(targets[row] - targets[row - 1]))
        turned = step == 0.0 or way not in (0.0, step)
        again = turned and row - begin >= FEWEST_OF_PASS and bool(targets[row] == targets[begin])
        passes[row] = passes[row - 1] + turned
        begin = row if turned else begin
        way = 0.0 if again or (turned and step == 0.0) else step
        one_way |= again and step != 0.0
    return passes, one_way
