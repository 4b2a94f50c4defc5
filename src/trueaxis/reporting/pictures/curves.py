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
EXPLAINED = (
    "s: standard deviation of what the polynomial leaves of the discrete values, before and after optimisation; in u: "
    "over their standard uncertainty"
)
POINTS_COLOUR, BEFORE_COLOUR, AFTER_COLOUR = GREY, ORANGE, BLUE


@dataclass(frozen=True, slots=True, eq=False)
class DrawnCurve:
    """A curve that is no polynomial: positions (n,), mm or deg; values and standard uncertainties (n,), mm or rad."""

    positions: FloatArray
    values: FloatArray
    u: FloatArray


def curves_picture(
    fits: Mapping[str, OptimalFit],
    *,
    u: Mapping[str, FloatArray] | None = None,
    undetermined: Sequence[str] = (),
    by_prior: Mapping[str, DrawnCurve] | None = None,
    kept: Mapping[str, DrawnCurve] | None = None,
    travel: Mapping[str, tuple[float, float]] | None = None,
) -> bytes:
    """PNG with a panel per component, in the order given: values with error bars and both polynomials.

    fits: component (EXX, EYX, ... in ISO 230-1's names, from which units follow: um or urad over mm or deg)
    to its fit; u: standard uncertainties of a component's values, (n,) mm or rad, drawn as bars of 2 u to
    either side where given. The band about the optimal polynomial is 2 u of the fitted curve. undetermined: components
    that the readings did not determine, drawn grey. by_prior: curves that rest on the prior, drawn dashed with a band
    of 2 u, behind the others. kept: curves that stay, as no polynomial is near to them, drawn in place of polynomials.
    travel: ends of the axis of each component, mm or deg, beyond which nothing is drawn. Raises ValueError on no fits.
    """
    if not fits:
        raise ValueError("there is no fit to draw")
    panels = _Panels(fits=fits, u=u or {}, undetermined=undetermined, by_prior=by_prior or {}, kept=kept or {},
                     travel=travel or {})  # fmt: skip
    return png(lambda: _figure(panels))


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _Panels:
    """As the arguments of `curves_picture`."""

    fits: Mapping[str, OptimalFit]
    u: Mapping[str, FloatArray]
    undetermined: Sequence[str]
    by_prior: Mapping[str, DrawnCurve]
    kept: Mapping[str, DrawnCurve]
    travel: Mapping[str, tuple[float, float]]


def _figure(of: _Panels) -> Figure:
    fits, by_prior = of.fits, of.by_prior
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
        if component in of.kept:
            _draw_kept(panel, component, fit, of.u.get(component), of.kept[component])
        else:
            _draw_panel(panel, component, fit, of.u.get(component), of.travel.get(component, (-np.inf, np.inf)))
        if component in of.undetermined:
            _grey(panel, component)
    shown = [panel for panel, name in zip(panels, fits, strict=False) if name not in of.undetermined] or list(panels)
    shown += list(panels[len(fits) : count][:1])
    labelled = {
        label: artist for panel in shown for artist, label in zip(*panel.get_legend_handles_labels(), strict=True)
    }
    if any(fit.after.powers for fit in fits.values()):
        figure.supxlabel(EXPLAINED, fontsize=8)
    figure.legend(labelled.values(), labelled.keys(), loc="outside upper center", ncols=len(labelled), frameon=False)
    return figure


def _draw_values(panel: Axes, fit: OptimalFit, factor: float, u: FloatArray | None) -> None:
    bars = None if u is None else 2 * factor * u
    panel.axhline(0.0, color="#B0B0B0", linewidth=0.6, zorder=0)
    panel.errorbar(
        fit.samples.positions, fit.samples.values * factor, yerr=bars, fmt="o", color=POINTS_COLOUR, markersize=2.6,
        elinewidth=0.8, capsize=1.6, zorder=2,
        label="discrete values" if u is None else "discrete values \N{PLUS-MINUS SIGN} 2u",
    )  # fmt: skip


def _draw_kept(panel: Axes, component: str, fit: OptimalFit, u: FloatArray | None, curve: DrawnCurve) -> None:
    unit, factor = _unit(component)
    _draw_values(panel, fit, factor, u)
    panel.plot(
        curve.positions,
        curve.values * factor,
        "-.",
        color=AFTER_COLOUR,
        linewidth=1.4,
        zorder=4,
        label="curve that stays",
    )
    _frame(panel, component, "no polynomial, the curve stays", unit)


def _draw_panel(
    panel: Axes, component: str, fit: OptimalFit, u: FloatArray | None, travel: tuple[float, float]
) -> None:
    unit, factor = _unit(component)
    ends = np.clip([fit.samples.home, *fit.samples.positions], *travel)
    curve = np.linspace(ends.min(), ends.max(), CURVE_POINTS)
    after, band = fit.after.at(curve) * factor, 2 * factor * fit.after.u_at(curve)
    panel.fill_between(curve, after - band, after + band, color=AFTER_COLOUR, alpha=0.18, linewidth=0, zorder=1)
    _draw_values(panel, fit, factor, u)
    panel.plot(curve, fit.before.at(curve) * factor, "--", color=BEFORE_COLOUR, linewidth=2.0, zorder=3, label="before")
    panel.plot(curve, after, "-", color=AFTER_COLOUR, linewidth=1.4, zorder=4, label="after optimisation")
    _frame(panel, component, _summary(fit, unit, factor), unit)


def _draw_prior(panel: Axes, component: str, curve: DrawnCurve) -> None:
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
