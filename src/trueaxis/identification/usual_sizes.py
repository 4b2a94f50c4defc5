"""What u is by the usual sizes of instrument unknowns, where the readings make these sizes far smaller.

How well a centre, a line or a zero is known then rests on few values. Both uncertainties go with the values.
"""

from dataclasses import dataclass, replace

import numpy as np

from trueaxis.estimation.instruments import CLASSES, own_kinds
from trueaxis.estimation.judgement import judged_component, judged_location
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.tool_point import ORIGIN, tool_point, volume
from trueaxis.identification.words import small
from trueaxis.model.model import MachineModel
from trueaxis.model.origin import UsualSize

LARGER = 2.0  # times u: less is within what a reader makes of any statement of uncertainty
MOST_NAMED = 4  # errors whose u would be larger by most


@dataclass(frozen=True, slots=True, kw_only=True)
class LargerU:
    """The largest u of an error by the sizes that the readings make likely, and by the usual ones, in `unit`."""

    name: str
    u: float
    u_usual: float
    unit: str


@dataclass(frozen=True, slots=True, kw_only=True)
class ByUsualSizes:
    """sizes: of the classes that the readings make far smaller than usual; errors: those whose u the usual sizes make
    far larger, most first; tool_u, tool_u_usual: of the tool point, RMS over the volume from home, mm.
    """

    sizes: tuple[UsualSize, ...]
    errors: tuple[LargerU, ...]
    tool_u: float
    tool_u_usual: float

    def __str__(self) -> str:
        sizes = [
            f"{one.unknown} {small(one.size, one.unit)}, from {one.values} value{'s' if one.values > 1 else ''} "
            f"(usual {small(one.usual, one.unit)})"
            for one in self.sizes
        ]
        named = [f"{one.name} {small(one.u, one.unit)} ({small(one.u_usual, one.unit)})" for one in self.errors]
        rest = f" and {len(named) - MOST_NAMED} more errors" if len(named) > MOST_NAMED else ""
        return (
            "u rests on sizes of instrument unknowns that the readings make far smaller than usual: "
            f"{'; '.join(sizes)}. A size that comes from few values is a guess. By the usual sizes, as plan counts, u "
            f"is what stands in brackets: tool point over the volume {small(self.tool_u, 'mm')} "
            f"({small(self.tool_u_usual, 'mm')})"
            + "".join(f", {one}" for one in named[:MOST_NAMED])
            + f"{rest}. The values carry both, and predict, fit, compensate, export and report say both"
        )


def by_usual_sizes(model: MachineModel, observed: Observations, found: Estimate) -> ByUsualSizes | None:
    """None where they make no u far larger; found: with the convention for straightness and squareness."""
    expected = found.as_expected
    if expected is None or found.ideal:
        return None
    usual = replace(found, spread=expected.spread, of_prior=expected.of_prior)
    pairs = [
        *(
            (name, judged_location(found, name).u, judged_location(usual, name).u, model.machine.parameter_unit(name))
            for name in found.layout.locations
        ),
        *(
            (name, judged_component(found, name).u, judged_component(usual, name).u, name.unit)
            for name in found.layout.components
        ),
    ]
    larger = sorted((one for one in pairs if one[2] > LARGER * one[1]), key=lambda one: -one[2] / one[1])
    tool = [float(np.sqrt(np.mean(tool_point(one, volume(model), [ORIGIN]).u ** 2))) for one in (found, usual)]
    if not larger and tool[1] <= LARGER * tool[0]:
        return None
    counts = _counts(observed, found)
    return ByUsualSizes(
        sizes=tuple(
            UsualSize(
                unknown=kind,
                size=CLASSES[kind].size * found.factors[kind],
                usual=CLASSES[kind].size,
                unit=CLASSES[kind].unit,
                values=counts[kind],
            )
            for kind in expected.classes
        ),
        errors=tuple(LargerU(name=name, u=u, u_usual=then, unit=unit) for name, u, then, unit in larger),
        tool_u=tool[0],
        tool_u_usual=tool[1],
    )


def _counts(observed: Observations, found: Estimate) -> dict[str, int]:
    """How many unknowns of each class there are."""
    kinds = [one.kind for one in found.layout.shared]
    for index in found.own:
        kinds += own_kinds(observed.runs[index], found.layout.straightness[index])
    return {kind: kinds.count(kind) for kind in kinds}
