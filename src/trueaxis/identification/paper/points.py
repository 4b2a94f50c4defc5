"""What is wrong with the measuring points of runs that give fewer values than they should."""

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from trueaxis.identification.words import enumerated
from trueaxis.measurement.setup import Run

SAME = 1e-9  # relative to the distance of the points


def points_remark(runs: Sequence[Run]) -> str:
    """A sentence where the points, seen along the common direction of the runs, coincide or lie on a line; else empty.

    Runs along one direction see a point through its two coordinates across that direction: three rotations and
    translations need three points that form a triangle when seen so.
    """
    directions = {run.direction for run in runs}
    carriers = {(run.target.on, run.reference.on) for run in runs}
    if len(runs) < 2 or len(directions) != 1 or len(carriers) != 1 or None in directions:
        return ""
    direction = np.array(runs[0].direction)
    points = np.array([run.target.point for run in runs])
    across = points - np.outer(points @ direction, direction)
    size = max(float(np.ptp(points, axis=0).max()), 1.0)
    along = f"seen along the direction ({', '.join(f'{part:g}' for part in direction)})"
    same = [
        f"{a.id} and {b.id}"
        for (a, at), (b, other) in combinations(zip(runs, across, strict=True), 2)
        if np.linalg.norm(at - other) <= SAME * size
    ]
    names = enumerated([run.id for run in runs])
    if same:
        rest = f", so that those of {names} lie on a line" if len(runs) > 2 else ""
        return f"the points of runs {enumerated(same)} are one point {along}{rest}"
    if len(runs) > 2 and np.linalg.matrix_rank(across - across[0], tol=SAME * size) < 2:
        return f"the points of runs {names} lie on a line {along}"
    return ""
