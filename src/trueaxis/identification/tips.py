"""Whether the tip of a probe stays at its sphere while linear axes follow a rotary one."""

from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.optimize import minimize_scalar

from trueaxis.estimation.observations import Observations
from trueaxis.estimation.set_up import relative_motion
from trueaxis.identification.slips import SENSE, Slip, Wrong, other_sense, other_way
from trueaxis.identification.words import enumerated, some_of
from trueaxis.io.faults import Fault
from trueaxis.machine.machine import LINEAR, ROTARY
from trueaxis.measurement.columns import BoolArray
from trueaxis.measurement.data import readings_path
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import FILE_NAME, Run
from trueaxis.model.model import MachineModel

OFF_SPHERE = 5.0  # mm: a sphere is set up within five with a ruler
ANGLE_STEP = 5.0  # deg, at which other zeros of a rotary axis are tried, before the best is looked for about them
# of the way that a tip goes: by another zero it has to stay where it was but for as much. A sphere that is written some
# millimetres elsewhere is not explained by an angle
NEARLY_ALL = 0.05
SMALLEST_OFF = 0.001  # mm, to which it is said how far a tip stays where it was


def wrong_tip(model: MachineModel, run: Run, positions: FloatArray, folder: Path) -> Wrong | None:
    """A run of a probe whose tip stays where it was, while linear axes follow a rotary one, if one axis moves the other
    way, if the rotary axes were written in radians, or if one of them were counted from elsewhere.

    Where neither does that, it may be of no sphere at all: `tip_notes` then says how far it goes.
    """
    way = _of_tip(model, run, positions)
    if not _follows(model, positions) or way <= OFF_SPHERE:
        return None
    rotary = [axis for axis in model.axes if axis in ROTARY]
    turned = np.array([axis in ROTARY for axis in model.axes])
    in_degrees = np.where(turned[:, np.newaxis], np.rad2deg(positions), positions)
    if (within := _of_tip(model, run, in_degrees)) <= OFF_SPHERE:
        problem = _leaves(way, "these positions were radians", within)
        columns, file = f"column {enumerated(rotary, 'or')}", str(readings_path(folder))
        radians = Slip(f"their positions of {enumerated(rotary)} were radians", file, f"degrees in {columns}")
        return Wrong(run.id, Fault(file, columns, f"run {run.id}: {problem}", "degrees"), (radians,))
    left = {}
    for row, axis in enumerate(model.axes):
        if np.ptp(positions[row]) > 0.0:
            home = {**run.home, axis: -run.home[axis]} if axis in run.home else run.home
            left[axis] = _of_tip(model, replace(run, home=home), other_way(positions, row))
    others = [axis for axis, off in left.items() if off <= OFF_SPHERE]
    if not others:
        return _counted_from_elsewhere(model, run, positions, way, folder)
    file, within = str(folder / FILE_NAME), max(left[axis] for axis in others)
    named = enumerated(others, "or")
    problem = _leaves(way, f"{named} moved the other way", within)
    fault = Fault(file, f"run {run.id}", problem, SENSE.format(axis=named))
    return Wrong(run.id, fault, tuple(other_sense(axis, file) for axis in others))


def _counted_from_elsewhere(
    model: MachineModel, run: Run, positions: FloatArray, way: float, folder: Path
) -> Wrong | None:
    """If a rotary axis were turned by some angle in all positions, the tip would stay where it was."""
    found: tuple[float, str, float] | None = None
    for row, axis in enumerate(model.axes):
        if axis not in ROTARY or axis not in run.home:
            continue
        unit = np.arange(len(model.axes))[:, np.newaxis] == row

        def off(angle: float, unit: BoolArray = unit, axis: str = axis) -> float:
            return _of_tip(
                model, replace(run, home={**run.home, axis: run.home[axis] + angle}), positions + angle * unit
            )

        rough = min(np.arange(-180.0, 180.0, ANGLE_STEP).tolist(), key=off)
        best = float(minimize_scalar(off, bounds=(rough - ANGLE_STEP, rough + ANGLE_STEP), method="bounded").x)
        best = min(best, float(np.round(best)), key=off)  # whole degrees where they do as well
        if found is None or off(best) < found[0]:
            found = off(best), axis, best
    if found is None or found[0] > min(OFF_SPHERE, NEARLY_ALL * way):
        return None
    left, axis, angle = found
    supposed = f"{axis} were {abs(angle):.5g} deg {'more' if angle > 0.0 else 'less'} than written"
    file = str(folder / FILE_NAME)
    remedy = f"positions of {axis} (and home) as the spec counts them: the zero of {axis} in both is one place"
    fault = Fault(file, f"run {run.id}", _leaves(way, supposed, left), remedy)
    return Wrong(run.id, fault, (Slip(supposed, file, remedy),))


def _leaves(way: float, supposed: str, within: float) -> str:
    return (
        f"the tip leaves its place by up to {way:.4g} mm while rotary axes turn; if {supposed}, it would stay there "
        f"within {max(SMALLEST_OFF, within):.2g} mm"
    )


def _of_tip(model: MachineModel, run: Run, positions: FloatArray) -> float:
    moved = relative_motion(model, run, positions)
    return float(np.linalg.norm(moved - moved[:, :1], axis=0).max())


def tip_notes(model: MachineModel, observed: Observations) -> tuple[str, ...]:
    """Runs of a probe in which the tip does not stay where it was while linear axes follow a rotary one."""
    far: dict[str, float] = {}
    for index, run in enumerate(observed.runs):
        positions = np.ascontiguousarray(observed.positions[:, observed.run == index])
        if run.instrument == "probe" and _follows(model, positions):
            way = _of_tip(model, run, positions)
            far |= {run.id: way} if way > OFF_SPHERE else {}
    if not far:
        return ()
    return (
        f"{some_of([*far])}: the tip leaves its place by up to {max(far.values()):.3g} mm while "
        "rotary axes turn. If these are of a sphere, a dimension (--known), the sense of an axis, positions or a point "
        "in setup.toml is wrong, and the values are, too",
    )


def _follows(model: MachineModel, positions: FloatArray) -> bool:
    """Whether linear axes move while rotary ones do."""
    moving = {axis for axis, at in zip(model.axes, positions, strict=True) if at.size and np.ptp(at) > 0.0}
    return bool(moving & set(LINEAR) and moving & set(ROTARY))
