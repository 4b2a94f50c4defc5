"""Functions that error curves are made of, evaluated on arrays: Legendre polynomials and harmonics of a turn, hats of a
table, powers.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from typing import Literal

import numpy as np
import numpy.typing as npt
from numpy.polynomial import legendre

from trueaxis.error_name import ErrorName

FloatArray = npt.NDArray[np.float64]

TURN = 360.0  # deg
A_WAVE = 6  # positions of the finest wave of a curve, where it is looked at
UNMEASURED_DEGREE = 3  # a curve that no reading holds may have any shape: low orders move the tool as much as high ones


@dataclass(frozen=True, kw_only=True)
class LegendreBasis:
    """Legendre polynomials on [low, high], each less its value at home: b_k(home) = 0, k = 1 .. degree; then, where a
    rotary axis turns round, the harmonics of a turn, cos and sin of 1 .. `harmonics` times the angle, less theirs.
    Beyond the range polynomials keep the values at its ends, and turns repeat.

    The first is the position from home divided by half the range. low, high, home: mm or deg.
    """

    low: float
    high: float
    degree: int
    home: float = 0.0
    harmonics: int = 0

    def __call__(self, positions: FloatArray) -> FloatArray:
        """(count, n): the basis functions at positions (n,)."""
        return np.asarray(basis_values((self,), positions[np.newaxis])[0])

    def evenly(self, least: int) -> FloatArray:
        """(m,): positions evenly over the range, `least` of them, more where harmonics are finer than that."""
        of_waves = int(A_WAVE * self.harmonics * (self.high - self.low) / TURN)
        return np.linspace(self.low, self.high, max(least, of_waves + 1))

    @property
    def form(self) -> Literal["legendre", "turn"]:
        """As files name it."""
        return "turn" if self.harmonics else "legendre"

    @property
    def count(self) -> int:
        """How many functions there are."""
        return self.degree + 2 * self.harmonics

    @property
    def order(self) -> tuple[int, int]:
        """Degree and harmonics: bases that have them alike have functions alike, each over its own range."""
        return self.degree, self.harmonics

    @property
    def polynomials(self) -> "LegendreBasis":
        """The same without harmonics."""
        return replace(self, harmonics=0)

    @property
    def powers(self) -> FloatArray:
        """(degree, degree): row k holds the coefficients of s^1 .. s^degree of b_(k+1); exact before rounding."""
        return _powers(*self._centre_and_half(), self.degree)

    @property
    def at_home(self) -> FloatArray:
        """(count,): the Legendre polynomials and harmonics at home, which the basis functions are less of."""
        return np.asarray(_at_home(self)[0])

    @property
    def per_position(self) -> float:
        """Slope of the first basis function, 1/mm or 1/deg."""
        return 1.0 / self._centre_and_half()[1]

    def _scaled(self, positions: FloatArray) -> FloatArray:
        centre, half = self._centre_and_half()
        return (positions - centre) / half

    def _centre_and_half(self) -> tuple[float, float]:
        return 0.5 * (self.low + self.high), 0.5 * (self.high - self.low) or 1.0


def basis_values(bases: tuple[LegendreBasis, ...], positions: FloatArray) -> FloatArray:
    """(k, count, n): each of k bases of one order at positions of its own, (k, n).

    At once, since on the few positions of a run a call costs more than its arithmetic.
    """
    low, high, centre, half, at_home = _stacked(bases)
    values = _functions((np.clip(positions, low, high) - centre) / half, positions, *bases[0].order)
    return np.ascontiguousarray((values - at_home).transpose(0, 2, 1))


def _functions(scaled: FloatArray, positions: FloatArray, degree: int, harmonics: int) -> FloatArray:
    """(..., degree + 2 harmonics): P1 .. Pn of scaled positions (...), cos a, sin a, cos 2a .. of positions in deg."""
    polynomials = legendre.legvander(scaled, degree)[..., 1:]
    if not harmonics:
        return np.asarray(polynomials)
    angles = np.deg2rad(positions)[..., np.newaxis] * np.arange(1.0, harmonics + 1.0)
    waves = np.stack([np.cos(angles), np.sin(angles)], axis=-1).reshape(*positions.shape, 2 * harmonics)
    return np.concatenate([polynomials, waves], axis=-1)


@lru_cache(maxsize=64)
def _stacked(bases: tuple[LegendreBasis, ...]) -> tuple[FloatArray, ...]:
    """low, high, centre and half of the range, (k, 1), and the values at home, (k, 1, count)."""
    of_range = [(one.low, one.high, *one._centre_and_half()) for one in bases]
    return (*np.array(of_range).T[:, :, np.newaxis], np.array([_at_home(one) for one in bases]))


@dataclass(frozen=True)
class HatBasis:
    """Hat functions of the positions of a table, (n,) rising, mm or deg; beyond the ends the last one stays 1."""

    positions: tuple[float, ...]

    def __call__(self, positions: FloatArray) -> FloatArray:
        """(n, m): the basis functions at positions (m,)."""
        nodes = np.array(self.positions)
        if nodes.size == 1:
            return np.ones((1, positions.size))
        below = np.clip(np.searchsorted(nodes, positions, side="right") - 1, 0, nodes.size - 2)
        share = np.clip((positions - nodes[below]) / (nodes[below + 1] - nodes[below]), 0.0, 1.0)
        found, at = np.zeros((nodes.size, positions.size)), np.arange(positions.size)
        found[below, at], found[below + 1, at] = 1.0 - share, share
        return found

    @property
    def count(self) -> int:
        """How many functions there are."""
        return len(self.positions)


@dataclass(frozen=True)
class PowerBasis:
    """Powers of the position in mm or deg, as a polynomial curve has them."""

    powers: tuple[int, ...]

    def __call__(self, positions: FloatArray) -> FloatArray:
        """(n_powers, m): the basis functions at positions (m,)."""
        return np.array([positions**power for power in self.powers]).reshape(self.count, positions.size)

    @property
    def count(self) -> int:
        """How many functions there are."""
        return len(self.powers)


Basis = LegendreBasis | HatBasis | PowerBasis


def unmeasured_basis(travel: Mapping[str, tuple[float, float]], component: ErrorName) -> LegendreBasis:
    """Functions that stand for a component of which nothing is known; travel: of every axis, mm or deg."""
    return axis_basis(travel[component.axis], UNMEASURED_DEGREE)


def axis_basis(travel: tuple[float, float], degree: int) -> LegendreBasis:
    """The basis of an axis: over its travel, position 0 included."""
    return LegendreBasis(low=min(travel[0], 0.0), high=max(travel[1], 0.0), degree=degree)


def travel_basis(travel: tuple[float, float], degree: int, harmonics: int = 0) -> LegendreBasis:
    """Over the travel, zero at home: at 0, or at the end of the travel next to it."""
    low, high = travel
    home = min(max(0.0, low), high)
    return LegendreBasis(low=low, high=high, degree=degree, home=home, harmonics=harmonics)


@lru_cache(maxsize=64)
def _at_home(basis: LegendreBasis) -> FloatArray:
    """(1, count)"""
    home = np.array([basis.home])
    return _functions(basis._scaled(home), home, *basis.order)


@lru_cache(maxsize=64)
def _powers(centre: float, half: float, degree: int) -> FloatArray:
    scaled = [Fraction(-centre) / Fraction(half), 1 / Fraction(half)]
    before, current = [Fraction(1)], scaled
    found = [current]
    for k in range(1, degree):
        following = _sum(_times(_product(scaled, current), Fraction(2 * k + 1, k + 1)), before, Fraction(-k, k + 1))
        before, current = current, following
        found.append(current)
    matrix = np.zeros((degree, degree))
    for row, coefficients in zip(matrix, found, strict=False):
        row[: len(coefficients) - 1] = [float(c) for c in coefficients[1:]]
    matrix.setflags(write=False)  # shared by all who ask
    return matrix


def _product(a: list[Fraction], b: list[Fraction]) -> list[Fraction]:
    found = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, left in enumerate(a):
        for j, right in enumerate(b):
            found[i + j] += left * right
    return found


def _times(a: list[Fraction], factor: Fraction) -> list[Fraction]:
    return [factor * part for part in a]


def _sum(a: list[Fraction], b: list[Fraction], factor: Fraction) -> list[Fraction]:
    return [part + (factor * b[i] if i < len(b) else 0) for i, part in enumerate(a)]
