"""Every cause that is searched for, and where.

The kinds of the library and of the spec at every place where they may act, and the grids of the parameters that their
terms are not linear in (`estimation.effects.grids`).
"""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.placement import allows, reads
from trueaxis.error_name import ROTATIONS
from trueaxis.estimation.effects.grids import OF_DIAGNOSIS, Fineness, covered_by, moments
from trueaxis.estimation.effects.grids import grid_of as grid_of_covered
from trueaxis.machine.machine import LINEAR, Machine
from trueaxis.model.effect_values import identity
from trueaxis.model.model import MachineModel


def candidates(model: MachineModel, rows: Rows) -> tuple[Effect, ...]:
    """All effects that the machine and these runs could have, in the order of the library; none that is there yet, and
    none that every set-up has some of.
    """
    there = {identity(effect) for effect in model.machine.effects}
    kinds = [kind for kind in model.machine.kinds.values() if not kind.nuisance]
    found = [effect for kind in kinds for effect in _of_kind(kind, model.machine, rows)]
    return tuple(effect for effect in found if identity(effect) not in there)


def _of_kind(kind: Kind, machine: Machine, rows: Rows) -> Iterator[Effect]:
    if kind.place == "component":
        yield from _of_components(kind, machine, rows)
    elif kind.place == "location":
        yield from _missing_locations(kind, machine)
    elif not kind.by_run:
        if any(reads(kind, rows.runs[index].instrument) for index in rows.present):
            yield Effect(kind=kind.name)
    else:
        yield from _of_runs(kind, rows)


def _of_components(kind: Kind, machine: Machine, rows: Rows) -> Iterator[Effect]:
    moving = {axis for axis, at in zip(rows.axes, rows.positions, strict=True) if at.min() < at.max()}
    for component in machine.components:
        if not allows(kind, component) or component.axis not in moving:
            continue
        if not kind.other_axis:
            yield Effect(kind=kind.name, component=component)
            continue
        for axis in machine.axes:
            if axis != component.axis and axis in moving:
                yield Effect(kind=kind.name, component=component, axis=axis)


def _missing_locations(kind: Kind, machine: Machine) -> Iterator[Effect]:
    for axis in machine.axes:
        if axis not in LINEAR:
            continue
        there = {direction for direction, _ in machine.mover(axis).position_errors}
        for turn in ROTATIONS:
            if turn not in there and turn.line != axis:
                yield Effect(kind=kind.name, component=turn.location_error(axis))


def _of_runs(kind: Kind, rows: Rows) -> Iterator[Effect]:
    """Of all runs that differ in their zero alone, and of those among them whose instrument stayed as it was set up; of
    a jump, of each run.
    """
    mine = [index for index in rows.present if reads(kind, rows.runs[index].instrument)]
    ends = ("target", "reference") if kind.name == "point_offset" else (None,)
    groups = [[index] for index in mine] if kind.name == "laser_step" else _alike(rows, mine)
    for group in groups:
        run, ids = rows.runs[group[0]], tuple(rows.runs[index].id for index in group)
        for end in ends:
            if end is None or getattr(run, end).on in ("tool", "workpiece"):
                yield Effect(kind=kind.name, runs=ids, end=end)


def _alike(rows: Rows, runs: Sequence[int]) -> list[list[int]]:
    """Groups of runs (by index) with the same `setup`, then with the same `mounted`; none twice."""
    found: dict[tuple[str, int], list[int]] = {}
    for index in runs:
        for name, of_rows in (("setup", rows.setup), ("mounted", rows.mounted)):
            found.setdefault((name, int(of_rows[rows.of_run(index)][0])), []).append(index)
    return [list(one) for one in dict.fromkeys(map(tuple, found.values()))]


def grid_of(
    kind: Kind, effect: Effect, rows: Rows, fineness: Fineness = OF_DIAGNOSIS
) -> tuple[Mapping[str, float], ...]:
    """The points of the grid: values of the parameters with the role `grid`; one empty point where there is none.

    NaN is the moment of a jump where a run is too short for one, or where its times are not known: no search then.
    """
    if not any(one.role == "grid" for one in kind.parameters):
        return ({},)
    if not effect.runs:
        return grid_of_covered(kind, covered_by(effect, rows.axes, rows.positions, rows.context), fineness)
    mine = np.isin(rows.run, [index for index, run in enumerate(rows.runs) if run.id in effect.runs])
    covered = covered_by(effect, rows.axes, rows.positions[:, mine], rows.context.of(mine))
    points = grid_of_covered(kind, covered, fineness)
    found = moments(covered.time[np.isfinite(covered.time)], fineness)
    jumps = {one.name for one in kind.parameters if one.grid == "moment"}
    if found or not jumps:
        return points
    return tuple({name: np.nan if name in jumps else value for name, value in point.items()} for point in points)
