"""When a name may be given, and what the diagnosis comes to."""

from collections.abc import Mapping, Sequence

import numpy as np

from trueaxis.diagnosis.causes.search import Ground, Search, cause_columns
from trueaxis.diagnosis.causes.signature import Fitted
from trueaxis.diagnosis.judging.amplitudes import Uneven
from trueaxis.diagnosis.judging.off import Off
from trueaxis.diagnosis.judging.structure import Check, StructureClass
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.result import Stale, Verdict
from trueaxis.effects.expression import names, parse
from trueaxis.effects.placement import SINCE_REVERSAL

HOMOGENEOUS = 1e-4  # p value below which the amplitudes of a cause are not one
PRACTICALLY_ALL = 0.97  # share from which neither a remainder nor differences between places take the name back
_TURNING = frozenset({"direction", *SINCE_REVERSAL})
DUE_TO: Mapping[StructureClass, frozenset[str]] = {  # variables of the causes that make a check fire
    StructureClass.LINE_DIRECTION: _TURNING | {"v"},
    StructureClass.LINE_DIRECTION_BY_LINE: _TURNING | {"v"},
    StructureClass.LINE_RIPPLE: _TURNING | {"v"},
    StructureClass.LINE_LOCAL: _TURNING,
    StructureClass.LINE_COURSE: _TURNING,
    StructureClass.LINE_TEMPERATURE: frozenset({"t", "T"}),
    StructureClass.LINE_BY_LINE: frozenset({"s_b", "q_b", "along", "t", "T"}),
    StructureClass.CIRCLE_COURSE: _TURNING,
    StructureClass.CIRCLE_DIRECTION: _TURNING | {"v"},
    StructureClass.CIRCLE_RIPPLE_DIRECTION: _TURNING | {"v"},
    StructureClass.CIRCLE_FEED: frozenset({"v"}),
    StructureClass.CIRCLE_DIRECTION_FEED: _TURNING | {"v"},
    StructureClass.CIRCLE_REVERSALS: _TURNING,
    StructureClass.CIRCLE_AFTER_REVERSALS: _TURNING,
    StructureClass.ERROR_DIRECTION: _TURNING | {"v"},
    StructureClass.ERROR_AFTER_REVERSALS: _TURNING | {"v"},
    StructureClass.ERROR_COURSE: _TURNING | {"t", "T"},
    StructureClass.ONE_PERIOD: _TURNING | {"q", "s"},  # cycles of one run
}
SIGNIFICANT = 2.0  # standard uncertainties: from where 95 % of the sizes that are possible are of one sign
# share of what was to be explained from which a remainder of that class does not take the name back: the lost motion of
# a real axis (docs/real-data.md) is not the same everywhere. Of some 400 cases of random worlds it decides two
NEARLY_ALL = 0.9


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


def names_stand(share: float, causes: Sequence[Fitted], checks: Sequence[Check], uneven: Sequence[Uneven]) -> bool:
    """Whether causes found may be named: one amplitude everywhere, and nothing left, or next to nothing.

    A little more may be left where all of it is of the class that the causes themselves are of: theirs is then not
    quite the form of the kind.
    """
    fired = [check for check in checks if check.fired]
    fired = [
        check for check in fired if check.structure is not StructureClass.LACK_OF_FIT
    ] or fired  # of what kind it is, others say
    one_size = all(one.p_value > HOMOGENEOUS for one in uneven) or share >= PRACTICALLY_ALL
    if not fired or share >= PRACTICALLY_ALL:
        return one_size
    used = {each.name for one in causes if one.kind.expression for each in names(parse(one.kind.expression))}
    of_their_class = all(DUE_TO.get(check.structure, frozenset()) & used for check in fired)
    return one_size and share >= NEARLY_ALL and of_their_class


def verdict_of(
    found: Search,
    stand: bool,
    checks: Sequence[Check],
    stale: Sequence[Stale],
    off: Sequence[Off],
    misfits: Sequence[str] = (),
    or_changed: Sequence[str] = (),
) -> Verdict:
    """What it all comes to. off: instruments that are; misfits: runs that no errors of the machine fit; or_changed:
    components whose values may have changed in place of the cause.
    """
    if misfits:
        return "unexplained_structure"
    if found.causes and stand:
        rivals = [*(one.rivals for one in found.causes), *(one.instead for one in off)]
        return "ambiguous" if or_changed or any(rivals) else "explained"
    if found.causes or (any(check.fired for check in checks) and not stand):
        return "unexplained_structure"
    if off:
        return "ambiguous" if any(one.instead for one in off) else "explained"
    return "recalibrate" if stale else "no_discrepancy"


def size_is_significant(one: Fitted) -> bool:
    """Whether a size of a cause exceeds what it is uncertain by: what has none is no answer, however likely."""
    sized = np.array([each.role not in ("phase", "grid") for each in one.kind.parameters])
    return bool((np.abs(one.values[sized]) > SIGNIFICANT * one.u[sized]).any())
