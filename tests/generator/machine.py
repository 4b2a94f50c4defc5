"""An independent exact machine: rigid bodies on one another, in extended precision, with nothing from the package.

Transforms are pairs (R, p) of extended-precision arrays; each body's transform to its lower body is, per pose,
ideal position, position error, ideal motion, motion error. Rotations by small errors are either the small-angle
matrices of the contract or true rotations (Rodrigues), to see how far apart the two are.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

Exact = Any  # arrays of numpy.longdouble
Rotations = Literal["small", "true"]
Function = Callable[[Exact], Exact]

LETTERS = {"X": 0, "Y": 1, "Z": 2, "A": 0, "B": 1, "C": 2}


def exact(values: Any) -> Exact:
    return np.asarray(values, dtype=np.longdouble)


@dataclass(frozen=True)
class Body:
    number: int
    lower: int
    moves: str | None = None
    sense: int = 1
    position: tuple[float | str, float | str, float | str] = (0.0, 0.0, 0.0)
    position_errors: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Generator:
    """bodies: listed by hand; motion_errors: component -> function of the axis position; frames: name -> body."""

    bodies: tuple[Body, ...]
    axes: tuple[str, ...]
    frames: Mapping[str, int]
    parameters: Mapping[str, float]
    motion_errors: Mapping[str, Function]
    rotations: Rotations = "small"

    def coordinates(self, body: str, frame: str, pose: Mapping[str, float], point: Any, actual: bool = True) -> Exact:
        """A point of a body in a frame, (3,)."""
        to_bed, place = self._to_bed(self.frames[body], pose, actual)
        at_bed = to_bed @ exact(point) + place
        frame_to_bed, origin = self._to_bed(self.frames[frame], pose, actual)
        return inverse3(frame_to_bed) @ (at_bed - origin)

    def deviation(self, body: str, frame: str, pose: Mapping[str, float], point: Any) -> Exact:
        actual = self.coordinates(body, frame, pose, point, actual=True)
        return actual - self.coordinates(body, frame, pose, point, actual=False)

    def _to_bed(self, number: int, pose: Mapping[str, float], actual: bool) -> tuple[Exact, Exact]:
        rotation, place = np.eye(3, dtype=np.longdouble), np.zeros(3, dtype=np.longdouble)
        while number != 1:
            body = next(body for body in self.bodies if body.number == number)
            for turn, shift in reversed(self._joint(body, pose, actual)):
                rotation, place = turn @ rotation, turn @ place + shift
            number = body.lower
        return rotation, place

    def _joint(self, body: Body, pose: Mapping[str, float], actual: bool) -> list[tuple[Exact, Exact]]:
        still, here = np.eye(3, dtype=np.longdouble), np.zeros(3, dtype=np.longdouble)
        position = exact([self.parameters.get(p, 0.0) if isinstance(p, str) else p for p in body.position])
        turn, shift = still, here
        if body.moves is not None and body.moves in "XYZ":
            shift = here.copy()
            shift[LETTERS[body.moves]] = exact(body.sense) * exact(pose[body.moves])
        elif body.moves is not None:
            vector = np.zeros(3, dtype=np.longdouble)
            vector[LETTERS[body.moves]] = exact(body.sense) * exact(pose[body.moves]) * exact(np.pi) / 180
            turn = rodrigues(vector)
        factors = [(still, position), (still, here), (turn, shift), (still, here)]
        if actual:
            located = {name: self.parameters.get(parameter, 0.0) for name, parameter in body.position_errors.items()}
            factors[1] = self._error(located)
            if body.moves is not None:
                at = exact(pose[body.moves])
                names = [f"E{direction}{body.moves}" for direction in "XYZABC"]
                found = {name[:2]: self.motion_errors[name](at) for name in names if name in self.motion_errors}
                factors[3] = self._error(found)
        return factors

    def _error(self, values: Mapping[str, Any]) -> tuple[Exact, Exact]:
        shift = exact([values.get(f"E{letter}", 0.0) for letter in "XYZ"])
        vector = exact([values.get(f"E{letter}", 0.0) for letter in "ABC"])
        if self.rotations == "true":
            return rodrigues(vector), shift
        return np.eye(3, dtype=np.longdouble) + cross_matrix(vector), shift


def cross_matrix(v: Exact) -> Exact:
    a, b, c = v
    return exact([[0, -c, b], [c, 0, -a], [-b, a, 0]])


def rodrigues(v: Exact) -> Exact:
    angle = np.sqrt(v @ v)
    if angle == 0:
        return np.eye(3, dtype=np.longdouble)
    k = cross_matrix(v / angle)
    return np.eye(3, dtype=np.longdouble) + np.sin(angle) * k + (1 - np.cos(angle)) * (k @ k)


def inverse3(m: Exact) -> Exact:
    """By cofactors: numpy has no extended-precision solver."""
    rows = [np.cross(m[1], m[2]), np.cross(m[2], m[0]), np.cross(m[0], m[1])]
    return np.array(rows).T / (m[0] @ rows[0])


def polynomial(**coefficients: float) -> Function:
    """polynomial(p1=1e-5, p3=2e-11): by plain powers, unlike Horner's scheme."""
    terms = [(int(name[1:]), exact(value)) for name, value in coefficients.items()]
    return lambda s: sum((value * exact(s) ** power for power, value in terms), start=exact(0.0))


def sine(amplitude: float, period: float, phase: float = 0.0) -> Function:
    """amplitude * (sin(2 pi s / period + phase) - sin(phase)): zero at home."""

    def value(s: Exact) -> Exact:
        return exact(amplitude) * (np.sin(2 * exact(np.pi) * exact(s) / period + phase) - np.sin(exact(phase)))

    return value
