"""Polar plots of ball-bar circles (Fig. 22 of the paper)."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes
from numpy.typing import NDArray

from trueaxis.reporting.pictures.png import BLUE, ORANGE, png

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class Trace:
    """One direction of run: polar angles (n,) rad and radial deviations (n,) mm."""

    name: str
    angles: FloatArray
    radial: FloatArray


def polar_plot(panels: Sequence[tuple[str, Sequence[Trace]]], title: str) -> bytes:
    """PNG: side by side, each panel a title and its traces (two at most), radial deviations magnified.

    The scale is the same in all panels, so that they compare; gaps of more than 10 deg are not bridged.
    """
    return png(lambda: _figure(panels, title))


def _figure(panels: Sequence[tuple[str, Sequence[Trace]]], title: str) -> Figure:
    figure = Figure(figsize=(4.8 * len(panels), 5.4), dpi=110)
    figure.suptitle(title, fontsize=11, y=0.98)
    figure.subplots_adjust(left=0.06, right=0.94, bottom=0.1, top=0.82, wspace=0.3)
    largest = 1e3 * max(float(np.abs(trace.radial).max()) for _, traces in panels for trace in traces)
    tick = _round_up(largest)
    for column, (name, traces) in enumerate(panels):
        panel = cast(PolarAxes, figure.add_subplot(1, len(panels), column + 1, projection="polar"))
        circle = np.linspace(0.0, 2.0 * np.pi, 361)
        panel.plot(circle, np.zeros_like(circle), color="#B0B0B0", linewidth=0.8)
        for trace, colour, line in zip(traces, (BLUE, ORANGE), ("-", "--"), strict=False):
            angles, radial = _broken(trace.angles, 1e3 * trace.radial)
            panel.plot(angles, radial, line, color=colour, linewidth=1.2, label=trace.name)
        panel.set_ylim(-2.2 * tick, 1.1 * tick)
        panel.set_yticks([-tick, 0.0, tick])
        panel.set_yticklabels([f"-{tick:g}", "0", f"+{tick:g} \N{MICRO SIGN}m"], fontsize=7)
        panel.tick_params(labelsize=8)
        panel.set_title(name, fontsize=9)
    handles, labels = panel.get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncols=2, fontsize=8, frameon=False)
    return figure


def _round_up(value: float) -> float:
    """1, 2 or 5 times a power of ten, not less than the value."""
    power = 10.0 ** np.floor(np.log10(max(value, 1e-6)))
    return float(next(step * power for step in (1.0, 2.0, 5.0, 10.0) if step * power >= value))


def _broken(angles: FloatArray, radial: FloatArray) -> tuple[FloatArray, FloatArray]:
    order = np.argsort(np.mod(angles, 2.0 * np.pi))
    sorted_angles, values = np.mod(angles, 2.0 * np.pi)[order], radial[order]
    if sorted_angles.size > 2 and sorted_angles[0] + 2.0 * np.pi - sorted_angles[-1] < np.radians(10.0):
        sorted_angles, values = np.append(sorted_angles, sorted_angles[0] + 2.0 * np.pi), np.append(values, values[0])
    gaps = np.flatnonzero(np.diff(sorted_angles) > np.radians(10.0)) + 1
    return np.insert(sorted_angles, gaps, np.nan), np.insert(values, gaps, np.nan)
