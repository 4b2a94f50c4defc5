"""`trueaxis plan`: what a set of runs will tell, before a reading is taken: of errors, of effects, of the tool point.

The noise that it is judged for is as given, as the device's table states it, else a round figure.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from trueaxis.effects.kind import Effect, Kind
from trueaxis.estimation.combinations import combinations
from trueaxis.estimation.effects.planned import planned_effects
from trueaxis.estimation.effects.unknowns import unit_in
from trueaxis.estimation.expected import expected
from trueaxis.estimation.judgement import TENTH, Judged, judged_component, judged_location
from trueaxis.estimation.observations import Observations, pure_error
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.tool_point import tool_point, tool_summary
from trueaxis.identification.estimated_effects import covariance_with_effects, with_uncertainty
from trueaxis.identification.weighting import NoiseModel, weighting
from trueaxis.io.faults import Fault, InputError
from trueaxis.measurement.instrument_kinds import ANGLE, INSTRUMENTS, small_unit
from trueaxis.measurement.setup import Device, Vector
from trueaxis.model.effect_values import EffectValues, identity
from trueaxis.model.errors import ErrorValues
from trueaxis.model.grid import Slice
from trueaxis.model.model import MachineModel
from trueaxis.model.volume import middle_planes
from trueaxis.planning.report import ErrorReport, Expectations, ExpectedEffect, ExpectedParameter, NoiseReport
from trueaxis.planning.runs import PlannedRuns, minutes

STEPS = 25  # along either side of a slice
DEFAULT_UM = 1.0  # what lasers, ball bars and probes scatter by in a shop, and in urad angular optics and levels


def judge(
    found: Estimate,
    planned: PlannedRuns,
    noise: Mapping[int, float],
    tools: Sequence[Vector],
    effects: tuple[ExpectedEffect, ...],
) -> Expectations:
    """What is to be expected of runs. found: the estimate that they let expect; noise: of every run, by index, mm;
    tools: points in the tool frame whose uncertainty counts, mm; effects: what is to be expected of them.
    """
    observed = planned.observed
    return Expectations(
        tool=tool_summary(found, tools, covariance_with_effects(found)),
        components=_components(found),
        locations=_locations(found),
        effects=effects,
        combinations=combinations(found, [run.id for run in observed.runs]),
        noise=_noise(observed, noise),
        runs=len(planned.runs),
        readings=observed.reading.size,
        unknowns=found.layout.of_machine,
        freedom=found.readings.freedom,
        minutes=minutes(planned.paths),
    )


def _components(found: Estimate) -> tuple[ErrorReport, ...]:
    level, layout = found.levelled(), found.layout
    return tuple(
        _error(name, name.unit, judged_component(level, name) if name in layout.components else None)
        for name in layout.model.components
    )


def _locations(found: Estimate) -> tuple[ErrorReport, ...]:
    level, layout = found.levelled(), found.layout
    return tuple(
        _error(
            name,
            layout.model.machine.parameter_unit(name),
            judged_location(level, name) if name in layout.locations else None,
        )
        for name in layout.model.location_errors
    )


def _error(name: str, unit: str, judged: Judged | None) -> ErrorReport:
    if judged is None:
        return ErrorReport(name=name, state="given", unit=unit)
    return ErrorReport(
        name=name, state=judged.determined, unit=unit, u=judged.u, u_rms=judged.u_rms, prior=judged.prior_rms,
        u_readings=judged.u_readings_rms, u_prior=judged.u_prior_rms,
    )  # fmt: skip


def _noise(observed: Observations, noise: Mapping[int, float]) -> tuple[NoiseReport, ...]:
    names = sorted({run.instrument for run in observed.runs})
    group = np.array([names.index(run.instrument) for run in observed.runs], dtype=np.int64)[observed.run]
    _, freedom = pure_error(observed, group, len(names))
    found = []
    for place, name in enumerate(names):
        um = [1e3 * noise[index] for index in noise if observed.runs[index].instrument == name]
        found.append(
            NoiseReport(
                instrument=name,
                runs=sum(run.instrument == name for run in observed.runs),
                readings=int((group == place).sum()),
                um=(min(um, default=0.0), max(um, default=0.0)),
                freedom=int(freedom[place]),
                unit=small_unit(name),
            )
        )
    return tuple(found)


def expected_with_effects(
    model: MachineModel,
    observed: Observations,
    given: ErrorValues,
    noise: Mapping[int, float],
    values: Sequence[EffectValues],
) -> tuple[Estimate, tuple[ExpectedEffect, ...]]:
    """The estimate to expect, effects of the spec among its unknowns, and a report of them, in the order of the spec.

    noise: of every run, by index, mm; values: at which effects are linearised, see `planned_effects`. A squareness is
    a location error.
    """
    planned = planned_effects(model, observed, given, values)
    found = expected(model, observed, given, noise, planned.unknowns)
    stated = {identity(one.effect) for one in values}
    reports = []
    for effect in model.effects:
        kind = model.kinds[effect.kind]
        if kind.place == "location":
            continue
        if effect in planned.lacking:
            reports.append(ExpectedEffect(effect=effect.label, state="lacking", missing=planned.lacking[effect]))
        elif any(one.effect == effect for one in planned.unknowns.members):
            reports.append(_told(found, effect, kind, stated=identity(effect) in stated))
        else:
            reports.append(ExpectedEffect(effect=effect.label, state="given"))
    return found, tuple(reports)


def _told(found: Estimate, effect: Effect, kind: Kind, *, stated: bool) -> ExpectedEffect:
    values = next(one for one in with_uncertainty(found.values, found).effects if one.effect == effect)
    u = [values.u.get(one.name, np.nan) for one in kind.parameters]
    parameters = tuple(
        ExpectedParameter(
            name=one.name,
            value=values.parameters[one.name],
            u=None if np.isnan(own) else own,
            unit=unit_in(one.unit, effect),
            role=one.role,
        )
        for one, own in zip(kind.parameters, u, strict=True)
    )
    if all(one.u is None for one in parameters):
        return ExpectedEffect(effect=effect.label, state="silent", parameters=parameters, stated=stated)
    return ExpectedEffect(
        effect=effect.label,
        state="errors" if _among_errors(found, effect) else "data",
        parameters=parameters,
        stated=stated,
    )


def _among_errors(found: Estimate, effect: Effect) -> bool:
    """Whether u of the amplitudes would be a tenth or less if the errors of the machine were known."""
    effects, first = found.layout.effects, found.layout.of_effects.start
    (place,) = (k for k, one in enumerate(effects.members) if one.effect == effect)
    member, mine = effects.members[place], effects.slices()[place]
    start = first + mine.start
    spread = found.spread[start : start + member.count - len(member.free)]
    of_errors, _ = np.linalg.qr(found.spread[: found.layout.of_machine].T)
    beside = spread - (spread @ of_errors) @ of_errors.T
    return bool(np.linalg.norm(beside) < TENTH * np.linalg.norm(spread))


def slices(found: Estimate, tools: Sequence[Vector]) -> tuple[Slice, ...]:
    """One of u for each pair of linear axes, other linear axes in the middle, rotary axes at home."""
    return tuple(
        one.slice(tool_point(found, one.positions, tools).u) for one in middle_planes(found.layout.model, STEPS)
    )


def noise_of_runs(observed: Observations, stated: NoiseModel) -> dict[int, float]:
    """Standard deviation of the readings of every run, by index, mm: stated for the run or its instrument, else as of a
    plan that states none. Raises InputError for names that are no run and no instrument.
    """
    runs = [(int(index), observed.runs[index]) for index in np.unique(observed.run)]
    found = {index: _of_device(run.instrument, run.device, stated) for index, run in runs}
    if not stated.by_group:
        return found
    silent = [(index, run) for index, run in runs if not {run.id, run.instrument} & stated.by_group.keys()]
    filled = {run.id: 1e3 * found[index] for index, run in silent if run.instrument != ANGLE}
    angles = [1e3 * found[index] for index, run in runs if run.instrument == ANGLE]
    whole = replace(stated, by_group={**stated.by_group, **filled}, urad=stated.urad or next(iter(angles), None))
    weights = weighting(observed, whole)
    assert weights.sigma is not None
    each = weights.sigma / weights.roots
    named = {index: float(each[observed.run == index][0]) for index, _ in runs}
    return {**named, **{index: found[index] for index, _ in silent}}


def noise_of_instruments(devices: Mapping[str, Device | None], stated: NoiseModel) -> dict[str, float]:
    """Standard deviation of the readings of new runs, by instrument, mm: stated for it, else as of a plan that states
    none. devices: by instrument, where they are known.
    """
    return {
        name: 1e-3 * stated.by_group[name]
        if name in stated.by_group and name != ANGLE
        else _of_device(name, device, stated)
        for name, device in devices.items()
    }


def refuse_runs(stated: NoiseModel) -> None:
    """Raise InputError where the noise of a first plan names what is no instrument: it has no runs yet."""
    wrong = [name for name in stated.by_group if name not in INSTRUMENTS or name == ANGLE]
    right = ", ".join(name for name in INSTRUMENTS if name != ANGLE)
    if wrong:
        raise InputError([Fault("--noise-um", name, "is no instrument of lengths", right) for name in wrong])


def _of_device(instrument: str, device: Device | None, stated: NoiseModel) -> float:
    """Standard deviation, mm; of an angle at ARM, where a microradian is a micrometre."""
    given = stated.urad if instrument == ANGLE else stated.um
    if given is not None:
        return 1e-3 * given
    return device.noise if device is not None and device.noise is not None else 1e-3 * DEFAULT_UM
