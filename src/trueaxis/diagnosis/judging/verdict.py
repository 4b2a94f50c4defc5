"""When a name may be given, and what the diagnosis comes to."""

from collections.abc import Sequence

import numpy as np

from trueaxis.diagnosis.causes.search import Ground, Search, cause_columns
from trueaxis.diagnosis.causes.signature import Fitted
from trueaxis.diagnosis.judging.amplitudes import Uneven
from trueaxis.diagnosis.judging.instruments import Off
from trueaxis.diagnosis.judging.structure import Check
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.result import Stale, Verdict

HOMOGENEOUS = 1e-4  # p value below which the amplitudes of a cause are not one
PRACTICALLY_ALL = 0.97  # share from which neither a remainder nor differences between places take the name back
SIGNIFICANT = 2.0  # standard uncertainties: from where 95 % of the sizes that are possible are of one sign


def explained_share(
    ground: Ground,
    found: Search,
    causes: Sequence[Fitted],
    checks: Sequence[Check],
    uneven: Sequence[Uneven],
    standing: Sequence[Fitted] = (),
    hard: Projection | None = None,
) -> float:
    """Share that the causes have of the whitened squares beyond those of noise.

    standing: those the model has already; hard: the base without them, where there are any. What is left is the most of
    what the checks that fired say, what all residuals come to, forms taken as exact, and what a cause has more at one
    place than at the others.
    """
    if not causes and not standing:
        return 0.0
    hard = hard or ground.plain
    nothing = np.zeros(ground.values.size)
    before = hard.rest(ground.values + ground.whitening(sum((one.signal for one in standing), nothing)))
    after = ground.plain.extended(cause_columns(ground, found.causes)).rest(ground.values)
    explained = float(before @ before) - float(after @ after)
    freedom = found.residual.size - found.projection.rank
    besides = [one.excess for one in uneven if one.p_value <= HOMOGENEOUS] + [one.excess for one in checks if one.fired]
    left = max(float(after @ after) - freedom, 0.0, *besides)
    return explained / (explained + left) if explained > 0.0 else 0.0


def names_stand(share: float, checks: Sequence[Check], uneven: Sequence[Uneven]) -> bool:
    """Whether causes found may be named: one amplitude everywhere and nothing left, or next to nothing."""
    nothing_left = not any(check.fired for check in checks) and all(one.p_value > HOMOGENEOUS for one in uneven)
    return nothing_left or share >= PRACTICALLY_ALL


def verdict_of(
    found: Search,
    stand: bool,
    checks: Sequence[Check],
    stale: Sequence[Stale],
    off: Sequence[Off],
    misfits: Sequence[str] = (),
) -> Verdict:
    """What it all comes to. off: instruments that are; misfits: runs that no errors of the machine fit."""
    if misfits:
        return "unexplained_structure"
    if found.causes and stand:
        return "ambiguous" if any(one.rivals for one in found.causes) else "explained"
    if found.causes or (any(check.fired for check in checks) and not stand):
        return "unexplained_structure"
    if off:
        return "explained"
    return "recalibrate" if stale else "no_discrepancy"


def size_is_significant(one: Fitted) -> bool:
    """Whether a size of a cause exceeds what it is uncertain by: what has none is no answer, however likely."""
    sized = np.array([each.role not in ("phase", "grid") for each in one.kind.parameters])
    return bool((np.abs(one.values[sized]) > SIGNIFICANT * one.u[sized]).any())
