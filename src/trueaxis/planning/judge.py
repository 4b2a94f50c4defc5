"""`trueaxis plan`: what a set of runs will tell, before a reading is taken."""

from collections.abc import Mapping, Sequence

import numpy as np

from trueaxis.estimation.combinations import combinations
from trueaxis.estimation.judgement import Judged, judged_component, judged_location
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.repeats import pure_error
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.tool_point import tool_summary
from trueaxis.identification.estimated_effects import covariance_with_effects
from trueaxis.measurement.instrument_kinds import small_unit
from trueaxis.measurement.setup import Vector
from trueaxis.planning.measuring_time import minutes
from trueaxis.planning.report import ErrorReport, Expectations, ExpectedEffect, NoiseReport
from trueaxis.planning.runs import PlannedRuns


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
        name=name, state=judged.determined, unit=unit, u=judged.u, u_rms=judged.u_rms, prior=judged.prior_rms
    )


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
