"""Where values have changed: the size that is told is one that the readings know."""

import numpy as np

from trueaxis.diagnose.stale import clearest


def test_the_change_told_is_the_largest_that_is_certain() -> None:
    value = np.array([0.1, -0.7, 0.6, 8.0])
    assert clearest(value, np.array([0.01, 0.1, 0.1, 21.0])) == 1
    assert clearest(value, np.array([0.01, 0.1, 0.1, 0.1])) == 3


def test_where_no_place_is_certain_it_is_the_one_known_best() -> None:
    """The test of the whole curve may be sure where no single place is."""
    assert clearest(np.array([8.0, 0.3, 0.0]), np.array([21.0, 0.2, 0.1])) == 1
    assert clearest(np.zeros(2), np.zeros(2)) == 0
