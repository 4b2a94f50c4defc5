"""The smallest set of location errors that describes a machine, by rank over its volume.

Literature counts location errors by where the ends are taken to be: what a displaced workpiece, or a tool of another
length, does as well is no error of the machine. Constant motion errors of every axis but along its own motion are all
that can be wrong with the places and directions of the axes above it; a set that spans them is complete.
"""

from collections.abc import Sequence
from itertools import product

import numpy as np

from trueaxis.estimation.machine import IdentifiedMachine, scales, units
from trueaxis.identification.words import enumerated
from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.errors import ErrorValues
from trueaxis.planning.report import LocationSet, Redundant

DEPENDENT = 1e-7  # share of a column that others leave over, below which they stand for it
TOOL_POINT = (23.0, 41.0, -97.0)  # mm: a point in no special place, so that every dimension counts
PLACEMENTS = (  # in words, and whether the workpiece may be placed freely
    ("workpiece and tool at their nominal places", False),
    ("workpiece placed freely", True),
    ("tool point anywhere", False),
    ("workpiece placed freely, tool point anywhere", True),
)
MOST_POINTS = 4096


def location_sets(machine: IdentifiedMachine, known: ErrorValues) -> tuple[LocationSet, ...]:
    """The sets under each of PLACEMENTS. Named dimensions that are not known get values in no special relation."""
    if not machine.location_errors:
        return ()
    dimensions = [name for name in machine.parameters if name not in machine.location_errors]
    values = {name: 60.0 + 37.0 * index % 83.0 for index, name in enumerate(dimensions)}
    generic = machine.with_values(ErrorValues(machine=machine.name, parameters={**values, **known.parameters}))
    positions = _volume(generic)
    point = np.array(TOOL_POINT)[:, np.newaxis]
    sensitivity = _stacked(generic.view_sensitivity("tool_in_workpiece", positions, point)) * scales(generic)
    count = len(generic.components)
    others = [i for i, name in enumerate(generic.components) if not name.is_positioning]
    errors = sensitivity[:, count:]
    constant = sensitivity[:, others]
    names = [generic.components[i] for i in others]
    workpiece, tool = _workpiece(generic, positions, point), _tool(generic, positions, point)
    nothing = np.zeros((errors.shape[0], 0))
    placed = (nothing, workpiece, tool, np.hstack([workpiece, tool]))
    labels: tuple[list[str], ...] = (
        [],
        _labels("workpiece"),
        _labels("tool")[:3],
        [*_labels("workpiece"), *_labels("tool")[:3]],
    )
    return tuple(
        _set(generic, placement, (free, label), errors, (constant, names), workpiece_free=workpiece_free)
        for (placement, workpiece_free), free, label in zip(PLACEMENTS, placed, labels, strict=True)
    )


def independent(columns: FloatArray, before: FloatArray) -> list[int]:
    """Columns, first come first kept, that are no combination of those before them and of `before`."""
    basis = _orthonormal(before)
    kept = []
    for index, column in enumerate(columns.T):
        size = float(np.linalg.norm(column))
        left = column - basis @ (basis.T @ column)
        left -= basis @ (basis.T @ left)
        if size > 0.0 and np.linalg.norm(left) > DEPENDENT * size:
            basis = np.column_stack([basis, left / np.linalg.norm(left)])
            kept.append(index)
    return kept


def _set(
    machine: IdentifiedMachine,
    placement: str,
    free: tuple[FloatArray, Sequence[str]],
    errors: FloatArray,
    constant: tuple[FloatArray, Sequence[str]],
    *,
    workpiece_free: bool,
) -> LocationSet:
    kept = independent(errors, free[0])
    redundant = [i for i in range(errors.shape[1]) if i not in kept]
    unit = units(machine)[len(machine.components) :]
    size = scales(machine)[len(machine.components) :]
    held = [machine.location_errors[i] for i in kept]
    spoken = [
        Redundant(machine.location_errors[i], _stands_for((errors, size, unit), i, (kept, held), free))
        for i in redundant
    ]
    more = independent(constant[0], np.hstack([free[0], errors]))
    complete = len(kept) + len(more)
    return LocationSet(
        placement=placement,
        workpiece_free=workpiece_free,
        rank=len(kept),
        kept=tuple(held),
        redundant=tuple(spoken),
        complete=complete,
        missing=tuple(constant[1][i] for i in more),
    )


def _stands_for(
    errors: tuple[FloatArray, FloatArray, Sequence[str]],
    index: int,
    kept: tuple[Sequence[int], Sequence[str]],
    free: tuple[FloatArray, Sequence[str]],
) -> str:
    """What a unit of a redundant error is made of."""
    columns, size, unit = errors
    if not np.linalg.norm(columns[:, index]) > 0.0:
        return "nothing: it does not move the tool point against the workpiece"
    basis = np.hstack([columns[:, list(kept[0])], free[0]])
    share = np.linalg.lstsq(basis, columns[:, index], rcond=1e-12)[0]
    share[np.abs(share) < 1e-6] = 0.0
    parts = []
    for place, name in enumerate(kept[1]):
        if share[place]:
            value = share[place] * size[kept[0][place]] / size[index]
            per = "" if unit[kept[0][place]] == unit[index] else f" {unit[kept[0][place]]}/{unit[index]}"
            parts.append(f"{value:+.4g}{per} {name}")
    moved = [label for label, value in zip(free[1], share[len(kept[1]) :], strict=True) if value]
    if moved:
        parts.append(f"a {enumerated(list(dict.fromkeys(moved)))}")
    return enumerated(parts)


def _labels(what: str) -> list[str]:
    return [f"displaced {what}"] * 3 + [f"turned {what}"] * 3


def _volume(machine: IdentifiedMachine) -> FloatArray:
    """(n_axes, n): a grid over the travels; a rotary axis beyond a turn is sampled over one."""
    grids = []
    for axis in machine.axes:
        low, high = machine.travel[axis]
        if axis not in LINEAR and high - low > 300.0:
            low, high = max(low, -150.0), min(high, 150.0)
        grids.append(np.linspace(low, high, 3 if axis in LINEAR else 5))
    points = np.array(list(product(*grids))).T
    step = -(-points.shape[1] // MOST_POINTS)
    return np.ascontiguousarray(points[:, ::step])


def _workpiece(machine: IdentifiedMachine, positions: FloatArray, point: FloatArray) -> FloatArray:
    """(3 n, 6): a workpiece displaced along and turned about its frame's axes, 1 mm or 1 mm at the lever each."""
    seen = machine.view_ideal("tool_in_workpiece", positions, point)
    moved = [np.repeat(unit[:, np.newaxis], seen.shape[1], axis=1) for unit in np.eye(3)]
    lever = float(np.abs(seen).max()) or 1.0
    turned = [np.cross(unit, seen.T).T / lever for unit in np.eye(3)]
    return np.column_stack([one.ravel() for one in (*moved, *turned)])


def _tool(machine: IdentifiedMachine, positions: FloatArray, point: FloatArray) -> FloatArray:
    """(3 n, 3): the tool point displaced along the axes of its own frame."""
    start = machine.view_ideal("tool_in_workpiece", positions, point)
    moved = [
        machine.view_ideal("tool_in_workpiece", positions, point + unit[:, np.newaxis]) - start for unit in np.eye(3)
    ]
    return np.column_stack([one.ravel() for one in moved])


def _stacked(sensitivity: FloatArray) -> FloatArray:
    """(3, k, n) to (3 n, k)."""
    return np.ascontiguousarray(sensitivity.transpose(0, 2, 1)).reshape(-1, sensitivity.shape[1])


def _orthonormal(columns: FloatArray) -> FloatArray:
    left, size, _ = np.linalg.svd(columns, full_matrices=False)
    return left[:, size > DEPENDENT * size.max(initial=0.0)]
