"""Views: a point of one end seen in a frame of another, as the walk of factors that takes it there.

The exact walk is carried as the pair (ideal point, deviation from it).

Four views carry everything: positions are compared (Eqs. 4-6), displacements measured (Eqs. 7-11) and errors
compensated (Eqs. 53-55) with them.

The deviation is never the difference of two positions, so it keeps its digits: micrometres against metres.
"""

from dataclasses import dataclass
from functools import cache

import sympy as sp

from trueaxis.derivation.chain import ZERO, Error, Joint, Shift, Step, Turn, Vector, added, chains, cross, turned
from trueaxis.derivation.routine import Binder
from trueaxis.machine.machine import Machine
from trueaxis.view import Carrier, Frame, View


@dataclass(frozen=True)
class Factor:
    """One factor met by a point on its way, and whether it is met inverted."""

    step: Step
    inverted: bool


@dataclass(frozen=True)
class ViewWalk:
    """A point of `seen` in the frame of `frame`; `walk` lists the factors in the order in which they act on it."""

    name: View
    seen: Carrier
    frame: Frame
    walk: tuple[Factor, ...]


@cache
def views(machine: Machine) -> tuple[ViewWalk, ...]:
    """The views of a machine: tool_in_workpiece (Eq. 4), tool_in_bed and workpiece_in_bed (Eq. 53), bed_in_workpiece.

    A body below both ends stands on both branches; what it does to the view cancels only as far as it truly does.
    """
    workpiece, tool = chains(machine)
    up_tool, up_workpiece = _towards_bed(tool), _towards_bed(workpiece)
    down_workpiece = tuple(Factor(factor.step, True) for factor in reversed(up_workpiece))
    return (
        ViewWalk("tool_in_workpiece", "tool", "workpiece", up_tool + down_workpiece),
        ViewWalk("tool_in_bed", "tool", "bed", up_tool),
        ViewWalk("workpiece_in_bed", "workpiece", "bed", up_workpiece),
        ViewWalk("bed_in_workpiece", "bed", "workpiece", down_workpiece),
    )


def view(machine: Machine, name: View) -> ViewWalk:
    """The view of that name."""
    return next(candidate for candidate in views(machine) if candidate.name == name)


def _towards_bed(joints: tuple[Joint, ...]) -> tuple[Factor, ...]:
    return tuple(Factor(step, False) for part in reversed(joints) for step in reversed(part.steps))


@dataclass(frozen=True)
class Walked:
    """Ideal point and exact deviation at the end of a walk, mm; both refer to what the binder has bound."""

    ideal: Vector
    deviation: Vector


def walk(
    view: ViewWalk,
    start: Vector,
    binder: Binder,
    *,
    exact: bool = True,
    true_rotation: bool = False,
    direction: bool = False,
) -> Walked:
    """Walk a point through a view, exactly or to first order in the errors.

    Forward, an error factor takes the point p + d to R (p + d) + delta. With the paper's matrix R = 1 + [epsilon x]
    the deviation becomes d + delta + epsilon x (p + d); inverted, with u = d - delta and w = p + u, it is
    (u + epsilon (epsilon . w) - epsilon x w - |epsilon|^2 p) / (1 + |epsilon|^2).
    true_rotation: R is the rotation by the vector epsilon instead, inverted by its negative. direction: `start` is a
    free vector, such as the tool axis, which displacements do not move.
    """
    p, d = start, ZERO
    for factor in view.walk:
        sign = -1 if factor.inverted else 1
        match factor.step:
            case Shift(by) if not direction:
                p = _bound(binder, added(p, by, sign))
            case Turn(axis, cosine, sine):
                p, d = (_bound(binder, turned(axis, cosine, sign * sine, one)) for one in (p, d))
            case Error(displacement, angles, names) if any(names):
                shift = ZERO if direction else displacement
                if not exact:
                    d = _bound(binder, added(added(d, shift, sign), cross(angles, p), sign))
                elif true_rotation:
                    d = _rotated(binder, shift, angles, p, d, sign)
                elif not factor.inverted:
                    d = _bound(binder, added(added(d, shift), cross(angles, added(p, d))))
                else:
                    d = _inverse(binder, shift, angles, p, d)
    return Walked(p, d)


def _inverse(binder: Binder, displacement: Vector, angles: Vector, p: Vector, d: Vector) -> Vector:
    u = _bound(binder, added(d, displacement, -1))
    if not any(angles):
        return u
    w = _bound(binder, added(p, u))
    projection = binder.bind(sum((a * b for a, b in zip(angles, w, strict=True)), sp.S.Zero))
    square = binder.bind(sum((a * a for a in angles), sp.S.Zero))
    scale = binder.bind(1 / (1 + square))
    turned = cross(angles, w)
    return _bound(binder, ((u[i] + angles[i] * projection - turned[i] - square * p[i]) * scale for i in range(3)))


def _rotated(binder: Binder, displacement: Vector, angles: Vector, p: Vector, d: Vector, sign: int) -> Vector:
    """Rodrigues' formula: (R - 1) w = s epsilon x w + c epsilon x (epsilon x w), q = |epsilon|^2.

    s = sin(|epsilon|)/|epsilon| and c = (1 - cos(|epsilon|))/|epsilon|^2 as series in q, which need no branch at zero
    and are exact to double precision for rotations below 0.05 rad.
    """
    u = d if sign > 0 else _bound(binder, added(d, displacement, -1))
    if any(angles):
        w = _bound(binder, added(p, u))
        q = binder.bind(sum((a * a for a in angles), sp.S.Zero))
        s = binder.bind(1 - q * (sp.Rational(1, 6) - q * (sp.Rational(1, 120) - q / 5040)))
        c = binder.bind(sp.Rational(1, 2) - q * (sp.Rational(1, 24) - q * (sp.Rational(1, 720) - q / 40320)))
        once = _bound(binder, cross(angles, w))
        twice = _bound(binder, cross(angles, once))
        u = _bound(binder, (u[i] + sign * s * once[i] + c * twice[i] for i in range(3)))
    return u if sign < 0 else _bound(binder, added(u, displacement))


def _bound(binder: Binder, values: object) -> Vector:
    x, y, z = binder.bind_all(values)  # type: ignore[arg-type]
    return x, y, z
