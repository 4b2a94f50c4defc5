"""Target points that make a singular plan regular."""

from dataclasses import dataclass, replace

import numpy as np

from trueaxis.identify.global_fit.least_squares import RANK_TOLERANCE
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.setup import Run, Vector
from trueaxis.plan import boxes
from trueaxis.plan.d_optimal import gains
from trueaxis.plan.method import Plan, plan_of
from trueaxis.plan.report import Move, PlanReport, Repair
from trueaxis.plan.rows import companions, of_runs, rows_of, with_run
from trueaxis.plan.system import folded

MOST_RUNS = 12
MOST_MOVES = 4
CHECKED = 5  # best candidates of a run whose rank is looked at


@dataclass(frozen=True, slots=True)
class _Tried:
    """A run with its target elsewhere, rank and condition of the whole then; growth: of log det, as of runs added."""

    run: int
    point: Vector
    rank: int
    condition: float
    growth: float

    @property
    def merit(self) -> tuple[int, float]:
        """Rank first, then the determinant."""
        return (self.rank, round(self.growth, 6))


def repair(plan: Plan, report: PlanReport) -> Repair | None:
    """Move one target point after another to where rank, then determinant grow most; None where nothing is open.

    Candidates: every coordinate as given, or lowest, middle or highest of the points given on that body, for the runs
    of singular blocks (else all laser and probe runs, the first MOST_RUNS of them).
    """
    if not plan.settled.open.shape[1]:
        return None
    moves: list[Move] = []
    others: list[Move] = []
    names = _runs_to_move(plan, report)
    current = plan
    while len(moves) < MOST_MOVES and current.settled.open.shape[1]:
        tried = [best for name in names if (best := _best(current, name)) is not None]
        tried = [one for one in tried if one.rank > current.system.factors.rank]
        if not tried:
            break
        tried.sort(key=lambda one: one.merit, reverse=True)
        if not moves:
            others = [_move(current, one) for one in tried[1:] if one.rank == tried[0].rank]
        moves.append(_move(current, tried[0]))
        current = _moved(current, tried[0])
    around = {run.target.on: boxes.box(plan.observed.runs, run.target.on) for run in plan.observed.runs}
    where = "; ".join(f"on the {on} {boxes.told(one)}" for on, one in around.items() if one is not None)
    text = (
        f"candidates: targets of {', '.join(names) if names else 'no run'}, each coordinate as given or lowest, middle "
        f"or highest in the box of the given points ({where})"
    )
    return Repair(tuple(moves), tuple(others), text, not current.settled.open.shape[1])


def _runs_to_move(plan: Plan, report: PlanReport) -> list[str]:
    singular = [name for block in report.blocks if block.rank < block.unknowns for name in block.runs]
    every = [run.id for run in plan.observed.runs if run.instrument != "ballbar" and run.target.on != "bed"]
    return (list(dict.fromkeys(singular)) or every)[:MOST_RUNS]


def _best(plan: Plan, name: str) -> _Tried | None:
    """The best place for the target of a run."""
    index = next(i for i, run in enumerate(plan.observed.runs) if run.id == name)
    run = plan.observed.runs[index]
    around = boxes.box(plan.observed.runs, run.target.on)
    if around is None:
        return None
    mates = companions(plan.system.unknowns, index)
    rest, own = _without(plan, mates), of_runs(plan.observed, mates)
    points = boxes.lattice(around, run.target.point)
    rows = [
        rows_of(plan.system.layout, with_run(own, mates.index(index), _elsewhere(run, point)), plan.options.assumed)
        for point in points
    ]
    growth = gains(rest.T @ rest + plan.ridge * np.eye(rest.shape[0]), rows)
    found = []
    for place in np.argsort(-growth, kind="stable")[:CHECKED]:
        size = np.linalg.svd(folded(rest, rows[place]), compute_uv=False)
        kept = size[size > RANK_TOLERANCE * size.max(initial=0.0)]
        if kept.size:
            found.append(_Tried(index, points[place], kept.size, float(kept[0] / kept[-1]), float(growth[place])))
    return max(found, key=lambda one: one.merit, default=None)


def _elsewhere(run: Run, point: Vector) -> Run:
    return replace(run, target=replace(run.target, point=point))


def _without(plan: Plan, runs: tuple[int, ...]) -> FloatArray:
    """The triangular factor of all other runs."""
    others = tuple(index for index in range(len(plan.observed.runs)) if index not in runs)
    n = plan.system.layout.count
    if not others:
        return np.zeros((n, n))
    rows = rows_of(plan.system.layout, of_runs(plan.observed, others), plan.options.assumed)
    return folded(np.zeros((n, n)), rows)


def _moved(plan: Plan, tried: _Tried) -> Plan:
    run = plan.observed.runs[tried.run]
    return plan_of(plan.machine, with_run(plan.observed, tried.run, _elsewhere(run, tried.point)), plan.options)


def _move(plan: Plan, tried: _Tried) -> Move:
    run = plan.observed.runs[tried.run]
    return Move(run.id, run.target.on, run.target.point, tried.point, tried.rank, tried.condition)
