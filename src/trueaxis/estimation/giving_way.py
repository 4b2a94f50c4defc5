"""Where the spec names an effect of an instrument, the instrument's own unknown of the same shape gives way to it."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import compress

import numpy as np

from trueaxis.estimation.jacobian import pieces
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.runs import MeasuredRun

SAME = 1e-3  # of an unknown's column: what effects leave of it is the curvature of their own columns


def giving_way(layout: Layout, runs: Sequence[MeasuredRun]) -> Layout:
    """Without the unknowns that runs share whose columns are those of effects: no reading could tell them apart.

    The spec says that the effect is there; the unknown would leave it as uncertain as what may be expected of any
    instrument.
    """
    if not layout.effects.count or not layout.shared:
        return layout
    columns = np.vstack([others[:, layout.of_machine :] for one in runs for _, _, others in pieces(layout, one.rows)])
    shared, effects = columns[:, : len(layout.shared)], columns[:, len(layout.shared) :]
    size = np.linalg.norm(effects, axis=0)
    left, singular, _ = np.linalg.svd(effects[:, size > 0.0] / size[size > 0.0], full_matrices=False)
    left = left[:, singular > SAME]
    rest = np.linalg.norm(shared - left @ (left.T @ shared), axis=0)
    kept = rest > SAME * np.linalg.norm(shared, axis=0)
    unknowns = np.concatenate([np.ones(layout.of_machine, dtype=bool), kept, np.ones(layout.effects.count, dtype=bool)])
    first = len(layout.kinds) - kept.size - layout.effects.count
    stays = [True] * first + kept.tolist() + [True] * layout.effects.count
    return replace(
        layout,
        shared=tuple(compress(layout.shared, kept)),
        sizes=layout.sizes[unknowns],
        kinds=tuple(compress(layout.kinds, stays)),
    )
