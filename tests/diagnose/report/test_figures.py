"""The arithmetic behind the figures, against closed forms."""

from dataclasses import replace

import numpy as np
import pytest

from tests.diagnose.report import builders
from trueaxis.diagnose.report.figures.periodogram import FALSE_ALARM, _frequencies, _spectrum
from trueaxis.diagnose.report.figures.whiteness import _autocorrelation
from trueaxis.diagnose.report.lines import envelope, lines_of, rounds_of, sample
from trueaxis.diagnose.report.svg import picture


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
    frequencies = _frequencies(at)
    wave = np.zeros(data.run.size)
    wave[rows] = 0.001 * np.sin(2.0 * np.pi * at / 80.0 + 0.7)
    found = _spectrum(replace(data, refitted=wave), rows, at, frequencies)
    assert 1.0 / frequencies[found.refitted.argmax()] == pytest.approx(80.0, rel=0.03)
    assert found.refitted.max() == pytest.approx(1.0, abs=0.02)
    assert found.extended.max() < found.line
    few = frequencies[: frequencies.size // 8]
    crossed = 0
    for _ in range(400):
        noise = rng.normal(size=data.run.size)
        spectrum = _spectrum(replace(data, refitted=noise), rows, at, few)
        crossed += bool(spectrum.refitted.max() > spectrum.line)
    # binomial, mean 4 at 1 %; neighbouring frequencies are not quite independent
    assert crossed <= 400 * FALSE_ALARM * 4


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
