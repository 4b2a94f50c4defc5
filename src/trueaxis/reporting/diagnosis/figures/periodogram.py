"""Lomb-Scargle periodograms of the residuals: over the position of each axis, and around the circles.

They have the shares of sines in the residuals, and what noise alone would reach.
"""

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from trueaxis.diagnosis.result import Diagnosis, FloatArray, IntArray, Residuals
from trueaxis.effects.library import BY_NAME
from trueaxis.reporting.diagnosis.lines import envelope, lines_of, rounds_of
from trueaxis.reporting.diagnosis.picture import Picture
from trueaxis.reporting.diagnosis.svg import BLUE, INK, ORANGE, picture, stacked
from trueaxis.reporting.diagnosis.words import effect_title

MOST_POINTS = 800
HIGHEST_LOBE = 40
FALSE_ALARM = 0.01
MOST_READINGS = 6000  # taken evenly, in order of position
MOST_FREQUENCIES = 2400
OVERSAMPLING = 4
AT_ONCE = 200  # frequencies: the memory of their waves stays small
HIGHEST_HARMONIC = 4


@dataclass(frozen=True, slots=True)
class Period:
    """A period that a cause named has, over the position of an axis, in its unit; title: of the cause."""

    axis: str
    length: float
    title: str


def periodograms(diagnosis: Diagnosis) -> list[Picture]:
    """One picture for each axis with lines, and one for all circles."""
    residuals = diagnosis.residuals
    found = []
    lines = lines_of(residuals)
    for axis in sorted({one.axis for one in lines}):
        rows = np.concatenate([one.rows for one in lines if one.axis == axis])
        at = residuals.positions[axis, rows]
        frequencies = frequencies_of(at)
        if frequencies.size:
            spectrum = spectrum_of(residuals, rows, at, frequencies)
            unit = "mm" if residuals.axes[axis] in "XYZ" else "deg"
            own = [one for one in _periods(diagnosis) if one.axis == residuals.axes[axis]]
            found.append(_picture(residuals.axes[axis], spectrum, unit, own))
    rounds = rounds_of(residuals)
    if rounds:
        rows = np.concatenate([one.rows for one in rounds])
        lobes = np.arange(1.0, HIGHEST_LOBE + 1.0) / (2.0 * np.pi)
        found.append(_picture("circles", spectrum_of(residuals, rows, residuals.theta[rows], lobes), "", []))
    return found


def _periods(diagnosis: Diagnosis) -> list[Period]:
    """Of causes whose kind has a parameter that is a pitch; it is over the axis that moves, the last letter."""
    return [
        Period(cause.effect.own_axis, abs(estimate.value), effect_title(cause.effect))
        for cause in diagnosis.causes
        if cause.effect.component and (kind := BY_NAME.get(cause.effect.kind))
        for parameter, estimate in zip(kind.parameters, cause.parameters, strict=False)
        if parameter.grid == "pitch" and estimate.value != 0.0
    ]


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


def _picture(name: str, spectrum: Spectrum, unit: str, periods: list[Period]) -> Picture:
    over = f"the position of {name}" if unit else "the polar angle of the circles"
    peak = [int(power.argmax()) for power in (spectrum.refitted, spectrum.extended)]
    at = [_named(float(spectrum.frequencies[k]), unit) for k in peak]
    above = [
        "above" if power[k] > spectrum.line else "below"
        for power, k in zip((spectrum.refitted, spectrum.extended), peak, strict=True)
    ]
    whose = [
        _whose(spectrum, float(spectrum.frequencies[k]), periods) if side == "above" else ""
        for k, side in zip(peak, above, strict=True)
    ]
    peaks = (
        f"Largest peak: refitted at {at[0]}{whose[0]}, {above[0]} the line; with the extended model at "
        f"{at[1]}{whose[1]}, {above[1]} it."
    )
    marked = " Ticks above: periods of the causes, and their harmonics." if periods else ""
    return picture(
        f"period-{name}",
        f"Periodogram, {name}",
        f"Lomb-Scargle periodogram of the residuals over {over}. {peaks}",
        f"{peaks} White noise crosses the line with probability {100 * FALSE_ALARM:g} %.{marked}",
        lambda: _figure(spectrum, unit, periods),
    )


def _whose(spectrum: Spectrum, frequency: float, periods: list[Period]) -> str:
    """Of which cause a peak is a harmonic, in words; nothing where it is of none."""
    for one in periods:
        order = harmonic(1.0 / frequency, one.length, spectrum.extent)
        if order:
            what = "the period" if order == 1 else f"harmonic {order} of the period"
            return f" ({what} of {one.title})"
    return ""


def _named(frequency: float, unit: str) -> str:
    return f"{1.0 / frequency:.4g} {unit}" if unit else f"{2.0 * np.pi * frequency:.0f} lobes"


def _figure(spectrum: Spectrum, unit: str, periods: list[Period]) -> Figure:
    figure, (panel,) = stacked(3.0)
    if unit:
        _curves(panel, spectrum, 1.0 / spectrum.frequencies)
        panel.set_xscale("log")
        panel.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        panel.xaxis.set_major_formatter(FuncFormatter(lambda period, _: f"{period:g}"))
        panel.xaxis.set_minor_formatter(NullFormatter())
        panel.set_xlabel(f"period ({unit})")
        _marks(panel, spectrum, periods)
    else:
        _stems(panel, spectrum)
    panel.axhline(
        100.0 * spectrum.line, color=INK, linewidth=0.9, linestyle="--", label=f"false alarm {100 * FALSE_ALARM:g} %"
    )
    panel.set_ylabel("share of variance (%)")
    panel.set_ylim(bottom=0.0)
    figure.legend(loc="upper center", ncols=3)
    return figure


def _marks(panel: Axes, spectrum: Spectrum, periods: list[Period]) -> None:
    """A tick at the top for each period of a cause and its harmonics within the frequencies shown."""
    for one in periods:
        for order in range(1, HIGHEST_HARMONIC + 1):
            if spectrum.frequencies[0] <= order / one.length <= spectrum.frequencies[-1]:
                panel.axvline(one.length / order, 0.94, 1.0, color=INK, linewidth=1.6 if order == 1 else 0.8)


def _curves(panel: Axes, spectrum: Spectrum, across: FloatArray) -> None:
    for power, colour, dash, label in (
        (spectrum.refitted, ORANGE, "-", "refitted"),
        (spectrum.extended, BLUE, (0, (4, 1.5)), "extended"),
    ):
        kept = envelope(power, MOST_POINTS)
        panel.plot(across[kept], 100.0 * power[kept], linestyle=dash, color=colour, linewidth=0.9, label=label)


def _stems(panel: Axes, spectrum: Spectrum) -> None:
    lobes = 2.0 * np.pi * spectrum.frequencies
    panel.vlines(lobes, 0.0, 100.0 * spectrum.refitted, color=ORANGE, linewidth=1.0)
    panel.plot(
        lobes, 100.0 * spectrum.refitted, "D", color=ORANGE, markerfacecolor="none", markersize=3.2, label="refitted"
    )
    panel.plot(lobes, 100.0 * spectrum.extended, "o", color=BLUE, markersize=2.6, label="extended")
    panel.set_xlim(0.0, HIGHEST_LOBE + 1.0)
    panel.set_xlabel("undulations per revolution")


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
