"""Errors of the tool point: along a path (Figs. 19 and 20 of the paper), against noise; slices of the volume."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection, QuadMesh
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from numpy.typing import NDArray

from trueaxis.machine.machine import LINEAR
from trueaxis.model.grid import Slice
from trueaxis.reporting.pictures.png import BLUE, GREEN, GREY, ORANGE, png

FloatArray = NDArray[np.float64]
FLOOR_UM = 0.003
COLOURS = (GREY, ORANGE, BLUE, GREEN)
STYLES = ((ORANGE, "o", "--"), (BLUE, "s", "-"), (GREEN, "^", "-"))
LEVELS = 6


@dataclass(frozen=True)
class PathErrors:
    """What one way of compensating leaves: positioning error E (Eq. 6) and norm of the error vector, both (n,) mm."""

    positioning: FloatArray
    vector: FloatArray


def error_map(path: FloatArray, left: Mapping[str, PathErrors], title: str) -> bytes:
    """PNG: E and the error vector along the path for each way of compensating, then where on the path (3, n) they are.

    All panels share their scales, logarithmic because the ways differ by orders of magnitude; below FLOOR_UM, nothing.
    """
    return png(lambda: _map_figure(path, left, title))


def _map_figure(path: FloatArray, left: Mapping[str, PathErrors], title: str) -> Figure:
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


def noise_picture(noise_um: Sequence[float], left: Mapping[str, FloatArray], nothing: float, title: str) -> bytes:
    """PNG. left: way -> (n, seeds), um, at every noise; nothing: what is left without compensation, um."""
    return png(lambda: _noise_figure(noise_um, left, nothing, title))


def _noise_figure(noise_um: Sequence[float], left: Mapping[str, FloatArray], nothing: float, title: str) -> Figure:
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


def uncertainty_picture(slices: Sequence[Slice]) -> bytes:
    """PNG of slices of u, mm. Raises ValueError where there is none."""
    title = "expected standard uncertainty of the tool point, seen from home: root sum of squares of x, y, z"
    return maps_picture({title: slices})


def maps_picture(maps: Mapping[str, Sequence[Slice]]) -> bytes:
    """PNG: a row for each title, a panel per slice, all of a row with one scale in micrometres. Raises ValueError where
    there is no slice.
    """
    if not all(maps.values()):
        raise ValueError("there is no slice to draw")
    return png(lambda: _maps_figure(maps))


def _maps_figure(maps: Mapping[str, Sequence[Slice]]) -> Figure:
    widest = max(map(len, maps.values()))
    figure = Figure(figsize=(4.0 * widest + 1.0, 4.2 * len(maps)), dpi=110, layout="constrained")
    rows = figure.subfigures(len(maps), 1, squeeze=False)[:, 0]
    for row, (title, slices) in zip(rows, maps.items(), strict=True):
        row.suptitle(title, fontsize=11)
        panels = row.subplots(1, len(slices), squeeze=False)[0]
        top = 1e3 * float(np.fmax.reduce([np.fmax.reduce(one.values, axis=None) for one in slices]))
        for panel, one in zip(panels, slices, strict=True):
            drawn = _panel(panel, one, top)
        bar = row.colorbar(drawn, ax=list(panels), shrink=0.85)
        bar.set_label("\N{MICRO SIGN}m", fontsize=8)
        bar.ax.tick_params(labelsize=8)
    return figure


def _panel(panel: Axes, one: Slice, top: float) -> QuadMesh:
    um = 1e3 * one.values
    drawn = panel.pcolormesh(one.first, one.second, um, cmap="viridis", vmin=0.0, vmax=top, shading="nearest")
    largest, least = (float(one.reduce(um, axis=None)) for one in (np.fmax, np.fmin))  # NaN: not known
    if largest > least:
        lines = panel.contour(one.first, one.second, um, levels=LEVELS, colors="white", linewidths=0.7)
        panel.clabel(lines, fontsize=7, fmt="%.3g")
    at = ", ".join(f"{axis} at {value:g}" for axis, value in one.at.items())
    told = "not known" if np.isnan(largest) else f"largest {largest:.3g} \N{MICRO SIGN}m"
    panel.set_title(f"{at}\n{told}", fontsize=9, loc="left")
    first, second = (f"{axis} ({'mm' if axis in LINEAR else 'deg'})" for axis in one.axes)
    panel.set_xlabel(first, fontsize=8)
    panel.set_ylabel(second, fontsize=8)
    panel.tick_params(labelsize=8)
    return drawn
