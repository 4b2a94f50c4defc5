"""The runs of a set of measured data, as setup.toml describes them, and their text there."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field

from trueaxis.io.safe_text import escaped
from trueaxis.measurement.instrument_kinds import Instrument
from trueaxis.view import Carrier, Frame

Vector = tuple[float, float, float]
FILE_NAME = "setup.toml"
DECIMALS = 6  # of a unit vector, to which two of them are one


@dataclass(frozen=True, slots=True)
class PointOn:
    """A point fixed to a body; `point` in mm, in that body's frame."""

    on: Carrier
    point: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Device:
    """One instrument, by its ID; what is known of it, None where nothing is said.

    resolution, noise: step of its display and standard deviation of a reading, mm, of an angle instrument mm at ARM;
    length_u: standard uncertainty of the length of a ball bar, or of a probe along Z of the tool frame, mm; scale_u:
    relative standard uncertainty of a laser's scale; line_u: standard uncertainty of the direction of lines of
    straightness against the ideal axes of the machine, rad.
    """

    id: str
    serial: str = ""
    resolution: float | None = None
    noise: float | None = None
    length_u: float | None = None
    scale_u: float | None = None
    line_u: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Run:
    """One run: an instrument set up once and read at many axis positions.

    direction: unit vector of the sensed direction, in `frame`, of an angle instrument of the axis of the rotation that
    it reads (None for the ball bar);
    home: axis -> position (mm, deg) at which the reading was set to zero, every axis of the machine named;
    length: nominal length of the ball bar, mm (None for the others). A distance has neither frame nor zero
    point: `frame` and `home` say nothing about a ball-bar run. device: None where the file names none: all runs of one
    instrument are then of one device; normalised: coefficient by which the readings are normalised to 20 degC, 1e-6/K,
    None where nothing is said; session: from one set-up of the machine to the next, empty where nothing is said.
    """

    id: str
    instrument: Instrument
    target: PointOn
    reference: PointOn
    frame: Frame
    home: Mapping[str, float]
    direction: Vector | None = None
    length: float | None = None
    device: Device | None = None
    session: str = ""
    normalised: float | None = None

    @property
    def line(self) -> Vector | None:
        """The direction or its opposite: the same of runs that sense along one line, either way."""
        if self.direction is None:
            return None
        rounded = [round(part, DECIMALS) + 0.0 for part in self.direction]
        sign = next((1.0 if part > 0.0 else -1.0 for part in rounded if part), 1.0)
        x, y, z = (sign * part + 0.0 for part in rounded)
        return x, y, z


@dataclass(frozen=True, slots=True)
class CompensationKey:
    """What setup.toml says of the compensation that was active on the control while the readings were taken.

    file: error values that it worked with, relative to the folder of setup.toml; None: none was active; location: line
    and key in setup.toml, for faults.
    """

    file: str | None
    location: str


@dataclass(frozen=True, slots=True)
class Setup:
    """All runs of a set of measured data, in the order of the file.

    compensation: None where the file says nothing of it; report: free text about the measurement.
    """

    machine: str
    runs: tuple[Run, ...]
    compensation: CompensationKey | None = None
    report: Mapping[str, str] = field(default_factory=dict)


def run_table(run: Run, comments: Mapping[str, str] | None = None) -> str:
    """A [[run]] table that reads back as the run; its device is named alone.

    comments: key -> what stands behind its line.
    """
    lines = {"id": toml_text(run.id), "instrument": toml_text(run.instrument)}
    if run.device is not None:
        lines["device"] = toml_text(run.device.id)
    if run.session:
        lines["session"] = toml_text(run.session)
    if run.length is not None:
        lines["length"] = repr(run.length)
    if run.direction is not None:
        lines["direction"] = repr(list(run.direction))
        lines["frame"] = toml_text(run.frame)
    lines["target"] = _point(run.target)
    lines["reference"] = _point(run.reference)
    if run.length is None:
        lines["home"] = f"{{ {', '.join(f'{axis} = {value!r}' for axis, value in run.home.items())} }}"
    if run.normalised is not None:
        lines["normalised_ppm_k"] = repr(run.normalised)
    said = comments or {}
    return "[[run]]\n" + "".join(
        f"{key} = {value}" + (f"  # {escaped(said[key])}" if key in said else "") + "\n" for key, value in lines.items()
    )


def toml_text(text: str) -> str:
    """A text in the quotes of TOML, whatever is in it."""
    return json.dumps(escaped(text), ensure_ascii=False)


def _point(end: PointOn) -> str:
    if end.on == "bed":
        return '{ on = "bed" }'
    return f'{{ on = "{end.on}", point = {list(end.point)!r} }}'
