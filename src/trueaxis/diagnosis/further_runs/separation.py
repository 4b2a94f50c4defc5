"""The further run that tells a candidate from its rivals best."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.diagnosis.further_runs.audit import CONFOUNDED, ISOLATION
from trueaxis.diagnosis.further_runs.menu import FurtherRun
from trueaxis.diagnosis.further_runs.prospect import TIMES, Outlook, Prospect
from trueaxis.diagnosis.result import FloatArray
from trueaxis.effects.kind import Kind
from trueaxis.estimation.effects.amplitudes import UNOBSERVABLE

APART = 1.0 - CONFOUNDED  # of 1 - R^2, from which two candidates no longer pass for one
WORTH = 2.0  # times as much information about the difference as now, for a run to be proposed
NEARLY_BEST = 1.2  # times the information of an easier run, which a better one must have to be taken instead


@dataclass(frozen=True, slots=True)
class Told:
    """What readings tell of one candidate beside another. strength: lambda (1 - R^2), per unit of amplitude squared."""

    detection: float
    strength: float
    r2: float


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Separation:
    """times: how often the run is taken; told: indices of the rivals that it tells apart; before, after: lambda
    (1 - R^2) against the worst of them.
    """

    further: FurtherRun
    times: int
    told: tuple[int, ...]
    before: float
    after: float


def told(mine: Outlook, rival: Outlook, times: int | None = None) -> list[Told]:
    """From the readings at hand, or with each run of the menu in turn, taken TIMES[times] times."""
    own, other, cross = (_products(*pair, times) for pair in ((mine, mine), (rival, rival), (mine, rival)))
    strength = np.trace(own, axis1=1, axis2=2) / own.shape[1]
    strength[strength <= UNOBSERVABLE * mine.whole] = 0.0  # the base holds it, and rounding is left
    alike = _inverse_roots(own, mine.whole) @ cross @ _inverse_roots(other, rival.whole)
    r2 = np.minimum(1.0, np.linalg.norm(alike, 2, axis=(1, 2)) ** 2)
    return [Told(*each) for each in zip(strength.tolist(), (strength * (1.0 - r2)).tolist(), r2.tolist(), strict=True)]


def _products(one: Outlook, other: Outlook, times: int | None) -> FloatArray:
    """(1, k, k') of the readings at hand, (runs, k, k') with those of each run of the menu."""
    at_hand = one.left.T @ other.left
    if times is None:
        return at_hand[np.newaxis]
    added = [a[times].T @ b[times] for a, b in zip(one.added, other.added, strict=True)]
    return at_hand + np.array(added).reshape(-1, *at_hand.shape)


def separation(prospect: Prospect, mine: Outlook, rivals: Sequence[Outlook]) -> Separation | None:
    """The run that tells the candidate from as many of its rivals as any, and from the worst of these best.

    Taken once if that suffices, else several times; None where no run of the menu tells it from any.
    """
    now = [one for rival in rivals for one in told(mine, rival)]
    for times in range(len(TIMES)):
        found: list[Separation] = []
        of_rivals = [told(mine, rival, times) for rival in rivals]
        for further, *then in zip(prospect.further, *of_rivals, strict=True):
            apart = tuple(
                place
                for place, (before, after) in enumerate(zip(now, then, strict=True))
                if 1.0 - after.r2 > APART and after.strength > WORTH * before.strength
            )
            if apart:
                found.append(
                    Separation(
                        further=further,
                        times=TIMES[times],
                        told=apart,
                        before=min(now[place].strength for place in apart),
                        after=min(then[place].strength for place in apart),
                    )
                )
        if found:
            most = max(len(one.told) for one in found)
            found = [one for one in found if len(one.told) == most]
            best = max(one.after for one in found)
            return next(one for one in found if NEARLY_BEST * one.after >= best)
    return None


def isolable(kind: Kind, strength: float) -> float:
    """The amplitude that is told from a rival, by lambda (1 - R^2); infinite where none is."""
    return _size(kind, ISOLATION, strength)


def largest_reading(mine: Outlook, strength: float) -> float:
    """mm: what an effect of that amplitude changes a reading at hand by at most."""
    return float(np.sqrt(ISOLATION / strength)) * mine.largest if strength > 0.0 else np.inf


def _size(kind: Kind, threshold: float, strength: float) -> float:
    size = float(np.sqrt(threshold / strength)) if strength > 0.0 else np.inf
    return float(np.sqrt(size)) if any(one.role == "root" for one in kind.parameters) else size


def _inverse_roots(grams: FloatArray, whole: float) -> FloatArray:
    """Of Gram matrices (m, k, k), directions that the base holds left out."""
    values, vectors = np.linalg.eigh(grams)
    kept = values > UNOBSERVABLE * np.maximum(whole, values.max(axis=1, keepdims=True, initial=0.0))
    roots = np.divide(1.0, np.sqrt(np.abs(values)), out=np.zeros_like(values), where=kept)
    return np.asarray((vectors * roots[:, np.newaxis]) @ vectors.transpose(0, 2, 1))
