"""What is guessed and found of the noise of instruments and runs."""

from dataclasses import dataclass

from trueaxis.diagnosis.null_model.base import ANYWHERE
from trueaxis.diagnosis.null_model.noise_blocks import Blocks
from trueaxis.diagnosis.result import FloatArray


@dataclass(frozen=True, slots=True)
class Guess:
    """Of an instrument: noise: mm; misfit: of the base, as a share of it; 0 where no target is repeated."""

    noise: float
    misfit: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Law:
    """Of an instrument: standard deviations, mm, of white and slow noise, wandering, settling and the places of the
    balls of its runs; lasts: typical steps; freedom: degrees of freedom that tell it.
    """

    white: float
    slow: float = 0.0
    lasts: float = 1.0
    wanders: float = 0.0
    settles: float = 0.0
    places: float = ANYWHERE
    freedom: float = 1.0


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Found:
    """sizes: (instruments, q), see `noise_fit.START`, mm and typical steps; scales: (n_runs,), of the white noise of
    each; told: (n_runs,), information on the logarithm of each; unlikely: minus the logarithm of the likelihood; times:
    what is expected the errors of the machine are, 0 where they are free; beside: what was found beside such errors, of
    instruments of which free ones leave nothing; blocks: of the readings that told it.
    """

    sizes: FloatArray
    scales: FloatArray
    told: FloatArray
    unlikely: float
    times: float = 0.0
    beside: "Found | None" = None
    blocks: Blocks | None = None
