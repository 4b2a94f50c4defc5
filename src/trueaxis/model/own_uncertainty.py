"""The uncertainty of error values that name no covariance file: the standard uncertainties that they carry."""

from collections.abc import Mapping, Sequence

import numpy as np
import numpy.typing as npt
from scipy.sparse import csr_array, diags_array, hstack

from trueaxis.error_name import ErrorName
from trueaxis.machine.machine import Machine
from trueaxis.model.bases import Basis, unmeasured_basis
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import Curve, FloatArray, TableCurve, basis_of_curve
from trueaxis.model.errors import ErrorValues

BoolArray = npt.NDArray[np.bool_]


def own_uncertainty(machine: Machine, errors: ErrorValues) -> Covariance:
    """The standard uncertainties that error values carry, as if independent; values without one count as open.

    Where no value has one, nothing is known (root None), and open is what the values name as undetermined.
    """
    named = {name for item in errors.undetermined for name in item.parameters}
    curves = {name: errors.motion_errors[name] for name in machine.components if name in errors.motion_errors}
    bases: dict[ErrorName, Basis] = {name: basis_of_curve(curve) for name, curve in curves.items()}
    for name in machine.components:
        if name in named and name not in bases:
            bases[name] = unmeasured_basis(machine.travel, name)
    locations = tuple(name for name in machine.location_errors if name in errors.parameters or name in named)
    parts = [_u_of_curve(curves[name]) if name in curves else np.full(bases[name].count, np.nan) for name in bases]
    parts.append(np.array([errors.u.get(name, np.nan) for name in locations]))
    names = [tuple(one.name for one in machine.kinds[values.effect.kind].parameters) for values in errors.effects]
    parts += [np.array([one.u.get(n, np.nan) for n in of]) for one, of in zip(errors.effects, names, strict=True)]
    u = np.concatenate([*parts, np.zeros(0)])
    owners = [*(name for name in bases for _ in range(bases[name].count)), *locations]
    undetermined = np.array([*(name in named for name in owners), *([False] * (u.size - len(owners)))], dtype=bool)
    known = bool(np.isfinite(u).any())
    opened = undetermined | (np.isnan(u) if known else np.zeros(u.size, dtype=bool))
    by_parts = _own_parts(errors, curves, bases, locations, u.size)
    root, of_prior = _own_root(u, by_parts, opened) if known else (None, None)
    return Covariance(
        machine=machine.name,
        components=tuple(bases),
        bases=tuple(bases.values()),
        locations=locations,
        root=root,
        open=_steps(opened),
        effects=tuple(values.effect.label for values in errors.effects),
        effect_parameters=tuple(names),
        of_prior=of_prior,
    )


def _own_parts(
    errors: ErrorValues,
    curves: Mapping[ErrorName, Curve],
    bases: Mapping[ErrorName, Basis],
    locations: Sequence[str],
    count: int,
) -> FloatArray:
    """(2, count): the parts of u by the readings and by the prior, NaN where a value does not have them."""
    found = np.full((2, count), np.nan)
    start = 0
    for name, basis in bases.items():
        curve = curves.get(name)
        if not isinstance(curve, TableCurve | None) and curve.u_readings is not None and curve.u_prior is not None:
            found[:, start : start + basis.count] = curve.u_readings, curve.u_prior
        start += basis.count
    for at, location in enumerate(locations, start):
        found[:, at] = errors.u_readings.get(location, np.nan), errors.u_prior.get(location, np.nan)
    return found


def _own_root(u: FloatArray, parts: FloatArray, opened: BoolArray) -> tuple[csr_array, int | None]:
    """A root of the covariance of values that are independent, and how many of its columns are the prior's.

    Tables have thousands of values: a matrix of all values times all would take gigabytes.
    """
    if np.isnan(parts[:, ~opened]).any():
        return csr_array(diags_array(np.where(opened, 0.0, u))), None
    readings, by_prior = np.where(opened, 0.0, parts)
    return csr_array(hstack([diags_array(readings), diags_array(by_prior)])), u.size


def _steps(opened: BoolArray) -> FloatArray:
    """(n, d): a step of each value that is open."""
    at = np.flatnonzero(opened)
    found = np.zeros((opened.size, at.size))
    found[at, np.arange(at.size)] = 1.0
    return found


def _u_of_curve(curve: Curve) -> FloatArray:
    count = basis_of_curve(curve).count
    return np.full(count, np.nan) if curve.u is None else np.array(curve.u, dtype=np.float64)
