"""An exact machine on arrays: rigid bodies on one another, true rotations, and the spec that says the same."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

Array = NDArray[np.float64]

LETTERS = "XYZABC"
BED = 1
Factor = tuple[Rotation | None, Array]  # None: no rotation


@dataclass(frozen=True)
class Joint:
    """A body and how it sits on its lower body; located: direction such as EC -> name of the position error."""

    number: int
    lower: int
    name: str
    moves: str = ""
    travel: tuple[float, float] = (0.0, 0.0)
    position: tuple[str, str, str] | None = None
    located: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Machine:
    """dimensions: name -> mm, known to the model; located errors and motion errors are given with every call."""

    name: str
    joints: tuple[Joint, ...]
    workpiece: int
    tool: int
    dimensions: Mapping[str, float]

    @cached_property
    def axes(self) -> tuple[str, ...]:
        return tuple(letter for letter in LETTERS if any(joint.moves == letter for joint in self.joints))

    @property
    def linear(self) -> tuple[str, ...]:
        return tuple(axis for axis in self.axes if axis in "XYZ")

    @cached_property
    def travel(self) -> dict[str, tuple[float, float]]:
        return {axis: self.mover(axis).travel for axis in self.axes}

    @cached_property
    def components(self) -> tuple[str, ...]:
        return tuple(f"E{letter}{axis}" for axis in self.axes for letter in LETTERS)

    @property
    def location_errors(self) -> tuple[str, ...]:
        return tuple(name for joint in self.joints for name in joint.located.values())

    def mover(self, axis: str) -> Joint:
        return next(joint for joint in self.joints if joint.moves == axis)

    def carries_workpiece(self, axis: str) -> bool:
        return self.mover(axis).number in self._branch(self.workpiece)

    def share(self, axis: str, position: Array) -> Array:
        """Position as a share of the travel."""
        low, high = self.travel[axis]
        return (position - low) / (high - low)

    def coordinates(
        self,
        view: tuple[str, str],
        positions: Mapping[str, Array],
        point: Array,
        errors: Mapping[str, Array] | None = None,
        located: Mapping[str, float] | None = None,
    ) -> Array:
        """A point of one body in the frame of another, (3, n), mm.

        view: (body, frame) of bed, workpiece, tool; positions: axis -> (n,), mm or deg; point: (3,) or (3, n); errors:
        component -> (n,); located: EC0X and the like -> rad or mm. Nothing given: the ideal machine.
        """
        count = len(next(iter(positions.values())))
        ends = {"bed": BED, "workpiece": self.workpiece, "tool": self.tool}
        start = np.array(np.broadcast_to(np.asarray(point, float).reshape(3, -1).T, (count, 3)))
        at_bed = self._to_bed(ends[view[0]], positions, start, errors or {}, located or {})
        return self._from_bed(ends[view[1]], positions, at_bed, errors or {}, located or {}).T

    def _to_bed(
        self,
        number: int,
        positions: Mapping[str, Array],
        at: Array,
        errors: Mapping[str, Array],
        located: Mapping[str, float],
    ) -> Array:
        for body in self._branch(number):
            for turn, shift in reversed(self._factors(body, positions, errors, located)):
                at = (at if turn is None else turn.apply(at)) + shift
        return at

    def _from_bed(
        self,
        number: int,
        positions: Mapping[str, Array],
        at: Array,
        errors: Mapping[str, Array],
        located: Mapping[str, float],
    ) -> Array:
        for body in reversed(self._branch(number)):
            for turn, shift in self._factors(body, positions, errors, located):
                at = at - shift if turn is None else turn.inv().apply(at - shift)
        return at

    def _branch(self, number: int) -> list[int]:
        found = []
        while number != BED:
            found.append(number)
            number = next(joint.lower for joint in self.joints if joint.number == number)
        return found

    def _factors(
        self, number: int, positions: Mapping[str, Array], errors: Mapping[str, Array], located: Mapping[str, float]
    ) -> list[Factor]:
        """Ideal position, position error, ideal motion, motion error."""
        joint = next(joint for joint in self.joints if joint.number == number)
        place = np.array([self.dimensions[name] for name in joint.position or ()] or [0.0, 0.0, 0.0])
        axis = joint.moves
        factors: list[Factor] = [(None, place), _small({d: located.get(f"{d}0{axis}", 0.0) for d in _DIRECTIONS})]
        if not axis:
            return factors[:1]
        way = np.zeros((len(positions[axis]), 3))
        way[:, LETTERS.index(axis) % 3] = positions[axis]
        turned = axis in "ABC"
        motion: Factor = (Rotation.from_rotvec(way, degrees=True), np.zeros(3)) if turned else (None, way)
        return [*factors, motion, _small({d: errors.get(f"{d}{axis}", 0.0) for d in _DIRECTIONS})]

    def spec(self, leave_out: tuple[str, ...] = ()) -> str:
        """The text of machine.toml; leave_out: names of located errors that the model is not to know."""
        lines = ["schema = 1", f'name = "{self.name}"', f'title = "{self.name}"']
        for joint in self.joints:
            lines += ["", "[[body]]", f"number = {joint.number}", f'name = "{joint.name}"', f"lower = {joint.lower}"]
            if joint.moves:
                travel = ", ".join(repr(end) for end in joint.travel)
                lines += [f'moves = "{joint.moves}"', f"travel = [{travel}]", 'motion_errors = "all"']
            if joint.position:
                lines.append("position = [" + ", ".join(f'"{name}"' for name in joint.position) + "]")
            kept = {d: name for d, name in joint.located.items() if name not in leave_out}
            if kept:
                lines.append("position_errors = { " + ", ".join(f'{d} = "{name}"' for d, name in kept.items()) + " }")
        return "\n".join([*lines, "", "[ends]", f"workpiece = {self.workpiece}", f"tool = {self.tool}", ""])


_DIRECTIONS = tuple(f"E{letter}" for letter in LETTERS)


def _small(values: Mapping[str, Array | float]) -> Factor:
    """A true rotation by the vector of the three angles, and a shift."""
    columns = np.broadcast_arrays(*(np.asarray(values[d], float) for d in _DIRECTIONS))
    both = np.stack(columns, axis=-1)
    return Rotation.from_rotvec(both[..., 3:]) if both[..., 3:].any() else None, both[..., :3]
