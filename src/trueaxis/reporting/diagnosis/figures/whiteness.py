"""Are the whitened residuals white and normal? Quantiles and autocorrelation."""

import numpy as np
from matplotlib.figure import Figure
from scipy.special import ndtri

from trueaxis.diagnosis.result import Diagnosis, FloatArray, Residuals
from trueaxis.reporting.diagnosis.picture import Picture
from trueaxis.reporting.diagnosis.svg import BLUE, DOT, INK, ORANGE, cloud, picture, stacked

MOST_POINTS = 400
MOST_LAGS = 30


def whiteness(diagnosis: Diagnosis) -> list[Picture]:
    """The Q-Q plot and the autocorrelation; none for fewer than eight readings."""
    whitened = diagnosis.residuals.whitened
    whitened = np.sort(whitened[np.isfinite(whitened)])
    if whitened.size < 8:
        return []
    spread = float(np.std(whitened))
    lags, correlation, count = _autocorrelation(diagnosis.residuals)
    bound = 1.96 / np.sqrt(count)
    outside = int(np.sum(np.abs(correlation) > bound))
    return [
        picture(
            "quantiles",
            "Q-Q plot of the whitened residuals",
            f"Quantiles of {whitened.size} whitened residuals against those of a normal distribution; "
            f"standard deviation {spread:.3g}.",
            f"On the line where the residuals are normal noise of the size of the repeats; standard deviation "
            f"{spread:.3g}."
            + (
                f" A selection of the {whitened.size} is drawn, evenly over the axis."
                if whitened.size > MOST_POINTS
                else ""
            ),
            lambda: _quantiles(whitened),
        ),
        picture(
            "autocorrelation",
            "Autocorrelation of the whitened residuals",
            f"Autocorrelation up to lag {lags.size}; {outside} of {lags.size} lie outside the 95 % band.",
            f"From one reading of a run to later ones; {outside} of {lags.size} outside the 95 % band "
            f"(chance: {0.05 * lags.size:.1f}).",
            lambda: _correlogram(lags, correlation, bound),
        ),
    ]


def _quantiles(whitened: FloatArray) -> Figure:
    figure, (panel,) = stacked(3.2)
    expected = ndtri((np.arange(1, whitened.size + 1) - 0.5) / whitened.size)
    ends = np.array([expected[0], expected[-1]])
    kept = np.unique(
        np.searchsorted(expected, np.linspace(expected[0], expected[-1], MOST_POINTS)).clip(0, whitened.size - 1)
    )
    panel.plot(ends, ends, "--", color=INK, linewidth=0.9, label="noise as estimated")
    cloud(panel, expected[kept], whitened[kept], DOT, BLUE, BLUE, 2.4, "residuals")
    panel.set_xlabel("normal quantile")
    panel.set_ylabel("whitened residual")
    figure.legend(loc="upper center", ncols=2)
    return figure


def _autocorrelation(residuals: Residuals) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Lags, correlation at each, and the number of pairs; pairs within a run only."""
    order = np.lexsort((residuals.seq, residuals.run))
    run, values = residuals.run[order], np.nan_to_num(residuals.whitened[order])
    lags = np.arange(1, min(MOST_LAGS, values.size // 4) + 1)
    power = float(np.mean(values**2)) or 1.0
    correlation, count = np.zeros(lags.size), np.zeros(lags.size)
    for k, lag in enumerate(lags):
        same = run[lag:] == run[:-lag]
        count[k] = max(1, int(same.sum()))
        correlation[k] = float(np.sum(values[lag:][same] * values[:-lag][same])) / (count[k] * power)
    return lags.astype(float), correlation, count


def _correlogram(lags: FloatArray, correlation: FloatArray, bound: FloatArray) -> Figure:
    figure, (panel,) = stacked(3.2)
    panel.fill_between(lags, -bound, bound, color=ORANGE, alpha=0.25, linewidth=0, label="95 % of white noise")
    panel.axhline(0.0, color=INK, linewidth=0.7)
    panel.vlines(lags, 0.0, correlation, color=BLUE, linewidth=1.3)
    panel.plot(lags, correlation, "o", color=BLUE, markersize=2.6, label="autocorrelation")
    largest = max(0.2, 1.15 * float(np.abs(correlation).max()))
    panel.set_ylim(-largest, largest)
    panel.set_xlabel("lag (readings)")
    figure.legend(loc="upper center", ncols=2)
    return figure
