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


def told(mine: Outlook, rival: Outlook, run: int | None = None, times: int = 0) -> Told:
    """From the readings at hand, or with run number `run` of the menu taken TIMES[times] times."""
    blocks = [(mine.left, rival.left)]
    if run is not None:
        blocks.append((mine.added[run][times], rival.added[run][times]))
    own = sum((one.T @ one for one, _ in blocks), np.zeros((mine.left.shape[1],) * 2))
    other = sum((two.T @ two for _, two in blocks), np.zeros((rival.left.shape[1],) * 2))
    cross = sum((one.T @ two for one, two in blocks), np.zeros((own.shape[0], other.shape[0])))
    strength = float(np.trace(own)) / own.shape[0]
    if strength <= UNOBSERVABLE * mine.whole:  # the base holds it, and rounding is left
        strength = 0.0
    alike = _inverse_root(own, mine.whole) @ cross @ _inverse_root(other, rival.whole)
    r2 = min(1.0, float(np.linalg.norm(alike, 2)) ** 2)
    return Told(strength, strength * (1.0 - r2), r2)


def separation(prospect: Prospect, mine: Outlook, rivals: Sequence[Outlook]) -> Separation | None:
    """The run that tells the candidate from as many of its rivals as any, and from the worst of these best.

    Taken once if that suffices, else several times; None where no run of the menu tells it from any.
    """
    now = [told(mine, rival) for rival in rivals]
    for times in range(len(TIMES)):
        found: list[Separation] = []
        for run, further in enumerate(prospect.further):
            then = [told(mine, rival, run, times) for rival in rivals]
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


def _inverse_root(gram: FloatArray, whole: float) -> FloatArray:
    """Of a Gram matrix (k, k), directions that the base holds left out."""
    values, vectors = np.linalg.eigh(gram)
    kept = values > UNOBSERVABLE * max(whole, float(values.max(initial=0.0)))
    roots = np.divide(1.0, np.sqrt(np.abs(values)), out=np.zeros_like(values), where=kept)
    return np.asarray((vectors * roots) @ vectors.T)
