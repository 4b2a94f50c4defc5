"""Noise of readings, mm: several kinds, none of which is told to who looks at the data."""

from collections.abc import Callable, Mapping

import numpy as np

from tests.hidden_effects.machine import Array

Source = np.random.Generator


def noise(kind: str, source: Source, sigma: float, distance: Array) -> Array:
    """Noise of one run in the order in which it was read, (n,); sigma: of a reading, mm; distance: (n,), mm."""
    return KINDS[kind](source, sigma, distance)


def _white(source: Source, sigma: float, distance: Array) -> Array:
    found: Array = sigma * source.standard_normal(len(distance))
    return found


def _correlated(source: Source, sigma: float, distance: Array) -> Array:
    """Four fifths of the variance white, the rest from one reading to the next (correlation 0.8)."""
    white, chain = _white(source, sigma, distance), _chain(source, sigma, distance)
    return np.asarray(np.sqrt(0.8) * white + np.sqrt(0.2) * chain, float)


def _chain(source: Source, sigma: float, distance: Array, correlation: float = 0.8) -> Array:
    steps = _white(source, sigma, distance)
    found = np.empty_like(steps)
    at = steps[0]
    for k, step in enumerate(steps):
        at = step if k == 0 else correlation * at + np.sqrt(1 - correlation**2) * step
        found[k] = at
    return found


def _realistic(source: Source, sigma: float, distance: Array) -> Array:
    """Correlated, and every run drifts over its length by about sigma."""
    return _correlated(source, sigma, distance) + sigma * source.normal() * np.linspace(-0.5, 0.5, len(distance))


def _walk(source: Source, sigma: float, distance: Array) -> Array:
    steps = source.standard_normal(len(distance)) / np.sqrt(len(distance))
    return _white(source, sigma, distance) + sigma * np.cumsum(steps)


def _heavy(source: Source, sigma: float, distance: Array) -> Array:
    found: Array = sigma * source.standard_t(5, len(distance)) / np.sqrt(5 / 3)
    return found


def _growing(source: Source, sigma: float, distance: Array) -> Array:
    """Twice as large at the far end as at the near one."""
    largest = np.max(distance)
    share = distance / largest if largest > 0 else np.zeros_like(distance)
    return _white(source, sigma, distance) * (2.0 / 3.0) * (1.0 + share)


def _quantised(source: Source, sigma: float, distance: Array) -> Array:
    """White; the display's last digit is cut where the readings are put together."""
    return _white(source, sigma, distance)


def _outliers(source: Source, sigma: float, distance: Array) -> Array:
    found = _correlated(source, sigma, distance)
    wrong = source.random(len(distance)) < 0.003
    size = source.uniform(8.0, 20.0, len(distance)) * source.choice((-1.0, 1.0), len(distance))
    return np.where(wrong, found + sigma * size, found)


def _none(source: Source, sigma: float, distance: Array) -> Array:
    return np.zeros_like(distance)


KINDS: Mapping[str, Callable[[Source, float, Array], Array]] = {
    "white": _white,
    "correlated": _correlated,
    "realistic": _realistic,
    "walk": _walk,
    "heavy": _heavy,
    "growing": _growing,
    "quantised": _quantised,
    "outliers": _outliers,
    "none": _none,
}
RESOLUTION = {"quantised": 1e-4}  # mm
