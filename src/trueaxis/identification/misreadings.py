"""Readings that cannot be what the set-up says: runs that contradict the others, and all readings too small."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from trueaxis.estimation.misread import SURE, How, Misread
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.tool_point import ORIGIN, moved_without
from trueaxis.identification.fit_quality import MISFIT_OF_RUN, FitQuality
from trueaxis.identification.words import enumerated
from trueaxis.model.errors import Fit

READS: Mapping[How, str] = {
    "reversed": "as if its sign were reversed (reading, direction in setup.toml, or sense of an axis)",
    "small": "as if it were 1000 times too small (m written for mm? of an angle, a file not in rad?)",
    "large": "as if it were 1000 times too large (um written for mm? mrad for rad?)",
    "mirrored": "as if its targets were labelled from the other end (positions in readings.csv)",
}
# By which errors of a machine may be smaller than [prior] says, all classes of them at once: 0.7 um and 1.7 urad by the
# default sizes are better than machines are, and a factor of 1000 in the unit is far beyond.
LEAST_MACHINE = 1.0 / 30.0
# mm: less than any instrument scatters in a shop, where air and temperature alone make some ten nanometres in a metre.
LEAST_NOISE = 2e-5


def with_misread(judged: FitQuality, observed: Observations, found: Estimate) -> FitQuality:
    """A misfit where runs are misread for sure, or contradict the others by much: the values follow them, too."""
    sure = {observed.runs[index].id: one for index, one in found.readings.misread.items() if one.sure}
    reasons, named = [_of_runs(sure) if sure else _of_all(found)], tuple(sure)
    if _matter(found):
        reasons, named = [*reasons, _of_contradicting(observed, found)], named + _contradicting(observed, found)
    reason = "; ".join(filter(None, reasons))
    return replace(judged, fit=Fit("misfit", judged.fit.chi2, named), reason=reason) if reason else judged


def misread_notes(observed: Observations, found: Estimate) -> tuple[str, ...]:
    """Runs that may be misread, with the odds, and those that contradict the others but change little."""
    contradict = () if _matter(found) or not found.readings.contradicting else (_of_contradicting(observed, found),)
    return contradict + tuple(
        f"run {observed.runs[index].id} may read {READS[one.how]}: by a factor of {np.exp(one.log_odds):.2g} the "
        "readings are likelier so, which is not enough to be sure"
        for index, one in found.readings.misread.items()
        if not one.sure
    )


def _of_runs(sure: Mapping[str, Misread]) -> str:
    if len(sure) == 1:
        ((run, one),) = sure.items()
        return f"run {run} reads {READS[one.how]}"
    kinds = {one.how for one in sure.values()}
    if len(kinds) == 1:
        return f"runs {', '.join(sure)}: one of them at least reads {READS[kinds.pop()]}"
    return "; ".join(f"run {run} reads {READS[one.how]}" for run, one in sure.items())


def _contradicting(observed: Observations, found: Estimate) -> tuple[str, ...]:
    """Ids of the runs, the surest first."""
    return tuple(observed.runs[index].id for one in found.readings.contradicting for index in one.runs)


def _matter(found: Estimate) -> bool:
    """Whether runs that contradict the others do so by more than noise of any form and a zero that is far off, or what
    is said of the tool point does not hold where they are wrong.
    """
    each = found.readings.contradicting
    if not each:
        return False
    moved, u = moved_without(found, [ORIGIN])
    return moved > u or max(one.zeros_free for one in each) > MISFIT_OF_RUN


def _of_contradicting(observed: Observations, found: Estimate) -> str:
    runs = _contradicting(observed, found)
    moved, u = moved_without(found, [ORIGIN])
    far = max(one.times for one in found.readings.contradicting)
    verb, them = ("contradicts", "it") if len(runs) == 1 else ("contradict", "them")
    return (
        f"run{'s' if len(runs) > 1 else ''} {enumerated(runs)} {verb} all others, by {far:.2g} times the noise; "
        f"without {them} the tool point moves by {moved * 1e3:.2g} um in the volume, where u is {u * 1e3:.2g} um "
        "(are runs swapped, is a target, reference, home or ball not where setup.toml says, or does the model lack an "
        "effect? diagnose tells more)"
    )


def _of_all(found: Estimate) -> str:
    """Why all readings together are too small to be in mm; empty where they are not."""
    off = [(found.factors[name], odds) for name, odds in found.likelier.items() if odds > 0.0]
    factors, odds = np.array(off).reshape(-1, 2).T
    if odds.sum() <= SURE or factors.max() > 1.0:
        return ""
    # each class counts by what the readings tell of its size
    size = float(np.exp(np.average(np.log(factors), weights=odds)))
    # not the noise that is estimated, which is no less than a stated resolution
    left = float(np.sqrt(np.mean(found.readings.residual[~found.readings.outliers] ** 2)))
    if size > LEAST_MACHINE or left > LEAST_NOISE:
        return ""
    return (
        f"all readings are too small to be in mm (are they in m?): errors are 1/{1.0 / size:.0f} of what [prior] says, "
        f"and the residuals are {left * 1e6:.2g} nm"
    )
