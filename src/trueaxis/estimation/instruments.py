"""What nobody knows of an instrument and its set-up, as unknowns beside those of the machine.

Of one run (own):
  zero     what the reading was when it was set to zero; of a straightness run the offset of its reference line
  drift    what the reading creeps by over the run
           (of an angle instrument zero and drift are angles)
  slope    of the reference line of a straightness run, unless its device's table states how it is aligned
  centre   of a ball bar's ball on the workpiece, beyond what its runs share: it may have been set up anew
Of several runs (shared):
  centre   of the ball of one set-up of a ball bar; of a probed sphere
  length   of a ball bar of one nominal length
  scale    of a laser: wavelength, air
  cosine   of one alignment of a laser: it reads short by half the square of its angle
  turn     of what a probe probes over a way: a plate or a straightedge is aligned by eye or by the machine itself
  stylus   of a probe: its tip, along Z of the tool frame
Every unknown belongs to a class, whose size is estimated about the one given here: where runs were set up anew, or a
scale was calibrated, is then found out.
"""

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.estimation.set_up import (
    ball_columns,
    ball_of,
    carried,
    is_straightness,
    relative_motion,
    tip_of,
)
from trueaxis.estimation.set_up_anew import Taken, set_ups
from trueaxis.measurement.instrument_kinds import ANGLE, ARM, AT_REST
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_effects import along
from trueaxis.measurement.reading_geometry import along_line
from trueaxis.measurement.reading_model import home_positions, sensed_directions
from trueaxis.measurement.setup import Run

# By what the size of a class may be larger or smaller, one standard deviation. Set-ups differ by orders of magnitude,
# and many runs tell; a laser is calibrated and aligned as its makers say, and one value tells nothing of a size; what a
# device's table states is in no need of correction. The length of a bar is one value, too: a size that was estimated
# from it made the bar a standard of length, which the scale of the laser then had to follow (of ten worlds from 4001 on
# one was 1.5 times as far off, and covered 78 % in place of 97 %; the others hardly changed).
SET_UP_FACTOR, CALIBRATED_FACTOR, STATED_FACTOR = 10.0, 2.0, 1.1
TOOL_AXIS = 2  # Z of the tool frame, along which a stylus is long: ISO 841 has it point from the tool to its holder
Unit = Literal["mm", "rad", "1"]  # 1: of the length that is read
BALL_OF_RUN = "ballbar centre of a run"
PROBE_LENGTH = "probe length"  # where nobody states how well it is known
STATED_STYLUS = "stated stylus"
STYLUSES = (PROBE_LENGTH, STATED_STYLUS)


@dataclass(frozen=True, slots=True, kw_only=True)
class UnknownClass:
    """A class of unknowns of instruments. size: one standard deviation in its unit, before the data have their say;
    factor: by what the size may be wrong, one standard deviation; of_point: three unknowns, along or about x, y and z,
    that belong to a point of the set-up; zero, drift: whether it is what the readings of a run are counted from, or
    what they creep by over the run.
    """

    name: str
    unit: Unit
    size: float
    factor: float = SET_UP_FACTOR
    of_point: bool = False
    zero: bool = False
    drift: bool = False


CLASSES: Mapping[str, UnknownClass] = {
    one.name: one
    for one in (
        # of single runs
        UnknownClass(name="laser zero", unit="mm", size=3e-3, zero=True),
        UnknownClass(name="laser drift", unit="mm", size=1e-3, drift=True),
        UnknownClass(name="straightness zero", unit="mm", size=0.1, zero=True),
        UnknownClass(name="straightness slope", unit="rad", size=50e-6),
        UnknownClass(name="straightness drift", unit="mm", size=1e-3, drift=True),
        UnknownClass(name="probe zero", unit="mm", size=3e-3, zero=True),
        UnknownClass(name="probe drift", unit="mm", size=1e-3, drift=True),
        # an autocollimator or a level is read where it stands; optics are set to zero, and creep by air and bench
        UnknownClass(name="angle zero", unit="rad", size=3e-6, zero=True),
        UnknownClass(name="angle drift", unit="rad", size=1e-6, drift=True),
        UnknownClass(name="displacement zero", unit="mm", size=3e-3, zero=True),
        UnknownClass(name="displacement drift", unit="mm", size=0.5e-3, drift=True),
        UnknownClass(name="ballbar zero", unit="mm", size=2e-3, zero=True),
        UnknownClass(name="ballbar drift", unit="mm", size=1e-3, drift=True),
        UnknownClass(name=BALL_OF_RUN, unit="mm", size=2e-3, of_point=True),
        # of several runs
        UnknownClass(name="ballbar centre", unit="mm", size=50e-3, of_point=True),
        UnknownClass(name="ballbar length", unit="mm", size=20e-3, factor=CALIBRATED_FACTOR),
        UnknownClass(name="laser scale", unit="1", size=1e-6, factor=CALIBRATED_FACTOR),
        UnknownClass(name="laser cosine", unit="1", size=0.5e-6, factor=CALIBRATED_FACTOR),
        # a stylus is measured on a presetter or on a gauge, whose own place is known to some hundredths
        UnknownClass(name=PROBE_LENGTH, unit="mm", size=20e-3, factor=CALIBRATED_FACTOR),
        UnknownClass(name="probe sphere", unit="mm", size=50e-3, of_point=True),
        UnknownClass(name="probe origin", unit="mm", size=50e-3, of_point=True),
        UnknownClass(name="probe alignment", unit="rad", size=1e-3, of_point=True),
        UnknownClass(name="stated length", unit="mm", size=1.0, factor=STATED_FACTOR),
        UnknownClass(name=STATED_STYLUS, unit="mm", size=1.0, factor=STATED_FACTOR),
        UnknownClass(name="stated scale", unit="1", size=1.0, factor=STATED_FACTOR),
        UnknownClass(name="stated slope", unit="rad", size=1.0, factor=STATED_FACTOR),
    )
}


@dataclass(frozen=True, slots=True, kw_only=True)
class SharedUnknown:
    """An unknown of several runs. of: what tells it from others of its class; coordinate: of a centre, else 0; runs:
    indices; size: one standard deviation, mm or 1, of its class or as the device's table states it.
    """

    kind: str
    of: Hashable
    runs: tuple[int, ...]
    coordinate: int = 0
    size: float = 1.0

    @property
    def unknown_class(self) -> UnknownClass:
        """Which it belongs to."""
        return CLASSES[self.kind]

    @property
    def label(self) -> str:
        """`ballbar centre z`, `laser scale`."""
        return f"{self.kind} {'xyz'[self.coordinate]}" if self.unknown_class.of_point else self.kind


def own_kinds(run: Run, straightness: bool) -> tuple[str, ...]:
    """Classes of the unknowns of a run, in the order of the columns of `own_columns`."""
    if run.instrument == "ballbar":
        return ("ballbar zero", "ballbar drift", *([BALL_OF_RUN] * 3))
    if straightness:
        of_line = ("straightness zero", "straightness drift")
        return of_line if states_line(run) else (*of_line, "straightness slope")
    return (f"{run.instrument} zero", f"{run.instrument} drift")


def own_columns(
    machine: IdentifiedMachine, run: Run, straightness: bool, positions: FloatArray, passed: FloatArray
) -> FloatArray:
    """(n, k): derivative of the readings by each of `own_kinds`, per mm or rad; passed: (n,), share of the run."""
    per_unit = ARM if run.instrument == ANGLE else 1.0  # mm of reading per mm, or per rad of an angle
    columns = [np.full(positions.shape[1], per_unit), per_unit * (passed - 0.5)]
    if run.instrument == "ballbar":
        columns += list(ball_columns(machine, run, positions).T)
    elif straightness and not states_line(run):
        columns.append(along_line(relative_motion(machine, run, positions)))
    return np.stack(columns, axis=1)


def shared_unknowns(runs: Sequence[Run], taken: Sequence[Taken], straightness: Sequence[bool]) -> list[SharedUnknown]:
    """All unknowns that runs share, in a fixed order. taken: the runs with readings, as they were taken."""
    set_up = set_ups(runs, taken)
    members: dict[tuple[str, Hashable, int], list[int]] = {}
    for index in sorted(one.index for one in taken):
        run = runs[index]
        if run.instrument == "ballbar":
            ball = (run.session, set_up[index], ball_of(run)[1])
            keys: list[tuple[str, Hashable, int]] = [("ballbar centre", ball, k) for k in range(3)]
            length = "ballbar length" if run.device is None or run.device.length_u is None else "stated length"
            keys.append((length, (run.session, run.device, run.length), 0))
        elif run.instrument == "probe":
            plate = (run.session, run.target, run.reference, run.frame)
            keys = [(kind, plate, k) for kind in ("probe origin", "probe alignment") for k in range(3)]
            sphere = ball_of(run)[1]
            if sphere.on not in (run.frame, "bed"):
                keys += [("probe sphere", (run.session, sphere), k) for k in range(3)]
            if tip_of(run) is not None:
                keys.append((_stylus(run), (run.session, run.device, tip_of(run)), 0))
        elif straightness[index]:
            keys = [("stated slope", index, 0)] if states_line(run) else []
        elif run.instrument in (ANGLE, AT_REST):
            keys = []  # an angle has no length that a scale could be off by, a sensor at rest hardly any
        else:
            scale = "laser scale" if run.device is None or run.device.scale_u is None else "stated scale"
            keys = [(scale, (run.session, run.device), 0)]
            line = (run.session, run.device, set_up[index], run.target, run.reference, run.direction)
            keys.append(("laser cosine", line, 0))
        for key in keys:
            members.setdefault(key, []).append(index)
    return [
        SharedUnknown(kind=kind, of=of, runs=tuple(of_runs), coordinate=k, size=_shared_size(kind, runs[of_runs[0]]))
        for (kind, of, k), of_runs in members.items()
    ]


def _stylus(run: Run) -> str:
    return PROBE_LENGTH if run.device is None or run.device.length_u is None else STATED_STYLUS


def states_line(run: Run) -> bool:
    """Whether it is known how a line of straightness is aligned."""
    return run.device is not None and run.device.line_u is not None


def _shared_size(kind: str, run: Run) -> float:
    known = run.device
    if known is None:
        return CLASSES[kind].size
    length, scale, slope = known.length_u, known.scale_u, known.line_u
    stated = {"stated length": length, STATED_STYLUS: length, "stated scale": scale, "stated slope": slope}
    size = stated.get(kind)
    return CLASSES[kind].size if size is None else size


def shared_column(machine: IdentifiedMachine, run: Run, unknown: SharedUnknown, positions: FloatArray) -> FloatArray:
    """(n,): derivative of the readings of a run by a shared unknown, per mm or per 1."""
    if unknown.unknown_class.unit == "1" or unknown.kind == "stated slope":
        line = unknown.kind == "stated slope"
        return along_line(relative_motion(machine, run, positions)) if line else along(machine, run, positions)
    if unknown.kind in ("ballbar length", "stated length"):
        return np.ones(positions.shape[1])
    if unknown.kind == "ballbar centre":
        return np.asarray(ball_columns(machine, run, positions)[:, unknown.coordinate])
    direction = sensed_directions(machine, run, positions)
    if unknown.kind == "probe origin":
        return np.asarray(direction[unknown.coordinate])
    if unknown.kind == "probe alignment":
        turned = np.cross(np.eye(3)[unknown.coordinate], relative_motion(machine, run, positions).T)
        return np.asarray(np.einsum("in,ni->n", direction, turned))
    sign, point = ball_of(run)
    coordinate, tip = unknown.coordinate, tip_of(run)
    if unknown.kind in STYLUSES and tip is not None:
        point, coordinate = tip, TOOL_AXIS  # it has the other sign than the ball, and a longer one ends at a lower Z
    turned = carried(machine, run, point, coordinate, positions)
    home = home_positions(run, machine.axes)
    if home is not None:
        turned = turned - carried(machine, run, point, coordinate, home)
    return np.asarray(sign * np.einsum("in,in->n", direction, turned))


def straight_runs(
    machine: IdentifiedMachine, runs: Sequence[Run], run: np.ndarray, positions: FloatArray
) -> list[bool]:
    """Of every run, whether it is one of straightness."""
    return [is_straightness(machine, one, positions[:, run == index]) for index, one in enumerate(runs)]
