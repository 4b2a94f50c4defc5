"""Figures of a positioning test by VDI/DGQ 3441, from the same readings as those of ISO 230-2.

The guideline (VDI/DGQ 3441:1977, withdrawn) is still what many acceptance sheets ask for. Its text was not at hand: the
definitions are those by which its figures are commonly given, written out in `figures_of`. They count 3 standard
deviations to each side where ISO 230-2 counts 2, and take the mean of both directions for the scatter.
"""

from dataclasses import asdict, dataclass

import numpy as np

from trueaxis.evaluation.positioning_test import Evaluation

GUIDELINE = "VDI/DGQ 3441"
SIGMAS = 6  # standard deviations that the positional scatter spans


@dataclass(frozen=True, slots=True, kw_only=True)
class Vdi3441:
    """Figures of an axis, mm or deg as the test. P: positional uncertainty; Pa: positional deviation; Ps_max, Ps_mean:
    largest and mean positional scatter; U_max, U_mean: largest and mean reversal error, both without sign.
    """

    P: float
    Pa: float
    Ps_max: float
    Ps_mean: float
    U_max: float
    U_mean: float

    def named(self) -> dict[str, float]:
        """The figures by the guideline's symbols."""
        return asdict(self)


def figures_of(evaluation: Evaluation) -> Vdi3441 | None:
    """None of a test with one cycle, which tells no scatter.

    With x the mean of both mean deviations of a target, U = |x+ - x-| and Ps = 6 (s+ + s-) / 2 there:
    Pa = max x - min x, P = max (x + (U + Ps) / 2) - min (x - (U + Ps) / 2).
    """
    if evaluation.cycles == 1:
        return None
    reversal = np.abs(evaluation.b)
    scatter = SIGMAS * (evaluation.positive.s + evaluation.negative.s) / 2
    half = (reversal + scatter) / 2
    return Vdi3441(
        P=float((evaluation.mean + half).max() - (evaluation.mean - half).min()),
        Pa=float(np.ptp(evaluation.mean)),
        Ps_max=float(scatter.max()),
        Ps_mean=float(scatter.mean()),
        U_max=float(reversal.max()),
        U_mean=float(reversal.mean()),
    )
