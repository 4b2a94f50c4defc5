"""A branch multiplied out body by body, as a pair: the error-free product, and the first-order motion on top of it.

To first order [SBk] = (1 + N_k) [SBk]^0, where N_k is the 4x4 matrix of a small rotation Theta_k about the origin of
the bed frame and a displacement D_k. An error factor (delta, epsilon) that is met behind the error-free product (R, p)
adds R epsilon to Theta and R delta + p x R epsilon to D; nothing is expanded and nothing of second order arises.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from trueaxis.derivation.chain import Error, Joint, Vector, cross, matrix

Columns = Mapping[str, Vector]


@dataclass(frozen=True)
class BranchStep:
    """What one joint adds to its branch.

    ideal: [SBk]^0, 4x4, mm. rotation, displacement: for each error of the joint, by its name, the vector by which a
    unit of it changes Theta (rad per mm or rad) and D (mm per mm or rad), bed frame.
    """

    joint: Joint
    ideal: sp.Matrix
    rotation: Columns
    displacement: Columns


def branch_steps(joints: tuple[Joint, ...]) -> tuple[BranchStep, ...]:
    """The steps of a branch from the bed outwards."""
    at = sp.eye(4)
    steps: list[BranchStep] = []
    for joint in joints:
        rotation: dict[str, Vector] = {}
        displacement: dict[str, Vector] = {}
        for factor in joint.steps:
            if not isinstance(factor, Error):
                at = (at * matrix(factor)).applyfunc(sp.expand)
                continue
            for index, name in enumerate(factor.names):
                if name is None:
                    continue
                turned = _vector(at[:3, index % 3])
                if index < 3:
                    displacement[name] = turned
                else:
                    rotation[name] = turned
                    displacement[name] = cross(_vector(at[:3, 3]), turned)
        steps.append(BranchStep(joint, at, rotation, displacement))
    return tuple(steps)


def _vector(column: sp.Matrix) -> Vector:
    x, y, z = column
    return x, y, z
