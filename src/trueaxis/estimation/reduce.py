"""All readings in a few triangles: whitened, each run's own unknowns parted off, the rest folded.

Time is linear in the number of readings, memory bounded.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.factors import triangle_of, with_rows
from trueaxis.estimation.instruments import own_kinds
from trueaxis.estimation.jacobian import Derivative, RunRows, derivatives
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.noise import Whitening
from trueaxis.measurement.machine import FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class OwnBlock:
    """The part of a run's whitened readings that its own unknowns take part in: readings = own b + others a + noise.

    kinds: class of each of the k own unknowns; own: (k, k); others: (k, n); readings: (k,).
    """

    kinds: tuple[str, ...]
    own: FloatArray
    others: FloatArray
    readings: FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Reduced:
    """What whitened readings say of n unknowns: triangle a + noise = readings, besides the blocks of the runs.

    triangle: (n, n), by scaled unknowns; readings: (n,); rest: sum of the squares that no unknown can change; log_root:
    half the logarithm of the determinant of the noise.
    """

    triangle: FloatArray
    readings: FloatArray
    rest: float
    blocks: tuple[OwnBlock, ...]
    log_root: float

    def holds(self, first: int) -> bool:
        """Whether a reading depends on one of the first unknowns."""
        return bool(self.triangle[:, :first].any()) or any(block.others[:, :first].any() for block in self.blocks)


def reduced(
    layout: Layout,
    runs: Sequence[RunRows],
    whitenings: Sequence[Whitening],
    readings: Sequence[FloatArray],
    unknowns: FloatArray | None = None,
    own_unknowns: Sequence[FloatArray] | None = None,
    kept: Sequence[Iterable[Derivative]] | None = None,
) -> Reduced:
    """readings: of each run (n,), mm, less what is expected with the unknowns (n,) and the runs' own ones, mm or rad;
    None: none of them is known yet; kept: the derivatives of each run's readings, where they are known.
    """
    n = layout.count
    scaled = None if unknowns is None else unknowns / layout.sizes
    folded = np.zeros((n + 1, n + 1))
    waiting: list[FloatArray] = []
    blocks = []
    log_root = 0.0
    for place, (rows, whiten, values) in enumerate(zip(runs, whitenings, readings, strict=True)):
        kinds = own_kinds(rows.run, layout.straightness[rows.index])
        k = len(kinds)
        known = None if scaled is None or own_unknowns is None else (own_unknowns[place], scaled)
        each = derivatives(layout, rows) if kept is None else kept[place]
        triangle = run_triangle(each, values, whiten, (k, n), known)
        if triangle.shape[0] < k:
            triangle = np.vstack([triangle, np.zeros((k - triangle.shape[0], k + n + 1))])
        blocks.append(OwnBlock(kinds=kinds, own=triangle[:k, :k], others=triangle[:k, k:-1], readings=triangle[:k, -1]))
        waiting.append(triangle[k:, k:])
        if sum(part.shape[0] for part in waiting) > n:
            folded, waiting = with_rows(folded, np.vstack(waiting)), []
        log_root += whiten.log_root
    folded = with_rows(folded, np.vstack([*waiting, np.zeros((0, n + 1))]))
    return Reduced(
        triangle=folded[:n, :n],
        readings=folded[:n, n],
        rest=float(folded[n, n] ** 2),
        blocks=tuple(blocks),
        log_root=log_root,
    )


def run_triangle(
    each: Iterable[Derivative],
    readings: FloatArray,
    whiten: Whitening,
    counts: tuple[int, int],
    known: tuple[FloatArray, FloatArray] | None = None,
) -> FloatArray:
    """(r, k + n + 1): what the whitened readings (m,) of a run say, r at most m and k + n + 1: by its own unknowns, by
    the others, and readings.

    counts: k and n; known: the unknowns, own and scaled, with which the readings were less; see `reduced`.
    """
    k, n = counts
    found, start, few = np.zeros((0, 0)), 0, True
    for one in each:
        whole = readings[start : start + one.place.size]
        start += one.place.size
        if known is not None:
            whole = whole + one.change(*known)
        # the ways in which the others change readings take their place: QR of columns that are not so many
        few = one.of_run or one.place.size == readings.size
        rows = whiten(np.hstack([one.own, one.by_few if few else one.by_others, whole[:, np.newaxis]]))
        found = with_rows(_square(found), rows) if found.size else triangle_of([rows])
    if not found.size:
        return np.zeros((0, k + n + 1))
    return np.hstack([found[:, :k], found[:, k:-1] @ one.others, found[:, -1:]]) if few else found


def _square(triangle: FloatArray) -> FloatArray:
    """With rows of zeros below."""
    return np.vstack([triangle, np.zeros((triangle.shape[1] - triangle.shape[0], triangle.shape[1]))])
