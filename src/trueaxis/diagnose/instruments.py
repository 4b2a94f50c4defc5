"""Instruments that are off by more than instruments are: zeros, slopes of straightness lines, places of balls.

Every run has its own, and they are free: no cause in the machine can be mistaken for one of them. But one set-up whose
own is many times what set-ups differ by, or than the others of its class have, is a cause, of the instrument.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.special import stdtr

from trueaxis.diagnose.null import Null, factored
from trueaxis.diagnose.result import FloatArray
from trueaxis.diagnose.whiten import RANK
from trueaxis.effects.kind import Effect
from trueaxis.estimation.instruments import CLASSES

FALSE_ALARMS = 1e-4  # share of data with instruments as usual in which one or other is taken for a cause
KINDS = {  # class of a run's own unknown -> the kind of effect that it is when it is off
    "laser zero": "reading_zero",
    "probe zero": "reading_zero",
    "straightness zero": "reading_zero",
    "ballbar zero": "reading_zero",
    "straightness slope": "reading_slope",
}


OF_INSTRUMENTS = frozenset(KINDS.values())


@dataclass(frozen=True, slots=True, eq=False)
class Off:
    """An instrument that is off in the runs of its effect: value and u, mm or 1; signal: (n,), mm."""

    effect: Effect
    value: float
    u: float
    p_value: float
    signal: FloatArray


@dataclass(frozen=True, slots=True)
class _Setup:
    """Runs of one set-up and session, by their places among those of the base, what they have on average, and its u."""

    places: tuple[int, ...]
    value: float
    u: float


def instruments_off(null: Null, signal: FloatArray) -> tuple[Off, ...]:
    """Those that are, most evident first. signal: (n,), mm, what causes in the machine do to the readings."""
    own, u = _own(null, null.values - signal)
    classes = dict.fromkeys(kind for kinds in null.base.own_kinds for kind in kinds if kind in KINDS)
    every = [(kind, one) for kind in classes for one in _setups(null, own, u, kind)]
    found = []
    for kind, one in every:
        others = [other for of, other in every if of == kind and other is not one]
        p_value = _chance(one, others, CLASSES[kind].size) * len(every)
        if p_value < FALSE_ALARMS:
            found.append(_off(null, kind, one, p_value))
    return tuple(sorted(found, key=lambda one: one.p_value))


def _chance(one: _Setup, others: Sequence[_Setup], size: float) -> float:
    """Probability that a set-up is so far off, where set-ups of its class differ as the others do, or as is usual."""
    if not others:
        return 1.0
    spread = max(size, float(np.sqrt(np.mean([other.value**2 for other in others]))))
    return float(2.0 * stdtr(len(others), -abs(one.value) / np.hypot(spread, one.u)))


def _own(null: Null, left: FloatArray) -> tuple[list[FloatArray], list[FloatArray]]:
    """Of every run (k,) each: its own unknowns beside the base, and their standard uncertainties, inf where unknown."""
    base, white = null.base, null.whitening
    q, r, size = factored(white, base.columns)
    root = np.linalg.pinv(r, rcond=RANK) / size[:, np.newaxis]  # of the covariance of what the base has fitted
    rest = left - base.columns @ (root @ q.transposed(white(left)))
    values, us = [], []
    inside = np.split(base.columns.weights @ root, base.columns.ends[1:-1])
    for run, own, noise, few, part in zip(base.runs, base.own, white.runs, base.columns.few, inside, strict=True):
        scale = np.maximum(np.linalg.norm(own, axis=0), 1e-300)
        both = noise.whitened(np.column_stack([own / scale, rest[run.rows.at], few]))
        k = own.shape[1]
        inverse = np.linalg.pinv(both[:, :k], rcond=RANK)
        through = inverse @ both[:, k + 1 :] @ part
        values.append(inverse @ both[:, k] / scale)
        u = np.sqrt(np.sum(inverse**2, axis=1) + np.sum(through**2, axis=1)) / scale
        held = np.abs(inverse @ both[:, :k] - np.eye(k)).max(axis=1) < np.sqrt(RANK)
        us.append(np.where(held, u, np.inf))
    return values, us


def _setups(null: Null, own: Sequence[FloatArray], u: Sequence[FloatArray], kind: str) -> Iterator[_Setup]:
    """Runs of one set-up that agree go together; where they do not, each is one by itself."""
    groups: dict[tuple[int, str], list[tuple[int, int]]] = {}
    for place, (run, kinds) in enumerate(zip(null.base.runs, null.base.own_kinds, strict=True)):
        if kind in kinds and np.isfinite(u[place][kinds.index(kind)]):
            key = int(null.rows.setup[run.rows.at[0]]), run.rows.run.session
            groups.setdefault(key, []).append((place, kinds.index(kind)))
    for members in groups.values():
        value = np.array([own[place][at] for place, at in members])
        each = np.array([u[place][at] for place, at in members])
        weight = 1.0 / each**2
        mean = float(value @ weight / weight.sum())
        if (np.abs(value - mean) <= CLASSES[kind].size + 3.0 * each).all():
            yield _Setup(tuple(place for place, _ in members), mean, float(weight.sum() ** -0.5))
        else:
            for (place, _), alone, its_u in zip(members, value.tolist(), each.tolist(), strict=True):
                yield _Setup((place,), alone, its_u)


def _off(null: Null, kind: str, one: _Setup, p_value: float) -> Off:
    signal = np.zeros(null.rows.size)
    for place in one.places:
        at = null.base.own_kinds[place].index(kind)
        signal[null.base.runs[place].rows.at] = null.base.own[place][:, at] * one.value
    runs = tuple(null.base.runs[place].rows.run.id for place in one.places)
    return Off(Effect(KINDS[kind], runs=runs), one.value, one.u, p_value, signal)
