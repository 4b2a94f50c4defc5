"""Where the spec names an effect of an instrument, the instrument's own unknown of the same shape gives way to it."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import compress

import numpy as np

from trueaxis.estimation.factors import decomposed
from trueaxis.estimation.jacobian import pieces
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.measurement.columns import BoolArray
from trueaxis.measurement.machine import FloatArray

SAME = 1e-3  # of an unknown's column: what effects leave of it is the curvature of their own columns


def giving_way(layout: Layout, runs: Sequence[MeasuredRun]) -> Layout:
    """Without the unknowns of the instruments whose columns are those of effects: no reading could tell them apart.

    The spec says that the effect is there; the unknown would leave it as uncertain as what may be expected of any
    instrument. An unknown of one run gives way to effects of that run alone: an effect of several runs is what they
    have in common, and each may have more of its own.
    """
    if not layout.effects.count:
        return layout
    parts = [list(pieces(layout, one.rows)) for one in runs]
    others = [np.vstack([columns[:, layout.of_machine :] for _, _, columns in part]) for part in parts]
    own = [np.vstack([columns for _, columns, _ in part]) for part in parts]
    first = len(layout.shared)
    kept = ~_within(np.vstack([columns[:, :first] for columns in others]), np.vstack([c[:, first:] for c in others]))
    in_runs = np.array([columns[:, first:].any(axis=0) for columns in others])
    alone = in_runs.sum(axis=0) == 1
    silent = {}
    for place, one in enumerate(runs):
        same = _within(own[place], others[place][:, first:][:, alone & in_runs[place]]) & own[place].any(axis=0)
        if same.any():
            silent[one.rows.index] = tuple(np.flatnonzero(same).tolist())
    return _without(replace(layout, silent=silent), kept)


def _within(columns: FloatArray, effects: FloatArray) -> BoolArray:
    """(k,): which of columns (n, k) are sums of those of effects (n, m)."""
    size = np.linalg.norm(effects, axis=0)
    left, singular, _ = decomposed(effects[:, size > 0.0] / size[size > 0.0])
    left = left[:, singular > SAME]
    rest = np.linalg.norm(columns - left @ (left.T @ columns), axis=0)
    return np.asarray(rest <= SAME * np.linalg.norm(columns, axis=0))


def _without(layout: Layout, kept: BoolArray) -> Layout:
    """With those alone of the unknowns that runs share, kept (n_shared,)."""
    unknowns = np.concatenate([np.ones(layout.of_machine, dtype=bool), kept, np.ones(layout.effects.count, dtype=bool)])
    first = len(layout.kinds) - kept.size - layout.effects.count
    stays = [True] * first + kept.tolist() + [True] * layout.effects.count
    return replace(
        layout,
        shared=tuple(compress(layout.shared, kept)),
        sizes=layout.sizes[unknowns],
        kinds=tuple(compress(layout.kinds, stays)),
    )
