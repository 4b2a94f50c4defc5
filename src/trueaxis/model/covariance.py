"""The covariance of error values and what readings leave open of them.

The record belongs to values: a digest of them stands in the error-values file, so that values that were edited since
are never given uncertainties that are not theirs. Values without such a file have the standard uncertainties that they
carry themselves.
"""

import hashlib
import json
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt
from scipy.sparse import block_diag, csr_array, diags_array, eye_array, hstack

from trueaxis.error_name import ErrorName
from trueaxis.machine.machine import Machine
from trueaxis.model.bases import Basis, unmeasured_basis
from trueaxis.model.curve_json import curve_object
from trueaxis.model.curves import Curve, FloatArray, TableCurve, basis_of_curve
from trueaxis.model.effect_values import effect_object
from trueaxis.model.errors import ErrorValues

DENSE = 0.25  # share of entries that are not zero above which products with a full matrix are faster
BoolArray = npt.NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Covariance:
    """Standard uncertainties and correlations of error values, and the combinations that nothing determines.

    The values are, in this order: coefficients of each component's basis, component by component; location errors;
    parameters of effects. mm and rad.

    components: names; bases: of each; locations: names of location errors; root: (n, r), a factor whose product with
    its transpose is the covariance, None where the noise of the readings is unknown; open: (n, d), combinations that
    no reading determines, as steps of the values; effects: labels, effect_parameters: names of the parameters of each;
    sha256_of_values: digest of the values it belongs to, empty where it is of none yet. of_prior: how many of the last
    columns of the root are the part of the covariance that rests on the prior, the others being that of the readings;
    None where the parts are not known.
    """

    machine: str
    components: tuple[ErrorName, ...]
    bases: tuple[Basis, ...]
    locations: tuple[str, ...]
    root: FloatArray | csr_array | None
    open: FloatArray
    effects: tuple[str, ...] = ()
    effect_parameters: tuple[tuple[str, ...], ...] = ()
    sha256_of_values: str = ""
    of_prior: int | None = None

    @property
    def count(self) -> int:
        """n, how many values there are."""
        of_effects = sum(len(names) for names in self.effect_parameters)
        return sum(basis.count for basis in self.bases) + len(self.locations) + of_effects

    @property
    def matrix(self) -> FloatArray:
        """(n, n): the covariance. Raises ValueError where the noise of the readings is unknown."""
        if self.root is None:
            raise ValueError("the noise of the readings is unknown")
        product = self.root @ self.root.T
        return np.asarray(product if isinstance(product, np.ndarray) else product.toarray())

    def rows_of(self, component: str) -> slice:
        """The values that are coefficients of a component."""
        index = self.components.index(component)
        start = sum(basis.count for basis in self.bases[:index])
        return slice(start, start + self.bases[index].count)

    def with_open_components(self, bases: Mapping[ErrorName, Basis]) -> "Covariance":
        """With further components of which nothing is known at all: every coefficient of their bases is open."""
        added = sum(basis.count for basis in bases.values())
        at = sum(basis.count for basis in self.bases)
        moved = _insertion(self.count, at, added)
        opened = np.hstack([moved @ self.open, np.eye(self.count + added)[:, at : at + added]])
        root = _mapped(moved, self.root)
        components, kinds = (*self.components, *bases), (*self.bases, *bases.values())
        return replace(self, components=components, bases=kinds, root=root, open=opened)

    def joined(self, other: "Covariance") -> "Covariance":
        """With the values of another, which has none of the same; they are independent.

        Values of the other whose noise is unknown are taken as exact. Where the parts of its covariance are not known,
        all of it counts with the readings: it was stated.
        """
        parts = [_parts(self), _parts(other)]
        order = np.argsort(np.concatenate(parts), kind="stable")
        roots = [csr_array((one.count, 0)) if one.root is None else csr_array(one.root) for one in (self, other)]
        root = csr_array(block_diag(roots, format="csr"))[order] if self.root is not None else None
        of_prior = None if self.of_prior is None else self.of_prior + (other.of_prior or 0)
        if root is not None and self.of_prior:  # the prior's columns of this one go behind those of the other
            ends = np.cumsum([roots[0].shape[1] - self.of_prior, self.of_prior, roots[1].shape[1]])
            root = root[
                :, np.concatenate([np.arange(ends[0]), np.arange(ends[1], ends[2]), np.arange(ends[0], ends[1])])
            ]
        opened = np.asarray(block_diag([csr_array(self.open), csr_array(other.open)], format="csr").toarray())[order]
        return Covariance(
            machine=self.machine,
            components=self.components + other.components,
            bases=self.bases + other.bases,
            locations=self.locations + other.locations,
            root=root if root is None or root.nnz <= DENSE * np.prod(root.shape) else np.asarray(root.toarray()),
            open=opened,
            effects=self.effects + other.effects,
            effect_parameters=self.effect_parameters + other.effect_parameters,
            of_prior=of_prior,
        )

    def of(self, components: Collection[str], locations: Collection[str], effects: Collection[str]) -> "Covariance":
        """Of some of the components, location errors and effects alone."""
        kept = [
            name in components
            for name, basis in zip(self.components, self.bases, strict=True)
            for _ in range(basis.count)
        ]
        kept += [name in locations for name in self.locations]
        kept += [label in effects for label, of in zip(self.effects, self.effect_parameters, strict=True) for _ in of]
        rows = np.flatnonzero(kept)
        opened = self.open[rows]
        pairs = [pair for pair in zip(self.components, self.bases, strict=True) if pair[0] in components]
        of_effects = [pair for pair in zip(self.effects, self.effect_parameters, strict=True) if pair[0] in effects]
        return Covariance(
            machine=self.machine,
            components=tuple(name for name, _ in pairs),
            bases=tuple(basis for _, basis in pairs),
            locations=tuple(name for name in self.locations if name in locations),
            root=None if self.root is None else self.root[rows],
            open=opened[:, opened.any(axis=0)],
            effects=tuple(label for label, _ in of_effects),
            effect_parameters=tuple(names for _, names in of_effects),
            of_prior=self.of_prior,
        )

    def smoothed(self, changes: Mapping[str, FloatArray]) -> "Covariance":
        """With the noise of components as it is after their coefficients went through matrices (n, n), by component.

        What is open stays as it is: a curve that is smoothed is not thereby determined.
        """
        blocks = [
            csr_array(changes.get(name, np.eye(basis.count)))
            for name, basis in zip(self.components, self.bases, strict=True)
        ]
        others = self.count - sum(basis.count for basis in self.bases)
        change = csr_array(block_diag([*blocks, eye_array(others)], format="csr"))
        return replace(self, root=_mapped(change, self.root))


def _parts(covariance: Covariance) -> FloatArray:
    """(n,): 0 for values of components, 1 for location errors, 2 for effects."""
    counts = [sum(basis.count for basis in covariance.bases), len(covariance.locations)]
    return np.repeat([0.0, 1.0, 2.0], [*counts, covariance.count - sum(counts)])


def _mapped(change: csr_array, root: FloatArray | csr_array | None) -> FloatArray | csr_array | None:
    """A factor after a linear change of the values."""
    if root is None:
        return None
    return csr_array(change @ root) if isinstance(root, csr_array) else np.asarray(change @ root)


def _insertion(count: int, at: int, added: int) -> csr_array:
    """(count + added, count): moves values from `at` on down by `added`."""
    rows = np.arange(count) + added * (np.arange(count) >= at)
    return csr_array((np.ones(count), (rows, np.arange(count))), shape=(count + added, count))


def factor(matrix: FloatArray) -> FloatArray:
    """(n, r) with factor @ factor.T = matrix, (n, n), symmetric and not negative; values of all units alike."""
    scale = np.sqrt(np.maximum(np.diag(matrix), 0.0))
    unit = np.where(scale > 0.0, scale, 1.0)
    values, vectors = np.linalg.eigh(matrix / np.outer(unit, unit))
    kept = values > 0.0
    return np.asarray((unit * (scale > 0.0))[:, np.newaxis] * vectors[:, kept] * np.sqrt(values[kept]))


def digest_of_values(errors: ErrorValues) -> str:
    """SHA-256 of the values and of what is decided by: how their identification ended, what it determined and left
    open, the ranges that were measured. Uncertainties and the order in the file do not count.
    """
    measured = {name: curve.measured for name, curve in errors.motion_errors.items()}
    judged = {
        "fit": None if errors.fit is None else [errors.fit.state, errors.fit.runs],
        "determined": dict(errors.determined),
        "undetermined": [[one.combination, one.parameters] for one in errors.undetermined],
        "measured": {name: None if ends is None else [float(end) for end in ends] for name, ends in measured.items()},
    }
    return _digest({"values": digest_of_numbers(errors), **judged})


def digest_of_numbers(errors: ErrorValues) -> str:
    """SHA-256 of the values alone, as files of earlier versions have it."""
    curves = {name: curve_object(curve) for name, curve in errors.motion_errors.items()}
    for curve in curves.values():
        for remark in ("u", "u_readings", "u_prior", "measured"):
            curve.pop(remark, None)
    effects = [{key: part for key, part in effect_object(one).items() if key != "u"} for one in errors.effects]
    effects.sort(key=lambda effect: json.dumps(effect, sort_keys=True))
    parameters = {name: float(value) for name, value in errors.parameters.items()}
    return _digest({"parameters": parameters, "motion_errors": curves, "effects": effects})


def _digest(tree: dict[str, Any]) -> str:
    return hashlib.sha256(json.dumps(tree, sort_keys=True).encode()).hexdigest()


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
