"""Effects as unknowns of the global fit: amplitudes, and the parameters that are searched."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from trueaxis.effects.kind import Effect, Kind
from trueaxis.estimation.effects.amplitudes import (
    amplitude_names,
    amplitude_units,
    amplitudes_of,
    basis_vectors,
    by_amplitude,
    parameters_of,
    searched_names,
)
from trueaxis.estimation.effects.signature import Ground, RunRows, by_differences, of_term
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_effects import placed_run
from trueaxis.measurement.setup import Run
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues

UNSEEN = 1e-9  # mm of reading per unit of a parameter, below which no reading holds it
POINT_SIZE = (
    20.0  # mm, one standard deviation: points are set up by eye and scale; readings that hardly tell would drift
)
MOST_CHANGE = 2.0  # factor by which a parameter that the term divides by changes in a step


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class EffectUnknown:
    """An effect whose parameters are sought.

    values: (k + f,), amplitudes, then the searched parameters that are fitted; free: names of the latter; chosen:
    values of the searched ones that are not, since the term does not change smoothly with them; sizes: (k + f,), what
    one scaled unit of each is: what changes a reading by 1 mm at most, where the fit starts.
    """

    effect: Effect
    kind: Kind
    values: FloatArray
    free: tuple[str, ...] = ()
    chosen: Mapping[str, float] | None = None
    sizes: FloatArray | None = None

    @property
    def count(self) -> int:
        """How many unknowns it has."""
        return self.values.size

    @property
    def curved(self) -> bool:
        """Whether its columns change with the values."""
        return bool(self.free) or self.kind.place == "point"

    @property
    def scale(self) -> FloatArray:
        """(count,): what one scaled unit is."""
        return np.ones(self.count) if self.sizes is None else self.sizes

    @property
    def names(self) -> tuple[str, ...]:
        """Of its unknowns, as a report says them."""
        return tuple(f"{name} of {self.effect.label}" for name in (*amplitude_names(self.kind), *self.free))

    @property
    def units(self) -> tuple[str, ...]:
        """Of its unknowns."""
        of_searched = {one.name: one.unit for one in self.kind.parameters}
        every = (*amplitude_units(self.kind), *(of_searched[name] for name in self.free))
        return tuple(unit_in(unit, self.effect) for unit in every)

    def searched(self, values: FloatArray) -> dict[str, float]:
        """Searched parameters at values (count,)."""
        own = zip(self.free, values[self.count - len(self.free) :].tolist(), strict=True)
        return {**(self.chosen or {}), **dict(own)}

    def parameters(self, values: FloatArray) -> FloatArray:
        """(m,), in the order of the kind, at values (count,)."""
        return parameters_of(self.kind, values[: self.count - len(self.free)], self.searched(values))

    def by_values(self, values: FloatArray) -> FloatArray:
        """(m, count): derivative of the parameters by the values."""
        k = self.count - len(self.free)
        found = np.zeros((len(self.kind.parameters), self.count))
        found[:, :k] = by_amplitude(self.kind, values[:k])
        for place, name in enumerate(self.free, k):
            found[[one.name for one in self.kind.parameters].index(name), place] = 1.0
        return found

    def columns(self, ground: Ground, chosen: RunRows) -> FloatArray:
        """(n, count): derivative of the readings by the values, at the values; mm per unit."""
        if self.kind.place == "point":
            return by_differences(ground, self.effect, self.kind, chosen.index, chosen.rows).T
        searched = self.searched(self.values)
        rows = [
            of_term(ground, self.effect, self.kind, vector, chosen)[0] for vector in basis_vectors(self.kind, searched)
        ]
        if self.free:
            term = of_term(ground, self.effect, self.kind, self.parameters(self.values), chosen)
            order = [one.name for one in self.kind.parameters]
            rows += [term[1 + order.index(name)] for name in self.free]
        return np.array(rows).T

    def at(self, values: FloatArray) -> "EffectUnknown":
        """The same at other values."""
        return replace(self, values=values)

    def within(self, values: FloatArray) -> bool:
        """Whether a step to the values leaves what a term divides by where it makes sense."""
        divisors = {one.name for one in self.kind.parameters if one.is_divisor}
        k = self.count - len(self.free)
        pairs = zip(self.free, self.values[k:].tolist(), values[k:].tolist(), strict=True)
        return all(
            before / MOST_CHANGE <= after <= before * MOST_CHANGE for name, before, after in pairs if name in divisors
        )


@dataclass(frozen=True, slots=True, eq=False)
class EffectUnknowns:
    """All effects whose parameters are sought, in the order of the spec; ground: None where there is none."""

    members: tuple[EffectUnknown, ...] = ()
    ground: Ground | None = None

    @property
    def count(self) -> int:
        """How many unknowns there are."""
        return sum(one.count for one in self.members)

    @property
    def curved(self) -> bool:
        """Whether columns change with the values."""
        return any(one.curved for one in self.members)

    @property
    def moves_points(self) -> bool:
        """Whether points of the runs are where the values say."""
        return any(one.kind.place == "point" for one in self.members)

    @property
    def scale(self) -> FloatArray:
        """(count,): what one scaled unit of each is."""
        return np.concatenate([np.zeros(0), *(one.scale for one in self.members)])

    @property
    def scaled(self) -> FloatArray:
        """(count,): the values at which the columns are, scaled."""
        return np.concatenate([np.zeros(0), *(one.values / one.scale for one in self.members)])

    def slices(self) -> tuple[slice, ...]:
        """Where the unknowns of each member stand among them."""
        ends = np.cumsum([0, *(one.count for one in self.members)]).tolist()
        return tuple(slice(first, last) for first, last in pairwise(ends))

    def values(self, unknowns: FloatArray) -> tuple[EffectValues, ...]:
        """Parameters by name from unknowns (count,), not scaled."""
        return tuple(
            EffectValues(one.effect, _by_name(one.kind, one.parameters(unknowns[mine])))
            for one, mine in zip(self.members, self.slices(), strict=True)
        )

    def without(self, effects: Iterable[Effect]) -> "EffectUnknowns":
        """All but some."""
        left_out = set(effects)
        return replace(self, members=tuple(one for one in self.members if one.effect not in left_out))

    def at(self, unknowns: FloatArray, values: ErrorValues) -> "EffectUnknowns":
        """Linearised at other unknowns (count,), not scaled; values: all of the machine there."""
        if self.ground is None:
            return self
        moved = [one.at(unknowns[mine]) for one, mine in zip(self.members, self.slices(), strict=True)]
        return EffectUnknowns(tuple(moved), replace(self.ground, model=self.ground.model.with_values(values)))

    def set_up(self, run: Run) -> Run:
        """The run with its points where the effects, at their values, say that they are."""
        if self.ground is None:
            return run
        return placed_run(self.ground.model, run)

    def within(self, unknowns: FloatArray) -> bool:
        """Whether a step to the unknowns (count,), not scaled, stays where the terms make sense."""
        return all(one.within(unknowns[mine]) for one, mine in zip(self.members, self.slices(), strict=True))

    def columns(self, chosen: RunRows) -> FloatArray:
        """(n, count): derivative of the readings by the scaled unknowns, mm."""
        assert self.ground is not None
        parts = [one.columns(self.ground, chosen) * one.scale for one in self.members]
        return np.hstack([np.zeros((chosen.rows.size, 0)), *parts])


def sized(member: EffectUnknown, ground: Ground, chosen: Sequence[RunRows]) -> EffectUnknown:
    """The member with sizes from its columns; searched parameters without an effect on any reading stay as chosen.

    Of a point the size is what may be expected, whatever the readings tell of it.
    """
    if member.kind.place == "point":
        return replace(member, sizes=np.full(member.count, POINT_SIZE))
    largest = np.zeros(member.count)
    for rows in chosen:
        largest = np.maximum(largest, np.abs(member.columns(ground, rows)).max(axis=0, initial=0.0))
    k = member.count - len(member.free)
    still = [name for name, seen in zip(member.free, largest[k:] > 0.0, strict=True) if not seen]
    if still:
        searched = member.searched(member.values)
        kept = np.concatenate([np.ones(k, dtype=bool), largest[k:] > 0.0])
        member = replace(
            member,
            values=member.values[kept],
            free=tuple(name for name in member.free if name not in still),
            chosen={**(member.chosen or {}), **{name: searched[name] for name in still}},
        )
        largest = largest[kept]
    return replace(member, sizes=1.0 / np.where(largest > UNSEEN, largest, 1.0))


def member_at(effect: Effect, kind: Kind, parameters: Mapping[str, float]) -> EffectUnknown:
    """The effect with the parameters at which the fit starts."""
    free = searched_names(kind)
    values = np.concatenate([amplitudes_of(kind, parameters), [parameters[name] for name in free]])
    return EffectUnknown(effect=effect, kind=kind, values=values, free=free)


def unit_in(unit: str, effect: Effect) -> str:
    """A unit of a kind with the component's and axis's own: `u/axis/K` of EXX is mm/mm/K."""
    error = effect.error if effect.component else None
    own = {"u": error.unit if error else "mm", "axis": error.axis_unit if error else "mm"}
    parts = unit.replace("^", " ^").split("/")
    return "/".join(" ".join(own.get(word, word) for word in part.split()).replace(" ^", "^") for part in parts)


def _by_name(kind: Kind, parameters: FloatArray) -> dict[str, float]:
    return dict(zip((one.name for one in kind.parameters), parameters.tolist(), strict=True))
