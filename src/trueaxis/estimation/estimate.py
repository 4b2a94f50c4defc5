"""The estimate: sizes, noise and unknowns in turn, on the exact model, until nothing moves any more."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from trueaxis.estimation.evidence import averaged, best_sizes, posterior_at
from trueaxis.estimation.gauge import levelling
from trueaxis.estimation.instruments import own_kinds
from trueaxis.estimation.jacobian import RunRows
from trueaxis.estimation.layout import Layout, layout_of
from trueaxis.estimation.noise import Noise, Whitening
from trueaxis.estimation.noise_of_residuals import first_noise, noise_of_draws
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.outliers import spoilt
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.reduce import reduced
from trueaxis.estimation.residuals import first_order, residuals_of
from trueaxis.estimation.runs import MeasuredRun, measured_runs
from trueaxis.estimation.sizes import Sizes
from trueaxis.measure.columns import BoolArray
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import MachineModel

T = TypeVar("T")

LEAST_ROUNDS, MOST_ROUNDS = 5, 30  # in which noise, outliers and sizes are estimated
SETTLED = 0.03  # relative change of the noise: far below what readings tell of it
MOST_STEPS = 20
STILL = 1e-3  # of the standard uncertainty of an unknown: a last step below it changes nothing that is said of it
LEAST_STEP = 1e-12  # of the size of an unknown: rounding
# A step may raise the squares where other sizes were found; led away by what is not linear, it raises them by far.
WORSE, LEAST_SHARE = 4.0, 1e-3
DISPLAY = 12.0**-0.5  # of its step: the standard deviation of rounding
DRAWS, SEED = 8, 20  # of the posterior, from which the noise is taken


class NothingHeldError(ValueError):
    """No reading depends on an error that is to be estimated."""


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Estimate:
    """What readings say of a machine and of the instruments.

    values: of the machine; unknowns: (n,), mm, rad or 1; spread: (n, r), a root of their covariance, the last
    `of_prior` columns of which are the prior's part, the others that of the readings; scale: (n,), their prior standard
    deviations, at their estimated sizes; factors: class of sizes -> the estimated size over the expected one. noise: of
    each instrument; scales: of each run with readings, by index, its noise over that of its
    instrument; stated: instruments whose noise was given: their scales are mm; outliers: (n_readings,), left out;
    residual: (n_readings,), mm; freedom: degrees of freedom that are left; rounds, steps: how often noise and sizes,
    then the unknowns alone were estimated; last_step, last_change: the largest last step in standard uncertainties, and
    by how much it changed a residual, mm; converged: whether it was none.
    """

    layout: Layout
    values: ErrorValues
    unknowns: FloatArray
    spread: FloatArray
    of_prior: int
    scale: FloatArray
    factors: Mapping[str, float]
    noise: Mapping[str, Noise]
    scales: Mapping[int, float]
    stated: frozenset[str]
    outliers: BoolArray
    residual: FloatArray
    freedom: float
    rounds: int
    steps: int
    last_step: float
    last_change: float
    converged: bool

    def levelled(self) -> "Estimate":
        """By the convention for straightness and squareness; what the instruments' unknowns are stays."""
        change = levelling(self.layout)
        prior = np.linalg.norm(change * self.scale, axis=1)
        unknowns = change @ self.unknowns
        given = replace(self.values, parameters=_others(self.values.parameters, self.layout.locations))
        given = replace(given, motion_errors=_others(self.values.motion_errors, self.layout.components))
        values = self.layout.values(unknowns, given)
        return replace(self, values=values, unknowns=unknowns, spread=change @ self.spread, scale=prior)


def _others(values: Mapping[str, T], names: tuple[str, ...]) -> dict[str, T]:
    return {name: value for name, value in values.items() if name not in names}


@dataclass(frozen=True, slots=True, eq=False)
class _State:
    """Where the estimation stands: noise of each instrument, scale of each run, and the unknowns.

    stated: instruments whose noise is known, white and 1, the scales of their runs being the noise in mm.
    """

    runs: list[MeasuredRun]
    stated: frozenset[str]
    noise: dict[str, Noise]
    scales: FloatArray
    unknowns: FloatArray
    own: list[FloatArray]
    residual: list[FloatArray]


def estimate(
    model: MachineModel,
    observed: Observations,
    given: ErrorValues | None = None,
    noise: Mapping[int, float] | None = None,
) -> Estimate:
    """The errors that are not given, from all readings, as a linear mixed model.

    given: values that are taken as they are, dimensions too; noise: standard deviation of the readings of runs, by
    index, mm; that of an instrument is estimated unless all of its runs are there. Raises NothingHeldError where
    no reading holds an error of the machine.
    """
    given = replace(given or ErrorValues(model.name), u={}, undetermined=(), covariance=None)
    layout = layout_of(model.with_values(given), observed, given)
    state = _start(layout, measured_runs(observed), given, noise)
    draw = np.random.default_rng(SEED)
    kinds = [own_kinds(one.rows.run, layout.straightness[one.rows.index]) for one in state.runs]
    sizes = Sizes(layout, kinds)
    x = np.zeros(sizes.spread.size)
    for rounds in range(1, MOST_ROUNDS + 1):
        found = reduced(layout, *_whitened(layout, state))
        if not found.holds(layout.of_machine):
            raise NothingHeldError("no reading holds an error of the machine")
        x, posterior = best_sizes(sizes, found, x)
        state = _moved(layout, state, posterior, given)
        known, scales = _noise(layout, state, posterior, draw)
        change = max(abs(np.log(one.sigma / state.noise[name].sigma)) for name, one in known.items())
        state = replace(state, noise=known, scales=scales)
        good = _good(state)
        settled = change < SETTLED and all((one.good == now).all() for one, now in zip(state.runs, good, strict=True))
        state = replace(state, runs=[replace(one, good=now) for one, now in zip(state.runs, good, strict=True)])
        if settled and rounds >= LEAST_ROUNDS:
            break
    converged, last = False, np.inf
    steps = 0
    while steps < MOST_STEPS and not converged:
        steps += 1
        found = reduced(layout, *_whitened(layout, state))
        posterior = posterior_at(sizes, found, x)
        before, residual = state.unknowns / layout.sizes, state.residual
        state = _moved(layout, state, posterior, given)
        change = max(float(np.max(np.abs(a - b), initial=0.0)) for a, b in zip(state.residual, residual, strict=True))
        u = np.maximum(np.linalg.norm(posterior.spread, axis=1), LEAST_STEP / STILL)
        last = float(np.max(np.abs(state.unknowns / layout.sizes - before) / u, initial=0.0))
        converged = last < STILL
    posterior = averaged(sizes, found, x)
    state = _moved(layout, state, posterior, given)
    left, outliers = np.zeros(observed.reading.size), np.zeros(observed.reading.size, dtype=bool)
    for one, rest in zip(state.runs, state.residual, strict=True):
        left[one.at], outliers[one.at] = rest, ~one.good
    return Estimate(
        layout=layout,
        values=layout.values(state.unknowns, given),
        unknowns=state.unknowns,
        spread=posterior.spread * layout.sizes[:, np.newaxis],
        of_prior=posterior.of_prior,
        scale=posterior.scale * layout.sizes,
        factors=sizes.factors(x),
        noise=state.noise,
        scales={one.rows.index: float(scale) for one, scale in zip(state.runs, state.scales, strict=True)},
        stated=state.stated,
        outliers=outliers,
        residual=left,
        freedom=float((~outliers).sum()) - posterior.told,
        rounds=rounds,
        steps=steps,
        last_step=last,
        last_change=change,
        converged=converged,
    )


def _start(layout: Layout, runs: list[MeasuredRun], given: ErrorValues, noise: Mapping[int, float] | None) -> _State:
    unknowns = np.zeros(layout.count)
    own_unknowns = [np.zeros(len(own_kinds(one.rows.run, layout.straightness[one.rows.index]))) for one in runs]
    residual = residuals_of(layout, runs, unknowns, own_unknowns, given)
    noise = noise or {}
    unstated = {one.instrument for one in runs if one.rows.index not in noise}
    found: dict[str, Noise] = {}
    for name in sorted({one.instrument for one in runs}):
        own = [rest for one, rest in zip(runs, residual, strict=True) if one.instrument == name]
        found[name] = first_noise(own) if name in unstated else Noise(1.0)
    scales = np.array([1.0 if one.instrument in unstated else noise[one.rows.index] for one in runs])
    stated = frozenset(found) - unstated
    return _State(runs, stated, found, scales, unknowns, own_unknowns, residual)


def _whitened(layout: Layout, state: _State) -> tuple[list[RunRows], list[Whitening], list[FloatArray]]:
    """Rows, whitening and readings less what is not linear, of every run."""
    kept = [one.kept() for one in state.runs]
    linear = first_order(layout, state.runs, state.unknowns, state.own)
    values = [(rest + part)[one.good] for one, rest, part in zip(state.runs, state.residual, linear, strict=True)]
    whitenings = [
        Whitening(state.noise[one.instrument], rows.steps, scale)
        for one, rows, scale in zip(state.runs, kept, state.scales, strict=True)
    ]
    return kept, whitenings, values


def _moved(layout: Layout, state: _State, posterior: Posterior, given: ErrorValues) -> _State:
    """After the step to the posterior mean, or a part of it where the exact model is far worse off after it."""
    squares = _squares(state, state.residual)
    share = 1.0
    while True:
        unknowns = state.unknowns + share * (posterior.mean * layout.sizes - state.unknowns)
        own = [now + share * (one.mean - now) for now, one in zip(state.own, posterior.own, strict=True)]
        residual = residuals_of(layout, state.runs, unknowns, own, given)
        if _squares(state, residual) <= WORSE * squares or share < LEAST_SHARE:
            return replace(state, unknowns=unknowns, own=own, residual=residual)
        share *= 0.5


def _squares(state: _State, residual: list[FloatArray]) -> float:
    """Of residuals in units of the noise; a reading more counts for rounding."""
    parts = zip(state.runs, residual, state.scales.tolist(), strict=True)
    return 1.0 + sum(
        float(np.sum((rest[one.good] / (scale * state.noise[one.instrument].sigma)) ** 2)) for one, rest, scale in parts
    )


def _noise(
    layout: Layout, state: _State, posterior: Posterior, draw: np.random.Generator
) -> tuple[dict[str, Noise], FloatArray]:
    normal = draw.standard_normal((posterior.spread.shape[1], DRAWS))
    own = [
        one.by_others @ normal + one.alone @ draw.standard_normal((one.alone.shape[1], DRAWS)) for one in posterior.own
    ]
    change = first_order(layout, state.runs, layout.sizes[:, np.newaxis] * (posterior.spread @ normal), own)
    draws = [
        (rest[:, np.newaxis] - off)[one.good] for one, rest, off in zip(state.runs, state.residual, change, strict=True)
    ]
    noise, scales = dict(state.noise), state.scales.copy()
    for name in sorted(state.noise.keys() - state.stated):
        members = [place for place, one in enumerate(state.runs) if one.instrument == name]
        steps = [state.runs[place].kept().steps for place in members]
        found, scales[members] = noise_of_draws([draws[place] for place in members], steps)
        devices = {state.runs[place].rows.run.device for place in members}
        resolved = max((one.resolution for one in devices if one is not None and one.resolution), default=0.0)
        noise[name] = replace(found, white=max(found.white, resolved * DISPLAY))
    return noise, scales


def _good(state: _State) -> list[BoolArray]:
    readings = sum(one.reading.size for one in state.runs)
    return [
        ~spoilt(state.noise[one.instrument], scale, one.rows.steps, rest, one.repeats, readings)
        for one, rest, scale in zip(state.runs, state.residual, state.scales.tolist(), strict=True)
    ]
