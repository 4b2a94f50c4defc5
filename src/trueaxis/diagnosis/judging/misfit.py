"""Runs that no errors of the machine fit: of the wrong sign, swapped, or set up elsewhere.

A run, all runs of a set-up, or of a session is a candidate like a cause: what it explains is what all readings come
nearer to the others when it is left out. Errors of the machine are by chance as large as [prior] may be wrong.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import solve_triangular
from scipy.special import logsumexp

from trueaxis.diagnosis.causes.search import FALSE_ALARMS
from trueaxis.diagnosis.judging.gain import VAGUE
from trueaxis.diagnosis.judging.verdict import PRACTICALLY_ALL
from trueaxis.diagnosis.null_model.by_run import ByRun
from trueaxis.diagnosis.null_model.noise import noise_of_runs
from trueaxis.diagnosis.null_model.noise_fit import NOISIEST, UNEVEN
from trueaxis.diagnosis.null_model.null import Null, balls_anywhere, lent
from trueaxis.diagnosis.null_model.whiten import whitening
from trueaxis.diagnosis.result import FloatArray
from trueaxis.estimation.tails import log_f_tail

MISFIT = 2.0  # times its noise, RMS of what a wrong run differs by: noise is not quite of the form that it is taken for
CLOSE = 0.5  # share of the squares of the farthest from which a group may be the wrong one in its place
FARTHER, PLACES = 6.0, 49  # standard deviations of that logarithm over which it is averaged, and at how many values
MOST = 0.25  # share of the runs that may be wrong: beyond it the model is

Group = tuple[int, ...]  # places of runs in the base


@dataclass(frozen=True, slots=True, eq=False)
class Known:
    """Causes beside which runs are judged. signals: (n, k), mm, free in size; besides: (n, m), mm, what they may do
    besides, one standard deviation.
    """

    signals: FloatArray
    besides: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Against:
    """A group of runs against what all others expect. squares: of what it differs by, over its noise; log_p: logarithm
    of the p value.
    """

    group: Group
    squares: float
    log_p: float


def misfits(null: Null, known: Known) -> tuple[str, ...]:
    """Ids of these runs, the worst first; where several are as likely to be the wrong one, all of these.

    Repeats that differ are noise, unless one of them is farther from what the others expect than noise takes it: the
    noise is what is left without the likeliest.
    """
    if MOST * len(null.base.runs) < 1.0:
        return ()
    null = balls_anywhere(null)
    signal = np.split(null.whitening(known.signals.sum(axis=1)), null.base.columns.starts[1:-1])
    caused = np.array([float(one @ one) for one in signal])
    judged, given_up = _Judged(null, caused, _columns(null, known), groups_of(null)), Group()
    found = list[int]()
    while True:
        against = judged.against(given_up)
        likeliest = min(against, key=lambda one: one.log_p, default=None)
        if likeliest is None or likeliest.log_p > -np.log(len(judged.groups)):
            break
        wrong = judged.sure(against)
        if not wrong:
            judged = replace(judged, null=_without(null, given_up + likeliest.group))
            wrong = judged.sure(judged.against(given_up))
        if not wrong:
            break
        # what is as far from a wrong run as that is from it is no worse: the wrong one is that without which all fit
        close = [one.group for one in wrong if one.squares > CLOSE * wrong[0].squares]
        left = {one: sum(each.squares for each in judged.sure(judged.against(given_up + one))) for one in close}
        worst = min(left, key=lambda one: (left[one], len(one)))
        alike = [one for one in left if left[one] == left[worst] == 0.0 and len(one) == len(worst)]
        judged = replace(judged, null=_without(null, given_up + worst))
        if not any(one.group in left for one in judged.sure(judged.against(given_up, own_noise=True))):
            break  # they may be as noisy as they are
        found += [*worst, *(place for one in alike for place in one)]
        given_up += worst
        if len(given_up) > MOST * len(null.base.runs):
            return ()
    return tuple(dict.fromkeys(null.base.runs[place].rows.run.id for place in found))


@dataclass(frozen=True, slots=True, eq=False)
class _Judged:
    """caused: (n_runs,), whitened squares of what causes do; columns: see `_columns`."""

    null: Null
    caused: FloatArray
    columns: ByRun
    groups: Sequence[Group]

    def against(self, given_up: Group, *, own_noise: bool = False) -> list[Against]:
        return against_others(self.null, self.columns, self.groups, given_up, own_noise=own_noise)

    def sure(self, against: Sequence[Against]) -> list[Against]:
        """Groups that do not fit, the worst first."""
        limit = np.log(FALSE_ALARMS / len(self.groups))
        sure = [one for one in against if one.log_p < limit and one.squares > self._least(one)]
        return sorted(sure, key=lambda one: -one.squares)

    def _least(self, one: Against) -> float:
        """What noise and causes that are not quite of their forms may come to."""
        group = list(one.group)
        readings = np.diff(self.columns.starts)[group].sum()
        return float(MISFIT**2 * readings + (1.0 - PRACTICALLY_ALL) * self.caused[group].sum())


def groups_of(null: Null) -> list[Group]:
    """Each run, and all of a set-up or a session, which agree with one another."""
    runs = [one.rows for one in null.base.runs]
    keys = [
        [("run", k), ("set-up", int(null.rows.mounted[run.at[0]])), ("session", run.run.session)]
        for k, run in enumerate(runs)
    ]
    found: dict[object, list[int]] = {}
    for place, of_run in enumerate(keys):
        for key in of_run:
            found.setdefault(key, []).append(place)
    return list(dict.fromkeys(tuple(one) for one in found.values() if len(one) <= MOST * len(runs) or len(one) == 1))


def _columns(null: Null, known: Known) -> ByRun:
    """Of all that readings vary by beside their noise, one standard deviation each."""
    base = null.base
    free = known.signals * (VAGUE / np.maximum(np.abs(known.signals).max(axis=0, initial=0.0), 1e-300))
    return base.columns.times(np.diag(base.wide())).beside(np.hstack([base.by_chance, known.besides, free]))


def _without(null: Null, given_up: Group) -> Null:
    """With the noise that the other runs tell."""
    if null.found is None:
        return null
    some = null.only(~np.isin(null.rows.run, [null.base.runs[place].rows.index for place in given_up]))
    noises, _, _ = noise_of_runs(some.rows, some.base, some.values, None, null.found)
    return balls_anywhere(lent(null, replace(some, whitening=whitening(some.rows.run, noises, some.base.free))))


def against_others(
    null: Null, columns: ByRun, groups: Sequence[Group], given_up: Group = (), *, own_noise: bool = False
) -> list[Against]:
    """Of groups none of whose runs is given up. columns: one standard deviation each.

    With r what an estimate from all runs leaves of whitened readings, and A the part of their variance that it takes,
    r' (1 - A)^-1 r are the squares of what a group differs by from what the others expect. own_noise: the noise of a
    run is normal in its logarithm about that of its instrument, and what no column can be tells of it.
    """
    base = null.base
    white = columns.whitened(null.whitening)
    read = np.split(null.whitening(null.values), white.starts[1:-1])
    within = [few.T @ one for few, one in zip(white.few, read, strict=True)]
    noise, spread = np.ones(len(read)), np.zeros(len(read))
    if own_noise:
        log, spread = np.transpose([_log_noise(one, some) for one, some in zip(read, within, strict=True)])
        noise = np.exp(log)
    run = np.repeat(np.arange(len(read)), [few.shape[1] for few in white.few])
    every, weights = np.concatenate(within) / noise[run], white.weights / noise[run][:, np.newaxis]
    kept = ~np.isin(run, given_up)
    r = np.linalg.qr(np.vstack([weights[kept], np.eye(weights.shape[1])]), mode="r")
    half = solve_triangular(r, weights.T, trans="T")
    rest = every - half.T @ (half[:, kept] @ every[kept])
    freedom = {one.group: one.freedom for one in null.noise}
    found = []
    for group in groups:
        mine = np.isin(run, group)
        k = int(mine.sum())
        if k == 0 or set(group) & set(given_up):
            continue
        strength, turned = np.linalg.eigh(np.eye(k) - half[:, mine].T @ half[:, mine])
        told = strength > 1e-9
        squares = float(np.sum((turned.T @ rest[mine])[told] ** 2 / strength[told]))
        least = min(freedom[base.runs[place].noise_group] for place in group)
        k = int(told.sum())
        among = float(np.linalg.norm(spread[list(group)])) / len(group)
        found.append(Against(group, squares, _log_p(squares / k, k, least, among)))
    return found


def _log_noise(read: FloatArray, within: FloatArray) -> tuple[float, float]:
    """Logarithm of the noise of a run over that of its instrument, and its standard deviation. read: (n,), whitened
    readings; within: (k,), their part that columns may be.
    """
    rest, further = float(read @ read - within @ within), read.size - within.size
    told = 2.0 * further  # by n squares the logarithm of a standard deviation is known to 1/(2 n), its variance
    log = 0.5 * float(np.log(max(rest, 1e-300) / further)) if further else 0.0
    precision = UNEVEN**-2 + told
    return float(np.clip(told * log / precision, 0.0, NOISIEST)), precision**-0.5


def _log_p(ratio: float, k: int, freedom: float, spread: float) -> float:
    """Logarithm of the probability that k squares are `ratio` on average, by a noise whose logarithm is known to
    `spread`.
    """
    z = np.linspace(0.0, FARTHER, PLACES) if spread else np.zeros(1)
    weight = np.exp(-0.5 * z**2)
    tails = [log_f_tail(ratio * float(np.exp(-2.0 * spread * one)), k, freedom) for one in z]
    return float(logsumexp(tails, b=weight / weight.sum()))
