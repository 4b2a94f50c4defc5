"""Seeded poses, points and error values."""

from typing import Any

import numpy as np

from tests.exact_chain import ExactChain

VIEWS = ("tool_in_workpiece", "tool_in_bed", "workpiece_in_bed", "bed_in_workpiece")


def drawn(chain: ExactChain, seed: int, size: float = 1.0) -> tuple[dict[str, float], dict[str, Any], list[float]]:
    """A pose, values of all errors (`size` times 20 um and 100 urad at most) and dimensions, and a point."""
    rng = np.random.default_rng(seed)
    pose = {axis: rng.uniform(-300, 400) if axis in "XYZ" else rng.uniform(-170, 180) for axis in chain.axes}
    values = {name: rng.uniform(-400, 400) for name in chain.dimensions}
    for name in chain.components:
        values[name] = size * rng.uniform(-1, 1) * (2e-2 if name[1] in "XYZ" else 1e-4)
    for name in chain.location_errors:
        values[name] = size * rng.uniform(-1, 1) * 1e-4
    return pose, values, list(rng.uniform(-250, 250, 3))
