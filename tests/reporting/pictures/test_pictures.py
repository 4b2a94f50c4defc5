"""Pictures are PNG, the same bytes each time, and refuse nothing that a run can give."""

import numpy as np

from trueaxis.reporting.pictures.standard_tests import Trace, _broken, _round_up, polar_plot
from trueaxis.reporting.pictures.tool_point import PathErrors, error_map

PATH = np.array([np.linspace(0.0, 100.0, 50), np.sin(np.linspace(0.0, 6.0, 50)), np.zeros(50)])
ERRORS = PathErrors(np.full(50, 1e-4), np.linspace(0.0, 1e-3, 50))


def test_error_maps_have_the_same_bytes_each_time() -> None:
    first, second = (error_map(PATH, {"before": ERRORS, "after": ERRORS}, "a path") for _ in range(2))
    assert first == second
    assert first.startswith(b"\x89PNG")


def test_polar_plots_have_the_same_bytes_each_time() -> None:
    angles = np.linspace(0.0, 2.0 * np.pi, 90, endpoint=False)
    panels = [("one", [Trace("cw", angles, 1e-3 * np.cos(2 * angles)), Trace("ccw", angles, 0.0 * angles)])]
    assert polar_plot(panels, "circle") == polar_plot(panels, "circle")


def test_gaps_are_not_bridged_and_full_circles_are_closed() -> None:
    full = np.radians(np.arange(0.0, 360.0, 5.0))
    angles, radial = _broken(full[::-1], np.arange(full.size, dtype=float))
    assert angles.size == full.size + 1
    assert not np.isnan(radial).any()
    arcs = np.radians(np.concatenate([np.arange(30.0, 150.0, 5.0), np.arange(210.0, 330.0, 5.0)]))
    angles, radial = _broken(arcs, np.ones(arcs.size))
    assert np.isnan(radial).sum() == 1
    assert np.isnan(angles).sum() == 1


def test_scales_are_round_numbers() -> None:
    assert [_round_up(value) for value in (0.7, 1.0, 1.3, 4.2, 8.1, 23.0)] == [1.0, 1.0, 2.0, 5.0, 10.0, 50.0]
