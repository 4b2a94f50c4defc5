"""What goes into the global method and what comes out, before it is put in words."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
import numpy.typing as npt

from trueaxis.effects.kind import Effect
from trueaxis.estimation.observations import Observations
from trueaxis.identify.global_fit.instruments import KINDS, Kind
from trueaxis.identify.global_fit.layout import Layout
from trueaxis.identify.global_fit.least_squares import Factors, Gauge
from trueaxis.identify.global_fit.order import Orders
from trueaxis.identify.global_fit.robust import Robust
from trueaxis.identify.noise import Noise
from trueaxis.identify.weighting import GroupNoise, Repeats
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.effect_values import EffectValues
from trueaxis.runtime.errors import ErrorValues

Choice = Literal["convention", "known"]
AUTO_DEGREE: Literal["auto"] = "auto"
HIGHEST_AUTO = 7
OPEN = 1e-4  # share of an unknown in the null space, scaled, below which what is open does not matter to it


@dataclass(frozen=True, slots=True)
class GlobalOptions:
    """squareness: what splits it from straightness; known: values given beforehand (dimensions too); noise_um:
    standard deviation of a reading, micrometres; noise_by_group: of those of an instrument or run; repeats: whether
    it is taken from repeated readings; degree: highest power of all components' polynomials or of each one named
    (others are zero), or "auto": each as high as held-out readings ask for; instruments: what is unknown of them;
    robust: how readings far off are weighed down; start: values of effects to start from, which spares a search.
    """

    squareness: Choice = "convention"
    known: ErrorValues | None = None
    noise_um: float | None = None
    degree: int | Mapping[str, int] | Literal["auto"] = 7
    noise_by_group: Mapping[str, float] = field(default_factory=dict)
    repeats: Repeats = ""
    instruments: tuple[Kind, ...] = KINDS
    robust: Robust = ""
    start: tuple[EffectValues, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class GlobalResult:
    """The fit: unknowns (n,) in mm or rad and their covariance (None where the noise is unknown); open: (n,),
    unknowns that no reading and no convention settles; held: how many readings hold an unknown; residual:
    (n_readings,), mm; roots, robust_weight: (n_readings,), square roots of the weights by noise, and what robustness
    makes of them; zeroed: effects that are given as zero, since a square would be negative; converged: whether it
    stands still.
    """

    layout: Layout
    observed: Observations
    given: ErrorValues
    options: GlobalOptions
    factors: Factors
    gauge: Gauge
    held: int
    unknowns: FloatArray
    covariance: FloatArray | None
    open: npt.NDArray[np.bool_]
    residual: FloatArray
    roots: FloatArray
    robust_weight: FloatArray
    iterations: int
    change: float
    noise: Noise
    groups: tuple[GroupNoise, ...] = ()
    orders: Orders | None = None
    zeroed: tuple[Effect, ...] = ()
    converged: bool = True
