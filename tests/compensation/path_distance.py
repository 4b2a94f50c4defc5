"""How far one path is off another, both points (3, n) joined by straight pieces; nothing of the package."""

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

FloatArray = NDArray[np.float64]
NEAREST = 24  # samples of the other path whose neighbourhoods are looked at
PROGRESS = 0.05  # mm per mm of way: what lies elsewhere along the path is further off, so that passes are not mixed up


def way(points: FloatArray) -> FloatArray:
    """Length of the path up to each point, (n,)."""
    return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=1), axis=0))])


def sampled(points: FloatArray, spacing: float, least: int = 1) -> FloatArray:
    """The same path with points no more than `spacing` apart; rows are coordinates, the first three of them lengths.

    least: parts of each motion; of several about one place `distances` then finds the right one.
    """
    count = np.maximum(np.ceil(np.linalg.norm(np.diff(points[:3], axis=1), axis=0) / spacing), least).astype(int)
    motion = np.repeat(np.arange(count.size), count)
    share = (np.arange(motion.size) - np.repeat(np.cumsum(count) - count, count) + 1) / count[motion]
    inner = points[:, motion] + share * (points[:, motion + 1] - points[:, motion])
    return np.concatenate([points[:, :1], inner], axis=1)


def distances(points: FloatArray, path: FloatArray) -> FloatArray:
    """Distance of each point from the path, (n,), looked for where about as much of the way is done."""
    if path.shape[1] < 2:
        return np.asarray(np.linalg.norm(points - path[:, :1], axis=0))
    ways = [way(points), way(path)]
    ways[0] *= ways[1][-1] / max(ways[0][-1], 1e-9)
    places, tree = (np.vstack([p, PROGRESS * w]) for p, w in zip((points, path), ways, strict=True))
    _, near = cKDTree(tree.T).query(places.T, k=min(NEAREST, path.shape[1]))
    best = np.full(points.shape[1], np.inf)
    for column in near.reshape(points.shape[1], -1).T:
        for shift in (-1, 0):
            first = np.clip(column + shift, 0, path.shape[1] - 2)
            a, span = path[:, first], path[:, first + 1] - path[:, first]
            size = (span**2).sum(axis=0)
            share = np.clip(((points - a) * span).sum(axis=0) / np.where(size > 0, size, 1.0), 0.0, 1.0)
            best = np.minimum(best, np.linalg.norm(points - a - share * span, axis=0))
    return best


def apart(one: FloatArray, other: FloatArray) -> float:
    """Largest distance of either path from the other."""
    return float(max(distances(one, other).max(), distances(other, one).max()))
