"""A laser along the diagonals of a machine whose axes point where exact rotations put them: nothing of the package."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

SIGNS = {"p": 1.0, "n": -1.0}


@dataclass(frozen=True, kw_only=True)
class Skewed:
    """xy, xz, yz: by how much the angles between positive axes exceed 90 deg, rad, exactly; scale: of X, Y, Z; lost:
    approached positively less negatively, of X, Y, Z, mm.
    """

    xy: float = 0.0
    xz: float = 0.0
    yz: float = 0.0
    scale: tuple[float, float, float] = (0.0, 0.0, 0.0)
    lost: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def axes(self) -> np.ndarray:
        """(3, 3): unit vectors of the axes in the rows."""
        x = np.array([1.0, 0.0, 0.0])
        y = Rotation.from_rotvec([0.0, 0.0, self.xy]).apply([0.0, 1.0, 0.0])  # on from x: the angle grows
        # z by the cosines of its angles to x and to y
        along_x = -np.sin(self.xz)
        along_y = (-np.sin(self.yz) - along_x * y[0]) / y[1]
        return np.array([x, y, [along_x, along_y, np.sqrt(1.0 - along_x**2 - along_y**2)]])

    def measured(self, name: str, lengths: np.ndarray, targets: np.ndarray, way: int) -> np.ndarray:
        """(m,), mm: the way of the reflector, since target 0, along a laser that is aligned to where the machine goes;
        way: +1 where the targets were approached growing.
        """
        sides = np.array([SIGNS[letter] for letter in name]) * lengths
        scaled, axes = sides * (1.0 + np.array(self.scale[: sides.size])), self.axes()[: sides.size]
        behind = 0.5 * way * np.sign(sides) * np.array(self.lost[: sides.size])
        beam = scaled @ axes
        at = (targets[:, np.newaxis] / np.linalg.norm(sides) * scaled + behind) @ axes
        return np.asarray(at @ beam / np.linalg.norm(beam))


def table(path: Path, readings: dict[int, np.ndarray], targets: np.ndarray, run: str = "") -> Path:
    """A file of one diagonal, or with a column run; readings: (m, cycles) by direction."""
    rows = [
        f"{target!r},{cycle + 1},{way},{float(values[i, cycle])!r}" + (f",{run}" if run else "")
        for way, values in readings.items()
        for i, target in enumerate(targets.tolist())
        for cycle in range(values.shape[1])
    ]
    path.write_text("\n".join([f"target,cycle,direction,measured{',run' if run else ''}", *rows]) + "\n")
    return path
