"""Which of the values given are no longer true: where the readings ask for others, beside all causes.

Errors of the machine are taken one component after another, the one that explains most first, until none explains more
than noise may.
"""

from collections.abc import Sequence

import numpy as np

from trueaxis.diagnose.base import Base
from trueaxis.diagnose.by_run import of_basis
from trueaxis.diagnose.freedom import Freedom
from trueaxis.diagnose.null import Null
from trueaxis.diagnose.projection import Projection, orthonormal
from trueaxis.diagnose.result import FloatArray, IntArray, Stale
from trueaxis.diagnose.rows import Rows
from trueaxis.diagnose.tails import log_f_tail
from trueaxis.diagnose.whiten import RANK

FALSE_ALARMS = 1e-5  # share of data with true values in which one component or other is taken for stale
CHANGED = 2.0  # standard uncertainties: from where to where a curve has changed


def stale_values(
    null: Null, causes: Sequence[FloatArray], besides: Sequence[FloatArray], freedom: Freedom
) -> tuple[tuple[Stale, ...], float]:
    """What is stale, most evident first, and the p value of all values given being true.

    causes: (n,) each, mm, signals of causes, free in size; besides: (n,) each, mm, what they may do besides, one
    standard deviation.
    """
    rows, base, whitening = null.rows, null.base, null.whitening
    further = np.column_stack([*causes, base.by_chance, *besides, null.values])
    white = base.columns.times(np.diag(base.expected)).beside(further).whitened(whitening).weights
    free = base.expected.size + len(causes)
    aside, chance = white[:, base.of_machine : free], white[:, free:-1]
    nuisance = Projection(of_basis(orthonormal(aside))).softened(chance)
    r = np.asarray(np.linalg.qr(nuisance.rest(white[:, [*range(base.of_machine), -1]]), mode="r"))
    return _chosen(rows, base, r, freedom), _all_p(r, freedom)


def _all_p(r: FloatArray, freedom: Freedom) -> float:
    basis = orthonormal(r[:, :-1])
    inside = basis.T @ r[:, -1]
    if basis.shape[1] == 0:
        return 1.0
    least = float(freedom.of_rows.min())
    return float(np.exp(log_f_tail(float(inside @ inside) / basis.shape[1], basis.shape[1], least)))


def _chosen(rows: Rows, base: Base, r: FloatArray, freedom: Freedom) -> tuple[Stale, ...]:
    names = np.array(base.components)
    every = list(dict.fromkeys(base.components))
    limit = float(np.log(FALSE_ALARMS / max(len(every), 1)))
    of_noise = {name: _freedom(rows, base, name, freedom) for name in every}
    taken: list[str] = []
    found: list[tuple[str, float]] = []
    left = r[:, -1]
    while len(taken) < len(every):
        held = orthonormal(r[:, :-1][:, np.isin(names, taken)])
        tried = []
        for name in every:
            if name in taken:
                continue
            columns = r[:, :-1][:, names == name]
            rest = columns - held @ (held.T @ columns)
            kept = np.linalg.norm(rest, axis=0) > RANK * np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
            basis = orthonormal(rest[:, kept])
            k = basis.shape[1]
            inside = basis.T @ left
            tried.append((log_f_tail(float(inside @ inside) / k, k, of_noise[name]) if k else 0.0, name))
        log_p, best = min(tried)
        if log_p > limit:
            break
        taken.append(best)
        found.append((best, log_p))
    return tuple(_change(rows, base, r, names, taken, name, log_p) for name, log_p in found)


def _freedom(rows: Rows, base: Base, name: str, freedom: Freedom) -> float:
    at: IntArray = np.arange(rows.size)
    return freedom.of(at, base.machine.take(np.array(base.components) == name).dense())


def _change(
    rows: Rows, base: Base, r: FloatArray, names: FloatArray, taken: Sequence[str], name: str, log_p: float
) -> Stale:
    """By how much values have changed where it is clearest, and from where to where by more than they are uncertain."""
    chosen = np.isin(names, taken)
    columns = r[:, :-1][:, chosen]
    triangle = np.vstack([columns, np.eye(columns.shape[1])])  # about what is expected
    inverse = np.linalg.pinv(triangle)
    coefficient = inverse[:, : r.shape[0]] @ r[:, -1]
    root = inverse
    mine = names[chosen] == name
    at, curve = base.curve(name, rows)
    value = curve @ coefficient[mine]
    u = np.linalg.norm(curve @ root[mine], axis=1)
    peak = clearest(value, u)
    far = np.flatnonzero(np.abs(value) > CHANGED * u)
    first, last = (far[0], far[-1]) if far.size else (peak, peak)
    return Stale(
        component=name,
        first=float(at[first]) if at.size > 1 else None,
        last=float(at[last]) if at.size > 1 else None,
        value=float(value[peak]),
        u=float(u[peak]),
        unit=base.units[name],
        p_value=float(np.exp(max(log_p, -700.0))),
    )


def clearest(value: FloatArray, u: FloatArray) -> int:
    """Where a change (n,) with standard uncertainties (n,) exceeds CHANGED of them by most; where none does, the place
    at which it comes nearest to it. The largest change itself may stand where the readings say least.
    """
    beyond = np.abs(value) - CHANGED * u
    if (beyond > 0.0).any():
        return int(np.argmax(beyond))
    return int(np.argmax(np.abs(value) / np.maximum(u, 1e-300)))
