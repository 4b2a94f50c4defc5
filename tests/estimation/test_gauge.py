"""The convention for straightness and squareness moves no point of the tool against home, whatever the machine."""

from pathlib import Path

import numpy as np
import pytest

from trueaxis.estimation.curve_prior import CurvePrior
from trueaxis.estimation.gauge import covariance_of, exactly_level, levelling
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.observations import Observations
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import home_of, load_model
from trueaxis.model.uncertainty import derivative

ROOT = Path(__file__).parents[2]
MACHINES = sorted(path.stem for path in (ROOT / "machines").glob("*.toml"))


@pytest.mark.parametrize("name", MACHINES)
def test_it_moves_no_point_of_the_tool(name: str) -> None:
    model = load_model(ROOT / "machines" / f"{name}.toml", None, ROOT / "generated")
    nothing = Observations(
        source="",
        runs=(),
        run=np.zeros(0, dtype=np.int64),
        positions=np.zeros((len(model.axes), 0)),
        reading=np.zeros(0),
    )
    known = ErrorValues(machine=model.name, parameters=dict.fromkeys(model.dimensions, 50.0))
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


@pytest.mark.parametrize("name", MACHINES)
def test_the_tool_tip_moves_as_before_on_the_exact_model(name: str) -> None:
    """Of a machine drawn from the prior. The linear map alone is off by 0.5 to 30 nm."""
    model = load_model(ROOT / "machines" / f"{name}.toml", None, ROOT / "generated")
    nothing = Observations(
        source="",
        runs=(),
        run=np.zeros(0, dtype=np.int64),
        positions=np.zeros((len(model.axes), 0)),
        reading=np.zeros(0),
    )
    known = ErrorValues(machine=model.name, parameters=dict.fromkeys(model.dimensions, 50.0))
    layout = layout_of(model.with_values(known), nothing, known)
    draw = np.random.default_rng(7)
    weights = [np.exp(CurvePrior(basis).log_weights(np.zeros(2))[0]) for basis in layout.bases]
    scale = layout.sizes * np.concatenate([*weights, np.ones(len(layout.locations))])
    unknowns = scale * draw.standard_normal(layout.count)
    linear = levelling(layout) @ unknowns
    exact = exactly_level(layout, layout.values(unknowns, known), known, linear, scale)
    np.testing.assert_array_equal(exact[layout.offsets[:-1]] == 0.0, linear[layout.offsets[:-1]] == 0.0)
    positions = np.array([draw.uniform(*model.travel[axis], 100) for axis in model.axes])
    home, tip = home_of(model), np.zeros((3, 1))

    def from_home(values: np.ndarray) -> np.ndarray:
        at = model.with_values(layout.values(values, known))
        return at.deviation(positions, tip) - at.deviation(home, tip)

    def off(values: np.ndarray) -> float:
        """Largest, mm, beside the rotation of the workpiece that fits best."""
        moved = from_home(values) - from_home(unknowns)
        x, y, z = model.ideal(positions, tip) - model.ideal(home, tip)
        zero = np.zeros(x.size)
        crossed = np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]])  # axes of rotation, coordinates, positions
        turned, rows = crossed.reshape(3, -1).T, moved.ravel()
        return float(np.abs(rows - turned @ np.linalg.lstsq(turned, rows, rcond=None)[0]).max())

    assert off(exact) < (1e-10 if len(model.axes) == 3 else 5e-7)
    assert off(exact) <= 0.2 * off(linear)
