"""The audit: what these readings could show of every candidate, said before they are looked at.

With M the projection that takes the whitened base away and s the whitened signature per unit amplitude, lambda =
|M s|^2. An amplitude of sqrt(27 / lambda) is found about as often as not at the threshold of the evidence; one of
sqrt(21 / (lambda (1 - R^2))) is told from a rival with which the rest of its signature has the squared correlation R^2.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.diagnose.projection import Projection, orthonormal
from trueaxis.diagnose.result import FloatArray, Limit, Observability
from trueaxis.diagnose.search import Ground
from trueaxis.diagnose.signatures import Signature, signature_of
from trueaxis.effects.kind import Effect, Kind
from trueaxis.identify.effects.unknowns import unit_in
from trueaxis.identify.effects.variable_projection import UNOBSERVABLE

DETECTION, ISOLATION = 27.0, 21.0
CONFOUNDED = 0.95
IN_BASE = "the saturated base holds it"


@dataclass(frozen=True, slots=True, eq=False)
class Audit:
    """limits: of every candidate; isolable: those observable; correlation: R^2 between them, (g, g)."""

    limits: tuple[Limit, ...]
    isolable: tuple[Effect, ...]
    correlation: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class _Seen:
    """A candidate that can be seen. basis: (n, k), of what the base leaves; strength: lambda per amplitude."""

    effect: Effect
    basis: FloatArray
    strength: float
    share: float


def audit(ground: Ground) -> Audit:
    """From the signatures of all candidates; the readings have no part in it, nor has what was found in them.

    Candidates with searched parameters are represented by the middle of their grid.
    """
    plain = Projection(ground.base.basis)  # what a cause may do besides its form is known when it is found, not before
    seen: list[_Seen] = []
    limits: dict[Effect, Limit] = {}
    signatures = [signature_of(ground.readings, effect) for effect in ground.effects]
    columns = [_over_all(ground, one) for one in signatures]
    ends = np.cumsum([one.shape[1] for one in columns])
    left_of = np.split(plain.rest(np.hstack(columns)), ends[:-1], axis=1) if columns else []
    for effect, signature, whole, rest in zip(ground.effects, signatures, columns, left_of, strict=True):
        squares, left = float(np.sum(whole**2)), float(np.sum(rest**2))
        share = left / squares if squares > 0.0 else 0.0
        if signature.missing or share <= UNOBSERVABLE:
            limits[effect] = _unobservable(ground, effect, share, signature.missing)
        else:
            seen.append(_Seen(effect, orthonormal(rest), left / whole.shape[1], share))
    correlation = _correlations([one.basis for one in seen])
    for place, one in enumerate(seen):
        others = correlation[place].copy()
        others[place] = -1.0
        nearest = int(np.argmax(others))
        rival = seen[nearest].effect if len(seen) > 1 else None
        limits[one.effect] = _limit(ground, one, rival, max(float(others[nearest]), 0.0))
    return Audit(tuple(limits[effect] for effect in ground.effects), tuple(one.effect for one in seen), correlation)


def _over_all(ground: Ground, signature: Signature) -> FloatArray:
    """(n, k): the whitened signature in the middle of its grid, over all rows."""
    found = np.zeros((ground.values.size, signature.columns.shape[2]))
    found[signature.support] = ground.knows(signature).middle
    return found


def _correlations(bases: Sequence[FloatArray]) -> FloatArray:
    """Largest squared canonical correlation of each two subspaces."""
    if not bases:
        return np.zeros((0, 0))
    everything = np.hstack(bases)
    gram = everything.T @ everything
    ends = np.cumsum([0, *(one.shape[1] for one in bases)])
    sizes = np.diff(ends)
    found = np.add.reduceat(np.add.reduceat(gram**2, ends[:-1], axis=0), ends[:-1], axis=1)
    # of a single column the sum of squares is the squared correlation; of two planes it is more than the largest one
    planes = np.flatnonzero(sizes > 1)
    for i in planes:
        for j in planes:
            found[i, j] = np.linalg.norm(gram[ends[i] : ends[i + 1], ends[j] : ends[j + 1]], 2) ** 2
    return np.minimum(found, 1.0)


def _limit(ground: Ground, one: _Seen, nearest: Effect | None, r2: float) -> Limit:
    kind = ground.readings.model.machine.kinds[one.effect.kind]
    name, unit = size_of(kind, one.effect)
    detection = float(np.sqrt(DETECTION / one.strength))
    isolation = float(np.sqrt(ISOLATION / (one.strength * max(1.0 - r2, 1e-12))))
    if any(each.role == "root" for each in kind.parameters):
        detection, isolation = float(np.sqrt(detection)), float(np.sqrt(isolation))
    state: Observability = "confounded" if r2 > CONFOUNDED else "observable"
    return Limit(one.effect, name, unit, detection, max(detection, isolation), one.share, nearest, r2, state)


def _unobservable(ground: Ground, effect: Effect, share: float, missing: str) -> Limit:
    name, unit = size_of(ground.readings.model.machine.kinds[effect.kind], effect)
    reason = f"no {missing}" if missing else IN_BASE
    return Limit(effect, name, unit, np.inf, np.inf, share, None, 0.0, "unobservable", reason)


def size_of(kind: Kind, effect: Effect) -> tuple[str, str]:
    """Name and unit of the parameter that tells the size of an effect: its first."""
    first = kind.parameters[0]
    return first.name, unit_in(first.unit, effect)
