"""The unknowns of an estimate, where each stands, and to which class of sizes it belongs."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.curve_prior import DEGREE
from trueaxis.estimation.instruments import SharedUnknown, shared_unknowns, straight_runs
from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.observations import Observations
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.bases import LegendreBasis, travel_basis
from trueaxis.runtime.curves import LegendreCurve
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import MachineModel
from trueaxis.spec.machine import LINEAR


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Layout:
    """Unknowns in this order: coefficients of each component's curve, location errors, unknowns that runs share.

    components, locations: names of those that are unknown; bases: of each component; shared: of the instruments;
    straightness: of each run; sizes: (n,), mm, rad or 1: what one scaled unit is, the size of [prior] or of the class;
    kinds: name of the class of each component, location error and shared unknown, in their order.
    """

    model: MachineModel
    components: tuple[str, ...]
    bases: tuple[LegendreBasis, ...]
    locations: tuple[str, ...]
    shared: tuple[SharedUnknown, ...]
    straightness: tuple[bool, ...]
    sizes: FloatArray
    kinds: tuple[str, ...]

    @property
    def count(self) -> int:
        """n, how many unknowns there are besides those of single runs."""
        return int(self.sizes.size)

    @property
    def of_machine(self) -> int:
        """How many of them, the first ones, are the machine's."""
        return self.count - len(self.shared)

    @property
    def offsets(self) -> IntArray:
        """(n_components + 1,): the first unknown of each component, then of the location errors."""
        return np.concatenate([[0], np.cumsum([basis.degree for basis in self.bases])]).astype(np.int64)

    def values(self, unknowns: FloatArray, given: ErrorValues) -> ErrorValues:
        """Error values from unknowns (n,), mm or rad, and what is given."""
        offsets = self.offsets
        curves = {
            name: LegendreCurve(basis, tuple(unknowns[first:last].tolist()))
            for name, basis, first, last in zip(
                self.components, self.bases, offsets[:-1].tolist(), offsets[1:].tolist(), strict=True
            )
        }
        located = unknowns[offsets[-1] : self.of_machine].tolist()
        return ErrorValues(
            given.machine,
            {**given.parameters, **dict(zip(self.locations, located, strict=True))},
            {**curves, **given.motion_errors},
            effects=given.effects,
        )


def layout_of(model: MachineModel, observed: Observations, given: ErrorValues) -> Layout:
    """Every error that is not given, whether a reading holds it or not: what none holds keeps its prior."""
    components = tuple(name for name in model.components if name not in given.motion_errors)
    locations = tuple(name for name in model.location_errors if name not in given.parameters)
    straightness = straight_runs(model, observed.runs, observed.run, observed.positions)
    shared = shared_unknowns(observed.runs, np.unique(observed.run).tolist(), straightness)
    bases = tuple(travel_basis(model.travel[name[2]], DEGREE) for name in components)
    prior, machine = model.prior, model.machine
    sizes = [
        *np.repeat([prior.of_component(name) for name in components], [basis.degree for basis in bases]).tolist(),
        *(prior.of_location(name, machine.parameter_unit(name)) for name in locations),
        *(one.size for one in shared),
    ]
    return Layout(
        model=model,
        components=components,
        bases=bases,
        locations=locations,
        shared=tuple(shared),
        straightness=tuple(straightness),
        sizes=np.array(sizes),
        kinds=(*map(class_of, components), *_classes_of(model, locations), *(one.kind for one in shared)),
    )


def class_of(component: str) -> str:
    """The class whose size a component shares."""
    return "translation" if component[1] in LINEAR else "rotation"


def _classes_of(model: MachineModel, locations: Sequence[str]) -> list[str]:
    return [f"location {model.machine.parameter_unit(name)}" for name in locations]
