"""Whether set-up and readings can be of this machine: points, positions, length and readings that contradict others.

A reading is refused where it is off by more than BELIEVED times what the prior sizes of the errors allow there, besides
what its instrument may be off by. A contradiction of this size is a slip of writing: a wrong point, sign or unit. What
would explain how far the balls of a ball bar are apart is named: a dimension, the place of a ball, the length.
"""

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import cast

import numpy as np

from trueaxis.estimation.set_up import is_straightness, relative_motion
from trueaxis.identification.fit_quality import expected_size
from trueaxis.identification.slips import SENSE, Slip, Wrong, faults_of, other_sense, other_way
from trueaxis.identification.tips import OFF_SPHERE, wrong_tip
from trueaxis.identification.words import enumerated
from trueaxis.io.faults import Fault
from trueaxis.measurement.data import MeasuredData, readings_path
from trueaxis.measurement.instrument_kinds import ARM, unit_of_file
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_geometry import along_line
from trueaxis.measurement.reading_model import ideal_bar, ideal_reading, measuring_frame
from trueaxis.measurement.readings import Readings
from trueaxis.measurement.setup import FILE_NAME, Run
from trueaxis.model.model import MachineModel

BELIEVED = 5.0  # times the prior standard deviation of a reading

# mm, what instruments may be off by: a ball or sphere is set up within a millimetre, with a ruler within five; the
# range of straightness optics; a laser's dead path and the growth of a cold machine, which a sensor at rest is to show;
# half of the range of an electronic autocollimator, 1 mrad (mm at ARM)
SET_UP = {"ballbar": 5.0, "probe": OFF_SPHERE, "straightness": 2.5, "laser": 0.5, "displacement": 0.5, "angle": 1.0}
BY_EYE = 5e-4  # rad, one standard deviation: what a line of straightness is off by that nobody has aligned with care
MOST_ROWS = 5  # named of a run
IN_UNIT = "is the reading in {unit}? [prior] of the machine's spec says what errors may be expected"
MOST_FITTED = 500  # positions that a cause is sought from
OFF = 5.0  # mm, what is left of distances where a cause explains them: a ball is set up within five with a ruler
FARTHEST = 500.0  # mm from what is given, from where a dimension is sought as well


def setup_faults(model: MachineModel, data: MeasuredData, folder: Path, only: Collection[str] = ()) -> list[Fault]:
    """Runs whose set-up or readings are not believable on the machine; dimensions are those of the model's values.

    only: of these runs, by id, if any are named.
    """
    wrong: list[Wrong] = []
    for index, run in enumerate(data.setup.runs):
        if only and run.id not in only:
            continue
        rows = data.readings.of_run(index)
        if rows.size and (found := _wrong(model, run, data.readings, rows, folder)) is not None:
            wrong.append(found)
    silent = _silent(model)
    if not silent or len(wrong) < 2:
        return faults_of(wrong)
    named = ", ".join(one.run for one in wrong)
    problem = f"{len(wrong)} runs contradict them as zero, which is what they are taken for: {named}"
    remedy = (
        "give them with --known E.json (a file of error values with these parameters, mm); the first of these runs:"
    )
    return [Fault("dimensions not given", ", ".join(silent), problem, remedy), wrong[0].fault]


def _silent(model: MachineModel) -> list[str]:
    """Dimensions that no error value gives: one missing file is more likely than several wrong runs."""
    return [name for name in model.dimensions if name not in model.errors.parameters]


def _wrong(model: MachineModel, run: Run, readings: Readings, rows: np.ndarray, folder: Path) -> Wrong | None:
    positions = np.ascontiguousarray(readings.positions[:, rows])
    reading = np.nan_to_num(readings.reading[rows])  # a plan's rows are checked for their geometry
    if run.instrument == "probe" and (of_tip := wrong_tip(model, run, positions, folder)) is not None:
        return of_tip
    ideal = ideal_reading(model, run, positions)
    allowed = BELIEVED * expected_size(model, run, positions) + _set_up(model, run, positions)
    wrong = np.flatnonzero(~(np.abs(ideal - reading) <= allowed))
    if wrong.size == 0:
        return None
    first = int(wrong[0])
    if run.instrument == "ballbar" and not abs(ideal[first]) <= abs(reading[first]):  # what is far: the balls
        causes, slips = _ball_causes(model, run, positions, reading, str(folder / FILE_NAME))
        fault = Fault(str(folder / FILE_NAME), f"run {run.id}", _apart(run, ideal[first], first), causes)
        return Wrong(run.id, fault, slips)
    named = ", ".join(str(readings.seq[rows[row]]) for row in wrong[:MOST_ROWS])
    more = f" and {wrong.size - MOST_ROWS} more" if wrong.size > MOST_ROWS else ""
    worst = int(wrong[np.argmax(np.abs(reading[wrong]))])
    unit = unit_of_file(run.instrument)
    off, most = (float(one[worst]) / (ARM if unit == "rad" else 1.0) for one in (reading, allowed))
    problem = (
        f"run {run.id}, seq {named}{more}: up to {off:.6g} {unit}, where errors of machine and set-up "
        f"allow {most:.2g} {unit} at most"
    )
    return Wrong(run.id, Fault(str(readings_path(folder)), "column reading", problem, IN_UNIT.format(unit=unit)))


def _set_up(model: MachineModel, run: Run, positions: FloatArray) -> FloatArray | float:
    if run.instrument != "laser" or not is_straightness(model, run, positions):
        return SET_UP[run.instrument]
    along = np.abs(along_line(relative_motion(model, run, positions)))
    return np.asarray(SET_UP["straightness"] + BELIEVED * BY_EYE * along)


def _apart(run: Run, off: float, row: int) -> str:
    length = cast(float, run.length)
    at = "at the first position" if row == 0 else f"at position {row + 1}"
    return f"the balls are {length + off:.6g} mm apart {at}, not {length:g} mm"


def _ball_causes(
    model: MachineModel, run: Run, positions: FloatArray, reading: FloatArray, file: str
) -> tuple[str, tuple[Slip, ...]]:
    """What explains the distances by itself, likeliest first: dimensions are given apart from the set-up and forgotten,
    an axis is written the wrong way round, which needs no number to agree, a ball is set up by hand, a length stands on
    the bar; and those of these that other runs may have as well. reading: (n,), mm; file: of the set-up.
    """
    every = slice(None, None, max(positions.shape[1] // MOST_FITTED, 1))
    positions = np.ascontiguousarray(positions[:, every])
    length = cast(float, run.length) + reading[every]
    silent = _silent(model)
    forgotten, wrong = (
        dict(_dimensions(model, run, positions, length, names))
        for names in (silent, [name for name in model.dimensions if name not in silent])
    )
    turned = tuple(_senses(model, run, positions, length))
    causes = [
        *(_dimension(model, *one) for one in forgotten.items()),
        *(f"does {axis} move the other way? ({SENSE.format(axis=axis)})" for axis in turned),
        *(_dimension(model, *one) for one in wrong.items()),
        *_ball(model, run, positions, length),
        *_length(model, run, positions, length),
    ]
    slips = [other_sense(axis, file) for axis in turned]
    slips += [_other_dimension(model, name, value, file) for name, values in wrong.items() for value in values]
    hint = f"; {', '.join(silent)} are taken as zero (--known gives them)" if silent else ""
    if not causes:
        return f"points, positions and length that agree{hint}", ()
    first = "" if len(causes) == 1 else "one of these, likeliest first: "
    return f"{first}{'; '.join(causes)}{hint}", tuple(slips)


def _other_dimension(model: MachineModel, name: str, value: float, file: str) -> Slip:
    """To a millimetre: a ball is set up within five with a ruler."""
    given = model.errors.parameters[name]
    return Slip(f"{name} were {round(value)} mm", file, f"dimension {name} (--known; given as {given:g})")


def _senses(model: MachineModel, run: Run, positions: FloatArray, length: FloatArray) -> Iterator[str]:
    for row, axis in enumerate(model.axes):
        off = np.abs(np.linalg.norm(ideal_bar(model, run, other_way(positions, row)), axis=0) - length)
        if positions[row].any() and float(off.max()) <= OFF:
            yield axis


def _dimensions(
    model: MachineModel, run: Run, positions: FloatArray, length: FloatArray, names: Sequence[str]
) -> Iterator[tuple[str, list[float]]]:
    """Those that explain the distances, each with its values, mm, the next to what is given first."""
    for name in names:
        given = model.errors.parameters.get(name, 0.0)
        bars = [ideal_bar(_with(model, name, value), run, positions) for value in (given, given + 1.0)]

        def off(value: FloatArray, bars: Sequence[FloatArray] = bars) -> FloatArray:
            return np.asarray(np.linalg.norm(bars[0] + value * (bars[1] - bars[0]), axis=0) - length)

        values = _fits(off, [np.array([start]) for start in (-FARTHEST, FARTHEST)])
        if values:
            yield name, [given + float(value[0]) for value in values]


def _dimension(model: MachineModel, name: str, values: Sequence[float]) -> str:
    given = model.errors.parameters.get(name, 0.0)
    told = [f"{round(value, 3) + 0.0:g}" for value in values]
    taken = "given as" if name in model.errors.parameters else "not given, taken as"
    return f"dimension {name} = {enumerated(told, 'or')} mm (--known; {taken} {given:g})"


def _with(model: MachineModel, name: str, value: float) -> MachineModel:
    parameters = {**model.errors.parameters, name: value}
    return model.with_values(replace(model.errors, parameters=parameters))


def _ball(model: MachineModel, run: Run, positions: FloatArray, length: FloatArray) -> Iterator[str]:
    """Where the ball that rests in the measuring frame would have to be."""
    ends = {"target": run.target, "reference": run.reference}
    name, end = next((name, end) for name, end in ends.items() if end.on == measuring_frame(run))
    # the other ball, seen from the point that is given
    other = (-1.0 if name == "target" else 1.0) * ideal_bar(model, run, positions)

    def off(centre: FloatArray) -> FloatArray:
        return np.asarray(np.linalg.norm(other - centre[:, np.newaxis], axis=0) - length)

    # |p|^2 - 2 p c + k = length^2 with k = |c|^2 is linear: a start that no distance between the points can mislead
    rows = np.vstack([2.0 * other, -np.ones(other.shape[1])]).T
    start = np.linalg.lstsq(rows, (other**2).sum(axis=0) - length**2, rcond=1e-9)[0][:3]
    middle = other.mean(axis=1)
    normal = np.linalg.svd(other - middle[:, np.newaxis])[0][:, 2]  # of a circle's plane: it has a place on either side
    beside = start + normal * (normal @ (middle - start))
    starts = [beside + side * FARTHEST * normal for side in (-1.0, 1.0)]
    centres = _fits(off, [start, np.zeros(3), *starts])
    if centres:
        at = [str([round(float(value), 3) + 0.0 for value in np.array(end.point) + moved]) for moved in centres]
        yield f"the ball on the {end.on} would have to be at {enumerated(at, 'or')} (key {name}.point)"


def _length(model: MachineModel, run: Run, positions: FloatArray, length: FloatArray) -> Iterator[str]:
    off = np.linalg.norm(ideal_bar(model, run, positions), axis=0) - length
    if float(np.ptp(off)) <= OFF:
        yield f"is the length {cast(float, run.length) + float(np.mean(off)):.6g} mm? (key length)"


def _fits(off: Callable[[FloatArray], FloatArray], starts: Sequence[FloatArray]) -> list[FloatArray]:
    """Values that leave little, those next to what is given first; sought from several starts."""
    from scipy.optimize import least_squares  # noqa: PLC0415  only a fault asks for it

    found: list[list[FloatArray]] = []  # those that no ruler tells apart, such as on either side of a circle's plane
    for start in starts:
        fit = least_squares(off, start, max_nfev=100)
        if float(np.abs(fit.fun).max()) <= OFF:
            near = next((of for of in found if float(np.linalg.norm(of[0] - fit.x)) <= OFF), None)
            if near is None:
                found.append(near := [])
            near.append(np.asarray(fit.x, dtype=np.float64))
    middles = [0.5 * (np.min(of, axis=0) + np.max(of, axis=0)) for of in found]
    return sorted(middles, key=lambda middle: float(np.linalg.norm(middle)))
