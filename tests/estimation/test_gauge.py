"""The convention for straightness and squareness moves no point of the tool against home, whatever the machine."""

from pathlib import Path

import numpy as np
import pytest

from trueaxis.estimation.gauge import covariance_of, levelling
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.observations import Observations
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import load_model
from trueaxis.runtime.uncertainty import derivative, home_of

ROOT = Path(__file__).parents[2]
MACHINES = sorted(path.stem for path in (ROOT / "machines").glob("*.toml"))


@pytest.mark.parametrize("name", MACHINES)
def test_it_moves_no_point_of_the_tool(name: str) -> None:
    model = load_model(ROOT / "machines" / f"{name}.toml", None, ROOT / "generated")
    nothing = Observations("", (), np.zeros(0, dtype=np.int64), np.zeros((len(model.axes), 0)), np.zeros(0))
    known = ErrorValues(model.name, dict.fromkeys(model.dimensions, 50.0))
    layout = layout_of(model.with_values(known), nothing, known)
    draw = np.random.default_rng(5)
    positions = np.array([draw.uniform(*model.travel[axis], 30) for axis in model.axes])
    change = levelling(layout) - np.eye(layout.count)
    covariance = covariance_of(layout, np.zeros((layout.count, 0)))
    home = home_of(layout.model)
    for tool in draw.uniform(-200.0, 200.0, (4, 3, 1)):
        moved = derivative(layout.model, covariance, positions, tool) - derivative(layout.model, covariance, home, tool)
        largest = np.abs(moved * layout.sizes[: layout.of_machine, np.newaxis]).max()
        off = np.einsum("ijn,jk->ikn", moved, change * layout.sizes)
        assert np.abs(off).max() < 1e-9 * largest
