"""Which noise each run has: from repeats where there are any, else from what its own course leaves."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.polynomial import legendre

from trueaxis.diagnose.noise import FEWEST, Contrast, contrasts, estimate_noise
from trueaxis.diagnose.result import FloatArray, NoiseOf
from trueaxis.diagnose.rows import Rows
from trueaxis.runtime.context import ReadingContext

COURSE = 12  # degree or harmonics of a run's own course, where nothing is repeated
GIVEN = 1e6  # degrees of freedom of a noise that is given
SMALLEST = 1e-9  # mm
FEWEST_SINGLE = 4  # degrees of freedom of repeats of single targets


def noise_of_runs(
    rows: Rows, reading: ReadingContext, values: FloatArray, noise_um: float | None
) -> tuple[NoiseOf, ...]:
    """Noise of every run of the set-up, in its order. values: (n,) mm, readings less what is expected.

    noise_um: of every reading, where it is known: white noise, and nothing is estimated.
    """
    every = contrasts(rows, values, reading.theta)
    of: dict[str, NoiseOf] = {}
    for instrument in dict.fromkeys(run.instrument for run in rows.runs):
        found = estimate_noise(every, instrument)
        if noise_um is not None:
            found = NoiseOf(instrument, noise_um * 1e-3, 0.0, 0.0, 0.0, GIVEN, "given")
        if found is None and instrument == "probe":
            found = _single_targets(rows, values, instrument)
        if found is None:
            found = estimate_noise(_courses(rows, reading, values, instrument), instrument)
            found = found and replace(found, origin="nothing is repeated, taken from the course of each run")
        of[instrument] = found or _unknown(rows, values, instrument)
    return tuple(of[run.instrument] for run in rows.runs)


def _unknown(rows: Rows, values: FloatArray, instrument: str) -> NoiseOf:
    """All that is there may be noise, where there are too few readings to know."""
    mine = np.array([run.instrument == instrument for run in rows.runs])[rows.run]
    size = float(np.sqrt(np.mean(values[mine] ** 2))) if mine.any() else 0.0
    return NoiseOf(instrument, max(size, SMALLEST), 0.0, 0.0, 0.0, 1.0, "unknown: too few readings")


def _single_targets(rows: Rows, values: FloatArray, instrument: str) -> NoiseOf | None:
    """White noise by the scatter of repeats of single targets: a probe that stands has no course to be smooth.

    None where too few are repeated.
    """
    mine = np.flatnonzero(np.array([run.instrument == instrument for run in rows.runs])[rows.run])
    _, group = np.unique(np.stack([rows.run[mine], rows.target[mine]]), axis=1, return_inverse=True)
    group = group.reshape(-1)
    count = np.bincount(group)
    rest = values[mine] - (np.bincount(group, weights=values[mine]) / count)[group]
    freedom = mine.size - count.size
    if freedom < FEWEST_SINGLE:
        return None
    sigma = max(float(np.sqrt(rest @ rest / freedom)), SMALLEST)
    return NoiseOf(instrument, sigma, 0.0, 0.0, 0.0, freedom, f"repeats of {int((count > 1).sum())} single targets")


def _courses(rows: Rows, reading: ReadingContext, values: FloatArray, instrument: str) -> Sequence[Contrast]:
    """Each run less a smooth course by direction: no repeats are at hand."""
    found = []
    for index in rows.present:
        mine = rows.of_run(index)
        if rows.runs[index].instrument != instrument:
            continue
        size = mine.stop - mine.start
        if instrument == "ballbar":
            angle = reading.theta[mine]
            parts = [np.ones(size), np.linspace(-0.5, 0.5, size)]
            parts += [part(k * angle) for k in range(1, COURSE + 1) for part in (np.cos, np.sin)]
            nuisance = np.stack(parts, axis=1)
        else:
            way = reading.along[mine]
            span = float(np.ptp(way)) or 1.0
            curve = legendre.legvander(2.0 * (way - way.min()) / span - 1.0, min(COURSE, size // 6))
            there = np.gradient(way) >= 0.0 if size > 1 else np.ones(size, dtype=bool)
            nuisance = np.hstack([np.linspace(-0.5, 0.5, size)[:, np.newaxis], curve, curve * there[:, np.newaxis]])
        q, r = np.linalg.qr(nuisance)
        kept = np.abs(np.diag(r)) > 1e-9 * np.abs(np.diag(r)).max()
        if size - int(kept.sum()) >= FEWEST // 2:
            found.append(Contrast(instrument, values[mine], q[:, kept], across_runs=False))
    return found
