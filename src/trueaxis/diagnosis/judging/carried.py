"""Causes that one set-up alone carries: without its readings the others tell nothing of them.

One such cause may be what it is. Two of them ask for two effects, and for one set-up that happens to show both; that
this is wrong says it all. A line of four that belonged elsewhere was called a pitch error and an error that depends on
two axes: together they are any smooth curve of one line.
"""

from collections.abc import Sequence

import numpy as np

from trueaxis.diagnosis.causes.signature import Fitted
from trueaxis.diagnosis.judging.misfit import Group, groups_of
from trueaxis.diagnosis.null_model.null import Null, what_is_free
from trueaxis.diagnosis.result import FloatArray

SEVERAL = 2  # causes that one set-up alone carries
TOLD = 1e-3  # share of what all readings tell of a cause, below which those of the others tell nothing of it
ROUNDING = 1e-9  # of the largest eigenvalue of products, below which rounding is all there is


def carried_by_one(null: Null, causes: Sequence[Fitted]) -> tuple[tuple[Fitted, ...], frozenset[str]]:
    """Causes, two or more, that are told by no readings once some one set-up is left out, and the runs of all set-ups
    without which it is so; else none.
    """
    if len(causes) < SEVERAL:
        return (), frozenset()
    signals, found = np.column_stack([one.signal for one in causes]), dict[tuple[int, ...], list[str]]()
    groups = groups_of(null)
    whole, each = told_without(null, signals, groups)
    for group, told in zip(groups, each, strict=True):
        lost = tuple(np.flatnonzero(told < TOLD * whole).tolist())
        if len(lost) >= SEVERAL:
            found.setdefault(lost, []).extend(null.base.runs[place].rows.run.id for place in group)
    if not found:
        return (), frozenset()
    most = max(found, key=len)
    return tuple(causes[k] for k in most), frozenset(found[most])


def told_without(null: Null, signals: FloatArray, groups: Sequence[Group]) -> tuple[FloatArray, list[FloatArray]]:
    """(k,): squares, in standard deviations of the readings, of what the base and the other signals leave of each
    signal; and the same without the readings of each group of runs. signals: (n, k), mm.

    A reading with an unknown of its own says nothing of anything else: that leaves it out, and nothing is fitted anew
    (the mean shift of a deletion; Cook and Weisberg, Residuals and Influence in Regression, 1982).
    """
    projection = what_is_free(null, np.zeros((null.rows.size, 0)))
    left = projection.rest(null.whitening(signals))
    products, of_rows, found = left.T @ left, projection.rest_transposed(left), []
    for group in groups:
        rows = np.sort(np.concatenate([null.base.runs[place].rows.at for place in group]))
        free = np.linalg.pinv(projection.products(rows, np.eye(rows.size)), rcond=ROUNDING, hermitian=True)
        found.append(_apart(products - of_rows[rows].T @ free @ of_rows[rows]))
    return _apart(products), found


def _apart(products: FloatArray) -> FloatArray:
    """(k,): squares of what other columns leave of each, by their products, (k, k)."""
    found = np.zeros(len(products))
    for k in range(len(products)):
        others = np.arange(len(products)) != k
        inner = np.linalg.pinv(products[np.ix_(others, others)], rcond=ROUNDING, hermitian=True)
        found[k] = products[k, k] - products[k, others] @ inner @ products[others, k]
    return found
