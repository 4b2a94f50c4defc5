"""The estimate: sizes, noise and unknowns in turn, on the exact model, until nothing moves any more."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from trueaxis.effects.kind import Effect, Kind
from trueaxis.error_name import ErrorName
from trueaxis.estimation.curve_prior import DEGREE
from trueaxis.estimation.effects.start import below_zero, sought_effects, with_locations, with_searched, with_zeros
from trueaxis.estimation.effects.unknowns import EffectUnknowns
from trueaxis.estimation.evidence import averaged, likelier, posterior_at
from trueaxis.estimation.fitted import Fitted, evidence_ratio
from trueaxis.estimation.giving_way import giving_way
from trueaxis.estimation.instrument_sizes import as_expected
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.left_out import Contradiction, contradictions
from trueaxis.estimation.misread import SURE, Misread, Refit, mean_square, misread_runs, unexplained
from trueaxis.estimation.noise_of_residuals import SMALLEST
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.orders import higher_degrees
from trueaxis.estimation.own_part import beside
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.result import Estimate, InstrumentNoise, Iteration, ReadingsLeft
from trueaxis.estimation.rounds import CONTINUED_ROUNDS, MOST_ROUNDS, SEARCH_ROUNDS, determined, settled
from trueaxis.estimation.runs import MeasuredRun, measured_runs
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.state import State, linearised, of_runs, started
from trueaxis.estimation.steps import moved
from trueaxis.estimation.swapped import Turned, likely_set_ups
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel

MOST_STEPS = 20
STILL = 1e-3  # of the standard uncertainty of an unknown: a last step below it changes nothing that is said of it
EXACT = 1e-6  # the same without a prior: readings without noise then give the errors back
LEAST_STEP = 1e-12  # of the size of an unknown: rounding
NO_NOISE = 2.0  # times the least noise: readings simulated without any were estimated to have up to 1.5 times it
LEAST_SQUARE = 1.0 / 9.0  # of residuals over their stated noise: below, it is three times too large or more


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class EstimationOptions:
    """noise: standard deviation of the readings of runs, by index, mm; that of an instrument is estimated unless all of
    its runs are there; start: values of effects, which spare the search of those that the readings do not depend on
    linearly; prior: whether anything is expected of the machine's errors: if not, what the readings do not determine is
    zero, and `open`; ideal: whether nothing is unknown of the instruments; degree: of the curves; None:
    with a prior as high as readings tell, else DEGREE; changes: whether readings are changes against values given: one
    run may then hold all that has changed, and contradicts nothing.
    """

    noise: Mapping[int, float] = field(default_factory=dict)
    start: Sequence[EffectValues] = ()
    prior: bool = True
    ideal: bool = False
    degree: int | None = None
    changes: bool = False


USUAL = EstimationOptions()


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _Setting:
    """What every estimation of one data set shares."""

    model: MachineModel
    observed: Observations
    given: ErrorValues
    runs: tuple[MeasuredRun, ...]
    options: EstimationOptions
    degrees: Mapping[ErrorName, int] = field(default_factory=dict)  # of curves of higher orders than others

    def started(self, effects: EffectUnknowns) -> tuple[State, Sizes]:
        """Nothing estimated yet."""
        degree = self.options.degree or DEGREE
        layout = layout_of(
            self.model, self.observed, self.given, effects, degree, self.degrees, turns=self.options.prior
        )
        layout = giving_way(layout, self.runs)
        state = started(layout, self.runs, self.given, self.options.noise)
        return state, Sizes(layout, state.own_kinds, flat=not self.options.prior, ideal=self.options.ideal)


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
    setting = _Setting(
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


def _searched(setting: _Setting, effects: EffectUnknowns, effect: Effect, kind: Kind) -> EffectUnknowns:
    """The effects and one more, started beside a rough estimate of all others."""
    state, sizes = setting.started(effects.without([effect]))
    x, state, _ = settled(state, sizes, SEARCH_ROUNDS)
    posterior, _ = determined(sizes, posterior_at(sizes, linearised(state), x))  # by the noise as it is now
    state = moved(state, posterior, sizes.own_scales(x))
    return with_searched(state.layout.effects, effect, kind, beside(state, sizes, x, posterior))


def _estimated(setting: _Setting, effects: EffectUnknowns) -> Estimate:
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
    misread, contradicting = _wrong(setting, Fitted(state=state, sizes=sizes, x=x), posterior)
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
            misread=misread,
            contradicting=tuple(contradicting),
            freedom=float((~outliers).sum()) - posterior.told,
        ),
        iteration=Iteration(rounds=rounds, steps=steps, last_step=last, last_change=change, converged=converged),
    )


def _higher_degrees(setting: _Setting, effects: EffectUnknowns, fitted: Fitted) -> dict[ErrorName, int]:
    """Of curves that end at an order which readings tell; none where no prior says how orders shrink.

    Where residuals are far from a noise that is stated, by one that is estimated: by a noise far too small readings
    would tell any order, and the curves follow what is wrong with them.
    """
    options = setting.options
    if options.degree is not None or not options.prior:
        return {}
    if options.noise and not _as_stated(fitted.state):
        state, sizes = replace(setting, options=replace(options, noise={})).started(effects)
        x, state, _ = settled(state, sizes, MOST_ROUNDS)
        fitted = Fitted(state=state, sizes=sizes, x=x)
    return higher_degrees(fitted.state.layout, fitted.posterior())


def _without_noise(state: State) -> bool:
    """Whether no estimated noise is above the least: outliers among what rounding leaves never come to rest."""
    return all(one.sigma < NO_NOISE * SMALLEST for name, one in state.noise.items() if name not in state.stated)


def _as_stated(state: State) -> bool:
    """Whether residuals are as large as a noise that is stated."""
    return LEAST_SQUARE < mean_square(state) <= 1.0


def _wrong(setting: _Setting, fitted: Fitted, posterior: Posterior) -> tuple[dict[int, Misread], list[Contradiction]]:
    """Runs that were misread, and those that contradict the others whatever is wrong with them.

    Where residuals are far from a noise that is stated, by one that is estimated. Changes show neither: what was given
    is no part of them, so a reversed sign is not undone by reversing it.
    """
    if setting.options.changes:
        return {}, []
    state, noise, options = fitted.state, setting.options.noise, setting.options
    kept = dict(zip((one.rows.index for one in state.runs), state.kept, strict=False))

    def refit(runs: Sequence[MeasuredRun]) -> Fitted:
        of_runs = tuple(kept[one.rows.index] for one in runs) if kept else ()
        begun = started(state.layout, tuple(runs), setting.given, noise, of_runs)
        sizes = Sizes(state.layout, begun.own_kinds, flat=not options.prior, ideal=options.ideal)
        x, found, _ = settled(begun, sizes, MOST_ROUNDS)
        return Fitted(state=found, sizes=sizes, x=x)

    def continued(runs: Sequence[MeasuredRun]) -> Fitted:
        begun = of_runs(fitted.state, runs)
        sizes = Sizes(state.layout, begun.own_kinds, flat=not options.prior, ideal=options.ideal)
        x, found, _ = settled(begun, sizes, MOST_ROUNDS, sizes.taken(fitted.sizes, fitted.x), CONTINUED_ROUNDS)
        return Fitted(state=found, sizes=sizes, x=x)

    if noise and not _as_stated(state):
        noise = {}
        fitted = refit(setting.runs)
        posterior = fitted.posterior()
    misread = misread_runs(fitted, posterior, continued, refit)
    sure = {index: one for index, one in misread.items() if one.sure}
    others = unexplained(fitted, sure, refit) if sure else contradictions(fitted, posterior, continued, SURE)
    elsewise = {index for one in others for index in one.runs}
    misread = {index: one for index, one in misread.items() if index not in elsewise}
    sure = {index: one for index, one in misread.items() if one.sure}
    swapped = _by_another_set_up(setting, fitted, sure, elsewise, refit)
    if not swapped:
        return misread, others
    return {index: one for index, one in misread.items() if one.partner is None} | swapped, []


def _by_another_set_up(
    setting: _Setting, fitted: Fitted, misread: Mapping[int, Misread], contradicting: Collection[int], refit: Refit
) -> dict[int, Misread]:
    """The two runs that were made each by the set-up of the other, or the one that sensed along another direction, if
    that explains most of what is wrong.

    Positions go with the readings: other than where readings alone are in each other's place. What all runs of an
    instrument have is not the set-up of one.
    """
    single = (index for index, one in misread.items() if not one.together)
    wrong = [*contradicting, *sorted(single, key=lambda index: -misread[index].log_odds)]
    found = dict[int, Misread]()
    for other in likely_set_ups(fitted, wrong, refit, SURE):
        if isinstance(other, Turned):
            relabelled = setting.observed.turned(other.index, other.direction)
        else:
            relabelled = setting.observed.exchanged(*other.places)
        there = replace(setting, observed=relabelled, runs=tuple(measured_runs(relabelled)))
        begun, sizes = there.started(fitted.state.layout.effects)
        x, state, _ = settled(begun, sizes, MOST_ROUNDS)
        gain = evidence_ratio(fitted, Fitted(state=state, sizes=sizes, x=x)) - float(np.log(other.among))
        if gain <= max([SURE, *(one.log_odds for one in {**misread, **found}.values())]):
            continue
        if isinstance(other, Turned):
            found = {other.index: Misread(how="turned", log_odds=gain, direction=other.direction)}
        else:
            first, second = other.places
            found = {
                first: Misread(how="swapped", log_odds=gain, partner=second),
                second: Misread(how="swapped", log_odds=gain, partner=first),
            }
    return found
