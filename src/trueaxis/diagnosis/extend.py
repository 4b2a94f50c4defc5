"""The extended model: which causes it takes over, and its error values found anew from the readings that were kept.

Values change from those given by as little as the readings ask for: what they do not hold, and how squareness was
told from straightness, stays as it was given.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import zip_longest

import numpy as np
from numpy.polynomial import chebyshev

from trueaxis.diagnosis.judging.instruments import NOT_OF_THE_MACHINE
from trueaxis.diagnosis.null_model.temperature import assumed, smoothed
from trueaxis.diagnosis.result import Diagnosis, ErrorNow, FloatArray
from trueaxis.effects.kind import Effect
from trueaxis.effects.library import BY_NAME
from trueaxis.estimation.judgement import SAMPLES
from trueaxis.estimation.observations import Observations, observations
from trueaxis.estimation.setting import EstimationOptions
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.identification.fit_quality import NotConvergedError
from trueaxis.identification.report import Identification
from trueaxis.identification.words import enumerated
from trueaxis.io.faults import InputError
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.reading_model import expected_readings
from trueaxis.model.curves import Curve, LegendreCurve, PolynomialCurve, TableCurve, polynomial_of
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues, Fit, Undetermined
from trueaxis.model.model import MachineModel

Extend = Callable[[Diagnosis], MachineModel]  # of the machine with the causes named, that given where none is


def named_effects(diagnosis: Diagnosis) -> tuple[Effect, ...]:
    """The effects that the extended machine has besides: causes that were named.

    What cannot be told from a rival, or from changed values, is not among them, nor is anything where structure is left
    unexplained, nor what an instrument had while it measured.
    """
    if diagnosis.verdict not in ("explained", "ambiguous"):
        return ()
    return tuple(cause.effect for cause in diagnosis.causes if cause.alone and _is_of_the_machine(cause.effect))


def start_values(diagnosis: Diagnosis) -> tuple[EffectValues, ...]:
    """The causes found, as the diagnosis fitted them: where their fit beside all error values starts."""
    return tuple(
        EffectValues(one.effect, {each.name: each.value for each in one.parameters})
        for one in diagnosis.causes
        if _is_of_the_machine(one.effect)
    )


def _is_of_the_machine(effect: Effect) -> bool:
    """Not what an instrument has in one session: a spec holds none of it."""
    kind = BY_NAME.get(effect.kind)
    return effect.kind not in NOT_OF_THE_MACHINE and (not effect.runs or kind is None or kind.by_run)


def all_readings(data: MeasuredData) -> Observations:
    """The readings that were measured, with the temperatures that the diagnosis assumes."""
    return observations("readings", data.setup.runs, assumed(smoothed(data).readings))


def kept_readings(data: MeasuredData, diagnosis: Diagnosis) -> Observations:
    """The readings that the diagnosis worked on, with the temperatures that it assumed."""
    taken = np.flatnonzero(~data.readings.planned)
    return all_readings(data).of(np.flatnonzero(np.isin(taken, diagnosis.residuals.row)))


@dataclass(frozen=True, slots=True)
class Anew:
    """What `identify` makes of the readings. values: None where no cause extends the machine; errors: a table of all;
    misfits: runs that no errors of the machine fit; settled: whether the values with the causes named have
    converged: there are none where they have not.
    """

    values: ErrorValues | None = None
    errors: tuple[ErrorNow, ...] = ()
    misfits: tuple[str, ...] = ()
    settled: bool = True


def identified_anew(model: MachineModel, data: MeasuredData, found: Diagnosis, extend: Extend) -> Anew:
    """All errors of the machine beside the causes named.

    Where none is, the diagnosis stands without a fit that does not stand still; else see `reidentified`. Where values
    given are nearly right, runs that contradict the others look like noisy ones beside changes that are none: so the
    readings are judged as they are, too, as `identify` does: all of them, where no effect needs to know from where an
    axis came. Where a cause is not part of the extended machine, readings that it explains fit no values, which says
    nothing against them; but a run may have been misread, which then explains the cause.
    """
    effects = named_effects(found)
    extended, named = extend(found), bool(effects)
    start = start_values(found) if named else ()
    try:
        readings = kept_readings(data, found)
        values, errors, fit = reidentified(extended, model.errors, readings, start)
    except NotConvergedError:
        return Anew(settled=not named)
    except InputError:
        if named:
            raise
        return Anew()
    whole = len(effects) == len(found.causes)
    wrong = fit.runs if whole and fit is not None and fit.state == "misfit" else ()
    if whole and not wrong:
        wrong = _as_read(extended, model.errors, readings if named else all_readings(data), start)
    of_instruments = frozenset(run for one in found.causes for run in one.effect.runs)
    if of_instruments or not whole:
        wrong = (*wrong, *(run for run in _misread(model, readings) if not whole or run in of_instruments))
    return Anew(values if named else None, errors, wrong)


def _as_read(
    model: MachineModel, given: ErrorValues, observed: Observations, start: Sequence[EffectValues]
) -> tuple[str, ...]:
    """Runs that no errors of the machine fit, by the readings as they are. start: of the effects of the machine."""
    options = IdentifyOptions(known=_dimensions(model, given), estimation=EstimationOptions(start=tuple(start)))
    try:
        fit = identify_estimated(model, observed, options).values.fit
    except (NotConvergedError, InputError):
        return ()
    return fit.runs if fit is not None and fit.state == "misfit" else ()


def _misread(model: MachineModel, observed: Observations) -> tuple[str, ...]:
    """Runs that were misread for sure: of the readings as they are, since a change shows no reversed sign."""
    try:
        found = identify_estimated(model, observed, IdentifyOptions(known=_dimensions(model, model.errors)))
    except (NotConvergedError, InputError):
        return ()
    return () if found.report.quality is None else found.report.quality.misread


def _dimensions(model: MachineModel, given: ErrorValues) -> ErrorValues:
    parameters = {name: given.parameters[name] for name in model.dimensions if name in given.parameters}
    return ErrorValues(machine=model.name, parameters=parameters)


def reidentified(
    model: MachineModel, given: ErrorValues, observed: Observations, start: Sequence[EffectValues] = ()
) -> tuple[ErrorValues, tuple[ErrorNow, ...], Fit | None]:
    """Error values of the extended machine: what `identify` makes of the readings, as a change of those given; a table
    of all; whether any values fit the readings.

    model: of the extended machine; given: values of the machine before; start: of its effects, to start from. Sizes of
    the changes are estimated, and unknowns of the instruments with them: where nothing has changed, nothing is changed.
    Dimensions stay. Raises InputError where the readings hold no unknown, NotConvergedError where the estimate does not
    stand still.
    """
    bare = _dimensions(model, given)
    before = _expected(model, replace(given, effects=()), observed) - _expected(model, bare, observed)
    options = IdentifyOptions(known=bare, estimation=EstimationOptions(start=tuple(start), changes=True))
    found = identify_estimated(model, replace(observed, reading=observed.reading - before), options)
    values = changed(given, found.values, model.location_errors)
    return values, _table(model, given, values, found), found.values.fit


def _table(model: MachineModel, given: ErrorValues, now: ErrorValues, found: Identification) -> tuple[ErrorNow, ...]:
    u_of: dict[str, float | None] = {one.name: one.u for one in found.report.components}
    u_of |= {one.name: one.u for one in found.report.locations}

    def row(name: str, unit: str, before: FloatArray, after: FloatArray) -> ErrorNow:
        u = u_of[name]
        return ErrorNow(
            name=name,
            unit=unit,
            given=_largest(before),
            now=_largest(after),
            change=_largest(after - before),
            u=np.nan if u is None else u,
            determined=found.values.determined[name],
        )

    known = found.values.determined.keys()
    rows = []
    for name in (one for one in model.components if one in known):
        after = now.motion_errors[name]
        travel = np.linspace(*model.travel[name.axis], SAMPLES)
        at = after.basis.evenly(SAMPLES) if isinstance(after, LegendreCurve) else travel
        before = given.motion_errors[name](at) if name in given.motion_errors else np.zeros(at.size)
        rows.append(row(name, name.unit, before, after(at)))
    for location in (one for one in model.location_errors if one in known):
        values = (np.array([one.parameters.get(location, 0.0)]) for one in (given, now))
        rows.append(row(location, model.machine.parameter_unit(location), *values))
    return tuple(rows)


def _largest(values: FloatArray) -> float:
    """The value that is farthest from zero."""
    return float(values[np.argmax(np.abs(values))])


def changed(given: ErrorValues, change: ErrorValues, locations: Sequence[str]) -> ErrorValues:
    """Values changed by others: location errors and curves are sums; effects and uncertainties are those of the change.

    A curve given as a table stays one, with the change at its positions.
    """
    moved = {
        name: given.parameters.get(name, 0.0) + change.parameters[name]
        for name in locations
        if name in change.parameters
    }
    curves = dict(given.motion_errors)
    for name, curve in change.motion_errors.items():
        curves[name] = _sum(curves[name], curve) if name in curves else curve
    return ErrorValues(
        machine=given.machine,
        parameters={**given.parameters, **moved},
        motion_errors=curves,
        u=change.u,
        undetermined=tuple(map(_open, change.undetermined)),
        effects=change.effects,
    )


def _expected(model: MachineModel, values: ErrorValues, observed: Observations) -> FloatArray:
    model = model.with_values(values)
    return expected_readings(model, observed.runs, observed.run, observed.positions, observed.context)


def _sum(given: Curve, change: Curve) -> Curve:
    """A polynomial that is not zero at home and harmonics have no form in common: they make a table of every degree."""
    if isinstance(given, TableCurve):
        values = np.array(given.values) + change(np.array(given.positions))
        return TableCurve(given.positions, tuple(values.tolist()))
    if isinstance(change, TableCurve):
        return _sum(change, given)
    for one, other in ((given, change), (change, given)):
        if isinstance(one, LegendreCurve) and float(np.abs(other(np.array([one.basis.home])))[0]) == 0.0:
            return _legendre_sum(one, other)
    for one in (given, change):
        if isinstance(one, LegendreCurve) and one.basis.harmonics:
            every = np.linspace(one.basis.low, one.basis.high, 1 + round(one.basis.high - one.basis.low))
            return TableCurve(tuple(every.tolist()), tuple((given(every) + change(every)).tolist()))
    given, change = (polynomial_of(one) if isinstance(one, LegendreCurve) else one for one in (given, change))
    total: dict[int, float] = {}
    for curve in (given, change):
        for power, coefficient in zip(curve.powers, curve.coefficients, strict=True):
            total[power] = total.get(power, 0.0) + coefficient
    u = None
    if change.u is not None:
        of_change = dict(zip(change.powers, change.u, strict=True))
        u = tuple(of_change.get(power, np.nan) for power in sorted(total))
    return PolynomialCurve(
        powers=tuple(sorted(total)), coefficients=tuple(total[power] for power in sorted(total)), u=u
    )


def _legendre_sum(curve: LegendreCurve, other: PolynomialCurve | LegendreCurve) -> LegendreCurve:
    """On the basis of the first, of an order that holds both; u: of the first."""
    own, waves = _parted(curve)
    others, other_waves = (other, ()) if isinstance(other, PolynomialCurve) else _parted(other)
    order = others.basis.degree if isinstance(others, LegendreCurve) else max(others.powers, default=0)
    basis = replace(own.basis, degree=max(own.basis.degree, order))
    # two polynomials of this order that agree at the nodes of Chebyshev are the same
    nodes = 0.5 * (basis.low + basis.high) + 0.5 * (basis.high - basis.low) * chebyshev.chebpts1(basis.degree + 1)
    coefficients = np.linalg.lstsq(basis(nodes).T, own(nodes) + others(nodes), rcond=None)[0].tolist()
    total = [sum(both) for both in zip_longest(waves, other_waves, fillvalue=0.0)]
    u = None
    if curve.u is not None:
        degree, open_ends = own.basis.degree, (basis.degree - own.basis.degree, len(total) - len(waves))
        u = (*curve.u[:degree], *([np.nan] * open_ends[0]), *curve.u[degree:], *([np.nan] * open_ends[1]))
    return LegendreCurve(basis=replace(basis, harmonics=len(total) // 2), coefficients=(*coefficients, *total), u=u)


def _parted(curve: LegendreCurve) -> tuple[LegendreCurve, tuple[float, ...]]:
    """The sum of its polynomials, and the coefficients of its harmonics."""
    basis, each = curve.basis.polynomials, curve.coefficients
    return LegendreCurve(basis=basis, coefficients=each[: basis.degree]), each[basis.degree :]


def _open(left: Undetermined) -> Undetermined:
    """What the readings leave open keeps the value given, whatever the fit of the change says of its own."""
    told = f"{enumerated(left.parameters)}: not settled by the readings, as near to what was given as they allow"
    return replace(left, combination=told)
