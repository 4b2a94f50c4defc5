"""What is going on while each reading is taken: the truth, of which the readings' columns tell a part."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tests.hidden_effects.machine import Array

Indices = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class RunPlan:
    """A run as the setup describes it; plane: of a circle, such as XY; line: which line it repeats."""

    id: str
    instrument: str
    target: tuple[str, Array]
    reference: tuple[str, Array]
    line: str
    home: Mapping[str, float] | None = None
    direction: Array | None = None
    length: float | None = None
    plane: str = ""


@dataclass(frozen=True, eq=False)
class State:
    """One entry per reading, (n,) or axis -> (n,).

    positions: commanded; directions: of approach, 0 where the axis has not moved in the run; velocity: mm/s or deg/s;
    since_reversal: way of the axis since it turned, infinite where it has not moved; time: s; temperature: degC of the
    air; soaked: degC of the structure, which follows the air; feed: mm/min, NaN where the machine stands.
    """

    run: Indices
    seq: Indices
    positions: Mapping[str, Array]
    directions: Mapping[str, Array]
    velocity: Mapping[str, Array]
    since_reversal: Mapping[str, Array]
    time: Array
    temperature: Array
    soaked: Array
    feed: Array

    def at(self, rows: Indices | NDArray[np.bool_]) -> "State":
        """These rows alone."""

        def of_axes(values: Mapping[str, Array]) -> dict[str, Array]:
            return {axis: array[rows] for axis, array in values.items()}

        return State(
            self.run[rows],
            self.seq[rows],
            of_axes(self.positions),
            of_axes(self.directions),
            of_axes(self.velocity),
            of_axes(self.since_reversal),
            self.time[rows],
            self.temperature[rows],
            self.soaked[rows],
            self.feed[rows],
        )


@dataclass(frozen=True, eq=False)
class Plan:
    """Runs and the states in which their readings are taken."""

    runs: tuple[RunPlan, ...]
    state: State

    def of_run(self, *instruments: str) -> NDArray[np.bool_]:
        """(n,), true in the rows of these instruments."""
        chosen = [index for index, run in enumerate(self.runs) if run.instrument in instruments]
        return np.isin(self.state.run, chosen)
