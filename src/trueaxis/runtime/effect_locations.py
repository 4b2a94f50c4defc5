"""A position error that the spec leaves out, as the motion errors that it amounts to."""

import numpy as np

from trueaxis.effects.kind import Effect
from trueaxis.runtime.curves import FloatArray
from trueaxis.spec.machine import LINEAR, Machine

_LETTERS = "XYZ"


def location_terms(machine: Machine, effect: Effect, angle: float, positions: FloatArray) -> dict[str, FloatArray]:
    """Motion errors equal to a small rotation before the motion of an axis, to first order: component -> (n,).

    effect: such as EC0X; angle: rad; positions: (n_axes, n), mm or deg. Of a joint whose ideal motion is a rotation R
    and a displacement p, a rotation w before the motion is the rotation R^T w with the displacement R^T (w x p) after
    it: for a linear axis the same rotation and a straightness that grows with the position.
    Raises ValueError where the spec leaves out one of these motion errors as well.
    """
    name = effect.component or ""
    axis = name[-1]
    turned = np.zeros(3)
    turned["ABC".index(name[1])] = angle
    commanded = machine.mover(axis).sense * positions[machine.axes.index(axis)]
    if axis in LINEAR:
        along = np.zeros(3)
        along[LINEAR.index(axis)] = 1.0
        vectors = {"A": np.repeat(turned[:, np.newaxis], commanded.size, axis=1)}
        vectors["X"] = np.cross(turned, along)[:, np.newaxis] * commanded
    else:
        vectors = {"A": _turned_back("ABC".index(axis), np.radians(commanded), turned)}
    found = {}
    for first, vector in vectors.items():
        letters = _LETTERS if first == "X" else "ABC"
        found.update({f"E{letter}{axis}": row for letter, row in zip(letters, vector, strict=True) if row.any()})
    lacking = sorted(set(found) - set(machine.components))
    if lacking:
        raise ValueError(f"{effect.label} needs the motion errors {', '.join(lacking)}, which the machine leaves out")
    return found


def _turned_back(about: int, angle: FloatArray, vector: FloatArray) -> FloatArray:
    """R^T vector, (3, n), with R the rotation about a frame axis by angles (n,), rad."""
    one, other = (about + 1) % 3, (about + 2) % 3
    found = np.repeat(vector[:, np.newaxis], angle.size, axis=1)
    found[one] = np.cos(angle) * vector[one] + np.sin(angle) * vector[other]
    found[other] = np.cos(angle) * vector[other] - np.sin(angle) * vector[one]
    return found
