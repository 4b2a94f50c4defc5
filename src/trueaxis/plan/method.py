"""`trueaxis plan`: what a set of runs can and cannot determine, and in which order."""

from dataclasses import dataclass, field

import numpy as np

from trueaxis.estimation.machine import IdentifiedMachine, lever
from trueaxis.estimation.observations import Observations
from trueaxis.identify.global_fit.design import Design
from trueaxis.identify.global_fit.layout import layout
from trueaxis.identify.global_fit.least_squares import RANK_TOLERANCE
from trueaxis.identify.notes import dimension_notes
from trueaxis.measure.readings import Readings
from trueaxis.measure.setup import Run
from trueaxis.plan import expected
from trueaxis.plan.combinations import settled_and_seen, undetermined
from trueaxis.plan.convention import Settled, settle
from trueaxis.plan.instruments import IDEAL, KNOWN, Assumptions, Unknowns, instrument_unknowns
from trueaxis.plan.location_sets import location_sets
from trueaxis.plan.order import order
from trueaxis.plan.report import InstrumentReport, PlanReport
from trueaxis.plan.system import System, system
from trueaxis.runtime.errors import ErrorValues

CONVENTION_TEXT = (
    "least-squares lines of the straightness are level (ISO 230-1), end-point lines beside it; it splits "
    "straightness from squareness where readings do not"
)
PRIOR_UM = 50.0  # of a scaled unknown: errors of machines before compensation are of this size


@dataclass(frozen=True, slots=True)
class PlanOptions:
    """noise_um: standard deviation of a reading, micrometres; degree: highest power of a component's polynomial;
    known: values given beforehand.
    """

    noise_um: float = 1.0
    degree: int = 7
    assumed: Assumptions = field(default_factory=Assumptions)
    known: ErrorValues | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Plan:
    """A plan with its equations; `settled` by least-squares lines; given: values known beforehand."""

    machine: IdentifiedMachine
    observed: Observations
    options: PlanOptions
    given: ErrorValues
    system: System
    settled: Settled

    @property
    def noise(self) -> float:
        """Standard deviation of a reading, mm."""
        return self.options.noise_um * 1e-3

    @property
    def ridge(self) -> float:
        """What is expected of a scaled unknown beforehand, as information in units of that of a reading."""
        return (self.options.noise_um / PRIOR_UM) ** 2


def planned(source: str, runs: tuple[Run, ...], readings: Readings) -> Observations:
    """Every row of a plan, whether it has a reading or not."""
    return Observations(source, runs, readings.run, readings.positions, np.zeros(readings.run.size))


def plan_of(machine: IdentifiedMachine, observed: Observations, options: PlanOptions) -> Plan:
    """Set up the equations of a plan."""
    given = options.known or ErrorValues(machine.name)
    machine = machine.with_values(given)
    unknowns = instrument_unknowns(machine, observed, options.assumed)
    named = frozenset([*given.motion_errors, *given.parameters])
    whole = system(Design(layout(machine, observed, given, options.degree), observed), unknowns, named)
    return Plan(machine, observed, options, given, whole, settle(whole.layout, whole.factors.null, "least-squares"))


def judge(plan: Plan) -> PlanReport:
    """Everything that can be said of a plan, proposals apart."""
    whole, settled, machine = plan.system, plan.settled, plan.machine
    by_ends = settle(whole.layout, whole.factors.null, "end-point")
    spread = expected.covariance(whole, settled, plan.noise)
    spread_by_ends = expected.covariance(whole, by_ends, plan.noise)
    blocks = order(machine, plan.observed, plan.given)
    return PlanReport(
        machine=machine.name,
        source=plan.observed.source,
        runs=len(plan.observed.runs),
        readings=plan.observed.reading.size,
        degree=plan.options.degree,
        noise_um=plan.options.noise_um,
        lever=lever(machine),
        rank_tolerance=RANK_TOLERANCE,
        instruments=_instruments(plan.observed.runs, whole.unknowns, plan.options.assumed),
        instrument_unknowns=whole.instruments,
        unknowns=whole.layout.count,
        rank=whole.factors.rank,
        settled=settled_and_seen(whole, settled).shape[1],
        condition=whole.factors.condition,
        convention=CONVENTION_TEXT,
        blocks=blocks.blocks() if blocks else (),
        blocks_fault=blocks.fault if blocks else "",
        free_of_order=blocks.left_out if blocks else tuple(run.id for run in plan.observed.runs),
        curves=expected.curves(whole, settled, spread),
        locations=expected.locations(whole, settled, spread, spread_by_ends),
        undetermined=undetermined(whole, settled, blocks),
        location_sets=location_sets(machine, plan.given),
        repair=None,
        proposal=None,
        notes=(*dimension_notes(machine, plan.given), *_travel_notes(plan)),
    )


def _instruments(
    runs: tuple[Run, ...], unknowns: tuple[Unknowns, ...], assumed: Assumptions
) -> tuple[InstrumentReport, ...]:
    """What was assumed of all runs: those with unknowns, then the rest."""
    found: dict[str, tuple[list[str], int]] = {}
    for one in unknowns:
        ids, count = found.setdefault(one.kind, ([], 0))
        found[one.kind] = (ids + [runs[index].id for index in one.runs], count + one.columns.shape[1])
    exact = [run.id for index, run in enumerate(runs) if not any(index in one.runs for one in unknowns)]
    if exact:
        found[IDEAL if assumed.ideal else KNOWN] = (exact, 0)
    return tuple(InstrumentReport(tuple(ids), kind, count) for kind, (ids, count) in found.items())


def _travel_notes(plan: Plan) -> tuple[str, ...]:
    """Axes that are measured over a part of their travel only."""
    notes = []
    for axis, knots in zip(plan.machine.axes, plan.system.layout.knots, strict=True):
        low, high = plan.machine.travel[axis]
        if knots.size < 2:
            notes.append(f"{axis} is not moved")
        elif knots[0] > low + 1e-6 or knots[-1] < high - 1e-6:
            notes.append(f"{axis} is measured from {knots[0]:g} to {knots[-1]:g} of its travel {low:g} to {high:g}")
    return tuple(notes)
