"""Discrete values of the component errors with their polynomials before and after optimisation (Fig. 14)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import ceil

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import Collection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from trueaxis.error_name import ErrorName
from trueaxis.identification.polynomial import OptimalFit
from trueaxis.reporting.pictures.png import BLUE, GREY, ORANGE, png

FloatArray = NDArray[np.float64]

COLUMNS = 3
CURVE_POINTS = 241
UNDETERMINED_COLOUR = "#B8B8B8"
POINTS_COLOUR, BEFORE_COLOUR, AFTER_COLOUR = GREY, ORANGE, BLUE


@dataclass(frozen=True, slots=True, eq=False)
class PriorCurve:
    """A curve that rests on the prior: positions (n,), mm or deg; values and standard uncertainties (n,), mm or rad."""

    positions: FloatArray
    values: FloatArray
    u: FloatArray


def curves_picture(
    fits: Mapping[str, OptimalFit],
    *,
    u: Mapping[str, FloatArray] | None = None,
    undetermined: Sequence[str] = (),
    by_prior: Mapping[str, PriorCurve] | None = None,
) -> bytes:
    """PNG with a panel per component, in the order given: values with error bars and both polynomials.

    fits: component (EXX, EYX, ... in ISO 230-1's names, from which units follow: um or urad over mm or deg)
    to its fit; u: standard uncertainties of a component's values, (n,) mm or rad, drawn as bars of 2 u to
    either side where given. The band about the optimal polynomial is 2 u of the fitted curve. undetermined: components
    that the readings did not determine, drawn grey. by_prior: curves that rest on the prior, drawn dashed with a band
    of 2 u, behind the others. Raises ValueError on no fits.
    """
    if not fits:
        raise ValueError("there is no fit to draw")
    return png(lambda: _figure(fits, {} if u is None else u, undetermined, by_prior or {}))


def _figure(
    fits: Mapping[str, OptimalFit],
    u: Mapping[str, FloatArray],
    undetermined: Sequence[str],
    by_prior: Mapping[str, PriorCurve],
) -> Figure:
    count = len(fits) + len(by_prior)
    columns = min(COLUMNS, count)
    rows = ceil(count / columns)
    figure = Figure(figsize=(1.2 + 4.2 * columns, 0.9 + 2.7 * rows), dpi=110, layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    for panel in panels[count:]:
        panel.set_axis_off()
    for panel, (component, curve) in zip(panels[len(fits) :], by_prior.items(), strict=False):
        _draw_prior(panel, component, curve)
    for panel, (component, fit) in zip(panels, fits.items(), strict=False):
        _draw_panel(panel, component, fit, u.get(component))
        if component in undetermined:
            _grey(panel, component)
    shown = [panel for panel, name in zip(panels, fits, strict=False) if name not in undetermined] or list(panels)
    shown += list(panels[len(fits) : count][:1])
    labelled = {
        label: artist for panel in shown for artist, label in zip(*panel.get_legend_handles_labels(), strict=True)
    }
    figure.legend(labelled.values(), labelled.keys(), loc="outside upper center", ncols=len(labelled), frameon=False)
    return figure


def _draw_panel(panel: Axes, component: str, fit: OptimalFit, u: FloatArray | None) -> None:
    unit, factor = _unit(component)
    x, y = fit.samples.positions, fit.samples.values * factor
    curve = np.linspace(min(0.0, x.min()), max(0.0, x.max()), CURVE_POINTS)
    after, band = fit.after.at(curve) * factor, 2 * factor * fit.after.u_at(curve)
    bars = None if u is None else 2 * factor * u
    panel.axhline(0.0, color="#B0B0B0", linewidth=0.6, zorder=0)
    panel.fill_between(curve, after - band, after + band, color=AFTER_COLOUR, alpha=0.18, linewidth=0, zorder=1)
    panel.errorbar(
        x, y, yerr=bars, fmt="o", color=POINTS_COLOUR, markersize=2.6, elinewidth=0.8, capsize=1.6, zorder=2,
        label="discrete values" if u is None else "discrete values \N{PLUS-MINUS SIGN} 2u",
    )  # fmt: skip
    panel.plot(curve, fit.before.at(curve) * factor, "--", color=BEFORE_COLOUR, linewidth=2.0, zorder=3, label="before")
    panel.plot(curve, after, "-", color=AFTER_COLOUR, linewidth=1.4, zorder=4, label="after optimisation")
    _frame(panel, component, _summary(fit, unit, factor), unit)


def _draw_prior(panel: Axes, component: str, curve: PriorCurve) -> None:
    unit, factor = _unit(component)
    values, band = curve.values * factor, 2 * factor * curve.u
    panel.axhline(0.0, color="#B0B0B0", linewidth=0.6, zorder=0)
    panel.fill_between(
        curve.positions, values - band, values + band, color=UNDETERMINED_COLOUR, alpha=0.35, linewidth=0, zorder=1
    )
    panel.plot(
        curve.positions, values, "--", color=UNDETERMINED_COLOUR, linewidth=1.4, zorder=2,
        label="not determined \N{PLUS-MINUS SIGN} 2u",
    )  # fmt: skip
    _frame(panel, component, "not determined by the readings", unit)


def _unit(component: str) -> tuple[str, float]:
    return ("\N{MICRO SIGN}rad", 1e6) if ErrorName(component).is_rotation else ("\N{MICRO SIGN}m", 1e3)


def _frame(panel: Axes, component: str, summary: str, unit: str) -> None:
    panel.set_title(f"{component}: {summary}", fontsize=9, loc="left")
    name = ErrorName(component)
    panel.set_xlabel(f"{name.axis} ({name.axis_unit})", fontsize=8, labelpad=1)
    panel.set_ylabel(f"{component} ({unit})", fontsize=8, labelpad=2)
    panel.tick_params(labelsize=8)
    panel.margins(x=0.02)
    panel.spines[["top", "right"]].set_visible(False)


def _grey(panel: Axes, component: str) -> None:
    """Make a panel look like what it is: values that the readings did not determine."""
    for artist in panel.get_children():
        if isinstance(artist, Line2D | Collection):
            artist.set_color(UNDETERMINED_COLOUR)
    panel.set_facecolor("#F4F4F4")
    panel.set_title(f"{component}: not determined by the readings", fontsize=9, loc="left", color="#707070")


def _summary(fit: OptimalFit, unit: str, factor: float) -> str:
    if not fit.after.powers:
        return "no polynomial"
    if fit.samples.whitening is not None:
        unit, factor = "u", 1.0
    before, after = (side.residual_standard_error * factor for side in (fit.before, fit.after))
    terms = f"{len(fit.before.powers)}\N{RIGHTWARDS ARROW}{len(fit.after.powers)} terms"
    return f"{terms}, s {before:.3g}\N{RIGHTWARDS ARROW}{after:.3g} {unit}"
