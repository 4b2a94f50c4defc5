"""G, G(b), F and D against their definitions, searched directly."""

import numpy as np
import pytest
from scipy.optimize import minimize

from tests.evaluation.iso230_4.path import Mill, turn
from trueaxis.evaluation.circular_test import Arc, CircularTest, circular_figures

MILL = Mill(squareness=3e-5, scale=(2e-5, 0.0), reversal=(-4e-3, -2e-3), centre=(0.03, -0.02), bar=-0.006)


def test_figures() -> None:
    draw = np.random.default_rng(1)
    arcs = []
    for sense in (1, -1):
        angle = turn(sense, 300)
        reading = MILL.read(angle, sense, 100.0, 500.0) + 3e-4 * draw.standard_normal(300)
        arcs.append(Arc(id=str(sense), sense=sense, angle=angle, deviation=reading))
    found = circular_figures(CircularTest(plane=("X", "Y"), radius=100.0, feed=None, arcs=tuple(arcs)))
    for arc, one in zip(arcs, found.arcs, strict=True):
        u, v = (100.0 + arc.deviation) * (np.cos(arc.angle), np.sin(arc.angle))

        def spread(centre: np.ndarray, u: np.ndarray = u, v: np.ndarray = v) -> float:
            return float(np.ptp(np.hypot(u - centre[0], v - centre[1])))

        best = minimize(spread, one.centre, method="Nelder-Mead", options={"xatol": 1e-9, "fatol": 1e-9})
        assert one.zone == pytest.approx(best.fun, abs=2e-5)
        assert one.zone <= one.G == pytest.approx(spread(np.array(one.centre)), abs=2e-5)
        assert one.F_max - one.F_min == pytest.approx(one.G)
        # the reading is the actual length less the nominal one: a bar that is longer by -6 um reads 6 um more
        assert 0.5 * (one.F_max + one.F_min) == pytest.approx(0.006, abs=0.004)
    assert found.G_b is not None
    assert found.G_b >= max(one.G for one in found.arcs) - 1e-4
    assert pytest.approx(0.006 + 100.0 * 1e-5, abs=1e-3) == found.D


def test_one_sense_has_no_bidirectional_figure() -> None:
    angle = turn(-1, 90)
    arc = Arc(id="a", sense=-1, angle=angle, deviation=MILL.read(angle, -1, 100.0, 500.0))
    assert circular_figures(CircularTest(plane=("Y", "Z"), radius=100.0, feed=None, arcs=(arc,))).G_b is None
