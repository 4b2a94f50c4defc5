"""The covariance of error values and what readings leave open of them.

The record belongs to values: a digest of them stands in the error-values file, so that values that were edited since
are never given uncertainties that are not theirs. Values without such a file have the standard uncertainties that they
carry themselves.
"""

import hashlib
import json
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.sparse import block_diag, csr_array, eye_array

from trueaxis.error_name import ErrorName
from trueaxis.model.bases import Basis
from trueaxis.model.curve_json import curve_object
from trueaxis.model.curves import FloatArray
from trueaxis.model.effect_values import effect_object
from trueaxis.model.errors import ErrorValues

DENSE = 0.25  # share of entries that are not zero above which products with a full matrix are faster


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
    None where the parts are not known. usual: the covariance by the usual sizes of instrument unknowns, of the same
    values, where it says far more than this one, whose sizes a few readings make likely; None where there is none.
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
    usual: "Covariance | None" = None

    def _usual(self, change: "Callable[[Covariance], Covariance]") -> "Covariance | None":
        return None if self.usual is None else change(self.usual)

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
        usual = self._usual(lambda one: one.with_open_components(bases))
        return replace(self, components=components, bases=kinds, root=root, open=opened, usual=usual)

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
            usual=None if self.usual is other.usual is None else (self.usual or self).joined(other.usual or other),
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
            usual=self._usual(lambda one: one.of(components, locations, effects)),
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
        return replace(self, root=_mapped(change, self.root), usual=self._usual(lambda one: one.smoothed(changes)))


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
