"""A machine in numbers from the [[body]] tables of a spec: 4x4 matrices, first order by a complex step.

Nothing of the package is used. With errors times 1e-30 i the imaginary part of any product is its first order.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[Any]
Values = Mapping[str, Any]
STEP = 1e-30j
_SIX = ("EX", "EY", "EZ", "EA", "EB", "EC")


def _error(six: list[Any]) -> Matrix:
    x, y, z, a, b, c = np.broadcast_arrays(*six)
    one, none = np.ones_like(x), np.zeros_like(x)
    rows = ((one, -c, b, x), (c, one, -a, y), (-b, a, one, z), (none, none, none, one))
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def _motion(axis: str, at: float) -> Matrix:
    result = np.eye(4, dtype=complex)
    if axis in "XYZ":
        result["XYZ".index(axis), 3] = at
        return result
    c, s = np.cos(np.pi * at / 180), np.sin(np.pi * at / 180)
    i, j = {"A": (1, 2), "B": (2, 0), "C": (0, 1)}[axis]
    result[i, i] = result[j, j] = c
    result[i, j], result[j, i] = -s, s
    return result


class NumericChain:
    """values: axis positions (x .. c), dimensions, errors by their names, all real; errors may be arrays of one shape,
    which stands in front of the matrices' then.
    """

    def __init__(self, tree: Mapping[str, Any]) -> None:
        self.bodies = {body["number"]: body for body in tree["body"]}
        self.ends = {"bed": 1} | tree["ends"]
        self.axes = sorted({b["moves"] for b in self.bodies.values() if "moves" in b}, key="XYZABC".index)
        self.components = [f"{d}{axis}" for axis in self.axes for d in _SIX]
        self.dimensions = [q for b in self.bodies.values() for q in b.get("position", []) if isinstance(q, str)]
        self.located = [n for b in self.bodies.values() for n in b.get("position_errors", {}).values()]

    def drawn(self, seed: int) -> dict[str, float]:
        """Random values of everything, none near 0."""
        rng = np.random.default_rng(seed)
        names = [*(axis.lower() for axis in self.axes), *self.dimensions, *self.components, *self.located]
        return {name: float(v) for name, v in zip(names, rng.uniform(0.3, 1.7, len(names)), strict=True)}

    def branch(self, end: int) -> list[int]:
        """Bodies from the one on the bed to this."""
        found: list[int] = []
        while end != 1:
            found.insert(0, end)
            end = self.bodies[end]["lower"]
        return found

    def factors(self, number: int, values: Values, size: complex) -> dict[str, Matrix]:
        """The four factors of a joint by p, pe, s, se; errors times `size`."""
        body = self.bodies[number]
        position = np.eye(4, dtype=complex)
        position[:3, 3] = [values[q] if isinstance(q, str) else q for q in body.get("position", (0, 0, 0))]
        located = body.get("position_errors", {})
        axis = body.get("moves", "")
        moved = [size * values[f"{d}{axis}"] if axis else 0 for d in _SIX]
        return {
            "p": position,
            "pe": _error([size * values[located[d]] if d in located else 0 for d in _SIX]),
            "s": _motion(axis, body.get("sense", 1) * values[axis.lower()]) if axis else np.eye(4),
            "se": _error(moved),
        }

    def to_bed(self, end: int, values: Values, size: complex) -> Matrix:
        """[SB end]."""
        result = np.eye(4, dtype=complex)
        for number in self.branch(end):
            for matrix in self.factors(number, values, size).values():
                result = result @ matrix
        return result

    def pair(self, end: int, values: Values) -> tuple[Matrix, Matrix]:
        """[SB end] without errors, and its first order."""
        stepped = self.to_bed(end, values, STEP)
        return stepped.real, stepped.imag / STEP.imag

    def seen(self, values: Values, point: Matrix) -> tuple[Matrix, Matrix]:
        """A tool point in the workpiece frame: ideal, and deviation to first order; (4,)."""
        work, tool = (self.to_bed(self.ends[end], values, STEP) for end in ("workpiece", "tool"))
        at = np.linalg.solve(work, tool @ point)
        return at.real, at.imag / STEP.imag

    def displacement(self, moves: str, ends: Mapping[str, Matrix], values: Values) -> tuple[Matrix, Matrix]:
        """Motion equation: signed sum of points (workpiece +, tool - where both) since home, ideal and first order."""
        still = {a.lower(): 0.0 for a in self.axes if a not in moves}
        calm = {n: 0.0 for n in self.components if n[2] not in moves}
        home = {a.lower(): 0.0 for a in self.axes} | dict.fromkeys(self.components, 0.0)
        total = np.zeros((4, 1), dtype=complex)
        for end, point in ends.items():
            sign = -1 if end == "tool" and len(ends) == 2 else 1
            for way, pose in ((1, still | calm), (-1, home)):
                total = total + sign * way * (self.to_bed(self.ends[end], {**values, **pose}, STEP) @ point)
        return total.real, total.imag / STEP.imag
