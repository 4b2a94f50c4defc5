"""The covariance of identified error values, its file, and what it makes of predicted deviations (JCGM 100:2008, 5.2).

The deviation is a first-order function of the error values within their size squared, so that u^2 of each coordinate is
J C J' with J its derivative by the values.
"""

import io
import json
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from trueaxis.effects.kind import Effect
from trueaxis.faults import Faults
from trueaxis.identify.effects.deviation import by_effects
from trueaxis.identify.global_fit.basis import Basis
from trueaxis.identify.machine import IdentifiedMachine, component_axes
from trueaxis.input_files import input_bytes
from trueaxis.measure.machine import FloatArray

SCHEMA = 1
OPEN = 1e-6  # mm per mm (rotations times their levers): response to an undetermined combination that counts
CHUNK = 4096  # points at a time
LARGEST_VARIANCE = 1e6  # mm^2, rad^2: beyond a standard uncertainty of a metre nothing has been measured
LARGEST_STEP = 1e9  # of an open combination, which has no length of its own
LARGEST_END = 1e7  # mm or deg, of the range of a basis
MOST_TERMS = 99  # of a basis, as of a polynomial
_ARRAYS = ("low", "high", "degree", "covariance", "open")


@dataclass(frozen=True, slots=True, eq=False)
class Covariance:
    """Standard uncertainties and correlations of error values.

    components: names; bases: of each (Legendre polynomials less their value at 0: see Basis); locations: names of
    location errors; matrix: (n, n), covariance of the coefficients, component by component, then of the location
    errors, then of the parameters of effects, mm and rad; open: (n, d), combinations that no reading determines, as
    steps of the same values; effects: labels, effect_parameters: names of the parameters of each.
    """

    machine: str
    components: tuple[str, ...]
    bases: tuple[Basis, ...]
    locations: tuple[str, ...]
    matrix: FloatArray
    open: FloatArray
    effects: tuple[str, ...] = ()
    effect_parameters: tuple[tuple[str, ...], ...] = ()

    @property
    def count(self) -> int:
        """How many values there are."""
        of_effects = sum(len(names) for names in self.effect_parameters)
        return sum(basis.degree for basis in self.bases) + len(self.locations) + of_effects


def derivative(machine: IdentifiedMachine, found: Covariance, positions: FloatArray, tool: FloatArray) -> FloatArray:
    """(3, n_values, n): of the deviation of tool points in the workpiece frame by the values, error-free machine.

    positions: (n_axes, n), mm or deg; tool: (3, 1) or (3, n), mm. Effects are those of axes that stand and have not
    moved, as where the machine is evaluated without a context.
    """
    by_error = machine.view_sensitivity("tool_in_workpiece", positions, np.ascontiguousarray(tool))
    by_error = np.broadcast_to(by_error, (*by_error.shape[:2], positions.shape[1]))
    axes = component_axes(machine)
    parts = []
    for name, basis in zip(found.components, found.bases, strict=True):
        index = machine.components.index(name)
        parts.append(by_error[:, index, np.newaxis] * basis(positions[axes[index]]))
    start = len(machine.components)
    parts += [by_error[:, start + machine.location_errors.index(name), np.newaxis] for name in found.locations]
    if found.effects:
        parts += by_effects(machine, by_error, positions, found.effects)
    return np.concatenate(parts, axis=1) if parts else np.zeros((3, 0, positions.shape[1]))


def predicted_u(machine: IdentifiedMachine, found: Covariance, positions: FloatArray, tool: FloatArray) -> FloatArray:
    """(3, n): standard uncertainty of the deviation of tool points, mm; NaN where it rests on what is undetermined."""
    n = positions.shape[1]
    result = np.empty((3, n))
    for start in range(0, n, CHUNK):
        stop = min(start + CHUNK, n)
        here = tool if tool.shape[1] == 1 else tool[:, start:stop]
        by_value = derivative(machine, found, positions[:, start:stop], here)
        variance = np.einsum("ikn,kl,iln->in", by_value, found.matrix, by_value, optimize=True)
        u = np.sqrt(np.maximum(variance, 0.0))
        moves = np.abs(np.einsum("ikn,kd->idn", by_value, found.open, optimize=True)).max(axis=1, initial=0.0)
        result[:, start:stop] = np.where(moves > OPEN, np.nan, u)
    return result


def dump_covariance(found: Covariance) -> bytes:
    """The content of a .npz file: plain arrays and a JSON text that names them; the same bytes each time."""
    head: dict[str, Any] = {
        "schema": SCHEMA,
        "machine": found.machine,
        "components": list(found.components),
        "locations": list(found.locations),
        "order": "coefficients of each component's basis, order 1 first, component by component; then locations",
        "basis": "Legendre polynomials of the position on [low, high], each less its value at position 0",
        "units": "mm and rad; positions mm and deg",
    }
    if found.effects:
        pairs = zip(found.effects, found.effect_parameters, strict=True)
        head["effects"] = [{"effect": label, "parameters": list(names)} for label, names in pairs]
    arrays = {
        "head": np.frombuffer(json.dumps(head).encode(), dtype=np.uint8),
        "low": np.array([basis.low for basis in found.bases]),
        "high": np.array([basis.high for basis in found.bases]),
        "degree": np.array([basis.degree for basis in found.bases], dtype=np.int64),
        "covariance": found.matrix,
        "open": found.open,
    }
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, array in arrays.items():
            content = io.BytesIO()
            np.lib.format.write_array(content, np.ascontiguousarray(array), allow_pickle=False)
            archive.writestr(zipfile.ZipInfo(f"{name}.npy"), content.getvalue(), zipfile.ZIP_DEFLATED)
    return buffer.getvalue()


def read_covariance(
    path: Path, machine: str, components: Sequence[str], location_errors: Sequence[str], effects: Sequence[Effect] = ()
) -> Covariance:
    """Read a covariance file of this machine. Raises InputError where it is none, or another's."""
    faults = Faults(str(path))
    data = input_bytes(path)
    try:
        with np.load(io.BytesIO(data), allow_pickle=False) as archive:
            head = json.loads(archive["head"].tobytes())
            low, high, degree, matrix, opened = (archive[name] for name in _ARRAYS)
        names, located = tuple(head["components"]), tuple(head["locations"])
        schema, of = head["schema"], head["machine"]
        bases = tuple(Basis(float(a), float(b), int(k)) for a, b, k in zip(low, high, degree, strict=True))
        labels = tuple(str(one["effect"]) for one in head.get("effects", ()))
        parameters = tuple(tuple(map(str, one["parameters"])) for one in head.get("effects", ()))
        numbers = np.array(matrix, float), np.array(opened, float)
        found = Covariance(of, names, bases, located, *numbers, labels, parameters)
    except Exception as error:  # whatever damage does to an archive
        faults.add("", f"is no covariance file: {type(error).__name__}", "a file written by identify --covariance")
        faults.raise_if_any()
        raise
    if schema != SCHEMA:
        faults.add("schema", f"{schema!r} is not a known schema", f"this version reads schema {SCHEMA}")
    if of != machine:
        faults.add("machine", f"{of!r} is another machine", f'the machine is "{machine}"')
    for kind, given, known in (
        ("component", names, components),
        ("location error", located, location_errors),
        ("effect", labels, [effect.label for effect in effects]),
    ):
        for name in given:
            if name not in known:
                faults.add(f"{kind}s", f"the machine has no {kind} {name}")
    n = found.count
    if len(bases) != len(names) or found.matrix.shape != (n, n) or found.open.ndim != 2 or found.open.shape[0] != n:
        faults.add("covariance", "does not fit the names", "a file written by identify --covariance")
    elif not (np.isfinite(found.matrix).all() and np.isfinite(found.open).all()):
        faults.add("covariance", "is not finite")
    elif np.abs(found.matrix).max(initial=0.0) > LARGEST_VARIANCE or (np.diag(found.matrix) < 0.0).any():
        faults.add("covariance", "is none", f"variances from 0 to {LARGEST_VARIANCE:g}, mm and rad")
    elif (np.abs(found.open) > LARGEST_STEP).any():
        faults.add("open", "is too large", f"steps of at most {LARGEST_STEP:g}")
    elif not all(-LARGEST_END < one.low < one.high < LARGEST_END and 0 <= one.degree <= MOST_TERMS for one in bases):
        faults.add("low, high, degree", "are no bases", f"ranges of positions, degrees from 0 to {MOST_TERMS}")
    faults.raise_if_any()
    return found
