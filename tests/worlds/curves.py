"""Error curves over the travel of an axis: smooth ones that are no polynomials, and draws of a known prior.

Every curve is zero at home (0, or the end of the travel next to it). The size of a curve is its expected root mean
square over the travel.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.polynomial import legendre
from scipy.interpolate import BSpline, CubicSpline

from tests.worlds.machine import Array

Source = np.random.Generator
Basis = Callable[[Array], Array]

DEGREE, ROUGHNESS = 12, 1.5  # of the prior: the coefficient of order k shrinks with k ** -ROUGHNESS
GRID = 200  # positions over which sizes are averaged
SHAPES, MODES = 200, 22  # shapes over which the covariance of smooth curves is averaged, and its modes that count


@dataclass(frozen=True, eq=False)
class Curve:
    """basis: positions (n,) -> (n, k); value = basis @ coefficients, mm or rad."""

    basis: Basis
    coefficients: Array

    def __call__(self, position: Array) -> Array:
        at = np.asarray(position, float)
        return np.asarray((self.basis(at.ravel()) @ self.coefficients).reshape(at.shape), float)

    def plus(self, more: Callable[[Array], Array]) -> "Curve":
        """With another curve added."""

        def both(at: Array) -> Array:
            return np.column_stack([self(at), more(at)])

        return Curve(both, np.ones(2))


@dataclass(frozen=True)
class Span:
    """Travel and home of an axis, mm or deg."""

    low: float
    high: float
    home: float

    def scaled(self, at: Array) -> Array:
        """-1 to 1 over the travel, clamped to it."""
        return np.clip(2.0 * (np.asarray(at, float) - self.low) / (self.high - self.low) - 1.0, -1.0, 1.0)


@cache
def prior_basis(span: Span) -> Basis:
    """Legendre polynomials less their value at home, so weighted that standard normal coefficients make a curve of
    size 1.
    """
    weights = np.arange(1.0, DEGREE + 1) ** -ROUGHNESS

    def polynomials(at: Array) -> Array:
        return np.asarray(legendre.legvander(span.scaled(at), DEGREE)[:, 1:], float)

    at_home = polynomials(np.array([span.home]))

    def raw(at: Array) -> Array:
        return np.asarray(weights * (polynomials(at) - at_home), float)

    size = np.sqrt(np.mean(np.sum(raw(_grid(span)) ** 2, axis=1)))
    return lambda at: raw(at) / size


@cache
def smooth_basis(span: Span) -> Basis:
    """What smooth curves are made of on the average over their shapes: the largest modes of their covariance, so
    weighted that standard normal coefficients make a curve of size 1. A normal stand-in for curves that are not quite
    normal.
    """
    source, grid = np.random.default_rng(7), _grid(span)
    covariance = np.zeros((GRID, GRID))
    for _ in range(SHAPES):
        drawn = _smooth_shape(source, span)(grid)
        covariance += drawn @ drawn.T / SHAPES
    values, vectors = np.linalg.eigh(covariance)
    modes = CubicSpline(grid, (vectors * np.sqrt(np.maximum(values, 0.0)))[:, : -MODES - 1 : -1])
    at_home = modes(span.home)
    return lambda at: np.asarray(modes(np.clip(at, span.low, span.high)) - at_home, float)


BASES: Mapping[str, Callable[[Span], Basis]] = {"prior": prior_basis, "smooth": smooth_basis}


def draw_curve(source: Source, family: str, span: Span, size: float) -> Curve:
    """family: `prior`, whose curves are draws of prior_basis, or `smooth`, whose are no polynomials."""
    basis = _smooth_shape(source, span) if family == "smooth" else BASES[family](span)
    count = basis(np.array([span.home])).shape[1]
    return Curve(basis, np.asarray(size * source.standard_normal(count), float))


def _smooth_shape(source: Source, span: Span) -> Basis:
    """A slope and either random waves or a random spline; of size 1."""
    shape = _waves(source) if source.random() < 0.6 else _spline(source)
    slope = source.uniform(0.0, 0.7)

    def raw(at: Array) -> Array:
        s = span.scaled(at)
        return np.column_stack([slope * s, shape(s)])

    at_home = raw(np.array([span.home]))
    expected = float(np.sqrt(np.mean(np.sum((raw(_grid(span)) - at_home) ** 2, axis=1))))
    return lambda at: np.asarray((raw(at) - at_home) / expected, float)


def _waves(source: Source) -> Basis:
    """A Gaussian process of a squared-exponential kernel, by random waves."""
    length = source.uniform(0.35, 1.0)  # of the half travel
    number = source.normal(size=32) / length
    phase = source.uniform(0, 2 * np.pi, 32)
    return lambda s: np.sqrt(2 / 32) * np.cos(s[:, None] * number + phase)


def _spline(source: Source) -> Basis:
    pieces = int(source.integers(3, 8))
    knots = np.concatenate([[-1.0] * 3, np.linspace(-1.0, 1.0, pieces + 1), [1.0] * 3])
    return lambda s: np.asarray(BSpline.design_matrix(s, knots, 3).toarray(), float)


def _grid(span: Span) -> Array:
    return np.linspace(span.low, span.high, GRID)
