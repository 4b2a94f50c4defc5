"""How far a compensated program relies on what was measured, and whether that is too far."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from trueaxis.compensate.machine import FloatArray
from trueaxis.compensate.visited import Visited
from trueaxis.runtime.covariance import Covariance
from trueaxis.runtime.extent import UncertaintyExtent, uncertainty_extent
from trueaxis.runtime.measured_range import BeyondMeasured, beyond_measured
from trueaxis.runtime.model import MachineModel
from trueaxis.runtime.uncertainty import prior_size

# Corrections that the prior makes likely: three standard deviations. What is larger comes from a slip (um for mm, a
# sign, another machine's values) far more often than from a machine.
PRIOR_SIZES = 3.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Limits:
    """max_u: largest standard uncertainty of the tool point, mm, None: any. max_correction: largest correction, mm;
    None: `PRIOR_SIZES` times what errors of the prior's sizes make of the tool point there.
    """

    max_u: float | None = None
    max_correction: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Reliance:
    """uncertainty: of the tool point at the places of the program, relative to home; beyond: use beyond the measured
    range (places, not blocks, are counted). largest_correction and allowed_correction (None where nothing moves), mm,
    at the place `correction_at` (axis positions, mm and deg) where the first is the largest share of the second.
    too_uncertain, too_large: which of the limits is passed; nothing may then be written.
    """

    uncertainty: UncertaintyExtent
    beyond: tuple[BeyondMeasured, ...]
    largest_correction: float
    allowed_correction: float | None
    correction_at: dict[str, float]
    too_uncertain: bool
    too_large: bool

    @property
    def refused(self) -> bool:
        """Whether the program must not be written."""
        return self.too_uncertain or self.too_large


Judge = Callable[[Visited], Reliance]


def judge_of(model: MachineModel, covariance: Covariance, tool_point: FloatArray, limits: Limits) -> Judge:
    """What judges the places that a program came to; tool_point: (3, 1), mm, tool frame."""

    def judge(visited: Visited) -> Reliance:
        positions, corrections = visited.positions, visited.corrections
        extent = uncertainty_extent(model, covariance, positions, tool_point)
        allowed = np.full(corrections.size, limits.max_correction or np.inf)
        if limits.max_correction is None:
            allowed = PRIOR_SIZES * prior_size(model, positions, tool_point)
        worst = int(np.argmax(corrections / allowed)) if corrections.size else None
        return Reliance(
            uncertainty=extent,
            beyond=beyond_measured(model.errors, model.axes, np.hstack([positions, visited.ends])),
            largest_correction=0.0 if worst is None else float(corrections[worst]),
            allowed_correction=None if worst is None else float(allowed[worst]),
            correction_at={} if worst is None else dict(zip(model.axes, positions[:, worst].tolist(), strict=True)),
            too_uncertain=limits.max_u is not None and extent.counted > limits.max_u,
            too_large=worst is not None and bool(corrections[worst] > allowed[worst]),
        )

    return judge
