"""A cause with values of its parameters."""

from dataclasses import dataclass

from trueaxis.diagnosis.result import FloatArray
from trueaxis.effects.kind import Effect, Kind


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Fitted:
    """One cause with its parameters in the order of its kind; u: NaN where the readings do not tell.

    signal: (n,), mm, what it does to the readings.
    """

    effect: Effect
    kind: Kind
    values: FloatArray
    u: FloatArray
    signal: FloatArray
