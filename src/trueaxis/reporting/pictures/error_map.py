"""Positioning errors along a path (Figs. 19 and 20 of the paper): error against path length, and on the path itself."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from numpy.typing import NDArray

from trueaxis.reporting.pictures.png import BLUE, GREEN, GREY, ORANGE, png

FloatArray = NDArray[np.float64]
FLOOR_UM = 0.003
COLOURS = (GREY, ORANGE, BLUE, GREEN)


@dataclass(frozen=True)
class PathErrors:
    """What one way of compensating leaves: positioning error E (Eq. 6) and norm of the error vector, both (n,) mm."""

    positioning: FloatArray
    vector: FloatArray


def error_map(path: FloatArray, left: Mapping[str, PathErrors], title: str) -> bytes:
    """PNG: E and the error vector along the path for each way of compensating, then where on the path (3, n) they are.

    All panels share their scales, logarithmic because the ways differ by orders of magnitude; below FLOOR_UM, nothing.
    """
    return png(lambda: _figure(path, left, title))


def _figure(path: FloatArray, left: Mapping[str, PathErrors], title: str) -> Figure:
    figure = Figure(figsize=(3.6 * len(left) + 1.0, 7.4), dpi=110, layout="constrained")
    figure.suptitle(title, fontsize=11)
    panels = figure.subplots(2, len(left), squeeze=False)
    steps = np.linalg.norm(np.diff(path, axis=1), axis=0)
    distance = np.concatenate([[0.0], np.cumsum(steps)])
    top = 4e3 * max(float(errors.vector.max()) for errors in left.values())
    for column, (name, errors) in enumerate(left.items()):
        _along(panels[0, column], distance, errors, name, COLOURS[column % len(COLOURS)])
        panels[0, column].set_ylim(FLOOR_UM, top)
        drawn = _map(panels[1, column], path, errors, top)
    bar = figure.colorbar(drawn, ax=list(panels[1]), shrink=0.85)
    bar.set_label("|E| (\N{MICRO SIGN}m)", fontsize=8)
    bar.ax.tick_params(labelsize=8)
    return figure


def _along(panel: Axes, distance: FloatArray, errors: PathErrors, name: str, colour: str) -> None:
    e, vector = 1e3 * np.abs(errors.positioning), 1e3 * errors.vector
    panel.semilogy(distance, np.maximum(vector, FLOOR_UM), color="#B8B8B8", linewidth=0.7, label="error vector, norm")
    panel.semilogy(distance, np.maximum(e, FLOOR_UM), color=colour, linewidth=0.9, label="positioning error |E|")
    panel.set_title(f"{name}\n|E| mean {e.mean():.4f}, max {e.max():.4f} \N{MICRO SIGN}m", fontsize=9, loc="left")
    panel.set_xlabel("distance along the path (mm)", fontsize=8)
    panel.set_ylabel("error (\N{MICRO SIGN}m)", fontsize=8)
    panel.tick_params(labelsize=8)
    panel.legend(fontsize=7, frameon=False, loc="upper center", ncols=2)
    panel.spines[["top", "right"]].set_visible(False)


def _map(panel: Axes, path: FloatArray, errors: PathErrors, top: float) -> PathCollection:
    colours = np.maximum(1e3 * np.abs(errors.positioning), FLOOR_UM)
    drawn = panel.scatter(path[0], path[1], c=colours, s=5, cmap="viridis", norm=LogNorm(FLOOR_UM, top))
    panel.set_aspect("equal")
    panel.set_xlabel("X of the workpiece frame (mm)", fontsize=8)
    panel.set_ylabel("Y of the workpiece frame (mm)", fontsize=8)
    panel.tick_params(labelsize=8)
    return drawn
