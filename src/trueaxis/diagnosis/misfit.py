"""Runs that no errors of the machine fit: of the wrong sign, swapped, or set up elsewhere.

Each run is judged by what all others expect of it. The worst is given up, and the others are judged anew, until all
fit. Where many would have to go it is no run that is wrong, but the model.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import solve_triangular

from trueaxis.diagnosis.noise import noise_of_runs
from trueaxis.diagnosis.null import Null, lent
from trueaxis.diagnosis.result import FloatArray
from trueaxis.diagnosis.tails import log_f_tail
from trueaxis.diagnosis.whiten import whitening

FALSE_ALARMS = 1e-4  # share of sound data in which one run or other is taken for wrong
WIDE = 4.0  # times what is expected of errors of the machine: by that factor [prior] may be wrong
MISFIT = 2.0  # times its noise, of what a wrong run differs by: causes are not quite of the forms of the library
NOISIER = 3.0  # times the noise of others that a run may have: beyond it what it reads is no noise
MOST = 0.25  # share of the runs that may be wrong
FAR = 3.0  # times the median of what runs differ by from what the others expect, from where one stands out
MOST_ALIKE = 5  # runs that are tried as the wrong one

Group = tuple[int, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Against:
    """A group of runs against what all others expect. far: squares per direction, over its noise; log_p: logarithm of
    the p value; excess: squares beyond those of noise.
    """

    group: Group
    far: float
    log_p: float
    excess: float


def misfits(null: Null, signal: FloatArray) -> tuple[str, ...]:
    """Ids of these runs, the worst first; where several are as likely to be the wrong one, all of these.

    A run, or all of a set-up, which agree with one another. signal: (n,), mm, of causes.
    """
    runs = [one.rows.run.id for one in null.base.runs]
    null = replace(null, values=null.values - signal)
    setup = [int(null.rows.setup[one.rows.at[0]]) for one in null.base.runs]
    same = [tuple(k for k, one in enumerate(setup) if one == number) for number in dict.fromkeys(setup)]
    groups = [*((place,) for place in range(len(runs))), *(one for one in same if len(one) > 1)]
    given_up: Group = ()
    found: list[int] = []
    while wrong := _wrong(null, groups, given_up):
        # what is as far from a wrong run as that is from it is no worse: the wrong one is that without which all fit
        left = {one: sum(_wrong(null, groups, given_up + one).values()) for one in list(wrong)[:MOST_ALIKE]}
        worst = min(left, key=lambda one: (left[one], len(one)))
        alike = [one for one in left if left[one] == left[worst] == 0.0 and len(one) == len(worst)]
        found += [*worst, *(place for one in alike for place in one)]
        given_up += worst
        if len(given_up) > MOST * len(runs):
            return ()
    return tuple(dict.fromkeys(runs[place] for place in found))


def _wrong(null: Null, groups: Sequence[Group], given_up: Group) -> dict[Group, float]:
    """Groups that do not fit, with their excess, the worst first.

    Repeats that differ are noise, unless one of them is farther from what the others expect than all others are: then
    the noise is what is left without it.
    """
    against = against_others(_without(null, given_up), groups, given_up)
    farthest = max(against, key=lambda one: one.far, default=None)
    if farthest is not None and farthest.far > FAR**2 * float(np.median([one.far for one in against])):
        against = against_others(_without(null, given_up + farthest.group), groups, given_up)
    limit = float(np.log(FALSE_ALARMS / max(len(against), 1)))
    sure = [one for one in against if one.log_p < limit and one.far > MISFIT**2]
    return {one.group: one.excess for one in sorted(sure, key=lambda one: -one.excess)}


def _without(null: Null, given_up: Group) -> Null:
    """With the noise that the other runs tell."""
    kept = [one for place, one in enumerate(null.base.runs) if place not in given_up]
    names = {one.instrument for one in kept}
    left_out = [place for place in given_up if null.base.runs[place].instrument in names]
    if not left_out or null.found is None:
        return null
    some = null.only(~np.isin(null.rows.run, [null.base.runs[place].rows.index for place in left_out]))
    noises, _, _ = noise_of_runs(some.rows, some.base, some.values, None, None)
    return lent(null, replace(some, whitening=whitening(some.rows.run, noises, some.base.own)))


def against_others(null: Null, groups: Sequence[Group], given_up: Group = ()) -> list[Against]:
    """Of groups none of whose runs is given up.

    With r what an estimate from all runs leaves of whitened readings, and A the part of their variance that it takes,
    r' (1 - A)^-1 r are the squares of what a group differs by from what the others expect. From directions that errors
    of the machine have no part in its own noise is told.
    """
    base = null.base
    wide = np.where(np.arange(base.expected.size) < base.of_machine, WIDE, 1.0) * base.expected
    white = base.columns.times(np.diag(wide)).beside(base.by_chance).whitened(null.whitening)
    read = np.split(null.whitening(null.values), white.starts[1:-1])
    inside = [few.T @ one for few, one in zip(white.few, read, strict=True)]
    outside = [float(one @ one - few @ few) for one, few in zip(read, inside, strict=True)]
    run = np.repeat(np.arange(len(read)), [one.size for one in inside])
    kept, every = ~np.isin(run, given_up), np.concatenate(inside)
    r = np.linalg.qr(np.vstack([white.weights[kept], np.eye(white.weights.shape[1])]), mode="r")
    half = solve_triangular(r, white.weights.T, trans="T")
    rest = every - half.T @ (half[:, kept] @ every[kept])
    of_noise = {one.instrument: one.freedom for one in null.noise}
    found = []
    for group in groups:
        mine = np.isin(run, group)
        k = int(mine.sum())
        freedom = sum(read[place].size - int(null.whitening.own_count[place]) for place in group)
        if k == 0 or freedom <= k or set(group) & set(given_up):
            continue
        squares = float(rest[mine] @ np.linalg.solve(np.eye(k) - half[:, mine].T @ half[:, mine], rest[mine]))
        apart = sum(outside[place] for place in group)
        noise = min(max(apart / (freedom - k), 1.0), NOISIER**2)
        log_p = log_f_tail(squares / k / noise, k, min(of_noise[base.runs[place].instrument] for place in group))
        found.append(Against(group, squares / k / noise, log_p, squares + apart - freedom))
    return found
