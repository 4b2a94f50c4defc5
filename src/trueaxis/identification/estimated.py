"""`identify --method global`: the estimate of all errors from all readings, as values, covariance and report."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from trueaxis.error_name import ErrorName
from trueaxis.estimation.combinations import combinations
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.first_order import sensed
from trueaxis.estimation.judgement import Judged, judged_component, judged_location, open_counts
from trueaxis.estimation.observations import Observations, copied_runs
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.rounds import NothingHeldError
from trueaxis.estimation.runs import measured_runs, noise_groups
from trueaxis.estimation.setting import USUAL, EstimationOptions
from trueaxis.estimation.tool_point import ORIGIN, tool_summary
from trueaxis.identification.estimated_effects import covariances, with_uncertainty
from trueaxis.identification.estimated_report import estimated_report
from trueaxis.identification.fit_quality import (
    NotConvergedError,
    Residuals,
    expected_sizes,
    noise_remedies,
    quality,
    run_residuals,
)
from trueaxis.identification.misreadings import with_misread
from trueaxis.identification.repeat_noise import noise_of_repeats
from trueaxis.identification.report import Identification
from trueaxis.identification.usual_sizes import by_usual_sizes
from trueaxis.identification.weighting import NoiseModel, weighting
from trueaxis.identification.words import enumerated
from trueaxis.io.faults import Fault, InputError
from trueaxis.model.curves import Curve, LegendreCurve
from trueaxis.model.errors import ErrorValues, Undetermined
from trueaxis.model.model import MachineModel

Choice = Literal["convention", "known"]
SILENT = {
    True: "the readings do not determine them; values and u rest on [prior]",
    False: "the readings leave combinations of them open, which are zero here",
}


@dataclass(frozen=True, slots=True)
class IdentifyOptions:
    """squareness: what parts it from straightness; known: values taken as they are, dimensions too; noise: what is
    known of it, in place of that of `estimation`.
    """

    squareness: Choice = "convention"
    known: ErrorValues | None = None
    noise: NoiseModel = field(default_factory=NoiseModel)
    estimation: EstimationOptions = USUAL


def identify_estimated(model: MachineModel, observed: Observations, options: IdentifyOptions) -> Identification:
    """Values, report and covariance.

    Raises InputError where no reading holds an error, or where the noise that is given does not fit the runs;
    NotConvergedError where the estimate does not stand still.
    """
    prior = options.estimation.prior
    given = _as_known(options.known or ErrorValues(machine=model.name))
    if options.squareness == "known":
        zeros = dict.fromkeys(model.location_errors, 0.0)
        given = replace(given, parameters={**zeros, **given.parameters})
    noise = _given_noise(observed, options.noise)
    try:
        found = estimate(model, observed, given, replace(options.estimation, noise=noise))
    except NothingHeldError as error:
        remedy = "runs that move an axis, or fewer values in --known"
        raise InputError([Fault(observed.source, "", str(error), remedy)]) from error
    residuals = _residuals(model, observed, found, noise)
    each = run_residuals(residuals, observed.runs)
    by_device = options.noise.um is None and not options.noise.names
    remedies = (
        {}
        if options.noise.repeats or options.noise.repeated
        else noise_remedies(observed, noise, each, by_device=by_device)
    )
    if not found.iteration.converged:
        raise NotConvergedError(each, found.iteration.rounds + found.iteration.steps, tuple(remedies))
    judged = with_misread(quality(residuals, observed.runs), observed, found, prior=prior)
    if judged.fit.state == "misfit" and remedies:
        judged = replace(judged, reason="; ".join([judged.reason, *remedies]))
    together = combinations(found, [run.id for run in observed.runs]) if prior else ()
    tip, found = found, found.levelled() if options.squareness == "convention" else found
    usual = by_usual_sizes(model, observed, found)
    tool = tool_summary(tip, [ORIGIN], covariances(tip, usual is not None)) if prior else None
    components = {name: judged_component(found, name) for name in found.layout.components}
    locations = {name: judged_location(found, name) for name in found.layout.locations}
    silent = [name for name, one in (*components.items(), *locations.items()) if one.determined == "prior"]
    if not prior:
        silent = [name for name, one in (*components.items(), *locations.items()) if one.determined != "data"]
    left_open = (Undetermined(f"{enumerated(silent)}: {SILENT[prior]}", tuple(silent)),) if silent else ()
    curves = {**_curves(model, observed, found), **given.motion_errors}
    values = replace(
        _with_u(found, components, locations), motion_errors=curves, undetermined=left_open, fit=judged.fit
    )
    report = estimated_report(
        model,
        observed,
        found,
        values,
        given,
        components=components,
        locations=locations,
        judged=judged,
        remedies=() if judged.fit.state == "misfit" else tuple(remedies),
        squareness=options.squareness,
        prior=prior,
    )
    said = () if usual is None else (str(usual),)
    report = replace(report, combinations=together, tool=tool, usual=usual, caveats=(*report.caveats, *said))
    return Identification(values, report, covariances(found, usual is not None))


def _with_u(found: Estimate, components: Mapping[ErrorName, Judged], locations: Mapping[str, Judged]) -> ErrorValues:
    """The values with the uncertainties of effects and location errors, and by what each is determined."""
    return replace(
        with_uncertainty(found.values, found),
        u={name: one.u for name, one in locations.items() if np.isfinite(one.u)},
        u_readings={name: one.u_readings_rms for name, one in locations.items()},
        u_prior={name: one.u_prior_rms for name, one in locations.items()},
        determined={name: one.determined for name, one in (*components.items(), *locations.items())},
    )


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
    good = ~found.readings.outliers
    of_group, stated = found.noise.of_group, found.noise.stated
    independent = {
        one.rows.index: of_group[one.noise_group].independent(one.rows.steps) for one in measured_runs(observed)
    }
    sigma = np.array(
        [
            of_group[group].sigma * (found.noise.scale_of_run.get(index, np.nan) if group in stated else 1.0)
            if group in of_group
            else np.nan
            for index, group in enumerate(noise_groups(observed.runs))
        ]
    )
    estimated = sigma[observed.run]
    of_runs = np.array([noise.get(index, np.nan) for index in range(len(observed.runs))])[observed.run]
    sizes = expected_sizes(model, observed.runs, observed.run, observed.positions)
    # no allowance for what a model lacks where the noise is stated: values follow a noise that is too small
    sizes = None if sizes is None else np.where(np.isfinite(of_runs), 0.0, sizes)
    by_repeats, freedom = noise_of_repeats(observed)
    of_repeats = np.isnan(of_runs) & np.isfinite(by_repeats)
    return Residuals(
        run=observed.run,
        count=good.astype(np.float64),
        squares=np.where(good, found.readings.residual, 0.0) ** 2,
        noise=np.where(np.isfinite(of_runs), of_runs, by_repeats),
        size=sizes,
        freedom=int(found.readings.freedom),
        copied=tuple(copied_runs(observed).tolist()),
        estimated=estimated,
        independent=independent,
        stated=tuple(sorted(noise)),
        noise_freedom=dict(zip(observed.run[of_repeats].tolist(), freedom[of_repeats].tolist(), strict=True)),
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
        u, u_readings, u_prior = (tuple(part[first : first + curve.basis.count].tolist()) for part in parts)
        curves[name] = replace(curve, u=u, u_readings=u_readings, u_prior=u_prior, measured=measured.get(name))
    return curves


def _measured(model: MachineModel, observed: Observations) -> dict[str, tuple[float, float]]:
    """Lowest and highest position at which a reading holds each component."""
    found: dict[str, tuple[float, float]] = {}
    for index in np.unique(observed.run).tolist():
        positions = np.ascontiguousarray(observed.positions[:, observed.run == index])
        held = np.abs(sensed(model, observed.runs[index], positions)) > 0.0
        for row, name in enumerate(model.components):
            at = positions[model.axes.index(name.axis), held[row]]
            if at.size and np.ptp(positions[model.axes.index(name.axis)]) > 0.0:
                low, high = found.get(name, (np.inf, -np.inf))
                found[name] = (min(low, float(at.min())), max(high, float(at.max())))
    return found
