"""Standard tests: polar plots of ball-bar circles (Fig. 22 of the paper), positioning tests as ISO 230-2 draws them,
diagonals.

Positioning tests show mean deviations of both directions with bands of 2 s to either side.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes
from numpy.typing import NDArray

from trueaxis.evaluation.diagonal_test import DiagonalFigures
from trueaxis.evaluation.positioning_report import SHOWN
from trueaxis.evaluation.positioning_test import COVERAGE_FACTOR, STANDARD, Evaluation, Unidirectional
from trueaxis.reporting.pictures.png import BLUE, GREEN, GREY, ORANGE, png

FloatArray = NDArray[np.float64]
MICROMETRE = "\N{MICRO SIGN}m"
LONGEST = 40  # characters of the name of a file in a title: the axes shrink by what a title is too long


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
    return png(lambda: _polar_figure(panels, title))


def _polar_figure(panels: Sequence[tuple[str, Sequence[Trace]]], title: str) -> Figure:
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


def positioning_plot(evaluation: Evaluation, title: str) -> bytes:
    """PNG: deviations in micrometres over the targets in mm, of a rotary axis in arc seconds over deg; the dashed lines
    lie A apart.
    """
    return png(lambda: _positioning_figure(evaluation, title))


def _positioning_figure(evaluation: Evaluation, title: str) -> Figure:
    figure = Figure(figsize=(8.4, 5.0), dpi=110, layout="constrained")
    panel = figure.subplots()
    panel.axhline(0.0, color="#B0B0B0", linewidth=0.8, zorder=0)
    order, factor = np.argsort(evaluation.targets), _shown(evaluation)[0]
    low, high = _limits(evaluation)
    for level, label in ((low, "limits of A"), (high, None)):
        panel.axhline(level, color=GREY, linewidth=0.8, linestyle=(0, (5, 3)), zorder=1, label=label)
    _draw(panel, evaluation, order, evaluation.positive, "positive approach", BLUE, "o-")
    _draw(panel, evaluation, order, evaluation.negative, "negative approach", ORANGE, "s--")
    x, mean = evaluation.targets[order], factor * evaluation.mean[order]
    panel.plot(x, mean, ":", color=GREY, linewidth=1.2, zorder=3, label="mean of both")
    right = panel.secondary_yaxis("right")
    right.set_yticks([low, high], labels=[f"{low:.1f}", f"{high:.1f}"], fontsize=8, color=GREY)
    panel.set_title(f"{title[-LONGEST:]}: {_summary(evaluation)}", fontsize=10, loc="left", parse_math=False)
    panel.set_xlabel(f"target position ({evaluation.unit})", fontsize=9)
    panel.set_ylabel(f"deviation ({_shown(evaluation)[1]})", fontsize=9)
    panel.tick_params(labelsize=8)
    panel.margins(x=0.02)
    panel.spines[["top"]].set_visible(False)
    figure.legend(*panel.get_legend_handles_labels(), loc="outside lower center", ncols=5, fontsize=8, frameon=False)
    return figure


def diagonal_plot(figures: DiagonalFigures) -> bytes:
    """PNG: mean deviations along each diagonal in micrometres; dashed: approached in the negative direction."""
    return png(lambda: _diagonal_figure(figures))


def _diagonal_figure(figures: DiagonalFigures) -> Figure:
    figure = Figure(figsize=(8.4, 5.0), dpi=110, layout="constrained")
    panel = figure.subplots()
    panel.axhline(0.0, color="#B0B0B0", linewidth=0.8, zorder=0)
    for one, colour in zip(figures.diagonals, (BLUE, ORANGE, GREEN, GREY), strict=False):
        x, e = one.evaluation.targets, one.evaluation
        panel.plot(x, 1e3 * e.positive.mean, "o-", color=colour, linewidth=1.5, markersize=4, label=one.name)
        panel.plot(x, 1e3 * e.negative.mean, "s--", color=colour, linewidth=1.0, markersize=3)
    largest = f"Ed {1e3 * figures.E_d:.1f}, Bd {1e3 * figures.B_d:.1f} {MICROMETRE}"
    panel.set_title(f"diagonal test: {largest}", fontsize=10, loc="left")
    panel.set_xlabel("target along the diagonal (mm); solid: positive approach, dashed: negative", fontsize=9)
    panel.set_ylabel(f"mean deviation ({MICROMETRE})", fontsize=9)
    panel.tick_params(labelsize=8)
    panel.spines[["top", "right"]].set_visible(False)
    figure.legend(*panel.get_legend_handles_labels(), loc="outside lower center", ncols=4, fontsize=8, frameon=False)
    return figure


def _draw(
    panel: Axes, evaluation: Evaluation, order: np.ndarray, side: Unidirectional, name: str, colour: str, line: str
) -> None:  # fmt: skip
    factor, x = _shown(evaluation)[0], evaluation.targets[order]
    mean, band = factor * side.mean[order], factor * COVERAGE_FACTOR * side.s[order]
    label = f"{name} \N{PLUS-MINUS SIGN} {COVERAGE_FACTOR} s"
    panel.fill_between(x, mean - band, mean + band, color=colour, alpha=0.2, linewidth=0, zorder=2)
    panel.plot(x, mean, line, color=colour, linewidth=1.5, markersize=4, zorder=4, label=label)


def _limits(evaluation: Evaluation) -> tuple[float, float]:
    """The lowest and the highest edge of both bands, whose distance is A, micrometres."""
    sides = (evaluation.positive, evaluation.negative)
    low = min(float((side.mean - COVERAGE_FACTOR * side.s).min()) for side in sides)
    high = max(float((side.mean + COVERAGE_FACTOR * side.s).max()) for side in sides)
    factor, _ = _shown(evaluation)
    return factor * low, factor * high


def _summary(evaluation: Evaluation) -> str:
    named = (("A", evaluation.A), ("E", evaluation.E), ("R", evaluation.R), ("B", evaluation.B), ("M", evaluation.M))
    convention = "" if evaluation.repeatability == "iso" else "; R unidirectional"
    factor, unit = _shown(evaluation)
    values = ", ".join(f"{name} {factor * value:.1f}" for name, value in named)
    return f"{values} {unit} ({STANDARD}{convention})"


def _shown(evaluation: Evaluation) -> tuple[float, str]:
    """Factor and unit of the deviations: micrometres, of a rotary axis arc seconds."""
    return (1e3, MICROMETRE) if evaluation.unit == "mm" else SHOWN["deg"][0]
