"""Values of the effects of a machine."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from trueaxis.effects.kind import Effect, Kind

FloatArray = npt.NDArray[np.float64]
Identity = tuple[str, str | None, str | None, tuple[str, ...], str | None]


@dataclass(frozen=True, slots=True)
class EffectValues:
    """One effect with its parameters by name, and their standard uncertainties, NaN where unknown."""

    effect: Effect
    parameters: Mapping[str, float]
    u: Mapping[str, float] = field(default_factory=dict)

    def vector(self, kind: Kind) -> FloatArray:
        """(m,): the parameters in the order of the effect's kind, zero where nothing is said."""
        return np.array([self.parameters.get(one.name, 0.0) for one in kind.parameters])


def identity(effect: Effect) -> Identity:
    """What makes two effects the same: everything but the order of runs; the end is the target unless said."""
    end = None if effect.end == "target" else effect.end
    return effect.kind, effect.component, effect.axis, tuple(sorted(effect.runs)), end


def in_order(values: Sequence[EffectValues], effects: Sequence[Effect]) -> tuple[EffectValues, ...]:
    """The values in the order of the effects; those of other effects follow as they came."""
    places = {identity(effect): index for index, effect in enumerate(effects)}
    return tuple(sorted(values, key=lambda one: places.get(identity(one.effect), len(effects))))
