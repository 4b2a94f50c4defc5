"""All readings in a few triangles: whitened, each run's own unknowns parted off, the rest folded.

Time is linear in the number of readings, memory bounded.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.instruments import own_kinds
from trueaxis.estimation.jacobian import RunRows, pieces
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.noise import Whitening
from trueaxis.measure.machine import FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class OwnBlock:
    """The part of a run's whitened readings that its own unknowns take part in: readings = own b + others a + noise.

    kinds: class of each of the k own unknowns; own: (k, k); others: (k, n); readings: (k,).
    """

    index: int
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


def triangle_of(rows: Sequence[FloatArray]) -> FloatArray:
    """R of the QR factorisation of stacked rows: it says the same of the unknowns."""
    return np.asarray(np.linalg.qr(np.vstack(rows), mode="r"))


def reduced(
    layout: Layout,
    runs: Sequence[RunRows],
    whitenings: Sequence[Whitening],
    readings: Sequence[FloatArray],
    unknowns: FloatArray | None = None,
    own_unknowns: Sequence[FloatArray] | None = None,
) -> Reduced:
    """readings: of each run (n,), mm, less what is expected with the unknowns (n,) and the runs' own ones, mm or rad;
    None: none of them is known yet.
    """
    n = layout.count
    scaled = None if unknowns is None else unknowns / layout.sizes
    folded = np.zeros((0, n + 1))
    waiting: list[FloatArray] = []
    blocks = []
    log_root = 0.0
    for place, (rows, whiten, values) in enumerate(zip(runs, whitenings, readings, strict=True)):
        kinds = own_kinds(rows.run, layout.straightness[rows.index])
        k = len(kinds)
        triangle = np.zeros((0, k + n + 1))
        for part, own, others in pieces(layout, rows):
            whole = values[part]
            if scaled is not None and own_unknowns is not None:
                whole = whole + others @ scaled + own @ own_unknowns[place]
            white = whiten(np.hstack([own, others, whole[:, np.newaxis]]))
            triangle = triangle_of([triangle, white])
        if triangle.shape[0] < k:
            triangle = np.vstack([triangle, np.zeros((k - triangle.shape[0], k + n + 1))])
        blocks.append(
            OwnBlock(
                index=rows.index,
                kinds=kinds,
                own=triangle[:k, :k],
                others=triangle[:k, k:-1],
                readings=triangle[:k, -1],
            )
        )
        waiting.append(triangle[k:, k:])
        if sum(part.shape[0] for part in waiting) > 3 * n:
            folded, waiting = triangle_of([folded, *waiting]), []
        log_root += whiten.log_root
    folded = triangle_of([folded, *waiting, np.zeros((n + 1, n + 1))])
    return Reduced(
        triangle=folded[:n, :n],
        readings=folded[:n, n],
        rest=float(folded[n, n] ** 2),
        blocks=tuple(blocks),
        log_root=log_root,
    )
