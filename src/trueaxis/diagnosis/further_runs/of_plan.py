"""What a measuring plan can tell: from which size on an effect is seen and told from others, what it lacks, and which
runs would tell more.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from trueaxis.diagnosis.judging.structure import Check
from trueaxis.effects.kind import Effect

Observability = Literal["observable", "confounded", "unobservable"]
Lack = Literal["column", "temperature", "instrument", "one_side", "one_direction", "one_feed"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Limit:
    """What the audit says of a candidate before any reading is looked at.

    size: name and unit of the amplitude that the limits are of; detection: what reaches the
    threshold of the evidence half the time; isolation: what is told from its nearest rival; share: |M s|^2 / |s|^2, the
    part of the signature that the base does not hold (M projects out the base); nearest: the candidate most like it,
    and r2, the squared correlation of what the base leaves of both. state: `observable`, `confounded` (r2 above 0.95)
    or `unobservable`; reason: why it is unobservable; nearest_at: searched parameters of the nearest where it is most
    alike.
    """

    effect: Effect
    size: str
    unit: str
    detection: float
    isolation: float
    share: float
    nearest: Effect | None
    r2: float
    state: Observability
    reason: str = ""
    nearest_at: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Placed:
    """A candidate at one point of its grid: values of the parameters that are searched, such as a pitch."""

    effect: Effect
    point: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Told:
    """From which amplitude on an effect is told from others: with a further run, and without it; infinite: never."""

    effect: Effect
    unit: str
    with_run: float
    without: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Separating:
    """What would tell a cause from its rivals. run: what to do, empty where no run of those considered would; times:
    how often; apart, left: rivals that it tells from the cause, and others; told: from the worst of them; needed: how
    often for the size found; broken_by: what would in general, as the kind has it.
    """

    cause: Placed
    run: str = ""
    times: int = 1
    apart: tuple[Placed, ...] = ()
    left: tuple[Placed, ...] = ()
    told: Told | None = None
    needed: int = 1
    broken_by: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class NextRun:
    """A further run that would help, for one of these: pairs: candidates that it tells apart, the first as `told` has
    it; check: of structure that has no name; instrument: whose noise is not known. run, times: what to do, and how
    often; empty where the check or the instrument says so.
    """

    run: str = ""
    times: int = 1
    pairs: tuple[tuple[Placed, tuple[Placed, ...]], ...] = ()
    told: Told | None = None
    check: Check | None = None
    instrument: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Absence:
    """What the data lack. place: column, axis of lines, plane of circles, or instrument; kinds: of effects that cannot
    be seen; empty: share of readings without the column; lacking: instruments that no run has; runs: ids of those whose
    temperature is assumed.
    """

    lack: Lack
    place: str = ""
    kinds: tuple[str, ...] = ()
    empty: tuple[int, int] = (0, 0)
    lacking: tuple[str, ...] = ()
    runs: tuple[str, ...] = ()
