"""What goes into the point-by-point method and what comes out, before it is put in words."""

from dataclasses import dataclass
from typing import Literal

from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.estimation.observations import Observations
from trueaxis.identification.fit_quality import FitQuality
from trueaxis.identification.noise import Noise
from trueaxis.identification.paper.equations import Equations
from trueaxis.identification.paper.grid import BoolArray, Cells, Grid
from trueaxis.identification.paper.solution import Response, Solution
from trueaxis.identification.paper.squareness import Choice, Squareness
from trueaxis.identification.paper.steps import Steps
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.errors import ErrorValues

Curves = Literal["table", "polynomial", "held-out"]


@dataclass(frozen=True, slots=True)
class PaperOptions:
    """squareness: the rule for the location errors; known: values given beforehand (dimensions too);
    noise_um: standard deviation of a reading, micrometres; curves: how components are given back.
    """

    squareness: Choice = "convention"
    known: ErrorValues | None = None
    noise_um: float | None = None
    curves: Curves = "table"


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class PaperResult:
    """Everything that the steps gave, for the report: see the records.

    u_nodes, u_locations: standard uncertainties, NaN where open, None where the noise is unknown; free:
    (n_location_errors,), those not given; used: readings in steps.
    """

    machine: IdentifiedMachine
    observed: Observations
    left_out: tuple[str, ...]
    given: ErrorValues
    options: PaperOptions
    grid: Grid
    cells: Cells
    equations: Equations
    steps: Steps
    response: Response
    rule: Squareness
    free: BoolArray
    solution: Solution
    noise: Noise
    u_nodes: FloatArray | None
    u_locations: FloatArray | None
    residual_rms: float
    quality: FitQuality
