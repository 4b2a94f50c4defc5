"""The exact walk of a point through a view, carried as the pair (ideal point, deviation from it).

The deviation is never the difference of two positions, so it keeps its digits: micrometres against metres.
"""

from dataclasses import dataclass

import sympy as sp

from trueaxis.derive.chain import ZERO, Error, Shift, Turn, Vector, cross, rotation
from trueaxis.derive.routine import Binder
from trueaxis.derive.views import View


@dataclass(frozen=True)
class Walked:
    """Ideal point and exact deviation at the end of a walk, mm; both refer to what the binder has bound."""

    ideal: Vector
    deviation: Vector


def walk(view: View, point: Vector, binder: Binder, *, exact: bool = True) -> Walked:
    """Walk a point through a view, exactly for the small-rotation matrices or to first order in the errors.

    Forward, an error factor gives d + delta + epsilon x (p + d). Inverted, with u = d - delta and w = p + u, the exact
    inverse of 1 + [epsilon x] gives (u + epsilon (epsilon . w) - epsilon x w - |epsilon|^2 p) / (1 + |epsilon|^2).
    """
    p, d = point, ZERO
    for factor in view.walk:
        sign = -1 if factor.inverted else 1
        match factor.step:
            case Shift(by):
                p = _bound(binder, _add(p, by, sign))
            case Turn(axis, cosine, sine):
                turn = rotation(axis, cosine, sign * sine)
                p, d = _bound(binder, turn * sp.Matrix(p)), _bound(binder, turn * sp.Matrix(d))
            case Error(displacement, angles, names) if any(names):
                if not exact:
                    d = _bound(binder, _add(_add(d, displacement, sign), cross(angles, p), sign))
                elif not factor.inverted:
                    d = _bound(binder, _add(_add(d, displacement), cross(angles, _add(p, d))))
                else:
                    d = _inverse(binder, displacement, angles, p, d)
    return Walked(p, d)


def _inverse(binder: Binder, displacement: Vector, angles: Vector, p: Vector, d: Vector) -> Vector:
    u = _bound(binder, _add(d, displacement, -1))
    if not any(angles):
        return u
    w = _bound(binder, _add(p, u))
    projection = binder.bind(sum((a * b for a, b in zip(angles, w, strict=True)), sp.S.Zero))
    square = binder.bind(sum((a * a for a in angles), sp.S.Zero))
    scale = binder.bind(1 / (1 + square))
    turned = cross(angles, w)
    return _bound(binder, ((u[i] + angles[i] * projection - turned[i] - square * p[i]) * scale for i in range(3)))


def _add(left: Vector, right: Vector, sign: int = 1) -> Vector:
    x, y, z = (a + sign * b for a, b in zip(left, right, strict=True))
    return x, y, z


def _bound(binder: Binder, values: object) -> Vector:
    x, y, z = binder.bind_all(values)  # type: ignore[arg-type]
    return x, y, z
