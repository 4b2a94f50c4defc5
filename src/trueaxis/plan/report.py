"""What planning has to say."""

from dataclasses import dataclass
from typing import Literal

State = Literal["determined", "by convention", "partly", "undetermined", "not seen", "given"]


@dataclass(frozen=True, slots=True)
class InstrumentReport:
    """What was assumed of the instruments of some runs."""

    runs: tuple[str, ...]
    assumed: str
    unknowns: int


@dataclass(frozen=True, slots=True)
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


@dataclass(frozen=True, slots=True)
class CurveReport:
    """One motion error: determined of its `unknowns` coefficients; largest standard uncertainty over the positions
    measured and over the whole travel, mm or rad (None: not determined).
    """

    name: str
    state: State
    unknowns: int
    determined: int
    u_measured: float | None
    u_travel: float | None
    unit: str


@dataclass(frozen=True, slots=True)
class LocationReport:
    """One location error: u in `unit` with least-squares lines level, and with end points level, where that matters."""

    name: str
    state: State
    u: float | None
    u_end_point: float | None
    unit: str


@dataclass(frozen=True, slots=True)
class OpenReport:
    """Combinations that no reading sees: how many, of which errors, in words; and the convention's, if it settles
    them.
    """

    combination: str
    parameters: tuple[str, ...]
    count: int
    settled: bool


@dataclass(frozen=True, slots=True)
class Redundant:
    """A location error that others can stand for, in words."""

    name: str
    stands_for: str


@dataclass(frozen=True, slots=True)
class LocationSet:
    """The smallest set of location errors under one assumption on the placements.

    rank: of the spec's location errors; kept, redundant: the set, in the order of the spec, and the rest; complete: how
    many any set needs that describes all axes; missing: constant errors that the spec's location errors cannot stand
    for.
    """

    placement: str
    rank: int
    kept: tuple[str, ...]
    redundant: tuple[Redundant, ...]
    complete: int
    missing: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Move:
    """A target point to be moved, mm, in the frame of its body; rank and condition of the whole afterwards."""

    run: str
    carrier: str
    given: tuple[float, float, float]
    moved: tuple[float, float, float]
    rank: int
    condition: float


@dataclass(frozen=True, slots=True)
class Repair:
    """The moves that make a plan as regular as any plan can be, or as regular as candidates make it."""

    moves: tuple[Move, ...]
    others: tuple[Move, ...]
    candidates: str
    regular: bool


@dataclass(frozen=True, slots=True)
class Added:
    """A run proposed: rank of the whole with it and those before; gain: of the logarithm of the determinant."""

    run: str
    what: str
    readings: int
    rank: int
    gain: float


@dataclass(frozen=True, slots=True)
class Proposal:
    """The runs that add most: from how many candidates, of which kind; prior_um: size of the errors expected;
    unknowns, rank, settled, condition, curves, locations: as in the plan, with the runs added.
    """

    added: tuple[Added, ...]
    candidates: str
    prior_um: float
    exchanges: int
    unknowns: int
    rank: int
    settled: int
    condition: float
    curves: tuple[CurveReport, ...]
    locations: tuple[LocationReport, ...]


@dataclass(frozen=True, slots=True)
class PlanReport:
    """Everything. Lengths mm and angles rad unless a name says otherwise.

    unknowns, rank, condition: of the machine's unknowns, rotations scaled by the lever, the instruments' eliminated;
    settled: combinations that the convention settles; blocks_fault: why there is no order of blocks, or empty;
    free_of_order: runs that take no part in it.
    """

    machine: str
    source: str
    runs: int
    readings: int
    degree: int
    noise_um: float
    lever: float
    rank_tolerance: float
    instruments: tuple[InstrumentReport, ...]
    instrument_unknowns: int
    unknowns: int
    rank: int
    settled: int
    condition: float
    convention: str
    blocks: tuple[BlockReport, ...]
    blocks_fault: str
    free_of_order: tuple[str, ...]
    curves: tuple[CurveReport, ...]
    locations: tuple[LocationReport, ...]
    undetermined: tuple[OpenReport, ...]
    location_sets: tuple[LocationSet, ...]
    repair: Repair | None
    proposal: Proposal | None
    notes: tuple[str, ...]

    @property
    def nothing_determined(self) -> bool:
        """Whether the runs determine no error at all."""
        states = [one.state for one in self.curves] + [one.state for one in self.locations]
        return not any(state in ("determined", "by convention", "partly") for state in states)
