"""The unknowns of an estimate, where each stands, and to which class of sizes it belongs."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from trueaxis.error_name import ErrorName
from trueaxis.estimation.curve_prior import DEGREE, harmonics_of, range_of
from trueaxis.estimation.effects.unknowns import EffectUnknowns
from trueaxis.estimation.instruments import STYLUSES, SharedUnknown, shared_unknowns, straight_runs
from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.set_up_anew import taken_runs
from trueaxis.machine.machine import ROTARY
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.bases import LegendreBasis, travel_basis
from trueaxis.model.curves import Curve, LegendreCurve
from trueaxis.model.effect_values import in_order
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel

TOOL_LENGTH = "EZ0T"  # location error by which a spec has the length of the tool, and of a probe, as its own unknown
EFFECT = "effect"  # class of all unknowns of effects: their size is not estimated, 1 mm of a reading is any size at all


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Layout:
    """Unknowns in this order: coefficients of each component's curve, location errors, unknowns of the instruments that
    runs share, effects.

    components, locations: names of those that are unknown; bases: of each component; shared: of the instruments;
    straightness: of each run; effects: whose parameters are sought, linearised at their values; sizes: (n,), what one
    scaled unit is, mm, rad or 1: the size of [prior] or of the class; of an effect what changes a reading by 1 mm;
    kinds: name of the class of each component, location error, shared unknown and unknown of effects, in their order;
    silent: by index of a run, which of its own unknowns add nothing, since an effect of that run has their shape.
    """

    model: MachineModel
    components: tuple[ErrorName, ...]
    bases: tuple[LegendreBasis, ...]
    locations: tuple[str, ...]
    shared: tuple[SharedUnknown, ...]
    straightness: tuple[bool, ...]
    effects: EffectUnknowns
    sizes: FloatArray
    kinds: tuple[str, ...]
    silent: Mapping[int, tuple[int, ...]] = field(default_factory=dict)

    @property
    def count(self) -> int:
        """n, how many unknowns there are besides those of single runs."""
        return int(self.sizes.size)

    @property
    def of_machine(self) -> int:
        """How many of them, the first ones, are curves and location errors of the machine."""
        return self.count - len(self.shared) - self.effects.count

    @property
    def of_shared(self) -> slice:
        """The unknowns of the instruments."""
        return slice(self.of_machine, self.of_machine + len(self.shared))

    @property
    def of_effects(self) -> slice:
        """The unknowns of effects."""
        return slice(self.count - self.effects.count, self.count)

    @property
    def offsets(self) -> IntArray:
        """(n_components + 1,): the first unknown of each component, then of the location errors."""
        return np.concatenate([[0], np.cumsum([basis.count for basis in self.bases])]).astype(np.int64)

    def values(self, unknowns: FloatArray, given: ErrorValues) -> ErrorValues:
        """Error values from unknowns (n,), mm or rad, and what is given."""
        offsets = self.offsets
        curves: dict[str, Curve] = {
            name: LegendreCurve(basis=basis, coefficients=tuple(unknowns[first:last].tolist()))
            for name, basis, first, last in zip(
                self.components, self.bases, offsets[:-1].tolist(), offsets[1:].tolist(), strict=True
            )
        }
        located = unknowns[offsets[-1] : self.of_machine].tolist()
        return ErrorValues(
            machine=given.machine,
            parameters={**given.parameters, **dict(zip(self.locations, located, strict=True))},
            motion_errors={**curves, **given.motion_errors},
            effects=in_order(
                (*given.effects, *self.effects.values(unknowns[self.of_effects])), self.model.machine.effects
            ),
        )

    def at(self, unknowns: FloatArray, given: ErrorValues) -> "Layout":
        """With effects linearised at unknowns (n,)."""
        if self.effects.ground is None:
            return self
        return replace(self, effects=self.effects.at(unknowns[self.of_effects], self.values(unknowns, given)))

    def start(self) -> FloatArray:
        """(n,): zero, and the effects at the values at which they are linearised."""
        found = np.zeros(self.count)
        found[self.of_effects] = self.effects.scaled * self.effects.scale
        return found


def _turned(model: MachineModel, observed: Observations, index: int) -> bool:
    """Whether a rotary axis stands elsewhere than at home in a run: else its zero holds the length of its tool."""
    home, at = observed.runs[index].home, observed.positions[:, observed.run == index]
    return any(axis in ROTARY and (at[row] != home[axis]).any() for row, axis in enumerate(model.axes))


def layout_of(
    model: MachineModel,
    observed: Observations,
    given: ErrorValues,
    effects: EffectUnknowns | None = None,
    degree: int = DEGREE,
    other_degrees: Mapping[ErrorName, int] | None = None,
    *,
    turns: bool = True,
) -> Layout:
    """Every error that is not given, whether a reading holds it or not: what none holds keeps its prior.

    degree: of the curves, but for those of other_degrees; turns: whether curves of an axis that turns round have
    harmonics. Beside polynomials with no prior they would leave open how much is of which.
    """
    effects = effects or EffectUnknowns()
    components = tuple(name for name in model.components if name not in given.motion_errors)
    locations = tuple(name for name in model.location_errors if name not in given.parameters)
    straightness = straight_runs(model, observed.runs, observed.run, observed.positions)
    time = None if observed.context is None else observed.context.time
    shared = [
        one
        for one in shared_unknowns(observed.runs, taken_runs(observed.run, time), straightness)
        if one.kind not in STYLUSES
        or (TOOL_LENGTH not in locations and any(_turned(model, observed, index) for index in one.runs))
    ]
    others = other_degrees or {}
    harmonics = {axis: harmonics_of(axis, model.travel[axis]) for axis in model.axes}
    ranges = {
        axis: range_of(model.travel[axis], harmonics[axis], observed.positions[row])
        for row, axis in enumerate(model.axes)
    }
    bases = tuple(
        travel_basis(ranges[name.axis], others.get(name, degree), harmonics[name.axis] if turns else 0)
        for name in components
    )
    prior, machine = model.prior, model.machine
    sizes = [
        *np.repeat([prior.of_component(name) for name in components], [basis.count for basis in bases]).tolist(),
        *(prior.of_location(name, machine.parameter_unit(name)) for name in locations),
        *(one.size for one in shared),
        *effects.scale.tolist(),
    ]
    return Layout(
        model=model,
        components=components,
        bases=bases,
        locations=locations,
        shared=tuple(shared),
        straightness=tuple(straightness),
        effects=effects,
        sizes=np.array(sizes),
        kinds=(
            *map(class_of, components),
            *_classes_of(model, locations),
            *(one.kind for one in shared),
            *([EFFECT] * effects.count),
        ),
    )


def class_of(component: ErrorName) -> str:
    """The class whose size a component shares."""
    return "rotation" if component.is_rotation else "translation"


def _classes_of(model: MachineModel, locations: Sequence[str]) -> list[str]:
    return [f"location {model.machine.parameter_unit(name)}" for name in locations]
