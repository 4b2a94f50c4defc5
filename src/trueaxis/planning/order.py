"""The order in which blocks of runs and components can be solved, and what is singular in it."""

from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.estimation.observations import Observations
from trueaxis.identification.paper.grid import Grid, equations, grid_and_cells, points_remark
from trueaxis.identification.paper.steps import SolvedStep, Step, Steps, solve_steps, steps_in_order
from trueaxis.identification.words import enumerated
from trueaxis.io.faults import InputError
from trueaxis.measurement.setup import Run
from trueaxis.model.errors import ErrorValues
from trueaxis.planning.report import BlockReport


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Order:
    """Blocks in order; solved: each with its equations, where every position that a block needs is measured; fault: why
    not, else empty; left_out: ball-bar runs, which sense all components at once.
    """

    grid: Grid
    runs: tuple[Run, ...]
    steps: tuple[Step, ...]
    solved: Steps | None
    fault: str
    left_out: tuple[str, ...]

    def blocks(self) -> tuple[BlockReport, ...]:
        """As a report."""
        if self.solved is None:
            return tuple(
                BlockReport(
                    runs=self.names(step),
                    components=self.components(step),
                    equations=0,
                    unknowns=0,
                    rank=0,
                    ranks=(),
                    condition=float("nan"),
                )
                for step in self.steps
            )
        return tuple(
            BlockReport(
                runs=self.names(one.step), components=self.components(one.step), equations=one.cells.size,
                unknowns=one.nodes.size, rank=one.inverse.rank, ranks=one.inverse.ranks,
                condition=one.inverse.condition, because=self.because(one),
            )
            for one in self.solved.steps
        )  # fmt: skip

    def names(self, step: Step) -> tuple[str, ...]:
        """The runs of a block."""
        return tuple(self.runs[run].id for run in step.runs)

    def components(self, step: Step) -> tuple[str, ...]:
        """The components of a block."""
        return tuple(self.grid.components[component] for component in step.components)

    def because(self, one: SolvedStep) -> str:
        """What makes a block singular; empty where it is not."""
        if one.inverse.rank == one.nodes.size:
            return ""
        runs = [self.runs[run] for run in one.step.runs]
        return same_coordinates(runs) or points_remark(runs) or "too few runs hold them"


def order(machine: IdentifiedMachine, observed: Observations, given: ErrorValues) -> Order | None:
    """The order of all laser and probe runs; None where there are none."""
    bars = [index for index, run in enumerate(observed.runs) if run.instrument == "ballbar"]
    left_out = tuple(observed.runs[index].id for index in bars)
    keep = np.flatnonzero(~np.isin(observed.run, bars))
    if keep.size == 0:
        return None
    usable = observed.of(keep)
    grid, cells = grid_and_cells(machine, usable)
    known = np.array([name in given.motion_errors for name in machine.components], dtype=bool)
    held = equations(machine, usable, grid, cells, known)
    steps = steps_in_order(held, grid, cells, len(usable.runs))
    solved, fault = None, ""
    try:
        solved = solve_steps(steps, held, grid, cells, usable)
    except InputError as error:
        fault = str(error.faults[0])
    return Order(grid=grid, runs=usable.runs, steps=steps, solved=solved, fault=fault, left_out=left_out)


def same_coordinates(runs: list[Run]) -> str:
    """`the points of A and B have the same x and y`, where runs along one axis see their points as one; else empty."""
    directions = {run.direction for run in runs}
    if len(runs) < 2 or len(directions) != 1 or len({(run.target.on, run.reference.on) for run in runs}) != 1:
        return ""
    (direction,) = directions
    if direction is None or max(abs(part) for part in direction) < 1.0:
        return ""
    across = [letter for letter, part in zip("xyz", direction, strict=True) if abs(part) < 1.0]
    groups: dict[tuple[float, ...], list[str]] = {}
    for run in runs:
        seen = tuple(
            round(value, 6) for value, part in zip(run.target.point, direction, strict=True) if abs(part) < 1.0
        )
        groups.setdefault(seen, []).append(run.id)
    same = [f"the points of {enumerated(ids)} have the same {enumerated(across)}" for ids in groups.values() if ids[1:]]
    return enumerated(same)
