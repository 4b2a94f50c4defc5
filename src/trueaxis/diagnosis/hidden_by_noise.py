"""What the noise, estimated without any cause, may have taken up: candidates beside which it is estimated anew."""

import numpy as np

from trueaxis.diagnosis.scan import LN10, Scanned
from trueaxis.diagnosis.search import FURTHER, Found, Ground, Search, beside_causes, zoomed
from trueaxis.estimation.tails import log_f_tail

LIKELIEST = 3  # candidates below the threshold, beside which the noise is estimated anew


def likeliest(ground: Ground, found: Search) -> list[Found]:
    """The few candidates with the best evidence, none of which reached the threshold: the noise may hold them."""
    scans = sorted(found.last, key=lambda one: -one.evidence)[:LIKELIEST]
    residual = ground.left(ground.base)
    return [zoomed(ground, residual, one) for one in scans if one.evidence > 0.0]


def in_noise_of_a_run(ground: Ground, found: Search) -> Found | None:
    """What would be a further cause if the noise of the runs that it acts on were what it leaves there: an instrument
    that slips once makes a run of its own noise. The likeliest; None where there is none.

    The evidence is that of a t test by these readings alone, whose noise is unknown.
    """
    rows, most = ground.readings.rows, ground.threshold + FURTHER * bool(found.causes)
    best: Scanned | None = None
    for one in found.last:
        if not one.effect.runs:
            continue
        mine = np.isin(rows.run, [index for index, run in enumerate(rows.runs) if run.id in one.effect.runs])
        left = float(found.residual[mine] @ found.residual[mine]) - one.statistic
        freedom = int(mine.sum()) - one.freedom
        if left <= 0.0 or freedom <= 0 or one.statistic <= 0.0:
            continue
        log_p = log_f_tail(one.statistic / one.freedom / (left / freedom), one.freedom, freedom)
        evidence = -log_p / LN10 - float(np.log10(one.tries))
        if evidence > most:
            best, most = one, evidence
    return None if best is None else zoomed(ground, ground.left(beside_causes(ground, found.causes)), best)
