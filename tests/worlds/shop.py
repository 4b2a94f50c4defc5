"""The shop: the noise of the instruments, and what is unknown about each of their set-ups."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from tests.worlds.kinematics import coordinates
from tests.worlds.lines import ideal_displacement
from tests.worlds.machine import Array, Indices, Machine
from tests.worlds.plan import Plan, Run

Source = np.random.Generator

UM, PPM = 1e-3, 1e-6
LIKELY = 0.55  # of each ingredient of the shop
COARSE = 5.0  # steps of a display over the white noise, from where on repeats show the same digits


@dataclass(frozen=True, eq=False)
class Unknown:
    """An unknown of an instrument, normal about 0: its kind, whom it is of, its spread, and the column of its rows.

    The readings of `rows` have column * value added. spread: in the unit of the value (mm, rad, 1).
    """

    kind: str
    scope: str
    spread: float
    rows: Indices
    column: Array


@dataclass(frozen=True, eq=False)
class Shop:
    """white: (n,), mm; per run (runs,): slow_mm and slow_s of an Ornstein-Uhlenbeck process, walk_mm at the end of the
    run of a random walk that grows with the order of reading; resolution: (n,), mm, 0 for none; outliers: rows that are
    spoilt, outlier_mm: by about how much.
    """

    white: Array
    slow_mm: Array
    slow_s: Array
    walk_mm: Array
    resolution: Array
    unknowns: tuple[Unknown, ...]
    outliers: Indices
    outlier_mm: float

    def covariance(self, plan: Plan, index: int) -> Array:
        """Of the noise of one run, (k, k), mm^2: white, slow, walk and the steps of the display; unknowns apart."""
        rows = plan.rows(index)
        time, order = plan.time[rows], np.arange(1, len(rows) + 1)
        found = self.slow_mm[index] ** 2 * np.exp(-np.abs(time[:, None] - time) / self.slow_s[index])
        found += self.walk_mm[index] ** 2 * np.minimum(order[:, None], order) / len(rows)
        return np.asarray(found + np.diag(self.white[rows] ** 2 + self.resolution[rows] ** 2 / 12), float)


def draw_shop(source: Source, machine: Machine, plan: Plan) -> Shop:
    count, runs = plan.count, len(plan.runs)
    white, resolution = np.zeros(count), np.zeros(count)
    slow_mm, slow_s, walk_mm = np.zeros(runs), np.ones(runs), np.zeros(runs)
    uneven, slow, walk, steps = (source.random() < LIKELY for _ in range(4))
    for instrument in ("laser", "ballbar", "probe"):
        level = UM * np.exp(source.uniform(np.log(0.08), np.log(1.0)))
        share, rows_of_slow = source.uniform(0.4, 1.2), source.uniform(3.0, 30.0)
        step = _display_step(level * float(source.choice([0.5, 2.0, COARSE], p=[0.3, 0.3, 0.4]))) if steps else 0.0
        for index, run in enumerate(plan.runs):
            rows = plan.rows(index)
            if run.instrument != instrument:
                continue
            white[rows] = level * (np.exp(0.4 * source.normal()) if uneven else 1.0)
            resolution[rows] = step
            interval = float(np.median(np.diff(plan.time[rows]))) if len(rows) > 1 else 1.0
            slow_mm[index], slow_s[index] = (share * level if slow else 0.0), max(rows_of_slow * interval, 1e-3)
            walk_mm[index] = level * source.uniform(0.5, 2.0) if walk else 0.0
    if uneven:  # and larger far away
        white = white * (1.0 + source.uniform(0.0, 1.0) * plan.seq / (1 + plan.seq.max()))
    unknowns = tuple(_unknowns(source, machine, plan))
    outliers = _outliers(source, plan)
    return Shop(white, slow_mm, slow_s, walk_mm, resolution, unknowns, outliers, 12.0 * float(np.median(white)))


def _display_step(about: float) -> float:
    """The next lower 1, 2 or 5 of a power of ten, mm."""
    power = 10.0 ** np.floor(np.log10(about))
    return float(max(digit * power for digit in (1.0, 2.0, 5.0) if digit * power <= about))


def draw_noise(source: Source, plan: Plan, shop: Shop) -> Array:
    """(n,), mm: white, slow and walking parts; neither outliers nor steps of the display."""
    found = shop.white * source.standard_normal(plan.count)
    for index in range(len(plan.runs)):
        rows = plan.rows(index)
        drawn = source.standard_normal((2, len(rows)))
        kept = np.exp(-np.diff(plan.time[rows], prepend=plan.time[rows[0]]) / shop.slow_s[index])
        kept[0] = 0.0
        at = 0.0
        chain = np.empty(len(rows))
        for k, (keep, step) in enumerate(zip(kept.tolist(), drawn[0].tolist(), strict=True)):
            at = keep * at + (1.0 - keep * keep) ** 0.5 * step
            chain[k] = at
        found[rows] += shop.slow_mm[index] * chain
        found[rows] += shop.walk_mm[index] * np.cumsum(drawn[1]) / np.sqrt(len(rows))
    return found


def draw_values(source: Source, shop: Shop) -> Array:
    """A value for each unknown; that of a cosine is never positive: -(angle^2)/2 of two angles."""
    found = np.empty(len(shop.unknowns))
    for k, unknown in enumerate(shop.unknowns):
        one, two = source.standard_normal(2)
        # spread = sqrt(2) s^2 is the root mean square of -(a^2 + b^2)/2 with a, b of standard deviation s
        found[k] = (
            -unknown.spread * (one**2 + two**2) / (2 * np.sqrt(2)) if unknown.kind == "cosine" else unknown.spread * one
        )
    return found


def draw_spoilt(source: Source, shop: Shop) -> Array:
    """What outliers have added, (k,), mm; two neighbours the same way."""
    size = (
        shop.outlier_mm * source.uniform(0.7, 3.0, len(shop.outliers)) * source.choice([-1.0, 1.0], len(shop.outliers))
    )
    for k in range(1, len(size)):
        if shop.outliers[k] == shop.outliers[k - 1] + 1:
            size[k] = size[k - 1] * source.uniform(0.8, 1.2)
    return np.asarray(size, float)


def _outliers(source: Source, plan: Plan) -> Indices:
    """Rows alone, or two neighbours of one run."""
    if source.random() > LIKELY:
        return np.zeros(0, np.int64)
    number = max(2, int(plan.count * source.uniform(0.0005, 0.003)))
    rows = source.choice(plan.count, number, replace=False)
    pairs = [row + 1 for row in rows if source.random() < 0.3 and row + 1 < plan.count]
    same = [row for row in pairs if plan.run[row] == plan.run[row - 1]]
    return np.unique(np.concatenate([rows, np.array(same, np.int64)]))


def every_unknown(machine: Machine, plan: Plan) -> tuple[Unknown, ...]:
    """What may be unknown about instruments whether or not a shop has it: to be taken as flat. Without creep and bars
    that warm up, whose course in time is the shop's own.
    """
    source = np.random.default_rng(0)  # draws spreads, which do not count
    makers = (_zeros, _drift, _slopes, _centres, _lengths, _scale, _cosines)
    return tuple(unknown for make in makers for unknown in make(source, machine, plan))


Maker = Callable[[Source, Machine, Plan], Iterator[Unknown]]


def _unknowns(source: Source, machine: Machine, plan: Plan) -> Iterator[Unknown]:
    for make in (_zeros, _slopes, _creep, _drift, _centres, _lengths, _warm_bar, _scale, _cosines):
        wanted = source.random() < LIKELY
        own = np.random.default_rng(source.integers(2**63))
        if wanted:
            yield from make(own, machine, plan)


def _by(plan: Plan, key: Callable[[Run], str | None]) -> Iterator[tuple[str, Indices]]:
    """Scopes in the order of the runs, and their rows."""
    keys = [key(run) for run in plan.runs]
    for scope in dict.fromkeys(keys):
        if scope is not None:
            chosen = [k for k, own in enumerate(keys) if own == scope]
            yield scope, np.flatnonzero(np.isin(plan.run, chosen))


def _line(run: Run) -> str | None:
    return run.id if run.instrument != "ballbar" else None


def _zeros(source: Source, machine: Machine, plan: Plan) -> Iterator[Unknown]:
    spread = UM * source.uniform(0.5, 5.0)
    for scope, rows in _by(plan, _line):
        yield Unknown("zero", scope, spread, rows, np.ones(len(rows)))


def _slopes(source: Source, machine: Machine, plan: Plan) -> Iterator[Unknown]:
    """A reflector of a straightness line that does not lie along the motion: aligned with care, or by eye."""
    spread = float(np.exp(source.uniform(*np.log([5e-6, 5e-4]))))
    for index, run in enumerate(plan.runs):
        if run.across:
            rows = plan.rows(index)
            moving = [axis for axis, values in plan.at(rows).items() if np.ptp(values) > 0]
            home = run.home or {}
            way = plan.positions[moving[0]][rows] - home[moving[0]] if moving else np.zeros(len(rows))
            yield Unknown("slope", run.id, spread, rows, way)


def _creep(source: Source, machine: Machine, plan: Plan) -> Iterator[Unknown]:
    spread, share = UM * source.uniform(0.3, 2.0), source.uniform(0.1, 0.5)
    for scope, rows in _by(plan, _line):
        passed = plan.time[rows] - plan.time[rows[0]]
        lasts = max(float(passed[-1]), 1.0)
        yield Unknown("creep", scope, spread, rows, 1.0 - np.exp(-passed / (share * lasts)))


def _drift(source: Source, machine: Machine, plan: Plan) -> Iterator[Unknown]:
    spread = UM * source.uniform(0.2, 2.0)
    for scope, rows in _by(plan, lambda run: run.id):
        passed = plan.time[rows] - plan.time[rows[0]]
        yield Unknown("drift", scope, spread, rows, passed / max(float(passed[-1]), 1.0))


def _centres(source: Source, machine: Machine, plan: Plan) -> Iterator[Unknown]:
    """The ball on the workpiece is elsewhere: to first order minus the direction of the bar."""
    spread = UM * source.uniform(2.0, 20.0)
    for scope, rows in _by(plan, lambda run: run.mount if run.instrument == "ballbar" else None):
        bars = np.concatenate(
            [bar_directions(machine, plan, index) for index in dict.fromkeys(plan.run[rows].tolist())]
        )
        for k, letter in enumerate("XYZ"):
            yield Unknown(f"centre_{letter}", scope, spread, rows, -bars[:, k])


def _bar_of_session(run: Run) -> str | None:
    return f"bar@{run.session}" if run.instrument == "ballbar" else None


def _lengths(source: Source, machine: Machine, plan: Plan) -> Iterator[Unknown]:
    """A bar that is longer than said reads less: its zero is off."""
    spread = UM * source.uniform(0.5, 5.0)
    for scope, rows in _by(plan, _bar_of_session):
        yield Unknown("length", scope, spread, rows, np.ones(len(rows)))


def _warm_bar(source: Source, machine: Machine, plan: Plan) -> Iterator[Unknown]:
    spread, tau = UM * source.uniform(0.5, 3.0), source.uniform(600.0, 3600.0)
    for scope, rows in _by(plan, _bar_of_session):
        yield Unknown("warm_bar", scope, spread, rows, 1.0 - np.exp(-(plan.time[rows] - plan.time[rows[0]]) / tau))


def _scale(source: Source, machine: Machine, plan: Plan) -> Iterator[Unknown]:
    spread = PPM * source.uniform(0.2, 2.0)
    for scope, rows in _by(plan, lambda run: f"laser@{run.session}" if run.instrument == "laser" else None):
        yield Unknown("scale", scope, spread, rows, _along(machine, plan, rows))


def _cosines(source: Source, machine: Machine, plan: Plan) -> Iterator[Unknown]:
    spread = np.sqrt(2) * source.uniform(2e-4, 1e-3) ** 2
    for scope, rows in _by(plan, lambda run: run.mount if run.instrument == "laser" and not run.across else None):
        yield Unknown("cosine", scope, float(spread), rows, _along(machine, plan, rows))


def _along(machine: Machine, plan: Plan, rows: Indices) -> Array:
    """Ideal displacement sensed since home, (k,), mm."""
    found = np.empty(len(rows))
    for index in dict.fromkeys(plan.run[rows].tolist()):
        own, run = plan.run[rows] == index, plan.runs[index]
        found[own] = ideal_displacement(machine, run, plan.at(rows[own])) @ np.array(run.direction)
    return found


def bar_directions(machine: Machine, plan: Plan, index: int) -> Array:
    """Unit vectors from the ball on the workpiece to that on the tool, ideal machine, (k, 3), workpiece frame."""
    run, at = plan.runs[index], plan.at(plan.rows(index))
    target, reference = np.array(run.target[1]), np.array(run.reference[1])
    bar = coordinates(machine, run.target[0], run.reference[0], at, target, {}, {}) - reference
    return np.asarray(bar / np.linalg.norm(bar, axis=1, keepdims=True), float)
