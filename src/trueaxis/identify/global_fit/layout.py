"""The unknowns of the global fit and where each stands."""

from dataclasses import dataclass

import numpy as np

from trueaxis.identify.global_fit.basis import Basis, axis_basis
from trueaxis.identify.machine import IdentifiedMachine, IntArray, component_axes, scales
from trueaxis.identify.observations import Observations
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.reading_model import home_positions
from trueaxis.runtime.curves import PolynomialCurve
from trueaxis.runtime.errors import ErrorValues

DECIMALS = 6


@dataclass(frozen=True, slots=True, eq=False)
class Layout:
    """Unknowns: coefficients of the components in their basis, component by component, then the location errors.

    bases: one for each axis, None where no reading leaves position 0; components, locations: indices of those that
    are unknown; offset: first unknown of each of `components`, then that of the location errors; knots: the
    different positions of each axis; scale: (n_unknowns,), mm or rad that one scaled unit is.
    """

    machine: IdentifiedMachine
    bases: tuple[Basis | None, ...]
    components: IntArray
    axis: IntArray
    locations: IntArray
    offset: IntArray
    knots: tuple[FloatArray, ...]
    scale: FloatArray

    @property
    def count(self) -> int:
        """How many unknowns there are."""
        return int(self.offset[-1]) + self.locations.size

    def names(self) -> tuple[str, ...]:
        """Name of the component or location error of each of `components` and `locations`."""
        return (
            *(self.machine.components[c] for c in self.components),
            *(self.machine.location_errors[p] for p in self.locations),
        )

    def of_component(self, place: int) -> slice:
        """The unknowns of the component at a place of `components`."""
        return slice(int(self.offset[place]), int(self.offset[place + 1]))

    def basis_of(self, place: int) -> Basis:
        """The basis of the component at a place of `components`."""
        basis = self.bases[int(self.axis[place])]
        assert basis is not None
        return basis

    def curve(self, place: int, unknowns: FloatArray, u: FloatArray | None = None) -> PolynomialCurve:
        """The component at a place of `components` in plain powers, from unknowns in mm or rad."""
        basis = self.basis_of(place)
        coefficients = unknowns[self.of_component(place)] @ basis.powers
        spread = None if u is None else tuple(u.tolist())
        return PolynomialCurve(tuple(range(1, basis.degree + 1)), tuple(coefficients.tolist()), spread)

    def values(self, unknowns: FloatArray, given: ErrorValues) -> ErrorValues:
        """Error values from unknowns in mm or rad and what is given."""
        located = dict(zip(self.names()[self.components.size :], unknowns[self.offset[-1] :].tolist(), strict=True))
        curves = {self.names()[place]: self.curve(place, unknowns) for place in range(self.components.size)}
        return ErrorValues(given.machine, {**given.parameters, **located}, {**curves, **given.motion_errors})


def layout(machine: IdentifiedMachine, observed: Observations, given: ErrorValues, degree: int) -> Layout:
    """The unknowns: of each axis powers up to `degree`, or to the number of its positions away from 0 if smaller.

    given: values known beforehand, which are no unknowns.
    """
    knots = _knots(machine, observed)
    bases: list[Basis | None] = []
    for axis, positions in zip(machine.axes, knots, strict=True):
        highest = min(degree, int(np.count_nonzero(positions)))
        bases.append(axis_basis(machine.travel[axis], highest) if highest else None)
    axes = component_axes(machine)
    components = np.array(
        [c for c, name in enumerate(machine.components) if name not in given.motion_errors and bases[axes[c]]],
        dtype=np.int64,
    )
    locations = np.array(
        [p for p, name in enumerate(machine.location_errors) if name not in given.parameters], dtype=np.int64
    )
    sizes = [basis.degree if (basis := bases[axes[c]]) else 0 for c in components]
    scale = scales(machine)
    every = np.concatenate([np.repeat(scale[components], sizes), scale[len(machine.components) + locations]])
    offset = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
    return Layout(machine, tuple(bases), components, axes[components], locations, offset, knots, every)


def _knots(machine: IdentifiedMachine, observed: Observations) -> tuple[FloatArray, ...]:
    homes = [home for run in observed.runs if (home := home_positions(run, machine.axes)) is not None]
    every = np.hstack([observed.positions, *homes])
    return tuple(np.unique(np.round(of_axis, DECIMALS) + 0.0) for of_axis in every)
