"""Errors that are known only in combination: a sum that is known ten times better than what it is made of.

An error belongs to a combination where its standard uncertainty would be a tenth or less if the others of the
combination were known. Looked at are numbers that have a name: slopes of curves, location errors, what runs share of
an instrument. The combination is the least-squares regression of the first of them on the others, over the posterior.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from trueaxis.estimation.instruments import SharedUnknown
from trueaxis.estimation.result import Estimate
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import PointOn

TENTH = 0.1  # of the standard uncertainty, as what rests on the prior is judged
MOST_PARTNERS = 3  # a sum of more than four is no statement on any of them: that none is known is in their u
MOST_RUNS = 3  # named of an unknown that runs share
INDEPENDENT = 1e-10  # of its square: what is left of a number that others make up

What = Literal["location", "slope", "instrument"]


@dataclass(frozen=True, slots=True)
class Part:
    """So much of a named number: a location error, the slope of a component, an unknown of an instrument."""

    what: What
    name: str
    factor: float
    unit: str


@dataclass(frozen=True, slots=True)
class Combination:
    """Parts of which the readings tell the sum with standard uncertainty u (unit of the first part, whose factor is 1)
    and by themselves nothing better than `alone`, (n_parts,), each in its own unit.
    """

    parts: tuple[Part, ...]
    u: float
    alone: tuple[float, ...]


def combinations(found: Estimate, runs: Sequence[str]) -> tuple[Combination, ...]:
    """All that hold an error of the machine, of an estimate before the convention for straightness and squareness.

    runs: ids, by index.
    """
    names, rows = _named(found, runs)
    spread = found.spread[rows] / found.scale[rows][:, np.newaxis]
    seen: dict[frozenset[int], Combination] = {}
    for index, own in enumerate(np.linalg.norm(spread, axis=1).tolist()):
        partners = _partners(spread, index) if own > TENTH else []
        members = sorted([index, *partners])
        if partners and frozenset(members) not in seen:
            seen[frozenset(members)] = _combination(found, [names[k] for k in members], rows[members])
    smallest = [one for members, one in seen.items() if not any(other < members for other in seen)]
    return tuple(one for one in smallest if any(part.what != "instrument" for part in one.parts))


def _named(found: Estimate, runs: Sequence[str]) -> tuple[list[tuple[What, str, float, str]], FloatArray]:
    """(what, name, number per unknown, unit) of every named number, and (k,) their unknowns: each is one of them."""
    layout = found.layout
    model, offsets = layout.model, layout.offsets
    names: list[tuple[What, str, float, str]] = []
    for name in layout.locations:
        names.append(("location", name, 1.0, model.machine.parameter_unit(name)))
    for name, basis in zip(layout.components, layout.bases, strict=True):
        is_scale = name.is_positioning and name.is_of_linear_axis
        unit = "1" if is_scale else name.slope_unit
        names.append(("slope", name, basis.per_position, unit))
    for unknown in layout.shared:
        names.append(("instrument", _label(unknown, runs), 1.0, unknown.unknown_class.unit))
    first = int(offsets[-1])
    located = np.arange(first, first + len(layout.locations))
    return names, np.concatenate([located, offsets[:-1], np.arange(layout.count)[layout.of_shared]])


def _label(unknown: SharedUnknown, runs: Sequence[str]) -> str:
    """`ballbar centre z at (250, -225, 200)`, `ballbar length (run-4, run-5)`, `laser scale (run-1 and 11 more)`."""
    points = [part.point for part in unknown.of if isinstance(part, PointOn)] if isinstance(unknown.of, tuple) else []
    if not (unknown.unknown_class.of_point and points):
        of = [runs[index] for index in unknown.runs]
        few = of if len(of) <= MOST_RUNS else of[:1]
        return f"{unknown.label} ({', '.join(few)}{'' if few == of else f' and {len(of) - 1} more'})"
    return f"{unknown.label} at ({', '.join(f'{part:g}' for part in points[-1])})"


def _partners(spread: FloatArray, index: int) -> list[int]:
    """The fewest others that leave a tenth of a number's uncertainty when they are known; none where none do.

    spread: (k, r), a root of the covariance. Chosen one after the other, each time what leaves least.
    """
    left = spread.copy()
    whole = float(spread[index] @ spread[index])
    size = np.sum(spread**2, axis=1)
    chosen: list[int] = []
    while len(chosen) < MOST_PARTNERS:
        squares = np.sum(left**2, axis=1)
        free = squares > INDEPENDENT * size
        free[[index, *chosen]] = False
        gain = np.where(free, (left @ left[index]) ** 2 / np.where(free, squares, 1.0), 0.0)
        best = int(gain.argmax())
        if not gain[best] > 0.0:
            return []
        direction = left[best] / np.sqrt(squares[best])
        left = left - np.outer(left @ direction, direction)
        chosen.append(best)
        if float(left[index] @ left[index]) < TENTH**2 * whole:
            return chosen
    return []


def _combination(found: Estimate, names: list[tuple[What, str, float, str]], rows: FloatArray) -> Combination:
    per = np.array([number for _, _, number, _ in names])
    spread = found.spread[rows] * per[:, np.newaxis]
    size = np.linalg.norm(spread, axis=1)
    share = np.linalg.lstsq((spread[1:] / size[1:, np.newaxis]).T, spread[0], rcond=None)[0] / size[1:]
    u = float(np.linalg.norm(spread[0] - share @ spread[1:]))
    factors = [1.0, *(-share).tolist()]
    parts = [Part(what, name, factor, unit) for (what, name, _, unit), factor in zip(names, factors, strict=True)]
    return Combination(tuple(parts), u, tuple(size.tolist()))
