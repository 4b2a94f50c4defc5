"""Error curves: one motion error as a function of its axis position, evaluated on arrays."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from trueaxis.model.bases import HatBasis, LegendreBasis, PowerBasis, basis_values

FloatArray = npt.NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class PolynomialCurve:
    """sum(coefficients[i] * s**powers[i]) of the commanded axis position s (mm, deg); value in mm or rad.

    powers: distinct whole numbers >= 0; u: standard uncertainty per coefficient, NaN where unknown, None when not
    given; u_readings, u_prior: its parts by the readings and by the prior, as u; measured: lowest and highest position
    that was measured, None where that is not known.
    """

    powers: tuple[int, ...]
    coefficients: tuple[float, ...]
    u: tuple[float, ...] | None = None
    measured: tuple[float, float] | None = None
    u_readings: tuple[float, ...] | None = None
    u_prior: tuple[float, ...] | None = None

    def __call__(self, positions: FloatArray) -> FloatArray:
        """Values, of the shape of `positions`; Horner's scheme, so that no power of s is ever formed in full."""
        falling = sorted(zip(self.powers, self.coefficients, strict=True), reverse=True)
        lower = [*(power for power, _ in falling[1:]), 0]
        values = np.zeros_like(positions, dtype=np.float64)
        for index, (power, coefficient) in enumerate(falling):
            values += coefficient
            for _ in range(power - lower[index]):
                values *= positions
        return values


@dataclass(frozen=True, slots=True)
class TableCurve:
    """Linear interpolation between (position, value) pairs; beyond the ends the end values hold.

    positions: strictly increasing (mm, deg); values: mm or rad; u: standard uncertainty per value, NaN where
    unknown, None when not given.
    """

    positions: tuple[float, ...]
    values: tuple[float, ...]
    u: tuple[float, ...] | None = None

    def __call__(self, positions: FloatArray) -> FloatArray:
        """Values, of the shape of `positions`."""
        return np.interp(positions, self.positions, self.values)

    @property
    def measured(self) -> tuple[float, float]:
        """Lowest and highest position that was measured: the ends of the table."""
        return self.positions[0], self.positions[-1]


@dataclass(frozen=True, slots=True, kw_only=True)
class LegendreCurve:
    """Sum of Legendre polynomials over the travel of an axis, and of harmonics where it turns round, zero at its home;
    beyond the travel the end values of the polynomials hold.

    basis: of the axis position, mm or deg; coefficients: of its functions, mm or rad; u, u_readings, u_prior, measured:
    as of a polynomial.
    """

    basis: LegendreBasis
    coefficients: tuple[float, ...]
    u: tuple[float, ...] | None = None
    measured: tuple[float, float] | None = None
    u_readings: tuple[float, ...] | None = None
    u_prior: tuple[float, ...] | None = None

    def __call__(self, positions: FloatArray) -> FloatArray:
        """Values, of the shape of `positions`."""
        at = np.asarray(positions, dtype=np.float64)
        return (np.array(self.coefficients) @ self.basis(at.ravel())).reshape(at.shape)


Curve = PolynomialCurve | TableCurve | LegendreCurve


def basis_of_curve(curve: Curve) -> HatBasis | PowerBasis | LegendreBasis:
    """The functions whose coefficients are the numbers of the curve."""
    match curve:
        case PolynomialCurve():
            return PowerBasis(curve.powers)
        case TableCurve():
            return HatBasis(curve.positions)
        case LegendreCurve():
            return curve.basis


def polynomial_of(curve: LegendreCurve) -> PolynomialCurve:
    """The same within the travel in plain powers; beyond it, the polynomial goes on. Of a curve without harmonics."""
    powers = np.array(curve.coefficients) @ curve.basis.powers
    at_home = -float(powers @ curve.basis.home ** np.arange(1.0, powers.size + 1.0))
    return PolynomialCurve(
        powers=tuple(range(powers.size + 1)), coefficients=(at_home, *powers.tolist()), u=None, measured=curve.measured
    )


def evaluate_components(
    curves: Mapping[str, Curve],
    components: Sequence[str],
    axis_of_component: Sequence[int],
    positions: FloatArray,
) -> FloatArray:
    """Values of the motion errors at axis positions.

    axis_of_component: for each component the row of `positions` it depends on; positions: (n_axes, n), mm or deg.
    Returns (n_components, n), mm or rad; components without a curve are zero.
    """
    values = np.zeros((len(components), positions.shape[1]))
    polynomials: dict[int, list[int]] = {}
    legendre: dict[tuple[int, LegendreBasis], list[int]] = {}
    for row, (component, axis) in enumerate(zip(components, axis_of_component, strict=True)):
        curve = curves.get(component)
        if isinstance(curve, PolynomialCurve):
            polynomials.setdefault(axis, []).append(row)
        elif isinstance(curve, LegendreCurve):
            legendre.setdefault((axis, curve.basis), []).append(row)
        elif curve is not None:
            values[row] = curve(positions[axis])
    for axis, rows in polynomials.items():
        # those of one axis at once: on few positions a call costs more than its arithmetic
        found = np.zeros((len(rows), positions.shape[1]))
        for coefficients in _falling(tuple(curves[components[row]] for row in rows)):
            found *= positions[axis]
            found += coefficients
        values[rows] = found
    for order in {basis.order for _, basis in legendre}:
        alike = {key: rows for key, rows in legendre.items() if key[1].order == order}
        each = basis_values(tuple(basis for _, basis in alike), positions[[axis for axis, _ in alike]])
        for rows, found in zip(alike.values(), each, strict=True):
            values[rows] = _stacked(tuple(curves[components[row]] for row in rows)) @ found
    return values


@lru_cache(maxsize=64)
def _stacked(curves: tuple[LegendreCurve, ...]) -> FloatArray:
    """(n_curves, count): their coefficients."""
    return np.array([one.coefficients for one in curves])


@lru_cache(maxsize=64)
def _falling(curves: tuple[PolynomialCurve, ...]) -> FloatArray:
    """(degree + 1, n_curves, 1): coefficients of each power, the highest first."""
    found = np.zeros((1 + max((power for one in curves for power in one.powers), default=0), len(curves), 1))
    for place, one in enumerate(curves):
        found[[-1 - power for power in one.powers], place, 0] = one.coefficients
    return found


def pack_polynomials(curves: Mapping[str, Curve], components: Sequence[str], degree: int) -> FloatArray | None:
    """Coefficients of the powers 1..degree, (n_components, degree), for kernels of that one fixed form.

    None when a curve has another form: a table, a constant term, or a power above `degree`.
    """
    packed = np.zeros((len(components), degree))
    for row, component in enumerate(components):
        curve = curves.get(component)
        if curve is None:
            continue
        if not isinstance(curve, PolynomialCurve):
            return None
        for power, coefficient in zip(curve.powers, curve.coefficients, strict=True):
            if 1 <= power <= degree:
                packed[row, power - 1] = coefficient
            elif coefficient != 0.0:
                return None
    return packed
