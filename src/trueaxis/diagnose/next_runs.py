"""Which further run would tell more."""

from collections.abc import Sequence

from trueaxis.diagnose.audit import Audit
from trueaxis.diagnose.result import Cause, NextRun
from trueaxis.diagnose.search import Ground
from trueaxis.effects.kind import Effect


def next_runs(ground: Ground, audit: Audit, causes: Sequence[Cause]) -> tuple[NextRun, ...]:
    """Runs."""
    return ()


def separating_run(ground: Ground, effect: Effect, rivals: Sequence[Effect]) -> str:
    """Run."""
    return ground.readings.model.machine.kinds[effect.kind].broken_by if rivals else ""
