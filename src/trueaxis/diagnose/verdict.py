"""When a name may be given, and what the diagnosis comes to."""

from collections.abc import Sequence

from trueaxis.diagnose.result import Check, Verdict
from trueaxis.diagnose.search import Search

HOMOGENEOUS = 1e-4  # p value below which the amplitudes of a cause are not one
NEARLY_ALL = 0.97  # share of what was to be explained from which a remainder does not take the name back


def explained_share(found: Search) -> float:
    """Share of the whitened squares beyond those of noise that the causes account for."""
    freedom = found.residual.size - found.projection.rank
    left = max(float(found.residual @ found.residual) - freedom, 0.0)
    explained = sum(one.scan.statistic - one.scan.freedom for one in found.causes)
    return explained / (explained + left) if explained > 0.0 else 0.0


def names_stand(share: float, checks: Sequence[Check], homogeneous_p: Sequence[float]) -> bool:
    """Whether causes found may be named: one amplitude everywhere, and nothing left, or next to nothing."""
    fired = any(check.fired for check in checks)
    return all(p > HOMOGENEOUS for p in homogeneous_p) and (not fired or share >= NEARLY_ALL)


def verdict_of(found: Search, stand: bool, checks: Sequence[Check], recalibrate: bool) -> Verdict:
    """What it all comes to."""
    if found.causes and stand:
        return "ambiguous" if any(one.rivals for one in found.causes) else "explained"
    if found.causes or any(check.fired for check in checks):
        return "unexplained_structure"
    return "recalibrate" if recalibrate else "no_discrepancy"
