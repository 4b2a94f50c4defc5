"""The arithmetic behind the figures, against closed forms."""

import re
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure
from scipy.signal import lombscargle

from tests.reporting.diagnosis import builders
from trueaxis.diagnosis.result import Estimate
from trueaxis.effects.library import BY_NAME
from trueaxis.reporting.diagnosis.figures.candidates import spread
from trueaxis.reporting.diagnosis.figures.periodogram import (
    AT_ONCE,
    FALSE_ALARM,
    frequencies_of,
    harmonic,
    periodograms,
    powers,
    spectrum_of,
)
from trueaxis.reporting.diagnosis.figures.residuals import _autocorrelation
from trueaxis.reporting.diagnosis.lines import envelope, lines_of, rounds_of, sample
from trueaxis.reporting.diagnosis.svg import BLUE, ORANGE, SHAPES, cloud, one_path, picture, stacked


def test_runs_are_sorted_into_lines_and_circles() -> None:
    data = builders.residuals()
    assert [(one.run, one.axis) for one in lines_of(data)] == [
        (f"{name}-{k}", axis) for axis, name in enumerate("XYZ") for k in (1, 2, 3)
    ]
    told = [(one.run, one.plane, one.turn, one.feed) for one in rounds_of(data)]
    assert told == [
        (f"{plane}-{feed:g}-{'ccw' if turn > 0 else 'cw'}", plane, turn, feed)
        for plane in ("XY", "ZX")
        for feed in (500.0, 3000.0)
        for turn in (1, -1)
    ]


def test_thinning_keeps_what_stands_out() -> None:
    values = np.random.default_rng(3).normal(size=10_000)
    values[4321], values[777] = 50.0, -50.0
    kept = envelope(values, 100)
    assert kept.size <= 100
    assert {4321, 777} <= set(kept.tolist())
    assert np.all(np.diff(kept) > 0)
    drawn = sample(values, 1000)
    assert drawn.size <= 1000
    assert {4321, 777} <= set(drawn.tolist())
    middle = values[drawn][np.abs(values[drawn]) < 1.6]
    assert middle.std() == pytest.approx(values[np.abs(values) < 1.6].std(), rel=0.1)
    assert sample(values[:100], 100).tolist() == envelope(values[:100], 100).tolist() == list(range(100))


def test_a_sine_stands_at_its_period_and_noise_crosses_the_line_as_often_as_it_says() -> None:
    data = builders.residuals()
    rows = np.concatenate([one.rows for one in lines_of(data) if one.axis == 1])
    rng = np.random.default_rng(11)
    at = rng.uniform(0.0, 500.0, rows.size)
    frequencies = frequencies_of(at)
    wave = np.zeros(data.run.size)
    wave[rows] = 0.001 * np.sin(2.0 * np.pi * at / 80.0 + 0.7)
    found = spectrum_of(replace(data, refitted=wave), rows, at, frequencies)
    assert 1.0 / frequencies[found.refitted.argmax()] == pytest.approx(80.0, rel=0.03)
    assert found.refitted.max() == pytest.approx(1.0, abs=0.02)
    assert found.extended.max() < found.line
    few = frequencies[: frequencies.size // 8]
    crossed = 0
    for _ in range(400):
        noise = rng.normal(size=data.run.size)
        spectrum = spectrum_of(replace(data, refitted=noise), rows, at, few)
        crossed += bool(spectrum.refitted.max() > spectrum.line)
    # binomial, mean 4 at 1 %; neighbouring frequencies are not quite independent
    assert crossed <= 400 * FALSE_ALARM * 4


@pytest.mark.parametrize("equidistant", [False, True])
def test_the_periodogram_over_targets_is_that_of_scipy_over_readings(equidistant: bool) -> None:
    rng = np.random.default_rng(2)
    targets = np.linspace(0.0, 475.0, 20) if equidistant else np.sort(rng.uniform(0.0, 500.0, 60))
    at = rng.permutation(np.repeat(targets, 7))
    values = rng.normal(size=(2, at.size))
    frequencies = np.arange(4, 41 if equidistant else 2 * AT_ONCE + 50) / 4 / 500.0  # up to Nyquist; beyond two blocks
    expected = [lombscargle(at, row, 2.0 * np.pi * frequencies, normalize=True) for row in values]
    assert powers(at, values, frequencies) == pytest.approx(np.stack(expected), abs=1e-12)
    assert powers(at, np.zeros((1, at.size)), frequencies).tolist() == [[0.0] * frequencies.size]


def test_harmonics_as_far_as_the_extent_tells_them() -> None:
    assert [harmonic(10.0 / k, 10.0, 500.0) for k in range(1, 6)] == [1, 2, 3, 4, 0]
    assert harmonic(5.02, 10.0, 500.0) == 2  # 0.4 of 1/500 away
    assert harmonic(5.03, 10.0, 500.0) == 0  # 0.6
    assert harmonic(20.0, 10.0, 500.0) == 0  # a multiple of a period is none of its harmonics


def test_the_peak_of_a_harmonic_names_its_cause() -> None:
    diagnosis = builders.diagnosis("explained")
    data = diagnosis.residuals
    names = [one.name for one in BY_NAME["cyclic"].parameters]
    parameters = tuple(Estimate(name, 90.0 if name == "pitch" else 0.001, 0.0001, "mm") for name in names)
    cyclic = replace(builders.cause(builders.CYCLIC), parameters=parameters)
    noise = data.extended
    first, second = (0.002 * np.sin(2.0 * np.pi * data.positions[1] * k / 90.0) for k in (1, 2))
    data = replace(data, refitted=noise + first, extended=noise + second)
    told = {one.name: one for one in periodograms(replace(diagnosis, residuals=data, causes=(cyclic,)))}
    assert "mm (the period of Cyclic in EYY), above the line" in told["period-Y"].caption
    assert "mm (harmonic 2 of the period of Cyclic in EYY), above it" in told["period-Y"].caption
    assert "Cyclic" not in told["period-X"].caption


def test_names_are_moved_apart_no_farther_than_they_have_to() -> None:
    assert spread(np.array([1.0, 5.0, 9.0]), 2.0, 0.0, 10.0).tolist() == [1.0, 5.0, 9.0]
    assert spread(np.array([4.0, 4.0, 9.0]), 2.0, 0.0, 10.0) == pytest.approx([3.0, 5.0, 9.0])
    assert spread(np.array([0.0, 0.5, 9.8]), 2.0, 0.0, 9.0) == pytest.approx([0.0, 2.0, 9.0])
    assert spread(np.array([0.0, 1.0, 2.0]), 4.0, 0.0, 4.0) == pytest.approx(
        [-2.0, 2.0, 6.0]
    )  # no room: about the middle


def test_a_cloud_is_one_element_with_a_marker_at_every_point() -> None:
    x, y = np.array([0.0, 1.0, 2.0]), np.array([0.0, 4.0, 1.0])
    triangle = one_path(np.column_stack([x, y]), np.array(SHAPES["^"]))
    parts = triangle.to_polygons()
    assert len(parts) == 3
    assert np.asarray(parts[1])[:-1].mean(axis=0) == pytest.approx([1.0, 4.0 - 0.5 / 3.0])

    def draw() -> Figure:
        figure, (panel,) = stacked(2.0)
        cloud(panel, x, y, "o", BLUE, BLUE, 2.0, "dots")
        cloud(panel, x, y, "s", ORANGE, "none", 2.0, "squares")
        panel.set_axis_off()
        return figure

    paths = re.findall(r'<path d="([^"]*)"[^>]*style="([^"]*)"', picture("name", "title", "alt", "caption", draw).svg)
    dots = [d for d, style in paths if "var(--blue)" in style]
    squares = [d for d, style in paths if "var(--orange)" in style]
    assert [d.count("M") for d in dots] == [3]
    assert [(d.count("M"), d.count("z")) for d in squares] == [(3, 3)]


def test_the_autocorrelation_of_a_first_order_process() -> None:
    data = builders.residuals()
    rng = np.random.default_rng(5)
    values = np.zeros(data.run.size)
    for k in range(1, values.size):
        values[k] = 0.6 * values[k - 1] + rng.normal()
    lags, correlation, count = _autocorrelation(replace(data, whitened=values))
    assert correlation[:4] == pytest.approx(0.6 ** np.arange(1, 5), abs=0.08)
    runs = len(data.runs)
    assert count[:2].tolist() == [values.size - runs, values.size - 2 * runs]  # never across runs
    assert lags[0] == 1.0


def test_a_mistake_in_drawing_is_not_swallowed() -> None:
    def draw() -> None:
        raise ValueError("no data")

    with pytest.raises(ValueError, match="no data"):
        picture("name", "title", "alt", "caption", draw)  # type: ignore[arg-type]
