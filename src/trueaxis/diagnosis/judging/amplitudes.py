"""Whether the amplitude of a cause is one: from set-up to set-up, along the travel, over time and temperature."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.special import chdtri, ndtr

from trueaxis.diagnosis.causes.imperfection import MODULATED, changing
from trueaxis.diagnosis.causes.search import Ground, Search, cause_columns
from trueaxis.diagnosis.causes.signature import Fitted
from trueaxis.diagnosis.result import AmplitudeOf, FloatArray
from trueaxis.effects.placement import used_variables

TOLERANCE = MODULATED  # of the amplitude, by which groups may differ: no real effect has the exact form
TELLING = 1e-3  # share of the information below which a group says nothing of the amplitude
# variables of kinds that say themselves how they change along the travel, and with time or temperature
OF_PLACE, OF_CONDITIONS = {"q", "s", "q_b", "s_b"}, {"t", "T"}


@dataclass(frozen=True, slots=True)
class Uneven:
    """How far an amplitude is from being one. p_value: of its being so; excess: whitened squares that are left if it
    counts as one.
    """

    p_value: float
    excess: float


def unevenness(ground: Ground, found: Search, causes: Sequence[Fitted], of_groups: Sequence[float]) -> list[Uneven]:
    """Of every cause, from set-up to set-up and with what else changes. of_groups: p of each, from `amplitudes_of`."""
    by_group = [Uneven(p, float(chdtri(1, max(p, 1e-300)))) for p in of_groups]
    changing = _changing(ground, found, causes)
    pairs = zip(by_group, changing, strict=True)
    return [min(pair, key=lambda one: one.p_value) for pair in pairs]


def _changing(ground: Ground, found: Search, causes: Sequence[Fitted]) -> list[Uneven]:
    """Of every cause the change of its amplitude that is least likely by chance.

    Causes, of exactly their forms, and the base are fitted beside. p is that of a normal deviate, TOLERANCE added to
    its uncertainty, times the number of changes tried.
    """
    projection = ground.plain.extended(cause_columns(ground, found.causes))
    residual = projection.rest(ground.values)
    tested = []
    for cause in causes:
        columns = list(_changes(ground, cause))
        worst = Uneven(1.0, 0.0)
        if columns:
            whole = ground.whitening(cause.signal)
            seen = projection.rest(ground.whitening(np.stack(columns, axis=1)))
            told = np.einsum("nk,nk->k", seen, seen)
            for mine, information in zip(seen.T, told, strict=True):
                if information < TELLING * float(whole @ whole):
                    continue
                explained = float((mine @ residual) ** 2 / information)
                z = np.sqrt(explained / (1.0 + TOLERANCE**2 * information))
                worst = min(worst, Uneven(float(2.0 * ndtr(-z)) * len(columns), explained), key=lambda one: one.p_value)
        tested.append(worst)
    return tested


def _changes(ground: Ground, cause: Fitted) -> Iterator[FloatArray]:
    """(n,), mm, each: the cause, its amplitude changing along the travel, with time or with temperature."""
    rows, used = ground.readings.rows, set(used_variables(cause.kind))
    scales = []
    if cause.kind.place == "component" and not used & OF_PLACE:
        scales.append(rows.positions[rows.axes.index(cause.effect.own_axis)])
    if used and not used & OF_CONDITIONS:
        if rows.time is not None and np.isfinite(rows.time).all():
            scales.append(rows.time)
        if not rows.assumed.any():
            scales.append(ground.readings.context.temperature)
    for scale in scales:
        yield from changing(cause.signal, scale, scale[cause.signal != 0.0])


def amplitudes_of(ground: Ground, causes: Sequence[Fitted], index: int) -> tuple[tuple[AmplitudeOf, ...], float]:
    """Amplitude and standard uncertainty by set-up, in the unit of the first parameter, and p of their being one.

    The other causes and the base are fitted beside.
    """
    rows = ground.readings.rows
    mine = causes[index]
    size = mine.values[0]
    groups = [
        (rows.setup == number)
        for number in np.unique(rows.setup)
        if np.abs(mine.signal[rows.setup == number]).max(initial=0.0) > 0.0
    ]
    if size == 0.0 or len(groups) < 2:
        return (), 1.0
    others = [ground.whitening(one.signal) for place, one in enumerate(causes) if place != index]
    projection = ground.base.extended(np.stack(others, axis=1)) if others else ground.base
    whole = projection.rest(ground.whitening(mine.signal))
    residual = projection.rest(ground.values)
    columns = projection.rest(
        ground.whitening(np.stack([np.where(group, mine.signal, 0.0) for group in groups], axis=1))
    )
    found, worst = [], 1.0
    for place, group in enumerate(groups):
        solved = _apart(whole, columns[:, place], residual)
        if solved is None:
            continue
        share, u, excess, excess_u = solved
        found.append(AmplitudeOf(_name(ground, group), share * size, u * abs(size)))
        z = excess / np.hypot(excess_u, TOLERANCE)
        worst = min(worst, float(2.0 * ndtr(-abs(z))) * len(groups))
    return tuple(found), min(worst, 1.0)


def _apart(whole: FloatArray, part: FloatArray, residual: FloatArray) -> tuple[float, float, float, float] | None:
    """Share of the amplitude in one group, its u, and by how much it exceeds that of all others, and its u.

    None where the group alone does not tell: its signature is the same as the whole, or the base holds it.
    """
    pair = np.stack([whole, part], axis=1)
    gram = pair.T @ pair
    if gram[1, 1] < TELLING * gram[0, 0] or 1.0 - gram[0, 1] ** 2 / (gram[0, 0] * gram[1, 1]) < 1e-6:
        return None
    inverse = np.linalg.inv(gram)
    value = inverse @ (pair.T @ residual)
    both = float(inverse.sum())
    return float(value.sum()), float(np.sqrt(max(both, 0.0))), float(value[1]), float(np.sqrt(inverse[1, 1]))


def _name(ground: Ground, group: FloatArray) -> str:
    rows = ground.readings.rows
    return ", ".join(rows.runs[index].id for index in np.unique(rows.run[group]))
