"""Whether a cause has one size: its amplitude as each set-up of an instrument shows it."""

from collections.abc import Sequence

import numpy as np
from scipy.stats import chi2

from trueaxis.diagnose.refit import Fitted
from trueaxis.diagnose.result import AmplitudeOf, FloatArray
from trueaxis.diagnose.search import Ground

TOLERANCE = 0.1  # of the amplitude, by which groups may differ: no real effect has the exact form
TELLING = 0.5  # a group whose own uncertainty is larger than this share of the amplitude... is still shown


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
    columns = np.stack([np.where(group, mine.signal, 0.0) for group in groups], axis=1)
    left = projection.rest(ground.whitening(columns))
    gram = left.T @ left
    told = np.diag(gram) > 1e-6 * np.diag(gram).max()
    gram, names = (
        gram[np.ix_(told, told)],
        [_name(ground, group) for group, seen in zip(groups, told, strict=True) if seen],
    )
    inverse = np.linalg.pinv(gram, rcond=1e-10, hermitian=True)
    share = inverse @ (left[:, told].T @ projection.rest(ground.values))
    spread = np.sqrt(np.maximum(np.diag(inverse), 0.0))
    found = tuple(
        AmplitudeOf(name, float(value * size), float(u * abs(size)))
        for name, value, u in zip(names, share, spread, strict=True)
    )
    return found, _homogeneous(share, gram)


def _homogeneous(share: FloatArray, information: FloatArray) -> float:
    """p of the hypothesis that all amplitudes are one, up to the tolerance."""
    if share.size < 2:
        return 1.0
    values, vectors = np.linalg.eigh(information)
    kept = values > 1e-10 * values.max()
    covariance = vectors[:, kept] @ np.diag(1.0 / values[kept]) @ vectors[:, kept].T
    weight = np.linalg.pinv(covariance + TOLERANCE**2 * np.eye(share.size), hermitian=True)
    ones = np.ones(share.size)
    mean = float(ones @ weight @ share / (ones @ weight @ ones))
    rest = share - mean
    return float(chi2.sf(float(rest @ weight @ rest), share.size - 1))


def _name(ground: Ground, group: FloatArray) -> str:
    rows = ground.readings.rows
    return ", ".join(rows.runs[index].id for index in np.unique(rows.run[group]))
