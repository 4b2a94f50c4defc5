"""The report on an estimate: what determines its values, instruments, noise, and what to know besides."""

from collections.abc import Mapping

import numpy as np

from trueaxis.error_name import ErrorName
from trueaxis.estimation.judgement import NINE_TENTHS, Judged, open_counts
from trueaxis.estimation.machine import lever
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.runs import noise_groups
from trueaxis.identification.estimated_effects import effect_reports
from trueaxis.identification.fit_quality import FitQuality
from trueaxis.identification.notes import dimension_notes, estimate_notes
from trueaxis.identification.report import (
    ComponentReport,
    IdentificationReport,
    InstrumentReport,
    Known,
    LocationReport,
    NoiseGroupReport,
)
from trueaxis.identification.tips import tip_notes
from trueaxis.identification.words import DETERMINED_BY, enumerated, level_rule
from trueaxis.measurement.columns import BoolArray
from trueaxis.measurement.instrument_kinds import small_unit
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.readings import angle_rows
from trueaxis.model.errors import Determined, ErrorValues
from trueaxis.model.model import MachineModel

KNOWN: dict[Determined, Known] = {"data": "determined", "partly": "partly", "prior": "undetermined"}
ORIGINS: dict[bool, dict[Determined, str]] = {
    True: DETERMINED_BY,
    False: {"data": DETERMINED_BY["data"], "partly": "partly open", "prior": "open: zero"},
}


def estimated_report(
    model: MachineModel,
    observed: Observations,
    found: Estimate,
    values: ErrorValues,
    given: ErrorValues,
    *,
    components: Mapping[ErrorName, Judged],
    locations: Mapping[str, Judged],
    judged: FitQuality,
    remedies: tuple[str, ...],
    squareness: str,
    prior: bool,
) -> IdentificationReport:
    """values: as they are written; given: those that were taken as they are; components, locations: by what those that
    were estimated are determined; remedies: of a noise that is stated wrong; squareness: what parts it from
    straightness; prior: whether anything was expected.
    """
    good = ~found.readings.outliers
    unit = {name: model.machine.parameter_unit(name) for name in model.location_errors}
    scale = np.array([found.noise.scale_of_run.get(index, np.nan) for index in range(len(observed.runs))])
    sigma = {name: one.sigma for name, one in found.noise.of_group.items()}
    each = np.array([sigma.get(group, np.nan) for group in noise_groups(observed.runs)]) * scale
    angle = angle_rows(observed.run, observed.runs)
    rms = _rms(found.readings.residual, good & ~angle), _rms(found.readings.residual, good & angle)
    noise = _rms(each[observed.run], ~angle), _rms(each[observed.run], angle)
    return IdentificationReport(
        machine=model.name,
        method="global",
        squareness=level_rule(model.axes) if squareness == "convention" else "given",
        readings=observed.reading.size,
        left_out=(),
        lever=lever(model),
        rank_tolerance=0.0,
        blocks=(),
        iterations=found.iteration.rounds + found.iteration.steps,
        last_change=found.iteration.last_change,
        residual_rms_um=np.nan if rms[0] is None else rms[0],
        residual_rms_urad=rms[1],
        freedom=int(found.readings.freedom),
        noise_um=np.nan if noise[0] is None else noise[0],
        noise_urad=noise[1],
        noise_origin=_noise_origin(found),
        locations=tuple(
            _location(found, name, locations.get(name), unit[name], prior) for name in model.location_errors
        ),
        components=tuple(_component(name, components.get(name), prior) for name in model.components),
        undetermined=values.undetermined,
        quality=judged,
        instruments=_instruments(observed, found),
        noise_groups=_noise_groups(observed, found),
        effects=effect_reports(values, found),
        outliers=int(found.readings.outliers.sum()),
        notes=(*remedies, *estimate_notes(model, observed, found, given, prior=prior)),
        caveats=(*dimension_notes(model, given), *tip_notes(found.layout.model, observed)),
    )


def _rms(values: FloatArray, rows: BoolArray) -> float | None:
    """Root mean square of some readings, um (of angles urad); None where there are none."""
    return 1e3 * float(np.sqrt(np.mean(values[rows] ** 2))) if rows.any() else None


def _location(found: Estimate, name: str, judged: Judged | None, unit: str, prior: bool) -> LocationReport:
    value = found.values.parameters.get(name, 0.0)
    if judged is None:
        return LocationReport(name=name, value=value, u=None, unit=unit, origin="given")
    return LocationReport(
        name=name,
        value=value,
        u=_known(judged.u),
        unit=unit,
        origin=ORIGINS[prior][judged.determined],
        u_readings=judged.u_readings_rms if prior else None,
        u_prior=judged.u_prior_rms if prior else None,
        prior=judged.prior_rms if prior else None,
    )


def _known(u: float) -> float | None:
    return u if np.isfinite(u) else None


def _component(name: ErrorName, judged: Judged | None, prior: bool) -> ComponentReport:
    if judged is None:
        return ComponentReport(name=name, known="given", largest=0.0, u=None, unit=name.unit)
    return ComponentReport(
        name=name,
        known=KNOWN[judged.determined],
        largest=judged.largest,
        u=_known(judged.u),
        unit=name.unit,
        at=judged.at,
        u_there=_known(judged.u_there),
        u_readings_rms=judged.u_readings_rms if prior else None,
        u_prior_rms=judged.u_prior_rms if prior else None,
        prior_rms=judged.prior_rms if prior else None,
        origin=ORIGINS[prior][judged.determined],
    )


def _instruments(observed: Observations, found: Estimate) -> tuple[InstrumentReport, ...]:
    layout = found.layout
    u = np.linalg.norm(found.spread, axis=1)
    silent = (u > NINE_TENTHS * found.scale) | open_counts(np.linalg.norm(found.open, axis=1), u)
    reports = []
    for place, unknown in enumerate(layout.shared, layout.of_machine):
        if silent[place]:
            continue
        runs = ", ".join(observed.runs[index].id for index in unknown.runs)
        value, unit = float(found.unknowns[place]), unknown.unknown_class.unit
        reports.append(
            InstrumentReport(name=f"{unknown.label} ({runs})", value=value, u=float(u[place]), unit=unit, origin="")
        )
    return tuple(reports)


def _noise_origin(found: Estimate) -> str:
    estimated = sorted(found.noise.of_group.keys() - found.noise.stated)
    if not estimated:
        return "stated"
    which = f" of {enumerated(estimated)}" if found.noise.stated else ""
    return f"estimated with the errors{which}, by restricted maximum likelihood"


def _noise_groups(observed: Observations, found: Estimate) -> tuple[NoiseGroupReport, ...]:
    """Of every group of runs with one noise; what of it is slow."""
    groups, of_run = [], noise_groups(observed.runs)
    for name, one in found.noise.of_group.items():
        scales = [scale for index, scale in found.noise.scale_of_run.items() if of_run[index] == name]
        size = one.sigma * float(np.sqrt(np.mean(np.square(scales)))) * 1e3
        slow = f" (slow part {one.slow * 1e3:.3g})" if one.slow > 0.0 else ""
        told = " (stated)" if name in found.noise.stated else slow
        stated, unit = name in found.noise.stated, small_unit(observed.runs[of_run.index(name)].instrument)
        groups.append(NoiseGroupReport(group=name + told, noise_um=size, unit=unit, instrument=name, stated=stated))
    return tuple(groups)
