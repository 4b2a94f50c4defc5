"""The rigid placement of a workpiece that fits deviations of tool points best: a shift and a small rotation.

Deviations relative to it are what remains of a workpiece whose place is not prescribed, as of a part that is aligned on
a measuring machine by all of its points. Least squares, all points counting alike.
"""

from dataclasses import dataclass

import numpy as np

from trueaxis.model.curves import FloatArray

ROUNDING = 1e-9  # of the largest singular value: a rotation that moves none of the points


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Placement:
    """The rigid placement of a workpiece that was taken off. centre: (3,), of the points, mm, workpiece frame; shift:
    (3,), mm, at the centre; rotation: (3,), rad, about x, y and z.
    """

    centre: FloatArray
    shift: FloatArray
    rotation: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Placements:
    """What the rigid placements of a workpiece make of n points.

    directions: (3, n, r), orthonormal over all coordinates of all points, r at most 6; centre: (3,), of the points, mm;
    parameters: (6, r), shift at the centre, mm, and rotation, rad, of each.
    """

    directions: FloatArray
    centre: FloatArray
    parameters: FloatArray

    def fit(self, deviation: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Deviations (3, n) relative to the best fit, and the shift and rotation (6,) that it takes off, mm and rad."""
        share = np.einsum("inr,in->r", self.directions, deviation)
        return deviation - self.directions @ share, self.parameters @ share


def placements(points: FloatArray) -> Placements:
    """Of a workpiece with these points (3, n), mm, in its frame."""
    count = points.shape[1]
    centre = points.mean(axis=1) if count else np.zeros(3)
    x, y, z = points - centre[:, np.newaxis]
    zero = np.zeros(count)
    size = max(float(np.sqrt((x**2 + y**2 + z**2).mean())) if count else 0.0, 1.0)
    turned = np.array([[zero, z, -y], [-z, zero, x], [y, -x, zero]]) / size  # coordinates of w x p, by those of w
    shifted = np.repeat(np.eye(3)[:, :, np.newaxis], count, axis=2)
    columns = np.concatenate([shifted, turned], axis=1).transpose(0, 2, 1)  # (3, n, 6)
    left, singular, right = np.linalg.svd(columns.reshape(3 * count, 6), full_matrices=False)
    kept = singular > ROUNDING * singular.max(initial=0.0)
    per_unit = np.array([1.0, 1.0, 1.0, 1.0 / size, 1.0 / size, 1.0 / size])
    parameters = per_unit[:, np.newaxis] * right[kept].T / singular[kept]
    return Placements(left[:, kept].reshape(3, count, int(kept.sum())), centre, parameters)
