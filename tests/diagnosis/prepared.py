"""Hidden-effect data as the stages of the diagnosis take them, and grounds to search on whose noise is known."""

import tempfile
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
from trueaxis.diagnosis.causes.candidates import candidates
from trueaxis.diagnosis.causes.search import Ground
from trueaxis.diagnosis.causes.signature import Readings, readings_of
from trueaxis.diagnosis.null_model.base import ANYWHERE, Base, base_of
from trueaxis.diagnosis.null_model.freedom import Freedom, freedom_of
from trueaxis.diagnosis.null_model.projection import Projection, spanned
from trueaxis.diagnosis.null_model.rows import Rows, rows_of
from trueaxis.diagnosis.null_model.whiten import MODES, SETTLED, RunNoise, Whitening, whitening
from trueaxis.diagnosis.result import NoiseOf
from trueaxis.estimation.noise import Noise
from trueaxis.measurement.data import MeasuredData, read_data
from trueaxis.model.errors import read_errors
from trueaxis.model.kernels import Kernels
from trueaxis.model.model import MachineModel

FloatArray = npt.NDArray[np.float64]

SIGMA = 3e-4  # mm
SMALL = Design(lines=2, repeats=2, targets=21, samples=72)
WHITE = Noise(SIGMA)
SLOW = Noise(SIGMA, SIGMA / 2, 4.5)
MANY = 1e6  # degrees of freedom of a noise that is known
DRIFTS = 1e-2  # mm, over a run: ten times what the classes of instruments state, as their factor allows


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
    kernels = Kernels(
        meta=module.META,
        module=module,
        routines={n: getattr(module, n) for n in module.META["routines"]},
        backend="numpy",
        note="",
    )
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
    null: Base
    whitening: Whitening
    base: Projection
    freedom: Freedom

    @property
    def columns(self) -> FloatArray:
        return self.null.columns.dense()

    def ground(self, values: FloatArray) -> Ground:
        """Of readings less what is expected, (n,), mm."""
        return Ground(
            readings=self.readings,
            effects=candidates(self.readings.model, self.readings.rows),
            whitening=self.whitening,
            plain=self.base,
            base=self.base,
            wide=self.base,
            values=self.whitening(values),
            freedom=self.freedom,
            progress=lambda _: None,
        )

    def without_own(self) -> FloatArray:
        """(n, k): every free unknown of every run's instrument, written out over all rows."""
        found = []
        for run, own in zip(self.null.runs, self.null.free, strict=True):
            block = np.zeros((self.readings.rows.size, own.shape[1]))
            block[run.rows.at] = own
            found.append(block)
        return np.hstack(found)

    def by_chance(self) -> FloatArray:
        """(n, k): by how much each run drifts, and its readings as its ball stands elsewhere, one sigma each."""
        found = []
        for run, noise in zip(self.null.runs, self.whitening.runs, strict=True):
            mine = np.column_stack([noise.drifts * (run.rows.passed - 0.5), noise.places * noise.ball])
            block = np.zeros((self.readings.rows.size, mine.shape[1]))
            block[run.rows.at] = mine
            found.append(block)
        return np.hstack(found)


@cache
def field(design: Design = SMALL, noise: Noise = WHITE, machine: str = "table_mill", settles: float = 0.0) -> Field:
    """Of a design, with the same noise in every run."""
    given = prepared(Case(seed=1, machine=machine, design=design, noise="none", given="exact"))
    return field_of(given.model, given.rows, noise, settles)


def field_of(model: MachineModel, rows: Rows, noise: Noise = WHITE, settles: float = 0.0) -> Field:
    null = base_of(model, rows)
    runs = [
        run_noise(noise, run.rows.steps, run.rows.passed, settles, drifts=DRIFTS, ball=ball, places=ANYWHERE)
        for run, ball in zip(null.runs, null.balls, strict=True)
    ]
    white = whitening(rows.run, runs, null.free)
    names = dict.fromkeys(run.instrument for run in null.runs)
    told = [
        NoiseOf(
            instrument=name,
            group=name,
            white=noise.white,
            correlated=noise.slow,
            correlation=0.0,
            settles=settles,
            freedom=MANY,
            origin="given",
        )
        for name in names
    ]
    base = Projection(spanned(null.columns.whitened(white)))
    return Field(readings_of(model, rows), null, white, base, freedom_of(rows, white, told))


def run_noise(
    noise: Noise,
    steps: FloatArray,
    passed: FloatArray,
    settles: float = 0.0,
    wanders: float = 0.0,
    drifts: float = 0.0,
    ball: FloatArray | None = None,
    places: float = 0.0,
) -> RunNoise:
    courses = {"wanders": wanders, "settles": settles, "drifts": drifts}
    ball = np.zeros((steps.size, 0)) if ball is None else ball
    return RunNoise(noise=noise, steps=steps, passed=passed, ball=ball, places=places, **courses)


def dense_covariance(run: RunNoise) -> FloatArray:
    """(n, n), mm^2: white, slow, drifting, wandering and settling noise of a run, and the place of its ball, written
    out entry by entry.
    """
    at = np.cumsum(np.concatenate([[0.0], run.steps[1:]]))
    lag = np.abs(np.subtract.outer(at, at))
    noise = run.noise
    stationary = noise.white**2 * np.eye(at.size) + noise.slow**2 * np.exp(-lag / noise.lasts)
    course = np.exp(-run.passed / SETTLED)
    modes = np.pi * np.arange(1, MODES + 1)
    walk = np.sqrt(2.0) * np.sin(np.outer(run.passed, modes)) / modes
    slow = run.wanders**2 * walk @ walk.T + run.settles**2 * np.outer(course, course)
    slow += run.places**2 * run.ball @ run.ball.T
    drift = run.passed - 0.5
    return np.asarray(stationary + slow + run.drifts**2 * np.outer(drift, drift))


def drawn_noise(source: np.random.Generator, run: RunNoise, count: int = 1) -> FloatArray:
    """(n, count): noise of a run, by the Cholesky factor of its dense covariance."""
    root = np.linalg.cholesky(dense_covariance(run))
    return np.asarray(root @ source.standard_normal((root.shape[0], count)))


def noise_of(where: Field, seed: int) -> FloatArray:
    """(n,), mm, run by run."""
    source = np.random.default_rng(seed)
    return np.concatenate([drawn_noise(source, run)[:, 0] for run in where.whitening.runs])
