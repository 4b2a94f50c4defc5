"""Positioning tests made up for tests, and their .dat text."""

import numpy as np

from trueaxis.evaluation.positioning_test import PositioningTest


def made_up(m: int = 4, n: int = 3, seed: int = 1) -> PositioningTest:
    """An axis of 100 mm with a scale error, a periodic error, 8 um lost motion and 1 um noise."""
    rng = np.random.default_rng(seed)
    targets = np.round(np.linspace(0.0, 100.0, m) + rng.uniform(-2.0, 2.0, m), 3)
    mean = targets + 1e-4 * targets + 0.003 * np.sin(targets)
    positive = mean[:, None] - 0.004 + rng.normal(0.0, 0.001, (m, n))
    negative = mean[:, None] + 0.004 + rng.normal(0.0, 0.001, (m, n))
    return PositioningTest(targets, positive, negative)


def dat_text(test: PositioningTest) -> str:
    m, n = test.positive.shape
    lines = [
        "TEST_DATA=# made up",
        "# comment",
        "REF_PV=SENSOR:Pos",
        "UNIT=mm",
        f"CYCLES={n}",
        f"POSITIONS={m}",
        "DEC=5",
    ]
    lines += [f"TGT_DATA[{i + 1}]={test.targets[i]!r}" for i in range(m)]
    for name, grid in (("FWD", test.positive), ("BWD", test.negative)):
        lines += [f"REF_DATA_{name}[{i + 1},{j + 1}]={grid[i, j]!r}" for j in range(n) for i in range(m)]
    return "\n".join(lines).replace("np.float64(", "").replace(")", "") + "\n  \n"
