"""Terms of effects and their derivatives by the effects' parameters, from the generated kernels."""

from typing import Any

import numpy as np

from trueaxis.effects.kind import Effect, Kind, Place
from trueaxis.effects.placement import FARTHEST, REFERENCE_TEMPERATURE, SINCE_REVERSAL, used_variables
from trueaxis.machine.machine import Machine
from trueaxis.model import effect_library
from trueaxis.model.context import Context, FloatArray, ReadingContext
from trueaxis.model.kernels import Kernels

_LIBRARY: Any = effect_library  # emitted, without annotations


def context_variables(kernels: Kernels, kind: str) -> tuple[str, ...]:
    """The context variables that the kernel of a kind takes, in the order of its rows."""
    own = kernels.meta["effects"]["kinds"]
    return tuple((own if kind in own else _LIBRARY.META["effects"]["kinds"])[kind]["context"])


def component_term(
    kernels: Kernels, machine: Machine, effect: Effect, parameters: FloatArray, positions: FloatArray, context: Context
) -> FloatArray:
    """What an effect adds to its component error, (1 + m, n): the term, then its derivative by each parameter.

    parameters: (m,), in the order of the kind; positions: (n_axes, n), mm or deg. Terms are in mm or rad, NaN where the
    context lacks what the effect depends on.
    """
    given = component_variables(kernels, machine, effect, positions, context)
    return term_of(kernels, machine.kinds[effect.kind], parameters, given)


def component_variables(
    kernels: Kernels, machine: Machine, effect: Effect, positions: FloatArray, context: Context
) -> FloatArray:
    """(v, n): all that the term of an effect on a component error depends on, besides its parameters."""
    _check_place(machine, effect, "component")
    own = effect.own_axis

    def row(name: str) -> FloatArray:
        if name == "t":
            return context.time
        if name == "T":
            return context.temperature - REFERENCE_TEMPERATURE
        axis = effect.axis if name.endswith("_b") else own
        if axis is None:
            raise ValueError(f"{effect.label} has no other axis")
        return _of_axis(name.removesuffix("_b"), machine, axis, positions, context)

    return np.array([row(name) for name in context_variables(kernels, effect.kind)])


def reading_term(
    kernels: Kernels, machine: Machine, effect: Effect, parameters: FloatArray, context: ReadingContext
) -> FloatArray:
    """What an effect adds to readings of its instrument, (1 + m, n), mm: the term, then its derivatives.

    parameters: (m,), in the order of the kind. NaN where the context lacks what the effect depends on.
    """
    given = reading_variables(kernels, machine, effect, context)
    return term_of(kernels, machine.kinds[effect.kind], parameters, given)


def reading_variables(kernels: Kernels, machine: Machine, effect: Effect, context: ReadingContext) -> FloatArray:
    """(v, n): all that the term of an effect on readings depends on, besides its parameters."""
    _check_place(machine, effect, "reading")
    rows = {
        "along": context.along,
        "theta": context.theta,
        "along_line": context.way,
        "t": context.time,
        "T": context.temperature - REFERENCE_TEMPERATURE,
    }
    return np.array([rows[name] for name in context_variables(kernels, effect.kind)])


def _check_place(machine: Machine, effect: Effect, place: Place) -> None:
    if machine.kinds[effect.kind].place != place:
        raise ValueError(f"{effect.label} is no effect on a {place}")


def _of_axis(name: str, machine: Machine, axis: str, positions: FloatArray, context: Context) -> FloatArray:
    row = machine.axes.index(axis)
    if name == "s":
        low, high = machine.travel[axis]
        return np.asarray((positions[row] - low) / (high - low))
    if name in SINCE_REVERSAL:  # derivatives at infinity may have no value
        return np.asarray(np.minimum(context.since(name)[row], FARTHEST))
    return np.asarray({"q": positions, "direction": context.directions, "v": context.velocity}[name][row])


def term_of(kernels: Kernels, kind: Kind, parameters: FloatArray, given: FloatArray) -> FloatArray:
    """(1 + m, n): the term and its derivatives. given: (v, n), the variables of the kind at n readings."""
    taken, used = context_variables(kernels, kind.name), used_variables(kind)
    name = f"effect_{kind.name}"
    # The machine's kernels have the effects of its spec; a search tries those of the whole library.
    kernel = kernels[name] if name in kernels else getattr(_LIBRARY, name)
    term: FloatArray = kernel(given, np.asarray(parameters, dtype=np.float64))
    # A comparison with an unknown value, as in a step, would pass for a known one.
    term[:, np.isnan(given[[name in used for name in taken]]).any(axis=0)] = np.nan
    return term
