"""Where the fit of an effect starts whose term is not linear in all parameters: the point of a grid that explains most.

At every point the amplitudes are those of least squares beside all other unknowns, which are projected out (variable
projection, G. H. Golub and V. Pereyra, 1973).
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.placement import concerns
from trueaxis.estimation.effects.amplitudes import amplitude_names, basis_vectors, explained, searched_names
from trueaxis.estimation.effects.grids import OF_FIT, ZOOMS, Point, covered_by, finer, grid_of
from trueaxis.estimation.effects.signature import Ground, of_term, reaches, rows_of
from trueaxis.estimation.effects.unknowns import EffectUnknown
from trueaxis.estimation.machine import IntArray
from trueaxis.measurement.machine import FloatArray

ENTRIES = 2**22  # of signatures held at a time: 32 MB


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class WhitenedRun:
    """Readings of one run in units of their noise, beside everything else that is estimated.

    index: of the run; rows: (m,), its readings in the order in which they were taken; whiten: makes the noise of
    columns (m, q) white and 1; rest: what the run's own unknowns leave of whitened columns (m, q); shared: (r, q) from
    what they leave: the sum over all runs, squared, is what unknowns that runs share take of it; residual: (m,),
    whitened.
    """

    index: int
    rows: IntArray
    whiten: Callable[[FloatArray], FloatArray]
    rest: Callable[[FloatArray], FloatArray]
    shared: Callable[[FloatArray], FloatArray]
    residual: FloatArray


Others = Callable[[], Iterator[WhitenedRun]]


@dataclass(frozen=True, slots=True, eq=False)
class _Explained:
    """At points of the grid: (points,) sums of squares explained, mm^2, and (points, k) amplitudes."""

    squares: FloatArray
    amplitudes: FloatArray


def searched_start(ground: Ground, effect: Effect, kind: Kind, others: Others) -> EffectUnknown:
    """The effect at its best point."""
    points = grid_points(ground, effect, kind)
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
    return EffectUnknown(
        effect=effect, kind=kind, values=np.concatenate([amplitudes, [point[name] for name in free]]), free=free
    )


def grid_points(ground: Ground, effect: Effect, kind: Kind) -> tuple[Point, ...]:
    """Where the searched parameters of an effect are looked for in these readings."""
    observed = ground.observed
    mine = np.array([concerns(kind, effect, run) for run in observed.runs], dtype=bool)[observed.run]
    covered = covered_by(effect, ground.model.axes, observed.positions[:, mine], ground.context.of(mine))
    return grid_of(kind, covered, OF_FIT)


def _explained(ground: Ground, effect: Effect, kind: Kind, points: tuple[Point, ...], others: Others) -> _Explained:
    k = len(amplitude_names(kind))
    longest = int(np.bincount(ground.observed.run).max())
    together = max(ENTRIES // (longest * k), 1)
    parts = [
        _of_points(ground, effect, kind, points[first : first + together], others)
        for first in range(0, len(points), together)
    ]
    return _Explained(
        np.concatenate([part.squares for part in parts]), np.concatenate([part.amplitudes for part in parts])
    )


def _of_points(ground: Ground, effect: Effect, kind: Kind, points: tuple[Point, ...], others: Others) -> _Explained:
    k = len(amplitude_names(kind))
    vectors = [vector for point in points for vector in basis_vectors(kind, point)]
    total, gram = np.zeros((len(points), k, k)), np.zeros((len(points), k, k))
    right, inside = np.zeros((len(points), k)), np.zeros((0, len(vectors)))
    for run in others():
        if not concerns(kind, effect, ground.observed.runs[run.index]):
            continue
        chosen = rows_of(ground, run.index, run.rows)
        if not reaches(ground, effect, kind, chosen):
            continue
        columns = run.whiten(np.array([of_term(ground, effect, kind, vector, chosen)[0] for vector in vectors]).T)
        rest = run.rest(columns)
        total += _products(columns, columns, k)
        gram += _products(columns, rest, k)
        right += (run.residual @ columns).reshape(-1, k)
        part = run.shared(rest)
        inside = part if inside.size == 0 else inside + part
    gram -= _products(inside, inside, k)
    root = any(one.role == "root" for one in kind.parameters)
    return _Explained(*explained(gram, right, np.trace(total, axis1=1, axis2=2), one_sided=root))


def _products(left: FloatArray, right: FloatArray, k: int) -> FloatArray:
    """(points, k, k): products of the k columns of each point."""
    shaped = [columns.reshape(columns.shape[0], -1, k) for columns in (left, right)]
    return np.asarray(np.einsum("npi,npj->pij", *shaped, optimize=True))
