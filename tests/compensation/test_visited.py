"""The places of a program: every one near a kept position, corrections never lost, memory bounded."""

from types import SimpleNamespace

import numpy as np
import pytest

from tests.machines import ROOT
from trueaxis.compensation.visited import FINEST, MOST_CELLS, Visited
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


def test_it_knows_where_it_first_came_to_by_feed(model: MachineModel) -> None:
    visited, unknown = Visited(model, np.zeros((3, 1))), np.full((3, 2), np.nan)
    visited.add(unknown, np.array([[1.0, 2.0], [0.0, 0.0], [0.0, 0.0]]), np.zeros((3, 2)), np.array([False, False]))
    assert visited.first_fed is None
    visited.add(unknown, np.array([[3.0, 4.0], [0.0, 0.0], [0.0, 0.0]]), np.zeros((3, 2)), np.array([False, True]))
    visited.add(unknown, np.array([[5.0, 6.0], [0.0, 0.0], [0.0, 0.0]]), np.zeros((3, 2)))
    assert visited.first_fed is not None
    assert visited.first_fed.tolist() == [4.0, 0.0, 0.0]


def test_a_long_motion_passes_through_every_cell_of_its_way(model: MachineModel) -> None:
    visited = Visited(model, np.zeros((3, 1)))
    visited.add(np.array([[0.0], [0.0], [0.0]]), np.array([[540.0], [0.0], [0.0]]), np.zeros((3, 1)))
    assert set(np.floor(visited.positions[0] / 20.0 - 1e-9).clip(0)) == set(range(27))
    samples = visited.samples([[250.0], [], []])
    along = np.round(np.unique(samples[0]), 6)
    assert {250.0, 540.0} <= set(along)
    cell = 540.0 / FINEST
    assert along[0] <= cell
    assert set(np.floor(along / cell - 1e-9).clip(0)) == set(range(FINEST))  # nothing of the way is passed over
    assert not samples[1:].any()


FIVE_AXES = SimpleNamespace(
    axes=("X", "Y", "Z", "A", "C"),
    travel={"X": (0.0, 500.0), "Y": (0.0, 450.0), "Z": (0.0, 400.0), "A": (-110.0, 30.0), "C": (-360.0, 360.0)},
)


def test_samples_are_positions_of_the_program() -> None:
    """Indexed rotary axes: what is between the indexed positions is passed at the retracted position alone."""
    source, visited = np.random.default_rng(5), Visited(FIVE_AXES, np.zeros((3, 1)))
    before = np.array([[250.0], [225.0], [400.0], [0.0], [0.0]])
    for tilt, turn in ((0.0, 0.0), (-90.0, 0.0), (-90.0, 180.0)):
        retracted = np.array([[250.0], [225.0], [400.0], [tilt], [turn]])
        visited.add(before, retracted, np.zeros((5, 1)))
        cut = np.vstack([source.uniform(100.0, 300.0, (3, 300)), np.full((2, 300), [[tilt], [turn]])])
        visited.add(np.hstack([retracted, cut[:, :-1]]), cut, np.zeros((5, 300)))
        visited.add(cut[:, -1:], retracted, np.zeros((5, 1)))
        before = retracted
    samples = visited.samples([[250.0], [225.0], [], list(np.arange(-110.0, 31.0, 10.0)), [90.0, 270.0]])
    indexed = np.isin(samples[3], (0.0, -90.0)) & np.isin(samples[4], (0.0, 180.0))
    np.testing.assert_allclose(samples[:3, ~indexed], np.tile([[250.0], [225.0], [400.0]], (~indexed).sum()))
    assert {*samples[3, ~indexed]} >= set(np.arange(-80.0, 0.0, 10.0))
    assert 90.0 in samples[4]
    assert samples[4].max() == 180.0
    assert samples.shape[1] < 2 * MOST_CELLS


def test_much_is_kept_in_larger_cells_and_its_corners_are() -> None:
    source, visited = np.random.default_rng(6), Visited(FIVE_AXES, np.zeros((3, 1)))
    low, high = np.array(list(FIVE_AXES.travel.values())).T[:, :, np.newaxis]
    positions = source.uniform(low, high, (5, 40_000))
    positions[:, 7] = high[:, 0]
    visited.add(np.hstack([positions[:, :1], positions[:, :-1]]), positions, np.zeros((5, 40_000)))
    assert 500 < visited.positions.shape[1] <= MOST_CELLS
    samples = visited.samples([[], [], [], [], []])
    assert (samples == high).all(axis=0).any()
    assert ((samples >= low) & (samples <= high)).all()
