"""The covariance of error values and what readings leave open of them, and its file beside the error values.

The record belongs to values: a digest of them stands in the error-values file, so that values that were edited since
are never given uncertainties that are not theirs.
"""

import hashlib
import io
import json
import os
import zipfile
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.sparse import block_diag, csr_array, eye_array

from trueaxis.faults import Faults
from trueaxis.input_files import input_bytes
from trueaxis.runtime.bases import Basis, HatBasis, LegendreBasis, PowerBasis
from trueaxis.runtime.curve_json import curve_object
from trueaxis.runtime.curves import FloatArray
from trueaxis.runtime.effect_json import effect_object
from trueaxis.runtime.errors import CovarianceLink, ErrorValues
from trueaxis.spec.machine import Machine

SCHEMA = 2
DENSE = 0.25  # share of entries that are not zero above which products with a full matrix are faster
LARGEST_U = 1e3  # mm, rad: beyond a metre nothing has been measured
LARGEST_STEP = 1e9  # of an open combination, which has no length of its own
LARGEST_END = 1e7  # mm or deg, of the range of a basis
MOST_TERMS = 99  # of a basis of polynomials, as of a polynomial
MOST_ENTRIES = 1_000_000  # of a row or column: a row of that many numbers is 8 MB


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Covariance:
    """Standard uncertainties and correlations of error values, and the combinations that nothing determines.

    The values are, in this order: coefficients of each component's basis, component by component; location errors;
    parameters of effects. mm and rad.

    components: names; bases: of each; locations: names of location errors; root: (n, r), a factor whose product with
    its transpose is the covariance, None where the noise of the readings is unknown; open: (n, d), combinations that
    no reading determines, as steps of the values; effects: labels, effect_parameters: names of the parameters of each;
    sha256_of_values: digest of the values it belongs to, empty where it is of none yet.
    """

    machine: str
    components: tuple[str, ...]
    bases: tuple[Basis, ...]
    locations: tuple[str, ...]
    root: FloatArray | csr_array | None
    open: FloatArray
    effects: tuple[str, ...] = ()
    effect_parameters: tuple[tuple[str, ...], ...] = ()
    sha256_of_values: str = ""

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

    def with_open_components(self, bases: Mapping[str, Basis]) -> "Covariance":
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

        Values of the other whose noise is unknown are taken as exact.
        """
        parts = [_parts(self), _parts(other)]
        order = np.argsort(np.concatenate(parts), kind="stable")
        roots = [csr_array((one.count, 0)) if one.root is None else csr_array(one.root) for one in (self, other)]
        root = csr_array(block_diag(roots, format="csr"))[order] if self.root is not None else None
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
    """SHA-256 of the values alone: uncertainties, remarks and the order in the file do not count."""
    curves = {name: curve_object(curve) for name, curve in errors.motion_errors.items()}
    for curve in curves.values():
        curve.pop("u", None)
        curve.pop("measured", None)
    effects = [{key: part for key, part in effect_object(one).items() if key != "u"} for one in errors.effects]
    effects.sort(key=lambda effect: json.dumps(effect, sort_keys=True))
    parameters = {name: float(value) for name, value in errors.parameters.items()}
    values = {"parameters": parameters, "motion_errors": curves, "effects": effects}
    return hashlib.sha256(json.dumps(values, sort_keys=True).encode()).hexdigest()


def linked(errors: ErrorValues, covariance: Covariance, path: Path, file: Path) -> tuple[ErrorValues, bytes]:
    """Values that name the file of their covariance, and the content of that file.

    path: where the values will be written; file: where the covariance will be.
    """
    name = os.path.relpath(file.resolve(), path.resolve().parent)
    digest = digest_of_values(errors)
    link = CovarianceLink(Path(name).as_posix(), digest)
    return replace(errors, covariance=link), dump_covariance(replace(covariance, sha256_of_values=digest))


def dump_covariance(covariance: Covariance) -> bytes:
    """The content of a .npz file: plain arrays and a JSON text that names them; the same bytes each time."""
    head: dict[str, Any] = {
        "schema": SCHEMA,
        "machine": covariance.machine,
        "sha256_of_values": covariance.sha256_of_values,
        "components": list(covariance.components),
        "bases": [_basis_object(basis) for basis in covariance.bases],
        "locations": list(covariance.locations),
        "order": "coefficients of each component's basis, component by component; then locations; then effects",
        "root": "sparse rows (data, indices, indptr); root times its transpose is the covariance",
        "noise": "unknown" if covariance.root is None else "known",
        "shape": [covariance.count, 0 if covariance.root is None else int(covariance.root.shape[1])],
        "units": "mm and rad; positions mm and deg",
        "effects": [
            {"effect": label, "parameters": list(names)}
            for label, names in zip(covariance.effects, covariance.effect_parameters, strict=True)
        ],
    }
    root = csr_array((covariance.count, 0)) if covariance.root is None else csr_array(covariance.root)
    arrays = {
        "head": np.frombuffer(json.dumps(head).encode(), dtype=np.uint8),
        "data": root.data.astype(np.float64),
        "indices": root.indices.astype(np.int64),
        "indptr": root.indptr.astype(np.int64),
        "open": covariance.open,
    }
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, array in arrays.items():
            content = io.BytesIO()
            np.lib.format.write_array(content, np.ascontiguousarray(array), allow_pickle=False)
            archive.writestr(zipfile.ZipInfo(f"{name}.npy"), content.getvalue(), zipfile.ZIP_DEFLATED)
    return buffer.getvalue()


def read_covariance(path: Path, machine: Machine) -> Covariance:
    """Read a covariance file of this machine. Raises InputError where it is none, or another's."""
    faults = Faults(str(path))
    data = input_bytes(path)
    remedy = "run identify again"
    try:
        with np.load(io.BytesIO(data), allow_pickle=False) as archive:
            head = json.loads(archive["head"].tobytes())
            schema = head["schema"]
            if schema == SCHEMA:
                values, opened = (_numbers(archive[name]) for name in ("data", "open"))
                covariance = _parsed(head, values, archive["indices"], archive["indptr"], opened)
    except Exception as error:  # whatever damage does to an archive
        faults.add("", f"is no covariance file: {type(error).__name__}", remedy)
        faults.raise_if_any()
        raise
    if schema != SCHEMA:
        faults.add("schema", f"{schema!r} is not a known schema", f"this version reads schema {SCHEMA}: {remedy}")
        faults.raise_if_any()
    if covariance.machine != machine.name:
        faults.add("machine", f"{covariance.machine!r} is another machine", f'the machine is "{machine.name}"')
    for kind, given, known in (
        ("component", covariance.components, machine.components),
        ("location error", covariance.locations, machine.location_errors),
        ("effect", covariance.effects, [effect.label for effect in machine.effects]),
    ):
        for name in given:
            if name not in known:
                faults.add(f"{kind}s", f"the machine has no {kind} {name}")
    n = covariance.count
    fits = covariance.open.ndim == 2 and covariance.open.shape[0] == n
    if not fits or len(covariance.bases) != len(covariance.components) or head["shape"][0] != n:
        faults.add("covariance", "does not fit the names", remedy)
    elif not np.abs(values).max(initial=0.0) <= LARGEST_U:  # not a number is none, either
        faults.add("covariance", "is none", f"standard uncertainties of at most {LARGEST_U:g}, mm and rad")
    elif not np.abs(covariance.open).max(initial=0.0) <= LARGEST_STEP:
        faults.add("open", "is too large", f"steps of at most {LARGEST_STEP:g}")
    elif not all(map(_is_basis, covariance.bases)):
        faults.add("bases", "are none", f"ranges and positions up to {LARGEST_END:g}, at most {MOST_TERMS} terms")
    faults.raise_if_any()
    return covariance


def _numbers(array: Any) -> FloatArray:
    """Raises TypeError where the array holds anything else."""
    if array.dtype.kind not in "fiu":
        raise TypeError(f"holds {array.dtype}")
    return np.array(array, dtype=np.float64)


def _parsed(head: Mapping[str, Any], values: FloatArray, indices: Any, indptr: Any, opened: FloatArray) -> Covariance:
    """The record of an archive's parts; raises anything where they are damaged."""
    rows, columns = (int(size) for size in head["shape"])
    if not (0 <= rows <= MOST_ENTRIES and 0 <= columns <= MOST_ENTRIES):
        raise ValueError(f"{rows} values, {columns} columns")
    if indices.dtype.kind not in "iu" or indptr.dtype.kind not in "iu" or indices.ndim != 1 or indptr.ndim != 1:
        raise TypeError("indices are whole numbers")
    if indptr.size != rows + 1 or (indices < 0).any() or (indices >= columns).any() or (np.diff(indptr) < 0).any():
        raise ValueError("indices do not fit")
    if indptr[0] != 0 or indptr[-1] != values.size or values.shape != indices.shape:
        raise ValueError("indices do not fit")
    sparse = csr_array((values, indices.astype(np.int64), indptr.astype(np.int64)), shape=(rows, columns))
    sparse.check_format(full_check=True)
    root: FloatArray | csr_array | None = None
    if head["noise"] == "known":
        root = np.asarray(sparse.toarray()) if sparse.nnz > DENSE * rows * columns else sparse
    return Covariance(
        machine=str(head["machine"]),
        components=_names(head["components"]),
        bases=tuple(_basis(one) for one in head["bases"]),
        locations=_names(head["locations"]),
        root=root,
        open=opened,
        effects=tuple(str(one["effect"]) for one in head["effects"]),
        effect_parameters=tuple(_names(one["parameters"]) for one in head["effects"]),
        sha256_of_values=str(head["sha256_of_values"]),
    )


def _is_basis(basis: Basis) -> bool:
    """Whether positions rise and orders are those of polynomials."""
    if isinstance(basis, PowerBasis):
        return all(0 <= power <= MOST_TERMS for power in basis.powers)
    if isinstance(basis, LegendreBasis):
        return (
            -LARGEST_END < basis.low <= basis.home <= basis.high < LARGEST_END
            and basis.low < basis.high
            and 0 <= basis.degree <= MOST_TERMS
        )
    positions = np.array(basis.positions)
    return bool((np.abs(positions) < LARGEST_END).all() and (np.diff(positions) > 0.0).all() and positions.size)


def _names(names: Sequence[Any]) -> tuple[str, ...]:
    return tuple(map(str, names))


def _basis_object(basis: Basis) -> dict[str, Any]:
    if isinstance(basis, LegendreBasis):
        return {
            "basis": "legendre", "range": [basis.low, basis.high], "degree": basis.degree, "home": basis.home
        }  # fmt: skip
    if isinstance(basis, HatBasis):
        return {"basis": "table", "positions": list(basis.positions)}
    return {"basis": "polynomial", "powers": list(basis.powers)}


def _basis(tree: Mapping[str, Any]) -> Basis:
    """Raises KeyError, TypeError or ValueError where the object is damaged."""
    if tree["basis"] == "legendre":
        low, high = (float(end) for end in tree["range"])
        return LegendreBasis(low, high, int(tree["degree"]), float(tree.get("home", 0.0)))
    if tree["basis"] == "table":
        return HatBasis(tuple(float(position) for position in tree["positions"]))
    if tree["basis"] == "polynomial":
        return PowerBasis(tuple(int(power) for power in tree["powers"]))
    raise ValueError(tree["basis"])
