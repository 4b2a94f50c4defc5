"""Whether a cause has one size: its amplitude as each set-up of an instrument shows it."""

from collections.abc import Sequence

import numpy as np
from scipy.special import ndtr

from trueaxis.diagnosis.fitted import Fitted
from trueaxis.diagnosis.result import AmplitudeOf, FloatArray
from trueaxis.diagnosis.search import Ground

TOLERANCE = 0.1  # of the amplitude, by which groups may differ: no real effect has the exact form
TELLING = 1e-3  # share of the information below which a group says nothing of the amplitude


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
