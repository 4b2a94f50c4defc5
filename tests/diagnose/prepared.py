"""Hidden-effect data as the stages of the diagnosis take them, and grounds to search on whose noise is known."""

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
import numpy.typing as npt

from tests.hidden_effects.case import Case, generate
from tests.hidden_effects.data import Data
from tests.hidden_effects.design import Design
from tests.kernels import kernels_of
from tests.machines import machine_of
from trueaxis.diagnose.base import base_of
from trueaxis.diagnose.candidates import candidates
from trueaxis.diagnose.freedom import Freedom, freedom_of
from trueaxis.diagnose.projection import Projection, orthonormal
from trueaxis.diagnose.result import NoiseOf
from trueaxis.diagnose.rows import Rows, rows_of
from trueaxis.diagnose.search import Ground
from trueaxis.diagnose.signatures import Readings, readings_of
from trueaxis.diagnose.whiten import Whitening, whitening
from trueaxis.measure.data import MeasuredData, read_data
from trueaxis.runtime.errors import read_errors
from trueaxis.runtime.kernels import Kernels
from trueaxis.runtime.model import MachineModel

FloatArray = npt.NDArray[np.float64]

SIGMA = 3e-4  # mm
SMALL = Design(lines=2, repeats=2, targets=21, samples=72)
WHITE = NoiseOf("laser", SIGMA, 0.0, 0.0, 0.0, 1e6, "given")


@dataclass(frozen=True)
class Prepared:
    """What the diagnosis is given, and what the generator knows."""

    model: MachineModel
    data: MeasuredData
    generated: Data

    @property
    def rows(self) -> Rows:
        return rows_of(self.data)


@cache
def prepared(case: Case) -> Prepared:
    """A case, written to files and read back as a user's would be."""
    generated = generate(case)
    machine = machine_of(generated.spec)
    module = kernels_of(generated.spec)
    kernels = Kernels(module.META, module, {n: getattr(module, n) for n in module.META["routines"]}, "numpy", "")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        generated.write(folder)
        data = read_data(folder / "data", machine)
        errors = read_errors(
            folder / "errors.json",
            machine=machine.name,
            components=machine.components,
            parameters=machine.parameters,
            effects=machine.effects,
            kinds=machine.kinds,
        )
    return Prepared(MachineModel(machine, kernels, errors), data, generated)


@dataclass(frozen=True)
class Field:
    """Where values can be planted: readings with signatures, base and whitening for a noise that is known."""

    readings: Readings
    columns: FloatArray
    whitening: Whitening
    base: Projection
    freedom: Freedom

    def ground(self, values: FloatArray) -> Ground:
        """Of readings less what is expected, (n,), mm."""
        effects = candidates(self.readings.model, self.readings.rows)
        white = self.whitening(values)
        return Ground(self.readings, effects, self.whitening, self.base, self.base, white, self.freedom, lambda _: None)


@cache
def field(design: Design = SMALL, noise: NoiseOf = WHITE, machine: str = "table_mill") -> Field:
    """Of a design, with the same noise in every run."""
    given = prepared(Case(seed=1, machine=machine, design=design, noise="none", given="exact"))
    rows = given.rows
    return field_of(given.model, rows, [noise for _ in rows.present])


def field_of(model: MachineModel, rows: Rows, noise: Sequence[NoiseOf]) -> Field:
    readings = readings_of(model, rows)
    columns = base_of(model, rows).columns
    white = whitening(rows.run, noise)
    return Field(readings, columns, white, Projection(orthonormal(white(columns))), freedom_of(white))


@cache
def _factor(noise: NoiseOf, size: int) -> FloatArray:
    return np.asarray(np.linalg.cholesky(dense_covariance(noise, size)))


def dense_covariance(noise: NoiseOf, size: int) -> FloatArray:
    """(size, size), mm^2: white, first-order autocorrelated and a random slope, written out entry by entry."""
    lag = np.abs(np.subtract.outer(np.arange(size), np.arange(size)))
    way = np.arange(size) / max(size - 1, 1) - 0.5
    correlated = noise.correlated**2 * noise.correlation**lag
    return np.asarray(noise.white**2 * np.eye(size) + correlated + noise.slope**2 * np.outer(way, way))


def drawn_noise(source: np.random.Generator, noise: NoiseOf, size: int, count: int = 1) -> FloatArray:
    """(size, count): runs of noise, by the Cholesky factor of their dense covariance."""
    return np.asarray(_factor(noise, size) @ source.standard_normal((size, count)))
