"""Step by step: the blocks of runs and components in the order in which they can be solved, and their solution.

Everything is linear, so that the solution is carried as three matrices: the response of every node to the readings
(which is also the way of their noise, transitivity included), to the location errors, and the null space.
"""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csc_array, csr_array, hstack

from trueaxis.blocks import solution_order
from trueaxis.estimation.observations import Observations
from trueaxis.identification.paper.grid import BoolArray, Cells, Equations, Grid, IntArray
from trueaxis.identification.paper.pseudo_inverse import PseudoInverse, TooLargeError, pseudo_inverse
from trueaxis.io.faults import Faults

RANK_TOLERANCE = 1e-8  # singular values below it, relative to the largest, count as zero
MOST_FAULTS = 10


@dataclass(frozen=True, slots=True)
class Step:
    """A block: runs and components by index; `closed` is False for what no order could reach."""

    runs: tuple[int, ...]
    components: tuple[int, ...]
    closed: bool = True


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class SolvedStep:
    """A step with its equations (cells that hold unknowns), nodes, pseudo-inverse and columns in `Steps.null`."""

    step: Step
    cells: IntArray
    nodes: IntArray
    inverse: PseudoInverse
    null_columns: range


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Steps:
    """All steps solved, in scaled unknowns.

    response: (n_nodes, n_cells), by the cells' means; by_location: (n_nodes, n_location_errors), how the nodes go
    along with location errors; null: (n_nodes, d), what no reading that was used sees; reached: (n_nodes,), nodes
    that stand in a step.
    """

    steps: tuple[SolvedStep, ...]
    response: csr_array
    by_location: csr_array
    null: csc_array
    reached: BoolArray


def steps_in_order(equations: Equations, grid: Grid, cells: Cells, n_runs: int) -> tuple[Step, ...]:
    """Which component each run holds, from the sensitivities, and the order that follows from it."""
    held = _held(equations, grid, cells, n_runs)
    components = sorted({component for row in held for component in row})
    number = {component: index for index, component in enumerate(components)}
    order = solution_order([[number[c] for c in row] for row in held], len(components))
    steps = [Step(block.equations, tuple(components[u] for u in block.unknowns)) for block in order.blocks]
    if order.undetermined:
        unused = tuple(run for run in order.unused if held[run])
        steps.append(Step(unused, tuple(components[u] for u in order.undetermined), closed=False))
    return tuple(steps)


def solve_steps(
    steps: tuple[Step, ...], equations: Equations, grid: Grid, cells: Cells, observed: Observations
) -> Steps:
    """Solve the steps one after another at every position.

    Raises InputError where a step needs a component at a position at which no step before has found it, and where
    too many unknowns hang together.
    """
    faults = Faults(observed.source)
    n_cells, n_locations = equations.located.shape
    response = csr_array((grid.count, n_cells))
    by_location = csr_array((grid.count, n_locations))
    null = csc_array((grid.count, 0))
    reached = np.zeros(grid.count, dtype=bool)
    solved = []
    weight = np.sqrt(cells.repeats)
    for step in steps:
        mine = np.concatenate([grid.nodes(component) for component in step.components])
        rows = np.flatnonzero(np.isin(cells.run, step.runs))
        block = equations.nodes[rows]
        unknown = block[:, mine]
        holding = np.flatnonzero(np.diff(unknown.indptr))
        rows, block, unknown = rows[holding], block[holding], unknown[holding]
        nodes = np.unique(unknown.indices).astype(np.int64)
        _check_known(block, mine, reached, (observed, grid, cells, rows), faults)
        try:
            inverse = pseudo_inverse(_weighted(unknown[:, nodes], weight[rows]), RANK_TOLERANCE)
        except TooLargeError as error:
            problem = f"the point-by-point method would have to solve {error.unknowns} unknowns together"
            faults.add(f"runs {_names(observed, step.runs)}", problem, "use --method global")
            faults.raise_if_any()
            raise
        nodes = mine[nodes]
        spread = _spread(inverse.inverse, nodes, rows, weight, (grid.count, n_cells))
        response = (response + spread - spread @ (equations.nodes @ response)).tocsr()
        by_location = (by_location - spread @ (equations.located + equations.nodes @ by_location)).tocsr()
        carried = null - spread @ (equations.nodes @ null)
        new = csc_array((grid.count, inverse.null.shape[1]))
        if inverse.null.shape[1]:
            lift = csr_array((np.ones(nodes.size), (nodes, np.arange(nodes.size))), shape=(grid.count, nodes.size))
            new = lift @ inverse.null
        columns = range(null.shape[1], null.shape[1] + new.shape[1])
        null = hstack([carried, new], format="csc")
        reached[nodes] = True
        solved.append(SolvedStep(step=step, cells=rows, nodes=nodes, inverse=inverse, null_columns=columns))
    faults.raise_if_any()
    return Steps(steps=tuple(solved), response=response, by_location=by_location, null=null, reached=reached)


def _held(equations: Equations, grid: Grid, cells: Cells, n_runs: int) -> list[list[int]]:
    component = grid.component_of(equations.nodes.indices.astype(np.int64))
    run = np.repeat(cells.run, np.diff(equations.nodes.indptr))
    return [np.unique(component[run == index]).tolist() for index in range(n_runs)]


def _weighted(matrix: csr_array, weight: IntArray) -> csr_array:
    weighted = matrix.copy()
    weighted.data = weighted.data * np.repeat(weight, np.diff(matrix.indptr))
    return weighted


def _spread(inverse: csr_array, nodes: IntArray, rows: IntArray, weight: IntArray, shape: tuple[int, int]) -> csr_array:
    found = inverse.tocoo()
    cells = rows[found.col]
    return csr_array((found.data * weight[cells], (nodes[found.row], cells)), shape=shape)


def _check_known(
    block: csr_array,
    mine: IntArray,
    reached: BoolArray,
    where: tuple[Observations, Grid, Cells, IntArray],
    faults: Faults,
) -> None:
    """Note positions that a run visits and at which what it needs was never measured."""
    observed, grid, cells, rows = where
    entries = block.tocoo()
    missing = ~reached[entries.col] & ~np.isin(entries.col, mine)
    found: dict[tuple[int, str, float], set[str]] = {}
    for row, node in zip(entries.row[missing], entries.col[missing], strict=True):
        component = grid.components[int(grid.component_of(np.array([node]))[0])]
        key = (int(cells.run[rows[row]]), component.axis, grid.position_of(int(node)))
        found.setdefault(key, set()).add(component)
    for index, ((run, axis, position), components) in enumerate(sorted(found.items())):
        if index == MOST_FAULTS:
            faults.add(f"run {observed.runs[run].id}", f"and so at {len(found) - MOST_FAULTS} more positions")
            break
        needed = " ".join(sorted(components))
        problem = f"{axis} = {position:g} was not measured before: {needed} not known there"
        faults.add(f"run {observed.runs[run].id}", problem, f"measure {axis} there, or use --method global")


def _names(observed: Observations, runs: tuple[int, ...]) -> str:
    return ", ".join(observed.runs[run].id for run in runs)
