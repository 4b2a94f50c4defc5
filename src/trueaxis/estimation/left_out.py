"""Runs that contradict all others, whatever is wrong: swapped, zeroed elsewhere, a ball that stands elsewhere.

With d what a run, or all runs of a set-up or a session, differs by from what the others let expect, and S its
covariance, d' S^-1 d is chi^2 where nothing is wrong. An estimate from all readings has it already: with e its whitened
residuals and P = 1 - J Sigma J' what it leaves of the noise, d = P^-1 e and S = P^-1. It was drawn towards the wrong
run, in values, sizes and noise. So the likeliest run is left out on trial, all is estimated without it, and it is
judged by what is then expected of it.

A run is judged by its own noise: what no error of a machine or a set-up could be, beside the noise of its instrument,
which counts for AS_MANY readings as everywhere. What that noise is where an error could be as well, it says by its form
alone, which however many readings tell no better than AS_MANY: so many are the degrees of freedom.
"""

from collections.abc import Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import block_diag, null_space, qr

from trueaxis.estimation.evidence import posterior_at
from trueaxis.estimation.fitted import Continued, Fitted
from trueaxis.estimation.instruments import CLASSES, own_kinds
from trueaxis.estimation.jacobian import Derivative, derivatives
from trueaxis.estimation.noise import Whitening
from trueaxis.estimation.noise_of_residuals import AS_MANY
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.reduce import run_triangle
from trueaxis.estimation.residuals import residual_of
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.estimation.state import linearised
from trueaxis.estimation.tails import log_f_tail
from trueaxis.measurement.machine import FloatArray

MOST = 0.25  # share of the runs that may contradict the others: beyond it the model does
AS_FAR = 0.95  # of the distance of several runs: one run is set up wrongly more often than all of its set-up are
TRIALS = 3  # suspects that are left out on trial, each at the cost of an estimate
TOLD = 0.1  # of the noise: what an unknown changes readings by, as large as expected, from where on it counts as such
NOTHING = 1e-6  # of the noise: a variance that is rounding, where the others let expect nothing of a direction
MOST_DIRECTIONS = 800  # of a group: half a second; of larger ones the runs are judged alone

Group = tuple[int, ...]  # runs, by their index


@dataclass(frozen=True, slots=True)
class Far:
    """How far runs are from what others let expect. log_p: logarithm of the probability that noise takes them as far;
    times: root mean square of that, in units of its standard deviation; log_density: of whitened readings, but for a
    constant.
    """

    log_p: float
    times: float
    log_density: float


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Contradiction:
    """Runs by their index. times: how far they are from what the others let expect, in units of its standard deviation,
    root mean square of several directions; log_p: logarithm of the probability that they are as far by noise;
    zeros_free: the same where their own zeros may be anything; without: (n,), the unknowns as the others tell them,
    without runs that contradicted them before either; spread: (n, r), a root of their covariance.
    """

    runs: Group
    times: float
    log_p: float
    zeros_free: float
    without: FloatArray
    spread: FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _Rows:
    """A run in the r directions in which unknowns may change its readings: own (r, k), whitened derivatives by its own
    unknowns in their sizes (k, 1), mm or rad, and others (r, n); left: (r,), what is left of the readings; noise:
    variance of what is left in all other directions; beside: minus twice the logarithm of the density of that.
    """

    own: FloatArray
    others: FloatArray
    sizes: FloatArray
    left: FloatArray
    noise: float
    beside: float


def contradictions(
    fitted: Fitted, posterior: Posterior, continued: Continued, sure: float
) -> list[Contradiction] | None:
    """Runs that contradict the others, one after the other; None where more than MOST of all do: the model does.

    posterior: of the fitted state; continued: goes on from it (of 10 suspects that contradicted, an estimate from the
    beginning, at three times the cost, found a logarithm at most 6 % larger); sure: minus the logarithm of the
    probability below which it is not noise.
    """
    groups, found, given_up = _groups(fitted.state.runs), list[Contradiction](), set[int]()
    most = MOST * len(fitted.state.runs)
    while len(given_up) <= most:
        for wrong in _suspects(fitted, posterior, groups)[:TRIALS]:
            others = _others(fitted.state.runs, wrong)
            members = [one for one in fitted.state.runs if one.rows.index in wrong]
            without = continued(fitted, others)
            wide, expected = widest(without)
            far = beside_others(wide, expected, members, fitted.scales)
            if far.log_p < -sure:
                break
        else:
            return found
        free = beside_others(wide, expected, members, fitted.scales, zeros_free=True)
        found.append(contradiction(wrong, far, free, wide, expected))
        given_up |= set(wrong)
        groups = [one for one in groups if not given_up & set(one)]
        fitted, posterior = without, without.posterior()
    return None


def widest(without: Fitted) -> tuple[Fitted, Posterior]:
    """An estimate by the largest sizes and waviest curves that a machine may have, and its posterior: what no run but
    the one that is left out sees is not known by how smooth all else is.
    """
    sizes = without.sizes
    x = sizes.widest(without.x)
    expected = posterior_at(sizes, linearised(without.state), x)
    state = replace(without.state, unknowns=expected.mean * without.state.layout.sizes)
    return Fitted(state=state, sizes=sizes, x=x), expected


def contradiction(runs: Group, far: Far, free: Far, without: Fitted, expected: Posterior) -> Contradiction:
    """Of runs that are so far from an estimate without them, and so far where zeros are free."""
    return Contradiction(
        runs=runs,
        times=far.times,
        log_p=far.log_p,
        zeros_free=free.times,
        without=without.state.unknowns,
        spread=expected.spread * without.state.layout.sizes[:, np.newaxis],
    )


def _suspects(fitted: Fitted, posterior: Posterior, groups: Sequence[Group]) -> list[Group]:
    """Groups of which at most one would be as far from all others by chance, the farthest first.

    Of runs that agree with one another, all are farther from the others than each alone: in place of a group stands
    what in it is farthest by its readings, a single run where that is nearly as far.
    """
    every = beside_all(fitted, posterior, [one for one in groups if _others_tell(fitted.state.runs, one)])
    suspects = {group: far for group, far in every.items() if far.log_p < -np.log(len(groups))}
    farthest = [
        max(
            (one for one in suspects if set(one) <= set(group)),
            key=lambda one: suspects[one].times * (1.0 if len(one) == 1 else AS_FAR),
        )
        for group in sorted(suspects, key=lambda one: suspects[one].log_p)
    ]
    return list(dict.fromkeys(farthest))


def _groups(runs: Sequence[MeasuredRun]) -> list[Group]:
    """Each run, and all of a set-up, of an instrument in a session, or of a session, which agree with one another; none
    beyond MOST.
    """
    members: dict[Hashable, list[int]] = {}
    for one in runs:
        run = one.rows.run
        home = tuple(sorted(run.home.items()))
        set_up = (run.instrument, run.device, run.session, run.target, run.reference, run.frame, run.direction, home)
        for key in (one.rows.index, set_up, (run.instrument, run.device, run.session), run.session):
            members.setdefault(key, []).append(one.rows.index)
    return [one for one in dict.fromkeys(map(tuple, members.values())) if len(one) <= MOST * len(runs)]


def _others(runs: Sequence[MeasuredRun], group: Group) -> list[MeasuredRun]:
    return [one for one in runs if one.rows.index not in group]


def _others_tell(runs: Sequence[MeasuredRun], group: Group) -> bool:
    """Whether what is left of the runs tells the noise of those of the group."""
    noises = {one.noise_group for one in runs if one.rows.index in group}
    return noises <= {one.noise_group for one in _others(runs, group)}


def beside_all(fitted: Fitted, posterior: Posterior, groups: Sequence[Group]) -> dict[Group, Far]:
    """Each group by the estimate from all runs, at its sizes and noise; posterior: of it."""
    rows: dict[int, _Rows] = {}
    by_others: dict[int, FloatArray] = {}
    alone: dict[int, FloatArray] = {}
    state = fitted.state
    for place, one in enumerate(state.runs):
        index, own = one.rows.index, posterior.own[place]
        each = state.derivatives_kept(place)
        mine = rows[index] = _rows(fitted, posterior, one, each, state.residual[place], float(state.scales[place]))
        by_others[index] = mine.own @ (own.by_others / mine.sizes) + mine.others @ posterior.spread
        alone[index] = mine.own @ (own.alone / mine.sizes)
    found = {}
    for group in groups:
        if len(group) > 1 and sum(rows[index].left.size for index in group) > MOST_DIRECTIONS:
            continue
        spread, of_run = (
            np.vstack([by_others[index] for index in group]),
            block_diag(*(alone[index] for index in group)),
        )
        kept = np.eye(spread.shape[0]) - spread @ spread.T - of_run @ of_run.T
        among = [rows[index] for index in group]
        found[group] = _far(among, kept + (kept * (_noise(among) - 1.0)) @ kept, NOTHING)
    return found


def beside_others(
    without: Fitted,
    expected: Posterior,
    runs: Sequence[MeasuredRun],
    scales: Mapping[int, float],
    *,
    zeros_free: bool = False,
) -> Far:
    """Runs together by an estimate without them.

    expected: its posterior; scales: of the noise of runs by index, by which runs of a stated noise are whitened;
    zeros_free: whether the zero of each of them may be anything.
    """
    layout, now = without.state.layout, without.state
    model = layout.model.with_values(layout.values(now.unknowns, now.given))
    rows, zeros = [], []
    for one in runs:
        kinds = own_kinds(one.rows.run, layout.straightness[one.rows.index])
        left = residual_of(layout, model, one, now.unknowns, np.zeros(len(kinds)))
        scale = scales[one.rows.index] if one.noise_group in now.stated else 1.0
        rows.append(_rows(without, expected, one, derivatives(layout, one.kept()), left, scale))
        zeros.append(rows[-1].own[:, [CLASSES[kind].zero for kind in kinds]])
    spread, of_run = np.vstack([one.others for one in rows]) @ expected.spread, block_diag(*(one.own for one in rows))
    covariance = spread @ spread.T + of_run @ of_run.T + np.diag(_noise(rows))
    return _far(rows, covariance, seen=null_space(block_diag(*zeros).T) if zeros_free else None)


def _noise(rows: Sequence[_Rows]) -> FloatArray:
    return np.concatenate([np.full(one.left.size, one.noise) for one in rows])


def _rows(
    fitted: Fitted,
    posterior: Posterior,
    one: MeasuredRun,
    each: Iterable[Derivative],
    left: FloatArray,
    scale: float,
) -> _Rows:
    """each: derivatives of the readings that count; left: (n,), of all readings, mm; scale: of the noise of the run by
    which its readings are whitened.
    """
    state, kept = fitted.state, one.kept()
    kinds = own_kinds(kept.run, state.layout.straightness[kept.index])
    whiten = Whitening(state.noise[one.noise_group], kept.steps, scale)
    counts = len(kinds), state.layout.count
    triangle = run_triangle(each, left[one.good], whiten, counts)
    sizes = fitted.sizes.own_scale(kinds, fitted.x)
    by_size = triangle[:, :-1] * np.concatenate([sizes, posterior.scale])
    turned, root, _ = qr(by_size, mode="economic", pivoting=True)
    directions = turned[:, np.abs(np.diag(root)) > TOLD]
    rest = triangle[:, -1] - directions @ (directions.T @ triangle[:, -1])
    further = max(int(one.good.sum()) - directions.shape[1], 0)
    usual = 1.0 if one.noise_group in state.stated else 1.0 / scale**2
    square = float(rest @ rest)
    noise = (AS_MANY * usual + square) / (AS_MANY + further)
    return _Rows(
        own=directions.T @ by_size[:, : sizes.size],
        others=directions.T @ triangle[:, sizes.size : -1],
        sizes=sizes[:, np.newaxis],
        left=directions.T @ triangle[:, -1],
        noise=noise,
        beside=square / noise + further * float(np.log(noise)),
    )


def _far(rows: Sequence[_Rows], covariance: FloatArray, least: float = 0.0, seen: FloatArray | None = None) -> Far:
    """By what is left of the readings of some runs, and its covariance.

    least: variance up to which a direction has none; seen: (k, q), directions that count, else all.
    """
    left = np.concatenate([one.left for one in rows])
    if seen is not None:
        left, covariance = seen.T @ left, seen.T @ covariance @ seen
    variance, turned = np.linalg.eigh(covariance)
    told = variance > least
    square, k = float(np.sum((turned.T @ left)[told] ** 2 / variance[told])), max(int(told.sum()), 1)
    density = -0.5 * (square + float(np.log(variance[told]).sum()) + sum(one.beside for one in rows))
    return Far(log_f_tail(square / k, k, AS_MANY), float(np.sqrt(square / k)), density)
