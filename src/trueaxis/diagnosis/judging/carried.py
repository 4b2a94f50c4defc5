"""Causes that one set-up alone carries: without its readings the others tell nothing of them.

One such cause may be what it is. Two of them ask for two effects, and for one set-up that happens to show both; that
this is wrong says it all. A line of four that belonged elsewhere was called a pitch error and an error that depends on
two axes: together they are any smooth curve of one line.
"""

from collections.abc import Sequence

import numpy as np

from trueaxis.diagnosis.causes.signature import Fitted
from trueaxis.diagnosis.judging.misfit import groups_of
from trueaxis.diagnosis.null_model.null import Null, what_is_free
from trueaxis.diagnosis.result import FloatArray

SEVERAL = 2  # causes that one set-up alone carries
TOLD = 1e-3  # share of what all readings tell of a cause, below which those of the others tell nothing of it


def carried_by_one(null: Null, causes: Sequence[Fitted]) -> tuple[tuple[Fitted, ...], frozenset[str]]:
    """Causes, two or more, that are told by no readings once some one set-up is left out, and the runs of all set-ups
    without which it is so; else none.
    """
    if len(causes) < SEVERAL:
        return (), frozenset()
    signals = np.column_stack([one.signal for one in causes])
    whole, found = _told(null, signals), dict[tuple[int, ...], list[str]]()
    for group in groups_of(null):
        runs = [null.base.runs[place].rows for place in group]
        others = ~np.isin(null.rows.run, [one.index for one in runs])
        told = _told(null.only(others), signals[others]) if others.any() else np.zeros(len(causes))
        lost = tuple(np.flatnonzero(told < TOLD * whole).tolist())
        if len(lost) >= SEVERAL:
            found.setdefault(lost, []).extend(one.run.id for one in runs)
    if not found:
        return (), frozenset()
    most = max(found, key=len)
    return tuple(causes[k] for k in most), frozenset(found[most])


def _told(null: Null, signals: FloatArray) -> FloatArray:
    """(k,): whitened squares of what the base and the other signals leave of each of them, (n, k), mm."""
    left = what_is_free(null, np.zeros((null.rows.size, 0))).rest(null.whitening(signals))
    found = np.zeros(left.shape[1])
    for k in range(left.shape[1]):
        others = np.delete(left, k, axis=1)
        rest = left[:, k] - others @ np.linalg.lstsq(others, left[:, k], rcond=None)[0]
        found[k] = rest @ rest
    return found
