"""Lomb-Scargle periodograms: the shares of sines in residuals, and what noise alone would reach."""

from dataclasses import dataclass

import numpy as np

from trueaxis.diagnosis.result import FloatArray, IntArray, Residuals

FALSE_ALARM = 0.01
MOST_READINGS = 6000  # taken evenly, in order of position
MOST_FREQUENCIES = 2400
OVERSAMPLING = 4
AT_ONCE = 200  # frequencies: the memory of their waves stays small
HIGHEST_HARMONIC = 4


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Spectrum:
    """Share of the variance (0 to 1) that a sine of each frequency takes, refitted and extended; the line that noise
    crosses anywhere with probability FALSE_ALARM; extent: of the readings, in the unit of a period.
    """

    frequencies: FloatArray
    refitted: FloatArray
    extended: FloatArray
    line: float
    extent: float


def frequencies_of(at: FloatArray) -> FloatArray:
    """From one period over the extent, in steps that miss no peak, to the Nyquist frequency of the shorter distances
    between targets, or as far as MOST_FREQUENCIES of these steps reach.
    """
    targets = np.unique(np.round(at, 3))
    if targets.size < 5:
        return np.empty(0)
    extent = float(np.ptp(targets))
    gaps = np.diff(targets)
    spacing = max(float(np.quantile(gaps, 0.1)), float(np.median(gaps)) / 5.0)
    periods = np.arange(OVERSAMPLING, OVERSAMPLING + MOST_FREQUENCIES) / OVERSAMPLING  # over the extent
    highest = max(extent / (2.0 * spacing), 2.0)
    return periods[periods <= highest] / extent


def spectrum_of(residuals: Residuals, rows: IntArray, at: FloatArray, frequencies: FloatArray) -> Spectrum:
    """Of the residuals in these rows, refitted and extended, over their places at, less the mean of each run."""
    order = np.argsort(at, kind="stable")
    order = order[:: max(1, -(-order.size // MOST_READINGS))]
    rows, at = rows[order], at[order]
    power = powers(
        at,
        np.stack([_without_run_means(residuals, values, rows) for values in (residuals.refitted, residuals.extended)]),
        frequencies,
    )
    independent = max(1.0, float(np.ptp(at)) * float(frequencies[-1] - frequencies[0]))
    freedom = max(rows.size - 3, 1)
    # P(power > z) = (1 - z)^((n - 3)/2) at one frequency, with the variance estimated from the same readings
    line = 1.0 - (1.0 - (1.0 - FALSE_ALARM) ** (1.0 / independent)) ** (2.0 / freedom)
    return Spectrum(
        frequencies=frequencies, refitted=power[0], extended=power[1], line=float(line), extent=float(np.ptp(at))
    )


def powers(at: FloatArray, values: FloatArray, frequencies: FloatArray) -> FloatArray:
    """Share of the squares of each row of values (c, n) that a sine of each frequency (f,) takes by least squares:
    (c, f), Lomb-Scargle (Scargle 1982). Readings at one target enter as their sum: targets are few, readings many.
    """
    targets, which = np.unique(at, return_inverse=True)
    count = np.bincount(which)
    sums = np.stack([np.bincount(which, weights=row) for row in values])
    double, turned = np.empty(frequencies.size, complex), np.empty((len(values), frequencies.size), complex)
    for start in range(0, frequencies.size, AT_ONCE):
        part = slice(start, start + AT_ONCE)
        wave = np.exp(2j * np.pi * np.outer(targets, frequencies[part]))
        double[part], turned[:, part] = count @ wave**2, sums @ wave
    # tau turns the phase so that cosine and sine are orthogonal over the readings
    turned *= np.exp(-0.5j * np.angle(double))
    cosines, sines = 0.5 * (at.size + np.abs(double)), 0.5 * (at.size - np.abs(double))
    taken = turned.real**2 / cosines
    known = sines > 1e-9 * at.size  # at the Nyquist frequency of equidistant targets every sine is zero
    taken += np.where(known, turned.imag**2 / np.where(known, sines, 1.0), 0.0)
    whole = np.sum(values**2, axis=1, keepdims=True)
    share: FloatArray = taken / np.where(whole > 0.0, whole, 1.0)
    return share


def _without_run_means(residuals: Residuals, values: FloatArray, rows: IntArray) -> FloatArray:
    """Offsets of runs are of the set-up, and would leak into the lowest frequencies."""
    count = np.bincount(residuals.run[rows], minlength=len(residuals.runs))
    total = np.bincount(residuals.run[rows], weights=values[rows], minlength=len(residuals.runs))
    mean = total / np.maximum(count, 1)
    left: FloatArray = values[rows] - mean[residuals.run[rows]]
    return left


def harmonic(period: float, of: float, extent: float) -> int:
    """Which harmonic of a period another is, as far as readings over this extent tell; 0: none."""
    order = round(of / period)
    near = abs(1.0 / period - order / of) < 0.5 / extent
    return order if 1 <= order <= HIGHEST_HARMONIC and near else 0
