"""What planning has to say."""

from dataclasses import dataclass
from typing import Literal

from trueaxis.effects.kind import Role
from trueaxis.estimation.combinations import Combination
from trueaxis.estimation.tool_point import ToolSummary
from trueaxis.measurement.instrument_kinds import SmallUnit
from trueaxis.model.errors import Determined

State = Determined | Literal["given"]


@dataclass(frozen=True, slots=True, kw_only=True)
class BlockReport:
    """Components that are solved together from runs, in the order in which that can be done.

    equations, unknowns and rank over all positions; ranks: (rank, unknowns) of what hangs together at a position,
    each pair once; condition: largest over smallest singular value there, rotations scaled by the lever; because:
    what makes it singular, in words, or empty.
    """

    runs: tuple[str, ...]
    components: tuple[str, ...]
    equations: int
    unknowns: int
    rank: int
    ranks: tuple[tuple[int, int], ...]
    condition: float
    because: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class ErrorReport:
    """A component or location error, mm or rad as `unit` says. state: by what it will be determined; u, u_rms: largest
    standard uncertainty and its root mean square over the travel; prior: what [prior] lets expect; u_readings, u_prior:
    the parts of u_rms by the readings and by the prior. None: given.
    """

    name: str
    state: State
    unit: str
    u: float | None = None
    u_rms: float | None = None
    prior: float | None = None
    u_readings: float | None = None
    u_prior: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class ExpectedParameter:
    """A parameter of an effect. value: at which it is linearised, 0 where u does not depend on it; u: standard
    uncertainty, None where the runs do not tell it; both in `unit`; role: as in its kind.
    """

    name: str
    value: float
    u: float | None
    unit: str
    role: Role


@dataclass(frozen=True, slots=True, kw_only=True)
class ExpectedEffect:
    """An effect of the spec.

    state: `data`, told by the readings; `errors`, only together with errors of the machine: u would be a tenth or less
    if they were known; `silent`, no reading holds it; `lacking`, readings lack columns that it depends on, `missing`;
    `given`. stated: whether the user said at which values it is linearised.
    """

    effect: str
    state: Literal["data", "errors", "silent", "lacking", "given"]
    parameters: tuple[ExpectedParameter, ...] = ()
    missing: tuple[str, ...] = ()
    stated: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class NoiseReport:
    """Of an instrument. um: lowest and highest standard deviation of a reading that was assumed, micrometres, or as
    `unit` says; freedom: degrees of freedom that repeats leave.
    """

    instrument: str
    runs: int
    readings: int
    um: tuple[float, float]
    freedom: int
    unit: SmallUnit = "um"


@dataclass(frozen=True, slots=True)
class Redundant:
    """A location error that others can stand for, in words."""

    name: str
    stands_for: str


@dataclass(frozen=True, slots=True, kw_only=True)
class LocationSet:
    """The smallest set of location errors under one assumption on the placements.

    placement: in words; workpiece_free: whether the workpiece may be placed anyhow; rank: of the spec's location
    errors; kept, redundant: the set, in the order of the spec, and the rest; complete: how
    many any set needs that describes all axes; missing: constant errors that the spec's location errors cannot stand
    for.
    """

    placement: str
    workpiece_free: bool
    rank: int
    kept: tuple[str, ...]
    redundant: tuple[Redundant, ...]
    complete: int
    missing: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Expectations:
    """What runs will tell. combinations: what is known only in combination; freedom: degrees of freedom left for the
    noise beside what the readings tell of the unknowns.
    """

    tool: ToolSummary
    components: tuple[ErrorReport, ...]
    locations: tuple[ErrorReport, ...]
    effects: tuple[ExpectedEffect, ...]
    combinations: tuple[Combination, ...]
    noise: tuple[NoiseReport, ...]
    runs: int
    readings: int
    unknowns: int
    freedom: float
    minutes: float

    @property
    def nothing_determined(self) -> bool:
        """Whether the runs tell of no error at all."""
        return all(one.state in ("prior", "given") for one in (*self.components, *self.locations))


@dataclass(frozen=True, slots=True, kw_only=True)
class Added:
    """A run proposed: minutes that it takes; u: of what is wanted after it and those before, mm or rad."""

    run: str
    what: str
    readings: int
    minutes: float
    u: float


@dataclass(frozen=True, slots=True, kw_only=True)
class ProposalReport:
    """The runs that add most: wanted: the tool point over the volume or one error; before: its u, mm or rad as `unit`
    says; candidates: of how many they were chosen; after: what the plan with them will tell.
    """

    wanted: str
    unit: str
    before: float
    candidates: int
    added: tuple[Added, ...]
    after: Expectations


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanReport:
    """Everything. Lengths mm and angles rad unless a name says otherwise.

    expected: None for a plan from nothing, whose runs are all proposed; blocks_fault: why there is no order of blocks,
    or empty; free_of_order: runs that take no part in it; caveats: what must be known before all else.
    """

    machine: str
    source: str
    expected: Expectations | None
    blocks: tuple[BlockReport, ...] = ()
    blocks_fault: str = ""
    free_of_order: tuple[str, ...] = ()
    location_sets: tuple[LocationSet, ...] = ()
    proposal: ProposalReport | None = None
    notes: tuple[str, ...] = ()
    caveats: tuple[str, ...] = ()

    @property
    def nothing_determined(self) -> bool:
        """Whether the runs, those proposed apart, tell of no error at all."""
        found = self.expected or (self.proposal.after if self.proposal is not None else None)
        return found is None or found.nothing_determined
