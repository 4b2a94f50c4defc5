"""Readings that cannot be what the set-up says: runs that contradict the others, and all readings too small."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from trueaxis.estimation.misread import SURE, How, Misread
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.identification.fit_quality import FitQuality
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
    """A misfit where runs are misread for sure: the values follow them, too."""
    sure = {observed.runs[index].id: one for index, one in found.readings.misread.items() if one.sure}
    reason = _of_runs(sure) if sure else _of_all(found)
    if not reason:
        return judged
    return replace(judged, fit=Fit("misfit", judged.fit.chi2, tuple(sure)), reason=reason)


def misread_notes(observed: Observations, found: Estimate) -> tuple[str, ...]:
    """Runs that may be misread, with the odds."""
    return tuple(
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
