"""The unknowns of the global fit and where each stands."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from trueaxis.estimation.effects.unknowns import EffectUnknowns
from trueaxis.estimation.machine import IdentifiedMachine, IntArray, component_axes, scales
from trueaxis.estimation.observations import Observations
from trueaxis.identify.global_fit.instruments import Instruments
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.reading_model import home_positions
from trueaxis.runtime.bases import LegendreBasis, axis_basis
from trueaxis.runtime.curves import PolynomialCurve
from trueaxis.runtime.errors import ErrorValues

DECIMALS = 6


@dataclass(frozen=True, slots=True, eq=False)
class Layout:
    """Unknowns: coefficients of the components in their basis, component by component, then the location errors, then
    those of effects, then those of the instruments.

    bases: one for each axis, None where no reading leaves position 0, of the highest degree of its components;
    components, locations: indices of those that are unknown; axis: of each of `components`; offset: first unknown of
    each of `components`, then that of the location errors; knots: the different positions of each axis; scale:
    (n_unknowns,), mm or rad that one scaled unit is.
    """

    machine: IdentifiedMachine
    bases: tuple[LegendreBasis | None, ...]
    components: IntArray
    axis: IntArray
    locations: IntArray
    offset: IntArray
    knots: tuple[FloatArray, ...]
    scale: FloatArray
    instruments: Instruments = field(default_factory=Instruments)
    effects: EffectUnknowns = field(default_factory=EffectUnknowns)

    @property
    def count(self) -> int:
        """How many unknowns there are."""
        return self.of_machine + self.instruments.count

    @property
    def of_machine(self) -> int:
        """How many of them, the first ones, are the machine's."""
        return int(self.offset[-1]) + self.locations.size + self.effects.count

    @property
    def of_locations(self) -> slice:
        """The unknowns that are location errors."""
        first = int(self.offset[-1])
        return slice(first, first + self.locations.size)

    @property
    def of_effects(self) -> slice:
        """The unknowns of effects."""
        return slice(self.of_machine - self.effects.count, self.of_machine)

    @property
    def of_instruments(self) -> slice:
        """The unknowns of the instruments."""
        return slice(self.of_machine, self.count)

    def names(self) -> tuple[str, ...]:
        """Name of the component or location error of each of `components` and `locations`."""
        return (
            *(self.machine.components[c] for c in self.components),
            *(self.machine.location_errors[p] for p in self.locations),
        )

    def of_component(self, place: int) -> slice:
        """The unknowns of the component at a place of `components`."""
        return slice(int(self.offset[place]), int(self.offset[place + 1]))

    def basis_of(self, place: int) -> LegendreBasis:
        """The basis of the component at a place of `components`: as many functions as it has unknowns."""
        basis = self.bases[int(self.axis[place])]
        assert basis is not None
        mine = self.of_component(place)
        return replace(basis, degree=mine.stop - mine.start)

    def curve(self, place: int, unknowns: FloatArray, u: FloatArray | None = None) -> PolynomialCurve:
        """The component at a place of `components` in plain powers, from unknowns in mm or rad."""
        basis = self.basis_of(place)
        coefficients = unknowns[self.of_component(place)] @ basis.powers
        spread = None if u is None else tuple(u.tolist())
        return PolynomialCurve(tuple(range(1, basis.degree + 1)), tuple(coefficients.tolist()), spread)

    def values(self, unknowns: FloatArray, given: ErrorValues) -> ErrorValues:
        """Error values from unknowns in mm or rad and what is given."""
        located = dict(zip(self.names()[self.components.size :], unknowns[self.of_locations].tolist(), strict=True))
        curves = {self.names()[place]: self.curve(place, unknowns) for place in range(self.components.size)}
        found = (*given.effects, *self.effects.values(unknowns[self.of_effects]))
        return ErrorValues(
            given.machine, {**given.parameters, **located}, {**curves, **given.motion_errors}, effects=found
        )


def layout(
    machine: IdentifiedMachine,
    observed: Observations,
    given: ErrorValues,
    degree: int | Mapping[str, int],
    instruments: Instruments | None = None,
    effects: EffectUnknowns | None = None,
) -> Layout:
    """The unknowns: of each axis powers up to `degree`, or to the number of its positions away from 0 if smaller.

    given: values known beforehand, which are no unknowns. degree: of all components, or of each: a component with
    degree 0, or not named, is left at zero.
    """
    knots = _knots(machine, observed)
    instruments = instruments or Instruments()
    effects = effects or EffectUnknowns()
    axes = component_axes(machine)
    most = [int(np.count_nonzero(positions)) for positions in knots]
    wanted = [degree if isinstance(degree, int) else degree.get(name, 0) for name in machine.components]
    sizes = np.array(
        [
            0 if name in given.motion_errors else min(high, most[axis])
            for name, high, axis in zip(machine.components, wanted, axes, strict=True)
        ],
        dtype=np.int64,
    )
    components = np.flatnonzero(sizes)
    highest = [int(np.max(sizes[axes == axis], initial=0)) for axis in range(len(machine.axes))]
    bases = tuple(
        axis_basis(machine.travel[axis], high) if high else None
        for axis, high in zip(machine.axes, highest, strict=True)
    )
    locations = np.array(
        [p for p, name in enumerate(machine.location_errors) if name not in given.parameters], dtype=np.int64
    )
    scale = scales(machine)
    every = np.concatenate(
        [
            np.repeat(scale[components], sizes[components]),
            scale[len(machine.components) + locations],
            effects.scale,
            [unknown.size for unknown in instruments.unknowns],
        ]
    )
    offset = np.concatenate([[0], np.cumsum(sizes[components])]).astype(np.int64)
    return Layout(machine, bases, components, axes[components], locations, offset, knots, every, instruments, effects)


def _knots(machine: IdentifiedMachine, observed: Observations) -> tuple[FloatArray, ...]:
    homes = [home for run in observed.runs if (home := home_positions(run, machine.axes)) is not None]
    every = np.hstack([observed.positions, *homes])
    return tuple(np.unique(np.round(of_axis, DECIMALS) + 0.0) for of_axis in every)
