"""The frozen record of a machine: bodies, their lower bodies, and what may be wrong between them.

Positions that programs rely on and do not state are in its tables [start] and [reference_points].
"""

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import cached_property
from pathlib import Path

from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.library import BY_NAME
from trueaxis.error_name import Direction, ErrorName
from trueaxis.io.safe_text import html_table
from trueaxis.machine.fields import Fields
from trueaxis.machine.prior import Prior

AXES = ("X", "Y", "Z", "A", "B", "C")
LINEAR, ROTARY = AXES[:3], AXES[3:]
BED = 1
REFERENCE_CODES = ("G28", "G30")
Position = tuple[tuple[str, float], ...]  # (axis, mm or deg) pairs, in the order of the machine's axes


@dataclass(frozen=True, kw_only=True)
class Body:
    """One rigid body and its joint to its lower body (the four factors of Eq. 1 of the paper).

    moves: the axis letter, None for a body fixed to its lower body. travel: mm, or deg for a rotary axis.
    position: home position in the lower body's frame, each a number (mm) or the name of a parameter.
    motion_errors: ISO 230-1 names, in the order EX EY EZ EA EB EC. position_errors: (direction, parameter) pairs.
    """

    number: int
    name: str
    lower: int
    moves: str | None = None
    sense: int = 1
    travel: tuple[float, float] | None = None
    position: tuple[float | str, float | str, float | str] = (0.0, 0.0, 0.0)
    motion_errors: tuple[ErrorName, ...] = ()
    position_errors: tuple[tuple[Direction, str], ...] = ()


@dataclass(frozen=True, kw_only=True)
class Machine:
    """A machine as its spec tells it; every property has the one order that all generated code uses.

    curve_degree: highest power of the motion-error polynomials that the polynomial kernels are emitted for.
    true_rotation: whether error rotations are true rotations instead of the paper's matrix 1 + [epsilon x].
    runs: folder of the measuring plan whose identification systems are derived, relative to the spec; or None.
    references: pairs (equation label, where the literature has it), printed beside the equations.
    effects: terms beside the geometric errors, in the order of the spec; effect_kinds: the spec's own kinds.
    prior: sizes of errors to expect before measuring.
    start: axis positions before a program, for the axes named, mm and deg; reference_points: those to which G28 and G30
    go. source: the file that it was read from, None where it comes from none; it makes no other machine.
    """

    name: str
    title: str
    bodies: tuple[Body, ...]
    workpiece: int
    tool: int
    curve_degree: int = 7
    true_rotation: bool = False
    runs: str | None = None
    references: tuple[tuple[str, str], ...] = ()
    effects: tuple[Effect, ...] = ()
    effect_kinds: tuple[Kind, ...] = ()
    prior: Prior = field(default_factory=Prior)
    start: Position = ()
    reference_points: tuple[tuple[str, Position], ...] = ()
    source: Path | None = field(default=None, compare=False, repr=False)

    @cached_property
    def axes(self) -> tuple[str, ...]:
        """Axis letters, in the order X Y Z A B C."""
        moved = {body.moves for body in self.bodies}
        return tuple(axis for axis in AXES if axis in moved)

    @cached_property
    def components(self) -> tuple[ErrorName, ...]:
        """Motion-error components: axis by axis, EX EY EZ EA EB EC within each."""
        return tuple(name for axis in self.axes for name in self.mover(axis).motion_errors)

    @cached_property
    def dimensions(self) -> tuple[str, ...]:
        """Named home positions (mm), in the order of the spec: nominal geometry, not errors."""
        return tuple(p for body in self.bodies for p in body.position if isinstance(p, str))

    @cached_property
    def location_errors(self) -> tuple[str, ...]:
        """Named position errors (mm or rad), in the order of the spec."""
        return tuple(name for body in self.bodies for _, name in body.position_errors)

    @cached_property
    def parameters(self) -> tuple[str, ...]:
        """Every named parameter: dimensions, then location errors."""
        return self.dimensions + self.location_errors

    @cached_property
    def kinds(self) -> dict[str, Kind]:
        """Every kind of effect by its name: those of the library, then the machine's own."""
        return BY_NAME | {kind.name: kind for kind in self.effect_kinds}

    @cached_property
    def travel(self) -> dict[str, tuple[float, float]]:
        """Travel of each axis, mm or deg."""
        return {axis: self.mover(axis).travel or (0.0, 0.0) for axis in self.axes}

    def body(self, number: int) -> Body:
        """The body of that number."""
        return next(body for body in self.bodies if body.number == number)

    def mover(self, axis: str) -> Body:
        """The body that an axis moves."""
        return next(body for body in self.bodies if body.moves == axis)

    def location_direction(self, parameter: str) -> Direction:
        """EX .. EC: what a location error displaces or turns."""
        return next(d for body in self.bodies for d, name in body.position_errors if name == parameter)

    def parameter_unit(self, parameter: str) -> str:
        """`mm` or `rad`."""
        return self.location_direction(parameter).unit if parameter in self.location_errors else "mm"

    @cached_property
    def chain(self) -> str:
        """The axes from the workpiece by way of the bed to the tool, each with its sense: `-X -Y bed +Z`."""
        carriers = [self._carriers(end) for end in (self.workpiece, self.tool)]
        return " ".join([*carriers[0], "bed", *reversed(carriers[1])])

    def _carriers(self, number: int) -> list[str]:
        """Axes that carry a body, with their senses, the nearest first."""
        found = []
        while number != BED:
            body = self.body(number)
            if body.moves is not None:
                found.append(f"{'+' if body.sense > 0 else '-'}{body.moves}")
            number = body.lower
        return found

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the parsed spec: what it says, not how it is laid out.

        References are prose; sizes to expect, positions that programs rely on and the file change no kernel: left out.
        """
        said = asdict(self)
        for name in ("references", "prior", "start", "reference_points", "source"):
            del said[name]
        return hashlib.sha256(json.dumps(said, sort_keys=True).encode()).hexdigest()

    def __str__(self) -> str:
        """Its axes and how many errors it has."""
        axes = [f"{axis} {low:g} to {high:g}" for axis, (low, high) in self.travel.items()]
        count = f"{len(self.components)} error motions, {len(self.location_errors)} location errors"
        return f"{self.name}: {self.title}; {', '.join(axes)}; {count}"

    def _repr_html_(self) -> str:
        """The bodies, for a notebook."""
        rows = []
        for one in self.bodies:
            travel = None if one.travel is None else f"{one.travel[0]:g} to {one.travel[1]:g}"
            locations = ", ".join(name for _, name in one.position_errors)
            rows.append((one.number, one.name, one.lower, one.moves, travel, ", ".join(one.motion_errors), locations))
        head = ("body", "name", "lower", "moves", "travel, mm or deg", "motion errors", "location errors")
        return html_table(f"{self.name}: {self.title}", head, rows)


def read_start(top: Fields, travel: Mapping[str, tuple[float, float]]) -> Position:
    """[start]: axis positions before a program, mm and deg; axes that it does not name are taken at home."""
    return _position(top.table("start"), travel)


def read_reference_points(top: Fields, travel: Mapping[str, tuple[float, float]]) -> tuple[tuple[str, Position], ...]:
    """[reference_points]: machine positions to which G28 and G30 go, for the axes that are named."""
    fields = top.table("reference_points")
    points = tuple((code, _position(fields.table(code), travel)) for code in REFERENCE_CODES if code in fields.raw)
    fields.refuse_others(", ".join(REFERENCE_CODES))
    return points


def _position(fields: Fields, travel: Mapping[str, tuple[float, float]]) -> Position:
    values = [(axis, _within(fields, axis, travel[axis])) for axis in travel if axis in fields.raw]
    fields.refuse_others(_names(tuple(travel)))
    return tuple((axis, value) for axis, value in values if value is not None)


def _within(fields: Fields, axis: str, travel: tuple[float, float]) -> float | None:
    low, high = travel
    right = f"a position within the travel, from {low:g} to {high:g}"
    value = fields.number(axis, right)
    if value is not None and not low <= value <= high:
        fields.fault(axis, f"is {value:g}", right)
        return None
    return value


def _names(axes: Sequence[str]) -> str:
    return f"the axes of the machine: {' '.join(axes)}"
