"""A positioning test as ISO 230-2 draws it: mean deviations of both directions with bands of 2 s to either side."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trueaxis.evaluation.iso230_2.evaluation import COVERAGE_FACTOR, STANDARD, Evaluation, Unidirectional
from trueaxis.evaluation.iso230_2.report import SHOWN
from trueaxis.reporting.pictures.png import BLUE, GREY, ORANGE, png

MICROMETRE = "\N{MICRO SIGN}m"


def positioning_plot(evaluation: Evaluation, title: str) -> bytes:
    """PNG: deviations in micrometres over the targets in mm, of a rotary axis in arc seconds over deg; the dashed lines
    lie A apart.
    """
    return png(lambda: _figure(evaluation, title))


def _figure(evaluation: Evaluation, title: str) -> Figure:
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
    panel.set_title(f"{title}: {_summary(evaluation)}", fontsize=10, loc="left", parse_math=False)
    panel.set_xlabel(f"target position ({evaluation.unit})", fontsize=9)
    panel.set_ylabel(f"deviation ({_shown(evaluation)[1]})", fontsize=9)
    panel.tick_params(labelsize=8)
    panel.margins(x=0.02)
    panel.spines[["top"]].set_visible(False)
    figure.legend(*panel.get_legend_handles_labels(), loc="outside lower center", ncols=5, fontsize=8, frameon=False)
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
