"""The chain of a machine in numbers: 4x4 matrices in 40 digits, from the text of the spec and the contract alone.

Nothing of the package is used. An error that is not named in `values` is zero.
"""

import tomllib
from collections.abc import Mapping, Sequence
from typing import Any

import mpmath

Values = Mapping[str, Any]
DIGITS = mpmath.mp.clone()
DIGITS.dps = 40

_LETTERS = "XYZABC"


class ExactChain:
    def __init__(self, text: str) -> None:
        tree = tomllib.loads(text)
        self.bodies: dict[int, dict[str, Any]] = {body["number"]: body for body in tree["body"]}
        self.ends: dict[str, int] = tree["ends"] | {"bed": 1}
        self.error = rotated if tree.get("rotations") == "true" else small

    @property
    def axes(self) -> list[str]:
        moved = [body["moves"] for body in self.bodies.values() if "moves" in body]
        return sorted(moved, key=_LETTERS.index)

    @property
    def components(self) -> list[str]:
        found = []
        for axis in self.axes:
            body = next(body for body in self.bodies.values() if body.get("moves") == axis)
            listed = body.get("motion_errors", "all")
            names = [f"E{letter}{axis}" for letter in _LETTERS]
            found += names if listed == "all" else [name for name in names if name in listed]
        return found

    @property
    def dimensions(self) -> list[str]:
        return [p for body in self.bodies.values() for p in body.get("position", []) if isinstance(p, str)]

    @property
    def location_errors(self) -> list[str]:
        order = [f"E{letter}" for letter in _LETTERS]
        return [
            body["position_errors"][d]
            for body in self.bodies.values()
            for d in order
            if d in body.get("position_errors", {})
        ]

    def place(self, view: str, pose: Values, values: Values, point: Sequence[Any]) -> Any:
        """A point of one body in the frame of another, `tool_in_workpiece` and the like: (3,) of 40 digits."""
        return placed(self.matrix(view, pose, values), point)

    def matrix(self, view: str, pose: Values, values: Values) -> Any:
        """The 4x4 matrix from one frame to the other."""
        seen, frame = view.split("_in_")
        moved = self.to_bed(self.ends[seen], pose, values)
        return moved if frame == "bed" else self.to_bed(self.ends[frame], pose, values) ** -1 * moved

    def deviation(self, view: str, pose: Values, values: Values, point: Sequence[Any]) -> Any:
        return self.place(view, pose, values, point) - self.place(view, pose, self._without_errors(values), point)

    def direction_deviation(self, pose: Values, values: Values, vector: Sequence[Any]) -> Any:
        """A vector of the tool frame, such as the tool axis, in the workpiece frame: actual minus ideal."""
        nowhere = [0, 0, 0]
        view = "tool_in_workpiece"
        actual, ideal = (self.matrix(view, pose, each) for each in (values, self._without_errors(values)))
        moved, still = (placed(actual, point) - placed(ideal, point) for point in (vector, nowhere))
        return moved - still

    def _without_errors(self, values: Values) -> Values:
        errors = set(self.components) | set(self.location_errors)
        return {name: value for name, value in values.items() if name not in errors}

    def to_bed(self, number: int, pose: Values, values: Values) -> Any:
        result = DIGITS.eye(4)
        while number != 1:
            body = self.bodies[number]
            result = self._joint(body, pose, values) * result
            number = body["lower"]
        return result

    def _joint(self, body: dict[str, Any], pose: Values, values: Values) -> Any:
        home = [values.get(p, 0) if isinstance(p, str) else p for p in body.get("position", [0, 0, 0])]
        pairs = body.get("position_errors", {})
        located = [values.get(pairs.get(f"E{letter}", ""), 0) for letter in _LETTERS]
        result = translation(home)
        if any(located):
            result = result * self.error(located)
        axis = body.get("moves")
        if axis is None:
            return result
        way = body.get("sense", 1) * DIGITS.mpf(pose[axis])
        if axis in "XYZ":
            motion = translation([way if letter == axis else 0 for letter in "XYZ"])
        else:
            motion = turn(axis, way * DIGITS.pi / 180)
        listed = body.get("motion_errors", "all")
        names = [f"E{letter}{axis}" for letter in _LETTERS]
        errors = [values.get(name, 0) if listed == "all" or name in listed else 0 for name in names]
        return result * motion * self.error(errors) if any(errors) else result * motion


def placed(at: Any, point: Sequence[Any]) -> Any:
    """A point, (3,), put through a 4x4 matrix."""
    return (at * DIGITS.matrix([*point, 1]))[:3]


def translation(by: Sequence[Any]) -> Any:
    result = DIGITS.eye(4)
    for row in range(3):
        result[row, 3] = DIGITS.mpf(by[row])
    return result


def small(errors: Sequence[Any]) -> Any:
    """The contract's small rotation (EA, EB, EC) with the displacement (EX, EY, EZ)."""
    x, y, z, a, b, c = (DIGITS.mpf(value) for value in errors)
    return DIGITS.matrix([[1, -c, b, x], [c, 1, -a, y], [-b, a, 1, z], [0, 0, 0, 1]])


def rotated(errors: Sequence[Any]) -> Any:
    """A true rotation by the vector (EA, EB, EC), as the exponential of its matrix, with the displacement."""
    x, y, z, a, b, c = (DIGITS.mpf(value) for value in errors)
    result = DIGITS.eye(4)
    result[:3, :3] = DIGITS.expm(DIGITS.matrix([[0, -c, b], [c, 0, -a], [-b, a, 0]]), method="taylor")
    result[0, 3], result[1, 3], result[2, 3] = x, y, z
    return result


def turn(axis: str, angle: Any) -> Any:
    c, s = DIGITS.cos(angle), DIGITS.sin(angle)
    rows = {
        "A": [[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]],
        "B": [[c, 0, s, 0], [0, 1, 0, 0], [-s, 0, c, 0], [0, 0, 0, 1]],
        "C": [[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
    }
    return DIGITS.matrix(rows[axis])
