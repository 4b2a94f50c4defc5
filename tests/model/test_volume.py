"""Points in the volume: no grid, and the largest uncertainty is not missed between the targets of a plan."""

from itertools import product

import numpy as np
import pytest

from tests.identification.random_plans import MACHINES, drawn
from trueaxis.estimation.expected import expected
from trueaxis.estimation.gauge import covariance_of
from trueaxis.model.covariance import Covariance
from trueaxis.model.extent import travel_positions, uncertainty_extent
from trueaxis.model.model import MachineModel, home_of
from trueaxis.model.uncertainty import tool_uncertainty
from trueaxis.model.volume import quasi_random

TOOL = np.zeros((3, 1))
TARGETS = 12  # along each axis
NOISE = 1e-6  # mm
SHARE = 0.9  # of the largest u of as many random points


@pytest.mark.parametrize("dimensions", [1, 3, 5])
def test_points_fill_every_coordinate(dimensions: int) -> None:
    for count in (50, 2000):
        apart = np.diff(np.sort(quasi_random(dimensions, count), axis=1), axis=1, prepend=0.0, append=1.0)
        assert (apart > 0.0).all()
        assert apart.max() < 10.0 / count  # of evenly spread ones 1 / count


def measured_at_targets(rng: np.random.Generator, name: str) -> tuple[MachineModel, Covariance]:
    """A machine of which some components are read at targets, evenly apart, the others nowhere."""
    one = drawn(rng, name, 3, 0, 5, 1.0)
    found = expected(one.model, one.observed, one.model.errors, dict.fromkeys(range(3), 1e-3))
    layout, scale = found.layout, found.scale[: found.layout.of_machine]
    scale[int(layout.offsets[-1]) :] *= 1e-6  # location errors are known
    rows = np.zeros((0, scale.size))
    for place, basis in enumerate(layout.bases):
        first = int(layout.offsets[place])
        part = np.zeros((TARGETS, scale.size))
        part[:, first : first + basis.degree] = basis(np.linspace(basis.low, basis.high, TARGETS)).T
        rows = np.vstack([rows, part])
    _, values, right = np.linalg.svd(rows * scale / NOISE)
    told = np.concatenate([values, np.zeros(scale.size - values.size)])
    spread = np.zeros((layout.count, scale.size))
    spread[: scale.size] = scale[:, np.newaxis] * right.T / np.hypot(1.0, told)
    return one.model, covariance_of(layout, spread)


@pytest.mark.parametrize("seed", range(4))
def test_the_largest_u_is_found_between_few_targets(seed: int) -> None:
    """1 um was said where 14 um were: a regular grid had hit the targets."""
    rng = np.random.default_rng([41, seed])
    model, covariance = measured_at_targets(rng, MACHINES[int(rng.integers(4))])

    def largest(positions: np.ndarray) -> float:
        return float(tool_uncertainty(model, covariance, positions, TOOL, datum=home_of(model)).u.max())

    inside = largest(np.array([rng.uniform(*model.travel[axis], 2000) for axis in model.axes]))
    grid = np.array(list(product(*(np.linspace(*model.travel[axis], TARGETS) for axis in model.axes)))).T
    assert largest(grid) < 0.5 * inside
    assert uncertainty_extent(model, covariance, travel_positions(model, covariance), TOOL).largest_u > SHARE * inside
