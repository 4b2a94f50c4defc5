"""Which runs are wrong: the fewest mistakes with which no run contradicts the others."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from trueaxis.estimation.fitted import Continued, Fitted, Refit, evidence_ratio
from trueaxis.estimation.left_out import Contradiction, contradictions
from trueaxis.estimation.misread import SURE, Misread, misread_runs
from trueaxis.estimation.other_set_ups import other_set_ups
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.rounds import CONTINUED_ROUNDS, MOST_ROUNDS, settled
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.estimation.setting import Setting
from trueaxis.estimation.state import as_stated, of_runs, started

# times: what is right leaves no more noise than there was, but for readings that count again. A line 0.1 mm off
# was likelier as another's, and contradicted nothing then, by a noise of 18 um in place of 0.4 um
NOISIER = 2.0


@dataclass(frozen=True, slots=True)
class WrongRuns:
    """misread: runs by index that are likelier with a fault undone; contradicting: runs that contradict the others with
    these undone, too, whatever is wrong with them; mistakes: how many they are, where several runs have one together.
    """

    misread: Mapping[int, Misread] = field(default_factory=dict)
    contradicting: Sequence[Contradiction] = ()
    mistakes: int = 0


def wrong_runs(setting: Setting, fitted: Fitted, posterior: Posterior) -> WrongRuns:
    """Those of an estimate. posterior: of what is fitted.

    Where residuals are far from a noise that is stated, by one that is estimated. Changes show none: what was given is
    no part of them, so a reversed sign is not undone by reversing it.
    """
    if setting.options.changes:
        return WrongRuns()
    refit, noise = _refit(setting, fitted, setting.options.noise), setting.options.noise
    if noise and not as_stated(fitted.state):
        refit = _refit(setting, fitted, {})
        fitted = refit(setting.runs)
        posterior = fitted.posterior()
    continued = _continued(setting)
    found = _fewest_mistakes(fitted, posterior, continued, refit)
    return _by_another_set_up(setting, fitted, found, continued, refit) or found


def _fewest_mistakes(fitted: Fitted, posterior: Posterior, continued: Continued, refit: Refit) -> WrongRuns:
    """Misread runs, and what contradicts the others with these undone; or, where those are more mistakes, what
    contradicts the others as all were read.

    Sound runs may be likelier with some fault undone where others are wrong that have none of the known faults.
    """
    found = misread_runs(fitted, posterior, continued, refit)
    after = found.undone.posterior() if found.mistakes else posterior
    left = contradictions(found.undone, after, continued, SURE) or []
    elsewise = {index for one in left for index in one.runs}
    held = [runs for runs in found.mistakes if not runs & elsewise]
    if found.mistakes and left:
        as_read = contradictions(fitted, posterior, continued, SURE) or []
        if 0 < len(as_read) < len(held) + len(left):
            unsure = {index: one for index, one in found.runs.items() if not one.sure}
            return WrongRuns(unsure, as_read, len(as_read))
    misread = {index: one for index, one in found.runs.items() if index not in elsewise}
    return WrongRuns(misread, left, len(held) + len(left))


def _refit(setting: Setting, fitted: Fitted, noise: Mapping[int, float]) -> Refit:
    """An estimate of runs from the beginning. noise: that is stated, of runs by index, mm."""
    state = fitted.state
    kept = dict(zip((one.rows.index for one in state.runs), state.kept, strict=False))

    def refit(runs: Sequence[MeasuredRun]) -> Fitted:
        of_runs = tuple(kept[one.rows.index] for one in runs) if kept else ()
        begun = started(state.layout, tuple(runs), setting.given, noise, of_runs)
        sizes = setting.sizes(begun)
        x, found, _ = settled(begun, sizes, MOST_ROUNDS)
        return Fitted(state=found, sizes=sizes, x=x)

    return refit


def _continued(setting: Setting) -> Continued:
    """An estimate of runs that goes on from another."""

    def continued(before: Fitted, runs: Sequence[MeasuredRun]) -> Fitted:
        begun = of_runs(before.state, runs)
        sizes = setting.sizes(begun)
        x, found, _ = settled(begun, sizes, MOST_ROUNDS, sizes.taken(before.sizes, before.x), CONTINUED_ROUNDS)
        return Fitted(state=found, sizes=sizes, x=x)

    return continued


def _by_another_set_up(
    setting: Setting, fitted: Fitted, among: WrongRuns, continued: Continued, refit: Refit
) -> WrongRuns | None:
    """What setup.toml may have said of some runs, if that explains most of what is wrong and leaves no more than was
    wrong. What it leaves is told once it is mended: its unknowns may be others than those of the estimate.
    """
    misread = {index: one for index, one in among.misread.items() if one.sure}
    single = (index for index, one in misread.items() if not one.together)
    contradicting = {index for one in among.contradicting for index in one.runs}
    wrong = [*contradicting, *sorted(single, key=lambda index: -misread[index].log_odds)]
    others = {index: one for index, one in among.misread.items() if one.partner is None}
    most, found = max([SURE, *(one.log_odds for one in misread.values())]), None
    for other in other_set_ups(fitted, setting.observed, wrong, misread, refit, SURE):
        begun, sizes = setting.of(other.observed).started(fitted.state.layout.effects)
        x, state, _ = settled(begun, sizes, MOST_ROUNDS)
        so = Fitted(state=state, sizes=sizes, x=x)
        gain = evidence_ratio(fitted, so) - float(np.log(other.among))
        noisier = any(one.sigma > NOISIER * fitted.state.noise[name].sigma for name, one in state.noise.items())
        if gain <= most or noisier:
            continue
        left = contradictions(so, so.posterior(), continued, SURE)
        if left is None or 1 + len(left) > among.mistakes:
            continue
        made = {index: replace(one, log_odds=gain) for index, one in other.misread.items()}
        most, found = gain, WrongRuns(others | made, mistakes=1 + len(left))
    return found
