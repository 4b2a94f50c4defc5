"""A machine of matrices and polynomials written down independently of the package's derivation."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
Curves = Mapping[str, Callable[[FloatArray], FloatArray]]


def motion(errors: Mapping[str, FloatArray], axis: str, shift: FloatArray) -> FloatArray:
    """(n, 4, 4): shift of a slide followed by its motion error, Eq. (1)."""
    n = shift.shape[1]
    ideal = np.tile(np.eye(4), (n, 1, 1))
    ideal[:, :3, 3] = shift.T
    e = {key: errors.get(f"E{key}{axis}", np.zeros(n)) for key in "XYZABC"}
    error = np.tile(np.eye(4), (n, 1, 1))
    error[:, 0, 1], error[:, 0, 2], error[:, 1, 2] = -e["C"], e["B"], -e["A"]
    error[:, 1, 0], error[:, 2, 0], error[:, 2, 1] = e["C"], -e["B"], e["A"]
    error[:, 0, 3], error[:, 1, 3], error[:, 2, 3] = e["X"], e["Y"], e["Z"]
    return ideal @ error


def small(a: float = 0.0, b: float = 0.0, c: float = 0.0) -> FloatArray:
    return np.array([[1.0, -c, b, 0.0], [c, 1.0, -a, 0.0], [-b, a, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]])


@dataclass
class XyzMachine:
    """Workpiece on Y on bed, tool on Z on X on bed; curves take axis positions in mm, values mm and rad."""

    curves: Curves = field(default_factory=dict)
    squareness: tuple[float, float, float] = (0.0, 0.0, 0.0)  # eps_xy, eps_yz, eps_xz
    axes: tuple[str, ...] = ("X", "Y", "Z")
    travel: Mapping[str, tuple[float, float]] = field(
        default_factory=lambda: {"X": (-1000.0, 1000.0), "Y": (-1000.0, 1000.0), "Z": (-1000.0, 1000.0)}
    )

    def ideal(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        x, y, z = positions
        return np.asarray(np.stack([x, -y, z]) + point)

    def actual(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        return self.actual_with(positions, point, {})

    def actual_with(self, positions: FloatArray, point: FloatArray, further: Mapping[str, FloatArray]) -> FloatArray:
        """further: component errors (n,) that do not depend on the position of their axis alone."""
        at = dict(zip("XYZ", positions, strict=True))
        errors = {name: curve(at[name[2]]) for name, curve in self.curves.items()}
        for name, values in further.items():
            errors[name] = errors.get(name, np.zeros_like(values)) + values
        zero = np.zeros_like(at["X"])
        xy, yz, xz = self.squareness
        workpiece = motion(errors, "Y", np.stack([zero, at["Y"], zero]))
        x = small(c=xy) @ motion(errors, "X", np.stack([at["X"], zero, zero]))
        tool = x @ small(a=yz, b=xz) @ motion(errors, "Z", np.stack([zero, zero, at["Z"]]))
        p = np.concatenate([np.broadcast_to(point, positions.shape), np.ones((1, positions.shape[1]))]).T[:, :, None]
        return np.linalg.solve(workpiece, tool @ p)[:, :3, 0].T

    def deviation(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        return np.asarray(self.actual(positions, point) - self.ideal(positions, point))

    def correction(self, positions: FloatArray, deviation: FloatArray) -> FloatArray:  # noqa: ARG002
        return np.asarray(deviation * np.array([[1.0], [-1.0], [1.0]]))

    def orientation_ideal(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        return self.ideal(positions, direction) - self.ideal(positions, np.zeros((3, 1)))

    def orientation_deviation(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        return self.deviation(positions, direction) - self.deviation(positions, np.zeros((3, 1)))


def polynomial(*coefficients: float) -> Callable[[FloatArray], FloatArray]:
    """c1 u + c2 u^2 + ... in u = position / 500."""

    def value(position: FloatArray) -> FloatArray:
        return np.asarray(np.polynomial.polynomial.polyval(position / 500.0, (0.0, *coefficients)))

    return value


def paper_sized(scale: float = 1.0) -> XyzMachine:
    """Errors of the size of the paper's machine: some 10 um over the travel, some 10 urad."""
    random = np.random.default_rng(7)
    curves = {}
    for axis in "XYZ":
        for kind in "XYZABC":
            size = 0.02 if kind in "XYZ" else 3e-5
            curves[f"E{kind}{axis}"] = polynomial(*(scale * size * random.uniform(-1.0, 1.0, 4)))
    return XyzMachine(curves, (5e-5 * scale, -3e-5 * scale, 4e-5 * scale))
