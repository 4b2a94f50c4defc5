"""Where an estimation stands: linearised, whitened, its noise and outliers renewed."""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.estimation.display import display_steps, rounded
from trueaxis.estimation.factors import triangle_of
from trueaxis.estimation.instruments import own_kinds
from trueaxis.estimation.jacobian import (
    Derivative,
    RunRows,
    beside_effects,
    derivatives,
    with_common_few,
    without_effects,
)
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.noise import Noise, Whitening
from trueaxis.estimation.noise_of_residuals import AS_MANY, first_noise, noise_of_draws
from trueaxis.estimation.outliers import WINDOW, Judged, excess, shared_by_repeats, spoilt, surely_none
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.reduce import Reduced, reduced
from trueaxis.estimation.residuals import residuals_of
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.errors import ErrorValues

KEPT = 50_000_000  # entries of derivatives that are kept: 400 MB, less than a million readings need without
# of the posterior, from which the noise is taken: as many residuals as tell it to half a percent of that of one draw
DRAWS, DRAWN = 8, 40_000
LEAST_SQUARE = 1.0 / 9.0  # of residuals over their stated noise: below, it is three times too large or more


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class State:
    """layout: linearised at the unknowns; given: values that are taken as they are; stated: groups of runs whose noise
    is known, white and 1, the scales of their runs being the noise in mm; display: step of the readings of each group,
    mm; noise: of each group; scales: of each run;
    unknowns: (n,), own: of each run, mm, rad or 1; residual: of each run, mm; kept: derivatives of each run's readings,
    where they fit into the memory and stay, without effects where theirs change.
    """

    layout: Layout
    given: ErrorValues
    runs: tuple[MeasuredRun, ...]
    stated: frozenset[str]
    display: Mapping[str, float]
    noise: Mapping[str, Noise]
    scales: FloatArray
    unknowns: FloatArray
    own: tuple[FloatArray, ...]
    residual: tuple[FloatArray, ...]
    kept: tuple[tuple[Derivative, ...], ...] = ()

    @property
    def own_kinds(self) -> list[tuple[str, ...]]:
        """Classes of the own unknowns of every run."""
        return [own_kinds(one.rows.run, self.layout.straightness[one.rows.index]) for one in self.runs]

    def whitening(self, place: int, rows: RunRows) -> Whitening:
        """Of the rows that count of the run at a place; a measurement that is written in two frames counts once."""
        one, scale = self.runs[place], float(self.scales[place])
        return Whitening(self.noise[one.noise_group], rows.steps, scale * float(np.sqrt(one.frames)))

    def derivatives(self, place: int) -> Iterable[Derivative]:
        """Of all readings of the run at a place, piece by piece."""
        rows = self.runs[place].rows
        if not self.kept:
            return derivatives(self.layout, rows)
        return beside_effects(self.layout, rows, self.kept[place]) if self.layout.effects.curved else self.kept[place]

    def derivatives_kept(self, place: int) -> Iterator[Derivative]:
        """The same of the readings that count."""
        start = 0
        for one in self.derivatives(place):
            yield one.of(self.runs[place].good[start : start + one.place.size])
            start += one.place.size


def started(
    layout: Layout,
    runs: tuple[MeasuredRun, ...],
    given: ErrorValues,
    stated_noise: Mapping[int, float],
    kept: tuple[tuple[Derivative, ...], ...] = (),
) -> State:
    """Nothing known but the values at which effects are linearised; stated_noise: mm, of runs by index; kept:
    derivatives of these runs that are at hand.
    """
    kinds = [own_kinds(one.rows.run, layout.straightness[one.rows.index]) for one in runs]
    unknowns, own = layout.start(), tuple(np.zeros(len(of_run)) for of_run in kinds)
    residual = residuals_of(layout, runs, unknowns, own, given)
    unstated = {one.noise_group for one in runs if one.rows.index not in stated_noise}
    display = display_steps(runs)
    found = _first_noise(runs, residual, unstated, display)
    scales = [1.0 if one.noise_group in unstated else stated_noise[one.rows.index] for one in runs]
    return State(
        layout=layout.at(unknowns, given),
        given=given,
        runs=runs,
        stated=frozenset(found) - unstated,
        display=display,
        noise=found,
        scales=np.array(scales),
        unknowns=unknowns,
        own=own,
        residual=tuple(residual),
        kept=kept or _kept(layout, runs),
    )


def _first_noise(
    runs: Sequence[MeasuredRun],
    residual: Sequence[FloatArray],
    unstated: Collection[str],
    display: Mapping[str, float],
) -> dict[str, Noise]:
    found: dict[str, Noise] = {}
    for name in sorted({one.noise_group for one in runs}):
        mine = [rest[one.good] for one, rest in zip(runs, residual, strict=True) if one.noise_group == name]
        found[name] = rounded(first_noise(mine), display[name]) if name in unstated else Noise(1.0)
    return found


def with_first_noise(state: State) -> State:
    """With noise and scales as at the start, by what is left of the readings that count."""
    stated = np.array([one.noise_group in state.stated for one in state.runs])
    noise = _first_noise(state.runs, state.residual, set(state.noise) - state.stated, state.display)
    return replace(state, noise=noise, scales=np.where(stated, state.scales, 1.0))


def _kept(layout: Layout, runs: Sequence[MeasuredRun]) -> tuple[tuple[Derivative, ...], ...]:
    """Derivatives of each run's readings, without effects where their columns change; none where they take too much
    memory, or effects move the points of the runs.

    They are of first order about the machine without errors: nothing else changes them.
    """
    if layout.effects.moves_points:
        return ()
    of_run = without_effects if layout.effects.curved else derivatives
    found, entries = [], 0
    for one in runs:
        parts = []
        for part in of_run(layout, one.rows):
            entries += part.own.size + part.few.size + part.others.size
            if entries > KEPT:
                return ()
            parts.append(part)
        found.append(with_common_few(parts))
    return tuple(found)


def of_runs(state: State, runs: Sequence[MeasuredRun]) -> State:
    """What it is of some of its runs, whose readings may be others than they were."""
    place_of = {one.rows.index: place for place, one in enumerate(state.runs)}
    places = [place_of[one.rows.index] for one in runs]
    groups = {one.noise_group for one in runs}
    return replace(
        state,
        runs=tuple(runs),
        stated=state.stated & groups,
        display={name: one for name, one in state.display.items() if name in groups},
        noise={name: one for name, one in state.noise.items() if name in groups},
        scales=state.scales[places],
        own=tuple(state.own[place] for place in places),
        residual=tuple(
            state.residual[place] + (one.reading - state.runs[place].reading)
            for place, one in zip(places, runs, strict=True)
        ),
        kept=tuple(state.kept[place] for place in places) if state.kept else (),
    )


def linearised(state: State) -> Reduced:
    """What the readings that count, whitened, say of the unknowns."""
    kept = [one.kept() for one in state.runs]
    left = [rest[one.good] for one, rest in zip(state.runs, state.residual, strict=True)]
    whitenings = [state.whitening(place, rows) for place, rows in enumerate(kept)]
    each = [state.derivatives_kept(place) for place in range(len(kept))]
    return reduced(state.layout, kept, whitenings, left, state.unknowns, state.own, each)


def with_noise(state: State, posterior: Posterior, draw: np.random.Generator, known: bool = False) -> State:
    """With the noise of every group of runs whose noise is not stated, from residuals of draws of the posterior.

    known: whether its shape is nearly as it is already.
    """
    normal = draw.standard_normal((posterior.spread.shape[1], DRAWS))
    own = [
        one.by_others @ normal + one.alone @ draw.standard_normal((one.alone.shape[1], DRAWS)) for one in posterior.own
    ]
    others = posterior.spread @ normal
    draws = []
    for place, (one, rest) in enumerate(zip(state.runs, state.residual, strict=True)):
        change = [part.change(own[place], others) for part in state.derivatives_kept(place)]
        draws.append(rest[one.good][:, np.newaxis] - np.concatenate(change))
    noise, scales = dict(state.noise), state.scales.copy()
    for name in sorted(state.noise.keys() - state.stated):
        members = [place for place, one in enumerate(state.runs) if one.noise_group == name]
        steps = [state.runs[place].kept().steps for place in members]
        enough = -(-DRAWN // max(sum(one.size for one in steps), 1))
        found, scales[members] = noise_of_draws(
            [draws[place][:, :enough] for place in members], steps, state.noise[name] if known else None
        )
        noise[name] = rounded(found, state.display[name])
    return replace(state, noise=noise, scales=scales)


def same_readings(one: State, other: State) -> bool:
    """Whether the same readings count."""
    return all((a.good == b.good).all() for a, b in zip(one.runs, other.runs, strict=True))


def counting(state: State) -> bytes:
    """Which readings count, as one key."""
    return np.packbits(np.concatenate([one.good for one in state.runs])).tobytes()


def without_outliers(state: State, posterior: Posterior, sharp: bool) -> State:
    """With the readings that count judged anew. posterior: of the state, or nearly.

    sharp: by the noise that a run has without those that are far, and what was left out stays out; else by its noise as
    it was estimated: as long as effects and noise are not found yet, what they make of single readings is no outlier.
    """
    readings = sum(one.reading.size for one in state.runs)
    runs = []
    for place, (one, rest) in enumerate(zip(state.runs, state.residual, strict=True)):
        noise, _ = _noise_of_run(state, place)
        usual = float(state.scales[place]) ** -2.0
        if one.good.all() and surely_none(rest, noise, one.rows.steps, usual, readings):
            runs.append(one)
            continue
        good = ~spoilt(_judged(state, posterior, place, sharp), readings)
        runs.append(replace(one, good=one.good & good if sharp else good))
    return replace(state, runs=tuple(runs))


def _noise_of_run(state: State, place: int) -> tuple[Noise, float]:
    """Of the run at a place, and by what it is more than a noise that is stated, 1 at least."""
    one, scale = state.runs[place], float(state.scales[place])
    more = excess(state.residual[place], scale) if one.noise_group in state.stated else 1.0
    return state.noise[one.noise_group].sized(more * scale), more


def _judged(state: State, posterior: Posterior, place: int, sharp: bool) -> Judged:
    """The readings of the run at a place beside what the estimate makes of them."""
    one, rest = state.runs[place], state.residual[place]
    noise, more = _noise_of_run(state, place)
    taken = np.zeros((rest.size, 0))
    if rest.size <= WINDOW:  # of a longer run no reading is known by what the others say of the unknowns
        whiten = Whitening(noise, one.kept().steps)
        of_good = more * _root(state, posterior, place)
        taken = np.zeros((rest.size, of_good.shape[1]))
        taken[one.good] = whiten.transposed(whiten.every(of_good))
    return Judged(
        steps=one.rows.steps,
        left=rest,
        shared=shared_by_repeats(rest, one.repeats),
        good=one.good,
        noise=noise,
        chance=np.zeros((rest.size, 0)),
        taken=taken,
        usual=float(state.scales[place]) ** -2.0,
        told=AS_MANY if sharp and one.noise_group not in state.stated else np.inf,
    )


def _root(state: State, posterior: Posterior, place: int) -> FloatArray:
    """(m, k), mm: of the covariance of what the posterior says of the readings that count of a short run."""
    (part,) = state.derivatives_kept(place)
    own = posterior.own[place]
    by_others = triangle_of([np.vstack([part.others @ posterior.spread, own.by_others]).T]).T
    return np.hstack([np.hstack([part.by_few, part.own]) @ by_others, part.own @ own.alone])


def mean_square(state: State) -> float:
    """Of the residuals that count, over their noise."""
    white = [
        state.whitening(place, one.kept())(state.residual[place][one.good][:, np.newaxis])
        for place, one in enumerate(state.runs)
    ]
    return float(np.mean(np.vstack(white) ** 2))


def as_stated(state: State) -> bool:
    """Whether residuals are as large as a noise that is stated."""
    return LEAST_SQUARE < mean_square(state) <= 1.0
