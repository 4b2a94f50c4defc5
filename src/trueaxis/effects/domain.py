"""Whether an expression has a value wherever it will be evaluated, tried out at many points."""

import math
import random
from collections.abc import Iterable, Iterator, Mapping, Sequence

from trueaxis.effects.evaluate import evaluate
from trueaxis.effects.expression import Expression, names
from trueaxis.effects.kind import Parameter
from trueaxis.effects.variables import FARTHEST

TRIES = 1000

# Values that matter of every context variable but the position: both ends, zero, something between.
_CONTEXT: Mapping[str, Sequence[float]] = {
    "s": (0.0, 0.3, 1.0),
    "direction": (-1.0, 0.0, 1.0),
    "v": (-200.0, 0.0, 200.0),
    "d": (0.0, 20.0, FARTHEST),
    "d_time": (0.0, 2.0, FARTHEST),
    "d_path": (0.0, 20.0, FARTHEST),
    "t": (0.0, 60.0, 1e5),
    "T": (-10.0, 0.0, 10.0),
}


def undefined_at(
    expression: Expression, positions: Sequence[float], parameters: Mapping[str, Sequence[float]]
) -> dict[str, float] | None:
    """Values of the names of an expression at which it has no finite value; None where none were met."""
    for values in samples(expression, positions, parameters):
        if not math.isfinite(evaluate(expression, values)):
            return values
    return None


def samples(
    expression: Expression, positions: Sequence[float], parameters: Mapping[str, Sequence[float]]
) -> Iterator[dict[str, float]]:
    """TRIES values of the names of an expression, drawn at random and always the same.

    positions: of the axes, mm or deg; parameters: values of each.
    """
    choices = {name.name: _choices(name.name, positions, parameters) for name in names(expression)}
    draw = random.Random(0)
    for _ in range(TRIES):
        yield {name: draw.choice(among) for name, among in choices.items()}


def sampled_positions(travels: Iterable[tuple[float, float]]) -> list[float]:
    """Both ends of each travel and a point between; 0 and 1 where there is none."""
    return [position for low, high in travels for position in (low, 0.7 * low + 0.3 * high, high)] or [0.0, 1.0]


def sampled_parameters(parameters: Iterable[Parameter]) -> dict[str, Sequence[float]]:
    """The grid of each parameter, or a value of either sign."""
    return {one.name: one.values or (-1.0, 1.0) for one in parameters}


def _choices(name: str, positions: Sequence[float], parameters: Mapping[str, Sequence[float]]) -> Sequence[float]:
    if name in parameters:
        return parameters[name]
    variable = name.removesuffix("_b")
    return positions if variable == "q" else _CONTEXT[variable]
