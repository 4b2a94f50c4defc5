"""Readings of an independent exact machine, taken word for word from the definition: displacements and distances."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from tests.generator.machine import Exact, Generator, exact

Pose = Mapping[str, float]
End = tuple[str, Sequence[float]]


def laser(
    machine: Generator, pose: Pose, home: Pose, *, direction: Sequence[float], frame: str, target: End, reference: End
) -> Exact:
    """direction . (displacement of target - displacement of reference), minus the same of the error-free machine."""

    def sensed(actual: bool) -> Exact:
        moved = [
            machine.coordinates(body, frame, pose, point, actual)
            - machine.coordinates(body, frame, home, point, actual)
            for body, point in (target, reference)
        ]
        return exact(direction) @ (moved[0] - moved[1])

    return sensed(True) - sensed(False)


def ball_bar(machine: Generator, pose: Pose, *, length: float, target: End, reference: End, frame: str) -> Exact:
    """Ball distance minus nominal length."""
    ends = [machine.coordinates(body, frame, pose, point, True) for body, point in (target, reference)]
    between = ends[0] - ends[1]
    return np.sqrt(between @ between) - exact(length)


def noise(seed: int, sigma_mm: float, count: int) -> Any:
    """Gaussian noise from uniform numbers (Box and Muller), not from the package's source of it."""
    source = np.random.RandomState(seed)
    u, v = source.uniform(size=(2, count))
    return sigma_mm * np.sqrt(-2.0 * np.log1p(-u)) * np.cos(2.0 * np.pi * v)
