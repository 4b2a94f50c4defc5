"""The point-by-point solution on the exact model: errors at nodes, their uncertainty, what is open."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from scipy.sparse import csc_array, csr_array

from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.estimation.observations import Observations
from trueaxis.identification.fit_quality import RESOLUTION, FitQuality
from trueaxis.identification.paper.grid import BoolArray, Cells, Equations, Grid
from trueaxis.identification.paper.squareness import Choice, Squareness
from trueaxis.identification.paper.steps import Steps
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import expected_readings
from trueaxis.model.curves import Curve, TableCurve
from trueaxis.model.errors import ErrorValues

CONVERGED = 1e-14  # mm, rotations times the lever
MOST_ITERATIONS = 20
GROWTH = 4.0  # of the largest residual: the steps lead away from the solution
OPEN = 1e-9  # share of a node in the null space, scaled, above which it counts as open
Curves = Literal["table", "polynomial", "held-out"]


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Response:
    """The linear solution in mm and rad, the rule for the location errors included.

    nodes: (n_nodes, n_cells) at location errors of zero; along: (n_nodes, n_location_errors), nodes going along with
    location errors; located: (n_location_errors, n_cells); null: (n_nodes, d); null_located:
    (n_location_errors, d). nodes + along @ located is the whole response to the readings.
    """

    nodes: csr_array
    along: csr_array
    located: FloatArray
    null: csc_array
    null_located: FloatArray
    node_scale: FloatArray
    location_scale: FloatArray

    def variances(self, cells: Cells) -> tuple[FloatArray, FloatArray]:
        """Variance of every node and every location error for readings of variance 1."""
        # of nodes + along @ located, which is never formed: it is as large as the square of the readings
        share = 1.0 / cells.repeats
        along, weighted = self.along, (self.located * share).T
        both = np.asarray(along.multiply(self.nodes @ weighted).sum(axis=1)).ravel()
        rule = np.asarray(along.multiply(along @ (self.located @ weighted)).sum(axis=1)).ravel()
        own = np.asarray(self.nodes.power(2) @ share)
        return np.maximum(own + 2.0 * both + rule, 0.0), self.located**2 @ share

    @property
    def open_nodes(self) -> BoolArray:
        """(n_nodes,): nodes that the readings leave open."""
        return _largest(abs(self.null)) > OPEN * self.node_scale

    @property
    def open_locations(self) -> BoolArray:
        """(n_location_errors,): location errors that rest on open nodes."""
        share: FloatArray = np.abs(self.null_located).max(axis=1, initial=0.0)
        return share > OPEN * self.location_scale


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Solution:
    """nodes: (n_nodes,), locations: (n_location_errors,), mm or rad; residual: (n_cells,), mm; change: the last, mm;
    step: (n_nodes,), the last one, mm or rad, infinite where the steps led away.
    """

    nodes: FloatArray
    locations: FloatArray
    residual: FloatArray
    iterations: int
    change: float
    step: FloatArray


def sloped(response: Response, free: BoolArray) -> BoolArray:
    """(n_nodes,): nodes that go along with a location error that is not given: no reading has their slope."""
    return np.asarray(abs(response.along[:, np.flatnonzero(free)]).sum(axis=1) > 0.0)


def natural(steps: Steps, equations: Equations) -> tuple[csr_array, csr_array, csc_array]:
    """Response, by_location and null of the steps, from scaled unknowns to mm and rad."""
    scale = equations.node_scale[:, np.newaxis]
    return (
        csr_array(steps.response.multiply(scale)),
        csr_array(steps.by_location.multiply(scale).multiply(1.0 / equations.location_scale[np.newaxis])),
        csc_array(steps.null.multiply(scale)),
    )


def with_rule(steps: Steps, equations: Equations, rule: Squareness) -> Response:
    """The response of everything to the readings, location errors by the rule."""
    nodes, along, null = natural(steps, equations)
    located = np.asarray((nodes.T @ rule.response.T).T)
    null_located = np.asarray((null.T @ rule.response.T).T)
    whole_null = csc_array(null + along @ csr_array(null_located))
    return Response(
        nodes=nodes,
        along=along,
        located=located,
        null=whole_null,
        null_located=null_located,
        node_scale=equations.node_scale,
        location_scale=equations.location_scale,
    )


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Exact:
    """The exact model at the cells; `given`: values that are known beforehand."""

    machine: IdentifiedMachine
    given: ErrorValues
    observed: Observations
    grid: Grid
    cells: Cells

    def residual(self, nodes: FloatArray, locations: FloatArray) -> FloatArray:
        """Mean readings minus those expected with the errors at the nodes and the location errors, (n_cells,), mm."""
        every = np.ones(self.grid.count, dtype=bool)
        named = dict(zip(self.machine.location_errors, locations.tolist(), strict=True))
        values = replace(
            self.given,
            parameters={**self.given.parameters, **named},
            motion_errors={**tables(self.grid, nodes, every), **self.given.motion_errors},
        )
        model, cells = self.machine.with_values(values), self.cells
        return cells.mean - expected_readings(model, self.observed.runs, cells.run, cells.positions)


def solve(exact: Exact, response: Response, rule: Squareness) -> Solution:
    """Solve on the exact model: what it predicts beyond the present values is corrected for until nothing changes."""
    nodes = np.zeros(exact.grid.count)
    start = exact.given.parameters
    locations = np.array([start.get(name, 0.0) for name in exact.machine.location_errors])
    change, before, iteration = np.inf, np.inf, 0
    residual = exact.residual(nodes, locations)
    largest = GROWTH * float(np.abs(residual).max(initial=0.0)) + RESOLUTION
    step: FloatArray = np.full(nodes.size, np.inf)
    while change > CONVERGED and iteration < MOST_ITERATIONS and not (iteration > 3 and change > 0.5 * before):
        step = response.nodes @ residual
        moved = rule.correction(nodes + step, locations)
        step = step + response.along @ moved
        nodes, locations = nodes + step, locations + moved
        residual = exact.residual(nodes, locations)
        before, change = change, float(np.max(np.abs(step / response.node_scale), initial=0.0))
        iteration += 1
        if not np.abs(residual).max(initial=0.0) <= largest:
            return Solution(
                nodes=nodes,
                locations=locations,
                residual=residual,
                iterations=iteration,
                change=change,
                step=np.full(nodes.size, np.inf),
            )
    return Solution(nodes=nodes, locations=locations, residual=residual, iterations=iteration, change=change, step=step)


def tables(grid: Grid, nodes: FloatArray, which: BoolArray, u: FloatArray | None = None) -> dict[str, Curve]:
    """Table curves of the components that have nodes of `which`, zero nodes between them included."""
    found: dict[str, Curve] = {}
    for index, name in enumerate(grid.components):
        mine = grid.nodes(index)
        used = which[mine]
        if not used.any():
            continue
        used = used | grid.fixed[mine]
        spread = None if u is None else tuple(u[mine][used].tolist())
        knots = grid.knots[grid.axis[index]][used]
        found[name] = TableCurve(tuple(knots.tolist()), tuple(nodes[mine][used].tolist()), spread)
    return found


def _largest(matrix: csc_array) -> FloatArray:
    if matrix.shape[1] == 0:
        return np.zeros(matrix.shape[0])
    return np.asarray(matrix.max(axis=1).todense()).ravel()


@dataclass(frozen=True, slots=True)
class PaperOptions:
    """squareness: the rule for the location errors; known: values given beforehand (dimensions too);
    noise_um: standard deviation of a reading, micrometres; curves: how components are given back.
    """

    squareness: Choice = "convention"
    known: ErrorValues | None = None
    noise_um: float | None = None
    curves: Curves = "table"


@dataclass(frozen=True, slots=True)
class Noise:
    """Standard deviation of a reading, mm (None: unknown); the degrees of freedom left; where it is from."""

    sigma: float | None
    freedom: int
    origin: str

    @property
    def um(self) -> float | None:
        """In micrometres."""
        return None if self.sigma is None else self.sigma * 1e3


def noise(squares: float, readings: int, rank: int, given_um: float | None, origin: str = "given") -> Noise:
    """From a sum of squared residuals (mm^2) of readings that determine `rank` unknowns, unless it is given."""
    freedom = readings - rank
    if given_um is not None:
        return Noise(given_um * 1e-3, freedom, origin)
    if freedom > 0:
        return Noise(float(np.sqrt(squares / freedom)), freedom, f"from the residuals, {freedom} degrees of freedom")
    return Noise(None, freedom, "unknown: no reading is left over to estimate it from, and none was given")


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
