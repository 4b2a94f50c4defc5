"""What rounding NC words to a resolution does to E of Eq. (6), by the direction of the ball bar.

    python benchmarks/word_rounding.py

Draws positions uniformly in the cell of the word lattice (seeded), rounds them in three ways and prints mean, standard
deviation and maximum of |E| in micrometres for words of 1 um. It knows nothing of trueaxis: it is the bound that
rounding sets, whatever the machine and its errors.
"""

import numpy as np
from numpy.typing import NDArray

DRAWS = 20000
FloatArray = NDArray[np.float64]


def unit_directions(name: str, rng: np.random.Generator) -> FloatArray:
    """(DRAWS, 3) bar directions."""
    fixed = {"along an axis": (1, 0, 0), "across a face": (1, 1, 0), "space diagonal": (1, 1, 1)}
    vectors = np.tile(fixed[name], (DRAWS, 1)) if name in fixed else rng.normal(size=(DRAWS, 3))
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))


def least_along(position: FloatArray, direction: FloatArray, spacing: float) -> FloatArray:
    """|E| of the best point of a lattice of that spacing within 1 (a word's step) of each position."""
    reach = np.arange(-2.0 / spacing, 2.0 / spacing + 1) * spacing
    lattice = np.stack(np.meshgrid(reach, reach, reach), axis=-1).reshape(-1, 3)
    best = np.empty(len(position))
    for index, (at, along) in enumerate(zip(position, direction, strict=True)):
        off = lattice - at
        best[index] = np.abs(off[(off * off).sum(axis=1) <= 1.0] @ along).min()
    return best


def main() -> None:
    """Print the table."""
    print(f"{'bar direction':16s}{'words':34s}{'mean':>8s}{'sd':>8s}{'max':>8s}   um")
    for name in ("along an axis", "across a face", "space diagonal", "any direction"):
        rng = np.random.default_rng(1)
        direction = unit_directions(name, rng)
        position = rng.uniform(-0.5, 0.5, (DRAWS, 3))
        rows = {
            "nearest": np.abs((position * direction).sum(axis=1)),
            "best within one step": least_along(position, direction, 1.0),
            "best middle of a block": least_along(position, direction, 0.5),
        }
        for words, e in rows.items():
            print(f"{name:16s}{words:34s}{e.mean():8.3f}{e.std():8.3f}{e.max():8.3f}")
    print(f"{'':16s}{'the paper, iterative (Sect. 5.2)':34s}{0.244:8.3f}{0.119:8.3f}{0.530:8.3f}")


if __name__ == "__main__":
    main()
