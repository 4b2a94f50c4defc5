"""Sect. 3.6 carried out as printed on machines whose squareness is known, to see what it finds."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .numeric import published_pitch
from .printed.tables import SQUARENESS_VALUES

TRAVEL = {"x": 540.0, "y": 700.0, "z": 600.0}
"""Sect. 4.1, mm."""
Curves = Mapping[str, Callable[[float], float]]
"""Angle (rad) over position (mm) for the pairs yx, zx, xy, zy, yz, xz of Eq. (39); absent is zero."""


def slope_as_printed(curve: Callable[[float], float], travel: float, samples: int) -> float:
    """c_uv1: Eq. (39) as printed, then the least-squares line, for which Eq. (41) stands once it is mended."""
    at = np.linspace(0.0, travel, samples + 1)[1:]
    offset: NDArray[np.float64] = np.cumsum([curve(float(v)) * v for v in at])
    return float(np.polyfit(at, offset, 1)[0])


def squareness_as_printed(curves: Curves, samples: int) -> dict[str, float]:
    """Eq. (43) as printed, rad."""
    c = {
        pair: slope_as_printed(curves[pair], TRAVEL[pair[1]], samples) if pair in curves else 0.0
        for pair in ("yx", "zx", "xy", "zy", "yz", "xz")
    }
    x, y, z = (np.array(v) for v in ((1, c["yx"], c["zx"]), (c["xy"], 1, c["zy"]), (c["xz"], c["yz"], 1)))

    def angle(a: NDArray[np.float64], b: NDArray[np.float64]) -> float:
        return float(np.arccos(a @ b / np.linalg.norm(a) / np.linalg.norm(b)))

    return {
        "epsilon_xy": np.pi / 2 - angle(x, y),
        "epsilon_xz": angle(x, z) - np.pi / 2,
        "epsilon_yz": angle(y, z) - np.pi / 2,
    }


@dataclass(frozen=True, slots=True)
class Case:
    """A machine, its true squareness and what Sect. 3.6 finds, microradians."""

    machine: str
    parameter: str
    truth: float
    found: float


def _constant(value: float) -> Callable[[float], float]:
    return lambda _: value


def cases() -> tuple[Case, ...]:
    """True squareness missed, square machines accused, and one curve sampled at two densities."""
    straight = squareness_as_printed({}, 18)
    turned = squareness_as_printed({"yx": _constant(10e-6), "xy": _constant(10e-6)}, 18)
    pitch = {samples: squareness_as_printed({"zx": published_pitch}, samples) for samples in (18, 36)}
    micro = 1e6
    result = [
        Case("Table 6's squareness, no pitch, no yaw", name, SQUARENESS_VALUES[name] * micro, straight[name] * micro)
        for name in SQUARENESS_VALUES
    ]
    result.append(
        Case("square, X and Y carriages both turned by 10 µrad", "epsilon_xy", 0.0, turned["epsilon_xy"] * micro)
    )
    result += [
        Case(
            f"square, X pitch of Eq. (52), {samples} samples ({540 // samples} mm)",
            "epsilon_xz",
            0.0,
            pitch[samples]["epsilon_xz"] * micro,
        )
        for samples in (18, 36)
    ]
    return tuple(result)
