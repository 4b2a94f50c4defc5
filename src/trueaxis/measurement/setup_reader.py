"""setup.toml to Run records, with every fault at its line and key."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

from trueaxis.io.faults import Faults
from trueaxis.io.input_files import input_bytes, utf8_text
from trueaxis.io.toml_lines import complainer, key_lines, parse_toml, place
from trueaxis.machine.fields import Fields, shown
from trueaxis.measurement.devices import check_devices, check_label, read_devices
from trueaxis.measurement.instrument_kinds import ANGLE, INSTRUMENTS, Instrument
from trueaxis.measurement.limits import FARTHEST_POINT
from trueaxis.measurement.machine import MachineAxes
from trueaxis.measurement.setup import CompensationKey, Device, PointOn, Run, Setup, Vector
from trueaxis.view import Carrier, Frame

UNIT_TOLERANCE = 1e-6  # a unit vector written with seven digits or more is one
LONGEST_BAR = 1e4  # mm; beyond this the length is no length of a ball bar
NO_COMPENSATION = "none"
LARGEST_EXPANSION = 100.0  # 1e-6/K: four times that of aluminium

_CARRIERS = ("tool", "workpiece", "bed")


def read_setup(path: Path, machine: MachineAxes) -> Setup:
    """Read setup.toml of data measured on a machine.

    Raises InputError with every fault of the file.
    """
    text = utf8_text(path, input_bytes(path))
    faults = Faults(str(path))
    top = Fields(parse_toml(text, faults), (), complainer(text, faults))
    setup = replace(_setup(top, machine), compensation=_compensation(top, text))
    top.refuse_others()
    faults.raise_if_any()
    return setup


def _setup(top: Fields, machine: MachineAxes) -> Setup:
    schema = top.integer("schema")
    if schema not in (1, None):
        top.fault("schema", f"{schema} is not a schema that this version reads", "schema = 1")
    measured = top.text("machine")
    if measured not in (machine.name, None):
        top.fault("machine", f"{shown(measured)} is another machine", f'machine = "{machine.name}"')
    runs: list[Run] = []
    ids: set[str] = set()
    devices = read_devices(top)
    tables = tuple(top.tables("run", required=True))
    for fields in tables:
        run = _run(fields, machine, devices)
        if run.id in ids:
            fields.fault("id", f'"{run.id}" names another run already', "an id of its own for each run")
        ids |= {run.id} - {""}
        runs.append(run)
    _check_homes(tables, runs, machine)
    check_devices(top, devices, runs)
    return Setup(machine.name, tuple(runs), report=_report(top))


def _compensation(top: Fields, text: str) -> CompensationKey | None:
    """The key `compensation`; None where it is absent, or no text. text: of the file."""
    name = "compensation"
    file = top.text(name, default="")
    if not file:
        return None
    location = place((name,), key_lines(text))
    return CompensationKey(None if file == NO_COMPENSATION else file, location)


def _report(top: Fields) -> dict[str, str]:
    """The table [report]: free text under free keys."""
    table = top.table("report")
    for key, value in table.raw.items():
        if not isinstance(value, str):
            table.fault(key, f"is {shown(value)}", "a text in quotes")
    return {key: value for key, value in table.raw.items() if isinstance(value, str)}


def _run(fields: Fields, machine: MachineAxes, devices: Mapping[str, Device]) -> Run:
    """The run of one table; what is wrong in it has been complained of and is filled with something harmless."""
    instrument = fields.choice("instrument", INSTRUMENTS)
    if "instrument" not in fields.raw:
        fields.fault("instrument", "is missing", f"one of {' '.join(INSTRUMENTS)}")
    ballbar = instrument == "ballbar"
    frame = cast(Frame, fields.choice("frame", ("bed", "workpiece")) or "bed")
    placed = instrument != ANGLE
    target = _point_on(fields, "target", ("tool", "workpiece"), placed=placed)
    if ballbar or "reference" in fields.raw:
        reference = _point_on(fields, "reference", _CARRIERS, placed=placed)
    else:
        fields.known.add("reference")
        reference = PointOn("bed")
    if target is not None and reference is not None:
        _check_carriers(fields, instrument, frame, target, reference)
    run = Run(
        id=_id(fields),
        instrument=cast(Instrument, instrument or "laser"),
        target=target or PointOn("tool"),
        reference=reference or PointOn("bed"),
        frame=frame,
        home=_home(fields, machine),
        direction=_direction(fields, instrument),
        length=_length(fields, instrument),
        device=_device(fields, devices),
        session=_label(fields, "session"),
        normalised=_normalised(fields),
    )
    fields.refuse_others()
    return run


def _check_carriers(fields: Fields, instrument: str | None, frame: Frame, target: PointOn, reference: PointOn) -> None:
    ballbar, angle = instrument == "ballbar", instrument == ANGLE
    if ballbar and target.on == reference.on:
        problem = f"both balls are on the {target.on}"
        fields.fault("reference", problem, "two bodies that move against each other")
    if not ballbar and target.on == frame == reference.on:
        problem = f"target and reference both rest in the {frame} frame: nothing is sensed"
        fields.fault("target", problem, "one of them on a body that moves in that frame")
    if angle and target.on == reference.on:
        problem = f"target and reference are both on the {target.on}, which does not turn against itself"
        fields.fault("reference", problem, "another body")


def _id(fields: Fields) -> str:
    run_id = fields.text("id") or ""
    check_label(fields, "id", run_id)
    return run_id


def _label(fields: Fields, key: str) -> str:
    """A name that may be absent."""
    label = fields.text(key, default="") or ""
    check_label(fields, key, label)
    return label


def _device(fields: Fields, devices: Mapping[str, Device]) -> Device | None:
    name = _label(fields, "device")
    return devices.get(name, Device(id=name)) if name else None


def _normalised(fields: Fields) -> float | None:
    """Coefficient of expansion by which the readings are normalised, 1e-6/K; None where nothing is said."""
    key = "normalised_ppm_k"
    if key not in fields.raw:
        fields.known.add(key)
        return None
    right = f"a coefficient of expansion in 1e-6/K, from 0 to {LARGEST_EXPANSION:g}"
    value = fields.number(key, right)
    if value is not None and not 0.0 <= value <= LARGEST_EXPANSION:
        fields.fault(key, f"is {value:g}", right)
        return None
    return value


def _direction(fields: Fields, instrument: str | None) -> Vector | None:
    if instrument == "ballbar":
        if "direction" in fields.raw:
            fields.fault("direction", "a ball bar senses along itself", "no direction")
        fields.known.add("direction")
        return None
    vector = fields.numbers("direction", 3, required=instrument is not None)
    if vector is None:
        return None
    norm = math.hypot(*vector)
    if abs(norm - 1.0) > UNIT_TOLERANCE:
        unit = [component / norm for component in vector] if 0.0 < norm < math.inf else "a unit vector"
        fields.fault("direction", f"has length {norm:.9g} where a unit vector has 1", f"{unit}")
    return cast(Vector, vector)


def _length(fields: Fields, instrument: str | None) -> float | None:
    given = fields.raw.get("length")
    fields.known.add("length")
    right = "the nominal length of the ball bar, mm"
    if instrument != "ballbar":
        if given is not None and instrument is not None:
            fields.fault("length", f"{'an' if instrument == ANGLE else 'a'} {instrument} has no length", "no length")
        return None
    if given is None:
        fields.fault("length", "is missing", right)
        return None
    length = fields.finite(given)
    if length is None or not 0.0 < length <= LONGEST_BAR:
        fields.fault("length", f"is {shown(given)}", right)
    return length


def _home(fields: Fields, machine: MachineAxes) -> dict[str, float]:
    home = dict.fromkeys(machine.axes, 0.0)
    table = fields.table("home")
    for axis, given in table.raw.items():
        if axis not in machine.axes:
            table.fault(axis, f"machine {machine.name} has no axis {axis}", f"axes {' '.join(machine.axes)}")
            continue
        position = table.finite(given)
        if position is None:
            table.fault(axis, f"is {shown(given)}", "a finite number")
        else:
            home[axis] = position
    return home


def _check_homes(tables: Sequence[Fields], runs: Sequence[Run], machine: MachineAxes) -> None:
    """Note homes outside the travel: of each axis the first, and how many more."""
    for axis, (low, high) in machine.travel.items():
        given = [(fields, run.home[axis]) for fields, run in zip(tables, runs, strict=True) if _says(fields, axis)]
        outside = [(fields, at) for fields, at in given if not low <= at <= high]
        if outside:
            fields, at = outside[0]
            also = f", and so in {len(outside) - 1} more runs" if len(outside) > 1 else ""
            fields.table("home").fault(axis, f"{at!r} is outside the travel{also}", f"from {low!r} to {high!r}")


def _says(fields: Fields, axis: str) -> bool:
    """Whether a run says where an axis is at home: zero, where it does not, may be outside the travel."""
    home = fields.raw.get("home")
    return isinstance(home, dict) and axis in home


def _point_on(fields: Fields, key: str, carriers: tuple[str, ...], *, placed: bool = True) -> PointOn | None:
    """The point under a key that must be there; None after a complaint. placed: whether it matters where it is."""
    right = f"{{ on = one of {' '.join(carriers)}{', point = [x, y, z]' if placed else ''} }}"
    if not isinstance(fields.raw.get(key), dict):
        fields.known.add(key)
        problem = f"is {shown(fields.raw[key])}" if key in fields.raw else "is missing"
        fields.fault(key, problem, right)
        return None
    table = fields.table(key)
    carrier = table.choice("on", carriers)
    if "on" not in table.raw:
        table.fault("on", "is missing", f"one of {' '.join(carriers)}")
    point: Any = table.numbers("point", 3, required=placed and carrier not in ("bed", None))
    if point is not None and max(map(abs, point)) > FARTHEST_POINT:
        table.fault("point", f"is {shown(list(point))}", f"coordinates in mm, at most {FARTHEST_POINT:g}")
    table.refuse_others("on, point")
    if carrier is None or (placed and point is None and carrier != "bed"):
        return None
    return PointOn(cast(Carrier, carrier), point or (0.0, 0.0, 0.0))
