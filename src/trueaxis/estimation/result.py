"""What an estimate comes to: values, covariance, noise, what it makes of the readings, how it was reached."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TypeVar

import numpy as np

from trueaxis.effects.kind import Effect
from trueaxis.estimation.doubted_lengths import DoubtedLength
from trueaxis.estimation.gauge import exactly_level, levelling
from trueaxis.estimation.instrument_sizes import AsExpected
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.left_out import Contradiction
from trueaxis.estimation.misread import Misread
from trueaxis.estimation.noise import Noise
from trueaxis.measurement.columns import BoolArray
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.effect_values import identity
from trueaxis.model.errors import ErrorValues

T = TypeVar("T")

SETTLED_BY_CONVENTION = 1e-6  # of their sizes: what is left of a combination that the convention settles is rounding


@dataclass(frozen=True, slots=True, kw_only=True)
class InstrumentNoise:
    """of_group: of each group of runs, by its name (`runs.noise_groups`); scale_of_run: of each run with readings, by
    index, its noise over that of its group; stated: groups whose noise was given: the scales of their runs are mm.
    """

    of_group: Mapping[str, Noise]
    scale_of_run: Mapping[int, float]
    stated: frozenset[str]


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class ReadingsLeft:
    """What the estimate leaves of the readings.

    residual: (n_readings,), mm; outliers: (n_readings,), those that are left out; misread: runs, by index, that are
    likelier with a fault undone, surest first; contradicting: those that contradict all others, without what
    would explain it; doubted: lengths of probes that are not what is stated; freedom: degrees of freedom that are left.
    """

    residual: FloatArray
    outliers: BoolArray
    misread: Mapping[int, Misread]
    contradicting: tuple[Contradiction, ...]
    doubted: tuple[DoubtedLength, ...] = ()
    freedom: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Iteration:
    """rounds, steps: how often noise and sizes, then the unknowns alone were estimated; none of a plan without
    readings; last_step: the largest last one, in standard uncertainties; last_change: by how much it changed a
    residual, mm; converged: whether it was none.
    """

    rounds: int
    steps: int
    last_step: float
    last_change: float
    converged: bool


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Estimate:
    """What readings say of a machine and of the instruments.

    values: of the machine; unknowns: (n,), mm, rad or 1; spread: (n, r), a root of their covariance, the last
    `of_prior` columns of which are the prior's part, the others that of the readings; open: (n, d), combinations of
    errors, as large as expected, that are zero since, without a prior, no reading determines them, with what
    instruments and effects would then be; scale: (n,), their prior standard deviations, at their estimated sizes;
    factors: class of sizes -> the estimated size over the expected one; likelier: of the classes of the machine's
    errors whose size is more than a factor of SAID from the expected one, the logarithm of how much likelier it is than
    that one; as_expected: by the expected sizes of instrument unknowns, where estimated ones are far smaller; own: of
    each run by its index, unknowns of its own in the order of `own_kinds`, mm, rad or
    1; zeroed: effects that are zero, since the readings make their square negative; ideal: whether nothing was taken as
    unknown of the instruments.
    """

    layout: Layout
    values: ErrorValues
    unknowns: FloatArray
    spread: FloatArray
    of_prior: int
    open: FloatArray
    scale: FloatArray
    factors: Mapping[str, float]
    likelier: Mapping[str, float] = field(default_factory=dict)
    as_expected: AsExpected | None = None
    own: Mapping[int, FloatArray] = field(default_factory=dict)
    zeroed: tuple[Effect, ...] = ()
    ideal: bool = False
    noise: InstrumentNoise
    readings: ReadingsLeft
    iteration: Iteration

    def levelled(self) -> "Estimate":
        """By the convention for straightness and squareness; what the instruments' unknowns are stays.

        Values on the exact model; covariance and what is open to first order.
        """
        change = levelling(self.layout)
        prior = np.linalg.norm(change * self.scale, axis=1)
        unknowns = change @ self.unknowns
        left_open = change @ self.open
        of_machine = (left_open / self.scale[:, np.newaxis])[: self.layout.of_machine]
        left_open = left_open[:, np.linalg.norm(of_machine, axis=0) > SETTLED_BY_CONVENTION]
        given = replace(self.values, parameters=_others(self.values.parameters, self.layout.locations))
        given = replace(given, motion_errors=_others(self.values.motion_errors, self.layout.components))
        own = {identity(one.effect) for one in self.layout.effects.members}
        given = replace(given, effects=tuple(one for one in given.effects if identity(one.effect) not in own))
        if self.unknowns[: self.layout.of_machine].any():
            unknowns = exactly_level(self.layout, self.values, given, unknowns, self.scale)
        values = self.layout.values(unknowns, given)
        beside_it = self.as_expected and replace(self.as_expected, spread=change @ self.as_expected.spread)
        return replace(
            self,
            values=values,
            unknowns=unknowns,
            spread=change @ self.spread,
            open=left_open,
            scale=prior,
            as_expected=beside_it,
        )


def _others(values: Mapping[str, T], names: tuple[str, ...]) -> dict[str, T]:
    return {name: value for name, value in values.items() if name not in names}
