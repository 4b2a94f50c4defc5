"""Lomb-Scargle periodograms of the residuals: over the position of each axis, and around the circles."""

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from trueaxis.diagnosis.result import Diagnosis, FloatArray
from trueaxis.effects.library import BY_NAME
from trueaxis.reporting.diagnosis.frame import stacked
from trueaxis.reporting.diagnosis.lines import envelope, lines_of, rounds_of
from trueaxis.reporting.diagnosis.picture import Picture
from trueaxis.reporting.diagnosis.spectrum import (
    FALSE_ALARM,
    HIGHEST_HARMONIC,
    Spectrum,
    frequencies_of,
    harmonic,
    spectrum_of,
)
from trueaxis.reporting.diagnosis.svg import BLUE, INK, ORANGE, picture
from trueaxis.reporting.diagnosis.words import effect_title

MOST_POINTS = 800
HIGHEST_LOBE = 40


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
