"""From what size on readings can show an effect, by the true noise and apart from the package.

With M the projection that takes away what smooth curves of every component error, location errors and flat unknowns of
every instrument can imitate, and s the whitened signature of the effect as it is hidden, lambda = |M s|^2. It is found
about as often as not at lambda = 27, and told from a rival of squared correlation R^2 at lambda (1 - R^2) = 21
(design of the method: docs/diagnosis.md).
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.polynomial import legendre
from scipy.linalg import cholesky, qr, solve_triangular

from tests.hidden_effects.power.grade import Name
from tests.worlds.design import Design
from tests.worlds.diagnosis.library import COARSE, SEARCHED, Search, candidates, fine
from tests.worlds.machine import Array, Indices
from tests.worlds.shop import Unknown, every_unknown
from tests.worlds.truth import span_of

DEGREE = 12
DETECTION, ISOLATION = 27.0, 21.0
RANK = 1e-5  # of the largest singular value: to show one sigma along a direction below it takes a curve of about 1 mm
DRIFT = 1e-2  # mm, of an instrument over a run, one standard deviation: five times the largest of the shops
NOT_SEEN = 1e-6  # share of a signature that must be left of it: less is within rounding of the flat unknowns
CONFOUNDED = 0.95
IMITATORS = 4  # candidates that together may imitate an effect of no kind
SPREADS = {  # what is usual of an instrument where the shop has no such unknown: mm, mm, rad, mm, mm, 1, 1
    "zero": 2e-3,
    "drift": 1e-3,
    "slope": 2e-5,
    "centre": 1e-2,
    "length": 2e-3,
    "scale": 1e-6,
    "cosine": 3e-7,
}


@dataclass(frozen=True, eq=False)
class OfRun:
    """rows: those that are no outliers; low: Cholesky factor of their noise; own: basis of the run's own unknowns."""

    rows: Indices
    low: Array
    own: Array


@dataclass(frozen=True, eq=False)
class Ground:
    """What is flat in a design. q: orthonormal, whitened, of all that is flat beside unknowns of single runs; of
    instruments alone: its own; pseudo: rows of q below the readings, which hold shared unknowns at their spread.
    """

    design: Design
    runs: tuple[OfRun, ...]
    instruments: Array
    q: Array
    pseudo: int = 0

    def white(self, values: Array) -> Array:
        """(n,) or (n, k), mm -> of unit noise, outliers and unknowns of single runs taken away."""
        values = values[:, None] if values.ndim == 1 else values
        found = []
        for one in self.runs:
            part = solve_triangular(one.low, values[one.rows], lower=True, check_finite=False)
            found.append(part - one.own @ (one.own.T @ part))
        return np.vstack([*found, np.zeros((self.pseudo, values.shape[1]))])

    def noisy(self, values: Array) -> Array:
        """(n,), mm -> of unit noise, and nothing taken away."""
        parts = [solve_triangular(one.low, values[one.rows], lower=True, check_finite=False) for one in self.runs]
        return np.concatenate(parts)

    def rest(self, white: Array) -> Array:
        """What is left beside all that is flat."""
        return np.asarray(white - self.q @ (self.q.T @ white), float)

    def left_of(self, signature: Array) -> Array:
        """(n,), mm -> what readings can show of it, of unit noise; zeros where that is within rounding."""
        left, whole = self.rest(self.white(signature))[:, 0], self.noisy(signature)
        seen = float(left @ left) > NOT_SEEN * float(whole @ whole)
        return left if seen else np.zeros_like(left)

    @cached_property
    def rivals(self) -> "Rivals":
        """All candidates of the library; made once for a design."""
        return rivals_of(self)


def flat_ground(design: Design, left_out: Sequence[str] = ()) -> Ground:
    """Every unknown of an instrument is flat but its drift; left_out: location errors that the spec does not have."""
    unknowns = (*_unknowns(design), *(u for u in design.shop.unknowns if u.kind == "warm_bar"))
    own, shared = _split(design, [u for u in unknowns if u.kind != "drift"])
    drifts = [replace(u, spread=DRIFT) for u in unknowns if u.kind == "drift"]
    runs = _runs(design, own, [*drifts, *(u for u in design.shop.unknowns if u.kind == "creep")])
    blank = Ground(design, runs, np.zeros((0, 0)), np.zeros((0, 0)))
    instruments = blank.white(_columns(design, shared))
    return _ground(blank, instruments, blank.white(_machine_columns(design, left_out)))


def stated_ground(design: Design) -> Ground:
    """Unknowns of instruments have the spread of the shop, or what is usual, so that one that is far off shows."""
    there = {(u.kind, u.scope): u.spread for u in design.shop.unknowns}
    unknowns = _unknowns(design)
    spread = {id(u): there.get((u.kind, u.scope), SPREADS[u.kind.split("_")[0]]) for u in unknowns}
    own, shared = _split(design, unknowns)
    normal = [Unknown(u.kind, u.scope, spread[id(u)], u.rows, u.column) for of in own.values() for u in of]
    creep = [u for u in design.shop.unknowns if u.kind == "creep"]
    runs = _runs(design, {}, [*normal, *creep])
    blank = Ground(design, runs, np.zeros((0, 0)), np.zeros((0, 0)))
    instruments = blank.white(_columns(design, shared))
    weights = np.diag([1.0 / spread[id(u)] for u in shared])
    curves = blank.white(_machine_columns(design, ()))
    pseudo = len(shared)
    blank = Ground(design, runs, blank.instruments, blank.q, pseudo)
    return _ground(blank, np.vstack([instruments, weights]), np.vstack([curves, np.zeros((pseudo, curves.shape[1]))]))


def _unknowns(design: Design) -> list[Unknown]:
    """Of a bar also the zero of each run: no shop resets it between two runs, and nobody who sees readings knows."""
    plan, found = design.plan, list(every_unknown(design.machine, design.plan))
    for index, run in enumerate(plan.runs):
        if run.instrument == "ballbar":
            rows = plan.rows(index)
            found.append(Unknown("zero", run.id, SPREADS["zero"], rows, np.ones(len(rows))))
    return found


def _ground(blank: Ground, instruments: Array, curves: Array) -> Ground:
    first = orthonormal(instruments)
    second = orthonormal(curves - first @ (first.T @ curves), curves)
    return Ground(blank.design, blank.runs, first, np.hstack([first, second]), blank.pseudo)


def orthonormal(columns: Array, before: Array | None = None) -> Array:
    """A basis of the columns, (n, r); before: the columns by whose size what is left of them is none."""
    before = columns if before is None else before
    size = np.linalg.norm(before, axis=0)
    kept = np.linalg.norm(columns, axis=0) > RANK * np.maximum(size, 1e-300)
    if not kept.any():
        return np.zeros((len(columns), 0))
    q, r = qr(columns[:, kept] / size[kept], mode="economic", check_finite=False)
    u, s, _ = np.linalg.svd(r)
    return np.asarray(q @ u[:, : len(s)][:, s > RANK * s[0]], float)


def _split(design: Design, unknowns: Iterable[Unknown]) -> tuple[dict[int, list[Unknown]], list[Unknown]]:
    own: dict[int, list[Unknown]] = {}
    shared = []
    for unknown in unknowns:
        runs = np.unique(design.plan.run[unknown.rows])
        if len(runs) == 1:
            own.setdefault(int(runs[0]), []).append(unknown)
        else:
            shared.append(unknown)
    return own, shared


def _runs(design: Design, own: Mapping[int, Sequence[Unknown]], normal: Sequence[Unknown]) -> tuple[OfRun, ...]:
    """own: flat; normal: of single runs, with their spread in the noise."""
    plan, found = design.plan, []
    with_spread, _ = _split(design, normal)
    for index in range(len(plan.runs)):
        rows = plan.rows(index)
        good = ~np.isin(rows, design.shop.outliers)
        covariance = design.shop.covariance(plan, index)
        for unknown in with_spread.get(index, []):
            covariance = covariance + unknown.spread**2 * np.outer(unknown.column, unknown.column)
        if not good.any():
            continue
        low = cholesky(covariance[np.ix_(good, good)], lower=True)
        columns = np.array([unknown.column[good] for unknown in own.get(index, [])]).reshape(-1, int(good.sum())).T
        found.append(OfRun(rows[good], low, orthonormal(solve_triangular(low, columns, lower=True))))
    return tuple(found)


def _columns(design: Design, unknowns: Sequence[Unknown]) -> Array:
    found = np.zeros((design.plan.count, len(unknowns)))
    for k, unknown in enumerate(unknowns):
        found[unknown.rows, k] = unknown.column
    return found


def _machine_columns(design: Design, left_out: Sequence[str]) -> Array:
    """Legendre polynomials of every component error, and location errors."""
    jac, blocks = design.jacobian, []
    for name in design.machine.components:
        span = span_of(design.machine, name[2])

        def basis(at: Array, scaled=span.scaled) -> Array:  # type: ignore[no-untyped-def]
            return np.asarray(legendre.legvander(scaled(at), DEGREE)[:, 1:], float)

        blocks.append(jac.columns(name, basis))
    blocks += [jac.located[name][:, None] for name in design.machine.locations if name not in left_out]
    return np.hstack(blocks)


@dataclass(frozen=True, eq=False)
class Rivals:
    """white: (n, k), columns of all candidates; gram: (k, k) blocks of what is left of them; blocks: name and columns
    of each candidate at each point of its grid.
    """

    white: Array
    held: Array
    blocks: tuple[tuple[Name, slice], ...]

    def nearest(self, left: Array, apart: Name | None = None, taken: Array | None = None) -> tuple[float, Name, Array]:
        """Largest share of a signature (n,), as `left_of` leaves it, that one candidate other than `apart` explains,
        that candidate, and the unit vector (n,) that does, apart from a factor; taken: (n, j), orthonormal, what
        other candidates explain already.
        """
        taken = np.zeros((len(left), 0)) if taken is None else taken
        along, beside = left @ self.white, taken.T @ self.white
        best: tuple[float, Name, slice, Array] = (0.0, Name(""), slice(0, 0), np.zeros(0))
        for name, block in self.blocks:
            if name == apart:
                continue
            columns, held = self.white[:, block], self.held[:, block]
            whole = np.einsum("ij,ij->j", columns, columns)
            gram = columns.T @ columns - held.T @ held - beside[:, block].T @ beside[:, block]
            if np.trace(gram) < NOT_SEEN * float(np.sum(whole)):
                continue
            weights = np.linalg.pinv(gram, rcond=1e-9, hermitian=True) @ along[block]
            share = float(along[block] @ weights)
            if share > best[0]:
                best = (share, name, block, weights)
        total = float(left @ left)
        unit = self.white[:, best[2]] @ best[3] if best[3].size else np.zeros_like(left)
        return (min(best[0] / total, 1.0) if total else 0.0), best[1], unit


def rivals_of(ground: Ground, search: Search = COARSE) -> Rivals:
    whites, blocks, count = [], [], 0
    for one in candidates(ground.design, search):
        white = ground.white(one.columns)
        if not np.any(white):
            continue
        white = white / np.linalg.norm(white, axis=0).max()
        whites.append(white)
        blocks.append((one.name, slice(count, count + white.shape[1])))
        count += white.shape[1]
    white = np.hstack(whites) if whites else np.zeros((len(ground.q), 0))
    return Rivals(white, ground.q.T @ white, tuple(blocks))


@dataclass(frozen=True)
class Limit:
    """strength: lambda of a signature of unit size; own: share of it that the library's own form at its best explains;
    alike: the largest share that another candidate, the rival, explains; lasting: the share without the two neighbours
    of each run that show most of it, which are taken for outliers.
    """

    strength: float
    own: float
    alike: float
    rival: Name
    lasting: float = 1.0

    @property
    def r2(self) -> float:
        """Of the rival with what the own form explains."""
        return min(self.alike / self.own, 1.0)

    @property
    def detection(self) -> float:
        """Size in units of that of the signature; infinite where no reading shows it."""
        return float(np.sqrt(DETECTION / (self.strength * self.own))) if self.strength > 0 else np.inf

    @property
    def isolation(self) -> float:
        left = self.strength * self.own * (1.0 - self.r2)
        return float(np.sqrt(ISOLATION / left)) if left > 1e-9 * self.strength and left > 0 else np.inf


NO_LIMIT = Limit(0.0, 1.0, 0.0, Name(""))


def limit_of(ground: Ground, signature: Array, name: Name, pitch: float = 0.0) -> Limit:
    """Of an effect of the library; signature: (n,), mm; name, pitch: its own."""
    left = ground.left_of(signature)
    strength = float(left @ left)
    if strength == 0.0:
        return NO_LIMIT
    forms = rivals_of(ground, fine(name, pitch))
    own = forms.nearest(left)[0] if forms.blocks else 1.0
    alike, rival, _ = ground.rivals.nearest(left, name)
    for other in dict.fromkeys(one for one, _ in ground.rivals.blocks if one.kind in SEARCHED and one != name):
        if other.component == name.component:  # a rival, too, is at its best: a coarse grid would call it told apart
            alike, rival = max(
                (alike, rival), rivals_of(ground, fine(other, 0.0)).nearest(left)[:2], key=lambda one: one[0]
            )
    if pitch:
        of_pitch = rivals_of(ground, Search(pitches=(pitch,)))
        alike, rival = max((alike, rival), of_pitch.nearest(left, name)[:2], key=lambda one: one[0])
    return Limit(strength, max(own, 1e-12), alike, rival, _lasting(ground, left))


def limit_of_outsider(ground: Ground, signature: Array) -> Limit:
    """Of an effect of no kind: candidates may imitate it together, taken one after another as a search takes them."""
    left = ground.left_of(signature)
    strength = float(left @ left)
    if strength == 0.0:
        return NO_LIMIT
    taken, rest, first = np.zeros((len(left), 0)), left, Name("")
    for number in range(IMITATORS):
        share, name, unit = ground.rivals.nearest(rest, None, taken)
        if share == 0.0:
            break
        first = name if number == 0 else first
        unit = ground.rest(unit[:, None])[:, 0]
        unit = unit - taken @ (taken.T @ unit)
        taken = np.column_stack([taken, unit / np.linalg.norm(unit)])
        rest = left - taken @ (taken.T @ left)
    alike = max(0.0, 1.0 - float(rest @ rest) / strength)
    return Limit(strength, 1.0, alike, first, _lasting(ground, left))


def _lasting(ground: Ground, left: Array) -> float:
    """Share of the squares of left (n,) that is not of the two neighbours of each run with the largest ones."""
    ends = np.cumsum([len(one.rows) for one in ground.runs])
    parts = np.split(left**2, ends)[: len(ends)]
    return 1.0 - sum(float(np.convolve(part, [1.0, 1.0]).max()) for part in parts) / float(left @ left)
