"""What compensation leaves against the noise of the readings: mean of many seeds, and their range."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from trueaxis.reporting.pictures.png import BLUE, GREEN, GREY, ORANGE, png

FloatArray = NDArray[np.float64]
STYLES = ((ORANGE, "o", "--"), (BLUE, "s", "-"), (GREEN, "^", "-"))


def noise_picture(noise_um: Sequence[float], left: Mapping[str, FloatArray], nothing: float, title: str) -> bytes:
    """PNG. left: way -> (n, seeds), um, at every noise; nothing: what is left without compensation, um."""
    return png(lambda: _figure(noise_um, left, nothing, title))


def _figure(noise_um: Sequence[float], left: Mapping[str, FloatArray], nothing: float, title: str) -> Figure:
    figure = Figure(figsize=(7.6, 4.6), dpi=110, layout="constrained")
    panel = figure.subplots()
    panel.set_title(title, fontsize=10, loc="left")
    panel.axhline(nothing, color=GREY, linewidth=1.2, linestyle=":", label=f"not compensated: {nothing:.1f}")
    for (way, values), (colour, marker, line) in zip(left.items(), STYLES, strict=False):
        panel.fill_between(noise_um, values.min(axis=1), values.max(axis=1), color=colour, alpha=0.18, linewidth=0.0)
        panel.loglog(noise_um, values.mean(axis=1), line, marker=marker, color=colour, linewidth=1.4, label=way)
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.set_xticks(list(noise_um), [f"{noise:g}" for noise in noise_um])
    panel.minorticks_off()
    ticks = [t for t in (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0) if panel.get_ylim()[0] <= t]
    panel.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
    panel.grid(color="#DDDDDD", linewidth=0.6)
    panel.set_xlabel("standard deviation of a laser reading (\N{MICRO SIGN}m)", fontsize=9)
    panel.set_ylabel("left of the error of the tool point,\nRMS of a coordinate (\N{MICRO SIGN}m)", fontsize=9)
    panel.tick_params(labelsize=8)
    panel.spines[["top", "right"]].set_visible(False)
    panel.legend(fontsize=8, frameon=False)
    return figure
