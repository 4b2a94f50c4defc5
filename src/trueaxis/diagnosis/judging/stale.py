"""Which of the values given are no longer true: where the readings ask for others, beside all causes.

Errors of the machine are taken one component after another, the likeliest first: by the marginal likelihood of its
change, of which less than [prior] expects is expected. A component is stale where the readings ask for its change
beside those of all others that are, by the F test: no name leans on what is expected.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.diagnosis.null_model.base import SIZES, Base
from trueaxis.diagnosis.null_model.by_run import of_basis
from trueaxis.diagnosis.null_model.freedom import Freedom
from trueaxis.diagnosis.null_model.null import Null
from trueaxis.diagnosis.null_model.projection import Projection, orthonormal, spanned
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.null_model.whiten import RANK
from trueaxis.diagnosis.result import BoolArray, FloatArray, IntArray, Stale
from trueaxis.estimation.factors import decomposed
from trueaxis.estimation.tails import log_f_tail

FALSE_ALARMS = 1e-5  # share of data with true values in which one component or other is taken for stale
CHANGED = 2.0  # standard uncertainties: from where to where a curve has changed
BENDS = 25  # places on a curve, between any two of which it may have bent
ALIKE = 2.0  # decades of likelihood within which another component may be the one that changed
MOST_ALIKE = 4  # of these that are told


@dataclass(frozen=True, slots=True)
class Changes:
    """stale: most evident first; p_value: of all values given being right; evidence: decades by which the changes are
    likelier than none, the number of components that were tried taken off.
    """

    stale: tuple[Stale, ...]
    p_value: float
    evidence: float


@dataclass(frozen=True, slots=True, eq=False)
class _Asked:
    """What readings ask for. r: (m, p + 1), triangular factor of the machine's columns, in units of what is expected,
    and of the readings; at: which columns are those of each component; freedom: of the noise for each; of_all: for what
    all of them explain together: components that may have changed in each other's place share it.
    """

    r: FloatArray
    at: Mapping[str, IntArray]
    freedom: Mapping[str, float]
    of_all: float

    def gram(self, sizes: Mapping[str, float]) -> FloatArray:
        """(p + 1, p + 1): products of columns and readings, with changes of these sizes part of the noise."""
        found = self.r.T @ self.r
        for name, size in sizes.items():
            at = self.at[name]
            inner = found[np.ix_(at, at)] + np.eye(at.size) / size**2
            found = found - found[:, at] @ np.linalg.solve(inner, found[at])
        return np.asarray(found)

    def log_p(self, name: str, others: Sequence[str]) -> float:
        """Logarithm of the p value of its values being right, beside any change of the others.

        By directions of which the readings say more than what is expected of the largest change: in any other a change
        that readings ask for would be far larger than its own uncertainty has it, and the others' remainder no change.
        """
        held = orthonormal(self.r[:, np.concatenate([np.zeros(0, np.int64), *(self.at[one] for one in others)])])
        columns = self.r[:, self.at[name]]
        left, strength, _ = decomposed(columns - held @ (held.T @ columns))
        basis = left[:, strength > 1.0 / max(SIZES)]
        k, inside = basis.shape[1], basis.T @ self.r[:, -1]
        return log_f_tail(float(inside @ inside) / k, k, self.freedom[name]) if k else 0.0


def free_besides(null: Null, causes: Sequence[FloatArray], besides: Sequence[FloatArray]) -> Projection:
    """All that is no news but for the values given: unknowns of instruments, causes, what given values vary by.

    causes: (n,) each, by what readings change with parameters of causes, free in size; besides: (n,) each, mm, what
    causes may do besides, one standard deviation.
    """
    base, white = null.base, null.whitening
    columns = base.columns.take(slice(base.of_machine, None))
    columns = columns.beside(np.column_stack(causes)) if causes else columns
    of_given = base.machine @ (base.expected[: base.of_machine, np.newaxis] * null.given)
    chance = np.column_stack([base.by_chance, *besides, of_given])
    return Projection(spanned(columns.whitened(white))).softened(white(chance))


def stale_values(null: Null, causes: Sequence[FloatArray], besides: Sequence[FloatArray], freedom: Freedom) -> Changes:
    """What is stale. causes, besides: see `free_besides`."""
    rows, base = null.rows, null.base
    further = np.column_stack([*causes, base.by_chance, *besides, null.values])
    white = base.columns.times(np.diag(base.expected)).beside(further).whitened(null.whitening).weights
    free = base.expected.size + len(causes)
    machine, aside = white[:, : base.of_machine], white[:, base.of_machine : free]
    chance = np.hstack([white[:, free:-1], machine @ null.given])
    nuisance = Projection(of_basis(orthonormal(aside))).softened(chance)
    r = np.asarray(np.linalg.qr(nuisance.rest(np.column_stack([machine, white[:, -1]])), mode="r"))
    names, every = np.array(base.components), tuple(dict.fromkeys(base.components))
    at = {name: np.flatnonzero(names == name) for name in every}
    of_noise = {name: freedom.of(np.arange(rows.size), base.machine.take(at[name]).dense()) for name in every}
    fitted = np.linalg.lstsq(r[:, :-1], r[:, -1], rcond=RANK)[0] * base.expected[: base.of_machine]
    asked = _Asked(r, at, of_noise, freedom.of(np.arange(rows.size), (base.machine @ fitted)[:, np.newaxis]))
    sizes, evidence = _chosen(asked)
    found = [_change(rows, base, asked, sizes, name) for name in sizes]
    found.sort(key=lambda one: one.p_value)
    return Changes(tuple(found), _all_p(r, freedom), evidence)


def _all_p(r: FloatArray, freedom: Freedom) -> float:
    basis = orthonormal(r[:, :-1])
    inside = basis.T @ r[:, -1]
    if basis.shape[1] == 0:
        return 1.0
    least = float(freedom.of_rows.min())
    return float(np.exp(log_f_tail(float(inside @ inside) / basis.shape[1], basis.shape[1], least)))


def _chosen(asked: _Asked) -> tuple[dict[str, float], float]:
    """Components that have changed with the sizes of their changes, and the evidence for all of them."""
    limit = float(np.log(FALSE_ALARMS / max(len(asked.at), 1)))
    tries = float(np.log10(max(len(asked.at), 1)))
    sizes: dict[str, float] = {}
    while len(sizes) < len(asked.at):
        others = [name for name in asked.at if name not in sizes]
        evident = _evident(asked, asked.gram(sizes), others)
        # where the noise is hardly known, a curve of many numbers may be the likelier, and yet no finding
        likeliest = sorted(others, key=lambda name: -evident[name][2])
        best = next((name for name in likeliest if asked.log_p(name, tuple(sizes)) <= limit), None)
        if best is None:
            break
        sizes[best] = evident[best][1]
    while len(sizes) > 1:
        log_p = {name: asked.log_p(name, [one for one in sizes if one != name]) for name in sizes}
        least = max(log_p, key=lambda name: log_p[name])
        if log_p[least] <= limit:
            break
        del sizes[least]
    evidence, known = 0.0, dict[str, float]()
    for name, size in sizes.items():
        evidence += _evident(asked, asked.gram(known), [name])[name][0] - tries
        known[name] = size
    return sizes, evidence


def _evident(asked: _Asked, gram: FloatArray, names: Sequence[str]) -> dict[str, tuple[float, float, float]]:
    """Decades by which a change of each component is likelier than none, its likeliest size, and the decades where the
    size of the noise is known by its degrees of freedom alone (integrated over, a Student t distribution).
    """
    found = {}
    diagonal = np.abs(np.diag(asked.r))[:-1]
    rank = int(np.count_nonzero(diagonal > RANK * diagonal.max(initial=0.0)))
    total = float(gram[-1, -1] - asked.r[-1, -1] ** 2)
    for name in names:
        at = asked.at[name]
        strength, turned = np.linalg.eigh(gram[np.ix_(at, at)])
        gain = np.square(SIZES)[:, np.newaxis] * np.maximum(strength, 0.0)
        squares = np.square(SIZES)[:, np.newaxis] * (turned.T @ gram[at, -1]) ** 2
        explained, volume = np.sum(squares / (1.0 + gain), axis=1), np.sum(np.log1p(gain), axis=1)
        decades = 0.5 * (explained - volume) / np.log(10.0)
        freedom = asked.of_all
        left = np.maximum(freedom + total - explained, freedom)
        unsure = 0.5 * ((freedom + rank) * np.log((freedom + total) / left) - volume) / np.log(10.0)
        best = int(np.argmax(decades))
        found[name] = float(decades[best]), SIZES[best], float(unsure.max())
    return found


def _change(rows: Rows, base: Base, asked: _Asked, sizes: Mapping[str, float], name: str) -> Stale:
    """By how much values have changed where it is clearest, and from where to where about that place by more than they
    are uncertain.

    Where no place is certain, by how much the curve has bent, from where to where: its slope, or more of it, is then
    not told from those of other runs.
    """
    chosen = np.concatenate([asked.at[one] for one in sizes])
    expected = np.concatenate([np.full(asked.at[one].size, size) for one, size in sizes.items()])
    inverse = np.linalg.pinv(np.vstack([asked.r[:, chosen], np.diag(1.0 / expected)]))
    coefficient = inverse[:, : asked.r.shape[0]] @ asked.r[:, -1]
    mine = np.isin(chosen, asked.at[name])
    at, curve = base.curve(name, rows)
    value, u = curve @ coefficient[mine], np.linalg.norm(curve @ inverse[mine], axis=1)
    bent = at.size > 2 and not (np.abs(value) > CHANGED * u).any()
    if bent:
        ends, bends = _bends(at, curve)
        value, u = bends @ coefficient[mine], np.linalg.norm(bends @ inverse[mine], axis=1)
        peak = clearest(value, u)
        first, last = ends[peak].tolist()
    else:
        peak = clearest(value, u)
        first, last = _about(peak, np.abs(value) > CHANGED * u)
    others = {one: size for one, size in sizes.items() if one != name}
    return Stale(
        component=name,
        first=float(at[first]) if at.size > 1 else None,
        last=float(at[last]) if at.size > 1 else None,
        value=float(value[peak]),
        u=float(u[peak]),
        unit=base.units[name],
        p_value=float(np.exp(max(asked.log_p(name, tuple(others)), -700.0))),
        bent=bent,
        alike=_alike(asked, others, name),
    )


def _about(place: int, far: BoolArray) -> tuple[int, int]:
    """The first and the last of those about a place that are far."""
    near = np.flatnonzero(~far)
    first, last = near[near < place].max(initial=-1) + 1, near[near > place].min(initial=far.size) - 1
    return (int(first), int(last)) if far[place] else (place, place)


def _bends(at: FloatArray, curve: FloatArray) -> tuple[IntArray, FloatArray]:
    """Places (p, 2) of the ends of straight lines of many lengths, and (p, k): by the coefficients of a curve (m, k),
    how far it is from each of them halfway.
    """
    some = np.unique(np.round(np.linspace(0, at.size - 1, min(BENDS, at.size))).astype(np.int64))
    first, last = np.triu_indices(some.size, 2)
    even = (last - first) % 2 == 0
    ends = some[np.stack([first, last], axis=1)[even]]
    middle = some[(first + last)[even] // 2]
    share = ((at[middle] - at[ends[:, 0]]) / (at[ends[:, 1]] - at[ends[:, 0]]))[:, np.newaxis]
    return ends, curve[middle] - (1.0 - share) * curve[ends[:, 0]] - share * curve[ends[:, 1]]


def _alike(asked: _Asked, others: Mapping[str, float], name: str) -> tuple[str, ...]:
    """Components whose change explains the readings about as well, in place of this one."""
    evident = _evident(asked, asked.gram(others), [one for one in asked.at if one not in others])
    own = evident.pop(name)[0]
    near = sorted((one for one in evident if evident[one][0] > own - ALIKE), key=lambda one: -evident[one][0])
    return tuple(near[:MOST_ALIKE])


def clearest(value: FloatArray, u: FloatArray) -> int:
    """Where a change (n,) with standard uncertainties (n,) exceeds CHANGED of them by most; where none does, the place
    at which it comes nearest to it. The largest change itself may stand where the readings say least.
    """
    beyond = np.abs(value) - CHANGED * u
    if (beyond > 0.0).any():
        return int(np.argmax(beyond))
    return int(np.argmax(np.abs(value) / np.maximum(u, 1e-300)))
