"""`plan --propose N`: the runs that would add most to a plan."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.estimation.observations import Observations
from trueaxis.identify.global_fit.layout import Layout, layout
from trueaxis.identify.global_fit.least_squares import RANK_TOLERANCE
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.setup import Instrument
from trueaxis.plan import expected
from trueaxis.plan.candidates import Candidate, candidates, style_of
from trueaxis.plan.combinations import settled_and_seen
from trueaxis.plan.convention import settle
from trueaxis.plan.d_optimal import choose
from trueaxis.plan.method import PRIOR_UM, Plan, plan_of
from trueaxis.plan.report import Added, Proposal
from trueaxis.plan.rows import rows_of, with_added
from trueaxis.plan.system import folded

ROUNDED = 1e-6  # share of a row below which it holds nothing


@dataclass(frozen=True, slots=True, eq=False)
class Extended:
    """The proposal and the runs behind it, with ids."""

    proposal: Proposal
    runs: tuple[Candidate, ...]


def propose(plan: Plan, count: int, instruments: Sequence[Instrument] = ()) -> Extended:
    """Choose `count` runs; instruments: of the candidates, those of the plan where none are named."""
    used = tuple(dict.fromkeys(instruments or (run.instrument for run in plan.observed.runs)))
    readings = np.bincount(plan.observed.run, minlength=len(plan.observed.runs))
    style = style_of(plan.machine, plan.observed.runs, readings.tolist(), used)
    offered = candidates(plan.machine, style)
    whole = _layout_of_all(plan, offered)
    rows = [_rows(whole, one, plan) for one in offered]
    held = [index for index, one in enumerate(rows) if one.any()]
    offered, rows = [offered[index] for index in held], [rows[index] for index in held]
    triangle = folded(np.zeros((whole.count,) * 2), rows_of(whole, plan.observed, plan.options.assumed))
    chosen = choose(triangle.T @ triangle + plan.ridge * np.eye(whole.count), rows, count)
    taken = _named(plan, [offered[index] for index in chosen.indices])
    added, observed = [], plan.observed
    for one, index, gain in zip(taken, chosen.indices, chosen.gains, strict=True):
        triangle = folded(triangle, rows[index])
        observed = with_added(observed, one.run, one.positions)
        added.append(Added(one.run.id, one.what, one.positions.shape[1], _rank(triangle), gain))
    after = plan_of(plan.machine, observed, plan.options)
    by_ends = settle(after.system.layout, after.system.factors.null, "end-point")
    spread, other = (expected.covariance(after.system, one, plan.noise) for one in (after.settled, by_ends))
    proposal = Proposal(
        added=tuple(added),
        candidates=_told(used, len(offered), chosen.exchanges, style.readings),
        prior_um=PRIOR_UM,
        exchanges=chosen.exchanges,
        unknowns=after.system.layout.count,
        rank=after.system.factors.rank,
        settled=settled_and_seen(after.system, after.settled).shape[1],
        condition=after.system.factors.condition,
        curves=expected.curves(after.system, after.settled, spread),
        locations=expected.locations(after.system, after.settled, spread, other),
    )
    return Extended(proposal, tuple(taken))


def _layout_of_all(plan: Plan, offered: Sequence[Candidate]) -> Layout:
    """Unknowns of every axis that the plan or a candidate moves."""
    positions = np.hstack([plan.observed.positions, *(one.positions for one in offered)])
    everything = replace(plan.observed, positions=positions)
    return layout(plan.machine, everything, plan.given, plan.options.degree)


def _rows(whole: Layout, one: Candidate, plan: Plan) -> FloatArray:
    count = one.positions.shape[1]
    alone = Observations("", (one.run,), np.zeros(count, dtype=np.int64), one.positions, np.zeros(count))
    rows = rows_of(whole, alone, plan.options.assumed)
    rows[np.abs(rows).max(axis=1) < ROUNDED] = 0.0
    return rows


def _named(plan: Plan, chosen: Sequence[Candidate]) -> list[Candidate]:
    """With ids that no run has yet."""
    taken = {run.id for run in plan.observed.runs}
    found, number = [], 0
    for one in chosen:
        number += 1
        while f"added-{number}" in taken:
            number += 1
        found.append(replace(one, run=replace(one.run, id=f"added-{number}")))
    return found


def _rank(triangle: FloatArray) -> int:
    size = np.linalg.svd(triangle, compute_uv=False)
    return int(np.count_nonzero(size > RANK_TOLERANCE * size[0]))


def _told(instruments: Sequence[Instrument], count: int, exchanges: int, readings: int) -> str:
    kinds = {
        "laser": "lines of one, two and three axes through corners and centre of the box of the given points",
        "probe": "such lines, and turns of rotary axes about spheres at quarters of the travels",
        "ballbar": "circles, and turns of rotary axes, about balls at quarters of the travels",
    }
    return (
        f"chosen D-optimally, greedily and by {exchanges} exchanges, among {count} candidates "
        f"({'; '.join(f'{name}: {kinds[name]}' for name in instruments)}), {readings} readings at most each, errors of "
        f"{PRIOR_UM:g} um expected beforehand"
    )
