"""`trueaxis plan`: a plan judged, runs proposed for it, a first plan from nothing."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.error_name import ErrorName
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.set_up import is_straightness
from trueaxis.estimation.tool_point import Datum
from trueaxis.identification.weighting import NoiseModel
from trueaxis.measurement.instrument_kinds import Instrument
from trueaxis.measurement.setup import Device, Vector
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel
from trueaxis.planning.candidates import Candidate
from trueaxis.planning.judge import expected_with_effects, judge, noise_of_instruments, noise_of_runs, refuse_runs
from trueaxis.planning.kit import LENGTHS, Kit
from trueaxis.planning.location_sets import location_sets
from trueaxis.planning.order import order
from trueaxis.planning.propose import LEAST_FALL, VOLUME, Chosen, Proposal, Wish, by_set_up, for_noise, named, propose
from trueaxis.planning.report import Added, PlanReport, ProposalReport
from trueaxis.planning.runs import PlannedRuns, no_runs

FIRST = "a plan from nothing"


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanOptions:
    """given: error values that are no unknowns; noise: what is known of it; tools: points in the tool frame whose
    uncertainty counts, mm; wanted: what proposed runs are to tell best: VOLUME, a component or a location error;
    datum: against which the tool point is known then; effects: values at which effects are linearised.
    """

    given: ErrorValues
    noise: NoiseModel
    tools: tuple[Vector, ...]
    wanted: str = VOLUME
    datum: Datum = "home"
    effects: tuple[EffectValues, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Proposed:
    """The plan with the runs, their ids new; the runs; the report of them; the estimate to expect from the plan."""

    planned: PlannedRuns
    runs: tuple[Candidate, ...]
    report: ProposalReport
    expected: Estimate


def judged_plan(model: MachineModel, options: PlanOptions, planned: PlannedRuns) -> tuple[PlanReport, Estimate]:
    """Everything that can be said of a plan, proposals apart, and the estimate to expect from it."""
    observed = planned.observed
    noise = noise_of_runs(observed, options.noise)
    found, effects = expected_with_effects(model, observed, options.given, noise, options.effects)
    blocks = order(model.with_values(options.given), observed, options.given)
    report = PlanReport(
        machine=model.name,
        source=observed.source,
        expected=judge(found, planned, noise, options.tools, effects),
        blocks=blocks.blocks() if blocks else (),
        blocks_fault=blocks.fault if blocks else "",
        free_of_order=blocks.left_out if blocks else tuple(run.id for run in observed.runs),
        location_sets=location_sets(model, options.given),
        notes=_travel_notes(model, observed),
    )
    return report, found


def proposed(
    model: MachineModel, options: PlanOptions, planned: PlannedRuns, count: int, instruments: Sequence[Instrument]
) -> Proposed:
    """The `count` runs that add most; instruments: of the candidates, those of the plan where none are named."""
    kit = _kit_of(model, planned.observed, options, instruments)
    wish = _wish(options, kit)

    def goes_on(chosen: Sequence[Chosen]) -> float:
        return np.inf if len(chosen) < count else 0.0

    noise = noise_of_runs(planned.observed, options.noise)
    found = named(propose(model, options.given, planned, noise, kit, wish, goes_on), planned.runs, "added-")
    return _with_report(model, options, planned, noise, found, wish)


def first_plan(
    model: MachineModel, options: PlanOptions, instruments: Sequence[Instrument], hours: float | None
) -> Proposed:
    """Runs for a machine of which nothing is measured, in at most `hours`; None: while a run is worth its time."""
    refuse_runs(options.noise)
    kit = Kit(instruments=tuple(instruments), tools=options.tools)
    wish = _wish(options, kit)

    def goes_on(chosen: Sequence[Chosen]) -> float:
        return np.inf if hours is None else 60.0 * hours - sum(one.minutes for one in chosen)

    least = LEAST_FALL if hours is None else 0.0
    nothing = no_runs(FIRST, model.axes)
    found = named(for_noise(propose(model, options.given, nothing, {}, kit, wish, goes_on, least)), (), "run-")
    return _with_report(model, options, nothing, {}, found, wish)


def _with_report(
    model: MachineModel,
    options: PlanOptions,
    planned: PlannedRuns,
    noise: Mapping[int, float],
    found: Proposal,
    wish: Wish,
) -> Proposed:
    runs = by_set_up([one.candidate for one in found.runs])
    whole = planned.with_added(runs)
    every = {**noise, **{k: wish.noise[one.run.instrument] for k, one in enumerate(runs, len(planned.runs))}}
    after, effects = expected_with_effects(model, whole.observed, options.given, every, options.effects)
    added = tuple(
        Added(
            run=one.candidate.run.id,
            what=one.candidate.what,
            readings=one.candidate.positions.shape[1],
            minutes=one.minutes,
            u=one.u,
        )
        for one in found.runs
    )
    report = ProposalReport(
        wanted=wish.wanted,
        unit=_unit(model, wish.wanted),
        before=found.before,
        candidates=found.count,
        added=added,
        after=judge(after, whole, every, options.tools, effects),
    )
    return Proposed(whole, runs, report, after)


def _kit_of(
    model: MachineModel, observed: Observations, options: PlanOptions, instruments: Sequence[Instrument]
) -> Kit:
    """What the plan has at hand: instruments, bars, their places on the tool."""
    runs = observed.runs
    used = tuple(dict.fromkeys(instruments or (run.instrument for run in runs)))
    lengths = tuple(dict.fromkeys(run.length for run in runs if run.length is not None)) or LENGTHS
    devices: dict[tuple[str, bool], Device] = {}
    on_tool: dict[str, list[Vector]] = {}
    for index, run in enumerate(runs):
        if run.device is not None:
            straight = is_straightness(model, run, observed.positions[:, observed.run == index])
            devices[run.instrument, straight] = run.device
        ends = [end.point for end in (run.target, run.reference) if end.on == "tool"]
        on_tool.setdefault(run.instrument, []).extend(ends)
    points = {instrument: _first_and_farthest(of) for instrument, of in on_tool.items() if of}
    tools = next(iter(points.values()), options.tools)[:1]
    session = runs[-1].session
    return Kit(instruments=used, tools=tools, points=points, lengths=lengths, devices=devices, session=session)


def _first_and_farthest(points: Sequence[Vector]) -> tuple[Vector, ...]:
    """The first place, and that which is farthest from it: of a rotation the others tell less, and all take time."""
    return tuple(dict.fromkeys((points[0], max(points, key=lambda one: math.dist(one, points[0])))))


def _wish(options: PlanOptions, kit: Kit) -> Wish:
    devices: dict[str, Device | None] = {name: kit.device_of(name) for name in kit.instruments}
    noise = noise_of_instruments(devices, options.noise)
    return Wish(wanted=options.wanted, datum=options.datum, tools=options.tools, noise=noise, effects=options.effects)


def _unit(model: MachineModel, wanted: str) -> str:
    if wanted in model.components:
        return ErrorName(wanted).unit
    return model.machine.parameter_unit(wanted) if wanted in model.location_errors else "mm"


def _travel_notes(model: MachineModel, observed: Observations) -> tuple[str, ...]:
    """Axes that are measured over a part of their travel only."""
    notes = []
    for axis, positions in zip(model.axes, observed.positions, strict=True):
        low, high = model.travel[axis]
        first, last = float(positions.min()), float(positions.max())
        if last - first < 1e-6:
            notes.append(f"{axis} is not moved")
        elif first > low + 1e-6 or last < high - 1e-6:
            notes.append(f"{axis} is measured from {first:g} to {last:g} of its travel {low:g} to {high:g}")
    return tuple(notes)
