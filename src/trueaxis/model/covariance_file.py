"""The file of a covariance beside error values: plain arrays and a JSON text that names them."""

import io
import json
import os
import zipfile
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.sparse import csr_array

from trueaxis.error_name import ErrorName
from trueaxis.io.faults import Faults
from trueaxis.io.input_files import input_bytes
from trueaxis.machine.machine import Machine
from trueaxis.model.bases import Basis, HatBasis, LegendreBasis, PowerBasis
from trueaxis.model.covariance import DENSE, Covariance, digest_of_values
from trueaxis.model.curves import FloatArray
from trueaxis.model.errors import CovarianceLink, ErrorValues

SCHEMA = 2
LARGEST_U = 1e3  # mm, rad: beyond a metre nothing has been measured
LARGEST_STEP = 1e9  # of an open combination, which has no length of its own
LARGEST_END = 1e7  # mm or deg, of the range of a basis
MOST_TERMS = 99  # of a basis of polynomials, as of a polynomial
MOST_ENTRIES = 1_000_000  # of a row or column: a row of that many numbers is 8 MB


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
        "root": "sparse rows (data, indices, indptr); root times its transpose is the covariance; "
        "the last prior_columns of its columns are the part that rests on the prior, where that is known",
        "noise": "unknown" if covariance.root is None else "known",
        "shape": [covariance.count, 0 if covariance.root is None else int(covariance.root.shape[1])],
        "units": "mm and rad; positions mm and deg",
        "effects": [
            {"effect": label, "parameters": list(names)}
            for label, names in zip(covariance.effects, covariance.effect_parameters, strict=True)
        ],
    }
    if covariance.of_prior is not None:
        head["prior_columns"] = covariance.of_prior
    arrays = _arrays(covariance, "") | {"open": covariance.open}
    usual = covariance.usual
    if usual is not None and usual.root is not None:
        head["usual"] = "a root of the same form, by the usual sizes of instrument unknowns"
        head["usual_columns"] = int(usual.root.shape[1])
        if usual.of_prior is not None:
            head["usual_prior_columns"] = usual.of_prior
        arrays |= _arrays(usual, "usual_")
    arrays = {"head": np.frombuffer(json.dumps(head).encode(), dtype=np.uint8)} | arrays
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, array in arrays.items():
            content = io.BytesIO()
            np.lib.format.write_array(content, np.ascontiguousarray(array), allow_pickle=False)
            archive.writestr(zipfile.ZipInfo(f"{name}.npy"), content.getvalue(), zipfile.ZIP_DEFLATED)
    return buffer.getvalue()


def _arrays(covariance: Covariance, before: str) -> dict[str, Any]:
    """The root as sparse rows, by the names of its arrays, which begin with `before`."""
    root = csr_array((covariance.count, 0)) if covariance.root is None else csr_array(covariance.root)
    return {
        f"{before}data": root.data.astype(np.float64),
        f"{before}indices": root.indices.astype(np.int64),
        f"{before}indptr": root.indptr.astype(np.int64),
    }


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
                opened = _numbers(archive["open"])
                covariance, values = _parsed(head, archive, opened, "")
                if "usual_columns" in head:
                    usual, others = _parsed(head, archive, opened, "usual_")
                    covariance, values = replace(covariance, usual=usual), np.concatenate([values, others])
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


def _parsed(head: Mapping[str, Any], archive: Any, opened: FloatArray, before: str) -> tuple[Covariance, FloatArray]:
    """The record of an archive's parts, whose names begin with `before`, and the numbers of its root; raises anything
    where they are damaged.
    """
    values = _numbers(archive[f"{before}data"])
    indices, indptr = archive[f"{before}indices"], archive[f"{before}indptr"]
    rows, columns = (int(size) for size in head["shape"])
    columns = int(head["usual_columns"]) if before else columns
    if not (0 <= rows <= MOST_ENTRIES and 0 <= columns <= MOST_ENTRIES):
        raise ValueError(f"{rows} values, {columns} columns")
    of_prior = head.get(f"{before}prior_columns")
    if not (of_prior is None or (isinstance(of_prior, int) and 0 <= of_prior <= columns)):
        raise ValueError(f"{of_prior!r} of {columns} columns")
    sparse = _sparse_rows(values, indices, indptr, (rows, columns))
    root: FloatArray | csr_array | None = None
    if head["noise"] == "known":
        root = np.asarray(sparse.toarray()) if sparse.nnz > DENSE * rows * columns else sparse
    found = Covariance(
        machine=str(head["machine"]),
        components=tuple(map(ErrorName, _names(head["components"]))),
        bases=tuple(_basis(one) for one in head["bases"]),
        locations=_names(head["locations"]),
        root=root,
        open=opened,
        effects=tuple(str(one["effect"]) for one in head["effects"]),
        effect_parameters=tuple(_names(one["parameters"]) for one in head["effects"]),
        sha256_of_values=str(head["sha256_of_values"]),
        of_prior=of_prior,
    )
    return found, values


def _sparse_rows(values: FloatArray, indices: Any, indptr: Any, shape: tuple[int, int]) -> csr_array:
    """Raises TypeError or ValueError where they are no sparse rows of that shape."""
    rows, columns = shape
    if indices.dtype.kind not in "iu" or indptr.dtype.kind not in "iu" or indices.ndim != 1 or indptr.ndim != 1:
        raise TypeError("indices are whole numbers")
    if indptr.size != rows + 1 or (indices < 0).any() or (indices >= columns).any() or (np.diff(indptr) < 0).any():
        raise ValueError("indices do not fit")
    if indptr[0] != 0 or indptr[-1] != values.size or values.shape != indices.shape:
        raise ValueError("indices do not fit")
    sparse = csr_array((values, indices.astype(np.int64), indptr.astype(np.int64)), shape=shape)
    sparse.check_format(full_check=True)
    return sparse


def _is_basis(basis: Basis) -> bool:
    """Whether positions rise and orders are those of polynomials."""
    if isinstance(basis, PowerBasis):
        return all(0 <= power <= MOST_TERMS for power in basis.powers)
    if isinstance(basis, LegendreBasis):
        return (
            -LARGEST_END < basis.low <= basis.home <= basis.high < LARGEST_END
            and basis.low < basis.high
            and basis.degree >= 0
            and basis.harmonics >= 0
            and basis.count <= MOST_TERMS
        )
    positions = np.array(basis.positions)
    return bool((np.abs(positions) < LARGEST_END).all() and (np.diff(positions) > 0.0).all() and positions.size)


def _names(names: Sequence[Any]) -> tuple[str, ...]:
    return tuple(map(str, names))


def _basis_object(basis: Basis) -> dict[str, Any]:
    if isinstance(basis, LegendreBasis):
        tree = {"basis": basis.form, "range": [basis.low, basis.high], "degree": basis.degree, "home": basis.home}
        return tree | ({"harmonics": basis.harmonics} if basis.harmonics else {})
    if isinstance(basis, HatBasis):
        return {"basis": "table", "positions": list(basis.positions)}
    return {"basis": "polynomial", "powers": list(basis.powers)}


def _basis(tree: Mapping[str, Any]) -> Basis:
    """Raises KeyError, TypeError or ValueError where the object is damaged."""
    if tree["basis"] in ("legendre", "turn"):
        low, high = (float(end) for end in tree["range"])
        harmonics = int(tree["harmonics"]) if tree["basis"] == "turn" else 0
        degree, home = int(tree["degree"]), float(tree.get("home", 0.0))
        return LegendreBasis(low=low, high=high, degree=degree, home=home, harmonics=harmonics)
    if tree["basis"] == "table":
        return HatBasis(tuple(float(position) for position in tree["positions"]))
    if tree["basis"] == "polynomial":
        return PowerBasis(tuple(int(power) for power in tree["powers"]))
    raise ValueError(tree["basis"])
