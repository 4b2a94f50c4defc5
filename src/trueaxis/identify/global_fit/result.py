"""What goes into the global method and what comes out, before it is put in words."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from trueaxis.identify.global_fit.layout import Layout
from trueaxis.identify.global_fit.least_squares import Factors, Gauge
from trueaxis.identify.noise import Noise
from trueaxis.identify.observations import Observations
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.errors import ErrorValues

Choice = Literal["convention", "known"]


@dataclass(frozen=True, slots=True)
class GlobalOptions:
    """squareness: what splits it from straightness; known: values given beforehand (dimensions too); noise_um:
    standard deviation of a reading, micrometres; degree: highest power of a component's polynomial.
    """

    squareness: Choice = "convention"
    known: ErrorValues | None = None
    noise_um: float | None = None
    degree: int = 7


@dataclass(frozen=True, slots=True, eq=False)
class GlobalResult:
    """The fit: unknowns (n,) in mm or rad and their covariance (None where the noise is unknown); open: (n,),
    unknowns that no reading and no convention settles.
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
    iterations: int
    change: float
    noise: Noise
