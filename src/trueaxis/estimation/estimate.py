"""The estimate: sizes, noise and unknowns in turn, on the exact model, until nothing moves any more."""

from dataclasses import replace

import numpy as np

from trueaxis.effects.kind import Effect, Kind
from trueaxis.error_name import ErrorName
from trueaxis.estimation.doubted_lengths import doubted_lengths
from trueaxis.estimation.effects.start import below_zero, sought_effects, with_locations, with_searched, with_zeros
from trueaxis.estimation.effects.unknowns import EffectUnknowns
from trueaxis.estimation.evidence import averaged, likelier, posterior_at
from trueaxis.estimation.fitted import Fitted
from trueaxis.estimation.instrument_sizes import as_expected
from trueaxis.estimation.noise_of_residuals import SMALLEST
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.orders import higher_degrees
from trueaxis.estimation.own_part import beside
from trueaxis.estimation.result import Estimate, InstrumentNoise, Iteration, ReadingsLeft
from trueaxis.estimation.rounds import MOST_ROUNDS, SEARCH_ROUNDS, determined, settled
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.setting import USUAL, EstimationOptions, Setting
from trueaxis.estimation.state import State, as_stated, linearised
from trueaxis.estimation.steps import moved
from trueaxis.estimation.wrong_runs import wrong_runs
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel

MOST_STEPS = 20
STILL = 1e-3  # of the standard uncertainty of an unknown: a last step below it changes nothing that is said of it
EXACT = 1e-6  # the same without a prior: readings without noise then give the errors back
LEAST_STEP = 1e-12  # of the size of an unknown: rounding
NO_NOISE = 2.0  # times the least noise: readings simulated without any were estimated to have up to 1.5 times it


def estimate(
    model: MachineModel,
    observed: Observations,
    given: ErrorValues | None = None,
    options: EstimationOptions = USUAL,
) -> Estimate:
    """The errors and effects that are not given, from all readings, as a linear mixed model.

    given: values that are taken as they are, dimensions too. Raises NothingHeldError where no reading holds an error of
    the machine, InputError where the readings lack a column that an effect depends on.
    """
    given = with_locations(
        model, replace(given or ErrorValues(machine=model.name), u={}, undetermined=(), covariance=None)
    )
    model = model.with_values(given)
    sought = sought_effects(model, observed, given, options.start)
    setting = Setting(
        model=model,
        observed=observed,
        given=given,
        runs=tuple(measured_runs(observed)),
        options=options,
    )
    effects = sought.at_once
    for effect, kind in (*sought.waiting, *(sought.waiting if len(sought.waiting) > 1 else ())):
        effects = _searched(setting, effects, effect, kind)
    found = _estimated(setting, effects)
    negative = below_zero(found.layout.effects, found.unknowns[found.layout.of_effects])
    if negative:
        zeroed = tuple(one.effect for one in negative)
        setting = replace(setting, given=with_zeros(given, negative))
        found = replace(_estimated(setting, effects.without(zeroed)), zeroed=zeroed)
    return found


def _searched(setting: Setting, effects: EffectUnknowns, effect: Effect, kind: Kind) -> EffectUnknowns:
    """The effects and one more, started beside a rough estimate of all others."""
    state, sizes = setting.started(effects.without([effect]))
    x, state, _ = settled(state, sizes, SEARCH_ROUNDS)
    posterior, _ = determined(sizes, posterior_at(sizes, linearised(state), x))  # by the noise as it is now
    state = moved(state, posterior, sizes.own_scales(x))
    return with_searched(state.layout.effects, effect, kind, beside(state, sizes, x, posterior))


def _estimated(setting: Setting, effects: EffectUnknowns) -> Estimate:
    state, sizes = setting.started(effects)
    x, state, rounds = settled(state, sizes, MOST_ROUNDS)
    setting = replace(setting, degrees=_higher_degrees(setting, effects, Fitted(state=state, sizes=sizes, x=x)))
    if setting.degrees:
        state, sizes = setting.started(effects)
        x, state, rounds = settled(state, sizes, MOST_ROUNDS)
    layout = state.layout
    converged, last = False, np.inf
    steps = 0
    while steps < MOST_STEPS and last >= (STILL if setting.options.prior else EXACT):
        steps += 1
        found = linearised(state)
        whole = posterior_at(sizes, found, x)
        posterior, left_open = determined(sizes, whole)
        before = state
        state = moved(state, posterior, sizes.own_scales(x))
        change = max(
            float(np.max(np.abs(a - b), initial=0.0)) for a, b in zip(state.residual, before.residual, strict=True)
        )
        u = np.maximum(np.linalg.norm(whole.spread, axis=1), LEAST_STEP / STILL)
        last = float(np.max(np.abs((state.unknowns - before.unknowns) / layout.sizes) / u, initial=0.0))
        converged = last < STILL and (rounds < MOST_ROUNDS or _without_noise(state))
    fitted = Fitted(state=state, sizes=sizes, x=x)
    wrong = wrong_runs(setting, fitted, posterior)
    ratios = likelier(sizes, found, x) if setting.options.prior else {}
    beside_it = as_expected(sizes, found, x) if setting.options.prior else None
    if setting.options.prior:
        posterior = averaged(sizes, found, x)
    left, outliers = np.zeros(setting.observed.reading.size), np.zeros(setting.observed.reading.size, dtype=bool)
    for one, rest in zip(state.runs, state.residual, strict=True):
        left[one.rows.at], outliers[one.rows.at] = rest, ~one.good
    return Estimate(
        layout=state.layout,
        values=layout.values(state.unknowns, setting.given),
        unknowns=state.unknowns,
        spread=posterior.spread * layout.sizes[:, np.newaxis],
        of_prior=posterior.of_prior,
        open=left_open * layout.sizes[:, np.newaxis],
        scale=posterior.scale * layout.sizes,
        factors=sizes.factors(x),
        likelier=ratios,
        as_expected=beside_it and replace(beside_it, spread=beside_it.spread * layout.sizes[:, np.newaxis]),
        ideal=setting.options.ideal,
        own={one.rows.index: own for one, own in zip(state.runs, state.own, strict=True)},
        noise=InstrumentNoise(
            of_group=state.noise,
            scale_of_run={one.rows.index: float(scale) for one, scale in zip(state.runs, state.scales, strict=True)},
            stated=state.stated,
        ),
        readings=ReadingsLeft(
            residual=left,
            outliers=outliers,
            misread=wrong.misread,
            contradicting=tuple(wrong.contradicting),
            doubted=() if wrong.mistakes else doubted_lengths(setting, fitted),
            freedom=float((~outliers).sum()) - posterior.told,
        ),
        iteration=Iteration(rounds=rounds, steps=steps, last_step=last, last_change=change, converged=converged),
    )


def _higher_degrees(setting: Setting, effects: EffectUnknowns, fitted: Fitted) -> dict[ErrorName, int]:
    """Of curves that end at an order which readings tell; none where no prior says how orders shrink.

    Where residuals are far from a noise that is stated, by one that is estimated: by a noise far too small readings
    would tell any order, and the curves follow what is wrong with them.
    """
    options = setting.options
    if options.degree is not None or not options.prior:
        return {}
    if options.noise and not as_stated(fitted.state):
        state, sizes = replace(setting, options=replace(options, noise={})).started(effects)
        x, state, _ = settled(state, sizes, MOST_ROUNDS)
        fitted = Fitted(state=state, sizes=sizes, x=x)
    return higher_degrees(fitted.state.layout, fitted.posterior())


def _without_noise(state: State) -> bool:
    """Whether no estimated noise is above the least: outliers among what rounding leaves never come to rest."""
    return all(one.sigma < NO_NOISE * SMALLEST for name, one in state.noise.items() if name not in state.stated)
