"""The places of a program: every one near a kept position, corrections never lost, memory bounded."""

import numpy as np
import pytest

from tests.machines import ROOT
from trueaxis.compensation.visited import MOST_CELLS, Visited
from trueaxis.model.model import MachineModel, load_model


@pytest.fixture(scope="module")
def model() -> MachineModel:
    return load_model(ROOT / "machines" / "dmu60p.toml", None, ROOT / "generated", backend="numpy")


@pytest.mark.parametrize("batches", [1, 7])
def test_every_position_is_near_a_kept_one_with_its_correction(model: MachineModel, batches: int) -> None:
    source = np.random.default_rng(3)
    travel = np.array([model.travel[axis] for axis in model.axes])
    positions = source.uniform(travel[:, :1], travel[:, 1:], (3, 4000))
    moved = source.normal(0.0, 0.01, (3, 4000))
    corrections = np.sqrt((moved**2).sum(axis=0))
    unknown = np.full((3, 4000), np.nan)
    visited = Visited(model, np.zeros((3, 1)))
    for part in np.array_split(np.arange(4000), batches):
        visited.add(unknown[:, part], positions[:, part], moved[:, part])
    cell = (travel[:, 1] - travel[:, 0]) / 27.0
    apart = np.abs(positions[:, :, np.newaxis] - visited.positions[:, np.newaxis, :]) / cell[:, np.newaxis, np.newaxis]
    near = (apart <= 1.0 + 1e-9).all(axis=0)
    assert near.any(axis=1).all()
    assert visited.corrections.max() == pytest.approx(corrections.max(), rel=1e-12)
    assert (np.where(near, visited.corrections, 0.0).max(axis=1) >= corrections * (1.0 - 1e-12)).all()
    np.testing.assert_array_equal(visited.ends, np.stack([positions.min(axis=1), positions.max(axis=1)], axis=1))
    assert visited.positions.shape[1] <= MOST_CELLS


def test_nothing_visited_is_nothing(model: MachineModel) -> None:
    visited = Visited(model, np.zeros((3, 1)))
    visited.add(np.zeros((3, 0)), np.zeros((3, 0)), np.zeros((3, 0)))
    assert visited.positions.shape == (3, 0)
    assert visited.ends.shape == (3, 0)


def test_a_long_motion_passes_through_every_cell_of_its_way(model: MachineModel) -> None:
    visited = Visited(model, np.zeros((3, 1)))
    visited.add(np.array([[0.0], [0.0], [0.0]]), np.array([[540.0], [0.0], [0.0]]), np.zeros((3, 1)))
    assert sorted(np.floor(visited.positions[0] / 20.0 - 1e-9).clip(0)) == list(range(27))
    samples = visited.samples([[250.0], [], []])
    along = np.round(np.unique(samples[0]), 6)
    assert {*np.round(np.linspace(0.0, 540.0, 28), 6), 250.0} <= set(along)
    assert np.diff(along).max() < 1.0  # nothing of the way is between the samples
