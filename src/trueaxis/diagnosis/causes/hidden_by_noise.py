"""What the noise, estimated without any cause, may have taken up: candidates beside which it is estimated anew."""

import numpy as np

from trueaxis.diagnosis.causes.scan import Scanned
from trueaxis.diagnosis.causes.search import FURTHER, Found, Ground, Search, beside_causes, zoomed
from trueaxis.estimation.tails import LN10, log_f_tail

LIKELIEST = 3  # candidates below the threshold, beside which the noise is estimated anew


def likeliest(ground: Ground, found: Search) -> list[Found]:
    """The few candidates with the best evidence, none of which reached the threshold: the noise may hold them."""
    scans = sorted(found.last, key=lambda one: -one.evidence)[:LIKELIEST]
    residual = ground.left(ground.base)
    return [zoomed(ground, residual, one) for one in scans if one.evidence > 0.0]


def in_noise_of_a_run(ground: Ground, search: Search) -> Found | None:
    """The likeliest candidate, of those that act on single runs, that the noise of these runs may hide, or None.

    A laser that slips once makes its run look noisy: judged by that noise, the step is none.
    Evidence as of any candidate, but by an F test against what the candidate leaves of the readings of its runs: their
    noise counts as unknown. The base's share of the degrees of freedom is not taken off: whether the candidate is a
    cause decides the search with the noise that is estimated beside it.
    """
    rows, most = ground.readings.rows, ground.threshold + FURTHER * bool(search.causes)
    best: Scanned | None = None
    for scan in search.last:
        if not scan.effect.runs:
            continue
        reached = np.isin(rows.run, [index for index, run in enumerate(rows.runs) if run.id in scan.effect.runs])
        left = float(search.residual[reached] @ search.residual[reached]) - scan.statistic
        freedom = int(reached.sum()) - scan.freedom
        if left <= 0.0 or freedom <= 0 or scan.statistic <= 0.0:
            continue
        log_p = log_f_tail(scan.statistic / scan.freedom / (left / freedom), scan.freedom, freedom)
        evidence = -log_p / LN10 - float(np.log10(scan.tries))
        if evidence > most:
            best, most = scan, evidence
    return None if best is None else zoomed(ground, ground.left(beside_causes(ground, search.causes)), best)
