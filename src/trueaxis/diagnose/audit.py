"""The audit: what these readings could show of every candidate, said before they are looked at.

With M the projection that takes the whitened base away and s the whitened signature per unit amplitude, lambda =
|M s|^2. An amplitude of sqrt(27 / lambda) is found about as often as not at the threshold of the evidence; one of
sqrt(21 / (lambda (1 - R^2))) is told from a rival with which the rest of its signature has the squared correlation R^2.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.diagnose.projection import Projection, orthonormal
from trueaxis.diagnose.result import FloatArray, Limit
from trueaxis.diagnose.scan import UNOBSERVABLE, Scanned
from trueaxis.diagnose.search import Ground
from trueaxis.effects.kind import Effect, Kind

DETECTION, ISOLATION = 27.0, 21.0
CONFOUNDED = 0.95
IN_BASE = "the saturated base holds it"


@dataclass(frozen=True, slots=True, eq=False)
class Audit:
    """limits: of every candidate; isolable: those observable; correlation: R^2 between them, (g, g)."""

    limits: tuple[Limit, ...]
    isolable: tuple[Effect, ...]
    correlation: FloatArray


def audit(ground: Ground, scans: Sequence[Scanned]) -> Audit:
    """From the signatures that the scan made; the readings have no part in it, nor has what was found in them.

    Candidates with searched parameters are represented by the middle of their grid.
    """
    plain = Projection(ground.base.basis)  # what a cause may do besides its form is known when it is found, not before
    audited = []
    bases = []
    for one in scans:
        whole = np.zeros((ground.values.size, one.freedom))
        whole[one.support] = one.middle
        rest = plain.rest(whole)
        squares, left = float(np.sum(whole**2)), float(np.sum(rest**2))
        share = left / squares if squares > 0.0 else 0.0
        audited.append(replace(one, share=share, strength=left / one.freedom))
        if not one.missing and share > UNOBSERVABLE:
            basis = orthonormal(rest)
            bases.append(basis if basis.shape[1] else np.zeros((whole.shape[0], 1)))
    scans = audited
    seen = [one for one in scans if not one.missing and one.share > UNOBSERVABLE]
    correlation = _correlations(bases)
    limits = {}
    for place, one in enumerate(seen):
        others = correlation[place].copy()
        others[place] = -1.0
        nearest = int(np.argmax(others)) if len(seen) > 1 else place
        limits[one.effect] = _limit(
            ground, one, seen[nearest].effect if len(seen) > 1 else None, float(others[nearest])
        )
    for one in scans:
        if one.effect not in limits:
            limits[one.effect] = _unobservable(ground, one)
    return Audit(tuple(limits[one.effect] for one in scans), tuple(one.effect for one in seen), correlation)


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


def _limit(ground: Ground, one: Scanned, nearest: Effect | None, r2: float) -> Limit:
    kind = ground.readings.model.machine.kinds[one.effect.kind]
    name, unit = size_of(kind, one.effect)
    r2 = max(r2, 0.0)
    detection = float(np.sqrt(DETECTION / one.strength))
    isolation = float(np.sqrt(ISOLATION / (one.strength * max(1.0 - r2, 1e-12))))
    if any(each.role == "root" for each in kind.parameters):
        detection, isolation = float(np.sqrt(detection)), float(np.sqrt(isolation))
    state = "confounded" if r2 > CONFOUNDED else "observable"
    return Limit(one.effect, name, unit, detection, max(detection, isolation), one.share, nearest, r2, state)  # type: ignore[arg-type]


def _unobservable(ground: Ground, one: Scanned) -> Limit:
    name, unit = size_of(ground.readings.model.machine.kinds[one.effect.kind], one.effect)
    reason = f"no {one.missing}" if one.missing else IN_BASE
    return Limit(one.effect, name, unit, np.inf, np.inf, one.share, None, 0.0, "unobservable", reason)


def size_of(kind: Kind, effect: Effect) -> tuple[str, str]:
    """Name and unit of the parameter that tells the size of an effect: its first."""
    first = kind.parameters[0]
    return first.name, unit_at(first.unit, effect)


def unit_at(unit: str, effect: Effect) -> str:
    """The unit of a parameter where the effect acts: `u` and `axis` filled in."""
    component = effect.component or ""
    turns = len(component) > 1 and component[1] in "ABC"
    rotary = component[-1:] in tuple("ABC")
    words = {"u": "rad" if turns else "mm", "axis": "deg" if rotary else "mm"}
    return "/".join(words.get(word, word) for word in unit.split("/"))
