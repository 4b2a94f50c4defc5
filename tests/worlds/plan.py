"""What is measured: runs as setup.toml describes them, and the state of the machine at every reading."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from tests.worlds.machine import Array, Indices

End = tuple[str, tuple[float, float, float]]


@dataclass(frozen=True, eq=False)
class Run:
    """A run; line: what is measured, the same for its repeats; mount: the set-up that its runs share (a line or a ball
    in one session); across: a straightness line; resolution_mm: of the display, 0 for none.
    """

    id: str
    instrument: str
    target: End
    reference: End
    frame: str
    line: str
    home: Mapping[str, float] | None = None
    direction: tuple[float, float, float] | None = None
    length: float | None = None
    across: bool = False
    session: int = 0
    plane: str = ""

    @property
    def mount(self) -> str:
        return f"{self.line}@{self.session}"

    @property
    def measuring_frame(self) -> str:
        """A ball bar has no frame of its own: its distance is seen by the body that carries the reference."""
        return self.frame if self.length is None else self.reference[0]


@dataclass(frozen=True, eq=False)
class Track:
    """The rows of one run in the order of reading: axis -> (n,) and (n,).

    positions: commanded; directions: of approach, 0 where the axis has not moved; since: way since the axis turned
    back, infinite where it has not; path: that of the linear axes together; turned: s
    since then, infinite where axes stand; velocity: mm/s or deg/s; time: s
    from the start of the run; feed: mm/min, NaN where axes stand.
    """

    positions: Mapping[str, Array]
    directions: Mapping[str, Array]
    since: Mapping[str, Array]
    path: Mapping[str, Array]
    turned: Mapping[str, Array]
    velocity: Mapping[str, Array]
    time: Array
    feed: Array


@dataclass(frozen=True, eq=False)
class Measurement:
    """Runs that belong together: the repeats of a line, both directions of a circle; used: ingredients."""

    runs: tuple[tuple[Run, Track], ...]
    used: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Plan:
    """All rows, (n,) or axis -> (n,); run: index into runs; temperature: of the air, soaked: of the structure, degC."""

    runs: tuple[Run, ...]
    run: Indices
    seq: Indices
    positions: Mapping[str, Array]
    directions: Mapping[str, Array]
    since: Mapping[str, Array]
    path: Mapping[str, Array]
    turned: Mapping[str, Array]
    velocity: Mapping[str, Array]
    time: Array
    feed: Array
    temperature: Array
    soaked: Array

    @property
    def count(self) -> int:
        return len(self.time)

    def rows(self, index: int) -> Indices:
        """Rows of a run, in the order of reading."""
        return np.flatnonzero(self.run == index)

    def at(self, rows: Indices) -> dict[str, Array]:
        """Positions in these rows."""
        return {axis: values[rows] for axis, values in self.positions.items()}


@dataclass(frozen=True)
class Habits:
    """How the shop measures: what is drawn once per design.

    orders: of targets, out of passes, cycles, poses; spacing: equidistant, jittered; targets: per line;
    repeats: of each target and direction; as_runs: repeats are runs of their own; both: from both directions; samples:
    per circle; overtravel: mm beyond the last target before an axis turns back, 0: it turns on the target;
    leave_out: no samples next to a reversal; bracket: reach of target points, mm; homes: out of first, zero, anywhere;
    thorough: every axis and every pair of axes is measured, by laser and ball bar.
    """

    orders: tuple[str, ...] = ("passes",)
    spacing: str = "equidistant"
    targets: int = 11
    repeats: int = 1
    as_runs: bool = False
    both: bool = True
    samples: int = 90
    overtravel: float = 3.0
    leave_out: bool = True
    bracket: float = 0.0
    thorough: bool = False
    homes: tuple[str, ...] = ("first",)
    feeds: tuple[float, ...] = field(default=(1000.0,))
