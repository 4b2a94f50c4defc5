"""The diagnosis from readings to verdict: audit, noise, screening, base, search, refit, checks, gain."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.special import fdtrc

from trueaxis.diagnose.amplitudes import amplitudes_of
from trueaxis.diagnose.audit import audit
from trueaxis.diagnose.base import Base, base_of
from trueaxis.diagnose.candidates import candidates
from trueaxis.diagnose.checks import run_checks
from trueaxis.diagnose.checks_of_repeats import checks_of_repeats
from trueaxis.diagnose.freedom import freedom_of
from trueaxis.diagnose.gain import fitted_left, gain_of, held_out, of_instruments
from trueaxis.diagnose.imperfection import imperfection, taken_up
from trueaxis.diagnose.noise_of_runs import noise_of_runs
from trueaxis.diagnose.projection import Projection, orthonormal
from trueaxis.diagnose.prospect import prospect_of
from trueaxis.diagnose.refit import Fitted, refit
from trueaxis.diagnose.result import AmplitudeOf, Check, Diagnosis, FloatArray, NoiseOf
from trueaxis.diagnose.rows import Rows, rows_of
from trueaxis.diagnose.screening import outliers
from trueaxis.diagnose.search import Each, Found, Ground, Search, search, with_rivals, without
from trueaxis.diagnose.signatures import Readings, readings_of
from trueaxis.diagnose.standing import refitted_columns, standing_effects
from trueaxis.diagnose.temperature import smoothed
from trueaxis.diagnose.verdict import HOMOGENEOUS, explained_share, names_stand, verdict_of
from trueaxis.diagnose.whiten import whitening
from trueaxis.diagnose.write_up import Outcome, diagnosis_of
from trueaxis.measure.data import MeasuredData
from trueaxis.measure.reading_model import expected_readings
from trueaxis.runtime.model import MachineModel

AGAIN = 0.03  # relative change of the noise, causes taken away, from which the search is done again
STALE = 0.005  # p value below which the values given are stale ...
WORTH = 0.02  # ... if refitting also lowers the held-out RMS by this share


@dataclass(frozen=True, slots=True)
class DiagnoseOptions:
    """noise_um: of a reading, where it is known, else from repeats. progress: told each stage. each: how candidates are
    gone through, one after another or by several threads; what is found is the same, to the last digit.
    """

    noise_um: float | None = None
    progress: Callable[[str], None] = lambda _: None
    each: Each = map


def diagnose(model: MachineModel, data: MeasuredData, options: DiagnoseOptions | None = None) -> Diagnosis:
    """What the model gets wrong of the data, and why. Raises ValueError where no reading can be used.

    Cost: linear in the number of readings, times rank of the base (hundreds) times the points of all grids.
    """
    options = options or DiagnoseOptions()
    options.progress("reading")
    rows = rows_of(smoothed(data))
    if rows.size == 0:
        raise ValueError("no reading can be used: plans, or taken beside reversals, or directions are unknown")
    values = rows.reading - _expected(model, rows)
    keep, off = outliers(rows, values)
    rows, values = rows.only(keep), values[keep]
    readings = readings_of(model, rows)
    base = base_of(model, rows)
    options.progress("noise")
    noise = noise_of_runs(rows, readings.reading, values, options.noise_um)
    standing = standing_effects(readings)
    free = np.hstack([base.columns, refitted_columns(readings, standing)]) if standing else base.columns
    ground, found, causes = _searched(readings, free, values, noise, options, standing)
    if causes:
        signals = np.sum([one.signal for one in causes], axis=0)
        again = noise_of_runs(rows, readings.reading, values - signals, options.noise_um)
        if _changed(noise, again):
            noise = again
        named = (*standing, *causes)
        ground, found, causes = _searched(readings, free, values, noise, options, named, found.causes)
    # neither looks at the readings: where there are threads they are worked out beside what follows
    audits, prospects = options.each(audit, [ground]), options.each(prospect_of, [ground])
    options.progress("checks")
    groups = _amplitudes(ground, causes)
    while len(causes) > 1 and min(p for _, p in groups) < HOMOGENEOUS:
        # a further cause that is not one everywhere is none, and says nothing against the others
        found = without(ground, found, max(k for k, (_, p) in enumerate(groups) if p < HOMOGENEOUS))
        causes = refit(ground, found.causes)
        groups = _amplitudes(ground, causes)
    checks = _checks(ground, found.projection, found.residual, values, causes, standing)
    hard = Projection(orthonormal(ground.whitening(base.columns))) if standing else None
    homogeneous_p = [p for _, p in groups]
    share = explained_share(ground, found, causes, checks, homogeneous_p, standing, hard)
    stand = names_stand(share, (*standing, *causes), checks, homogeneous_p)
    if stand:
        options.progress("rivals")
        found = with_rivals(ground, found)
    elif causes:
        causes, groups = (), ()
        checks = _checks(ground, ground.base, ground.base.rest(ground.values), values, causes, standing)
    options.progress("gain")
    held, split = held_out(rows)
    everything = fitted_left(base, ground.whitening, values, causes, np.ones_like(held))
    of_held = fitted_left(base, ground.whitening, values, causes, ~held)
    floor = float(np.sqrt(np.mean([one.sigma**2 for one in ground.whitening.noise])))
    gain = gain_of(everything, of_held, held, split, floor)
    stale_p = _stale(ground, base)
    recalibrate = stale_p < STALE and gain.held_out.refitted < (1.0 - WORTH) * gain.held_out.given
    (audited,), (prospect,) = audits, prospects
    return diagnosis_of(
        Outcome(
            ground=ground,
            base=base,
            values=values,
            search=found,
            causes=causes,
            groups=groups,
            verdict=verdict_of(found, stand, checks, recalibrate),
            audit=audited,
            prospect=prospect,
            checks=checks,
            outliers=off,
            noise=noise,
            held=held,
            left=everything,
            gain=gain,
            # the base as fine as the curves of the extended machine
            of_instruments=of_instruments(
                base_of(model, rows, model.machine.curve_degree), ground.whitening, values, causes
            ),
            stale_p=stale_p,
        )
    )


def _checks(
    ground: Ground,
    projection: Projection,
    residual: FloatArray,
    values: FloatArray,
    causes: Sequence[Fitted],
    standing: Sequence[Fitted],
) -> tuple[Check, ...]:
    """values: (n,) mm, less what is expected, and so less what effects that are standing do."""
    rows, theta = ground.readings.rows, ground.readings.reading.theta
    found = run_checks(rows, theta, ground.whitening, projection, residual, ground.freedom)
    left = values - sum((one.signal for one in causes), np.zeros_like(values))
    hard = Projection(ground.base.basis)
    left -= taken_up(ground.readings, (*standing, *causes), lambda columns: hard.rest(ground.whitening(columns)), left)
    return found + checks_of_repeats(rows, left, theta, ground.whitening.noise)


def _amplitudes(ground: Ground, causes: Sequence[Fitted]) -> tuple[tuple[tuple[AmplitudeOf, ...], float], ...]:
    return tuple(amplitudes_of(ground, causes, index) for index in range(len(causes)))


def _expected(model: MachineModel, rows: Rows) -> FloatArray:
    return expected_readings(model, rows.runs, rows.run, rows.positions, rows.context)


def _searched(
    readings: Readings,
    free: FloatArray,
    values: FloatArray,
    noise: Sequence[NoiseOf],
    options: DiagnoseOptions,
    known: Sequence[Fitted],
    start: Sequence[Found] = (),
) -> tuple[Ground, Search, tuple[Fitted, ...]]:
    rows = readings.rows
    white = whitening(rows.run, [noise[index] for index in rows.present])
    projection = Projection(orthonormal(white(free)))
    chance = imperfection(readings, known, lambda columns: projection.rest(white(columns)))
    ground = Ground(
        readings=readings,
        effects=candidates(readings.model, rows),
        whitening=white,
        base=projection.softened(chance.beside),
        values=white(values),
        freedom=freedom_of(white),
        progress=options.progress,
        each=options.each,
        wide=projection.softened(chance.columns),
    )
    found = search(ground, start)
    return ground, found, refit(ground, found.causes)


def _changed(before: Sequence[NoiseOf], after: Sequence[NoiseOf]) -> bool:
    pairs = [(one.sigma, other.sigma) for one, other in zip(before, after, strict=True)]
    pairs += [(one.sigma + one.slope, other.sigma + other.slope) for one, other in zip(before, after, strict=True)]
    return any(abs(one - other) > AGAIN * max(one, other) for one, other in pairs)


def _stale(ground: Ground, base: Base) -> float:
    """The p value of the values given being right: what the base explains beyond the unknowns of the instruments."""
    nuisance = Projection(orthonormal(ground.whitening(base.columns[:, base.of_instruments])))
    left = nuisance.rest(ground.values)
    within = ground.base.basis.T @ left
    k = ground.base.rank - nuisance.rank
    if k <= 0:
        return 1.0
    return float(fdtrc(k, ground.freedom.of_readings, float(within @ within) / k))
