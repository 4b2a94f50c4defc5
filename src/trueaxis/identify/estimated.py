"""`identify --method global`: the estimate of all errors from all readings, as values, covariance and report."""

from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from trueaxis.estimation.combinations import combinations
from trueaxis.estimation.curve_prior import DEGREE
from trueaxis.estimation.estimate import Estimate, NothingHeldError, estimate
from trueaxis.estimation.first_order import sensed
from trueaxis.estimation.judgement import NINE_TENTHS, Judged, judged_component, judged_location, open_counts
from trueaxis.estimation.machine import lever
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.repeats import copied_runs
from trueaxis.estimation.tool_point import tool_summary
from trueaxis.faults import Fault, InputError
from trueaxis.identify.estimated_effects import covariance_with_effects, effect_reports, with_uncertainty
from trueaxis.identify.fit_quality import (
    FitQuality,
    NotConvergedError,
    Residuals,
    expected_sizes,
    known_noise,
    quality,
    run_residuals,
    with_reversed,
)
from trueaxis.identify.notes import dimension_notes, estimate_notes
from trueaxis.identify.report import (
    ComponentReport,
    Identification,
    IdentificationReport,
    InstrumentReport,
    Known,
    LocationReport,
    NoiseGroupReport,
)
from trueaxis.identify.weighting import NoiseModel, weighting
from trueaxis.identify.words import enumerated, unit_of
from trueaxis.runtime.curves import Curve, LegendreCurve
from trueaxis.runtime.effect_values import EffectValues
from trueaxis.runtime.errors import Determined, ErrorValues, Undetermined
from trueaxis.runtime.model import MachineModel

Choice = Literal["convention", "known"]
KNOWN: dict[Determined, Known] = {"data": "determined", "partly": "partly", "prior": "undetermined"}
ORIGINS: dict[Determined, str] = {
    "data": "from the readings",
    "partly": "from the readings and the prior",
    "prior": "undetermined: from the prior alone",
}
SILENT = {
    True: "the readings do not determine them; values and u are those of [prior]",
    False: "the readings leave combinations of them open, which are zero here",
}
ORIGIN = (0.0, 0.0, 0.0)  # of the tool frame: the tool point that the report is about
RULES = {"convention": "least-squares lines of the straightness are level (ISO 230-1)", "known": "given"}


@dataclass(frozen=True, slots=True)
class EstimateOptions:
    """squareness: what parts it from straightness; known: values taken as they are, dimensions too; noise: what is
    known of it; start, prior, ideal, degree: as `estimate` takes them.
    """

    squareness: Choice = "convention"
    known: ErrorValues | None = None
    noise: NoiseModel = field(default_factory=NoiseModel)
    start: tuple[EffectValues, ...] = ()
    prior: bool = True
    ideal: bool = False
    degree: int = DEGREE


def identify_estimated(model: MachineModel, observed: Observations, options: EstimateOptions) -> Identification:
    """Values, report and covariance.

    Raises InputError where no reading holds an error, or where the noise that is given does not fit the runs;
    NotConvergedError where the estimate does not stand still.
    """
    given = _as_known(options.known or ErrorValues(model.name))
    if options.squareness == "known":
        zeros = dict.fromkeys(model.location_errors, 0.0)
        given = replace(given, parameters={**zeros, **given.parameters})
    noise = _given_noise(observed, options.noise)
    try:
        found = estimate(
            model,
            observed,
            given,
            noise,
            options.start,
            prior=options.prior,
            ideal=options.ideal,
            degree=options.degree,
        )
    except NothingHeldError as error:
        remedy = "runs that move an axis, or fewer values in --known"
        raise InputError([Fault(observed.source, "", str(error), remedy)]) from error
    residuals = _residuals(model, observed, found, noise)
    if not found.converged:
        raise NotConvergedError(run_residuals(residuals, observed.runs), found.rounds + found.steps)
    surest = sorted(found.reversed, key=lambda index: -found.reversed[index])
    judged = with_reversed(quality(residuals, observed.runs), [observed.runs[index].id for index in surest])
    together, tool = combinations(found), tool_summary(found, [ORIGIN]) if options.prior else None
    found = found.levelled() if options.squareness == "convention" else found
    components = {name: judged_component(found, name) for name in found.layout.components}
    locations = {name: judged_location(found, name) for name in found.layout.locations}
    silent = [name for name, one in (*components.items(), *locations.items()) if one.determined == "prior"]
    if not options.prior:
        silent = [name for name, one in (*components.items(), *locations.items()) if one.determined != "data"]
    left_open = (Undetermined(f"{enumerated(silent)}: {SILENT[options.prior]}", tuple(silent)),) if silent else ()
    values = replace(
        with_uncertainty(found.values, found),
        motion_errors={**_curves(model, observed, found), **given.motion_errors},
        u={name: one.u for name, one in locations.items() if np.isfinite(one.u)},
        u_readings={name: one.u_readings for name, one in locations.items()},
        u_prior={name: one.u_prior for name, one in locations.items()},
        determined={name: one.determined for name, one in (*components.items(), *locations.items())},
        undetermined=left_open,
        fit=judged.fit,
    )
    report = _report(model, observed, found, components, locations, judged, options)
    report = replace(
        report,
        effects=effect_reports(values, found),
        undetermined=left_open,
        combinations=together,
        tool=tool,
        notes=(*dimension_notes(model, given), *estimate_notes(model, found, given)),
    )
    return Identification(values, report, covariance_with_effects(found))


def _as_known(values: ErrorValues) -> ErrorValues:
    """Without what is said of their own identification."""
    return replace(
        values, u={}, u_readings={}, u_prior={}, determined={}, undetermined=(), covariance=None, fit=None
    )  # fmt: skip


def _given_noise(observed: Observations, model: NoiseModel) -> dict[int, float]:
    """Standard deviation of the readings of runs by index, mm: by the options, else by their devices."""
    weights = weighting(observed, model)
    if weights.sigma is None:
        devices = {index: observed.runs[index].device for index in np.unique(observed.run).tolist()}
        return {index: one.noise for index, one in devices.items() if one is not None and one.noise is not None}
    each = weights.sigma / weights.roots
    return {int(index): float(each[observed.run == index][0]) for index in np.unique(observed.run)}


def _residuals(model: MachineModel, observed: Observations, found: Estimate, noise: dict[int, float]) -> Residuals:
    good = ~found.outliers
    known, sizes = known_noise(observed, None), expected_sizes(model, observed.runs, observed.run, observed.positions)
    if set(np.unique(observed.run).tolist()) <= set(noise):
        sizes = None  # with a noise that is stated too small the values follow it: no allowance for what a model lacks
        known = np.array([noise.get(index, np.nan) for index in range(len(observed.runs))])[observed.run]
    return Residuals(
        observed.run,
        good.astype(np.float64),
        np.where(good, found.residual, 0.0) ** 2,
        known,
        sizes,
        int(found.freedom),
        () if set(np.unique(observed.run).tolist()) <= set(noise) else tuple(copied_runs(observed).tolist()),
    )


def _curves(model: MachineModel, observed: Observations, found: Estimate) -> dict[str, Curve]:
    measured = _measured(model, observed)
    curves: dict[str, Curve] = {}
    readings, by_prior = np.split(found.spread, [found.spread.shape[1] - found.of_prior], axis=1)
    parts = [np.linalg.norm(part, axis=1) for part in (found.spread, readings, by_prior)]
    parts[0][open_counts(np.linalg.norm(found.open, axis=1), parts[0])] = np.nan
    for place, name in enumerate(found.layout.components):
        first = int(found.layout.offsets[place])
        curve = found.values.motion_errors[name]
        assert isinstance(curve, LegendreCurve)
        u, u_readings, u_prior = (tuple(part[first : first + curve.basis.degree].tolist()) for part in parts)
        curves[name] = replace(curve, u=u, u_readings=u_readings, u_prior=u_prior, measured=measured.get(name))
    return curves


def _measured(model: MachineModel, observed: Observations) -> dict[str, tuple[float, float]]:
    """Lowest and highest position at which a reading holds each component."""
    found: dict[str, tuple[float, float]] = {}
    for index in np.unique(observed.run).tolist():
        positions = np.ascontiguousarray(observed.positions[:, observed.run == index])
        held = np.abs(sensed(model, observed.runs[index], positions)) > 0.0
        for row, name in enumerate(model.components):
            at = positions[model.axes.index(name[2]), held[row]]
            if at.size and np.ptp(positions[model.axes.index(name[2])]) > 0.0:
                low, high = found.get(name, (np.inf, -np.inf))
                found[name] = (min(low, float(at.min())), max(high, float(at.max())))
    return found


def _report(
    model: MachineModel,
    observed: Observations,
    found: Estimate,
    components: dict[str, Judged],
    locations: dict[str, Judged],
    judged: FitQuality,
    options: EstimateOptions,
) -> IdentificationReport:
    _layout, good = found.layout, ~found.outliers
    unit = {name: model.machine.parameter_unit(name) for name in model.location_errors}
    scale = np.array([found.scales.get(index, np.nan) for index in range(len(observed.runs))])
    sigma = {name: one.sigma for name, one in found.noise.items()}
    each = np.array([sigma.get(run.instrument, np.nan) for run in observed.runs]) * scale
    return IdentificationReport(
        machine=model.name,
        method="global",
        squareness=RULES[options.squareness],
        readings=observed.reading.size,
        left_out=(),
        lever=lever(model),
        rank_tolerance=0.0,
        blocks=(),
        iterations=found.rounds + found.steps,
        last_change=found.last_change,
        residual_rms_um=float(np.sqrt(np.mean(found.residual[good] ** 2))) * 1e3,
        freedom=int(found.freedom),
        noise_um=float(np.sqrt(np.mean(each[observed.run] ** 2))) * 1e3,
        noise_origin=_noise_origin(found),
        locations=tuple(_location(found, name, locations.get(name), unit[name]) for name in model.location_errors),
        components=tuple(_component(name, components.get(name)) for name in model.components),
        undetermined=(),
        quality=judged,
        instruments=_instruments(observed, found),
        noise_groups=_noise_groups(observed, found),
    )


def _location(found: Estimate, name: str, judged: Judged | None, unit: str) -> LocationReport:
    value = found.values.parameters.get(name, 0.0)
    if judged is None:
        return LocationReport(name, value, None, unit, "given")
    return LocationReport(
        name,
        value,
        _known_u(judged),
        unit,
        ORIGINS[judged.determined],
        u_readings=judged.u_readings,
        u_prior=judged.u_prior,
    )


def _known_u(judged: Judged) -> float | None:
    return judged.u if np.isfinite(judged.u) else None


def _component(name: str, judged: Judged | None) -> ComponentReport:
    if judged is None:
        return ComponentReport(name, "given", 0.0, None, unit_of(name))
    return ComponentReport(
        name,
        KNOWN[judged.determined],
        judged.largest,
        _known_u(judged),
        unit_of(name),
        u_readings=judged.u_readings,
        u_prior=judged.u_prior,
    )


def _instruments(observed: Observations, found: Estimate) -> tuple[InstrumentReport, ...]:
    layout = found.layout
    u = np.linalg.norm(found.spread, axis=1)
    silent = (u > NINE_TENTHS * found.scale) | open_counts(np.linalg.norm(found.open, axis=1), u)
    reports = []
    for place, unknown in enumerate(layout.shared, layout.of_machine):
        if silent[place]:
            continue
        letter = f" {'xyz'[unknown.coordinate]}" if "centre" in unknown.kind or "probe" in unknown.kind else ""
        runs = ", ".join(observed.runs[index].id for index in unknown.runs)
        unit = "1" if unknown.kind in ("laser scale", "stated scale", "laser cosine") else "mm"
        unit = "rad" if unknown.kind == "probe alignment" else unit
        value = float(found.unknowns[place])
        reports.append(InstrumentReport(f"{unknown.kind}{letter} ({runs})", value, float(u[place]), unit, ""))
    return tuple(reports)


def _noise_origin(found: Estimate) -> str:
    estimated = sorted(found.noise.keys() - found.stated)
    if not estimated:
        return "stated"
    which = f" of {enumerated(estimated)}" if found.stated else ""
    return f"estimated with the errors{which}, by restricted maximum likelihood"


def _noise_groups(observed: Observations, found: Estimate) -> tuple[NoiseGroupReport, ...]:
    """Of every instrument, over its runs; what of it is slow."""
    groups = []
    for name, one in found.noise.items():
        scales = [scale for index, scale in found.scales.items() if observed.runs[index].instrument == name]
        size = one.sigma * float(np.sqrt(np.mean(np.square(scales)))) * 1e3
        told = " (stated)" if name in found.stated else f" (slow part {one.slow * 1e3:.3g})" if one.slow > 0.0 else ""
        groups.append(NoiseGroupReport(name + told, size, None))
    return tuple(groups)
