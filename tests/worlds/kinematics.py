"""Exact coordinates of points on a machine with errors, and how each error moves them.

A body's transform to its lower body is, in this order: position, location error, motion, motion error. Points are
carried through the chain one transform after another, so that arrays of any leading shape (machines, poses) go at once.
"""

from collections.abc import Mapping

import numpy as np

from tests.worlds.machine import LETTERS, LINEAR, Array, Body, Machine

Values = Mapping[str, Array]


def coordinates(
    machine: Machine,
    end: str,
    frame: str,
    positions: Values,
    point: Array,
    errors: Values,
    located: Values,
) -> Array:
    """A point of one end in the frame of another, (..., n, 3), mm.

    end, frame: bed, workpiece or tool; positions: axis -> (n,), mm or deg; point: (3,) or (n, 3), in the frame of its
    end; errors: component -> (..., n); located: name -> value, of any shape that goes with
    these. Empty mappings: the ideal machine.
    """
    at = np.asarray(point, float)
    for body in reversed(machine.branch(end)):
        at = _joint(machine, body, positions, at, errors, located)
    for body in machine.branch(frame):
        at = _joint_back(machine, body, positions, at, errors, located)
    count = len(next(iter(positions.values())))
    return np.array(np.broadcast_to(at, np.broadcast_shapes(at.shape, (count, 3))))


def ideal_frame(machine: Machine, end: str, positions: Values) -> tuple[Array, Array]:
    """Axes (n, 3, 3), as columns, and origin (n, 3) of an end's frame on the ideal machine, seen from the bed."""
    return _frames(machine, machine.branch(end), positions)[-1][2:]


def sensitivities(machine: Machine, end: str, frame: str, positions: Values, point: Array) -> dict[str, Array]:
    """Change of `coordinates` per unit of each component error and location error at the ideal machine, (n, 3).

    An error of a body displaces (EX EY EZ) or turns (EA EB EC) everything outside it, about the body's own frame: the
    generator matrix of the error, conjugated by the ideal chain. What the errors of the frame's branch do counts
    negatively.
    """
    bed = coordinates(machine, end, "bed", positions, point, {}, {})
    to_frame = np.swapaxes(ideal_frame(machine, frame, positions)[0], 1, 2) if frame != "bed" else np.eye(3)[None]
    found: dict[str, Array] = {}
    for side, sign in ((end, 1.0), (frame, -1.0)):
        branch = machine.branch(side)
        for body, (still, origin, turned, moved) in zip(branch, _frames(machine, branch, positions), strict=True):
            for direction, name in body.located:
                change = _generator(direction, still, bed - origin)
                found[name] = found.get(name, 0.0) + sign * np.einsum("nij,nj->ni", to_frame, change)
            for name in body.motion:
                change = _generator(name[:2], turned, bed - moved)
                found[name] = found.get(name, 0.0) + sign * np.einsum("nij,nj->ni", to_frame, change)
    return found


def follow(machine: Machine, rotary: Values, tool_point: Array, workpiece_point: Array) -> dict[str, Array]:
    """Positions of the linear axes, (n,), at which the two points meet on the ideal machine; rotary: axis -> (n,).

    Rotary axes stand further from the bed than linear ones.
    """
    count = len(next(iter(rotary.values())))
    start = dict(rotary) | {axis: np.zeros(count) for axis in machine.linear}
    tool = coordinates(machine, "tool", "bed", start, tool_point, {}, {})
    workpiece = coordinates(machine, "workpiece", "bed", start, workpiece_point, {}, {})
    found = {}
    for axis in machine.linear:
        sense = machine.body_of(axis).sense * (1.0 if machine.carries("tool", axis) else -1.0)
        found[axis] = np.asarray(sense * (workpiece - tool)[:, LETTERS.index(axis)], float)
    return found


def _joint(machine: Machine, body: Body, positions: Values, at: Array, errors: Values, located: Values) -> Array:
    """From the body's own frame to that of its lower body."""
    if body.motion and errors:
        shift, turn = _error({name[:2]: errors[name] for name in body.motion if name in errors})
        at = _turn(at, turn, machine.true_rotations) + shift
    if body.moves:
        at = _motion(body, positions[body.moves], at)
    if body.located and located:
        shift, turn = _error({d: np.asarray(located.get(name, 0.0)) for d, name in body.located})
        at = _turn(at, turn, machine.true_rotations) + shift
    return np.asarray(at + np.array(body.offset), float)


def _joint_back(machine: Machine, body: Body, positions: Values, at: Array, errors: Values, located: Values) -> Array:
    """From the lower body's frame to the body's own."""
    at = at - np.array(body.offset)
    if body.located and located:
        shift, turn = _error({d: np.asarray(located.get(name, 0.0)) for d, name in body.located})
        at = _turn_back(at - shift, turn, machine.true_rotations)
    if body.moves:
        at = _motion(body, -positions[body.moves], at)
    if body.motion and errors:
        shift, turn = _error({name[:2]: errors[name] for name in body.motion if name in errors})
        at = _turn_back(at - shift, turn, machine.true_rotations)
    return at


def _motion(body: Body, position: Array, at: Array) -> Array:
    axis = LETTERS.index(body.moves) % 3
    if body.moves in LINEAR:
        return np.asarray(at + body.sense * np.asarray(position)[..., np.newaxis] * np.eye(3)[axis], float)
    angle = np.radians(body.sense * np.asarray(position))
    one, two = (axis + 1) % 3, (axis + 2) % 3
    cosine, sine = np.cos(angle), np.sin(angle)
    parts = [at[..., axis] + 0.0 * angle] * 3
    parts[one] = cosine * at[..., one] - sine * at[..., two]
    parts[two] = sine * at[..., one] + cosine * at[..., two]
    return np.stack(np.broadcast_arrays(*parts), axis=-1)


def _error(values: Mapping[str, Array]) -> tuple[Array, Array]:
    """Shift and rotation vector, (..., 3) each."""
    zero = np.zeros(())
    columns: tuple[Array, ...] = np.broadcast_arrays(
        *(np.asarray(values.get(f"E{letter}", zero), float) for letter in LETTERS)
    )
    return np.stack(columns[:3], axis=-1), np.stack(columns[3:], axis=-1)


def _turn(at: Array, turn: Array, true_rotations: bool) -> Array:
    """(1 + [turn x]) at; or the rotation by the vector (Rodrigues)."""
    if not true_rotations:
        return at + _cross(turn, at)
    square = np.sum(turn**2, axis=-1, keepdims=True)
    angle = np.sqrt(square)
    first = np.sinc(angle / np.pi)
    second = 0.5 * np.sinc(angle / (2 * np.pi)) ** 2  # (1 - cos a) / a^2
    once = _cross(turn, at)
    return np.asarray(at + first * once + second * _cross(turn, once), float)


def _turn_back(at: Array, turn: Array, true_rotations: bool) -> Array:
    """(1 + [e x])^-1 v = (v + e (e . v) - e x v) / (1 + e . e)."""
    if true_rotations:
        return _turn(at, -turn, true_rotations=True)
    along = np.sum(turn * at, axis=-1, keepdims=True)
    return np.asarray((at + turn * along - _cross(turn, at)) / (1.0 + np.sum(turn**2, axis=-1, keepdims=True)), float)


def _cross(a: Array, b: Array) -> Array:
    return np.stack(
        [
            a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1],
            a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2],
            a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0],
        ],
        axis=-1,
    )


Frame = tuple[Array, Array, Array, Array]


def _frames(machine: Machine, branch: tuple[Body, ...], positions: Values) -> list[Frame]:
    """Per body: axes and origin before its motion, and after it; (n, 3, 3) and (n, 3), seen from the bed."""
    count = len(next(iter(positions.values())))
    axes, origin = np.broadcast_to(np.eye(3), (count, 3, 3)), np.zeros((count, 3))
    found = []
    for body in branch:
        start = origin + np.einsum("nij,j->ni", axes, np.array(body.offset))
        moved, turned = start, axes
        if body.moves:
            unit = np.eye(3)
            tips = [_motion(body, positions[body.moves], unit[k]) for k in range(3)]
            shift = _motion(body, positions[body.moves], np.zeros(3))
            own = np.stack([tip - shift for tip in tips], axis=-1)
            turned = np.einsum("nij,njk->nik", axes, own)
            moved = start + np.einsum("nij,nj->ni", axes, shift)
        found.append((axes, start, turned, moved))
        axes, origin = turned, moved
    return found


def _generator(direction: str, axes: Array, lever: Array) -> Array:
    """(n, 3): shift along a column of the axes, or turn about it of what stands at the lever."""
    letter = LETTERS.index(direction[1])
    column = axes[:, :, letter % 3]
    return column if letter < 3 else _cross(column, lever)
