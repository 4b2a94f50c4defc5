"""The effects of a machine in the global fit: which are unknown, where the fit starts, which instrument gives way."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.effects.kind import Effect, Kind
from trueaxis.estimation.effects.amplitudes import searched_names
from trueaxis.estimation.effects.faults import check_columns
from trueaxis.estimation.effects.search import WhitenedRun, searched_start
from trueaxis.estimation.effects.signature import RunRows, all_rows, ground_of
from trueaxis.estimation.effects.unknowns import EffectUnknown, EffectUnknowns, member_at, sized
from trueaxis.estimation.machine import IdentifiedMachine, IntArray
from trueaxis.estimation.observations import Observations
from trueaxis.identify.global_fit.design import Design
from trueaxis.identify.global_fit.instruments import Instruments
from trueaxis.identify.global_fit.layout import Layout, layout
from trueaxis.identify.global_fit.least_squares import RANK_TOLERANCE, ROUNDING, Factors, Gauge, factors, gauge
from trueaxis.identify.global_fit.robust import scale_of, weights
from trueaxis.identify.global_fit.solve import CONVERGED, Solution, solve, solve_curved
from trueaxis.identify.null_space import reduced
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.effect_values import EffectValues, identity
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import MachineModel

NEARLY = 1e-7  # mm: last change of a fit that others start from
Degree = int | Mapping[str, int]


@dataclass(frozen=True, slots=True, eq=False)
class Setting:
    """What every fit of one identification shares; level: whether straightness is levelled."""

    machine: IdentifiedMachine
    observed: Observations
    given: ErrorValues
    instruments: Instruments
    roots: FloatArray
    level: bool

    def design(self, degree: Degree, effects: EffectUnknowns) -> Design:
        """With components of a degree."""
        plan = layout(self.machine, self.observed, self.given, degree, self.instruments, effects)
        return Design(plan, self.observed, self.roots)

    def solved(
        self,
        design: Design,
        found: Factors | None = None,
        moved: Gauge | None = None,
        start: FloatArray | None = None,
        tolerance: float = CONVERGED,
        least: float = RANK_TOLERANCE,
    ) -> Solution:
        """Least squares; found, moved: factors and gauge of the design, where they are there already; start: (n,);
        tolerance: of the last change where columns change, mm; least: relative singular value that counts.
        """
        if design.layout.effects.curved:
            start = start_of(design) if start is None else start
            return solve_curved(design, self.given, self.level, start, tolerance)
        found = found or factors(design.triangle()[0], least)
        moved = moved or gauge(design.layout, found.null, self.level)
        return solve(design, found, moved, self.given, start)


@dataclass(frozen=True, slots=True, eq=False)
class Unknown:
    """The effects whose parameters are sought: those that the fit may start with at once, and those that need a fit of
    the others before.
    """

    at_once: EffectUnknowns
    waiting: tuple[tuple[Effect, Kind], ...] = ()

    @property
    def observed(self) -> Observations | None:
        """The readings, nothing of their context unknown; None where the machine has no effects."""
        return None if self.at_once.ground is None else self.at_once.ground.observed


def unknown_effects(
    machine: IdentifiedMachine, observed: Observations, given: ErrorValues, start: Sequence[EffectValues]
) -> Unknown:
    """The effects of the machine whose values are not given; a squareness is unknown as the location error it adds.

    start: values to start with, which spares a search.

    Raises InputError where the readings lack a column that an effect depends on.
    """
    if not isinstance(machine, MachineModel) or not machine.machine.effects:
        return Unknown(EffectUnknowns())
    ground, kinds = ground_of(machine, observed), machine.machine.kinds
    chosen = all_rows(observed, ground)
    check_columns(ground, [(effect, kinds[effect.kind]) for effect in machine.machine.effects], chosen)
    ground = ground_of(machine, replace(observed, context=ground.context.filled()))
    known = {identity(one.effect) for one in given.effects}
    starts = {identity(one.effect): one for one in start}
    at_once, waiting = [], []
    for effect in machine.machine.effects:
        kind, own = kinds[effect.kind], starts.get(identity(effect))
        if identity(effect) in known or kind.place == "location":
            continue
        if own is not None and kind.place != "point":
            at_once.append(sized(member_at(effect, kind, own.parameters), ground, chosen))
        elif searched_names(kind) or kind.place == "point":
            waiting.append((effect, kind))
        else:
            at_once.append(sized(_zero(effect, kind), ground, chosen))
    return Unknown(EffectUnknowns(tuple(at_once), ground), tuple(waiting))


def with_locations(machine: IdentifiedMachine, given: ErrorValues) -> ErrorValues:
    """The values with those that effects give to location errors among the parameters: told once, not twice."""
    if not isinstance(machine, MachineModel):
        return given
    told = [one for one in given.effects if machine.kinds[one.effect.kind].place == "location"]
    angles = {one.effect.component or "": float(one.vector(machine.kinds[one.effect.kind])[0]) for one in told}
    left = tuple(one for one in given.effects if one not in told)
    return replace(given, parameters={**given.parameters, **angles}, effects=left)


def started(setting: Setting, degree: Degree, unknown: Unknown) -> EffectUnknowns:
    """All effects with values to start from: those that wait are started one after another, beside the others.

    Where several are searched, each one is searched once more beside all others.
    """
    found = unknown.at_once
    for effect, kind in unknown.waiting:
        found = _with(setting, degree, found, effect, kind)
    searched = [(effect, kind) for effect, kind in unknown.waiting if searched_names(kind)]
    for effect, kind in searched if len(searched) > 1 else []:
        others = tuple(one for one in found.members if one.effect != effect)
        found = _with(setting, degree, replace(found, members=others), effect, kind)
    return found


def trimmed(setting: Setting, degree: Degree, unknown: Unknown) -> Setting:
    """The setting for a robust start: readings that lie far off a fit of what starts at once hardly count.

    Where columns change with the values, a few of them would lead a plain fit astray before it is reweighted.
    """
    if not unknown.waiting:
        return setting
    z = setting.roots * setting.solved(setting.design(degree, unknown.at_once), tolerance=NEARLY).residual
    scale = scale_of(z)
    return replace(setting, roots=setting.roots * np.sqrt(weights(z / scale, "tukey"))) if scale else setting


def start_of(design: Design) -> FloatArray:
    """(n_unknowns,): scaled unknowns with the effects where they are linearised, all else zero."""
    plan = design.layout
    start = np.zeros(plan.count)
    start[plan.of_effects] = plan.effects.scaled
    return start


def with_way_given(instruments: Instruments, unknown: Unknown, observed: Observations) -> Instruments:
    """Without the unknowns of instruments that could take the place of effects: the spec names what is off."""
    ground = unknown.at_once.ground
    if ground is None or not instruments.count:
        return instruments
    points = [_zero(effect, kind) for effect, kind in unknown.waiting if kind.place == "point"]
    readings = [one for one in unknown.at_once.members if one.kind.place == "reading"]
    members = EffectUnknowns((*readings, *points), ground)
    if not members.count:
        return instruments
    pieces = [
        np.hstack([members.columns(rows), _of_instruments(instruments, observed, ground.model, rows)])
        for rows in all_rows(observed, ground)
    ]
    columns = np.vstack(pieces)
    size = np.abs(columns).max(axis=0)
    told = np.flatnonzero(size > 0.0)
    null = factors(columns[:, told] / size[told]).null
    led = np.flatnonzero(told < members.count)
    basis, count = reduced(null, led.tolist(), ROUNDING)
    shared = told[(np.abs(basis[:, :count]) > ROUNDING).any(axis=1)] - members.count
    kept = [one for place, one in enumerate(instruments.unknowns) if place not in shared]
    return Instruments(tuple(kept))


def below_zero(plan: Layout, unknowns: FloatArray) -> tuple[EffectUnknown, ...]:
    """Effects whose term is proportional to a square that came out negative; unknowns: (n,), scaled."""
    values = (unknowns * plan.scale)[plan.of_effects]
    return tuple(
        one
        for one, mine in zip(plan.effects.members, plan.effects.slices(), strict=True)
        if any(parameter.role == "root" for parameter in one.kind.parameters)
        and (values[mine][: one.count - len(one.free)] < 0.0).any()
    )


def with_zeros(given: ErrorValues, members: Sequence[EffectUnknown]) -> ErrorValues:
    """What is given, and effects that are zero."""
    zeros = []
    for one in members:
        searched = one.searched(one.values)
        parameters = {each.name: searched.get(each.name, 0.0) for each in one.kind.parameters}
        zeros.append(EffectValues(one.effect, parameters))
    return replace(given, effects=(*given.effects, *zeros))


def _with(setting: Setting, degree: Degree, found: EffectUnknowns, effect: Effect, kind: Kind) -> EffectUnknowns:
    """The effects and one more, at values that go with a fit of the others."""
    design = setting.design(degree, found)
    solution = setting.solved(design, tolerance=NEARLY)
    plan, values = design.layout, solution.unknowns * design.layout.scale
    found = plan.effects.at(values[plan.of_effects], plan.values(values, setting.given))
    assert found.ground is not None
    if kind.place == "point":
        member = _zero(effect, kind)
    else:
        design = design.at(solution.unknowns, setting.given)
        fitted = factors(design.triangle()[0])
        root = fitted.vectors / fitted.singular

        def others() -> Iterator[WhitenedRun]:
            for rows, piece in design.pieces():

                def whiten(columns: FloatArray, rows: IntArray = rows) -> FloatArray:
                    return np.asarray(columns * setting.roots[rows, np.newaxis])

                yield WhitenedRun(
                    index=int(setting.observed.run[rows[0]]),
                    rows=rows,
                    whiten=whiten,
                    own=np.zeros((rows.size, 0)),
                    others=piece @ root,
                    residual=setting.roots[rows] * solution.residual[rows],
                )

        member = searched_start(found.ground, effect, kind, others)
    member = sized(member, found.ground, all_rows(setting.observed, found.ground))
    machine = found.ground.model.machine
    order = [identity(one) for one in machine.effects]
    members = sorted((*found.members, member), key=lambda one: order.index(identity(one.effect)))
    return replace(found, members=tuple(members))


def _zero(effect: Effect, kind: Kind) -> EffectUnknown:
    return member_at(effect, kind, {one.name: 0.0 for one in kind.parameters})


def _of_instruments(
    instruments: Instruments, observed: Observations, machine: IdentifiedMachine, chosen: RunRows
) -> FloatArray:
    return instruments.columns(machine, observed.runs, chosen.index, observed.positions[:, chosen.rows])
