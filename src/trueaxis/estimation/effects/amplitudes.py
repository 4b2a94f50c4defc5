"""Parameters of an effect by what its term is linear in.

A cosine of amplitude A and phase phi is c cos x + s sin x with c = A cos phi, s = -A sin phi; a parameter whose square
the term is proportional to is taken by its square. The term is then linear in the amplitudes, whatever the parameters
that are searched, and no fit can run into a wrong phase or stand still at an angle of zero.
"""

from collections.abc import Mapping

import numpy as np

from trueaxis.effects.kind import Kind, Role
from trueaxis.measurement.machine import FloatArray

UNOBSERVABLE = 1e-9  # share of a squared signature that the other unknowns leave
QUARTER = -0.5 * np.pi  # the phase at which a cosine is a sine


def explained(
    gram: FloatArray, right: FloatArray, whole: FloatArray, *, one_sided: bool
) -> tuple[FloatArray, FloatArray]:
    """(points,) sums of squares that least squares explains, and (points, k) the amplitudes.

    gram, right: (points, k, k) and (points, k), signatures times one another and times what is to be explained, others
    projected out; whole: (points,), their squares before that. one_sided: an amplitude below zero explains nothing.
    """
    values, vectors = np.linalg.eigh(gram)
    kept = values > UNOBSERVABLE * whole[:, np.newaxis]
    turned = np.einsum("pij,pi->pj", vectors, right)
    scaled = np.divide(turned, values, out=np.zeros_like(turned), where=kept)
    amplitudes = np.einsum("pij,pj->pi", vectors, scaled)
    squares = np.sum(np.where(kept, turned * scaled, 0.0), axis=1)
    if one_sided:
        squares = np.where((amplitudes > 0.0).all(axis=1), squares, 0.0)
    return squares, amplitudes


def amplitude_names(kind: Kind) -> tuple[str, ...]:
    """What each amplitude is, in words."""
    linear, phases = _named(kind, "linear"), _named(kind, "phase")
    if phases:
        return f"{linear[0]} (cosine)", f"{linear[0]} (sine)"
    return (*linear, *(f"{name}^2" for name in _named(kind, "root")))


def amplitude_units(kind: Kind) -> tuple[str, ...]:
    """Units of the amplitudes, as the kind writes them."""
    unit = {one.name: one.unit for one in kind.parameters}
    if _named(kind, "phase"):
        return (unit[_named(kind, "linear")[0]],) * 2
    return (*(unit[name] for name in _named(kind, "linear")), *(f"{unit[name]}^2" for name in _named(kind, "root")))


def basis_vectors(kind: Kind, searched: Mapping[str, float]) -> tuple[FloatArray, ...]:
    """Parameters (m,) at which the term is what one unit of each amplitude adds."""
    linear, phases = _named(kind, "linear"), _named(kind, "phase")
    if phases:
        units = [{linear[0]: 1.0, phases[0]: phase} for phase in (0.0, QUARTER)]
    else:
        units = [{name: 1.0} for name in (*linear, *_named(kind, "root"))]
    return tuple(_vector(kind, {**searched, **unit}) for unit in units)


def parameters_of(kind: Kind, amplitudes: FloatArray, searched: Mapping[str, float]) -> FloatArray:
    """(m,): parameters in the order of the kind. A negative square is taken for zero."""
    linear, phases, roots = (_named(kind, role) for role in ("linear", "phase", "root"))
    if phases:
        cosine, sine = amplitudes
        found = {linear[0]: float(np.hypot(cosine, sine)), phases[0]: float(np.arctan2(-sine, cosine))}
    else:
        found = dict(zip(linear, amplitudes[: len(linear)].tolist(), strict=True))
        squares = np.maximum(amplitudes[len(linear) :], 0.0)
        found |= dict(zip(roots, np.sqrt(squares).tolist(), strict=True))
    return _vector(kind, {**searched, **found})


def amplitudes_of(kind: Kind, parameters: Mapping[str, float]) -> FloatArray:
    """(k,): amplitudes from parameters."""
    linear, phases, roots = (_named(kind, role) for role in ("linear", "phase", "root"))
    if phases:
        size, phase = parameters[linear[0]], parameters[phases[0]]
        return np.array([size * np.cos(phase), -size * np.sin(phase)])
    return np.array([*(parameters[name] for name in linear), *(parameters[name] ** 2 for name in roots)])


def by_amplitude(kind: Kind, amplitudes: FloatArray) -> FloatArray:
    """(m, k): derivative of the parameters by the amplitudes, NaN where there is none (the phase of nothing)."""
    names = [one.name for one in kind.parameters]
    linear, phases, roots = (_named(kind, role) for role in ("linear", "phase", "root"))
    found = np.zeros((len(names), amplitudes.size))
    if phases:
        cosine, sine = amplitudes
        size = np.hypot(cosine, sine) or np.nan
        found[names.index(linear[0])] = np.array([cosine, sine]) / size
        found[names.index(phases[0])] = np.array([sine, -cosine]) / size**2
        return found
    for place, name in enumerate(linear):
        found[names.index(name), place] = 1.0
    for place, name in enumerate(roots, len(linear)):
        square = float(amplitudes[place])
        found[names.index(name), place] = 0.5 / np.sqrt(square) if square > 0.0 else np.nan
    return found


def searched_names(kind: Kind) -> tuple[str, ...]:
    """Parameters that the term depends on in any other way."""
    return _named(kind, "grid")


def _named(kind: Kind, role: Role) -> tuple[str, ...]:
    return tuple(one.name for one in kind.parameters if one.role == role)


def _vector(kind: Kind, values: Mapping[str, float]) -> FloatArray:
    return np.array([values.get(one.name, 0.0) for one in kind.parameters], dtype=np.float64)
