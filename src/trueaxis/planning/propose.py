"""Runs that would add most to a plan, or make the first one: candidates, what they tell, and the choice among them.

Chosen are those that lower the mean variance of what is asked for most, per minute: I- and c-optimal, greedy.

With S a root of the covariance (units of the prior) and J the rows of a run, its readings lower the variance of T by
|| (1 + A A')^-1/2 A (T S)' ||^2, A = J S: small matrices, whatever the number of unknowns. A chosen run turns S into
S (1 + A'A)^-1/2, which changes the A of all others by a product of its rank.

Greedy choice is near the best: variances that fall by what runs tell have less to fall with every run (the classic
bound of 1 - 1/e holds for the determinant, and approximately here; tests compare with all pairs).
"""

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from trueaxis.estimation.effects.planned import planned_effects
from trueaxis.estimation.expected import expected_posterior, informing_rows
from trueaxis.estimation.gauge import levelling
from trueaxis.estimation.judgement import NINE_TENTHS, SAMPLES
from trueaxis.estimation.layout import Layout, layout_of
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.tool_point import POINTS, Datum, moved_by, volume
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import Run, Vector
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel
from trueaxis.planning.candidates import Candidate, candidates
from trueaxis.planning.kit import Kit
from trueaxis.planning.runs import SET_UP_MINUTES, PlannedRuns, run_minutes, set_up_of

VOLUME = "volume"  # what is to be known best: the tool point over the volume, or the error that is named instead
LEAST_FREEDOM = 20  # degrees of freedom of repeats: the noise of an instrument is then known to a sixth
LEAST_FALL = 0.01  # of u, by a run that is still worth it: less is within what sizes of errors are off by
KEPT = 1e-6  # of the variance of what is asked for: directions of it that are left out of the sums
NOTHING = 1e-12  # of a variance: rounding


@dataclass(frozen=True, slots=True, kw_only=True)
class Wish:
    """What proposed runs are for. wanted: VOLUME, a component or a location error; tools: points in the tool frame
    whose place against the datum counts, mm; noise: standard deviation of readings by instrument, mm; effects: values
    at which effects of the spec are linearised.
    """

    wanted: str
    datum: Datum
    tools: tuple[Vector, ...]
    noise: dict[str, float]
    effects: tuple[EffectValues, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Proposed:
    """A run taken from `count` candidates: minutes it takes, u of what is wanted after it, mm or rad."""

    candidate: Candidate
    minutes: float
    u: float


@dataclass(frozen=True, slots=True, eq=False)
class Proposal:
    """Runs in the order of their choice, among `count` candidates; before: u without them, mm or rad."""

    runs: tuple[Proposed, ...]
    count: int
    before: float


@dataclass(frozen=True, slots=True)
class Chosen:
    """An offer by its index; minutes: that it takes more; u: after it, root of the mean of what is asked for."""

    index: int
    minutes: float
    u: float


def propose(
    model: MachineModel,
    given: ErrorValues,
    there: PlannedRuns,
    noise: dict[int, float],
    kit: Kit,
    wish: Wish,
    goes_on: Callable[[Sequence[Chosen]], float],
    least_fall: float = 0.0,
) -> Proposal:
    """Choose runs to be added to those that are there. Where there are none, repeats of the noise take time, too.

    noise: of the runs that are there, by index, mm; goes_on, least_fall: see `choose`.
    """
    first = len(there.runs)
    offered = candidates(model.with_values(given), kit)
    everything = there.with_added(offered).observed
    effects = planned_effects(model, everything, given, wish.effects).unknowns
    layout = layout_of(model.with_values(given), everything, given, effects)
    before, _ = expected_posterior(layout, everything.of(np.flatnonzero(everything.run < first)), noise)
    scale = before.scale * layout.sizes
    rows = [one.rows for one in measured_runs(everything) if one.rows.index >= first]
    offers = [
        _offer(informing_rows(layout, one, wish.noise[one.run.instrument], scale), candidate, repeats=not first)
        for one, candidate in zip(rows, offered, strict=True)
    ]
    spread = before.spread / before.scale[:, np.newaxis]
    target = _target(layout, wish) * scale
    chosen = choose(spread, target, offers, goes_on, [set_up_of(*path) for path in there.to_take], least_fall)
    runs = tuple(Proposed(offered[one.index], one.minutes, one.u) for one in chosen)
    return Proposal(runs, len(offered), float(np.linalg.norm(target @ spread)))


def for_noise(proposal: Proposal) -> Proposal:
    """The same with the first run of every instrument taken more than once, so that repeats tell the noise."""
    runs, known = [], set[str]()
    for one in proposal.runs:
        instrument = one.candidate.run.instrument
        runs.append(one if instrument in known else replace(one, candidate=_repeated(one.candidate)))
        known.add(instrument)
    return replace(proposal, runs=tuple(runs))


def _repeated(one: Candidate) -> Candidate:
    again = one.positions[:, 1:]  # from where the run ends, which is where it began
    return replace(one, positions=np.ascontiguousarray(np.hstack([one.positions, *([again] * _passes(one))])))


def _passes(one: Candidate) -> int:
    """How often a run is repeated: each time as many readings are taken again, but for where it turns."""
    return -(-LEAST_FREEDOM // max(int(one.positions.shape[1]) - 2, 1))


def named(proposal: Proposal, taken: Sequence[Run], prefix: str) -> Proposal:
    """With ids that no run has yet."""
    ids, number, runs = {run.id for run in taken}, 0, []
    for one in proposal.runs:
        number += 1
        while f"{prefix}{number}" in ids:
            number += 1
        candidate = replace(one.candidate, run=replace(one.candidate.run, id=f"{prefix}{number}"))
        runs.append(replace(one, candidate=candidate))
    return replace(proposal, runs=tuple(runs))


def by_set_up(found: Sequence[Candidate]) -> tuple[Candidate, ...]:
    """As they are to be taken: those of one set-up together, where the first of them was."""
    keys = [set_up_of(one.run, one.positions) for one in found]
    first = {key: keys.index(key) for key in keys}
    return tuple(one for _, one in sorted(zip(keys, found, strict=True), key=lambda pair: first[pair[0]]))


@dataclass(frozen=True, slots=True, eq=False)
class Offer:
    """rows: (m, n), as `informing_rows` gives them; minutes: of the run itself; shared: what it needs that others need,
    too, and that takes its minutes once: a set-up.
    """

    rows: FloatArray
    minutes: float
    shared: tuple[tuple[Hashable, float], ...]


def _offer(informing: FloatArray, one: Candidate, *, repeats: bool) -> Offer:
    run, readings = one.run, one.positions.shape[1]
    shared: list[tuple[Hashable, float]] = [(set_up_of(run, one.positions), SET_UP_MINUTES[run.instrument])]
    once = run_minutes(run, readings)
    if repeats:
        more = run_minutes(run, readings + _passes(one) * (readings - 1)) - once
        shared.append((run.instrument, more))
    return Offer(informing, once, tuple(shared))


def _target(layout: Layout, wish: Wish) -> FloatArray:
    """(q, n): rows whose variances sum up to the mean variance of what is wanted, by unknowns in mm and rad."""
    found = np.zeros((1, layout.count))
    if wish.wanted == VOLUME:
        moved = moved_by(layout, volume(layout.model), wish.tools, wish.datum) / np.sqrt(POINTS)
        return np.hstack([moved, np.zeros((moved.shape[0], layout.count - layout.of_machine))])
    if wish.wanted in layout.locations:
        found[0, int(layout.offsets[-1]) + layout.locations.index(wish.wanted)] = 1.0
    else:
        place = layout.components.index(wish.wanted)
        basis, first = layout.bases[place], int(layout.offsets[place])
        at = basis.evenly(SAMPLES)
        found = np.zeros((at.size, layout.count))
        found[:, first : first + basis.count] = basis(at).T / np.sqrt(at.size)
    return np.asarray(found @ levelling(layout))


def choose(
    spread: FloatArray,
    target: FloatArray,
    offers: Sequence[Offer],
    goes_on: Callable[[Sequence[Chosen]], float],
    there: Sequence[Hashable] = (),
    least_fall: float = 0.0,
) -> list[Chosen]:
    """One offer after the other, each once.

    spread: (n, r), a root of the covariance before, in units of the prior; target: (q, n), whose mean square is to
    fall: sum of squares of target @ spread; goes_on: minutes that are left for another, after those chosen; there:
    what is set up already; least_fall: share of u that a run lowers at least, of the part of u that offers tell at
    all: what none of them tells is no reason to stop.
    """
    if not offers:
        return []
    starts = np.concatenate([[0], np.cumsum([one.rows.shape[0] for one in offers])]).tolist()
    parts = [slice(first, last) for first, last in pairwise(starts)]
    rows = np.vstack([one.rows for one in offers]) @ spread
    wanted = _few(target @ spread)
    told = _told(rows)
    left = np.ones(len(offers), dtype=bool)
    done, chosen = set(there), list[Chosen]()
    while left.any() and (allowed := goes_on(chosen)) > 0.0:
        gains = _gains(rows, wanted, parts)
        taking = np.array([one.minutes + sum(m for key, m in one.shared if key not in done) for one in offers])
        least = max(
            (1.0 - (1.0 - least_fall) ** 2) * float(np.sum((wanted @ told) ** 2)), NOTHING * float(np.sum(wanted**2))
        )
        open_ = left & (taking <= allowed) & (gains > least)
        if not open_.any():
            break
        best = int(np.argmax(np.where(open_, gains / taking, -np.inf)))
        done.update(key for key, _ in offers[best].shared)
        left[best] = False
        rows, wanted = _updated(rows, wanted, parts[best])
        chosen.append(Chosen(best, float(taking[best]), float(np.sqrt(np.sum(wanted**2)))))
    return chosen


def _few(wanted: FloatArray) -> FloatArray:
    """(t, r): as few rows with the same sums of squares, but for KEPT of the whole."""
    _, size, right = np.linalg.svd(wanted, full_matrices=False)
    tail = np.cumsum(size[::-1] ** 2)[::-1]
    kept = tail > KEPT * float(tail[0]) if size.size else np.zeros(0, dtype=bool)
    return np.asarray(size[kept, np.newaxis] * right[kept])


def _told(rows: FloatArray) -> FloatArray:
    """(r, k): orthonormal directions of which all rows together tell more than the prior, by the rule of judgement."""
    information, directions = np.linalg.eigh(rows.T @ rows)
    return np.asarray(directions[:, 1.0 + information > NINE_TENTHS**-2])


def _gains(rows: FloatArray, wanted: FloatArray, parts: Sequence[slice]) -> FloatArray:
    """(n_offers,): by how much each lowers the sum of variances."""
    seen = rows @ wanted.T
    found = np.zeros(len(parts))
    for index, part in enumerate(parts):
        own = rows[part]
        if own.size:
            variance, turned = np.linalg.eigh(own @ own.T)
            squares = np.sum((turned.T @ seen[part]) ** 2, axis=1)
            found[index] = float(np.sum(squares / (1.0 + np.maximum(variance, 0.0))))
    return found


def _updated(rows: FloatArray, wanted: FloatArray, part: slice) -> tuple[FloatArray, FloatArray]:
    """Both after the rows of an offer are known: times (1 + A'A)^-1/2."""
    _, size, right = np.linalg.svd(rows[part], full_matrices=False)
    change = (1.0 - 1.0 / np.hypot(1.0, size))[:, np.newaxis] * right
    return rows - (rows @ right.T) @ change, wanted - (wanted @ right.T) @ change
