"""The audit: what these readings could show of every candidate, said before they are looked at.

With M the projection that takes the whitened base away and s the whitened signature per unit amplitude, lambda =
|M s|^2. An amplitude of sqrt(27 / lambda) is found about as often as not at the threshold of the evidence; one of
sqrt(21 / (lambda (1 - R^2))) is told from a rival with which the rest of its signature has the squared correlation R^2.
Both are of a noise that is known. Where few degrees of freedom tell it, the threshold is farther out, and so are they.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.special import chdtrc, fdtri

from trueaxis.diagnosis.causes.candidates import grid_of
from trueaxis.diagnosis.causes.search import Ground
from trueaxis.diagnosis.causes.signature import Signature
from trueaxis.diagnosis.causes.signatures import signature_of
from trueaxis.diagnosis.further_runs.of_plan import Limit, Observability
from trueaxis.diagnosis.null_model.projection import Projection, orthonormal
from trueaxis.diagnosis.result import BoolArray, FloatArray, IntArray
from trueaxis.effects.kind import Effect, Kind
from trueaxis.estimation.effects.amplitudes import UNOBSERVABLE
from trueaxis.estimation.effects.unknowns import unit_in

DETECTION, ISOLATION = 27.0, 21.0
CONFOUNDED = 0.95
SMALL = 16  # points of a grid
AT_ONCE = 64  # columns
IN_BASE = "new values of the errors would hold it"


@dataclass(frozen=True, slots=True, eq=False)
class Audit:
    """limits: of every candidate; isolable: those observable; correlation: R^2 between them, (g, g)."""

    limits: tuple[Limit, ...]
    isolable: tuple[Effect, ...]
    correlation: FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _Seen:
    """A candidate that can be seen. bases: (n, k) each, of what the base leaves at the points of its grid; strength:
    lambda per amplitude, at the middle one, less by how much farther out a noise that is not quite known has limits.
    """

    effect: Effect
    points: tuple[Mapping[str, float], ...]
    bases: tuple[FloatArray, ...]
    strength: float
    share: float

    @property
    def middle(self) -> FloatArray:
        """(n, k): the basis in the middle of the grid."""
        return self.bases[len(self.bases) // 2]


def audit(ground: Ground) -> Audit:
    """From the signatures of all candidates; the readings have no part in it, nor has what was found in them.

    A candidate with searched parameters is looked for in the middle of its grid; as a rival it may be anywhere on it.
    """
    plain = ground.plain  # what a cause may do besides its form is known when it is found, not before
    seen: list[_Seen] = []
    limits: dict[Effect, Limit] = {}
    for effect, signature, whole, rest in _left(ground, plain):
        k = signature.terms.shape[2] - signature.free
        parts = [slice(start, start + k) for start in range(0, whole.shape[1], k)]
        middle = parts[len(parts) // 2]
        raw = signature.columns(slice(len(parts) // 2, len(parts) // 2 + 1))[:, 0]
        squares = float(np.sum((raw / ground.freedom.sigma[signature.support, np.newaxis]) ** 2))
        left = float(np.sum(rest[:, middle] ** 2))
        share = left / squares if squares > 0.0 else 0.0
        if signature.missing or share <= UNOBSERVABLE:
            limits[effect] = _unobservable(ground, effect, share, signature.missing)
            continue
        seen.append(
            _Seen(
                effect=effect,
                points=signature.points,
                bases=tuple(_basis(rest[:, part]) for part in parts),
                strength=left / k / _farther(ground.freedom.of_cause(signature.support, raw)),
                share=share,
            )
        )
    r2, place_of = _alike(seen)
    for place, one in enumerate(seen):
        others = r2[place].copy()
        others[place] = -1.0
        nearest = int(np.argmax(others))
        rival = seen[nearest] if len(seen) > 1 else None
        limits[one.effect] = _limit(ground, one, rival, max(float(others[nearest]), 0.0), int(place_of[place, nearest]))
    correlation = np.maximum(r2, r2.T)
    return Audit(tuple(limits[effect] for effect in ground.effects), tuple(one.effect for one in seen), correlation)


def _farther(freedom: float) -> float:
    """By how many times the threshold is larger where so many degrees of freedom tell the noise, by the F test."""
    return float(fdtri(1.0, freedom, 1.0 - chdtrc(1.0, DETECTION))) / DETECTION


def _left(ground: Ground, base: Projection) -> Iterator[tuple[Effect, Signature, FloatArray, FloatArray]]:
    """Each candidate with its signature, whitened, (n, points k), and what the base and amplitudes of runs leave of it.

    Many at once: for a column or two the base would be read as often as for a hundred.
    """
    waiting: list[tuple[Effect, Signature, FloatArray]] = []
    for place, effect in enumerate(ground.effects):
        signature = _shown(ground, effect)
        _, count, k = signature.terms.shape
        columns = signature.columns(slice(None)).reshape(-1, count * k)
        whole = np.zeros((ground.values.size, count * k))
        whole[signature.support] = ground.whitening.part(signature.support, columns)
        waiting.append((effect, signature, whole))
        if sum(one.shape[1] for *_, one in waiting) >= AT_ONCE or place == len(ground.effects) - 1:
            rest = base.rest(np.hstack([one for *_, one in waiting]))
            ends = np.cumsum([one.shape[1] for *_, one in waiting])
            for (one, its, columns), left in zip(waiting, np.split(rest, ends[:-1], axis=1), strict=True):
                yield one, its, columns[:, _own(its)], _without_runs(left, its)
            waiting = []


def _own(signature: Signature) -> BoolArray:
    """(points k,): amplitudes of the effect, not of runs."""
    _, count, k = signature.terms.shape
    return np.tile(np.arange(k) < k - signature.free, count)


def _without_runs(left: FloatArray, signature: Signature) -> FloatArray:
    """What the amplitudes of runs leave of those of the effect, point by point."""
    own = _own(signature)
    if signature.free == 0:
        return left
    parts = [np.split(one, len(signature.points), axis=1) for one in (left[:, own], left[:, ~own])]
    runs = map(orthonormal, parts[1])
    return np.hstack([one - of_runs @ (of_runs.T @ one) for one, of_runs in zip(parts[0], runs, strict=True)])


def _shown(ground: Ground, effect: Effect) -> Signature:
    """At all points of a small grid, in the middle of a large one, whose points are not alike."""
    readings = ground.readings
    points = grid_of(readings.model.machine.kinds[effect.kind], effect, readings.rows)
    middle = points[len(points) // 2]
    return signature_of(readings, effect, None if len(points) <= SMALL else (middle,))


def _basis(columns: FloatArray) -> FloatArray:
    """Orthonormal; one column of zeros where nothing is left."""
    found = orthonormal(columns)
    return found if found.shape[1] else np.zeros((columns.shape[0], 1))


def _alike(seen: Sequence[_Seen]) -> tuple[FloatArray, IntArray]:
    """(g, g): R^2 of each candidate in the middle of its grid with each other where that is most like it, and where."""
    found, places = np.eye(len(seen)), np.zeros((len(seen), len(seen)), dtype=np.int64)
    if seen:
        every = _correlations([one.middle for one in seen], [basis for one in seen for basis in one.bases])
        ends = np.cumsum([len(one.bases) for one in seen])
        for column, part in enumerate(np.split(every, ends[:-1], axis=1)):
            places[:, column] = np.argmax(part, axis=1)
            found[:, column] = part.max(axis=1)
    return found, places


def _correlations(bases: Sequence[FloatArray], others: Sequence[FloatArray]) -> FloatArray:
    """Largest squared canonical correlation of each two subspaces."""
    first, starts = np.hstack(bases).T, range(0, len(others), AT_ONCE)
    # all of them side by side would take as much memory again
    gram = np.hstack([first @ np.hstack(others[start : start + AT_ONCE]) for start in starts])
    rows, columns = (np.cumsum([0, *(one.shape[1] for one in each)]) for each in (bases, others))
    found = np.add.reduceat(np.add.reduceat(gram**2, rows[:-1], axis=0), columns[:-1], axis=1)
    # of a single column the sum of squares is the squared correlation; of two planes it is more than the largest one
    for i in np.flatnonzero(np.diff(rows) > 1):
        for j in np.flatnonzero(np.diff(columns) > 1):
            part = gram[rows[i] : rows[i + 1], columns[j] : columns[j + 1]]
            found[i, j] = np.linalg.norm(part, 2) ** 2
    return np.asarray(np.minimum(found, 1.0))


def _limit(ground: Ground, one: _Seen, nearest: _Seen | None, r2: float, place: int) -> Limit:
    kind = ground.readings.model.machine.kinds[one.effect.kind]
    name, unit = size_of(kind, one.effect)
    detection = float(np.sqrt(DETECTION / one.strength))
    isolation = float(np.sqrt(ISOLATION / (one.strength * max(1.0 - r2, 1e-12))))
    if any(each.role == "root" for each in kind.parameters):
        detection, isolation = float(np.sqrt(detection)), float(np.sqrt(isolation))
    state: Observability = "confounded" if r2 > CONFOUNDED else "observable"
    rival, at = (None, {}) if nearest is None else (nearest.effect, nearest.points[place])
    isolation = max(detection, isolation)
    return Limit(
        effect=one.effect,
        size=name,
        unit=unit,
        detection=detection,
        isolation=isolation,
        share=one.share,
        nearest=rival,
        r2=r2,
        state=state,
        nearest_at=at,
    )


def _unobservable(ground: Ground, effect: Effect, share: float, missing: str) -> Limit:
    name, unit = size_of(ground.readings.model.machine.kinds[effect.kind], effect)
    reason = f"no {missing}" if missing else IN_BASE
    return Limit(
        effect=effect,
        size=name,
        unit=unit,
        detection=np.inf,
        isolation=np.inf,
        share=share,
        nearest=None,
        r2=0.0,
        state="unobservable",
        reason=reason,
    )


def size_of(kind: Kind, effect: Effect) -> tuple[str, str]:
    """Name and unit of the parameter that tells the size of an effect: its first."""
    first = kind.parameters[0]
    return first.name, unit_in(first.unit, effect)
