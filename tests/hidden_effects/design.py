"""What a campaign of measurements consists of."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Design:
    """lines: per axis; repeats: of each line, as runs of their own (X1-1, X1-2, ...) or, with one_run, in one run (X1);
    targets: per line, irregular where jitter, by `off` mm at most where that is given; straightness: one line per axis
    and direction across; diagonals: of the working volume; gauge: a probe on a step gauge along X, whose scale is
    beyond doubt; circles per plane: two directions times the feeds; leave_out: no samples next to a reversal;
    temperature: `day`, `linear` or none.
    """

    lines: int = 4
    repeats: int = 3
    targets: int = 41
    jitter: bool = True
    off: float | None = None
    one_run: bool = False
    straightness: bool = False
    diagonals: bool = False
    gauge: bool = False
    laser: bool = True
    ball_bar: bool = True
    feeds: tuple[float, ...] = (1000.0, 4000.0)
    radius: float = 150.0
    bar: float = 150.0
    samples: int = 180
    leave_out: bool = True
    temperature: str = "day"
    times: bool = True
