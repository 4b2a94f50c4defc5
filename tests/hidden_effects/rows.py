"""The rows of one run, before the clock of the campaign is known."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from tests.hidden_effects.machine import Array


@dataclass(frozen=True, eq=False)
class Rows:
    """The rows of one run, (n,); time since its start."""

    positions: Mapping[str, Array]
    directions: Mapping[str, Array]
    velocity: Mapping[str, Array]
    since_reversal: Mapping[str, Array]
    time: Array
    feed: Array
    lasts: float


def unit(axis: str) -> Array:
    return np.asarray(np.eye(3)["XYZ".index(axis)], float)
