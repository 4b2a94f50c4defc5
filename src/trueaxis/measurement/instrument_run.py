"""What an instrument file says of one run: readings and positions as numbers, and nothing that it leaves open."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
DirectionArray = npt.NDArray[np.int8]

MOST_ROWS = 1_000_000  # of a file: more is no file of readings that were taken one by one


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class InstrumentRun:
    """One run as its file has it, rows in the order in which they were read.

    file: as the user named it; id: the run's name; instrument: "ballbar" where the file is of a ball bar, "angle"
    where it is of angles, else None.
    axis: the axis whose positions are `targets`, None where the file does not name it. targets: (n,), mm or deg, None
    where `positions` has all; positions: axis -> (n,), mm or deg; angle: (n,), polar angle of a ball bar in the plane
    of its circle, rad. reading: (n,), mm: a deviation, or the whole length of the bar where `whole_length`; of angles
    rad, or, where `unit_open`, as in a file that does not say its unit. directions: (n,), direction of approach of the
    moved axis, 0 where it follows from the order of the rows. time (s), feed (mm/min), temperature (degC): (n,) where
    the file has them. report: free text for reports. unused: heads of columns of the file that were not read. assumed:
    sentences on what the reader of the file takes for granted.
    """

    file: str
    id: str
    reading: FloatArray
    instrument: Literal["ballbar", "angle"] | None = None
    axis: str | None = None
    targets: FloatArray | None = None
    positions: Mapping[str, FloatArray] = field(default_factory=dict)
    angle: FloatArray | None = None
    whole_length: bool = False
    unit_open: bool = False
    directions: DirectionArray | None = None
    time: FloatArray | None = None
    feed: FloatArray | None = None
    temperature: FloatArray | None = None
    report: Mapping[str, str] = field(default_factory=dict)
    unused: tuple[str, ...] = ()
    assumed: tuple[str, ...] = ()


def approach_of_passes(passes: npt.NDArray[np.int64], targets: FloatArray) -> DirectionArray:
    """(n,): +1 for rows of passes over ascending targets, -1 for descending ones, 0 for passes that are neither.

    passes: (n,), number of the pass of each row; targets: (n,), mm or deg, in the order of the rows.
    """
    directions = np.zeros(targets.size, dtype=np.int8)
    for number in np.unique(passes):
        rows = np.flatnonzero(passes == number)
        steps = np.diff(targets[rows])
        if steps.size and (steps > 0.0).all():
            directions[rows] = 1
        elif steps.size and (steps < 0.0).all():
            directions[rows] = -1
    return directions
