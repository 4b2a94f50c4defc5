"""From a run of an instrument file, and what the user says beside it, to a run of a data folder."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import cast

import numpy as np

from trueaxis.instrument_files.conventions import directions_of, in_angles, normalised, sensed
from trueaxis.instrument_files.user_keys import RunKeys, UserKeys
from trueaxis.io.faults import Fault
from trueaxis.io.safe_text import escaped
from trueaxis.machine.machine import BED, LINEAR, Machine
from trueaxis.measurement.instrument_kinds import ANGLE, ARM, Instrument, small_unit, unit_of_file
from trueaxis.measurement.instrument_run import DirectionArray, FloatArray, InstrumentRun
from trueaxis.measurement.limits import COLDEST, FARTHEST_POINT, FASTEST, LONGEST_ID, LONGEST_TIME, WARMEST
from trueaxis.measurement.readings_reader import LARGEST_READING
from trueaxis.measurement.setup import PointOn, Run, Vector
from trueaxis.measurement.setup_reader import LONGEST_BAR
from trueaxis.view import Carrier, Frame

PLANES = {"XY": ("X", "Y"), "YZ": ("Y", "Z"), "ZX": ("Z", "X")}
SLANTED = 1e-3  # by which the cosine of a direction along an axis may be less than 1
MOVING_OPTIC = "where the moving optic or sensor is, in the frame of {}, mm"


@dataclass(frozen=True, slots=True)
class ToolView:
    """at: the tool point in the workpiece frame at axis positions (n_axes, 1), for a point (3, 1) of the tool, mm;
    zero: dimensions that the spec names and nobody has given, which are taken as zero.
    """

    at: Callable[[FloatArray, FloatArray], FloatArray]
    zero: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class DataRun:
    """A run and its readings as a data folder has them.

    positions: (n_axes, n), mm or deg; directions: (n_axes, n), 0 where they follow from the order; reading: (n,), mm.
    assumed: what the file does not say, by key, with its value and why it has it; remarks: on the readings.
    """

    run: Run
    source: InstrumentRun
    positions: FloatArray
    directions: DirectionArray | None
    reading: FloatArray
    assumed: RunKeys
    remarks: tuple[str, ...]


def data_run(source: InstrumentRun, machine: Machine, keys: UserKeys, view: ToolView) -> DataRun | None:
    """The run; None where questions or faults, noted in `keys`, keep it open. view: for the place of a ball bar."""
    own = keys.of_run(source.file, source.id)
    before = len(keys.questions) + len(keys.faults)
    run_id = escaped(own.text("id", "its name", "X1", default=source.id) or "")[:LONGEST_ID].strip() or "run"
    instrument: Instrument | None = source.instrument
    if instrument == ANGLE:
        angles = in_angles(source, own)
        if angles is None:
            return None
        source = angles
    if instrument is None:
        among = ("laser", "probe")
        instrument = cast("Instrument | None", own.text("instrument", "", "laser", among=among, default="laser"))
    found = (_ball_bar if instrument == "ballbar" else _along)(source, machine, own, view, run_id, instrument)
    if found is None or len(keys.questions) + len(keys.faults) > before:
        return None
    _check(found, machine, own)
    return None if len(keys.faults) + len(keys.questions) > before else found


def _along(
    source: InstrumentRun, machine: Machine, own: RunKeys, _: ToolView, run_id: str, instrument: Instrument | None
) -> DataRun | None:
    """A run of a laser, a probe or an angle instrument."""
    axis = source.axis if source.axis in machine.axes else None
    if source.targets is not None and axis is None:
        right = machine.axes[0]
        axis = own.text("axis", f"which axis moved ({' '.join(machine.axes)})", right, among=machine.axes)
        if axis is None:  # of the rest, what is needed in any case
            if instrument != ANGLE:
                own.vector("target.point", MOVING_OPTIC.format("its carrier"), "X,Y,Z")
            return None
    positions = _positions(source, machine, own, axis)
    moved = [name for row, name in enumerate(machine.axes) if np.ptp(positions[row]) > 0.0]
    mover = axis or (moved[0] if len(moved) == 1 else None)
    side: Carrier = "tool" if mover is None or _carries_tool(machine, mover) else "workpiece"
    on = cast("Carrier | None", own.text("target", "", "tool", among=("tool", "workpiece"), default=side))
    frame_of = cast("Frame | None", own.text("frame", "", "bed", among=("bed", "workpiece"), default="bed"))
    angle = instrument == ANGLE
    backwards = on != side and own.said("reference") == side  # what stands still, seen from what moves
    direction = sensed(machine, own, mover, angle=angle, backwards=backwards)
    meaning = MOVING_OPTIC.format(f"the {on or side}")
    target = (0.0, 0.0, 0.0) if angle else own.vector("target.point", meaning, "X,Y,Z")  # all points turn alike
    reference = _reference(own, angle=angle)
    warm = _normalised(source, machine, own, positions, (mover, on, frame_of, direction))
    if warm is None:
        return None
    source, expansion, warmth = warm
    home, reading, remark = _home(source, machine, own, positions)
    if on is None or frame_of is None or direction is None or target is None or reference is None or reading is None:
        return None
    if on == frame_of == reference.on:
        own.wrong("frame", frame_of, "a frame in which the target moves")
        return None
    run = Run(
        id=run_id, instrument=instrument or "laser", target=PointOn(on, target), reference=reference,
        frame=frame_of, home=home, direction=direction, normalised=expansion,
    )  # fmt: skip
    row = None if mover is None else machine.axes.index(mover)
    directions = None if source.directions is None else directions_of(source.directions, positions, row)
    return DataRun(
        run=run, source=source, positions=positions, directions=directions, reading=reading,
        assumed=own, remarks=(*source.assumed, *warmth, *remark),
    )  # fmt: skip


def _ball_bar(
    source: InstrumentRun, machine: Machine, own: RunKeys, view: ToolView, run_id: str, _: Instrument | None
) -> DataRun | None:
    length = own.number("length", "the nominal length of the ball bar, mm", "150")
    if length is not None and not 0.0 < length <= LONGEST_BAR:
        own.wrong("length", repr(length), f"above 0, at most {LONGEST_BAR:g} mm")
        return None
    plane = None
    if source.angle is not None and not source.positions:
        planes = [name for name, axes in PLANES.items() if set(axes) <= set(machine.axes)]
        if not planes:
            own.wrong("plane", "", "positions of the axes: this machine has no two linear axes")
            return None
        plane = own.text("plane", f"the plane of the circle ({' '.join(planes)})", planes[0], among=planes)
    positions = _positions(source, machine, own, None, circle=plane)
    centre = positions[:, :1].copy()
    if plane is not None and length is not None and source.angle is not None:
        for axis, of in zip(PLANES[plane], (np.cos, np.sin), strict=True):
            positions[machine.axes.index(axis)] += length * of(source.angle)
    tool = own.vector("target.point", "where the ball on the tool is, in the frame of the tool, mm", "0,0,0")
    default: Vector | None = None
    if plane is not None and tool is not None and own.said("reference.point") is None:
        at = view.at(centre, np.array(tool)[:, np.newaxis])[:, 0]
        default = cast(Vector, tuple(float(round(value, 9)) for value in at))
    if tool is None or (plane is None and not source.positions):
        return None  # where the other ball is may follow from these
    meaning = "where the ball on the workpiece is, in the frame of the workpiece, mm"
    ball = own.vector("reference.point", meaning, "X,Y,Z", default=default)
    if length is None or ball is None:
        return None
    run = Run(
        id=run_id, instrument="ballbar", target=PointOn("tool", tool), reference=PointOn("workpiece", ball),
        frame="bed", home=dict.fromkeys(machine.axes, 0.0), length=length,
    )  # fmt: skip
    reading = source.reading - length if source.whole_length else source.reading
    remarks = source.assumed
    if own.sources.get("reference.point") == "default" and view.zero:
        remarks += (f"the ball stands there with {', '.join(view.zero)} of the spec taken as 0 (--known gives them)",)
    if plane is not None:
        first, second = PLANES[plane]
        remarks += (f"angles count from {first}+ to {second}+ in commanded positions",)
    return DataRun(
        run=run, source=source, positions=positions, directions=None, reading=reading,
        assumed=own, remarks=remarks,
    )  # fmt: skip


def _positions(
    source: InstrumentRun, machine: Machine, own: RunKeys, axis: str | None, circle: str | None = None
) -> FloatArray:
    """(n_axes, n): as the file and the user say; zero where a question is open. circle: the plane of a ball bar."""
    positions = np.zeros((len(machine.axes), source.reading.size))
    for row, name in enumerate(machine.axes):
        if name == axis and source.targets is not None:
            positions[row] = source.targets
        elif name in source.positions:
            positions[row] = source.positions[name]
        else:
            unit = "mm" if name in LINEAR else "deg"
            at = "at the centre of the circle" if circle and name in PLANES[circle] else "during the run"
            value = own.number(f"at.{name}", f"the position of axis {name} {at}, {unit}", "0")
            positions[row] = 0.0 if value is None else value
    for name in source.positions:
        if name not in machine.axes:
            problem = f"machine {machine.name} has no axis {name}"
            own.keys.faults.append(Fault(source.file, f"column {name}", problem, f"axes {' '.join(machine.axes)}"))
    return positions


def _carries_tool(machine: Machine, axis: str) -> bool:
    number = machine.tool
    while number != BED:
        body = machine.body(number)
        if body.moves == axis:
            return True
        number = body.lower
    return False


def _reference(own: RunKeys, *, angle: bool) -> PointOn | None:
    on = cast("Carrier | None", own.text("reference", "", "bed", among=("bed", "tool", "workpiece"), default="bed"))
    if on is None or on == "bed" or angle:
        return None if on is None else PointOn(on)
    point = own.vector("reference.point", f"where the resting optic is, in the frame of the {on}, mm", "X,Y,Z")
    return None if point is None else PointOn(on, point)


def _normalised(
    source: InstrumentRun,
    machine: Machine,
    own: RunKeys,
    positions: FloatArray,
    seen: tuple[str | None, Carrier | None, Frame | None, Vector | None],
) -> tuple[InstrumentRun, float | None, tuple[str, ...]] | None:
    """See `normalised`. seen: axis that moved, what carries the target, frame and direction of the run."""
    axis, on, frame, direction = seen
    if axis is None or axis not in LINEAR or source.instrument == ANGLE or on is None or direction is None:
        return source, None, ()
    row = machine.axes.index(axis)
    along = machine.mover(axis).sense * direction[LINEAR.index(axis)]
    if own.said(f"expansion.{axis}") is not None:
        carried = _carries_tool(machine, axis) == (on == "tool")
        if frame != "bed" or not carried or abs(along) < 1.0 - SLANTED or own.said("reference") not in (None, "bed"):
            right = "a run along the axis, of what the axis carries against the bed"
            own.wrong(f"expansion.{axis}", own.values[f"expansion.{axis}"], right)
            return None
    return normalised(source, own, axis, along * (positions[row] - positions[row, 0]))


def _home(
    source: InstrumentRun, machine: Machine, own: RunKeys, positions: FloatArray
) -> tuple[dict[str, float], FloatArray | None, tuple[str, ...]]:
    """Where the readings are zero, and the readings since then.

    Programs take the zero from where they like. If no reading at home is zero, the mean of those at home is taken off:
    its uncertainty is that of a reading by the root of their number.
    """
    home = {name: float(positions[row, 0]) for row, name in enumerate(machine.axes)}
    for name in machine.axes:
        value = own.number(f"home.{name}", "", "0", default=home[name])
        home[name] = home[name] if value is None else value
    at_home = np.all(positions == np.array([[home[name]] for name in machine.axes]), axis=0)
    readings = source.reading[at_home]
    default = "keep" if not readings.size or (readings == 0.0).any() else "mean"
    if own.said("zero") is None and any(own.sources.get(f"home.{name}") == "user" for name in machine.axes):
        default = "keep"
    zero = own.text("zero", "", "keep", among=("keep", "mean"), default=default)
    if zero == "mean" and not readings.size:
        own.wrong("zero", "mean", "keep: there is no reading at home")
        return home, None, ()
    if zero == "mean":
        off = float(readings.mean())
        unit = small_unit(source.instrument or "laser")
        said = f"the mean of the {readings.size} readings at home, {off * 1e3:.6g} {unit}, was taken off every reading"
        return home, source.reading - off, (said,)
    return home, None if zero is None else source.reading, ()


def _check(found: DataRun, machine: Machine, own: RunKeys) -> None:
    """Note what a data folder does not take."""
    source, run = found.source, found.run
    for row, axis in enumerate(machine.axes):
        low, high = machine.travel[axis]
        outside = found.positions[row][(found.positions[row] < low) | (found.positions[row] > high)]
        away = run.instrument != "ballbar" and not low <= run.home[axis] <= high  # no reading of a bar counts from home
        if outside.size or away:
            worst = outside[0] if outside.size else run.home[axis]
            problem = f"{axis} = {worst:.6g} is outside the travel"
            own.keys.faults.append(Fault(source.file, f"run {run.id}", problem, f"from {low!r} to {high!r}"))
    for point, key in ((run.target.point, "target.point"), (run.reference.point, "reference.point")):
        if max(map(abs, point)) > FARTHEST_POINT:
            own.wrong(key, str(list(point)), f"coordinates in mm, at most {FARTHEST_POINT:g}")
    largest = float(np.abs(found.reading).max(initial=0.0))
    if not largest <= LARGEST_READING:
        unit = unit_of_file(run.instrument)
        per_unit = ARM if unit == "rad" else 1.0
        problem = f"has a reading of {largest / per_unit:.6g} {unit}"
        remedy = f"deviations of at most {LARGEST_READING / per_unit:g} {unit}: unit.reading, length"
        own.keys.faults.append(Fault(source.file, f"run {run.id}", problem, remedy))
    for name, values, low, high in (
        ("time", source.time, -LONGEST_TIME, LONGEST_TIME),
        ("feed", source.feed, 0.0, FASTEST),
        ("temperature", source.temperature, COLDEST, WARMEST),
    ):
        wrong = np.zeros(0) if values is None else values[(values < low) | (values > high)]
        if wrong.size:
            problem = f"{name} {wrong[0]:.6g} is outside what can be"
            own.keys.faults.append(Fault(source.file, f"run {run.id}", problem, f"from {low:g} to {high:g}"))
