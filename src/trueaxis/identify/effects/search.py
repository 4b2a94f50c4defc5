"""Where the fit of an effect starts whose term is not linear in all parameters: the point of a grid that explains most.

At every point the amplitudes are those of least squares beside all other unknowns, which are projected out (variable
projection, G. H. Golub and V. Pereyra, 1973).
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from trueaxis.effects.kind import Effect, Kind
from trueaxis.estimation.machine import IntArray
from trueaxis.identify.effects.amplitudes import amplitude_names, basis_vectors, searched_names
from trueaxis.identify.effects.grids import Point, finer, grid_of
from trueaxis.identify.effects.signature import Ground, is_in, of_term, reaches, rows_of
from trueaxis.identify.effects.unknowns import EffectUnknown
from trueaxis.identify.effects.variable_projection import explained
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.effect_terms import component_axis

ZOOMS = 2
POINTS = 256  # of the grid at a time


@dataclass(frozen=True, slots=True, eq=False)
class Others:
    """The fit of all other unknowns.

    pieces: weighted rows of their design matrix, all of one run each; root: (n_unknowns, rank), with inverse normal
    matrix root root'; residual: (n_readings,), mm, what they leave; roots: (n_readings,), square roots of the weights.
    """

    pieces: Callable[[], Iterator[tuple[IntArray, FloatArray]]]
    root: FloatArray
    residual: FloatArray
    roots: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class _Explained:
    """At points of the grid: (points,) sums of squares explained, mm^2, and (points, k) amplitudes."""

    squares: FloatArray
    amplitudes: FloatArray


def searched_start(ground: Ground, effect: Effect, kind: Kind, others: Others) -> EffectUnknown:
    """The effect at its best point."""
    points = _grid(ground, effect, kind)
    found = _explained(ground, effect, kind, points, others)
    best = int(np.argmax(found.squares))
    most, point, amplitudes = found.squares[best], points[best], found.amplitudes[best]
    for _ in range(ZOOMS if len(points) > 1 and len(points[0]) == 1 else 0):
        points = finer(points, best)
        found = _explained(ground, effect, kind, points, others)
        best = int(np.argmax(found.squares))
        if found.squares[best] >= most:
            most, point, amplitudes = found.squares[best], points[best], found.amplitudes[best]
    free = searched_names(kind)
    return EffectUnknown(effect, kind, np.concatenate([amplitudes, [point[name] for name in free]]), free)


def _grid(ground: Ground, effect: Effect, kind: Kind) -> tuple[Point, ...]:
    observed = ground.observed
    mine = np.array([is_in(effect, kind, run) for run in observed.runs], dtype=bool)[observed.run]
    positions = None
    if kind.place == "component":
        positions = observed.positions[ground.model.axes.index(component_axis(effect))]
    return grid_of(kind, positions, ground.context.time[mine])


def _explained(ground: Ground, effect: Effect, kind: Kind, points: tuple[Point, ...], others: Others) -> _Explained:
    parts = [
        _of_points(ground, effect, kind, points[first : first + POINTS], others)
        for first in range(0, len(points), POINTS)
    ]
    return _Explained(
        np.concatenate([part.squares for part in parts]), np.concatenate([part.amplitudes for part in parts])
    )


def _of_points(ground: Ground, effect: Effect, kind: Kind, points: tuple[Point, ...], others: Others) -> _Explained:
    k, rank = len(amplitude_names(kind)), others.root.shape[1]
    vectors = [vector for point in points for vector in basis_vectors(kind, point)]
    total, right = np.zeros((len(points), k, k)), np.zeros((len(points), k))
    inside = np.zeros((rank, len(vectors)))
    for rows, piece in others.pieces():
        index = int(ground.observed.run[rows[0]]) if rows.size else -1
        if index < 0 or not is_in(effect, kind, ground.observed.runs[index]):
            continue
        chosen = rows_of(ground, index, rows)
        if not reaches(ground, effect, kind, chosen):
            continue
        columns = np.array([of_term(ground, effect, kind, vector, chosen)[0] for vector in vectors]).T
        columns *= others.roots[rows, np.newaxis]
        shaped = columns.reshape(rows.size, len(points), k)
        total += np.einsum("npi,npj->pij", shaped, shaped, optimize=True)
        right += ((others.roots[rows] * others.residual[rows]) @ columns).reshape(len(points), k)
        inside += (piece @ others.root).T @ columns
    shaped = inside.reshape(rank, len(points), k)
    gram = total - np.einsum("rpi,rpj->pij", shaped, shaped, optimize=True)
    root = any(one.role == "root" for one in kind.parameters)
    return _Explained(*explained(gram, right, np.trace(total, axis1=1, axis2=2), one_sided=root))
