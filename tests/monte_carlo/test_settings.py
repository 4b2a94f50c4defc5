"""The parts of draws and their seeds."""

import numpy as np
import pytest

from trueaxis.monte_carlo.settings import generators, parts


@pytest.mark.parametrize("count", [2, 99, 100, 101, 12_345, 500_000, 1_000_000, 5_000_001])
def test_parts_are_all_draws_in_bounded_numbers(count: int) -> None:
    found = parts(count)
    assert sum(found) == count
    assert max(found) - min(found) <= 1
    assert len(found) == min(count, 100) if count <= 500_000 else 100 < len(found) <= 1001


def test_a_million_draws_are_a_hundred_to_a_thousand_tasks() -> None:
    assert 100 <= len(parts(1_000_000)) <= 1000


def test_every_part_has_numbers_of_its_own() -> None:
    drawn = {one.standard_normal() for number in range(50) for one in generators(7, 100, number)}
    assert len(drawn) == 150
    again = [one.standard_normal() for one in generators(7, 100, 3)]
    assert set(again) <= drawn
    assert generators(8, 100, 3)[0].standard_normal() not in drawn


def test_noise_does_not_move_the_draws_of_values() -> None:
    values, noise, _ = generators(1, 100, 0)
    noise.standard_normal(1000)
    assert values.standard_normal() == generators(1, 100, 0)[0].standard_normal()
    assert isinstance(values, np.random.Generator)
