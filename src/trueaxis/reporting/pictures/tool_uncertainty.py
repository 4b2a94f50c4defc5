"""The expected uncertainty of the tool point on slices through the volume."""

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.figure import Figure

from trueaxis.planning.slices import Slice
from trueaxis.reporting.pictures.png import png

LEVELS = 6


def uncertainty_picture(slices: Sequence[Slice]) -> bytes:
    """PNG: a panel per slice, all with one scale in micrometres. Raises ValueError where there is none."""
    if not slices:
        raise ValueError("there is no slice to draw")
    return png(lambda: _figure(slices))


def _figure(slices: Sequence[Slice]) -> Figure:
    figure = Figure(figsize=(4.0 * len(slices) + 1.0, 4.2), dpi=110, layout="constrained")
    figure.suptitle("expected standard uncertainty of the tool point, seen from home", fontsize=11)
    panels = figure.subplots(1, len(slices), squeeze=False)[0]
    top = 1e3 * max(float(one.u.max()) for one in slices)
    for panel, one in zip(panels, slices, strict=True):
        drawn = _panel(panel, one, top)
    bar = figure.colorbar(drawn, ax=list(panels), shrink=0.85)
    bar.set_label("u (\N{MICRO SIGN}m)", fontsize=8)
    bar.ax.tick_params(labelsize=8)
    return figure


def _panel(panel: Axes, one: Slice, top: float) -> QuadMesh:
    um = 1e3 * one.u
    drawn = panel.pcolormesh(one.first, one.second, um, cmap="viridis", vmin=0.0, vmax=top, shading="nearest")
    if float(um.max()) > float(um.min()):
        lines = panel.contour(one.first, one.second, um, levels=LEVELS, colors="white", linewidths=0.7)
        panel.clabel(lines, fontsize=7, fmt="%.3g")
    at = ", ".join(f"{axis} at {value:g}" for axis, value in one.at.items())
    panel.set_title(f"{at}\nlargest {um.max():.3g} \N{MICRO SIGN}m", fontsize=9, loc="left")
    panel.set_xlabel(f"{one.axes[0]} (mm)", fontsize=8)
    panel.set_ylabel(f"{one.axes[1]} (mm)", fontsize=8)
    panel.tick_params(labelsize=8)
    return drawn
